#!/bin/sh
# Every Jupyter notebook of the book is valid and runs from its first cell to its last. By hand, since it needs Debian's
# jupyter-nbconvert, python3-ipykernel and python3-numpy; the cells ask for pictures of the size that the chapters had:
#
#     crevice chapter all --size 160x90 --lang en --out OUT
#     CREVICE=build/release/crevice tests/pages/notebooks_test.sh OUT
set -eu
out=${1:?give the directory that \`crevice chapter all --out\` wrote}
CREVICE=$(realpath "${CREVICE:-build/release/crevice}")
export CREVICE
failed=0
for notebook in "$out"/*/*.ipynb; do
    if jupyter nbconvert --to notebook --execute --output-dir "$out/executed" "$notebook" >"$out/nbconvert.txt" 2>&1; then
        echo "$notebook runs"
    else
        failed=1
        echo "$notebook does not run:"
        tail -n 5 "$out/nbconvert.txt"
    fi
done
exit $failed
