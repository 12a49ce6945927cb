#!/bin/sh
# Steps one pass in the debugger as the README tells: stops in the kernel of one AO sample, and must see plain floats there.
# usage: step_through_test.sh GDB CREVICE
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" -batch -nx -ex 'set breakpoint pending on' -ex 'skip -gfi *wide*.h' -ex 'break crevice::luna_occlusion' -ex run \
    -ex 'print settings.radius' -ex 'print run.lanes' -ex 'tbreak LunaKernel::accessibility<float>' -ex continue -ex 'print p' \
    -ex 'print n' -ex next -ex next -ex 'print sum' \
    --args "$2" render wall_corner --size 32x18 --threads 1 --lanes 1 --out "$scratch" > "$scratch/log" 2>&1 || true
cat "$scratch/log"
grep -q '^\$1 = 0.5' "$scratch/log"
grep -q '^\$2 = 1' "$scratch/log"
grep -Eq '^\$3 = \{x = -?[0-9.]+' "$scratch/log"
