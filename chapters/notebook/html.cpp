#include "chapters/notebook/html.h"

#include <cstdint>

namespace crevice {

namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --paper: #fcfbf8; --ink: #1f2328; --soft: #656d76; --line: #e0dcd3;
  --card: #f4f1ea; --accent: #0b5cad; --good: #1a7f37; --bad: #c4232e; }
@media (prefers-color-scheme: dark) { :root { --paper: #16181c; --ink: #e3e5e8; --soft: #9aa2ac;
  --line: #33383f; --card: #1f2329; --accent: #79b8ff; --good: #56d364; --bad: #ff7b72; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 17px/1.6 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.5rem 6rem; }
.with-contents { display: grid; grid-template-columns: 17rem minmax(0, 1fr); }
nav { position: sticky; top: 0; align-self: start; max-height: 100vh; overflow: auto; padding: 2rem 1.25rem;
  border-right: 1px solid var(--line); font-size: .9rem; }
nav ol { list-style: none; margin: .5rem 0 0; padding: 0; }
nav a { display: flex; gap: .6rem; padding: .2rem .5rem; border-radius: 5px; color: inherit;
  text-decoration: none; }
nav a:hover { background: var(--card); }
nav .bad { white-space: nowrap; }
nav .number { color: var(--soft); font-variant-numeric: tabular-nums; }
@media (max-width: 60rem) { .with-contents { display: block; }
  nav { position: static; max-height: none; border-right: 0; border-bottom: 1px solid var(--line); } }
h1, h2, h3 { line-height: 1.25; text-wrap: balance; margin: 2.2rem 0 .8rem; }
h1 { font-size: 1.9rem; } h2 { font-size: 1.35rem; } h3 { font-size: 1.1rem; }
main > :first-child, section > :first-child { margin-top: 0; }
section + section { margin-top: 4rem; padding-top: 3rem; border-top: 1px solid var(--line); }
p, ul, ol, blockquote { max-width: 44rem; }
a { color: var(--accent); }
code, pre { font: .88em/1.5 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
code { background: var(--card); padding: .1em .3em; border-radius: 4px; }
pre { background: var(--card); padding: .9rem 1.1rem; border-radius: 8px; overflow-x: auto; }
pre code { padding: 0; background: none; }
blockquote { margin-left: 0; padding-left: 1rem; border-left: 3px solid var(--line); color: var(--soft); }
table { border-collapse: collapse; margin: 1.2rem 0; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .9rem .3rem 0; text-align: left; border-bottom: 1px solid var(--line); }
th { font-weight: 600; } td.number, th.number { text-align: right; }
.scroll { overflow-x: auto; }
figure { margin: 1.5rem 0; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
.pictures > div { flex: 0 1 auto; min-width: 0; }
.row > div { flex: 1 1 14rem; max-width: 34rem; }
img { display: block; max-width: 100%; height: auto; image-rendering: pixelated; border-radius: 3px;
  outline: 1px solid var(--line); outline-offset: -1px; }
.row img { width: 100% !important; }
figcaption { font-size: .95rem; margin-top: .5rem; max-width: 44rem; }
.about { font-size: .8rem; line-height: 1.45; color: var(--soft); margin: .35rem 0 0; }
.about b { color: var(--ink); }
label { display: block; position: relative; }
label input { position: absolute; opacity: 0; }
label input:focus-visible ~ img { outline: 2px solid var(--accent); }
.zoom { cursor: zoom-in; }
.zoom input:checked + img { position: fixed; inset: 0; z-index: 9; width: 100% !important; height: 100%;
  max-width: none; object-fit: contain; background: var(--paper); cursor: zoom-out; }
.flip { display: grid; cursor: pointer; } .flip > * { grid-area: 1 / 1; }
.flip .second { opacity: 0; }
.flip:hover .second, .flip input:checked ~ .second { opacity: 1; }
.flip:hover input:checked ~ .second { opacity: 0; }
.tag { justify-self: start; align-self: start; z-index: 1; margin: 6px; padding: 0 .5em; border-radius: 4px;
  font-size: .75rem; background: #000b; color: #fff; }
.check { display: grid; grid-template-columns: 1.4rem 1fr; margin: .35rem 0; max-width: 44rem; }
.check .detail { color: var(--soft); } .good { color: var(--good); } .bad { color: var(--bad); }
.bad-check { background: color-mix(in srgb, var(--bad) 12%, transparent); border-radius: 6px;
  padding: .3rem .5rem; }
.box { margin: 1.8rem 0; padding: .9rem 1.2rem; border-radius: 8px; max-width: 46rem;
  background: var(--card); }
.box > :first-child { margin-top: 0; } .box > :last-child { margin-bottom: 0; }
.bar { display: inline-block; height: .75em; background: var(--accent); border-radius: 2px; }
.side { display: flex; flex-wrap: wrap; gap: 0 3rem; }
)css";

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

std::string image_element(std::string_view png, Size size, std::string_view alt, std::string_view classes) {
    const int scale = size.width < kMinShownWidth ? (kMinShownWidth + size.width - 1) / size.width : 1;
    std::string element = "<img";
    if (!classes.empty()) element += " class=\"" + escape_html(classes) + "\"";
    element +=
        " alt=\"" + escape_html(alt) + "\" style=\"width:" + std::to_string(size.width * scale) + "px\"";
    return element + " src=\"data:image/png;base64," + base64(png) + "\">";
}

std::string html_page(std::string_view title, std::string_view body) {
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    page += "<link rel=\"icon\" href=\"data:,\">\n<title>" + escape_html(title) + "</title>\n<style>";
    page += kStyle;
    page += "</style>\n</head>\n<body>\n";
    page += body;
    page += "</body>\n</html>\n";
    return page;
}

}  // namespace crevice
