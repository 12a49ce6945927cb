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

Planes read_image(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".npy") return read_npy(path);
    if (extension == ".png") return planes_of(read_png8(path));
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

DifferenceEntry file_entry(const CompareOptions& options) {
    DifferenceEntry entry{options.a.filename().string(), read_image(options.a), read_image(options.b), "",
                          false};
    entry.linear_light = entry.name == "lit.npy";
    if (entry.a.size() != entry.b.size() || !(entry.a[0].size == entry.b[0].size)) {
        throw InputError(options.b.string() + ": of another shape than " + options.a.string() + " (" +
                         shape_text(entry.b) + " and " + shape_text(entry.a) +
                         ", width x height x components); compare images of one shape");
    }
    entry.note = "A is " + options.a.string() + ", B is " + options.b.string() + ".";
    return entry;
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
    std::vector<DifferenceEntry> entries;
    if (directories) {
        entries = directory_entries(options);
    } else {
        entries.push_back(file_entry(options));
    }
    long long differing = 0;
    for (const DifferenceEntry& entry : entries) {
        const bool comparable = !directories || entry.note.empty();
        if (!comparable) report << entry.name << ": " << entry.note << "\n";
        const std::string stem = directories ? fs::path(entry.name).stem().string() + "_error" : "error";
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
