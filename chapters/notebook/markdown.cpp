#include "chapters/notebook/markdown.h"

#include <md4c-html.h>

#include "rasterizer/base/error.h"

namespace crevice {

std::string html_from_markdown(std::string_view markdown) {
    std::string html;
    const auto append = [](const MD_CHAR* text, MD_SIZE size, void* target) {
        static_cast<std::string*>(target)->append(text, size);
    };
    const unsigned flags = MD_FLAG_TABLES | MD_FLAG_NOHTMLSPANS | MD_FLAG_LATEXMATHSPANS;
    if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html, flags, 0) != 0) {
        throw InputError("a Markdown text cannot be parsed (" + std::string(markdown.substr(0, 40)) +
                         "...); there may be too little memory");
    }
    return html;
}

}  // namespace crevice
