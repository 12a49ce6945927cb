#!/bin/sh
# Installs the libraries into a scratch directory, builds the programs of examples/ against them, draws a corner of two walls
# and a floor, which must not be open everywhere, and runs AO on the buffers of `crevice render`, which must be that command's own.
# usage: install_test.sh BUILD_DIRECTORY CXX_COMPILER
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$1" --prefix "$scratch/installed" >/dev/null
flags=$(sed -n 's/^CREVICE_SANITIZE:STRING=//p' "$1/CMakeCache.txt")
cmake -G Ninja -S "$here/../../examples" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/installed" \
    -DCMAKE_CXX_COMPILER="$2" ${flags:+-DCMAKE_CXX_FLAGS=-fsanitize=$flags} >/dev/null
cmake --build "$scratch/build" >/dev/null
cat > "$scratch/corner.obj" <<'OBJ'
v 0 0 0
v 4 0 0
v 0 4 0
v 0 0 4
v 4 4 0
v 4 0 4
v 0 4 4
f 1 2 5 3
f 1 3 7 4
f 1 4 6 2
OBJ
"$scratch/build/occlusion_of_obj" "$scratch/corner.obj" "$scratch/corner.png"
# A picture of one grey deflates to less.
test "$(wc -c < "$scratch/corner.png")" -gt 4000
! "$scratch/build/occlusion_of_obj" "$scratch/nothing.obj" "$scratch/nothing.png"
crevice=$1/crevice
[ -x "$crevice" ] || exit 0  # built without the command
"$crevice" render columns --size 160x90 --out "$scratch/frame" >/dev/null
"$scratch/build/ao_of_buffers" "$scratch/frame/normal.npy" "$scratch/frame/view_depth.npy" 60 "$scratch/ao_raw.npy"
"$crevice" compare "$scratch/ao_raw.npy" "$scratch/frame/ao_raw.npy" >/dev/null
