#!/bin/sh
# The same with GNU parallel (Debian: apt-get install parallel): one shard a core, one thread each.
#   examples/sweep/parallel.sh PLAN SHARDS OUT     CREVICE is the program, default: crevice
# The shards may share one directory. Give it a plan with "repetitions": 0, or other machines by --sshlogin: shards beside
# each other disturb each other's times.
set -eu
plan=$1 shards=$2 out=$3
crevice=${CREVICE-crevice}
# Where a shard fails the others go on, and merge says what is missing.
seq "$shards" | parallel "$crevice" sweep "$plan" --shard "{}/$shards" --threads 1 --out "$out" || true
"$crevice" merge "$out"
