#!/bin/sh
# Opens `crevice view` on a display of its own, drives it by mouse and keys, photographs it, and draws what it copied as a
# command: the same hash. Usage: view_window_test.sh PROGRAM OUT; 77: something that it needs is not installed.
set -eu
program=$1 out=$2
for needed in Xvfb xdotool; do
    command -v $needed > /dev/null || { echo "skipped: $needed is not installed"; exit 77; }
done
rm -rf "$out"
mkdir -p "$out"
fail() { echo "view: $1; see $out/told.txt" >&2; tail -n 4 "$out/told.txt" >&2; exit 1; }
# Waits until the command that follows a number of seconds succeeds.
within() {
    seconds=$1; shift
    for _ in $(seq $((seconds * 5))); do "$@" > /dev/null 2>&1 && return 0; sleep 0.2; done
    return 1
}

Xvfb -displayfd 3 -screen 0 1400x900x24 3> "$out/display" 2> /dev/null &
server=$!
trap 'kill $viewer $server 2> /dev/null || true' EXIT
viewer=
within 20 test -s "$out/display" || fail "Xvfb does not start"
DISPLAY=:$(cat "$out/display")
export DISPLAY SDL_VIDEODRIVER=x11

"$program" view columns --size 320x180 --buffer ao_blurred --out "$out" > "$out/told.txt" 2>&1 &
viewer=$!
within 30 xdotool search --name '^Crevice$' || {
    grep -q "built without" "$out/told.txt" && { echo "skipped: built without SDL2 and Dear ImGui"; exit 77; }
    fail "no window within 30 s"
}
# The first frame is there when it can be copied.
copied() { xdotool key c; sleep 0.3; grep -q "^crevice render" "$out/told.txt"; }
within 60 copied || fail "no frame within 60 s"
grep -q -- "--eye" "$out/told.txt" && fail "the camera was moved before anybody touched it"

# The picture is that of the panel's right; dragging it turns the scene.
xdotool mousemove 900 400; sleep 0.3
xdotool mousedown 1; sleep 0.3
for x in 920 940 960 980; do xdotool mousemove $x 410; sleep 0.2; done
xdotool mouseup 1; sleep 0.3
turned() { xdotool key c; sleep 0.5; tail -n 2 "$out/told.txt" | grep -q -- "--eye"; }
within 30 turned || fail "dragging does not move the camera"

# A pixel, what is left out, truth: photographed.
xdotool mousemove 860 560; sleep 0.3; xdotool click 1; sleep 1
xdotool key l; sleep 0.5
xdotool key F12
within 20 test -s "$out/view_0.png" || fail "no screenshot"
xdotool key Escape; xdotool key 7; sleep 5; xdotool key F12
within 20 test -s "$out/view_1.png" || fail "no second screenshot"

ao_is_copied() { xdotool key 5; sleep 0.5; xdotool key c; sleep 0.5; tail -n 1 "$out/told.txt" | grep -q "ao_blurred"; }
within 30 ao_is_copied || fail "nothing is copied"
line=$(grep "^crevice render" "$out/told.txt" | tail -n 1)
hash=$(sed -n 's/^# ao_blurred //p' "$out/told.txt" | tail -n 1)
# The words hold no blanks of their own here.
# shellcheck disable=SC2086
"$program" ${line#crevice } --only ao_blurred --out "$out/again" > /dev/null
grep -q "\"hash\": \"$hash\"" "$out/again/passes.json" || fail "the copied command draws other bits ($line, $hash)"
echo "the window and the command have the same bits: $hash"
