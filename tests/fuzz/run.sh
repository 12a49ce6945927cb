#!/bin/sh
# Runs every fuzz target of the preset `fuzz` for SECONDS, two at once: tests/fuzz/run.sh SECONDS [DIRECTORY OF THE BUILD]
# Prints how many inputs each tried. An input that fails stands in the build's directory, in a file named after its kind and
# its target; the target's whole report beside it, in fuzz_TARGET.log. What they make up is kept for the next run.
set -eu
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [DIRECTORY OF THE BUILD]}
sources=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
build=${2-$sources/../../build/fuzz}
cd "$build"

fuzz_one() {
    mkdir -p "found_$1"
    if "./fuzz_$1" -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="$1-" "found_$1" "$sources/seeds/$1" \
        >"fuzz_$1.log" 2>&1; then
        echo "fuzz_$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "fuzz_$1.log") inputs, nothing found"
    else
        tail -n 60 "fuzz_$1.log"
        echo "fuzz_$1: failed; the input is named above"
        return 1
    fi
}

set -- obj mtl image npy words json
failed=0
while [ $# -gt 0 ]; do
    fuzz_one "$1" &
    first=$!
    fuzz_one "$2" || failed=1
    wait $first || failed=1
    shift 2
done
exit $failed
