#!/bin/sh
# A sweep in shards, each with a directory of its own, as on machines that share nothing; then merged.
#   examples/sweep/shell.sh PLAN SHARDS OUT        CREVICE is the program, default: crevice
# On this one machine the shards run one after the other. Run any of them again after it was stopped: it goes on.
set -eu
plan=$1 shards=$2 out=$3
crevice=${CREVICE-crevice}
shard=1
while [ "$shard" -le "$shards" ]; do
    # 1: some of its jobs failed. The others go on, and merge says so.
    "$crevice" sweep "$plan" --shard "$shard/$shards" --out "$out/shard_$shard" || [ $? -eq 1 ]
    shard=$((shard + 1))
done
"$crevice" merge "$out"/shard_* --out "$out"
