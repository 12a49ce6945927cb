#include "chapters/compare/compared_files.h"

#include <algorithm>
#include <ostream>
#include <set>
#include <string>
#include <utility>

#include "chapters/compare/compared_image.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

// The images of one side that may have partners on the other.
struct Side {
    fs::path path;  // as the user named it, or a file in that directory
    std::vector<ComparedImage> images;
};

bool same_shape(const ComparedImage& a, const ComparedImage& b) {
    return a.planes.size() == b.planes.size() && a.planes[0].size == b.planes[0].size;
}

bool same_values(const Image<float>& a, const Image<float>& b) {
    for (int y = 0; y < a.size.height; ++y) {
        if (!std::equal(a.row(y), a.row(y) + a.size.width, b.row(y))) return false;
    }
    return true;
}

// Three equal components, as a decoder makes of a grey picture, are one.
void keep_one_grey(ComparedImage& image) {
    Planes& planes = image.planes;
    if (planes.size() == 3 && same_values(planes[0], planes[1]) && same_values(planes[0], planes[2]))
        planes.resize(1);
}

// Grey pictures are compared as grey, whatever either file stores.
void match_greys(ComparedImage& a, ComparedImage& b) {
    if (!a.picture || !b.picture) return;
    if (a.planes.size() == 1) keep_one_grey(b);
    if (b.planes.size() == 1) keep_one_grey(a);
}

std::string shape_text(const Planes& planes) {
    return std::to_string(planes[0].size.width) + "x" + std::to_string(planes[0].size.height) + "x" +
           std::to_string(planes.size());
}

// Where only one has alpha, the other is opaque.
Planes alpha_of(ComparedImage& image) {
    return planes_of(image.alpha.empty() ? Image<float>(image.planes[0].size, 1.0f) : std::move(image.alpha));
}

bool shows_light(const std::string& name, const ComparedImage& image) {
    return image.light || name == "lit.npy";
}

// A pair of one shape, and their alpha if any has some.
void add_pair(const std::string& name, const fs::path& path_a, ComparedImage a, const fs::path& path_b,
              ComparedImage b, std::ostream& warnings, std::vector<DifferenceEntry>& entries) {
    if (a.linear != b.linear) {
        warnings << "warning: " << (a.linear ? path_b : path_a).string()
                 << ": its values are sRGB codes and those of " << (a.linear ? path_a : path_b).string()
                 << " linear; they are compared as they stand\n";
    }
    const bool has_alpha = !a.alpha.empty() || !b.alpha.empty(),
               light = shows_light(name, a) || shows_light(name, b);
    Planes alpha_a = has_alpha ? alpha_of(a) : Planes(), alpha_b = has_alpha ? alpha_of(b) : Planes();
    entries.push_back({name, std::move(a.planes), std::move(b.planes), "", light, false, a.layer});
    if (has_alpha)
        entries.push_back({name, std::move(alpha_a), std::move(alpha_b), "", false, true, a.layer});
}

ComparedImage* image_of(Side& side, const std::string& layer) {
    const auto found = std::ranges::find(side.images, layer, &ComparedImage::layer);
    return found == side.images.end() ? nullptr : &*found;
}

// What both have under one name, whole, or why it is no pair; `file` stands before the layers' names.
void add_layer(const std::string& file, const std::string& layer, Side& a, Side& b, std::ostream& warnings,
               std::vector<DifferenceEntry>& entries) {
    ComparedImage* const of_a = image_of(a, layer);
    ComparedImage* const of_b = image_of(b, layer);
    const std::string name = file.empty() || layer.empty() ? file + layer : file + ", " + layer;
    if (of_a != nullptr && of_b != nullptr) match_greys(*of_a, *of_b);
    if (of_a != nullptr && of_b != nullptr && same_shape(*of_a, *of_b)) {
        const auto path = [&](const Side& side) { return file.empty() ? side.path : side.path / file; };
        add_pair(name, path(a), std::move(*of_a), path(b), std::move(*of_b), warnings, entries);
        return;
    }
    const std::string note =
        of_b == nullptr   ? "only in " + a.path.string()
        : of_a == nullptr ? "only in " + b.path.string()
                          : "shapes differ: " + shape_text(of_a->planes) + " and " + shape_text(of_b->planes);
    const bool light = shows_light(name, of_a != nullptr ? *of_a : *of_b);
    entries.push_back({name, of_a != nullptr ? std::move(of_a->planes) : Planes(),
                       of_b != nullptr ? std::move(of_b->planes) : Planes(), note, light, false, layer});
}

// All layers that either has, in the order of `a` and then of `b`.
void add_layers(const std::string& file, Side a, Side b, std::ostream& warnings,
                std::vector<DifferenceEntry>& entries) {
    // Files of one image each: they are a pair whatever their one layer is called.
    if (!file.empty() && a.images.size() <= 1 && b.images.size() <= 1) {
        for (Side* side : {&a, &b}) {
            for (ComparedImage& image : side->images) image.layer.clear();
        }
    }
    std::vector<std::string> layers;
    for (const Side* side : {&a, &b}) {
        for (const ComparedImage& image : side->images) {
            if (std::ranges::find(layers, image.layer) == layers.end()) layers.push_back(image.layer);
        }
    }
    for (const std::string& layer : layers) add_layer(file, layer, a, b, warnings, entries);
}

std::string layer_names(const Side& side) {
    std::string names;
    for (const ComparedImage& image : side.images) names += (names.empty() ? "" : ", ") + image.layer;
    return names;
}

// Two files of one image each.
std::vector<DifferenceEntry> only_pair(Side a, Side b, std::ostream& warnings) {
    ComparedImage &of_a = a.images[0], &of_b = b.images[0];
    match_greys(of_a, of_b);
    if (!same_shape(of_a, of_b)) {
        throw InputError(b.path.string() + ": of another shape than " + a.path.string() + " (" +
                         shape_text(of_b.planes) + " and " + shape_text(of_a.planes) +
                         ", width x height x components); compare images of one shape");
    }
    // The file's name says which image it is, whatever its one layer is called.
    of_a.layer.clear();
    std::vector<DifferenceEntry> entries;
    add_pair(a.path.filename().string(), a.path, std::move(of_a), b.path, std::move(of_b), warnings, entries);
    for (DifferenceEntry& entry : entries)
        entry.note = "A is " + a.path.string() + ", B is " + b.path.string() + ".";
    return entries;
}

std::vector<DifferenceEntry> file_entries(const fs::path& path_a, const fs::path& path_b,
                                          std::ostream& warnings) {
    Side a{path_a, compared_images(path_a, warnings)}, b{path_b, compared_images(path_b, warnings)};
    if (a.images.size() == 1 && b.images.size() == 1) return only_pair(std::move(a), std::move(b), warnings);
    for (const auto& [layered, other] : {std::pair(&a, &b), {&b, &a}}) {
        if (is_layered_kind(other->path)) continue;
        throw InputError(layered->path.string() + ": holds several layers (" + layer_names(*layered) +
                         "), but " + other->path.string() +
                         " is one image; compare it with an .exr or a directory");
    }
    std::vector<DifferenceEntry> entries;
    add_layers("", std::move(a), std::move(b), warnings, entries);
    return entries;
}

// Of a directory, what the layers of an EXR may be compared with: each image under its name without the ending, the .npy
// where there are several.
Side images_by_name(const fs::path& directory, std::ostream& warnings) {
    Side side{directory, {}};
    const std::vector<std::string> names = image_names(directory);
    for (const std::string& name : names) {
        const fs::path npy = fs::path(name).replace_extension(".npy");
        const bool better = name != npy && std::ranges::binary_search(names, npy.string());
        if (better || is_layered_kind(name)) continue;
        side.images.push_back(std::move(compared_images(directory / name, warnings)[0]));
        side.images.back().layer = fs::path(name).stem().string();
    }
    return side;
}

// Of all names that either directory has.
std::set<std::string> paired_names(const std::vector<std::string>& in_a, const std::vector<std::string>& in_b,
                                   std::ostream& warnings) {
    std::set<std::string> names(in_a.begin(), in_a.end());
    names.insert(in_b.begin(), in_b.end());
    const auto holds = [](const std::vector<std::string>& all, const std::string& name) {
        return std::ranges::binary_search(all, name);
    };
    const std::size_t left_out = std::erase_if(names, [&](const std::string& name) {
        const std::string npy = fs::path(name).replace_extension(".npy").string();
        return name != npy && holds(in_a, npy) && holds(in_b, npy);
    });
    if (left_out > 0)
        warnings << "note: " << left_out << (left_out == 1 ? " picture is" : " pictures are")
                 << " not compared: both directories have a .npy of the same name\n";
    return names;
}

std::vector<DifferenceEntry> directory_entries(const fs::path& a, const fs::path& b, std::ostream& warnings) {
    const std::vector<std::string> in_a = image_names(a), in_b = image_names(b);
    if (in_a.empty() && in_b.empty()) {
        throw InputError(a.string() + ": neither it nor " + b.string() + " holds " + kComparedKinds +
                         "; give two directories that do");
    }
    std::vector<DifferenceEntry> entries;
    for (const std::string& name : paired_names(in_a, in_b, warnings)) {
        const auto side = [&](const fs::path& directory, const std::vector<std::string>& names) {
            const bool has = std::ranges::binary_search(names, name);
            return Side{directory,
                        has ? compared_images(directory / name, warnings) : std::vector<ComparedImage>()};
        };
        try {
            add_layers(name, side(a, in_a), side(b, in_b), warnings, entries);
        } catch (const InputError& error) {
            entries.push_back({.name = name, .a = {}, .b = {}, .note = error.what(), .unread = true});
        }
    }
    return entries;
}

}  // namespace

std::vector<std::string> image_names(const fs::path& directory) {
    std::vector<std::string> names;
    std::error_code error;
    fs::directory_iterator entries(directory, error);
    if (error)
        throw InputError(directory.string() + ": cannot be read (" + error.message() + "); check the name");
    for (const fs::directory_entry& entry : entries) {
        if (is_compared_kind(entry.path())) names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::vector<DifferenceEntry> compared_entries(const fs::path& a, const fs::path& b, std::ostream& warnings) {
    std::error_code ignored;
    const bool a_is_directory = fs::is_directory(a, ignored), b_is_directory = fs::is_directory(b, ignored);
    if (a_is_directory && b_is_directory) return directory_entries(a, b, warnings);
    if (!a_is_directory && !b_is_directory) return file_entries(a, b, warnings);
    const fs::path &directory = a_is_directory ? a : b, &file = a_is_directory ? b : a;
    if (!fs::exists(file, ignored))
        throw InputError(file.string() + ": there is no such file or directory; check the name");
    if (!is_layered_kind(file)) {
        throw InputError(directory.string() + ": a directory, but " + file.string() +
                         " is none; give two files, two directories, or an .exr and a directory");
    }
    Side layers{file, compared_images(file, warnings)}, images = images_by_name(directory, warnings);
    std::vector<DifferenceEntry> entries;
    add_layers("", a_is_directory ? std::move(images) : std::move(layers),
               a_is_directory ? std::move(layers) : std::move(images), warnings, entries);
    return entries;
}

}  // namespace crevice
