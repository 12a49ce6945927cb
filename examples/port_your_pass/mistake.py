#!/usr/bin/env python3
"""Makes one of the mistakes that porters make, on purpose: reads an image of `crevice render`, writes what a pass with
that mistake would have written. For chapters/port_your_pass.md; nothing but Python's own library.

    mistake.py flipped_rows  IN.npy OUT.npy               # row 0 is the lowest, as OpenGL reads pixels back
    mistake.py world_normals IN.npy OUT.npy PASSES.json   # normals in world space instead of view space
    mistake.py mirrored_z    IN.npy OUT.npy               # a right-handed view space: z towards the eye
    mistake.py clear_colour  IN.npy OUT.npy               # normals cleared to (0, 0, -1), where the lab has 0
    mistake.py srgb          IN.npy OUT.npy               # an AO target with an sRGB format
"""
import array
import ast
import json
import struct
import sys

MAGIC = b"\x93NUMPY\x01\x00"


def read_npy(path):
    """The shape and the floats of a .npy as Crevice writes it: version 1.0, '<f4', row by row."""
    with open(path, "rb") as file:
        if file.read(8) != MAGIC:
            sys.exit(f"{path}: not a .npy of version 1.0; give one that crevice render wrote")
        (length,) = struct.unpack("<H", file.read(2))
        header = ast.literal_eval(file.read(length).decode())
        values = array.array("f", file.read())
    return header["shape"], values


def write_npy(path, shape, values):
    header = repr({"descr": "<f4", "fortran_order": False, "shape": tuple(shape)})
    header += " " * (-(len(header) + 11) % 64) + "\n"
    with open(path, "wb") as file:
        file.write(MAGIC + struct.pack("<H", len(header)) + header.encode() + values.tobytes())


def flipped_rows(shape, values, _):
    row = len(values) // shape[0]
    return array.array("f", (v for y in reversed(range(shape[0])) for v in values[y * row : (y + 1) * row]))


def world_normals(shape, values, passes):
    """passes.json holds the view matrix row by row; the inverse of its rotation is its transpose."""
    view = json.load(open(passes))["matrices"]["view"]
    turned = array.array("f")
    for i in range(0, len(values), 3):
        n = values[i : i + 3]
        turned.extend(sum(view[row][column] * n[row] for row in range(3)) for column in range(3))
    return turned


def mirrored_z(shape, values, _):
    return array.array("f", (-v if i % 3 == 2 and v != 0 else v for i, v in enumerate(values)))


def clear_colour(shape, values, _):
    cleared = array.array("f", values)
    for i in range(0, len(values), 3):
        if not any(values[i : i + 3]):
            cleared[i + 2] = -1
    return cleared


def srgb(shape, values, _):
    return array.array("f", (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in values))


def main():
    mistakes = {f.__name__: f for f in (flipped_rows, world_normals, mirrored_z, clear_colour, srgb)}
    words = sys.argv[1:]
    if len(words) < 3 or words[0] not in mistakes or (words[0] == "world_normals") != (len(words) == 4):
        sys.exit(__doc__)
    shape, values = read_npy(words[1])
    write_npy(words[2], shape, mistakes[words[0]](shape, values, words[3] if len(words) == 4 else None))


main()
