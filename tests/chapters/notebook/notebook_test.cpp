#include "chapters/notebook/notebook.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/notebook/html.h"
#include "chapters/notebook/notebook_page.h"
#include "rasterizer/base/error.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string bytes_in(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

NotebookOptions options_in(const ScratchDirectory& scratch) {
    NotebookOptions options;
    options.out = scratch.path();
    options.size = {4, 2};
    return options;
}

void write_sample(Notebook& book) {
    book.text(R"(
        # Raw AO & its <radius>

        A *claim*, `code < 1`, and <script>alert(1)</script>.

            indented code stays code
    )");
    book.show("ao_raw", ao_picture(Image<float>(book.size(), 0.5f)), "darker where a < b & c", 12.5);
    book.show_row("side by side", {{"left", ao_picture(Image<float>({3, 3}, 0.0f))},
                                   {"right", ao_picture(Image<float>({3, 3}, 1.0f))}});
    book.table({"method", "RMSE"}, {{"a<b", "0.125"}, {"c|d", "-3e-2"}});
    book.check("every pixel is in [0,1]", true, "min 0.5, max 0.5");
    book.check("0.5 < 0.4 & more", false, "it is \"not\"");
    book.try_it({"set `radius` to 2: darker", "edit 2", "edit 3"});
    book.errata({"the tutorial divides by zero"});
}

struct Written {
    std::string terminal, html, markdown, jupyter, png;
};

Written written_sample(bool quiet = false) {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    options.quiet = quiet;
    std::ostringstream terminal;
    Notebook book(options, "07_raw_ao", terminal);
    write_sample(book);
    book.write_files();
    CHECK(!contains(book.html(), scratch.path().string()));
    return {terminal.str(), book.html(), bytes_in(scratch / "07_raw_ao" / "07_raw_ao.md"),
            bytes_in(scratch / "07_raw_ao" / "07_raw_ao.ipynb"),
            bytes_in(scratch / "07_raw_ao" / "ao_raw.png")};
}

}  // namespace

TEST_CASE("html: what is text stays text, what is Markdown becomes HTML") {
    const std::string html = written_sample().html;
    CHECK(contains(html, "<h1>Raw AO &amp; its &lt;radius&gt;</h1>"));
    CHECK(contains(html, "<em>claim</em>"));
    CHECK(contains(html, "<code>code &lt; 1</code>"));
    CHECK(contains(html, "<pre><code>indented code stays code\n</code></pre>"));
    CHECK(contains(html, "&lt;script&gt;"));
    CHECK(!contains(html, "<script"));
    CHECK(contains(html, "darker where a &lt; b &amp; c"));
    CHECK(contains(html, "<td>a&lt;b</td><td class=\"number\">0.125</td>"));
    CHECK(contains(html, "0.5 &lt; 0.4 &amp; more"));
    CHECK(contains(html, "it is &quot;not&quot;"));
    CHECK(contains(html, "<li>set <code>radius</code> to 2: darker</li>"));
}

TEST_CASE("html: the page needs nothing from outside and contains every picture") {
    const Written sample = written_sample();
    const std::string page =
        notebook_page({{"07_raw_ao", "Raw AO", sample.html, 1}, {"08_blur", "Blur", "", 0}});
    // A link may lead anywhere; it loads nothing by itself.
    for (const char* outside :
         {"src=\"http", "src=\"//", "srcset", "stylesheet", "url(", "@import", "<script", "<iframe"}) {
        CAPTURE(outside);
        CHECK(!contains(page, outside));
    }
    CHECK(contains(page, "src=\"data:image/png;base64," + base64(sample.png) + "\""));
    CHECK(contains(page, "<a href=\"#07_raw_ao\">"));
    CHECK(contains(page, "<section id=\"07_raw_ao\">"));
    CHECK(contains(page, "prefers-color-scheme: dark"));
    // A 4-pixel picture is shown at a whole multiple of its size.
    CHECK(contains(page, "style=\"width:320px\""));
    CHECK(contains(page, "image-rendering: pixelated"));
}

TEST_CASE("two runs write the same bytes, whatever the directory and the times are") {
    const Written a = written_sample(), b = written_sample();
    CHECK(a.html == b.html);
    CHECK(a.markdown == b.markdown);
    CHECK(a.jupyter == b.jupyter);
    CHECK(a.png == b.png);
    CHECK(!contains(a.html, "12.5"));
    CHECK(contains(a.terminal, "12.50 ms"));
}

TEST_CASE("terminal: plain text without colours when it is none; quiet shows failed checks only") {
    const std::string text = written_sample().terminal;
    CHECK(contains(text, "# Raw AO & its <radius>\n"));
    CHECK(contains(text, "ao_raw.png  4x2\n"));
    CHECK(contains(text, "min 0.5, mean 0.5, max 0.5"));
    CHECK(contains(text, "✓ every pixel is in [0,1]  (min 0.5, max 0.5)\n"));
    CHECK(contains(text, "✗ 0.5 < 0.4 & more  (it is \"not\")\n"));
    CHECK(contains(text, "  method   RMSE\n  a<b     0.125\n  c|d     -3e-2\n"));
    CHECK(!contains(text, "\033"));
    CHECK(written_sample(true).terminal == "✗ 0.5 < 0.4 & more  (it is \"not\")\n");
}

TEST_CASE("markdown: pictures are linked, tables keep their columns") {
    const std::string markdown = written_sample().markdown;
    CHECK(markdown.starts_with("# Raw AO & its <radius>\n\nA *claim*"));
    CHECK(contains(markdown, "![ao_raw](ao_raw.png)"));
    CHECK(contains(markdown, "| method | RMSE |\n|---|---:|\n| a&lt;b | 0.125 |\n| c\\|d | -3e-2 |\n"));
    CHECK(contains(markdown, "1. set `radius` to 2: darker\n2. edit 2\n3. edit 3\n"));
}

TEST_CASE("jupyter: nbformat 4.5") {
    const Written sample = written_sample();
    const nlohmann::json notebook = nlohmann::json::parse(sample.jupyter);
    CHECK(notebook.at("nbformat") == 4);
    CHECK(notebook.at("nbformat_minor") == 5);
    CHECK(notebook.at("metadata").at("language_info").at("name") == "c++");
    REQUIRE(notebook.at("cells").size() == 8);
    for (const auto& cell : notebook.at("cells")) {
        CAPTURE(cell.dump());
        CHECK(cell.at("id").get<std::string>().starts_with("07_raw_ao-"));
        CHECK(cell.at("metadata").is_object());
        CHECK(cell.at("source").is_string());
        const bool is_code = cell.at("cell_type") == "code";
        CHECK(cell.contains("outputs") == is_code);
        CHECK(cell.contains("execution_count") == is_code);
    }
    const auto& output = notebook.at("cells").at(1).at("outputs").at(0);
    CHECK(output.at("output_type") == "display_data");
    CHECK(output.at("data").at("image/png") == base64(sample.png));
    CHECK(output.at("data").at("text/plain").is_array());
    CHECK(output.at("metadata").at("image/png").at("width") == 4);
    CHECK(notebook.at("cells").at(2).at("outputs").size() == 2);
}

TEST_CASE("checks are counted and passed through") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    Notebook book(options_in(scratch), "01_test", terminal);
    CHECK(book.check("yes", true));
    CHECK(!book.check("no", false));
    CHECK(book.checks() == 2);
    CHECK(book.failed_checks() == 1);
}

TEST_CASE("mistakes of a chapter are named") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    Notebook book(options_in(scratch), "01_test", terminal);
    const Picture picture = ao_picture(Image<float>({2, 2}, 1.0f));
    book.show("ao", picture);
    CHECK_THROWS_AS(book.show("ao", picture), UsageError);
    CHECK_THROWS_AS(book.show("../ao", picture), UsageError);
    CHECK_THROWS_AS(book.show("", picture), UsageError);
    CHECK_THROWS_AS(book.show_row("", {{"same", picture}, {"same", picture}}), UsageError);
    CHECK_THROWS_AS(book.table({"a", "b"}, {{"1"}}), UsageError);
    NotebookOptions nowhere = options_in(scratch);
    nowhere.out = "/dev/null/out";
    CHECK_THROWS_AS(Notebook(nowhere, "01_test", terminal), OutputError);
}

TEST_CASE("base64: the vectors of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe\xfd") == "//79");
}
