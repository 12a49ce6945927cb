#include "chapters/notebook/notebook_page.h"

#include "chapters/notebook/html.h"
#include "chapters/notebook/markdown.h"
#include "chapters/notebook/notebook_text.h"
#include "chapters/notebook/sources.h"

namespace crevice {

namespace {

std::string element(const std::string& tag, const std::string& html) {
    return "<" + tag + ">" + html + "</" + tag + ">";
}

std::string html_of(const TextCell& cell) {
    const std::string html = html_from_markdown(cell.markdown);
    return cell.kind == TextCell::Kind::aside ? "<aside class=\"box\">\n" + html + "</aside>\n" : html;
}

// A click enlarges a picture to the window; the check box behind it does that without a script.
std::string html_of(const NotebookPicture& picture) {
    const std::string size = std::to_string(picture.size.width) + "×" + std::to_string(picture.size.height);
    const std::string about =
        "<b>" + escape_html(picture.name) + "</b> " + size + " · " + escape_html(picture.about);
    return "<div><label class=\"zoom\"><input type=\"checkbox\" aria-label=\"enlarge " +
           escape_html(picture.name) + "\">" + image_element(picture.png, picture.size, picture.name) +
           "</label>\n<p class=\"about\">" + about + "</p></div>\n";
}

std::string html_of(const PictureCell& cell) {
    std::string html = "<figure>\n<div class=\"pictures";
    html += cell.pictures.size() > 1 ? " row\">\n" : "\">\n";
    for (const NotebookPicture& picture : cell.pictures) html += html_of(picture);
    html += "</div>\n";
    if (!cell.caption.empty()) html += element("figcaption", escape_html(cell.caption)) + "\n";
    return html + "</figure>\n";
}

std::string html_of(const TableCell& table) {
    const auto line = [&table](const std::vector<std::string>& row, const std::string& tag) {
        std::string html = "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const char* open = is_numeric_column(table, c) ? " class=\"number\">" : ">";
            html += "<" + tag + open + escape_html(row[c]) + "</" + tag + ">";
        }
        return html + "</tr>\n";
    };
    std::string html =
        "<div class=\"scroll\"><table>\n<thead>" + line(table.header, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) html += line(row, "td");
    return html + "</tbody>\n</table></div>\n";
}

std::string html_of(const CheckCell& check) {
    std::string html = check.ok ? "<div class=\"check\"><span class=\"good\">✓</span><span>"
                                : "<div class=\"check bad-check\"><span class=\"bad\">✗</span><span>";
    html += escape_html(check.claim);
    if (!check.detail.empty()) html += " <span class=\"detail\">(" + escape_html(check.detail) + ")</span>";
    return html + "</span></div>\n";
}

std::string contents(const std::vector<NotebookSection>& sections) {
    std::string html = "<nav><strong>Crevice</strong>\n<ol>\n";
    for (const NotebookSection& section : sections) {
        const std::string number = section.name.substr(0, section.name.find('_'));
        html += "<li><a href=\"#" + escape_html(section.name) + "\"><span class=\"number\">" +
                escape_html(number) + "</span><span>" + escape_html(section.title);
        if (section.failed_checks > 0)
            html += " <span class=\"bad\">✗ " + std::to_string(section.failed_checks) + "</span>";
        html += "</span></a></li>\n";
    }
    return html + "</ol></nav>\n";
}

}  // namespace

std::string html_from_cells(const std::vector<Cell>& cells) {
    std::string html;
    for (const Cell& cell : cells) {
        html += std::visit([](const auto& known) { return html_of(known); }, cell);
    }
    return html;
}

std::string notebook_page(const std::vector<NotebookSection>& sections) {
    std::string body = "<div class=\"with-contents\">\n" + contents(sections) + "<main>\n";
    body +=
        "<section id=\"sources\">\n<h2>Sources</h2>\n" + html_from_markdown(sources_table()) + "</section>\n";
    for (const NotebookSection& section : sections) {
        body += "<section id=\"" + escape_html(section.name) + "\">\n" + section.html + "</section>\n";
    }
    const std::string title =
        sections.size() == 1 ? sections[0].title + " · Crevice" : "Crevice: ambient occlusion";
    return html_page(title, body + "</main></div>\n");
}

}  // namespace crevice
