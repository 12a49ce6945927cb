// What a chapter is written as: the page, Markdown and a Jupyter notebook.
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/notebook/html.h"
#include "chapters/notebook/output_html.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/written_notebook.h"

using namespace crevice;

TEST_CASE("page: what is text stays text, what is Markdown becomes HTML") {
    const std::string html = written_sample().page;
    CHECK(contains(html, "<h1>Raw AO &amp; its radius</h1>"));
    CHECK(contains(html, "<em>claim</em>"));
    CHECK(contains(html, "<code>code &lt; 1</code>"));
    CHECK(contains(html, "<x-equation>x_{1} &lt; 2</x-equation>"));
    CHECK(contains(html, "darker where <code>a &lt; b</code>"));
    CHECK(contains(html, "<td>a&lt;b</td><td class=\"number\">0.125</td>"));
    CHECK(contains(html, "it is &quot;not&quot;"));
    CHECK(contains(html, "book.show(&quot;ao_raw&quot;, ao);"));
}

TEST_CASE("page: it needs nothing from outside and contains every picture and its values") {
    const WrittenNotebook sample = written_sample();
    // A link may lead anywhere; it loads nothing by itself.
    for (const char* outside : {"src=\"http", "src=\"//", "srcset", "rel=\"stylesheet", "url(http",
                                "url(fonts", "@import", "<iframe", "<script src"}) {
        CAPTURE(outside);
        CHECK(!contains(sample.page, outside));
    }
    CHECK(contains(sample.page, "src=\"data:image/png;base64," + base64(sample.png) + "\""));
    const std::string values = base64(values_png(planes_of(Image<float>({4, 2}, 0.5f))));
    CHECK(contains(sample.page, "<script type=\"text/plain\" class=\"values\">" + values));
    CHECK(contains(sample.page, "href=\"08_blur.html\""));
    CHECK(contains(sample.page, "class=\"here\" aria-current=\"page\" href=\"07_raw_ao.html\""));
    CHECK(contains(sample.page, "prefers-color-scheme: dark"));
    CHECK(contains(sample.page, "katex.render"));
    CHECK(contains(sample.page, "registerLanguage('cpp'"));
    CHECK(!contains(sample.page, "registerLanguage('perl'"));
    // A 4-pixel picture is shown at a whole multiple of its size.
    CHECK(contains(sample.page, "style=\"width:640px\""));
    CHECK(failed_checks_in(sample.page.substr(0, kFailedChecksWithin)) == 1);
    CHECK(failed_checks_in("<html></html>") == -1);
}

TEST_CASE("two runs write the same bytes, whatever the directory and the times are") {
    const WrittenNotebook a = written_sample(), b = written_sample();
    CHECK(a.page == b.page);
    CHECK(a.markdown == b.markdown);
    CHECK(a.jupyter == b.jupyter);
    CHECK(a.png == b.png);
    CHECK(!contains(a.page, "12.50 ms"));
    CHECK(contains(a.terminal, "12.50 ms"));
}

TEST_CASE("markdown: pictures are linked, code stands between fences, tables keep their columns") {
    const std::string markdown = written_sample().markdown;
    CHECK(markdown.starts_with("# Raw AO & its radius\n\nA *claim*"));
    CHECK(contains(markdown, "```cpp\nbook.show(\"ao_raw\", ao);\n```"));
    CHECK(contains(markdown, "![ao_raw](ao_raw.png)"));
    CHECK(contains(markdown, "![curve](curve.svg)"));
    CHECK(contains(markdown, "| method | RMSE |\n|---|---:|\n| a&lt;b | 0.125 |\n| c\\|d | -3e-2 |\n"));
}

TEST_CASE("jupyter: nbformat 4.5, and code cells that run the chapter's cells") {
    const WrittenNotebook sample = written_sample();
    const nlohmann::json notebook = nlohmann::json::parse(sample.jupyter);
    CHECK(notebook.at("nbformat") == 4);
    CHECK(notebook.at("nbformat_minor") == 5);
    CHECK(notebook.at("metadata").at("kernelspec").at("name") == "python3");
    const auto& cells = notebook.at("cells");
    REQUIRE(cells.size() == 7);
    const std::vector<std::string> ids = {"python-setup", "intro", "pictures-source", "pictures", "numbers",
                                          "table-source", "table"};
    for (std::size_t i = 0; i < ids.size(); ++i) {
        CAPTURE(cells[i].dump());
        CHECK(cells[i].at("id") == ids[i]);
        CHECK(cells[i].at("metadata").is_object());
        CHECK(cells[i].at("source").is_string());
        const bool is_code = cells[i].at("cell_type") == "code";
        CHECK(cells[i].contains("outputs") == is_code);
        CHECK(cells[i].contains("execution_count") == is_code);
    }
    const std::string run = cells[3].at("source");
    CHECK(contains(run, "!{crevice} chapter 07 --cell pictures --size 4x2 --out ..\n"));
    CHECK(contains(run, "display(Image(\"ao_raw.png\"))\nao_raw = np.load(\"ao_raw.npy\")"));
    CHECK(cells[3].at("outputs").size() == 6);
    CHECK(cells[3].at("outputs")[0].at("output_type") == "stream");
    const auto& output = cells[3].at("outputs")[1];
    CHECK(output.at("data").at("image/png") == base64(sample.png));
    CHECK(output.at("metadata").at("image/png").at("width") == 4);
    CHECK(cells[6].at("outputs")[1].at("data").contains("image/svg+xml"));
}

TEST_CASE("jupyter: the cells ask for the pictures that the chapter was run for") {
    const ScratchDirectory scratch;
    NotebookOptions options = notebook_options_in(scratch);
    options.size = {160, 90};
    options.seed = 3;
    options.words = {"radius=2"};
    CHECK(contains(written_sample(options, scratch).jupyter,
                   "--cell pictures --size 160x90 --seed 3 --param 'radius=2' --out .."));
}
