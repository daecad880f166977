#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# An ensemble as a job array, which needs no MPI: each task does one seed (at every point of a sweep), in a folder of its
# own below NAME.parts, as an ensemble's folder takes one at a time. Then, once, the merge:
#
#   sbatch --array=1-20 slurm_array.sh colony.in -sweep d 0.5um,1um,2um
#   slurm_array.sh --merge 20 colony.in -sweep d 0.5um,1um,2um
#
# The merge takes the runs together and does those that are missing, where it is called.
#   SARCINA   the program, if it is not in PATH
#SBATCH --job-name=sarcina
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=500M
#SBATCH --time=12:00:00
#SBATCH --output=%x.%A.%a.out
set -euo pipefail
usage() { sed -n '3,11s/^# \{0,1\}//p' "$0" >&2; exit 2; }
sarcina=${SARCINA:-sarcina}
seeds=
if [[ ${1-} == --merge ]]; then
    [[ $# -ge 3 ]] || usage
    seeds=$2
    shift 2
fi
[[ $# -gt 0 && ( $seeds || ${SLURM_ARRAY_TASK_ID-} ) ]] || usage
script=$(realpath "$1")
name=$(basename "${1%.*}")
shift
if [[ $seeds ]]; then
    mkdir -p "$name.runs"
    cp -R "$name.parts"/*/"$name.runs"/. "$name.runs"
    exec "$sarcina" -replicates "$seeds" "$@" "$script"
fi
folder=$name.parts/seed=$SLURM_ARRAY_TASK_ID
mkdir -p "$folder"
cd "$folder"
exec "$sarcina" -workers "${SLURM_CPUS_PER_TASK:-1}" -replicates "$SLURM_ARRAY_TASK_ID..$SLURM_ARRAY_TASK_ID" "$@" "$script"
