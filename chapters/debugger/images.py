"""The pictures of a stopped program, for any debugger: their numbers, statistics and PNG files. Standard library only."""

import array
import math
import struct
import zlib

# No images are looked for in them.
OTHERS_TYPES = ("std::", "glm::", "CLI::", "nlohmann::")


def element_code(type_name, bytes_each):
    """What `array` calls the elements of Image<T>, by the debugger's name of T; enumerations by their size. None: unknown."""
    codes = {"float": "f", "double": "d", "int": "i", "unsigned int": "I", "unsigned char": "B"}
    return codes.get(type_name, {1: "B", 4: "i"}.get(bytes_each))


class Plane:
    """One Image<T>: rows from the top, each `stride` elements long, of which the first `width` are pixels."""

    def __init__(self, width, height, stride, code, memory):
        self.width, self.height, self.stride = width, height, stride
        self.elements = array.array(code, bytes(memory))

    def row(self, y):
        return self.elements[y * self.stride:y * self.stride + self.width]

    def at(self, x, y):
        return self.elements[y * self.stride + x]

    def rows(self):
        return (self.row(y) for y in range(self.height))


class Picture:
    """A picture of one plane (Image<T>) or three (Image3), as it stood when it was read."""

    def __init__(self, kind, planes):
        self.kind, self.planes = kind, planes
        self.width, self.height = planes[0].width, planes[0].height

    def at(self, x, y):
        return tuple(plane.at(x, y) for plane in self.planes)

    def statistics(self):
        return Statistics(row for plane in self.planes for row in plane.rows())


class Statistics:
    """Of the finite values; the others are counted."""

    def __init__(self, rows):
        self.count = self.nan = self.infinite = 0
        self.low, self.high, sums = math.inf, -math.inf, []
        for row in rows:
            self.count += len(row)
            if not math.isfinite(sum(row)):
                self.nan += sum(value != value for value in row)
                self.infinite += sum(value in (math.inf, -math.inf) for value in row)
                row = [value for value in row if math.isfinite(value)]
            if len(row) > 0:
                self.low, self.high = min(self.low, min(row)), max(self.high, max(row))
                sums.append(math.fsum(row))
        finite = self.count - self.nan - self.infinite
        self.mean = math.fsum(sums) / finite if finite > 0 else math.nan

    def any_finite(self):
        return self.count > self.nan + self.infinite

    def text(self):
        span = f"min {short(self.low)}  max {short(self.high)}  mean {short(self.mean)}"
        return f"{span if self.any_finite() else 'no finite value'}  nan {self.nan}  inf {self.infinite}"

    def range_text(self):
        span = f"{short(self.low)} .. {short(self.high)}" if self.any_finite() else "no finite value"
        return span + "".join(f", {count} {name}" for count, name in ((self.infinite, "inf"), (self.nan, "nan")) if count)


def short(value):
    return str(value) if isinstance(value, int) else f"{value:.6g}"


def exact(value):
    """The shortest text that reads back as the same 32-bit float; whole numbers as they are."""
    if isinstance(value, int) or value != value or value in (math.inf, -math.inf):
        return str(value)
    for digits in range(1, 17):
        text = f"{value:.{digits}g}"
        if struct.unpack("f", struct.pack("f", float(text)))[0] == value:
            return text
    return repr(value)


def pixel_text(components):
    if len(components) == 1:
        return exact(components[0])
    return "(" + ", ".join(exact(c) for c in components) + ")"


def mapping_of(picture):
    """How values become bytes, as a function and in words."""
    spread = picture.statistics()
    low, high = spread.low, spread.high
    if len(picture.planes) == 3 and low < 0 and low >= -1 and high <= 1:
        low, high, words = -1.0, 1.0, "-1 .. 1 as 0 .. 255"
    elif low >= 0 and high <= 1 and picture.planes[0].elements.typecode in "fd":
        low, high, words = 0.0, 1.0, "0 .. 1 as 0 .. 255"
    else:
        words = f"{short(low)} .. {short(high)} as 0 .. 255"

    def byte(value):
        if value != value:
            return 0
        if value <= low:
            return 0
        if value >= high:
            return 255
        return int((value - low) / (high - low) * 255 + 0.5)

    return byte, words + (", NaN as 0" if spread.nan else "")


def png_bytes(picture):
    """An 8-bit PNG, grey of one plane and RGB of three, and in words how values became bytes."""
    byte, words = mapping_of(picture)
    lines = bytearray()
    for y in range(picture.height):
        lines.append(0)  # the filter of this line: none
        rows = [plane.row(y) for plane in picture.planes]
        for pixel in zip(*rows):
            lines.extend(byte(value) for value in pixel)

    def chunk(kind, content):
        return (struct.pack(">I", len(content)) + kind + content +
                struct.pack(">I", zlib.crc32(kind + content)))

    colour = 2 if len(picture.planes) == 3 else 0
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, colour, 0, 0, 0)
    png = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(lines))) +
           chunk(b"IEND", b""))
    return png, words


def is_depth_map(name):
    """Whether it has a border: one column and row before the picture, two behind (AoInputs::depth_map)."""
    return name.split(".")[-1] == "depth_map"


def picture_size(images):
    """Of the largest image, which the others show in fewer pixels."""
    sizes = [(p.width * p.height, p.width, p.height) for name, p in images if not is_depth_map(name)]
    return max(sizes)[1:] if sizes else (0, 0)


def place_in(name, picture, x, y, size):
    """The pixel of `picture` that shows pixel (x, y) of a picture of this size."""
    if is_depth_map(name) and (picture.width, picture.height) == (size[0] + 3, size[1] + 3):
        return x + 1, y + 1
    return ((2 * x + 1) * picture.width // (2 * size[0]), (2 * y + 1) * picture.height // (2 * size[1]))


# ---- what the commands print, from [(name, picture), ...] -------------------------------------------------------------


def aligned(rows):
    """Lines of all rows, their columns but for the last one padded to the same width."""
    if not rows:
        return ""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]) - 1)]
    return "\n".join("  ".join([*(word.ljust(width) for word, width in zip(row, widths)), row[-1]]) for row in rows)


def table_of_images(images):
    if not images:
        return "no images in this frame"
    return aligned([(name, f"{picture.width}x{picture.height}", picture.kind, picture.statistics().range_text())
                    for name, picture in images])


def table_of_pixel(images, x, y):
    if not images:
        raise ValueError("no images in this frame")
    width, height = size = picture_size(images)
    if not (0 <= x < width and 0 <= y < height):
        raise ValueError(f"outside the picture ({x}, {y}); it is {width}x{height}")
    rows = []
    for name, picture in images:
        column, row = place_in(name, picture, x, y, size)
        rows.append((name, f"({column}, {row})", pixel_text(picture.at(column, row))))
    return aligned(rows)


# What the kernels of the other passes tell of a pixel: members for the first line, and those of each element of a vector.
LISTS = {
    "crevice::ExplainedPass": (("name", "value"), "taps", ("x", "y", "value", "weight", "verdict")),
    "crevice::LitExplanation": (("colour", "accessibility"), "terms", ("kind", "light", "colour")),
    "crevice::PixelFragments": (("shown", "code"), "fragments", ("number", "z_ndc", "code", "stored", "verdict")),
}


def list_text(first, rows):
    """From (member, text) pairs."""
    lines = aligned([[f"[{index}]", *(f"{name} {text}" for name, text in row)] for index, row in enumerate(rows)])
    return "  ".join(f"{name} {text}" for name, text in first) + ("\n" + lines if rows else "")


# What is told of an ExplainedSample: a word for it, its member, and how many numbers that has.
SAMPLE_COLUMNS = (("takes", "contribution", 1), ("q", "q_view", 3), ("r", "r_view", 3), ("dz", "dz", 1), ("dp", "dp", 1),
                  ("weight", "weight", 1))


def short_text(numbers):
    return short(numbers[0]) if len(numbers) == 1 else "(" + ", ".join(map(short, numbers)) + ")"


def sample_texts(columns, verdict):
    """From the numbers of each of SAMPLE_COLUMNS."""
    return [f"{word} {short_text(numbers)}" for (word, _, _), numbers in zip(SAMPLE_COLUMNS, columns)] + [verdict]


def told_text(samples):
    """An Explanation, a line a sample, from [(columns, verdict), ...]."""
    taken = [columns[0][0] for columns, _ in samples]
    some = sum(t > 0 for t in taken)
    most = f", number {taken.index(max(taken))} most" if some else ""
    rows = [[f"[{index}]", *sample_texts(*sample)] for index, sample in enumerate(samples)]
    return f"{some} of {len(taken)} samples take something{most}\n{aligned(rows)}"


def save_png(picture, path):
    png, words = png_bytes(picture)
    with open(path, "wb") as file:
        file.write(png)
    return f"{path}: {picture.width}x{picture.height}, {words}"
