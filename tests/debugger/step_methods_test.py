"""Steps through every method's kernel at one pixel, and compares what it meets with what the probe says of that pixel:

    gdb -batch -nx -x crevice_gdb.py -x step_methods_test.py --args build/debug/crevice
"""

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

# The lines at which a kernel's one-pixel form has found one sample, in the variable `sample`.
SAMPLE_FOUND = {
    "ssao/methods/each_texel.h": "result.samples.push_back(sample);",
    "ssao/methods/luna_explain.cpp": "return sample;",
    "ssao/rays/ray_cast_map.cpp": "result.samples.push_back(sample);",
    "ssao/bakes/vertex_bake.cpp": "result.samples.push_back(sample);",
}
NUMBERS = ("contribution", "dz", "dp", "weight")

failures = []
exits = []  # of the program, method after method


def require(holds, what):
    if not holds:
        failures.append(what)
    return holds


def bits(value):
    return struct.pack("<f", value).hex()


def line_of(path, text):
    with open(os.path.join(root, path), encoding="utf-8") as source:
        lines = [number for number, line in enumerate(source, 1) if line.strip() == text]
    assert len(lines) == 1, f"{path}: {text!r} stands on lines {lines}"
    return lines[0]


def program():
    return gdb.current_progspace().filename


def methods():
    said = subprocess.run([program(), "methods"], capture_output=True, text=True, check=True).stdout
    return [name for name in re.findall(r"^(\w+) ", said, re.MULTILINE) if name not in ("method", "none")]


def stepped_samples(method, said_to):
    """Stops before the kernel, goes into it, and from sample to sample to its end; what the program says goes to a file."""
    gdb.execute(f"set args render {SCENE} --ao {method} --size {SIZE} --pixel {X},{Y} --pass ao --break > {said_to}")
    gdb.execute("run", to_string=True)
    require(int(gdb.parse_and_eval("$_siginfo.si_signo")) == signal.SIGTRAP, f"{method}: no trap")
    require(len(gdb.selected_inferior().threads()) == 1, f"{method}: more than one thread")
    gdb.execute("kernel", to_string=True)
    require(gdb.selected_frame().name().startswith("crevice::explain_"), f"{method}: not in its kernel")
    found = []
    gdb.execute("continue", to_string=True)
    while gdb.selected_inferior().pid != 0:
        sample = gdb.parse_and_eval("sample")
        found.append({name: float(sample[name]) for name in NUMBERS} | {"verdict": sample["verdict"].string()})
        gdb.execute("continue", to_string=True)
    require(getattr(exits[-1], "exit_code", None) == 0, f"{method}: did not run to its end")
    return found


def float_of_npy(path, x, y):
    """A value of a two-dimensional array of little-endian 32-bit floats."""
    with open(path, "rb") as file:
        magic, length = struct.unpack("<8sH", file.read(10))
        header = file.read(length).decode("latin-1")
        rows, columns = (int(n) for n in re.search(r"\((\d+), (\d+)\)", header).groups())
        assert magic == b"\x93NUMPY\x01\x00" and "'<f4'" in header and y < rows
        file.seek(4 * (y * columns + x), os.SEEK_CUR)
        return struct.unpack("<f", file.read(4))[0]


def compare(method, scratch):
    """The kernel at the pixel against the pass over all of them, and against how many samples it says it had."""
    said_to = os.path.join(scratch, "said.txt")
    stepped = stepped_samples(method, said_to)
    with open(said_to, encoding="utf-8") as file:
        said = re.fullmatch(rf"ao at pixel {X},{Y}: texel (\d+),(\d+) of \d+x\d+ is (\S+), of (\d+) samples\n", file.read())
    if not require(said is not None, f"{method}: no last line"):
        return
    require(int(said.group(4)) == len(stepped), f"{method}: stepped through {len(stepped)} samples of {said.group(4)}")
    subprocess.run([program(), "render", SCENE, "--ao", method, "--size", SIZE, "--only", "ao_raw", "--out", scratch],
                   capture_output=True, check=True)
    value = float_of_npy(os.path.join(scratch, "ao_raw.npy"), int(said.group(1)), int(said.group(2)))
    require(bits(value) == bits(float(said.group(3))), f"{method}: {said.group(3)}, where the pass has {value!r}")


gdb.execute("set confirm off")
gdb.execute("set pagination off")
gdb.execute("set environment ASAN_OPTIONS detect_leaks=0")
gdb.events.exited.connect(exits.append)
for path, text in SAMPLE_FOUND.items():
    gdb.Breakpoint(f"{os.path.basename(path)}:{line_of(path, text)}").silent = True
stepped = methods()
require(len(stepped) > 10, f"only {len(stepped)} methods")
with tempfile.TemporaryDirectory() as directory:
    for method in stepped:
        compare(method, directory)
for failure in failures:
    print(failure)
print(f"{len(stepped)} methods, {len(failures)} failures")
gdb.execute(f"quit {1 if failures else 0}")
