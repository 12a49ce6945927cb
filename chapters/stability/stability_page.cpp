#include "chapters/stability/stability_page.h"

#include "chapters/notebook/html.h"
#include "chapters/notebook/report_page.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

constexpr const char* kColours[] = {"#7cc47f", "#c8e6c9", "#ffe082", "#ef7f78"};

std::string anchor_of(const StabilityCell& cell) {
    return std::string(cell.method->name) + "-" + cell.stiff->name;
}

std::string legend() {
    static constexpr const char* kMeanings[] = {
        "the answer to the last bit", "within 0.01 of the stated answer",
        "further off, and the frame says so", "further off in silence, or no number in [0,1]"};
    std::string html = "<p>";
    for (std::size_t i = 0; i < std::size(kColours); ++i)
        html += std::string("<span style=\"background:") + kColours[i] + "\">&emsp;</span> " +
                word_of(static_cast<StabilityVerdict>(i)) + ": " + kMeanings[i] + ".&emsp;";
    return html + "</p>\n";
}

// Cells come case by case, in each the methods in the table's order.
std::string heat_map(const std::vector<StabilityCell>& cells) {
    std::string html = "<table>\n<tr><th></th>";
    for (const StabilityCell& cell : cells) {
        if (cell.stiff != cells.front().stiff) break;
        html += std::string("<th>") + cell.method->name + "</th>";
    }
    const StiffCase* row = nullptr;
    for (const StabilityCell& cell : cells) {
        if (cell.stiff != row) {
            html += "</tr>\n<tr><td title=\"" + escape_html(cell.stiff->question) + "\">" +
                    escape_html(cell.stiff->name) + "</td>";
        }
        row = cell.stiff;
        html += std::string("<td style=\"background:") + kColours[static_cast<std::size_t>(cell.verdict)] +
                "\"><a href=\"#" + anchor_of(cell) + "\" title=\"" + word_of(cell.verdict) + "\">" +
                significant_text(cell.measured, 2) + "</a></td>";
    }
    return html + "</tr>\n</table>\n";
}

std::string detail(const StabilityCell& cell) {
    std::string html = "<h3 id=\"" + anchor_of(cell) + "\">" + cell.method->name + ", " +
                       escape_html(cell.stiff->name) + ": " + word_of(cell.verdict) + "</h3>\n<p>" +
                       escape_html(cell.stiff->question) +
                       ". Measured: " + significant_text(cell.measured, 3) + ".";
    if (!cell.warning.empty()) html += " The frame says: " + escape_html(cell.warning) + ".";
    return html + "</p>\n<pre>" + escape_html(command_of(cell)) + "</pre>\n" +
           image_element(png_bytes(cell.ao.size, cell.ao.channels, cell.ao.pixels), cell.ao.size,
                         std::string(cell.method->name) + ", raw AO");
}

}  // namespace

std::string command_of(const StabilityCell& cell) {
    return std::string("crevice stability --case ") + cell.stiff->name + " --ao " + cell.method->name;
}

std::string stability_page(const BenchReport& report, const std::vector<StabilityCell>& cells) {
    std::string body = "<h1>Stability: every method on stiff cases</h1>\n" + facts_element(report.facts) +
                       "<p>Each row is a case whose answer is known before it is measured: an open plane is "
                       "1, a scene in other units or "
                       "elsewhere has the same bits, nothing seen is 1. A number is how far the mean "
                       "accessibility lies below 1; where "
                       "another view must have the same bits, the largest difference. Cells lead to their "
                       "picture and command.</p>\n" +
                       legend() + heat_map(cells) + table_elements({&report.tables.front(), 1});
    for (const StabilityCell& cell : cells) body += detail(cell);
    return html_page("crevice stability", body);
}

}  // namespace crevice
