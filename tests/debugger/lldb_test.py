"""What LLDB says of every type and with every command: lldb --batch -o 'command script import lldb_test.py' printed_values"""

import os
import sys

import lldb

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
import expected  # noqa: E402


def __lldb_init_module(debugger, _):
    debugger.SetAsync(False)

    frame = None

    def said(command):
        result = lldb.SBCommandReturnObject()
        # While LLDB loads this file, commands know of no process but the one that they are given.
        context = [lldb.SBExecutionContext(frame)] if frame else []
        debugger.GetCommandInterpreter().HandleCommand(command, *context, result)
        return result.GetOutput() if result.Succeeded() else result.GetError().removeprefix("error: ")

    with open(os.path.join(here, "printed_values.cpp"), encoding="utf-8") as source:
        line = next(number for number, line in enumerate(source, 1) if line.startswith(expected.STOP))
    said(f"command script import {here}/../../chapters/debugger/crevice_lldb.py")
    said("settings set target.env-vars ASAN_OPTIONS=detect_leaks=0")
    said(f"breakpoint set -f printed_values.cpp -l {line}")
    said("process launch -o /dev/null")
    frame = debugger.GetSelectedTarget().GetProcess().GetSelectedThread().GetSelectedFrame()
    for name, text in expected.VALUES.items():
        expected.compare(name, frame.GetValueForVariablePath(name).GetSummary() or "", text)
    settings = said("frame variable settings")
    for part in ("samples = 14", "radius = 0.5"):
        if part not in settings:
            expected.failures.append(f"settings: lacks {part!r} in {settings!r}")
    expected.compare_samples("told", said("frame variable told"))
    expected.compare_lines("images", said("images"), expected.IMAGES)
    expected.compare_lines("pixel 3 1", said("pixel 3 1"), expected.PIXEL)
    expected.compare("stats", said("stats maps.fine"), expected.STATS)
    expected.compare_saved(lambda name, path: said(f"save-image {name} {path}"))
    for command, text in {
            "pixel 4 0": "pixel: outside the picture (4, 0); it is 4x2",
            "pixel 1": "usage: pixel X Y",
            "stats point": "stats: point is no image of this frame, or an empty one; `images` lists them",
            "stats absent": "stats: absent is no image of this frame, or an empty one; `images` lists them",
            "save-image maps.fine /nowhere/a.png":
                "/nowhere/a.png: cannot be written (No such file or directory); choose another file",
    }.items():
        expected.compare(command, said(command), text)
    expected.verdict()
