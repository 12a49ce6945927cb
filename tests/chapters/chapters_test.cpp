// Every chapter of this program at a small size: its claims hold, its pictures are on disk, and a second run
// writes the same bytes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "chapters/notebook/chapter.h"
#include "rasterizer/base/image_io.h"
#include "tests/tools/bytes_in.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

constexpr Size kSmall = {160, 90};

// Other tests register chapters of their own, some meant to fail; those are numbered from 90 on.
std::vector<const Chapter*> real_chapters() {
    std::vector<const Chapter*> real;
    for (const Chapter* chapter : all_chapters()) {
        if (std::atoi(chapter->number) < 90) real.push_back(chapter);
    }
    return real;
}

struct ChapterRun {
    std::string terminal;
    std::vector<NotebookCell> cells;
    int checks = 0, failed_checks = 0;
    std::vector<std::string> untranslated;
    std::map<std::string, std::string> files;  // name to bytes
};

ChapterRun run_small(const Chapter& chapter, std::uint32_t seed = 1) {
    const ScratchDirectory scratch;
    NotebookOptions options;
    options.out = scratch.path();
    options.size = kSmall;
    options.quiet = true;
    options.seed = seed;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options, chapter.source(), terminal, answers);
    chapter.run(book);
    book.finish();
    book.write_files();
    ChapterRun run{terminal.str(),       book.cells(),        book.checks(),
                   book.failed_checks(), book.untranslated(), {}};
    for (const auto& entry : std::filesystem::directory_iterator(scratch / chapter.name())) {
        run.files[entry.path().filename().string()] = bytes_in(entry.path());
    }
    return run;
}

std::vector<const NotebookPicture*> pictures_of(const ChapterRun& run) {
    std::vector<const NotebookPicture*> pictures;
    for (const NotebookCell& cell : run.cells) {
        for (const Output& output : cell.outputs) {
            const auto* row = std::get_if<PictureOutput>(&output);
            if (row == nullptr) continue;
            for (const NotebookPicture& picture : row->pictures) pictures.push_back(&picture);
        }
    }
    return pictures;
}

bool same_values(const Planes& a, const Planes& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (int y = 0; y < a[c].size.height; ++y) {
            if (!std::equal(a[c].row(y), a[c].row(y) + a[c].size.width, b[c].row(y))) return false;
        }
    }
    return true;
}

// NAME.md and NAME.ipynb, in each language that there is.
std::size_t files_of_texts(const ChapterRun& run) {
    std::size_t count = 0;
    for (const auto& [name, bytes] : run.files)
        count += name.ends_with(".md") || name.ends_with(".ipynb") ? 1 : 0;
    return count;
}

// The first run of a chapter, which several tests look at.
const ChapterRun& first_run(const Chapter& chapter) {
    static std::map<std::string, ChapterRun> runs;
    const auto found = runs.find(chapter.name());
    return found != runs.end() ? found->second
                               : runs.emplace(chapter.name(), run_small(chapter)).first->second;
}

}  // namespace

TEST_CASE("chapters: each number and topic is there once") {
    const std::vector<const Chapter*> chapters = real_chapters();
    REQUIRE(!chapters.empty());
    for (std::size_t i = 1; i < chapters.size(); ++i) {
        CAPTURE(chapters[i]->name());
        CHECK(std::string(chapters[i - 1]->number) < chapters[i]->number);
        for (std::size_t j = 0; j < i; ++j) CHECK(std::string(chapters[j]->topic) != chapters[i]->topic);
    }
}

TEST_CASE("chapters: every claim holds, every picture is on disk, quiet says nothing") {
    for (const Chapter* chapter : real_chapters()) {
        const ChapterRun& run = first_run(*chapter);
        CAPTURE(chapter->name());
        CHECK(run.terminal == "");
        CHECK(run.checks > 0);
        CHECK(run.failed_checks == 0);
        std::size_t pictures = 0, drawings = 0, films = 0;
        for (const NotebookCell& cell : run.cells) {
            for (const Output& output : cell.outputs) {
                if (const auto* drawing = std::get_if<DrawingOutput>(&output)) {
                    ++drawings;
                    CHECK(!drawing->caption.empty());
                    CAPTURE(drawing->name);
                    REQUIRE(run.files.contains(drawing->name + ".svg"));
                    CHECK(xml_fault(run.files.at(drawing->name + ".svg")) == "");
                }
                if (const auto* film = std::get_if<FilmOutput>(&output)) {
                    ++films;
                    CAPTURE(film->name);
                    REQUIRE(run.files.contains(film->name + ".webp"));
                    const bool on_disk = run.files.at(film->name + ".webp") == film->webp;
                    CHECK(on_disk);
                }
                const auto* row = std::get_if<PictureOutput>(&output);
                if (row == nullptr) continue;
                for (const NotebookPicture& picture : row->pictures) {
                    CAPTURE(picture.name);
                    ++pictures;
                    CHECK(!(row->caption.empty() && picture.caption.empty()));
                    REQUIRE(run.files.contains(picture.name + ".png"));
                    const bool on_disk = run.files.at(picture.name + ".png") == picture.png;
                    CHECK(on_disk);
                }
            }
        }
        CHECK(pictures > 0);
        CHECK(run.files.contains(chapter->name() + ".md"));
        CHECK(run.files.contains(chapter->name() + ".ipynb"));
        CHECK(run.files.size() == pictures + drawings + films + files_of_texts(run));
    }
}

TEST_CASE("chapters: each has a question, exercises with answers, and says where to go on") {
    for (const Chapter* chapter : real_chapters()) {
        CAPTURE(chapter->name());
        std::string prose = "\n";
        for (const NotebookCell& cell : first_run(*chapter).cells) prose += cell.prose.en + "\n";
        CHECK(prose.find("\n# ") != std::string::npos);
        for (const char* part : {"## Exercises", "<summary>Answers</summary>", "## Where to go on"}) {
            CAPTURE(part);
            CHECK(prose.find(part) != std::string::npos);
        }
    }
}

TEST_CASE("chapters: what has a Chinese translation has all of it, made from the present English") {
    for (const Chapter* chapter : real_chapters()) {
        if (chapter->source().chinese.cells.empty()) continue;
        const ChapterRun& run = first_run(*chapter);
        std::string missing;
        for (const std::string& heading : run.untranslated) missing += heading + "\n";
        INFO("chapters/zh/" << chapter->name() << ".md lacks\n" << missing);
        CHECK(run.untranslated.empty());
        CHECK(!chapter->book_title().zh.empty());
    }
}

TEST_CASE("chapters: a picture that leads into the lab is what its command draws") {
    const ScratchDirectory scratch;
    int compared = 0;
    for (const Chapter* chapter : real_chapters()) {
        for (const NotebookPicture* picture : pictures_of(first_run(*chapter))) {
            const std::string prefix = "crevice ", &command = picture->command;
            if (!command.starts_with(prefix + "render ")) continue;
            CAPTURE(chapter->name());
            CAPTURE(picture->name);
            CAPTURE(command);
            const std::string buffer = command.substr(command.rfind(' ') + 1);
            const Outcome drawn =
                crevice_says(command.substr(prefix.size()) + " --out " + scratch.path().string());
            REQUIRE_MESSAGE(drawn.code == 0, drawn.text);
            const Planes values = read_npy(scratch / (buffer + ".npy"));
            // A part of the map, or the map at the picture's size, says less.
            if (values.front().size != picture->picture.size) continue;
            // Lit pictures keep no values beside their colours.
            const bool same = picture->picture.values.empty()
                                  ? bytes_in(scratch / (buffer + ".png")) == picture->png
                                  : same_values(picture->picture.values, values);
            CHECK(same);
            ++compared;
        }
    }
    CHECK(compared > 40);
}

TEST_CASE("chapters: two runs write the same bytes") {
    for (const Chapter* chapter : real_chapters()) {
        const ChapterRun &first = first_run(*chapter), second = run_small(*chapter);
        CAPTURE(chapter->name());
        CHECK(first.files.size() == second.files.size());
        for (const auto& file : first.files) {
            CAPTURE(file.first);
            REQUIRE(second.files.contains(file.first));
            // Not compared inside CHECK, which would print both files.
            const bool same = second.files.at(file.first) == file.second;
            CHECK(same);
        }
    }
}

TEST_CASE("chapters: claims do not hang on the seed") {
    for (const Chapter* chapter : real_chapters()) {
        CAPTURE(chapter->name());
        const ChapterRun run = run_small(*chapter, 77);
        CAPTURE(run.terminal);
        CHECK(run.failed_checks == 0);
    }
}
