#include "rasterizer/obj/text_pieces.h"

#include <algorithm>
#include <cstdint>

#include "rasterizer/base/parallel.h"

namespace crevice {
namespace {

// The first place behind `from` at which a logical line begins for certain: behind the end of a line without a
// backslash at its end. The end of the text where there is none.
std::size_t next_line_start(std::string_view text, std::size_t from) {
    while (true) {
        const std::size_t end = text.find_first_of("\r\n", from);
        if (end == std::string_view::npos) return text.size();
        const bool behind_return = text[end] == '\n' && end > 0 && text[end - 1] == '\r';
        const std::size_t stop = behind_return ? end - 1 : end;
        from = end + 1;
        if (text[end] == '\r' && from < text.size() && text[from] == '\n') ++from;
        if (stop == 0 || text[stop - 1] != '\\') return from;
    }
}

std::size_t line_ends(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        ++count;
    for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
        const bool ends_with_line_feed = at + 1 < text.size() && text[at + 1] == '\n';
        if (!ends_with_line_feed) ++count;
    }
    return count;
}

}  // namespace

std::vector<TextPiece> text_pieces(std::string_view text, std::size_t piece_bytes, const Run& run) {
    std::vector<TextPiece> pieces;
    do {
        const std::size_t length =
            text.size() <= piece_bytes ? text.size() : next_line_start(text, piece_bytes);
        pieces.push_back({text.substr(0, length)});
        text.remove_prefix(length);
    } while (!text.empty());
    std::vector<std::size_t> lines(pieces.size());
    parallel_for(static_cast<int>(pieces.size()), run, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        lines[at] = line_ends(pieces[at].text);
    });
    for (std::size_t i = 1; i < pieces.size(); ++i)
        pieces[i].first_line = pieces[i - 1].first_line + lines[i - 1];
    return pieces;
}

}  // namespace crevice
