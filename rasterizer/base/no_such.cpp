#include "rasterizer/base/no_such.h"

#include <algorithm>

namespace crevice {

namespace {

// How many slips lead from one word to the other (Damerau 1964, optimal string alignment).
std::size_t slips(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                least[i][j] = i + j;
                continue;
            }
            const std::size_t other_letter = a[i - 1] != b[j - 1] ? 1 : 0;
            least[i][j] =
                std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + other_letter});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
        }
    }
    return least[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& known) {
    constexpr std::size_t kLongest = 40, kLettersASlip = 3;
    if (word.size() > kLongest) return "";
    std::string nearest;
    std::size_t fewest = std::max<std::size_t>(1, word.size() / kLettersASlip) + 1;
    for (const std::string& name : known) {
        const std::size_t count = slips(word, name);
        // A name of as many letters as there are slips has nothing in common with the word.
        if (count < fewest && count < name.size()) {
            fewest = count;
            nearest = name;
        }
    }
    return nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(word, known);
    return nearest.empty() ? "" : "did you mean " + nearest + "? ";
}

UsageError no_such(const std::string& where, const std::string& kind, const std::string& name,
                   const std::vector<std::string>& known) {
    const std::string nearest = did_you_mean(name, known);
    std::string all;
    for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
    return UsageError(where + ": there is no such " + kind + " (" + name + "); " +
                      (nearest.empty() ? "give one of " : nearest + "There are ") + all);
}

}  // namespace crevice
