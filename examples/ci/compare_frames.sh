#!/bin/sh
# Draws a frame and holds its buffers against goldens, within the limits of goldens/limits.json: exit 0 when all pass, 1 when
# one does not. Then OUT/compare.html shows both and their difference, OUT/junit.xml tells the CI. The frame is the lab's
# own; a renderer that writes its buffers as .npy, .pfm or .png of the same names takes the place of `crevice render`.
# usage: compare_frames.sh CREVICE OUT [OPTION OF render]...
#   compare_frames.sh build/release/crevice out/ci
#   compare_frames.sh build/release/crevice out/ci --param radius=0.4      a planted regression: exit 1
#   compare_frames.sh build/release/crevice out/ci --bless                 the goldens take what differs from the frame
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
program=$1 out=$2
shift 2
bless=
if [ "${1-}" = --bless ]; then
    bless=--bless
    shift
fi
"$program" render columns --ao xjun --size 64x36 --only normal,ao_raw,ao_blurred --out "$out/frame" "$@"
# Of each buffer the numbers are compared, not the picture made of them.
mkdir -p "$out/buffers"
mv "$out/frame"/*.npy "$out/buffers"
"$program" compare "$out/buffers" "$here/goldens" --html "$out/compare.html" --junit "$out/junit.xml" $bless
