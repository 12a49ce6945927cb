#include "chapters/notebook/html.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "chapters/notebook/embedded_files.h"
#include "chapters/notebook/page_packages.h"

namespace crevice {

namespace {

constexpr const char* kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string escape_html(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&': escaped += "&amp;"; break;
            case '<': escaped += "&lt;"; break;
            case '>': escaped += "&gt;"; break;
            case '"': escaped += "&quot;"; break;
            default: escaped += c;
        }
    }
    return escaped;
}

std::string unescape_html(std::string_view html) {
    static constexpr std::pair<std::string_view, char> kEntities[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}};
    std::string text;
    while (!html.empty()) {
        const auto entity = std::find_if(std::begin(kEntities), std::end(kEntities),
                                         [&](const auto& known) { return html.starts_with(known.first); });
        const bool found = entity != std::end(kEntities);
        text += found ? entity->second : html.front();
        html.remove_prefix(found ? entity->first.size() : 1);
    }
    return text;
}

std::string lab_address(std::string_view command) {
    // As JavaScript's encodeURIComponent(), but for the characters that a command may well show.
    constexpr std::string_view kKept = "-_.~,=";
    constexpr const char* kHex = "0123456789ABCDEF";
    std::string address = "lab.html#";
    for (const char c : command) {
        const auto byte = static_cast<unsigned char>(c);
        const bool alphanumeric = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (alphanumeric || kKept.find(c) != kKept.npos)
            address += c;
        else
            address += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
    return address;
}

std::string base64(std::string_view bytes) {
    std::string digits;
    digits.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            digits += i + k <= bytes.size() ? kBase64Digits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return digits;
}

std::string image_element(std::string_view file, Size size, std::string_view alt, std::string_view classes,
                          std::string_view type) {
    const int scale = size.width < kMinShownWidth ? (kMinShownWidth + size.width - 1) / size.width : 1;
    std::string element = "<img";
    if (!classes.empty()) element += " class=\"" + escape_html(classes) + "\"";
    element +=
        " alt=\"" + escape_html(alt) + "\" style=\"width:" + std::to_string(size.width * scale) + "px\"";
    return element + " src=\"data:" + std::string(type) + ";base64," + base64(file) + "\">";
}

std::string html_page(std::string_view title, std::string_view body, const PageParts& parts) {
    const std::string language = escape_html(parts.language);
    std::string page = "<!DOCTYPE html>\n<html lang=\"" + language + "\" data-lang=\"" + language +
                       "\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" + parts.head;
    page += "<link rel=\"icon\" href=\"data:,\">\n<title>" + escape_html(title) + "</title>\n<style>";
    page += embedded_file("page/page.css").value_or("");
    if (parts.mathematics) page += katex_style();
    if (parts.plots) page += embedded_file("page/plots.css").value_or("");
    page += "</style>\n</head>\n<body>\n";
    page += body;
    if (parts.mathematics) page += "<script>" + katex_script() + "</script>\n";
    if (parts.code) page += "<script>" + highlight_script() + "</script>\n";
    if (parts.script)
        page += "<script>" + std::string(embedded_file("page/page.js").value_or("")) + "</script>\n";
    for (const char* const script : {"page/point_card.js", "page/zooming_plot.js", "page/plots.js"}) {
        if (parts.plots) page += "<script>" + std::string(embedded_file(script).value_or("")) + "</script>\n";
    }
    return page + "</body>\n</html>\n";
}

}  // namespace crevice
