"""What GDB says of every type and with every command: gdb -batch -nx -x crevice_gdb.py -x gdb_test.py --args printed_values"""

import os
import sys

import gdb

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
import expected  # noqa: E402


def said(command):
    try:
        return gdb.execute(command, to_string=True)
    except gdb.error as error:
        return str(error).removeprefix("Error occurred in Python: ")


def line_of(text):
    with open(os.path.join(here, "printed_values.cpp"), encoding="utf-8") as source:
        return next(number for number, line in enumerate(source, 1) if line.startswith(text))


gdb.execute("set confirm off")
gdb.execute("set environment ASAN_OPTIONS detect_leaks=0")
gdb.execute(f"break printed_values.cpp:{line_of(expected.STOP)}", to_string=True)
gdb.execute("run > /dev/null", to_string=True)

for name, text in expected.VALUES.items():
    expected.compare(name, said(f"output {name}").split(" = {")[0], text)
settings = said("output settings")
for part in ("LunaSettings = {", "samples = 14", "radius = 0.5"):
    if part not in settings:
        expected.failures.append(f"settings: lacks {part!r} in {settings!r}")
expected.compare("few", said("output few"), "Size = {width = 4, height = 2}")
expected.compare("none", said("output none"), "nothing")
expected.compare_samples("told", said("output told"))
expected.compare_lines("info images", said("info images"), expected.IMAGES)
expected.compare_lines("pixel 3 1", said("pixel 3 1"), expected.PIXEL)
expected.compare("stats", said("stats maps.fine"), expected.STATS)
expected.compare_saved(lambda name, path: said(f"save-image {name} {path}"))
for command, text in {
        "pixel 4 0": "pixel: outside the picture (4, 0); it is 4x2",
        "pixel 1": "usage: pixel X Y",
        "stats point": "point: no image, or an empty one (crevice::Vec3<float>); `info images` lists those of the frame",
        "stats nothing": "nothing: no image, or an empty one (crevice::Image<float>); `info images` lists those of the frame",
        "stats absent": 'No symbol "absent" in current context.',
        "save-image maps.fine /nowhere/a.png": "/nowhere/a.png: cannot be written (No such file or directory); choose another file",
}.items():
    expected.compare(command, said(command), text)
gdb.execute(f"quit {expected.verdict()}")
