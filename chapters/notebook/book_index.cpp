#include "chapters/notebook/book_index.h"

#include "chapters/notebook/embedded_files.h"
#include "chapters/notebook/html.h"
#include "chapters/notebook/output_html.h"
#include "chapters/notebook/sources.h"
#include "chapters/notebook/translation.h"

namespace crevice {

std::string book_index(const std::vector<BookEntry>& chapters, BookLanguage language) {
    const BookText preface = {
        std::string(embedded_file("chapters/preface.md").value_or("")),
        chinese_lines_joined(std::string(embedded_file("chapters/zh/preface.md").value_or("")))};
    std::string body = "<div class=\"with-contents\">\n" + contents_html(chapters, "") + "<main>\n";
    body += prose_html(preface) + "<section id=\"sources\">\n" + prose_html({sources_table(), ""}) +
            "</section>\n";
    PageParts parts;
    parts.script = true;
    parts.mathematics = body.find("<x-equation") != body.npos;
    parts.language = language == BookLanguage::zh ? "zh" : "en";
    return html_page("Crevice: ambient occlusion", body + "</main></div>\n", parts);
}

}  // namespace crevice
