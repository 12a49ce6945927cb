#include "chapters/notebook/cells.h"

#include <algorithm>
#include <sstream>

namespace crevice {

bool is_numeric_column(const TableOutput& table, std::size_t column) {
    const auto is_number = [column](const std::vector<BookText>& row) {
        const std::string& text = row[column].en;
        const std::size_t first = text.find_first_not_of("+-.");
        const bool is_list = text.find(", ") != std::string::npos;
        return first != std::string::npos && text[first] >= '0' && text[first] <= '9' && !is_list;
    };
    return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), is_number);
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
