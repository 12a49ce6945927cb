#include "rasterizer/obj/alike_warnings.h"

#include <map>
#include <string_view>
#include <utility>

#include "rasterizer/obj/obj_report.h"

namespace crevice {
namespace {

// Where a warning's text begins: behind "path:line: ".
std::size_t begin_of_text(std::string_view warning) {
    const std::size_t colon = warning.find(": ");
    return colon == std::string_view::npos ? 0 : colon + 2;
}

// The text without its values: what is in brackets, and the names of materials. Keywords stay.
std::string kind_of(std::string_view warning) {
    constexpr std::string_view kBeforeName = "material `";
    std::string kind;
    int brackets = 0;
    bool in_name = false;
    for (const char c : warning.substr(begin_of_text(warning))) {
        if (in_name) {
            in_name = c != '`';
            continue;
        }
        if (c == '(') ++brackets;
        if (brackets == 0) kind.push_back(c);
        if (c == ')' && brackets > 0) --brackets;
        in_name = kind.ends_with(kBeforeName);
    }
    return kind;
}

struct Alike {
    std::size_t count = 0;
    std::size_t next_at = 0;  // in the result, of the first that is not said
};

}  // namespace

std::vector<std::string> few_of_each_kind(const std::vector<std::string>& warnings) {
    std::map<std::string, Alike> kinds;
    std::vector<std::string> few;
    for (const std::string& warning : warnings) {
        Alike& alike = kinds[kind_of(warning)];
        if (++alike.count > kMostAlike + 1) continue;
        if (alike.count > kMostAlike) alike.next_at = few.size();
        few.push_back(warning);
    }
    for (const auto& [kind, alike] : kinds) {
        if (alike.count <= kMostAlike + 1) continue;
        std::string& next = few[alike.next_at];
        next = next.substr(0, begin_of_text(next)) + "and " + std::to_string(alike.count - kMostAlike) +
               " more of this kind, the first of them here: " + next.substr(begin_of_text(next));
    }
    return few;
}

void add_notes(std::vector<std::string>& warnings, const std::string& path,
               const std::vector<MtlNote>& notes) {
    constexpr std::size_t kMost = 32;
    std::map<std::pair<std::string_view, std::string_view>, Tally> tallies;
    Tally others;
    for (const MtlNote& note : notes) {
        const std::pair<std::string_view, std::string_view> key(note.what, note.done);
        (tallies.contains(key) || tallies.size() < kMost ? tallies[key] : others).add(note.line);
    }
    const auto say = [&](std::string_view what, std::string_view done, const Tally& tally) {
        const std::string count =
            std::to_string(tally.count) + (tally.count == 1 ? " line" : " lines, the first here");
        warnings.push_back(path + ":" + std::to_string(tally.first_line) + ": " +
                           std::string(what).append(" (").append(count).append("); ").append(done));
    };
    for (const auto& [note, tally] : tallies) say(note.first, note.second, tally);
    if (others.count > 0) say("more statements are not drawn here", "passed over", others);
}

}  // namespace crevice
