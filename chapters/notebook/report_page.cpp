#include "chapters/notebook/report_page.h"

#include "chapters/notebook/html.h"

namespace crevice {

std::string facts_element(const Facts& facts) {
    std::string html = "<table>\n";
    for (const auto& [name, value] : facts)
        html += "<tr><th>" + escape_html(name) + "</th><td>" + escape_html(value) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string table_elements(std::span<const Table> tables) {
    std::string html;
    for (const Table& table : tables)
        html +=
            "<h2>" + escape_html(table.name) + "</h2>\n<pre>" + escape_html(table_text(table)) + "</pre>\n";
    return html;
}

}  // namespace crevice
