#include "chapters/notebook/cells.h"

#include <sstream>

namespace crevice {

bool is_numeric_column(const TableOutput& table, std::size_t column) {
    bool any = false;
    for (const std::vector<BookText>& row : table.rows) {
        const std::string& text = row[column].en;
        if (text.empty()) continue;
        const std::size_t first = text.find_first_not_of("+-.");
        const bool is_list = text.find(", ") != std::string::npos;
        if (first == std::string::npos || text[first] < '0' || text[first] > '9' || is_list) return false;
        any = true;
    }
    return any;
}

std::vector<TranscriptLine> lines_of(const TranscriptOutput& transcript) {
    std::vector<TranscriptLine> lines;
    std::istringstream stream(transcript.text);
    bool goes_on = false;
    for (std::string text; std::getline(stream, text);) {
        const bool typed = goes_on || text.starts_with("$ ") || text.starts_with("(gdb) ");
        goes_on = typed && text.ends_with('\\');
        lines.push_back({text, typed});
    }
    return lines;
}

}  // namespace crevice
