/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input is a socket, not a pipe: writing to a program that has ended is then an error to us and no signal. */
#include "base/process.h"

#include "base/alloc.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

struct process {
    char *name;
    pid_t id;
    int input;
};

/* 0, or the error number. */
static int start(const char *const *words, int input, bool silent, pid_t *id) {
    char path[] = "PATH=/usr/local/bin:/usr/bin:/bin", locale[] = "LC_ALL=C.UTF-8";
    char *environment[] = {path, locale, NULL};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    if (input >= 0)
        posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    else
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (silent)
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    int error = posix_spawnp(id, words[0], &files, &how, (char *const *)words, environment);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    return error;
}

/* Its end, as waitpid(2) says it: a signal to us (Ctrl-C) does not end the wait. */
static int wait_for(pid_t id) {
    int status = 0;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR)
        ;
    return status;
}

int process_check(const char *name, const char *package, diag *d) {
    const char *const words[] = {name, "-version", NULL};
    pid_t id;
    if (start(words, -1, true, &id) == 0) {
        int status = wait_for(id);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 127) /* how some systems say that there is none */
            return SARCINA_OK;
    }
    diag_error(d, "the program %s is needed for this and is not in PATH", name);
    return diag_help(d, "apt-get install %s", package);
}

process *process_open(const char *const *words, diag *d) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends)) {
        diag_error(d, "cannot start %s: %s", words[0], strerror(errno));
        return NULL;
    }
    process p = {.input = ends[1]};
    int error = start(words, ends[0], false, &p.id);
    close(ends[0]);
    if (error) {
        close(ends[1]);
        diag_error(d, "cannot start %s: %s", words[0], strerror(error));
        return NULL;
    }
    p.name = alloc_copy(words[0]);
    process *kept = alloc_zeroed(1, sizeof *kept);
    *kept = p;
    return kept;
}

int process_write(process *p, const void *bytes, size_t n, diag *d) {
    const char *at = bytes;
    while (n > 0) {
        ssize_t sent = send(p->input, at, n, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            return diag_error(d, "%s ended before it should", p->name);
        at += sent;
        n -= (size_t)sent;
    }
    return SARCINA_OK;
}

int process_close(process *p, diag *d) {
    if (!p)
        return SARCINA_OK;
    int result = SARCINA_OK;
    close(p->input);
    int status = wait_for(p->id);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        result = diag_error(d, "%s failed", p->name);
    free(p->name);
    free(p);
    return result;
}

int process_run(const char *const *words, const void *bytes, size_t n, diag *d) {
    process *p = process_open(words, d);
    if (!p)
        return SARCINA_ERROR;
    int status = process_write(p, bytes, n, d);
    return process_close(p, status ? NULL : d) ? SARCINA_ERROR : status;
}
