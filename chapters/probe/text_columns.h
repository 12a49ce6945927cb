// Words in columns, each as wide as its widest word.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace crevice {

inline std::string padded(const std::string& word, std::size_t width) {
    return word + std::string(width > word.size() ? width - word.size() : 1, ' ');
}

class TextColumns {
 public:
    explicit TextColumns(std::vector<std::string> headings) : rows_{std::move(headings)} {}

    // As many words as there are headings.
    void row(std::vector<std::string> words) { rows_.push_back(std::move(words)); }

    // A line a row, without spaces at its end.
    std::string text() const {
        std::string text;
        for (const std::vector<std::string>& row : rows_) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], width(i) + kGap);
            text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
        }
        return text;
    }

 private:
    static constexpr std::size_t kGap = 2;

    std::size_t width(std::size_t column) const {
        std::size_t width = 0;
        for (const std::vector<std::string>& row : rows_) width = std::max(width, row[column].size());
        return width;
    }

    std::vector<std::vector<std::string>> rows_;
};

}  // namespace crevice
