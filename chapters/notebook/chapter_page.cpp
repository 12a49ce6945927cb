#include "chapters/notebook/chapter_page.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "chapters/notebook/html.h"
#include "chapters/notebook/markdown.h"
#include "chapters/notebook/output_html.h"

namespace crevice {

namespace {

constexpr const char* kFailedChecks = "<meta name=\"failed-checks\" content=\"";

// Longer code than this is folded: it would tear the text apart.
constexpr auto kShownLines = 8;

std::string code_html(const SourceCell& cell, const std::string& file) {
    const bool folded = cell.kind == SourceCell::Kind::setup ||
                        std::count(cell.text.begin(), cell.text.end(), '\n') >= kShownLines;
    return std::string("<details class=\"code\"") + (folded ? ">" : " open>") + "<summary><code>" +
           escape_html(file) + ":" + std::to_string(cell.first_line) + "</code></summary>\n" +
           numbered_code(cell.text, cell.first_line) + "</details>\n";
}

std::string cell_html(const NotebookCell& cell, const std::string& file) {
    std::string html = "<section id=\"" + escape_html(cell.source.name) + "\">\n";
    if (cell.source.kind == SourceCell::Kind::prose) {
        html += prose_html(cell.prose);
    } else {
        html += code_html(cell.source, file);
        for (const Output& output : cell.outputs) html += output_html(output);
    }
    return html + "</section>\n";
}

// Links to the chapters before and after.
std::string neighbours_html(const std::string& name, const std::vector<BookEntry>& chapters) {
    std::string html = "<p class=\"next\">";
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        if (chapters[i].name != name) continue;
        const auto link = [&](std::size_t to, const char* before, const char* after) {
            const BookEntry& chapter = chapters[to];
            return "<a href=\"" + escape_html(chapter.name) + ".html\">" + before +
                   bilingual_html({escape_html(chapter.title.en), escape_html(chapter.title.zh)}, true) +
                   after + "</a>";
        };
        html += i > 0 ? link(i - 1, "← ", "") : "<span></span>";
        html += i + 1 < chapters.size() ? link(i + 1, "", " →") : "<span></span>";
    }
    return html + "</p>\n";
}

}  // namespace

std::string chapter_page(const ChapterPage& page, const std::vector<NotebookCell>& cells,
                         const std::vector<BookEntry>& chapters, BookLanguage language) {
    std::string body = "<div class=\"with-contents\">\n" + contents_html(chapters, page.name) + "<main>\n";
    // What the first lines of a source set up stands below the title of its page.
    const auto title = std::find_if(cells.begin(), cells.end(), [](const NotebookCell& cell) {
        return cell.source.kind == SourceCell::Kind::prose;
    });
    if (title != cells.end()) body += cell_html(*title, page.file);
    for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
        if (cell != title) body += cell_html(*cell, page.file);
    }
    body += neighbours_html(page.name, chapters) + "</main></div>\n";
    PageParts parts;
    parts.head = kFailedChecks + std::to_string(page.failed_checks) + "\">\n";
    parts.script = true;
    parts.mathematics = body.find("<x-equation") != body.npos;
    parts.code = body.find("language-cpp") != body.npos;
    parts.language = language == BookLanguage::zh ? "zh" : "en";
    return html_page(page.title.in(language) + " · Crevice", body, parts);
}

int failed_checks_in(const std::string& page) {
    const std::size_t at = page.find(kFailedChecks);
    return at == page.npos ? -1 : std::atoi(page.c_str() + at + std::strlen(kFailedChecks));
}

}  // namespace crevice
