#include "chapters/notebook/notebook.h"

#include <sstream>

#include <doctest/doctest.h>

#include "chapters/notebook/html.h"
#include "chapters/notebook/output_html.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "tests/tools/notebook_source.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/written_notebook.h"

using namespace crevice;

TEST_CASE("notebook: outputs land under the cell that made them; prose has its numbers") {
    const WrittenNotebook sample = written_sample();
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
        Notebook book(notebook_options_in(scratch), notebook_source("07_raw_ao", kNotebookSource), terminal,
                      answers);
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

TEST_CASE("one cell: only its outputs are kept, with its buffers as .npy, and the chapter ends with it") {
    const ScratchDirectory scratch;
    NotebookOptions options = notebook_options_in(scratch);
    options.cell = "pictures";
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options, notebook_source("07_raw_ao", kNotebookSource), terminal, answers);
    CHECK_THROWS_AS(write_sample(book), LeaveChapter);
    CHECK(std::filesystem::exists(scratch / "07_raw_ao" / "ao_raw.npy"));
    CHECK(!std::filesystem::exists(scratch / "07_raw_ao" / "curve.svg"));
    CHECK(!contains(terminal.str(), "Raw AO"));
    options.cell = "nowhere";
    CHECK_THROWS_AS(Notebook(options, notebook_source("07_raw_ao", kNotebookSource), terminal, answers),
                    UsageError);
}

TEST_CASE("step: values, previews, files; a parameter runs the chapter again; q leaves it") {
    const ScratchDirectory scratch;
    NotebookOptions options = notebook_options_in(scratch);
    options.step = true;
    const auto run = [&](const std::string& typed, std::string& said) {
        std::ostringstream terminal;
        std::istringstream answers(typed);
        Notebook book(options, notebook_source("07_raw_ao", kNotebookSource), terminal, answers);
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
    Notebook book(notebook_options_in(scratch), notebook_source("07_raw_ao", ""), terminal, answers);
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
    const std::string markdown = read_file(scratch / "07_raw_ao" / "07_raw_ao.md", 1 << 20);
    CHECK(contains(markdown, "[`" + command + "`](../" + address + ")"));
    CHECK(contains(markdown, "```console\n$ crevice probe a \\\n    --pass ao\nAO 1 < 2\n(gdb) run\n```"));
    CHECK(contains(terminal.str(), "    " + command + "\n"));
    CHECK(contains(terminal.str(), "    AO 1 < 2\n"));
}

TEST_CASE("checks are counted and passed through") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(notebook_options_in(scratch), notebook_source("01_test", ""), terminal, answers);
    CHECK(book.check("yes", true));
    CHECK(!book.check("no", false));
    CHECK(book.checks() == 2);
    CHECK(book.failed_checks() == 1);
}

TEST_CASE("numbers: so many digits for all of them, or each as it is") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(notebook_options_in(scratch), notebook_source("01_test", ""), terminal, answers);
    book.numbers(2, {{"half", 0.5}, {"third", 1.0 / 3}});
    book.numbers({{"count", 14}, {"size", std::size_t{3}}, {"word", "red"}});
    book.check("{half}, {third}, {count}, {size}, {word}.", true);
    CHECK(contains(terminal.str(), "0.50, 0.33, 14, 3, red."));
    CHECK_THROWS_AS(book.numbers(1, {{"other", 1}, {"half", 1}}), UsageError);
}

TEST_CASE("mistakes of a chapter are named") {
    const ScratchDirectory scratch;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(notebook_options_in(scratch), notebook_source("01_test", ""), terminal, answers);
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
    NotebookOptions nowhere = notebook_options_in(scratch);
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
