"""Crevice in GDB: how its types are printed, and commands for the pictures of a stopped frame.

    gdb -x chapters/debugger/crevice_gdb.py --args build/debug/crevice render ...

or `source chapters/debugger/crevice_gdb.py` at the prompt. GDB loads it by itself, from crevice-gdb.py beside the program,
once ~/.config/gdb/gdbinit says `add-auto-load-safe-path /path/to/this/repository/build`.
"""

import os
import re
import sys

import gdb
import gdb.printing

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import images  # noqa: E402

# ---- values -----------------------------------------------------------------------------------------------------------


def plain(value):
    """The value that a reference refers to."""
    return value.referenced_value() if value.type.strip_typedefs().code == gdb.TYPE_CODE_REF else value


def type_name(value):
    return str(value.type.strip_typedefs().unqualified())


def choice(value):
    """An enumerator without the name of its type."""
    return str(value).split("::")[-1]


def number(value):
    """Of a value that is one word: a number, an enumerator, characters."""
    code = value.type.strip_typedefs().code
    if code == gdb.TYPE_CODE_ENUM:
        return choice(value)
    if code == gdb.TYPE_CODE_PTR:
        return value.string()
    if code == gdb.TYPE_CODE_FLT:
        return images.exact(float(value)) if value.type.sizeof == 4 else repr(float(value))
    return str(value)


def elements(vector):
    """Of a std::vector or CacheLineArray, as pointers to the first and past the last."""
    fields = [field.name for field in vector.type.strip_typedefs().fields()]
    if "first_" in fields:  # CacheLineArray
        return vector["first_"], vector["first_"] + vector["size_"]
    if "__begin_" in fields:  # libc++
        return vector["__begin_"], vector["__end_"]
    return vector["_M_impl"]["_M_start"], vector["_M_impl"]["_M_finish"]


def plane_of(image):
    """None where the memory holds no image, as before a variable's first line."""
    width, height, stride = int(image["size"]["width"]), int(image["size"]["height"]), int(image["stride"])
    first, end = elements(image["pixels"])
    element = first.type.strip_typedefs().target().strip_typedefs()
    count = (int(end) - int(first)) // element.sizeof
    if width < 1 or height < 1 or stride < width or stride * height != count:
        return None
    code = images.element_code(str(element), element.sizeof)
    if code is None:
        return None
    try:
        memory = gdb.selected_inferior().read_memory(int(first), count * element.sizeof)
    except gdb.MemoryError:
        return None
    return images.Plane(width, height, stride, code, memory)


def picture_of(value):
    """None where the value is no image, or holds none."""
    name = type_name(value)
    if name == "crevice::Image3":
        planes = [plane_of(value[axis]) for axis in "xyz"]
    elif name.startswith("crevice::Image<"):
        planes = [plane_of(value)]
    else:
        return None
    return images.Picture(name.removeprefix("crevice::"), planes) if all(planes) else None


def images_in(name, value, depth=4):
    """(name, picture) of the value or of all that it holds, through references and structs."""
    value = plain(value)
    own_type = value.type.strip_typedefs()
    if own_type.code != gdb.TYPE_CODE_STRUCT or type_name(value).startswith(images.OTHERS_TYPES):
        return
    picture = picture_of(value)
    if picture is not None:
        yield name, picture
    elif depth > 0 and not type_name(value).startswith("crevice::Image"):
        for field in own_type.fields():
            if field.name and not field.is_base_class and hasattr(field, "bitpos"):
                yield from images_in(f"{name}.{field.name}", value[field], depth - 1)


def variables(frame):
    """(name, value) of the parameters and of the variables whose line has been run."""
    line, seen, block = frame.find_sal().line, set(), frame.block()
    while block is not None:
        for symbol in block:
            started = symbol.is_argument or symbol.is_variable and symbol.line < line
            if started and symbol.name not in seen:
                seen.add(symbol.name)
                yield symbol.name, symbol.value(frame)
        if block.function is not None:
            return
        block = block.superblock


def images_of_frame():
    found = []
    for name, value in variables(gdb.selected_frame()):
        if name == "this":
            found += ((inner.replace("this.", "this->", 1), picture)
                      for inner, picture in images_in(name, value.dereference()))
        else:
            found += images_in(name, value)
    return found


def named_image(name):
    value = plain(gdb.parse_and_eval(name))
    picture = picture_of(value)
    if picture is None:
        raise gdb.GdbError(f"{name}: no image, or an empty one ({type_name(value)}); `info images` lists those of the frame")
    return picture


# ---- printers ---------------------------------------------------------------------------------------------------------


class Text:
    """A type that is one line."""

    def __init__(self, value):
        self.value = value

    def to_string(self):
        return text_of(self.value)


def text_of(value):
    name = type_name(value)
    for pattern, text in TEXTS:
        if re.fullmatch(pattern, name):
            return text(value)
    return number(value)


# Of one vector, or of two halves.
def lanes(value):
    return [value[field][lane] for field in value.type.strip_typedefs().fields()
            for lane in range(field.type.strip_typedefs().range()[1] + 1)]


def lanes_text(value):
    return "{" + ", ".join(number(lane) for lane in lanes(value)) + "}"


def mask_text(value):
    return "{" + ", ".join("true" if int(lane) else "false" for lane in lanes(value)) + "}"


def components_text(value, names):
    return "(" + ", ".join(text_of(value[name]) for name in names) + ")"


def glm_vector_text(value):
    return components_text(value, "xyzw"[:int(re.match(r"glm::vec<(\d)", type_name(value)).group(1))])


def glm_matrix_text(value):
    """Row by row, as on paper; glm keeps columns."""
    columns, rows = (int(n) for n in re.match(r"glm::mat<(\d), (\d)", type_name(value)).groups())
    lines = (", ".join(number(value["value"][c]["xyzw"[r]]) for c in range(columns)) for r in range(rows))
    return "[" + "; ".join(lines) + "]"


def image_text(value):
    size = value["x"]["size"] if type_name(value) == "crevice::Image3" else value["size"]
    return f"{type_name(value).removeprefix('crevice::')} {text_of(size)}"


TEXTS = [
    (r"crevice::WideOf<.*>", lanes_text),
    (r"crevice::WideMask<.*>", mask_text),
    (r"crevice::Vec3<.*>", lambda v: components_text(v, "xyz")),
    (r"crevice::Screen2<.*>", lambda v: components_text(v, "xy")),
    (r"crevice::Size", lambda v: f"{v['width']}x{v['height']}"),
    (r"crevice::Image<.*>|crevice::Image3", image_text),
    (r"glm::vec<.*>", glm_vector_text),
    (r"glm::mat<.*>", glm_matrix_text),
]


class GBuffer:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        depth, numbers = choice(self.value["depth"]["format"]), choice(self.value["format"])
        return f"GBuffer {text_of(self.value['view_depth']['size'])}, depth {depth}, normals {numbers}"

    def children(self):
        for name in ("normal", "view_depth", "depth", "material", "triangle"):
            yield name, self.value[name]


class AnySettings:
    """The struct that it holds: its type is an argument of the function that std::any manages it with."""

    def __init__(self, value):
        held = value["held_"]
        self.settings = None
        if int(held["_M_manager"]) == 0:
            return
        function = gdb.execute(f"info symbol {int(held['_M_manager'])}", to_string=True)
        place, name = re.match(r"std::any::_Manager_(\w+)<(.*)>::_S_manage", function).groups()
        at = held["_M_storage"]["_M_ptr"] if place == "external" else held["_M_storage"]["_M_buffer"].address
        self.settings = at.cast(gdb.lookup_type(name).pointer()).dereference()

    def to_string(self):
        return "nothing" if self.settings is None else type_name(self.settings).removeprefix("crevice::")

    def children(self):
        if self.settings is not None:
            for field in self.settings.type.fields():
                yield field.name, self.settings[field]


def sample_parts(sample):
    """Its numbers as images.SAMPLE_COLUMNS names them, and its verdict."""
    columns = [[float(sample[member])] if count == 1 else [float(sample[member][axis]) for axis in "xyz"]
               for _, member, count in images.SAMPLE_COLUMNS]
    return columns, sample["verdict"].string()


def explanation_text(value):
    if not value["surface"]:
        return "background, open"
    first, end = elements(value["samples"])
    return images.told_text([sample_parts((first + i).dereference()) for i in range(int(end - first))])


def list_text(value):
    """As images.LISTS says."""
    first, vector, columns = images.LISTS[type_name(value)]
    begin, end = elements(value[vector])
    rows = [[(name, text_of((begin + i).dereference()[name])) for name in columns] for i in range(int(end - begin))]
    return images.list_text([(name, text_of(value[name])) for name in first], rows)


def ao_text(value):
    return f"texel {value['x']},{value['y']} is {number(value['value'])}: {explanation_text(value['explanation'])}"


TEXTS.append((r"std::(?:__cxx11::)?basic_string<char.*>", lambda v: v["_M_dataplus"]["_M_p"].string()))
TEXTS.append((r"crevice::AoProbe", ao_text))
TEXTS += [(name, list_text) for name in images.LISTS]
TEXTS.append((r"crevice::ExplainedSample", lambda v: "  ".join(images.sample_texts(*sample_parts(v)))))
TEXTS.append((r"crevice::Explanation", explanation_text))


def register_printers():
    printers = gdb.printing.RegexpCollectionPrettyPrinter("crevice")
    for pattern in (pattern for pattern, _ in TEXTS if not pattern.startswith("std::")):
        printers.add_printer(pattern, f"^(?:{pattern})$", Text)
    for printer in (GBuffer, AnySettings):
        printers.add_printer(printer.__name__, f"^crevice::{printer.__name__}$", printer)
    gdb.printing.register_pretty_printer(None, printers, replace=True)


# ---- commands ---------------------------------------------------------------------------------------------------------


class Command(gdb.Command):
    """A command of so many words; its class's docstring is what `help` says."""

    words = ()

    def __init__(self, name):
        super().__init__(name, gdb.COMMAND_DATA, gdb.COMPLETE_SYMBOL)
        self.name = name

    def invoke(self, argument, from_tty):
        words = gdb.string_to_argv(argument)
        if len(words) != len(self.words):
            raise gdb.GdbError(f"usage: {' '.join((self.name, *self.words))}")
        try:
            self.run(*words)
        except ValueError as error:
            raise gdb.GdbError(f"{self.name}: {error}") from None
        except OSError as error:
            raise gdb.GdbError(f"{error.filename}: cannot be written ({error.strerror}); choose another file") from None


class InfoImages(Command):
    """The images of the selected frame: name, size, type, smallest and largest value."""

    def run(self):
        print(images.table_of_images(images_of_frame()))


class Pixel(Command):
    """pixel X Y: every image of the frame at this pixel of the largest one; smaller ones at the texel that lies there."""

    words = ("X", "Y")

    def run(self, x, y):
        print(images.table_of_pixel(images_of_frame(), int(x), int(y)))


class Stats(Command):
    """stats NAME: smallest, largest and mean value of an image, and how many are no finite numbers."""

    words = ("NAME",)

    def run(self, name):
        print(named_image(name).statistics().text())


class SaveImage(Command):
    """save-image NAME FILE.png: an image as an 8-bit PNG; how values became bytes is printed."""

    words = ("NAME", "FILE.png")

    def run(self, name, path):
        print(images.save_png(named_image(name), path))


class Kernel(Command):
    """Runs to the first line of the pixel's kernel, from where `crevice render --break` stopped."""

    def run(self):
        listed = gdb.execute("info functions -q -n ^crevice::explain_", to_string=True)
        names = {"crevice::pixel_fragments", *re.findall(r"\bcrevice::explain_\w+", listed)}
        stops = [gdb.Breakpoint(name, internal=True, temporary=True) for name in sorted(names)]
        gdb.execute("continue")
        for stop in stops:
            if stop.is_valid():
                stop.delete()


register_printers()
InfoImages("info images")
Pixel("pixel")
Stats("stats")
SaveImage("save-image")
Kernel("kernel")
# `step` goes over the arithmetic of vectors and lanes, and over the checks of settings.
gdb.execute("skip -gfi */rasterizer/lanes/*.h", to_string=True)
gdb.execute("skip -rfu ^crevice::validate", to_string=True)
