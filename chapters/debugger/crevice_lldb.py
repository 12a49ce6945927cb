"""Crevice in LLDB: how its types are printed, and commands for the pictures of a stopped frame.

    (lldb) command script import chapters/debugger/crevice_lldb.py

The same line in ~/.lldbinit, with the whole path, loads it every time.
"""

import os
import re
import shlex
import sys

import lldb

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import images  # noqa: E402

STRUCTS = (lldb.eTypeClassStruct, lldb.eTypeClassClass)

# ---- values -----------------------------------------------------------------------------------------------------------


def plain(value):
    """As the program holds it, behind references and without what LLDB makes of it."""
    value = value.GetNonSyntheticValue()
    return value.Dereference().GetNonSyntheticValue() if value.GetType().IsReferenceType() else value


def member(value, path):
    for name in path.split("."):
        value = plain(value.GetChildMemberWithName(name))
    return value


def whole(value, path):
    return member(value, path).GetValueAsSigned()


def type_name(value):
    return value.GetType().GetCanonicalType().GetUnqualifiedType().GetName()


def choice(value):
    return (value.GetValue() or "").split("::")[-1]


def number(value):
    """Of a value that is one word: a number, an enumerator, characters."""
    kind = value.GetType().GetCanonicalType().GetBasicType()
    error = lldb.SBError()
    if kind == lldb.eBasicTypeFloat:
        return images.exact(value.GetData().GetFloat(error, 0))
    if kind == lldb.eBasicTypeDouble:
        return repr(value.GetData().GetDouble(error, 0))
    return (value.GetSummary() or "").strip('"') or choice(value)


def elements(vector):
    """Of a std::vector or CacheLineArray: the addresses of the first and past the last, and the type of one."""
    if vector.GetChildMemberWithName("first_").IsValid():  # CacheLineArray
        first = member(vector, "first_")
        element = first.GetType().GetCanonicalType().GetPointeeType()
        begin, size = first.GetValueAsUnsigned(), member(vector, "size_").GetValueAsUnsigned()
        return begin, begin + size * element.GetByteSize(), element
    names = ("__begin_", "__end_") if vector.GetChildMemberWithName("__begin_").IsValid() else (
        "_M_impl._M_start", "_M_impl._M_finish")  # libc++, libstdc++
    first, end = (member(vector, name) for name in names)
    return first.GetValueAsUnsigned(), end.GetValueAsUnsigned(), first.GetType().GetCanonicalType().GetPointeeType()


def plane_of(image):
    """None where the memory holds no image, as before a variable's first line."""
    width, height, stride = (whole(image, name) for name in ("size.width", "size.height", "stride"))
    first, end, element = elements(member(image, "pixels"))
    count = (end - first) // max(element.GetByteSize(), 1)
    if width < 1 or height < 1 or stride < width or stride * height != count:
        return None
    code = images.element_code(element.GetCanonicalType().GetName(), element.GetByteSize())
    error = lldb.SBError()
    memory = image.GetProcess().ReadMemory(first, count * element.GetByteSize(), error)
    return images.Plane(width, height, stride, code, memory) if code and error.Success() else None


def picture_of(value):
    """None where the value is no image, or holds none."""
    name = type_name(value)
    if name == "crevice::Image3":
        planes = [plane_of(member(value, axis)) for axis in "xyz"]
    elif name.startswith("crevice::Image<"):
        planes = [plane_of(value)]
    else:
        return None
    return images.Picture(name.removeprefix("crevice::"), planes) if all(planes) else None


def images_in(name, value, depth=4):
    """(name, picture) of the value or of all that it holds, through references and structs."""
    value = plain(value)
    if value.GetType().GetCanonicalType().GetTypeClass() not in STRUCTS or type_name(value).startswith(images.OTHERS_TYPES):
        return
    picture = picture_of(value)
    if picture is not None:
        yield name, picture
    elif depth > 0 and not type_name(value).startswith("crevice::Image"):
        for index in range(value.GetNumChildren()):
            inner = value.GetChildAtIndex(index)
            if inner.GetName():
                yield from images_in(f"{name}.{inner.GetName()}", inner, depth - 1)


def variables(frame):
    """The parameters and the variables whose line has been run."""
    line = frame.GetLineEntry().GetLine()
    for value in frame.GetVariables(True, True, False, True):
        if value.GetValueType() == lldb.eValueTypeVariableArgument or value.GetDeclaration().GetLine() < line:
            yield value


def images_of(frame):
    found = []
    for value in variables(frame):
        if value.GetName() == "this":
            found += ((name.replace("this.", "this->", 1), picture)
                      for name, picture in images_in("this", value.Dereference()))
        else:
            found += images_in(value.GetName(), value)
    return found


def named_image(frame, name):
    value = frame.GetValueForVariablePath(name)
    picture = picture_of(plain(value)) if value.IsValid() else None
    if picture is None:
        raise ValueError(f"{name} is no image of this frame, or an empty one; `images` lists them")
    return picture


# ---- summaries --------------------------------------------------------------------------------------------------------


# Of one vector, or of two halves.
def lanes(value):
    vectors = [value.GetChildAtIndex(i) for i in range(value.GetNumChildren())]
    return [vector.GetChildAtIndex(lane) for vector in vectors for lane in range(vector.GetNumChildren())]


def text_of(value):
    value, name = plain(value), type_name(value)
    for pattern, text in SUMMARIES:
        if re.match(pattern, name):
            return text(value, {})
    return number(value)


def components_text(value, names):
    return "(" + ", ".join(text_of(value.GetChildMemberWithName(name)) for name in names) + ")"


def lanes_text(value, _):
    return "{" + ", ".join(number(lane) for lane in lanes(plain(value))) + "}"


def mask_text(value, _):
    return "{" + ", ".join("true" if lane.GetValueAsSigned() else "false" for lane in lanes(plain(value))) + "}"


def vec3_text(value, _):
    return components_text(plain(value), "xyz")


def screen2_text(value, _):
    return components_text(plain(value), "xy")


def size_text(value, _):
    return f"{whole(plain(value), 'width')}x{whole(plain(value), 'height')}"


def image_text(value, _):
    value = plain(value)
    size = member(value, "x.size" if type_name(value) == "crevice::Image3" else "size")
    return f"{type_name(value).removeprefix('crevice::')} {size_text(size, {})}"


def glm_floats(value):
    """All the numbers of a glm vector or matrix, as they lie in memory."""
    kind = re.match(r"glm::\w+<([\d, ]+), (\w+)", type_name(value)).group(2)
    data, error = value.GetData(), lldb.SBError()
    if kind == "double":
        return [repr(data.GetDouble(error, 8 * i)) for i in range(value.GetByteSize() // 8)]
    read = {"float": lambda at: images.exact(data.GetFloat(error, at)),
            "int": lambda at: str(data.GetSignedInt32(error, at))}[kind]
    return [read(4 * i) for i in range(value.GetByteSize() // 4)]


def glm_vector_text(value, _):
    return "(" + ", ".join(glm_floats(plain(value))) + ")"


def glm_matrix_text(value, _):
    """Row by row, as on paper; glm keeps columns."""
    value = plain(value)
    columns, rows = (int(n) for n in re.match(r"glm::mat<(\d), (\d)", type_name(value)).groups())
    numbers = glm_floats(value)
    lines = (", ".join(numbers[c * rows + r] for c in range(columns)) for r in range(rows))
    return "[" + "; ".join(lines) + "]"


def gbuffer_text(value, _):
    value = plain(value)
    size = size_text(member(value, "view_depth.size"), {})
    return f"GBuffer {size}, depth {choice(member(value, 'depth.format'))}, normals {choice(member(value, 'format'))}"


def sample_parts(sample):
    """Its numbers as images.SAMPLE_COLUMNS names them, and its verdict."""
    error = lldb.SBError()
    columns = [[sample.GetChildMemberWithName(member).GetData().GetFloat(error, 4 * i) for i in range(count)]
               for _, member, count in images.SAMPLE_COLUMNS]
    return columns, sample.GetChildMemberWithName("verdict").GetSummary().strip('"')


def sample_text(value, _):
    return "  ".join(images.sample_texts(*sample_parts(plain(value))))


def explanation_text(value, _):
    value = plain(value)
    if not value.GetChildMemberWithName("surface").GetValueAsUnsigned():
        return "background, open"
    first, end, kind = elements(member(value, "samples"))
    target = value.GetTarget()
    return images.told_text([
        sample_parts(target.CreateValueFromAddress("sample", lldb.SBAddress(at, target), kind))
        for at in range(first, end, kind.GetByteSize())])


def list_text(value, _):
    """As images.LISTS says."""
    value = plain(value)
    first, vector, columns = images.LISTS[type_name(value)]
    begin, end, kind = elements(member(value, vector))
    target = value.GetTarget()
    rows = [target.CreateValueFromAddress("row", lldb.SBAddress(at, target), kind)
            for at in range(begin, end, kind.GetByteSize())]
    return images.list_text([(name, text_of(value.GetChildMemberWithName(name))) for name in first],
                            [[(name, text_of(row.GetChildMemberWithName(name))) for name in columns] for row in rows])


def ao_text(value, _):
    value = plain(value)
    x, y, access = (number(value.GetChildMemberWithName(name)) for name in ("x", "y", "value"))
    return f"texel {x},{y} is {access}: {explanation_text(value.GetChildMemberWithName('explanation'), {})}"


SUMMARIES = [
    (r"^crevice::WideOf<.*>$", lanes_text),
    (r"^crevice::WideMask<.*>$", mask_text),
    (r"^crevice::Vec3<.*>$", vec3_text),
    (r"^crevice::Screen2<.*>$", screen2_text),
    (r"^crevice::Size$", size_text),
    (r"^crevice::Image(<.*>|3)$", image_text),
    (r"^crevice::GBuffer$", gbuffer_text),
    (r"^crevice::ExplainedSample$", sample_text),
    (r"^crevice::Explanation$", explanation_text),
    (r"^crevice::AoProbe$", ao_text),
    *((f"^{name}$", list_text) for name in images.LISTS),
    (r"^glm::vec<.*>$", glm_vector_text),
    (r"^glm::mat<.*>$", glm_matrix_text),
]


class AnySettings:
    """The struct that it holds: its type is an argument of the function that std::any manages it with."""

    def __init__(self, value, _):
        self.value = value
        self.settings = None

    def update(self):
        self.settings = None
        held = member(self.value, "held_")
        target = held.GetTarget()
        address = target.ResolveLoadAddress(member(held, "_M_manager").GetValueAsUnsigned())
        manager = address.GetSymbol().GetName() or ""
        named = re.match(r"std::any::_Manager_(\w+)<(.*)>::_S_manage", manager)
        if named is None:
            return
        kind = target.FindFirstType(named.group(2))
        storage = held.GetChildMemberWithName("_M_storage")
        at = (member(storage, "_M_ptr").GetValueAsUnsigned() if named.group(1) == "external" else
              storage.GetChildMemberWithName("_M_buffer").GetLoadAddress())
        self.settings = target.CreateValueFromAddress("settings", lldb.SBAddress(at, target), kind)

    def num_children(self):
        return 0 if self.settings is None else self.settings.GetNumChildren()

    def get_child_at_index(self, index):
        return self.settings.GetChildAtIndex(index)

    def get_child_index(self, name):
        return self.settings.GetIndexOfChildWithName(name)


# ---- commands ---------------------------------------------------------------------------------------------------------


def command(usage):
    """A function of a frame and words as a command of LLDB."""
    wanted = usage.split()[1:]

    def made(run):
        def invoke(debugger, argument, context, result, _):
            words = shlex.split(argument)
            if len(words) != len(wanted):
                result.SetError(f"usage: {usage}")
                return
            try:
                result.AppendMessage(run(context.GetFrame(), *words))
            except ValueError as error:
                result.SetError(f"{usage.split()[0]}: {error}")
            except OSError as error:
                result.SetError(f"{error.filename}: cannot be written ({error.strerror}); choose another file")
        invoke.__doc__ = run.__doc__
        return invoke
    return made


@command("images")
def list_images(frame):
    """The images of the selected frame: name, size, type, smallest and largest value."""
    return images.table_of_images(images_of(frame))


@command("pixel X Y")
def pixel(frame, x, y):
    """pixel X Y: every image of the frame at this pixel of the largest one; smaller ones at the texel that lies there."""
    return images.table_of_pixel(images_of(frame), int(x), int(y))


@command("stats NAME")
def stats(frame, name):
    """stats NAME: smallest, largest and mean value of an image, and how many are no finite numbers."""
    return named_image(frame, name).statistics().text()


@command("save-image NAME FILE.png")
def save_image(frame, name, path):
    """save-image NAME FILE.png: an image as an 8-bit PNG; how values became bytes is printed."""
    return images.save_png(named_image(frame, name), path)


def kernel(debugger, argument, context, result, _):
    """Runs to the first line of the pixel's kernel, from where `crevice render --break` stopped."""
    context.GetTarget().BreakpointCreateByRegex("^crevice::(explain_|pixel_fragments)").SetOneShot(True)
    debugger.HandleCommand("process continue")


def __lldb_init_module(debugger, _):
    module = __name__
    for pattern, text in SUMMARIES:
        expanded = "-e" if text is gbuffer_text else ""
        debugger.HandleCommand(f"type summary add {expanded} -F {module}.{text.__name__} -x '{pattern}'")
    debugger.HandleCommand(f"type synthetic add -l {module}.AnySettings crevice::AnySettings")
    for name, function in (("images", "list_images"), ("pixel", "pixel"), ("stats", "stats"),
                           ("save-image", "save_image"), ("kernel", "kernel")):
        debugger.HandleCommand(f"command script add -f {module}.{function} {name}")
    # `step` goes over the arithmetic of vectors and lanes, and over the checks of settings.
    debugger.HandleCommand("settings set target.process.thread.step-avoid-regexp "
                           "^std::|^glm::|^crevice::(Vec3|Wide|select|dot|load|gather|validate)")
