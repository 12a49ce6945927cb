// The files that an OBJ names: its MTL files, and their textures.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace crevice {

struct FoundFile {
    std::filesystem::path path;  // as the OBJ's own path shows it; empty: there is none that may be read
    bool outside = false;        // there is one at the place written, and it lies outside the OBJ's directory
    bool elsewhere = false;  // not at the place written, but a file of that name beside the MTL or the OBJ
};

// Finds files in the directory of the OBJ and below, also after following links, or anywhere if that is
// allowed. Names come from Windows as often as not: a backslash counts as a slash, and where no file has a
// name in its capitals, one that differs in them alone is taken. A directory is listed once, however many of its files
// are missing; a tree serves one thread at a time.
class FileTree {
 public:
    // Throws InputError when the OBJ's directory cannot be read.
    FileTree(const std::filesystem::path& obj_path, bool outside_allowed);

    // The regular file or directory `name`, seen from `base` or else from the OBJ's directory. Many files
    // have absolute paths of the machine that they were made on: where there is nothing at the place written,
    // or it may not be read, the last part of the name is looked for in both directories.
    FoundFile find(const std::string& name, const std::filesystem::path& base) const;

    // The directory of the OBJ, as its path shows it.
    const std::filesystem::path& directory() const { return directory_; }

 private:
    // Where the file at `path` stands in the OBJ's directory; nothing ("") when it may not be read.
    std::filesystem::path shown(const std::filesystem::path& path) const;

    using NamesBySmallLetters = std::map<std::string, std::filesystem::path>;

    std::filesystem::path same_but_for_capitals(const std::filesystem::path& directory,
                                                const std::filesystem::path& name) const;
    std::filesystem::path on_disk(const std::filesystem::path& path) const;

    std::filesystem::path directory_, root_;  // as it is shown; canonical
    bool outside_allowed_;
    mutable std::map<std::filesystem::path, NamesBySmallLetters>
        names_in_;  // directories that were asked for
};

}  // namespace crevice
