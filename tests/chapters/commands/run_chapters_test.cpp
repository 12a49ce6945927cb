#include "chapters/commands/run_chapters.h"

#include <iostream>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/commands/notebook_flags.h"
#include "rasterizer/base/error.h"
#include "tests/tools/bytes_in.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

NotebookOptions options_in(const ScratchDirectory& scratch) {
    NotebookOptions options;
    options.out = scratch.path();
    return options;
}

void passing(Notebook& book) { book.check("one is one", true); }
void failing(Notebook& book) { book.check("one is two", false, "1 and 2"); }
void throwing(Notebook& book) {
    book.check("before", true);
    throw InputError("scene.obj:3: no such vertex (9); check it");
}
void silent(Notebook&) {}

// A Chapter registers itself, so these have numbers that no real chapter has.
const Chapter kPassing("95", "passing", "Passing & good", passing);
const Chapter kThrowing("96", "throwing", "Throwing", throwing);
const Chapter kFailing("97", "failing", "Failing", failing);
const Chapter kSilent("98", "silent", "Silent", silent);

// What `call` prints to std::cout.
template <class Call>
std::string printed(Call call) {
    std::ostringstream text;
    std::streambuf* const before = std::cout.rdbuf(text.rdbuf());
    call();
    std::cout.rdbuf(before);
    return text.str();
}

}  // namespace

TEST_CASE("chapters: one that throws is a failed check, the others go on, the last line is the page") {
    const ScratchDirectory scratch;
    const NotebookOptions options = options_in(scratch);
    int code = -1;
    const Chapter* const all[] = {&kPassing, &kThrowing, &kFailing, &kSilent};
    const std::string text = printed([&] { code = run_chapters(all, options); });
    CHECK(code == 1);
    CHECK(contains(text,
                   "✗ chapter 96_throwing runs to its end  (scene.obj:3: no such vertex (9); check it)\n"));
    CHECK(contains(text, "✗ one is two  (1 and 2)\n"));
    CHECK(contains(text, "✗ chapter 98_silent writes something\n"));
    CHECK(contains(text, "failed: 96_throwing (1) 97_failing (1) 98_silent (1)\n"));
    CHECK(text.ends_with((scratch / "index.html").string() + "\n"));
    const std::string page = bytes_in(scratch / "index.html");
    CHECK(contains(page, "Passing &amp; good"));
    CHECK(contains(page, "href=\"97_failing.html\""));
    CHECK(contains(page, "Failing <span class=\"bad\">✗ 1</span>"));
    CHECK(contains(bytes_in(scratch / "97_failing.html"), "one is two"));
    const Chapter* const good[] = {&kPassing};
    printed([&] { code = run_chapters(good, options); });
    CHECK(code == 0);
    const Chapter* const bad[] = {&kPassing, &kFailing};
    printed([&] { code = run_chapters(bad, options); });
    CHECK(code == 1);
}

TEST_CASE("chapters: running one leaves the pages of the others, and the index names all that are there") {
    const ScratchDirectory scratch;
    const NotebookOptions options = options_in(scratch);
    const Chapter *const first[] = {&kFailing}, *const second[] = {&kPassing};
    printed([&] { run_chapters(first, options); });
    const std::string before = bytes_in(scratch / "97_failing.html");
    printed([&] { run_chapters(second, options); });
    CHECK(bytes_in(scratch / "97_failing.html") == before);
    const std::string index = bytes_in(scratch / "index.html");
    CHECK(contains(index, "href=\"95_passing.html\""));
    CHECK(contains(index, "href=\"97_failing.html\""));
    CHECK(!contains(index, "href=\"98_silent.html\""));
}

TEST_CASE("chapters: of one cell alone there is no page; a changed parameter does not fail a claim") {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    const Chapter* const failing_alone[] = {&kFailing};
    options.words = {"radius=2"};
    int code = -1;
    printed([&] { code = run_chapters(failing_alone, options); });
    CHECK(code == 0);
    options.words.clear();
    options.cell = "all";
    const ScratchDirectory elsewhere;
    options.out = elsewhere.path();
    printed([&] { code = run_chapters(failing_alone, options); });
    CHECK(code == 1);
    CHECK(!std::filesystem::exists(elsewhere / "97_failing.html"));
    CHECK(!std::filesystem::exists(elsewhere / "index.html"));
}

TEST_CASE("chapters: one that breaks off has failed, with a changed parameter, too") {
    const ScratchDirectory scratch;
    NotebookOptions options = options_in(scratch);
    const Chapter* const throwing_alone[] = {&kThrowing};
    options.words = {"radius=2"};
    int code = -1;
    printed([&] { code = run_chapters(throwing_alone, options); });
    CHECK(code == 1);
}

TEST_CASE("chapters: a scene or a parameter that no chapter can know is a mistake of usage") {
    NotebookWords words;
    words.scene = "column";
    CHECK(contains(message_of<UsageError>([&] { notebook_options_of(words); }), "did you mean columns?"));
    words.scene = "cornell";
    words.parameters = {"radius=0.4", "thickness=1", "fade_start=3"};
    CHECK(notebook_options_of(words).words.size() == 3);
    words.parameters.push_back("nonsense=1");
    CHECK(contains(message_of<UsageError>([&] { notebook_options_of(words); }), "(nonsense=1)"));
}

TEST_CASE("chapters: stepping through, a parameter that is refused is taken back, and the reader goes on") {
    const ScratchDirectory scratch;
    const Outcome outcome =
        crevice_says("chapter 07 --size 64x36 --step --lang en --out '" + scratch.path().string() + "'; }",
                     "{ printf '\\nset nonsense=1\\nset epsilon=0\\n\\nq\\n' | ");
    CAPTURE(outcome.text);
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.text, "(nonsense); give one of"));
    CHECK(contains(outcome.text, "; taken back\n"));
    CHECK(!contains(outcome.text, "runs to its end"));
}

TEST_CASE("chapters: chosen by number, topic or name; an unknown one lists what there is") {
    for (const char* which : {"95", "passing", "95_passing"}) {
        CAPTURE(which);
        const auto chosen = chosen_chapters(which);
        REQUIRE(chosen.size() == 1);
        CHECK(chosen[0] == &kPassing);
    }
    const auto all = chosen_chapters("all");
    CHECK(all.size() >= 4);
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1]->name() < all[i]->name());
    for (const char* which : {"", "42", "90", "95x", "ALL"}) {
        CAPTURE(which);
        std::string message;
        try {
            chosen_chapters(which);
        } catch (const UsageError& error) {
            message = error.what();
        }
        CHECK(contains(message, std::string("(") + which + ")"));
        CHECK(contains(message, "95_passing"));
    }
}
