/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Workers over the ranks of an MPI job (Open MPI; an optional part of the build): rank 0 hands out the jobs, one at a
 * time to each rank, and works too. Without MPI, or when mpirun has not started this program, there is one rank. */
#ifndef SARCINA_APP_WORKERS_MPI_H
#define SARCINA_APP_WORKERS_MPI_H

#include "app/workers.h"

void workers_mpi_begin(void); /* once, before the others */
void workers_mpi_end(void);
int workers_mpi_rank(void);
int workers_mpi_ranks(void);

/* Rank 0: runs the jobs of `due` (rows of jobs), as workers_run does. Every rank has the same jobs. */
void workers_mpi_run(const worker_job *jobs, const size_t *due, size_t ndue, const worker_host *host);

/* The other ranks: runs what rank 0 hands out, until it has no more. ending(): not 0 once what runs must end. */
void workers_mpi_serve(const worker_job *jobs, int (*ending)(void));

#endif
