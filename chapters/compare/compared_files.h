// What `crevice compare` is given: two images, or two directories of them, as pairs to be compared.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "chapters/compare/difference_page.h"

namespace crevice {

// .npy of floats, halves, doubles, bytes or words with one to four components, .pfm, and .png. Codes of a PNG count as
// k/255, or as k/65535 where there are 16 bits, as the file encodes them; its alpha, where either has any, is a pair of
// its own. Of two directories files of one name are a pair; a picture is left out where both have a .npy of its name. A
// file that only one has, or of another shape than its partner, makes an entry with a note that says so.
// On `warnings`: sRGB codes against linear values, doubles that no float holds.
// Throws InputError when a file cannot be read, when two files are of different kinds or shapes, and when no directory
// holds an image.
std::vector<DifferenceEntry> compared_entries(const std::filesystem::path& a, const std::filesystem::path& b,
                                              std::ostream& warnings);

// The names of the images in a directory, in order.
std::vector<std::string> image_names(const std::filesystem::path& directory);

}  // namespace crevice
