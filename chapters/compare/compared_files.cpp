#include "chapters/compare/compared_files.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <set>
#include <string>
#include <utility>

#include "chapters/compare/pfm.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/textures/image_file.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

// What a file holds, as it stands there.
struct ComparedFile {
    Planes planes;
    Image<float> alpha;  // empty: it has none
    bool linear = true;  // its values are proportional to light, or no light at all; else sRGB codes
};

constexpr std::uintmax_t kMaxFile = std::uintmax_t{1} << 34;

// In small letters, whatever the disk says.
std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

ComparedFile read_image(const fs::path& path, std::ostream& warnings) {
    const std::string extension = extension_of(path);
    if (extension == ".npy") {
        NpyImage image = read_npy_image(path);
        if (image.rounded > 0)
            warnings << "warning: " << path.string() << ": " << image.rounded
                     << " of its values are doubles that no float holds; the nearest floats are compared\n";
        return {std::move(image.planes), {}};
    }
    if (extension == ".pfm") return {planes_from_pfm(read_file(path, kMaxFile), path.string()), {}};
    if (extension == ".png") {
        ImageCodes codes = read_png(path);
        return {planes_of(std::move(codes.colour)), std::move(codes.alpha), codes.linear};
    }
    throw InputError(path.string() + ": not an image that can be compared (" + extension +
                     "); give a .npy, a .pfm or a .png");
}

bool is_image(const fs::path& path) {
    const std::string extension = extension_of(path);
    return extension == ".npy" || extension == ".pfm" || extension == ".png";
}

bool same_shape(const ComparedFile& a, const ComparedFile& b) {
    return a.planes.size() == b.planes.size() && a.planes[0].size == b.planes[0].size;
}

std::string shape_text(const Planes& planes) {
    return std::to_string(planes[0].size.width) + "x" + std::to_string(planes[0].size.height) + "x" +
           std::to_string(planes.size());
}

// Where only one has alpha, the other is opaque.
Planes alpha_of(ComparedFile& file) {
    return planes_of(file.alpha.empty() ? Image<float>(file.planes[0].size, 1.0f) : std::move(file.alpha));
}

// A pair of one shape, and their alpha if any has some.
void add_pair(const std::string& name, const fs::path& path_a, ComparedFile a, const fs::path& path_b,
              ComparedFile b, std::ostream& warnings, std::vector<DifferenceEntry>& entries) {
    if (a.linear != b.linear) {
        warnings << "warning: " << (a.linear ? path_b : path_a).string()
                 << ": its values are sRGB codes and those of " << (a.linear ? path_a : path_b).string()
                 << " linear; they are compared as they stand\n";
    }
    const bool has_alpha = !a.alpha.empty() || !b.alpha.empty();
    Planes alpha_a = has_alpha ? alpha_of(a) : Planes(), alpha_b = has_alpha ? alpha_of(b) : Planes();
    entries.push_back({name, std::move(a.planes), std::move(b.planes), "", name == "lit.npy"});
    if (has_alpha) entries.push_back({name, std::move(alpha_a), std::move(alpha_b), "", false, true});
}

std::vector<DifferenceEntry> file_entries(const fs::path& path_a, const fs::path& path_b,
                                          std::ostream& warnings) {
    ComparedFile a = read_image(path_a, warnings), b = read_image(path_b, warnings);
    if (!same_shape(a, b)) {
        throw InputError(path_b.string() + ": of another shape than " + path_a.string() + " (" +
                         shape_text(b.planes) + " and " + shape_text(a.planes) +
                         ", width x height x components); compare images of one shape");
    }
    std::vector<DifferenceEntry> entries;
    add_pair(path_a.filename().string(), path_a, std::move(a), path_b, std::move(b), warnings, entries);
    for (DifferenceEntry& entry : entries)
        entry.note = "A is " + path_a.string() + ", B is " + path_b.string() + ".";
    return entries;
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
        warnings << "note: " << left_out
                 << " pictures are not compared: both directories have a .npy of the same name\n";
    return names;
}

std::vector<DifferenceEntry> directory_entries(const fs::path& a, const fs::path& b, std::ostream& warnings) {
    const std::vector<std::string> in_a = image_names(a), in_b = image_names(b);
    if (in_a.empty() && in_b.empty()) {
        throw InputError(a.string() + ": neither it nor " + b.string() +
                         " holds a .npy, a .pfm or a .png; give two directories that do");
    }
    std::vector<DifferenceEntry> entries;
    for (const std::string& name : paired_names(in_a, in_b, warnings)) {
        const bool has_a = std::ranges::binary_search(in_a, name),
                   has_b = std::ranges::binary_search(in_b, name);
        ComparedFile of_a = has_a ? read_image(a / name, warnings) : ComparedFile(),
                     of_b = has_b ? read_image(b / name, warnings) : ComparedFile();
        if (has_a && has_b && same_shape(of_a, of_b)) {
            add_pair(name, a / name, std::move(of_a), b / name, std::move(of_b), warnings, entries);
            continue;
        }
        const std::string note =
            !has_b   ? "only in " + a.string()
            : !has_a ? "only in " + b.string()
                     : "shapes differ: " + shape_text(of_a.planes) + " and " + shape_text(of_b.planes);
        entries.push_back({name, std::move(of_a.planes), std::move(of_b.planes), note, name == "lit.npy"});
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
        if (is_image(entry.path())) names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::vector<DifferenceEntry> compared_entries(const fs::path& a, const fs::path& b, std::ostream& warnings) {
    std::error_code ignored;
    const bool directories = fs::is_directory(a, ignored);
    if (directories != fs::is_directory(b, ignored)) {
        throw InputError((directories ? a : b).string() + ": a directory, but " +
                         (directories ? b : a).string() + " is none; give two files or two directories");
    }
    return directories ? directory_entries(a, b, warnings) : file_entries(a, b, warnings);
}

}  // namespace crevice
