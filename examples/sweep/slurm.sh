#!/bin/sh
# The same with Slurm: an array of jobs, one shard each, and a job that merges when all have ended.
#   PLAN=plan.json OUT=/shared/sweep sbatch --array=1-8 examples/sweep/slurm.sh
#   PLAN=plan.json OUT=/shared/sweep sbatch --dependency=afterany:ARRAY_JOB examples/sweep/slurm.sh
# One shard once more, the third of eight: SHARDS=8 PLAN=... OUT=... sbatch --array=3 examples/sweep/slurm.sh
# CREVICE is the program, default: crevice. OUT is a directory that all nodes see. Times are merged only where they come from
# one kind of machine; --exclusive keeps other jobs away from them.
#SBATCH --job-name=crevice-sweep
#SBATCH --exclusive
set -eu
crevice=${CREVICE-crevice}
if [ -n "${SLURM_ARRAY_TASK_ID-}" ]; then
    exec "$crevice" sweep "$PLAN" --shard "$SLURM_ARRAY_TASK_ID/${SHARDS-$SLURM_ARRAY_TASK_COUNT}" --out "$OUT"
fi
exec "$crevice" merge "$OUT"
