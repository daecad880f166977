/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs programs, each in a folder of its own, several at a time: as child processes of this one, or of the ranks of an
 * MPI job (workers_mpi.h). */
#ifndef SARCINA_APP_WORKERS_H
#define SARCINA_APP_WORKERS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

typedef struct worker_job {
    const char *folder; /* is there already; screen.txt and errors.txt go into it */
    char *const *argv;  /* of this very program, ended by NULL */
} worker_job;

/* What becomes of the jobs. */
typedef struct worker_host {
    void *self;
    void (*ended)(void *self, size_t job, int code, double seconds); /* code: 128 + signal when it was killed */
    void (*waiting)(void *self, size_t running);                     /* a few times a second */
    bool (*stopped)(void *self);                                     /* no new jobs: those that run are waited for */
    int (*ending)(void *self);                                       /* not 0: those that run are ended (SIGTERM) */
} worker_host;

/* Runs the jobs of `due` (ndue rows of jobs) in that order, at most `at_once` at a time, each a child of this
 * process. A job that cannot be started ends with code 127. */
void workers_run(const worker_job *jobs, const size_t *due, size_t ndue, int at_once, const worker_host *host);

/* Starts one job; -1: it could not be. */
pid_t workers_start(const worker_job *job);

/* Has the process ended? Does not wait. */
bool workers_poll(pid_t pid, int *code);

/* Asks it to end: what it has done of its run is lost. 0: there is none. */
void workers_end(pid_t pid);

/* A few hundredths of a second, between looks. */
void workers_pause(void);

#endif
