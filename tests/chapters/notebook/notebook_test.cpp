#include "chapters/notebook/notebook.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/notebook/chapter_page.h"
#include "chapters/notebook/html.h"
#include "chapters/notebook/output_html.h"
#include "rasterizer/base/error.h"
#include "tests/tools/notebook_source.h"
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

// A chapter of three cells; outputs are put at the lines of the file that they would be called from.
constexpr const char* kSource =
    "// %% intro [markdown]\n"                  // 1
    "// # Raw AO & its radius\n"                // 2
    "//\n"                                      // 3
    "// A *claim*, `code < 1`, $x_{1} < 2$.\n"  // 4
    "\n"                                        // 5
    "// %% pictures\n"                          // 6
    "book.show(\"ao_raw\", ao);\n"              // 7
    "\n"                                        // 8
    "// %% numbers [markdown]\n"                // 9
    "// The mean is {mean}.\n"                  // 10
    "\n"                                        // 11
    "// %% table\n"                             // 12
    "book.table(header, rows);\n";              // 13
constexpr int kPictures = 7, kTable = 13;

void write_sample(Notebook& book) {
    book.show("ao_raw", ao_picture(Image<float>(book.size(), 0.5f)), "darker where `a < b`", 12.5, kPictures);
    book.show_row({{"left", ao_picture(Image<float>({3, 3}, 0.0f)), "black"},
                   {"right", ao_picture(Image<float>({3, 3}, 1.0f)), "white"}},
                  "side by side", kPictures);
    book.compare({"before", ao_picture(Image<float>({3, 3}, 0.0f))},
                 {"after", ao_picture(Image<float>({3, 3}, 1.0f))}, "", kPictures);
    book.number("mean", 0.5, 2);
    book.table({"method", "RMSE"}, {{"a<b", "0.125"}, {"c|d", "-3e-2"}}, "errors", kTable);
    book.check("every pixel is in [0,1]", true, "min 0.5, max 0.5", kTable);
    book.check("the mean {mean} is above 0.6", false, "it is \"not\"", kTable);
    book.draw("curve", "<svg><text>x</text></svg>", "a curve", kTable);
    book.finish();
}

struct Written {
    std::string terminal, page, markdown, jupyter, png;
    std::vector<NotebookCell> cells;
};

Written written_sample(NotebookOptions options, const ScratchDirectory& scratch) {
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options, notebook_source("07_raw_ao", kSource), terminal, answers);
    write_sample(book);
    book.write_files();
    const std::string page =
        chapter_page({"07_raw_ao", {"Raw AO", ""}, book.file(), book.failed_checks()}, book.cells(),
                     {{"07_raw_ao", {"Raw AO", ""}, 1}, {"08_blur", {"Blur", ""}, 0}}, BookLanguage::en);
    return {terminal.str(),
            page,
            bytes_in(scratch / "07_raw_ao" / "07_raw_ao.md"),
            bytes_in(scratch / "07_raw_ao" / "07_raw_ao.ipynb"),
            bytes_in(scratch / "07_raw_ao" / "ao_raw.png"),
            book.cells()};
}

Written written_sample(bool quiet = false) {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    options.quiet = quiet;
    Written sample = written_sample(options, scratch);
    CHECK(!contains(sample.page, scratch.path().string()));
    return sample;
}

}  // namespace

TEST_CASE("notebook: outputs land under the cell that made them; prose has its numbers") {
    const Written sample = written_sample();
    REQUIRE(sample.cells.size() == 4);
    CHECK(sample.cells[1].outputs.size() == 3);
    CHECK(sample.cells[2].prose.en == "The mean is 0.50.");
    CHECK(sample.cells[3].outputs.size() == 4);
    CHECK(std::get<CheckOutput>(sample.cells[3].outputs[2]).claim.en == "the mean 0.50 is above 0.6");
}

TEST_CASE("notebook: what belongs into another cell is named by file and line") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    const Picture picture = ao_picture(Image<float>({2, 2}, 1.0f));
    const auto message_of = [&](auto act) {
        Notebook book(options_in(scratch), notebook_source("07_raw_ao", kSource), terminal, answers);
        try {
            act(book);
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(contains(message_of([&](Notebook& book) { book.show("a", picture, "", {}, 4); }),
                   "chapters/07_raw_ao.cpp:4: an output of the cell intro"));
    CHECK(contains(message_of([&](Notebook& book) {
                       book.number("mean", 1, 0);
                       book.show("a", picture, "", {}, kTable);
                       book.show("b", picture, "", {}, kPictures);
                   }),
                   "chapters/07_raw_ao.cpp:7: an output of the cell pictures, which is over"));
    CHECK(contains(message_of([&](Notebook& book) { book.show("a", picture, "", {}, 99); }), ":99: "));
    CHECK(contains(message_of([&](Notebook& book) { book.show("a", picture, "", {}, kTable); }), "(mean)"));
}

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
    const Written sample = written_sample();
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
    CHECK(failed_checks_in(sample.page) == 1);
    CHECK(failed_checks_in("<html></html>") == -1);
}

TEST_CASE("two runs write the same bytes, whatever the directory and the times are") {
    const Written a = written_sample(), b = written_sample();
    CHECK(a.page == b.page);
    CHECK(a.markdown == b.markdown);
    CHECK(a.jupyter == b.jupyter);
    CHECK(a.png == b.png);
    CHECK(!contains(a.page, "12.50 ms"));
    CHECK(contains(a.terminal, "12.50 ms"));
}

TEST_CASE("terminal: plain text without colours when it is none; quiet shows failed checks only") {
    const std::string text = written_sample().terminal;
    CHECK(contains(text, "# Raw AO & its radius\n"));
    CHECK(contains(text, "ao_raw.png  4x2\n"));
    CHECK(contains(text, "min 0.5, mean 0.5, max 0.5"));
    CHECK(contains(text, "✓ every pixel is in [0,1]  (min 0.5, max 0.5)\n"));
    CHECK(contains(text, "✗ the mean 0.50 is above 0.6  (it is \"not\")\n"));
    CHECK(contains(text, "  method   RMSE\n  a<b     0.125\n  c|d     -3e-2\n"));
    CHECK(!contains(text, "\033"));
    CHECK(written_sample(true).terminal == "✗ the mean 0.50 is above 0.6  (it is \"not\")\n");
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
    const Written sample = written_sample();
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
    NotebookOptions options = options_in(scratch);
    options.size = {160, 90};
    options.seed = 3;
    options.words = {"radius=2"};
    CHECK(contains(written_sample(options, scratch).jupyter,
                   "--cell pictures --size 160x90 --seed 3 --param 'radius=2' --out .."));
}

TEST_CASE("one cell: only its outputs are kept, with its buffers as .npy, and the chapter ends with it") {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    options.cell = "pictures";
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options, notebook_source("07_raw_ao", kSource), terminal, answers);
    CHECK_THROWS_AS(write_sample(book), LeaveChapter);
    CHECK(std::filesystem::exists(scratch / "07_raw_ao" / "ao_raw.npy"));
    CHECK(!std::filesystem::exists(scratch / "07_raw_ao" / "curve.svg"));
    CHECK(!contains(terminal.str(), "Raw AO"));
    options.cell = "nowhere";
    CHECK_THROWS_AS(Notebook(options, notebook_source("07_raw_ao", kSource), terminal, answers), UsageError);
}

TEST_CASE("step: values, previews, files; a parameter runs the chapter again; q leaves it") {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    options.step = true;
    const auto run = [&](const std::string& typed, std::string& said) {
        std::ostringstream terminal;
        std::istringstream answers(typed);
        Notebook book(options, notebook_source("07_raw_ao", kSource), terminal, answers);
        auto why = std::optional<LeaveChapter>();
        try {
            write_sample(book);
        } catch (const LeaveChapter& wish) {
            why = wish;
        }
        said = terminal.str();
        return why;
    };
    std::string said;
    const std::string saved = (scratch / "saved.npy").string();
    auto why = run("p 1 1\nv ao_raw\ns ao_raw " + saved + "\nv nothing\np x\n?\n\n\n", said);
    CHECK(!why);
    CHECK(contains(said, "  ao_raw (4x2): 0.5\n"));
    CHECK(contains(said, "\033[38;2;128;128;128m"));
    CHECK(contains(said, "no picture of this name has been shown (nothing)"));
    CHECK(contains(said, "p needs two whole numbers"));
    CHECK(read_npy(saved).front().at(1, 1) == 0.5f);
    why = run("set radius=2\n", said);
    REQUIRE(why);
    CHECK(why->why == LeaveChapter::Why::run_again);
    CHECK(why->word == "radius=2");
    CHECK(why->cell == "pictures");
    why = run("q\n", said);
    REQUIRE(why);
    CHECK(why->why == LeaveChapter::Why::quit);
    options.silent_until = "table";
    why = run("", said);
    CHECK(!contains(said, "ao_raw"));
    CHECK(contains(said, "every pixel is in [0,1]"));
}

TEST_CASE(
    "a picture leads into the lab by its command; a transcript tells what was typed from what was answered") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options_in(scratch), notebook_source("07_raw_ao", ""), terminal, answers);
    const std::string command = "crevice probe columns 1 2 --eye=-1,2,3 --param epsilon=0";
    book.show({"ao", ao_picture(Image<float>({2, 2}, 1.0f)), "open", command}, 1);
    book.transcript("$ crevice probe a \\\n    --pass ao\nAO 1 < 2\n(gdb) run\n", "what it says", 1);
    book.write_files();
    const std::string address =
        "lab.html#crevice%20probe%20columns%201%202%20--eye=-1,2,3%20--param%20epsilon=0";
    const std::string html =
        output_html(book.cells()[0].outputs[0]) + output_html(book.cells()[0].outputs[1]);
    CHECK(contains(html, "<a class=\"lab\" href=\"" + address + "\""));
    CHECK(
        contains(html, "<b>$ crevice probe a \\</b>\n<b>    --pass ao</b>\nAO 1 &lt; 2\n<b>(gdb) run</b>\n"));
    const std::string markdown = bytes_in(scratch / "07_raw_ao" / "07_raw_ao.md");
    CHECK(contains(markdown, "[`" + command + "`](../" + address + ")"));
    CHECK(contains(markdown, "```console\n$ crevice probe a \\\n    --pass ao\nAO 1 < 2\n(gdb) run\n```"));
    CHECK(contains(terminal.str(), "    " + command + "\n"));
    CHECK(contains(terminal.str(), "    AO 1 < 2\n"));
}

TEST_CASE("checks are counted and passed through") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options_in(scratch), notebook_source("01_test", ""), terminal, answers);
    CHECK(book.check("yes", true));
    CHECK(!book.check("no", false));
    CHECK(book.checks() == 2);
    CHECK(book.failed_checks() == 1);
}

TEST_CASE("mistakes of a chapter are named") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options_in(scratch), notebook_source("01_test", ""), terminal, answers);
    const Picture picture = ao_picture(Image<float>({2, 2}, 1.0f)),
                  larger = ao_picture(Image<float>({4, 2}, 1.0f));
    book.show("ao", picture);
    book.number("mean", 1, 0);
    CHECK_THROWS_AS(book.number("mean", 1, 0), UsageError);
    CHECK_THROWS_AS(book.show("ao", picture), UsageError);
    CHECK_THROWS_AS(book.show("../ao", picture), UsageError);
    CHECK_THROWS_AS(book.show("", picture), UsageError);
    CHECK_THROWS_AS(book.show_row({{"same", picture}, {"same", picture}}), UsageError);
    CHECK_THROWS_AS(book.compare({"one", picture}, {"two", larger}), UsageError);
    CHECK_THROWS_AS(book.table({"a", "b"}, {{"1"}}), UsageError);
    CHECK_THROWS_AS(book.show("b", picture, "without a number {gone}"), UsageError);
    CHECK_THROWS_AS(book.listing("ssao/nowhere.h", "f"), UsageError);
    NotebookOptions nowhere = options_in(scratch);
    nowhere.out = "/dev/null/out";
    CHECK_THROWS_AS(Notebook(nowhere, notebook_source("01_test", ""), terminal, answers), OutputError);
}

TEST_CASE("base64: the vectors of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe\xfd") == "//79");
}
