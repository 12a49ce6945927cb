#include "rasterizer/base/dead_partials.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "rasterizer/base/write_file.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

struct DeadPartial {
    std::string target;  // the name without .PID.partial
    fs::path path;
};

// The process that a partial file's name tells of, and its target; 0 for other names.
long writer_in(std::string_view name, std::string& target) {
    constexpr std::string_view kEnd = ".partial";
    if (!name.ends_with(kEnd)) return 0;
    name.remove_suffix(kEnd.size());
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return 0;
    const std::string_view digits = name.substr(dot + 1);
    long pid = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), pid);
    target = name.substr(0, dot);
    const bool whole = error == std::errc() && stop == digits.data() + digits.size() && pid > 0;
    // The name must be the one that partial_path() gives: no zeros before the number.
    return whole && std::to_string(pid) == digits ? pid : 0;
}

bool is_gone(long pid) { return kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH; }

// Its writer may be a process of another machine, or of another container, that has the number of none here.
bool is_being_written(const fs::path& path) {
    const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return true;
    struct stat status = {};
    const bool dead =
        fstat(file, &status) == 0 && S_ISREG(status.st_mode) && flock(file, LOCK_EX | LOCK_NB) == 0;
    close(file);
    return !dead;
}

std::vector<DeadPartial> dead_partials_in(const fs::path& directory) {
    std::vector<DeadPartial> found;
    std::error_code error;
    for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
         entry.increment(error)) {
        DeadPartial partial{{}, entry->path()};
        const long pid = writer_in(partial.path.filename().native(), partial.target);
        if (pid != 0 && is_gone(pid)) found.push_back(partial);
    }
    return found;
}

}  // namespace

void mark_being_written(int file_descriptor) { flock(file_descriptor, LOCK_EX | LOCK_NB); }

void remove_dead_partials(const fs::path& target) {
    static std::mutex mutex;
    static std::map<fs::path, std::vector<DeadPartial>> known;
    const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const std::lock_guard lock(mutex);
    const auto [at, is_new] = known.try_emplace(directory);
    if (is_new) at->second = dead_partials_in(directory);
    std::erase_if(at->second, [&](const DeadPartial& partial) {
        if (partial.target != target.filename()) return false;
        std::error_code ignored;
        if (!is_being_written(partial.path)) fs::remove(partial.path, ignored);
        return true;
    });
}

}  // namespace crevice
