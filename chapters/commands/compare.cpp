#include "chapters/commands/compare.h"

#include <iostream>
#include <set>
#include <string>

#include "chapters/commands/difference_page.h"
#include "chapters/notebook/picture.h"
#include "rasterizer/base/error.h"
#include "rasterizer/textures/texture.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

// What a file holds, as it stands there.
struct ComparedFile {
    Planes planes;
    Image<float> alpha;   // empty: it has none
    bool linear = false;  // its values are proportional to light, or no light at all; else sRGB codes
};

ComparedFile read_image(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".npy") return {read_npy(path), {}, true};
    if (extension == ".png") {
        ImageCodes codes = read_png(path);
        return {planes_of(std::move(codes.colour)), std::move(codes.alpha), codes.linear};
    }
    throw InputError(path.string() + ": not an image that can be compared (" + extension +
                     "); give a .npy or a .png");
}

Image3 image3_of(Planes planes) {
    Image3 image;
    image.x = std::move(planes[0]);
    image.y = std::move(planes[1]);
    image.z = std::move(planes[2]);
    return image;
}

// Writes OUT/STEM.npy and OUT/STEM.png, and says so.
void write_error_images(const Planes& a, const Planes& b, const fs::path& out, const std::string& stem,
                        std::ostream& report) {
    const fs::path npy = out / (stem + ".npy"), png = out / (stem + ".png");
    Planes difference = signed_difference(a, b);
    Picture picture;
    if (difference.size() == 1) {
        write_npy(npy, difference[0]);
        picture = difference_picture(difference[0]);
    } else {
        const Image3 image = image3_of(std::move(difference));
        write_npy(npy, image);
        picture = difference_picture(image);
    }
    write_picture(png, picture);
    report << "  " << npy.string() << ", " << png.string() << ": " << picture.mapping << "\n";
}

// Prints one pair and writes what there is to write; true when they differ.
bool compare_pair(const DifferenceEntry& pair, const fs::path& out, const std::string& stem,
                  std::ostream& report) {
    const ImageError error = compare_images(pair.a, pair.b);
    report << pair.name << ": " << (error.identical() ? "identical" : "differs") << "\n";
    for (const auto& [name, value] : error_rows(error)) {
        report << "  " << name << std::string(18 - name.size(), ' ') << value << "\n";
    }
    if (error.identical()) return false;
    write_error_images(pair.a, pair.b, out, stem, report);
    return true;
}

std::set<std::string> npy_names(const fs::path& directory) {
    std::set<std::string> names;
    std::error_code error;
    fs::directory_iterator entries(directory, error);
    if (error)
        throw InputError(directory.string() + ": cannot be read (" + error.message() + "); check the name");
    for (const fs::directory_entry& entry : entries) {
        if (entry.path().extension() == ".npy") names.insert(entry.path().filename().string());
    }
    return names;
}

std::string shape_text(const Planes& planes) {
    return std::to_string(planes[0].size.width) + "x" + std::to_string(planes[0].size.height) + "x" +
           std::to_string(planes.size());
}

// One entry a name that either directory has.
std::vector<DifferenceEntry> directory_entries(const CompareOptions& options) {
    const std::set<std::string> in_a = npy_names(options.a), in_b = npy_names(options.b);
    std::set<std::string> names = in_a;
    names.insert(in_b.begin(), in_b.end());
    if (names.empty()) {
        throw InputError(options.a.string() + ": neither it nor " + options.b.string() +
                         " holds a .npy file; give two directories that do");
    }
    std::vector<DifferenceEntry> entries;
    for (const std::string& name : names) {
        DifferenceEntry entry;
        entry.name = name;
        entry.linear_light = name == "lit.npy";
        if (in_a.contains(name)) entry.a = read_npy(options.a / name);
        if (in_b.contains(name)) entry.b = read_npy(options.b / name);
        if (entry.a.empty() || entry.b.empty()) {
            entry.note = "only in " + (entry.a.empty() ? options.b : options.a).string();
        } else if (entry.a.size() != entry.b.size() || !(entry.a[0].size == entry.b[0].size)) {
            entry.note = "shapes differ: " + shape_text(entry.a) + " and " + shape_text(entry.b);
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

// Where only one has alpha, the other is opaque.
Image<float> alpha_of(ComparedFile& file) {
    return file.alpha.empty() ? Image<float>(file.planes[0].size, 1.0f) : std::move(file.alpha);
}

// The two files, and their alpha if any has some.
std::vector<DifferenceEntry> file_entries(const CompareOptions& options) {
    ComparedFile a = read_image(options.a), b = read_image(options.b);
    if (a.planes.size() != b.planes.size() || !(a.planes[0].size == b.planes[0].size)) {
        throw InputError(options.b.string() + ": of another shape than " + options.a.string() + " (" +
                         shape_text(b.planes) + " and " + shape_text(a.planes) +
                         ", width x height x components); compare images of one shape");
    }
    if (a.linear != b.linear) {
        std::cerr << (a.linear ? options.b : options.a).string()
                  << ": its values are sRGB codes and those of "
                  << (a.linear ? options.a : options.b).string()
                  << " linear; they are compared as they stand\n";
    }
    std::vector<DifferenceEntry> entries;
    const std::string name = options.a.filename().string();
    const auto add = [&](const std::string& what, Planes of_a, Planes of_b) {
        entries.push_back({what, std::move(of_a), std::move(of_b),
                           "A is " + options.a.string() + ", B is " + options.b.string() + ".",
                           what == "lit.npy"});
    };
    const bool alpha = !a.alpha.empty() || !b.alpha.empty();
    Image<float> alpha_a = alpha ? alpha_of(a) : Image<float>(),
                 alpha_b = alpha ? alpha_of(b) : Image<float>();
    add(name, std::move(a.planes), std::move(b.planes));
    if (alpha) add(name + ", alpha", planes_of(std::move(alpha_a)), planes_of(std::move(alpha_b)));
    return entries;
}

}  // namespace

int compare_files(const CompareOptions& options, std::ostream& report) {
    std::error_code ignored;
    const bool directories = fs::is_directory(options.a, ignored);
    if (directories != fs::is_directory(options.b, ignored)) {
        throw InputError((directories ? options.a : options.b).string() + ": a directory, but " +
                         (directories ? options.b : options.a).string() +
                         " is none; give two files or two directories");
    }
    const std::vector<DifferenceEntry> entries =
        directories ? directory_entries(options) : file_entries(options);
    long long differing = 0;
    for (const DifferenceEntry& entry : entries) {
        const bool comparable = !directories || entry.note.empty();
        if (!comparable) report << entry.name << ": " << entry.note << "\n";
        const std::string of_file = &entry == &entries.front() ? "error" : "error_alpha";
        const std::string stem = directories ? fs::path(entry.name).stem().string() + "_error" : of_file;
        differing += !comparable || compare_pair(entry, options.out, stem, report);
    }
    if (directories) report << differing << " of " << entries.size() << " differ\n";
    if (options.html) {
        write_file_atomically(*options.html, difference_page(entries));
        report << options.html->string() << "\n";
    }
    return static_cast<int>(differing > 0 ? ExitCode::check_failed : ExitCode::done);
}

}  // namespace crevice
