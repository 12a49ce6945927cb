#include "rasterizer/obj/file_tree.h"

#include <algorithm>
#include <system_error>

#include "rasterizer/base/error.h"
#include "rasterizer/obj/obj_lines.h"

namespace crevice {

namespace fs = std::filesystem;

FileTree::FileTree(const fs::path& obj_path, bool outside_allowed)
    : directory_(obj_path.parent_path()), outside_allowed_(outside_allowed) {
    std::error_code error;
    root_ = fs::canonical(directory_.empty() ? fs::path(".") : directory_, error);
    if (error) throw InputError(obj_path.string() + ": its directory cannot be read; check the path");
}

// The file in `directory` whose name is `name` but for capitals, or nothing (""). Of several the first in the
// alphabet, so that the order of the directory does not matter.
fs::path FileTree::same_but_for_capitals(const fs::path& directory, const fs::path& name) const {
    const auto [listed, is_new] = names_in_.try_emplace(directory);
    NamesBySmallLetters& names = listed->second;
    std::error_code error;
    fs::directory_iterator at;
    if (is_new) at = fs::directory_iterator(directory.empty() ? "." : directory, error);
    for (const fs::directory_iterator end; !error && at != end; at.increment(error)) {
        const fs::path candidate = at->path().filename();
        const auto [same, is_first] = names.try_emplace(lower_case(candidate.string()), candidate);
        if (!is_first) same->second = std::min(same->second, candidate);
    }
    const auto found = names.find(lower_case(name.string()));
    return found == names.end() ? fs::path() : directory / found->second;
}

// `path` as it stands on the disk, canonical; nothing ("") where there is no such file.
fs::path FileTree::on_disk(const fs::path& path) const {
    std::error_code error;
    const fs::path plain = fs::canonical(path, error);
    if (!error) return plain;
    fs::path found;
    for (const fs::path& part : path) {
        const fs::path next = found / part;
        found = fs::exists(next, error) ? next : same_but_for_capitals(found, part);
        if (found.empty()) return {};
    }
    const fs::path canonical = fs::canonical(found, error);
    return error ? fs::path() : canonical;
}

fs::path FileTree::shown(const fs::path& path) const {
    const fs::path below = path.lexically_relative(root_);
    const bool inside = !below.empty() && *below.begin() != "..";
    if (inside) return directory_ / below;
    return outside_allowed_ ? path : fs::path();
}

FoundFile FileTree::find(const std::string& name, const fs::path& base) const {
    std::string slashed = name;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path written(slashed), last = written.filename();
    FoundFile found;
    if (last.empty()) return found;
    for (const fs::path& directory : {base, directory_}) {
        const fs::path path = on_disk(directory / written);
        if (path.empty()) continue;
        found.path = shown(path);
        if (!found.path.empty()) return found;
        found.outside = true;
    }
    for (const fs::path& directory : {base, directory_}) {
        const fs::path path = on_disk(directory / last);
        if (path.empty()) continue;
        found.path = shown(path);
        found.elsewhere = !found.path.empty();
        if (found.elsewhere) return found;
    }
    return found;
}

}  // namespace crevice
