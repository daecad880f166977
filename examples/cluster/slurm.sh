#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# An ensemble over the nodes of a cluster, under Slurm; with a build of `cmake --preset mpi`:
#
#   sbatch --ntasks=64 slurm.sh -replicates 200 -sweep d 0.5um,1um,2um colony.in
#
# One task does one run at a time. Two minutes before the job's time is up its runs are ended, and what is done has been
# merged; the same line once more does what is missing.
#   SARCINA   the program, if it is not in PATH
#   LAUNCHER  what starts it on all tasks; "srun --mpi=pmix" where Open MPI's mpirun is not to be used
#SBATCH --job-name=sarcina
#SBATCH --ntasks=32
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=500M
#SBATCH --time=12:00:00
#SBATCH --signal=TERM@120
#SBATCH --output=%x.%j.out
set -euo pipefail
[[ $# -gt 0 ]] || { sed -n '3,11s/^# \{0,1\}//p' "$0" >&2; exit 2; }
read -ra launcher <<<"${LAUNCHER:-mpirun}"
exec "${launcher[@]}" "${SARCINA:-sarcina}" -threads "${SLURM_CPUS_PER_TASK:-1}" "$@"
