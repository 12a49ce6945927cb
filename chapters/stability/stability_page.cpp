#include "chapters/stability/stability_page.h"

#include "chapters/notebook/html.h"
#include "chapters/notebook/report_page.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

// The colours of verdicts are light on dark pages too, so that their text is always dark.
constexpr const char* kStyle = R"css(<style>
main { max-width: 76rem; }
.exact { background: #7cc47f; } .within { background: #c8e6c9; } .warned { background: #ffe082; }
.wrong { background: #ef7f78; }
.exact, .within, .warned, .wrong, .map a { color: #1f2328; }
.key span { padding: .1rem .6rem; border-radius: 4px; }
.key p { margin: .4rem 0; }
.map th, .map td { padding: .15rem .4rem; white-space: nowrap; }
.map td { border: 1px solid var(--paper); text-align: right; }
.map td a { text-decoration: none; display: block; }
.map td:first-child { position: sticky; left: 0; background: var(--paper); text-align: left; }
.map td:first-child a { color: var(--accent); }
.map tr:first-child th { writing-mode: vertical-rl; transform: rotate(180deg); text-align: left; }
.cells { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; }
.cells figure { margin: 0; } .cells img { width: 100% !important; }
.cells figure:target { outline: 3px solid var(--accent); outline-offset: 4px; border-radius: 4px; }
.cells figcaption { font-size: .85rem; } .cells figcaption span { padding: 0 .4rem; border-radius: 4px; }
.cells pre { white-space: pre-wrap; padding: .5rem .7rem; margin: .4rem 0 0; }
@media (max-width: 40rem) { main { padding: 1.2rem .8rem 4rem; }
  .map td:first-child { white-space: normal; min-width: 7.5rem; max-width: 7.5rem; } }
</style>
)css";

std::string anchor_of(const StabilityCell& cell) {
    return std::string(cell.method->name) + "-" + cell.stiff->name;
}

std::string legend() {
    static constexpr const char* kMeanings[] = {
        "the stated answer to the last bit, or refused where that is the answer", "within what is stated",
        "further off or surfaces missing, and the frame says so; or refused in one line",
        "further off in silence, surfaces missing, or no number in [0,1]"};
    std::string html = "<div class=\"key\">\n";
    for (std::size_t i = 0; i < std::size(kMeanings); ++i) {
        const std::string word = word_of(static_cast<StabilityVerdict>(i));
        html += "<p><span class=\"" + word + "\">" + word + "</span> " + kMeanings[i] + "</p>\n";
    }
    return html + "</div>\n";
}

// Narrow pages break a name after its underscores.
std::string breakable(const std::string& name) {
    std::string html;
    for (const char c : name) html += c == '_' ? "_<wbr>" : escape_html({&c, 1});
    return html;
}

std::string shown_number(const StabilityCell& cell) {
    if (cell.ao.size.width == 0) return "refused";
    return cell.stiff->answer == Answer::in_range ? "in range" : significant_text(cell.measured, 2);
}

// Cells come case by case, in each the methods in the table's order.
std::string heat_map(const std::vector<StabilityCell>& cells) {
    std::string html = "<div class=\"scroll\">\n<table class=\"map\">\n<tr><th></th>";
    for (const StabilityCell& cell : cells) {
        if (cell.stiff != cells.front().stiff) break;
        html += std::string("<th>") + cell.method->name + "</th>";
    }
    const StiffCase* row = nullptr;
    for (const StabilityCell& cell : cells) {
        const std::string name = escape_html(cell.stiff->name);
        if (cell.stiff != row) {
            html += "</tr>\n<tr><td title=\"" + escape_html(cell.stiff->question) + "\"><a href=\"#" + name +
                    "\">" + breakable(cell.stiff->name) + "</a></td>";
        }
        row = cell.stiff;
        const std::string verdict = word_of(cell.verdict);
        html += "<td class=\"" + verdict + "\"><a href=\"#" + escape_html(anchor_of(cell)) + "\" title=\"" +
                cell.method->name + ", " + name + ": " + verdict + "\">" + shown_number(cell) + "</a></td>";
    }
    return html + "</tr>\n</table>\n</div>\n";
}

std::string measured_text(const StabilityCell& cell) {
    if (cell.ao.size.width == 0) return "No map.";
    const std::string off = significant_text(cell.measured, 3);
    const bool exact = cell.measured == 0;
    std::string text;
    switch (cell.stiff->answer) {
        case Answer::open: text = exact ? "all open" : off + " below 1 on the mean"; break;
        case Answer::same: text = exact ? "the same bits" : "differs by up to " + off; break;
        case Answer::background: text = exact ? "1 everywhere" : "up to " + off + " below 1"; break;
        case Answer::in_range:
        case Answer::refused: text = "a map was made"; break;
    }
    if (cell.stiff->covered) text += "; " + percent_text(cell.covered) + " of the picture covered";
    return "Measured: " + text + ".";
}

std::string detail(const StabilityCell& cell) {
    const std::string verdict = word_of(cell.verdict);
    std::string html = "<figure id=\"" + escape_html(anchor_of(cell)) + "\">\n";
    if (cell.ao.size.width > 0)
        html += image_element(png_bytes(cell.ao.size, cell.ao.channels, cell.ao.pixels), cell.ao.size,
                              std::string(cell.method->name) + ", raw AO");
    html += std::string("<figcaption><b>") + cell.method->name + "</b> <span class=\"" + verdict + "\">" +
            verdict + "</span> " + measured_text(cell);
    if (!cell.warning.empty()) html += " The program says: " + escape_html(cell.warning) + ".";
    return html + "<pre>" + escape_html(command_of(cell)) + "</pre></figcaption>\n</figure>\n";
}

std::string case_sections(const std::vector<StabilityCell>& cells) {
    std::string html;
    const StiffCase* open_case = nullptr;
    for (const StabilityCell& cell : cells) {
        if (cell.stiff != open_case) {
            if (open_case != nullptr) html += "</div>\n";
            html += "<h2 id=\"" + escape_html(cell.stiff->name) + "\">" + escape_html(cell.stiff->name) +
                    "</h2>\n<p>" + escape_html(cell.stiff->question) +
                    ".<br>Stated before it is measured: " + escape_html(stated_answer(*cell.stiff)) +
                    ".</p>\n<div class=\"cells\">\n";
        }
        open_case = cell.stiff;
        html += detail(cell);
    }
    return open_case == nullptr ? html : html + "</div>\n";
}

}  // namespace

std::string command_of(const StabilityCell& cell) {
    return std::string("crevice stability --case ") + cell.stiff->name + " --ao " + cell.method->name;
}

std::string stability_page(const BenchReport& report, const std::vector<StabilityCell>& cells,
                           const std::vector<CaseRounding>& rounding) {
    std::string body = kStyle;
    body +=
        "<main>\n<h1>Stability: every method on stiff cases</h1>\n<p>Each row is a case that asks much of "
        "the "
        "numbers. Its answer is known before it is measured: an open plane is 1, a scene in other units or "
        "elsewhere "
        "has the same bits, nothing seen is 1. A number is how far the mean accessibility lies below 1; "
        "where another "
        "view must have the same bits, the largest difference of a texel. Cells lead to their picture and "
        "command.</p>\n";
    if (!cells.empty()) body += legend() + heat_map(cells) + table_elements({&report.tables.front(), 1});
    body += rounding_section(rounding) + case_sections(cells) + "<h2>Run on</h2>\n" +
            facts_element(report.facts) + "</main>\n";
    return html_page("crevice stability", body);
}

}  // namespace crevice
