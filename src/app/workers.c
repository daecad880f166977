/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/workers.h"

#include "base/alloc.h"
#include "engine/scene.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { PAUSE_MILLISECONDS = 20 };

/* A child must not think itself a rank of the MPI job that its parent belongs to. */
static char **plain_environment(void) {
    static const char *const prefixes[] = {"OMPI_", "PMIX_", "PMI_", "SLURM_PMI", "PRTE_"};
    size_t n = 0, kept = 0;
    while (environ[n])
        n++;
    char **copy = alloc_zeroed(n + 1, sizeof *copy);
    for (size_t i = 0; i < n; i++) {
        bool of_mpi = false;
        for (size_t k = 0; k < sizeof prefixes / sizeof prefixes[0]; k++)
            of_mpi |= strncmp(environ[i], prefixes[k], strlen(prefixes[k])) == 0;
        if (!of_mpi)
            copy[kept++] = environ[i];
    }
    return copy;
}

pid_t workers_start(const worker_job *job) {
    posix_spawn_file_actions_t actions;
    pid_t pid;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, job->folder);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "screen.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "errors.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    char **environment = plain_environment();
    int failed = posix_spawn(&pid, "/proc/self/exe", &actions, NULL, job->argv, environment);
    free(environment);
    posix_spawn_file_actions_destroy(&actions);
    return failed ? -1 : pid;
}

bool workers_poll(pid_t pid, int *code) {
    int status;
    pid_t got;
    do
        got = waitpid(pid, &status, WNOHANG);
    while (got < 0 && errno == EINTR);
    if (got == 0)
        return false;
    *code = got < 0 ? 127 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
}

typedef struct slot {
    pid_t pid; /* 0: free */
    size_t job;
    double since;
} slot;

static void fill(slot *s, const worker_job *jobs, size_t job, const worker_host *host) {
    *s = (slot){.pid = workers_start(&jobs[job]), .job = job, .since = scene_clock()};
    if (s->pid > 0)
        return;
    s->pid = 0;
    host->ended(host->self, job, 127, 0);
}

static void look_after(slot *s, const worker_host *host) {
    int code;
    if (!s->pid || !workers_poll(s->pid, &code))
        return;
    s->pid = 0;
    host->ended(host->self, s->job, code, scene_clock() - s->since);
}

void workers_end(pid_t pid) {
    if (pid > 0)
        kill(pid, SIGTERM);
}

void workers_pause(void) {
    nanosleep(&(struct timespec){.tv_nsec = PAUSE_MILLISECONDS * 1000000L}, NULL);
}

void workers_run(const worker_job *jobs, const size_t *due, size_t ndue, int at_once, const worker_host *host) {
    slot *slots = alloc_zeroed((size_t)at_once, sizeof *slots);
    size_t next = 0, running;
    do {
        running = 0;
        for (int i = 0; i < at_once && host->ending(host->self); i++)
            workers_end(slots[i].pid);
        for (int i = 0; i < at_once; i++) {
            look_after(&slots[i], host);
            if (!slots[i].pid && next < ndue && !host->stopped(host->self))
                fill(&slots[i], jobs, due[next++], host);
            running += slots[i].pid > 0;
        }
        host->waiting(host->self, running);
        workers_pause();
    } while (running || (next < ndue && !host->stopped(host->self)));
    free(slots);
}
