#include "chapters/report/report_markdown.h"

#include "chapters/notebook/markdown_text.h"
#include "chapters/report/setting_words.h"

namespace crevice {

namespace {

// The first drawing of a choice, and links to the others.
std::string choices_markdown(const ReportBlock& block) {
    std::string links;
    for (std::size_t i = 1; i < block.outputs.size(); ++i) {
        const auto& drawing = std::get<DrawingOutput>(block.outputs[i]);
        links += std::string(i == 1 ? "The same for " : ", ") + "[" + escaped_markdown(block.choices[i]) +
                 "](" + drawing.name + ".svg)";
    }
    return output_markdown(block.outputs.front(), BookLanguage::en) + (links.empty() ? "" : links + ".\n\n");
}

std::string block_markdown(const ReportBlock& block) {
    std::string text = block.heading.empty() ? "" : "### " + escaped_markdown(block.heading) + "\n\n";
    if (!block.prose.empty()) text += block.prose + "\n\n";
    if (!block.choices.empty()) return text + choices_markdown(block);
    for (const Output& output : block.outputs) text += output_markdown(output, BookLanguage::en);
    return text;
}

}  // namespace

std::string report_markdown(const std::string& title, std::span<const ReportSection> sections) {
    std::string text = "# " + escaped_markdown(title) + "\n\n";
    for (const ReportSection& section : sections) {
        text += "## " + escaped_markdown(section.heading) + "\n\n";
        for (const ReportBlock& block : section.blocks) text += block_markdown(block);
    }
    return text;
}

}  // namespace crevice
