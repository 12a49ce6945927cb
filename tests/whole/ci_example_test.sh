#!/bin/sh
# The CI example passes as it stands, and fails on a planted regression with a report that names the buffer.
# usage: ci_example_test.sh CREVICE
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
example="$here/../../examples/ci/compare_frames.sh"
"$example" "$1" "$scratch/good"

code=0
"$example" "$1" "$scratch/bad" --param radius=0.4 > "$scratch/report" || code=$?
cat "$scratch/report"
test "$code" -eq 1
# Occlusion has changed, normals have not.
for report in "$scratch/report" "$scratch/bad/junit.xml" "$scratch/bad/compare.html"; do
    grep -q 'ao_raw.npy' "$report"
    grep -q 'ao_blurred.npy' "$report"
done
grep -q '<failure' "$scratch/bad/junit.xml"
if grep 'normal.npy: beyond' "$scratch/report"; then exit 1; fi
if grep '<failure' "$scratch/good/junit.xml"; then exit 1; fi
