"""What GDB and LLDB must say of tests/debugger/printed_values.cpp, and how it is compared."""

import os
import struct
import sys
import tempfile
import zlib

STOP = "    stop_here(gbuffer"

VALUES = {
    "maps.fine": "Image<float> 4x2",
    "maps.fine.size": "4x2",
    "normals": "Image3 4x2",
    "kinds": "Image<unsigned char> 2x2",
    "nothing": "Image<float> 0x0",
    "gbuffer": "GBuffer 4x2, depth d24, normals float32",
    "point": "(1, -2, 0.1)",
    "lanes": "{1, 2.5, -3, 0.1}",
    "whole_lanes": "{7, 7, 7, 7}",
    "halves": "{0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}",
    "mask": "{false, true, false, false}",
    "points": "({1, 2.5, -3, 0.1}, {1, 2.5, -3, 0.1}, {1, 2.5, -3, 0.1})",
    "place": "(12.5, 3)",
    "pair": "(0.1, 2)",
    "eye": "(0.1, 0.0, -10.0)",
    "pass": "name iteration 1, across  value 0.25\n[0]  x 3  y 1  value 0.25  weight 1  verdict counts",
    "lit": "colour (1.5, 0.5, 0.5)  accessibility 1\n"
           "[0]  kind ambient  light -1  colour (0.5, 0.5, 0.5)\n[1]  kind diffuse  light 0   colour (1, 0, 0)",
    "moved": "[1, 0, 0, 5; 0, 1, 0, 6; 0, 0, 1, 7; 0, 0, 0, 1]",
}

IMAGES = """\
normals                4x2  Image3                -1 .. 0.5
gbuffer.normal         4x2  Image3                -1 .. 0.5
gbuffer.view_depth     4x2  Image<float>          0.5 .. 0.5, 1 inf
gbuffer.depth.codes    4x2  Image<int>            16777215 .. 16777215
kinds                  2x2  Image<unsigned char>  3 .. 3
maps.fine              4x2  Image<float>          0.5 .. 0.5, 1 inf
maps.coarse            2x1  Image<float>          0.25 .. 0.75
maps.depth_map         7x5  Image<float>          7 .. 100"""

# At pixel (3, 1): the half-size map shows its texel (1, 0), and the depth map has a border of one.
PIXEL = """\
normals                (3, 1)  (0, 0.5, -1)
gbuffer.normal         (3, 1)  (0, 0.5, -1)
gbuffer.view_depth     (3, 1)  inf
gbuffer.depth.codes    (3, 1)  16777215
kinds                  (1, 1)  3
maps.fine              (3, 1)  inf
maps.coarse            (1, 0)  0.75
maps.depth_map         (4, 2)  7"""

STATS = "min 0.5  max 0.5  mean 0.5  nan 0  inf 1"

failures = []


def compare(what, said, expected):
    if said.strip() != expected.strip():
        failures.append(f"{what}\n  said:     {said.strip()!r}\n  expected: {expected.strip()!r}")


def compare_lines(what, said, expected):
    """Whatever the order of lines and the number of spaces between columns."""
    def columns(text):
        return sorted(tuple(line.split()) for line in text.strip().splitlines())
    compare(what, "\n".join(map(str, columns(said))), "\n".join(map(str, columns(expected))))


def compare_samples(what, said):
    for part in ("1 of 2 samples take something, number 1 most", "nothing in front", "takes 0.5  q (0, 0, 0)"):
        if part not in said:
            failures.append(f"{what}: lacks {part!r} in {said!r}")


def png_pixels(path):
    """Width, height, colour type and the bytes of an unfiltered 8-bit PNG, one row after another."""
    with open(path, "rb") as file:
        png = file.read()
    width, height, bits, colour = struct.unpack(">IIBB", png[16:26])
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and bits == 8
    at, packed = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        content = png[at + 8:at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + content)
        packed += content if kind == b"IDAT" else b""
        at += 12 + length
    lines, stride = zlib.decompress(packed), 1 + width * (3 if colour == 2 else 1)
    return width, height, colour, [list(lines[y * stride + 1:(y + 1) * stride]) for y in range(height)]


def compare_saved(save):
    """`save(name, path)` writes an image and returns what is printed."""
    with tempfile.TemporaryDirectory() as scratch:
        for name, mapping, pixels in (
                ("maps.fine", "0 .. 1 as 0 .. 255", (4, 2, 0, [[128] * 4, [128, 128, 128, 255]])),
                ("normals", "-1 .. 1 as 0 .. 255", (4, 2, 2, [[128, 191, 0] * 4] * 2))):
            path = os.path.join(scratch, name + ".png")
            compare(f"save-image {name}", save(name, path), f"{path}: 4x2, {mapping}")
            if os.path.exists(path):
                compare(f"the PNG of {name}", str(png_pixels(path)), str(pixels))


def verdict():
    """Prints what failed; the last line says whether anything did."""
    for failure in failures:
        print(failure)
    print(f"{len(failures)} differences" if failures else "all as expected")
    sys.stdout.flush()
    return 1 if failures else 0
