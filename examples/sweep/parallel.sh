#!/bin/sh
# The same with GNU parallel (Debian: apt-get install parallel): one shard a core, one thread each.
#   examples/sweep/parallel.sh PLAN SHARDS OUT     CREVICE is the program, default: crevice
# The shards may share one directory. Give it a plan with "repetitions": 0, or other machines by --sshlogin: shards beside
# each other disturb each other's times.
set -eu
plan=$1 shards=$2 out=$3
crevice=${CREVICE-crevice}
seq "$shards" | parallel --halt now,fail=1 "$crevice" sweep "$plan" --shard "{}/$shards" --threads 1 --out "$out"
"$crevice" merge "$out"
