"""Steps through every method's kernel at one pixel, and through the passes around it, and compares what it meets with what
`crevice probe --json` says of that pixel:

    gdb -batch -nx -x crevice_gdb.py -x step_methods_test.py --args crevice
"""

import json
import math
import os
import re
import signal
import struct
import subprocess
import tempfile

import gdb

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
SCENE, SIZE, X, Y = "wall_corner", "64x36", 20, 25

# The lines at which a kernel has found one sample, in the variable `sample`.
SAMPLE_FOUND = {
    "ssao/methods/each_texel.cpp": "result.samples.push_back(std::move(sample));",
    "ssao/methods/luna_explain.cpp": "return sample;",
    "ssao/rays/ray_cast_map.cpp": "result.samples.push_back(sample);",
    "ssao/bakes/vertex_bake.cpp": "result.samples.push_back(sample);",
}
# What is read there: members of ExplainedSample, which are the names in the document, too.
NUMBERS, POINTS = ("contribution", "dz", "dp", "weight"), ("q_view", "r_view")

failures = []
exits = []  # of the program, one run after the other
others = []  # threads of this run beside the first


def require(holds, what):
    if not holds:
        failures.append(what)
    return holds


def same_bits(value, told):
    """The document has null for what is no finite number."""
    if told is None:
        return not math.isfinite(value)
    return struct.pack("<f", value) == struct.pack("<f", told)


def line_of(path, text):
    with open(os.path.join(root, path), encoding="utf-8") as source:
        lines = [number for number, line in enumerate(source, 1) if line.strip() == text]
    assert len(lines) == 1, f"{path}: {text!r} stands on lines {lines}"
    return lines[0]


def program():
    return gdb.current_progspace().filename


def said(*words):
    return subprocess.run([program(), *words], capture_output=True, text=True, check=True).stdout


def methods():
    return [name for name in re.findall(r"^(\w+) ", said("methods"), re.MULTILINE) if name not in ("method", "none")]


def stop_before(what, method, name, file=os.devnull):
    """Runs until the trap before the kernel of a pass; what the program prints goes to a file."""
    for stop in sample_stops:
        stop.enabled = name == "ao"
    gdb.execute(f"set args render {SCENE} --ao {method} --size {SIZE} --pixel {X},{Y} --pass {name} --break > {file}")
    others.clear()
    gdb.execute("run", to_string=True)
    if not require(gdb.selected_inferior().pid != 0, f"{what}: ran to its end"):
        return False
    require(int(gdb.parse_and_eval("$_siginfo.si_signo")) == signal.SIGTRAP, f"{what}: no trap")
    return True


def go_to_the_end(what):
    while gdb.selected_inferior().pid != 0:
        gdb.execute("continue", to_string=True)
    require(getattr(exits[-1], "exit_code", None) == 0, f"{what}: ended with an error")
    require(not others, f"{what}: more than one thread")


def stepped_samples(method, file):
    """From the trap into the kernel, and from sample to sample to its end."""
    gdb.execute("kernel", to_string=True)
    require(gdb.selected_frame().name().startswith("crevice::explain_"), f"{method}: not in its kernel")
    found = []
    gdb.execute("continue", to_string=True)
    while gdb.selected_inferior().pid != 0:
        sample = gdb.parse_and_eval("sample")
        found.append({name: [float(sample[name])] for name in NUMBERS} |
                     {name: [float(sample[name][axis]) for axis in "xyz"] for name in POINTS} |
                     {"verdict": sample["verdict"].string()})
        gdb.execute("continue", to_string=True)
    go_to_the_end(method)
    with open(file, encoding="utf-8") as output:
        return found, output.read()


def compare_ao(method, told, file):
    if not stop_before(method, method, "ao", file):
        return
    found, printed = stepped_samples(method, file)
    value = re.fullmatch(rf"ao at pixel {X},{Y}: (\S+), of {len(told['samples'])} samples\n", printed)
    if require(value is not None, f"{method}: says {printed!r}"):
        require(same_bits(float(value.group(1)), told["value"]), f"{method}: {value.group(1)}, probe {told['value']}")
    if not require(len(found) == len(told["samples"]), f"{method}: {len(found)} samples, probe {len(told['samples'])}"):
        return
    for index, (one, other) in enumerate(zip(found, told["samples"])):
        for name in NUMBERS + POINTS:
            others = other[name] if name in POINTS else [other[name]]
            require(all(map(same_bits, one[name], others)), f"{method}, sample {index}: {name} {one[name]}, probe {others}")
        require(one["verdict"] == other["verdict"], f"{method}, sample {index}: {one['verdict']}, probe {other['verdict']}")


def kernel_said(what, method, name):
    """Over the call of the kernel, and what it returned: the variable `told`, as it stands on the next line."""
    if not stop_before(what, method, name):
        return None
    gdb.execute("next", to_string=True)
    return gdb.parse_and_eval("told")


def compare_blur(method, told):
    what = f"{method}, blur"
    blur = kernel_said(what, method, "blur")
    if blur is None:
        return
    require(same_bits(float(blur["value"]), told["value"]), f"{what}: {float(blur['value'])}, probe {told['value']}")
    first, end = elements(blur["passes"])
    require(int(end - first) == len(told["passes"]), f"{what}: {int(end - first)} passes, probe {len(told['passes'])}")
    go_to_the_end(what)


def compare_others(passes):
    """The passes before and behind, which are the same for all methods."""
    lit = kernel_said("lit", "xjun", "lit")
    colour = [float(lit["colour"][axis]) for axis in "xyz"]
    require(all(map(same_bits, colour, passes["lit"]["value"])), f"lit: {colour}, probe {passes['lit']['value']}")
    go_to_the_end("lit")
    raster = kernel_said("normal_depth", "xjun", "normal_depth")
    first, end = elements(raster["fragments"])
    require(int(end - first) == len(passes["raster"]["triangles"]), "normal_depth: another number of triangles")
    require(int(raster["code"]) == passes["raster"]["code"], f"normal_depth: {raster['code']}, probe {passes['raster']['code']}")
    go_to_the_end("normal_depth")


def compare(method, file):
    passes = json.loads(said("probe", SCENE, str(X), str(Y), "--ao", method, "--size", SIZE, "--json"))["passes"]
    compare_ao(method, passes["ao"], file)
    if "left_out" not in passes["blur"]:
        compare_blur(method, passes["blur"])
    if method == "xjun":
        compare_others(passes)


gdb.execute("set confirm off")
gdb.execute("set pagination off")
gdb.execute("set environment ASAN_OPTIONS detect_leaks=0")
gdb.events.exited.connect(exits.append)
gdb.events.new_thread.connect(lambda event: event.inferior_thread.num > 1 and others.append(event.inferior_thread.num))
sample_stops = [gdb.Breakpoint(f"{os.path.basename(path)}:{line_of(path, text)}") for path, text in SAMPLE_FOUND.items()]
for stop in sample_stops:
    stop.silent = True
stepped = methods()
require(len(stepped) > 10, f"only {len(stepped)} methods")
with tempfile.TemporaryDirectory() as directory:
    for method in stepped:
        compare(method, os.path.join(directory, "said.txt"))
# What has no kernel to stop before is refused, with the exit code of a wrong word.
gdb.execute(f"set args render {SCENE} --ao none --size {SIZE} --pixel {X},{Y} --pass ao --break 2> {os.devnull}")
gdb.execute("run", to_string=True)
require(getattr(exits[-1], "exit_code", None) == 2, "none: not refused")
for failure in failures:
    print(failure)
print(f"{len(stepped)} methods, {len(failures)} failures")
gdb.execute(f"quit {1 if failures else 0}")
