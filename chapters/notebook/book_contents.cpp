#include "chapters/notebook/book_contents.h"

#include <algorithm>
#include <string_view>

#include "chapters/notebook/html.h"

namespace crevice {

namespace {

struct BookPart {
    const char* first;  // the number of its first chapter
    BookText title;
};
const BookPart kParts[] = {
    {"01", {"I · The tutorials' SSAO, pass by pass", "第一部分 · 教程中的 SSAO，逐步讲解"}},
    {"13", {"II · The other methods", "第二部分 · 其他方法"}},
    {"21", {"III · Judgement", "第三部分 · 评判"}},
};

std::string entry_html(const BookEntry& chapter, const std::string& here) {
    std::string html = "<li><a";
    if (chapter.name == here) html += " class=\"here\" aria-current=\"page\"";
    html += " href=\"" + escape_html(chapter.name) + ".html\"><span class=\"number\">" +
            escape_html(chapter.name.substr(0, 2)) + "</span><span>" + plain_html(chapter.title);
    if (chapter.failed_checks > 0)
        html += " <span class=\"bad\">✗ " + std::to_string(chapter.failed_checks) + "</span>";
    return html + "</span></a></li>\n";
}

}  // namespace

std::string bilingual_html(const BookText& html, bool inline_html) {
    if (html.zh.empty()) return html.en;
    const std::string tag = inline_html ? "span" : "div";
    return "<" + tag + " class=\"en\">" + html.en + "</" + tag + "><" + tag + " class=\"zh\" lang=\"zh\">" +
           html.zh + "</" + tag + ">";
}

std::string plain_html(const BookText& text) {
    return bilingual_html({escape_html(text.en), escape_html(text.zh)}, true);
}

std::string contents_html(const std::vector<BookEntry>& chapters, const std::string& here) {
    std::string html = "<nav>\n<a href=\"index.html\"><strong>Crevice</strong></a>\n";
    const bool translated = std::any_of(chapters.begin(), chapters.end(),
                                        [](const BookEntry& chapter) { return !chapter.title.zh.empty(); });
    if (translated)
        html +=
            "<div class=\"languages\"><button data-set-lang=\"en\">English</button>"
            "<button data-set-lang=\"zh\">中文</button></div>\n";
    std::size_t part = 0;
    html += "<ol>\n";
    for (const BookEntry& chapter : chapters) {
        const BookPart* begun = nullptr;
        for (; part < std::size(kParts) && chapter.name >= kParts[part].first; ++part) begun = &kParts[part];
        if (begun != nullptr) html += "<li class=\"part\">" + plain_html(begun->title) + "</li>\n";
        html += entry_html(chapter, here);
    }
    html += "<li class=\"part\"></li>\n<li><a href=\"index.html#sources\"><span>" +
            plain_html({"The sources, by their names", "各个来源及其称呼"}) + "</span></a></li>\n";
    return html + "</ol></nav>\n";
}

}  // namespace crevice
