#include "chapters/notebook/page_packages.h"

#include <string_view>

#include "chapters/notebook/embedded_files.h"
#include "chapters/notebook/html.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

std::string_view packaged(const std::string& name) {
    const std::string path = "page/" + name;
    const auto file = embedded_file(path);
    if (!file) throw UsageError(path + ": not a file that the program contains");
    return *file;
}

// The @font-face block with the font itself in place of its address; empty where the program does not contain it.
std::string with_font_inside(std::string_view block) {
    constexpr std::string_view kAddress = "url(fonts/", kSource = "src:";
    const std::size_t name = block.find(kAddress) + kAddress.size(), end = block.find(')', name);
    const auto font = embedded_file("page/fonts/" + std::string(block.substr(name, end - name)));
    if (!font) return "";
    const std::size_t source = block.find(kSource) + kSource.size(), rest = block.find(';', source);
    std::string result(block.substr(0, source));
    result += "url(data:font/woff2;base64," + base64(*font) + ") format('woff2')";
    result += block.substr(rest);
    return result;
}

}  // namespace

std::string katex_style() {
    constexpr std::string_view kBlock = "@font-face{";
    std::string_view css = packaged("katex.css");
    std::string style;
    for (std::size_t at = css.find(kBlock); at != css.npos; at = css.find(kBlock)) {
        const std::size_t end = css.find('}', at) + 1;
        style += css.substr(0, at);
        style += with_font_inside(css.substr(at, end - at));
        css.remove_prefix(end);
    }
    style += css;
    return style;
}

std::string katex_script() { return std::string(packaged("katex.js")); }

std::string highlight_script() {
    // The package holds the core, then one block a language.
    constexpr std::string_view kLanguage = "\nhljs.registerLanguage('",
                               kCpp = "\nhljs.registerLanguage('cpp'";
    const std::string_view all = packaged("highlight.js");
    const std::size_t first = all.find(kLanguage), cpp = all.find(kCpp);
    if (first == all.npos || cpp == all.npos)
        throw UsageError(
            "page/highlight.js: not made as expected; it must register C++ as a language of its own");
    std::string script(all.substr(0, first));
    script += all.substr(cpp, all.find(kLanguage, cpp + 1) - cpp);
    return script;
}

}  // namespace crevice
