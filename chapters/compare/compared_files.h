// What `crevice compare` is given: two images, or two directories of them, as pairs to be compared.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "chapters/compare/difference_page.h"

namespace crevice {

// Two files of one image each are a pair, whatever their kinds (compared_image.h); so are the layers of one name of two
// EXRs, a layer of an EXR and the image of its name in a directory, and the files of one name of two directories. A picture
// is left out where both directories have a .npy of its name, and where a directory has a .npy of a layer's name. Alpha,
// where either has any, is a pair of its own. Grey pictures (PNG, TIFF) are a pair even if one stores
// three equal components. Of more than one pair, what only one side has, or of another shape, makes an
// entry with a note that says so.
// On `warnings`: sRGB codes against linear values, doubles that no float holds.
// Throws InputError when a file cannot be read (of two directories that one becomes an entry with a note), when two files
// are of different shapes, and when no directory holds an image.
std::vector<DifferenceEntry> compared_entries(const std::filesystem::path& a, const std::filesystem::path& b,
                                              std::ostream& warnings);

// The names of the images in a directory, in order.
std::vector<std::string> image_names(const std::filesystem::path& directory);

}  // namespace crevice
