/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/workers_mpi.h"

#include "engine/scene.h"

#include <stdlib.h>

#if SARCINA_HAVE_MPI

#include <mpi.h>

enum { TAG_READY = 1, TAG_JOB, JOB_NONE = -1 };

/* What a rank says when it wants work: the job it has done, if any, and how that ended. */
typedef struct ready_message {
    long job; /* JOB_NONE: the first word of this rank */
    int code;
    double seconds;
} ready_message;

/* mpirun says so in the environment of what it starts (Open MPI, or a PMI launcher such as Slurm's). */
static int started_by_mpirun(void) {
    return getenv("OMPI_COMM_WORLD_SIZE") || getenv("PMIX_RANK") || getenv("PMI_RANK");
}

void workers_mpi_begin(void) {
    if (started_by_mpirun())
        MPI_Init(NULL, NULL);
}

static int is_on(void) {
    int begun, ended;
    MPI_Initialized(&begun);
    MPI_Finalized(&ended);
    return begun && !ended;
}

void workers_mpi_end(void) {
    if (is_on())
        MPI_Finalize();
}

int workers_mpi_rank(void) {
    int rank = 0;
    if (is_on())
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

int workers_mpi_ranks(void) {
    int n = 1;
    if (is_on())
        MPI_Comm_size(MPI_COMM_WORLD, &n);
    return n;
}

/* The rank's own child. */
typedef struct child {
    pid_t pid; /* 0: none */
    long job;
    double since;
} child;

static ready_message start(child *c, const worker_job *jobs, long job) {
    *c = (child){.pid = workers_start(&jobs[job]), .job = job, .since = scene_clock()};
    if (c->pid < 0)
        c->pid = 0;
    return (ready_message){job, 127, 0};
}

/* Has the child ended? Then *m says how. */
static bool ended(child *c, ready_message *m) {
    int code;
    if (!c->pid || !workers_poll(c->pid, &code))
        return false;
    c->pid = 0;
    *m = (ready_message){c->job, code, scene_clock() - c->since};
    return true;
}

/* The next job to hand out; JOB_NONE: no more. */
static long next_job(const size_t *due, size_t ndue, size_t *next, const worker_host *host) {
    return *next < ndue && !host->stopped(host->self) ? (long)due[(*next)++] : JOB_NONE;
}

static void tell(const worker_host *host, const ready_message *m) {
    if (m->job != JOB_NONE)
        host->ended(host->self, (size_t)m->job, m->code, m->seconds);
}

/* Answers one rank that wants work, if any does. */
static void answer(const size_t *due, size_t ndue, size_t *next, int *busy, int *released, const worker_host *host) {
    int waiting;
    MPI_Status from;
    MPI_Iprobe(MPI_ANY_SOURCE, TAG_READY, MPI_COMM_WORLD, &waiting, &from);
    if (!waiting)
        return;
    ready_message m;
    MPI_Recv(&m, sizeof m, MPI_BYTE, from.MPI_SOURCE, TAG_READY, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    *busy -= m.job != JOB_NONE;
    tell(host, &m);
    long job = next_job(due, ndue, next, host);
    MPI_Send(&job, 1, MPI_LONG, from.MPI_SOURCE, TAG_JOB, MPI_COMM_WORLD);
    *busy += job != JOB_NONE;
    *released += job == JOB_NONE;
}

void workers_mpi_run(const worker_job *jobs, const size_t *due, size_t ndue, const worker_host *host) {
    child own = {0};
    size_t next = 0;
    int busy = 0, released = 0, others = workers_mpi_ranks() - 1;
    bool idle = false; /* this rank has no more to do */
    ready_message m;
    while (!idle || released < others) {
        if (host->ending(host->self))
            workers_end(own.pid);
        if (ended(&own, &m))
            tell(host, &m);
        if (!own.pid) {
            long job = next_job(due, ndue, &next, host);
            idle = job == JOB_NONE;
            if (!idle) {
                m = start(&own, jobs, job);
                if (!own.pid)
                    tell(host, &m);
            }
        }
        answer(due, ndue, &next, &busy, &released, host);
        host->waiting(host->self, (size_t)busy + (own.pid > 0));
        workers_pause();
    }
}

void workers_mpi_serve(const worker_job *jobs, int (*ending)(void)) {
    child own = {0};
    ready_message m = {.job = JOB_NONE};
    for (;;) {
        long job;
        MPI_Send(&m, sizeof m, MPI_BYTE, 0, TAG_READY, MPI_COMM_WORLD);
        MPI_Recv(&job, 1, MPI_LONG, 0, TAG_JOB, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (job == JOB_NONE)
            return;
        m = start(&own, jobs, job);
        while (own.pid && !ended(&own, &m)) {
            if (ending())
                workers_end(own.pid);
            workers_pause();
        }
    }
}

#else

void workers_mpi_begin(void) {
}
void workers_mpi_end(void) {
}

int workers_mpi_rank(void) {
    return 0;
}

int workers_mpi_ranks(void) {
    return 1;
}

void workers_mpi_run(const worker_job *jobs, const size_t *due, size_t ndue, const worker_host *host) {
    workers_run(jobs, due, ndue, 1, host);
}

void workers_mpi_serve(const worker_job *jobs, int (*ending)(void)) {
    (void)jobs;
    (void)ending;
}

#endif
