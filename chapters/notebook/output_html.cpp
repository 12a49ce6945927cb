#include "chapters/notebook/output_html.h"

#include <algorithm>

#include "chapters/notebook/book_contents.h"
#include "chapters/notebook/html.h"
#include "chapters/notebook/markdown.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

std::string captioned(const std::string& tag, const std::string& classes, const BookText& caption) {
    if (caption.empty()) return "";
    return "<" + tag + (classes.empty() ? "" : " class=\"" + classes + "\"") + ">" + prose_html(caption) +
           "</" + tag + ">\n";
}

// What a click enlarges; its values wait in a script element that is no script until the pointer asks for them.
std::string picture_html(const NotebookPicture& shown) {
    const Size size = shown.picture.size;
    std::string html = "<div class=\"picture\" data-name=\"" + escape_html(shown.name) + "\" data-width=\"" +
                       std::to_string(size.width) + "\" data-height=\"" + std::to_string(size.height) +
                       "\"><button class=\"canvas\" aria-label=\"enlarge " + escape_html(shown.name) + "\">" +
                       image_element(shown.png, size, shown.name) + "</button>";
    if (!shown.picture.values.empty())
        html += "<script type=\"text/plain\" class=\"values\">" + base64(values_png(shown.picture.values)) +
                "</script>";
    return html;
}

std::string lab_link(const std::string& command) {
    if (command.empty()) return "";
    return " · <a class=\"lab\" href=\"" + escape_html(lab_address(command)) + "\" title=\"" +
           escape_html(command) + "\">" + plain_html({"in the lab", "在实验台中"}) + "</a>";
}

std::string about_html(const NotebookPicture& shown) {
    return captioned("div", "caption", shown.caption) + "<p class=\"about\"><b>" + escape_html(shown.name) +
           "</b> " + size_text(shown.picture.size) + " · " + plain_html(shown.about) +
           lab_link(shown.command) + "</p>";
}

std::string pair_html(const PictureOutput& output) {
    std::string html = "<figure class=\"with-pair\">\n<div class=\"pair\">";
    for (const NotebookPicture& shown : output.pictures) html += picture_html(shown) + "</div>";
    html +=
        "</div>\n<div class=\"pair-tools\"><button class=\"ab\" aria-label=\"change sides\">A | B</button>"
        "<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"how much of the first picture "
        "is "
        "shown\"></div>\n<div class=\"sides\">";
    for (const NotebookPicture& shown : output.pictures) html += "<div>" + about_html(shown) + "</div>";
    return html + "</div>\n" + captioned("figcaption", "", output.caption) + "</figure>\n";
}

std::string html_of(const PictureOutput& output) {
    if (output.layout == PictureOutput::Layout::pair) return pair_html(output);
    std::string html = "<figure>\n<div class=\"pictures";
    html += output.pictures.size() > 1 ? " row\">\n" : "\">\n";
    for (const NotebookPicture& shown : output.pictures)
        html += picture_html(shown) + about_html(shown) + "</div>\n";
    return html + "</div>\n" + captioned("figcaption", "", output.caption) + "</figure>\n";
}

// Closed at first: nothing moves before the reader wants it to.
std::string html_of(const FilmOutput& film) {
    const std::string count = std::to_string(film.frames),
                      kilobytes = std::to_string((film.webp.size() + 999) / 1000) + " kB";
    const BookText play = {"Play the film: " + count + " frames, " + kilobytes,
                           "播放影片：" + count + " 帧，" + kilobytes};
    return "<figure>\n<details class=\"film\"><summary>" + plain_html(play) + "</summary>\n" +
           image_element(film.webp, film.size, film.name, "", "image/webp") + "</details>\n" +
           captioned("figcaption", "", film.caption) + "</figure>\n";
}

std::string html_of(const DrawingOutput& output) {
    return "<figure>\n<div class=\"scroll\">" + bilingual_html(output.svg, false) + "</div>\n" +
           captioned("figcaption", "", output.caption) + "</figure>\n";
}

std::string html_of(const TableOutput& table) {
    const auto line = [&table](const std::vector<BookText>& row, const std::string& tag) {
        std::string html = "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const char* open = is_numeric_column(table, c) ? " class=\"number\">" : ">";
            html += "<" + tag + open + plain_html(row[c]) + "</" + tag + ">";
        }
        return html + "</tr>\n";
    };
    std::string html =
        "<figure>\n<div class=\"scroll\"><table>\n<thead>" + line(table.header, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) html += line(row, "td");
    return html + "</tbody>\n</table></div>\n" + captioned("figcaption", "", table.caption) + "</figure>\n";
}

std::string html_of(const CheckOutput& check) {
    std::string html = check.ok ? "<div class=\"check\"><span class=\"good\">✓</span>"
                                : "<div class=\"check bad-check\"><span class=\"bad\">✗</span>";
    html += prose_html(check.claim);
    if (!check.detail.empty()) html += " <span class=\"detail\">(" + escape_html(check.detail) + ")</span>";
    return html + "</div>\n";
}

std::string html_of(const ListingOutput& output) {
    const CodeListing& listing = output.listing;
    return "<figure class=\"listing\">\n<figcaption><code>" + escape_html(listing.file) + ":" +
           std::to_string(listing.first_line) + "</code></figcaption>\n" +
           numbered_code(listing.code, listing.first_line) + captioned("div", "caption", output.caption) +
           "</figure>\n";
}

std::string html_of(const TranscriptOutput& output) {
    std::string lines;
    for (const TranscriptLine& line : lines_of(output)) {
        const std::string text = escape_html(line.text);
        lines += (line.typed ? "<b>" + text + "</b>" : text) + "\n";
    }
    return "<figure class=\"transcript\">\n<pre>" + lines + "</pre>\n" +
           captioned("figcaption", "", output.caption) + "</figure>\n";
}

}  // namespace

std::string prose_html(const BookText& markdown) {
    return bilingual_html(
        {html_from_markdown(markdown.en), markdown.zh.empty() ? "" : html_from_markdown(markdown.zh)}, false);
}

std::string output_html(const Output& output) {
    return std::visit([](const auto& known) { return html_of(known); }, output);
}

std::string numbered_code(const std::string& code, int first_line) {
    const auto lines = std::count(code.begin(), code.end(), '\n') + (code.ends_with('\n') ? 0 : 1);
    std::string numbers;
    for (long i = 0; i < lines; ++i) numbers += std::to_string(first_line + i) + "\n";
    return "<div class=\"lines\"><pre class=\"numbers\" aria-hidden=\"true\">" + numbers +
           "</pre><pre><code class=\"language-cpp\">" + escape_html(code) + "</code></pre></div>\n";
}

}  // namespace crevice
