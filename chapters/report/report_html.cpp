#include "chapters/report/report_html.h"

#include "chapters/notebook/html.h"
#include "chapters/notebook/output_html.h"

namespace crevice {

namespace {

std::string contents(const std::string& title, std::span<const ReportSection> sections) {
    std::string html = "<nav>\n<strong>" + escape_html(title) + "</strong>\n<ol>\n";
    for (const ReportSection& section : sections)
        html += "<li><a href=\"#" + escape_html(section.id) + "\">" + escape_html(section.heading) +
                "</a></li>\n";
    return html + "</ol></nav>\n";
}

// Radio buttons that show one output each; style alone does it.
std::string choices_html(const ReportBlock& block) {
    const std::string name = escape_html(block.id);
    std::string buttons, shown;
    for (std::size_t i = 0; i < block.outputs.size(); ++i) {
        const std::string id = name + "-" + std::to_string(i);
        buttons += "<input type=\"radio\" name=\"" + name + "\" id=\"" + id + "\"" +
                   (i == 0 ? " checked" : "") + "><label for=\"" + id + "\">" +
                   escape_html(block.choices[i]) + "</label>\n";
        shown += "<div class=\"choice\">\n" + output_html(block.outputs[i]) + "</div>\n";
    }
    return "<div class=\"choices\">\n" + buttons + shown + "</div>\n";
}

std::string block_html(const ReportBlock& block) {
    std::string attributes = block.id.empty() ? "" : " id=\"" + escape_html(block.id) + "\"";
    if (block.threads > 0) attributes += " data-threads=\"" + std::to_string(block.threads) + "\"";
    std::string body = block.prose.empty() ? "" : prose_html({block.prose, ""});
    if (!block.choices.empty()) {
        body += choices_html(block);
    } else {
        for (const Output& output : block.outputs) body += output_html(output);
    }
    if (block.folded) {
        return "<details class=\"wide\"" + attributes + "><summary>" + escape_html(block.heading) +
               "</summary>\n" + body + "</details>\n";
    }
    const std::string heading = block.heading.empty() ? "" : "<h3>" + escape_html(block.heading) + "</h3>\n";
    return "<div" + attributes + ">\n" + heading + body + "</div>\n";
}

}  // namespace

std::string report_html(const std::string& title, std::span<const ReportSection> sections) {
    std::string body = "<div class=\"with-contents\">\n" + contents(title, sections) + "<main>\n<h1>" +
                       escape_html(title) + "</h1>\n";
    for (const ReportSection& section : sections) {
        body += "<section id=\"" + escape_html(section.id) + "\"";
        if (!section.scene.empty()) body += " data-scene=\"" + escape_html(section.scene) + "\"";
        body += ">\n<h2>" + escape_html(section.heading) + "</h2>\n";
        for (const ReportBlock& block : section.blocks) body += block_html(block);
        body += "</section>\n";
    }
    PageParts parts;
    parts.plots = true;
    return html_page(title + " · Crevice", body + "</main></div>\n", parts);
}

}  // namespace crevice
