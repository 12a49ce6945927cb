#!/bin/sh
# The examples of sweeps on many machines that run on this one: shards one after the other, and side by side with GNU
# parallel where it is installed, come to the same bytes as one shard.
#   sweep_examples_test.sh CREVICE EXAMPLES
set -eu
export CREVICE="$1"
examples=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME="$work/cache"
cat > "$work/plan.json" <<'PLAN'
{"name": "small", "scenes": ["cornell"], "sizes": [[48, 27]], "methods": ["xjun", "gtao"],
 "parameters": {"samples": [4, 8], "ao_scale": [0.5, 1]}, "reference_rays": 16}
PLAN
"$CREVICE" sweep "$work/plan.json" --out "$work/one"
"$CREVICE" merge "$work/one"
"$examples/shell.sh" "$work/plan.json" 3 "$work/shell"
cmp "$work/one/results.json" "$work/shell/results.json"
if command -v parallel >/dev/null; then
    "$examples/parallel.sh" "$work/plan.json" 4 "$work/parallel"
    cmp "$work/one/results.json" "$work/parallel/results.json"
fi
# The manifest's shards of an index that counts from 0.
shard=$(sed -n 's/^ *- [^ ]* --no-install sweep \(.*\) || .*$/echo \1/p' "$examples/kubernetes.yaml")
[ "$(JOB_COMPLETION_INDEX=7 SHARDS=8 sh -c "$shard")" = "/plan/plan.json --shard 8/8 --out /sweep/out" ]
