// One term has one word in Chinese: what chapters/zh/glossary.md lists as not used stands nowhere in the book or the lab.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    REQUIRE_MESSAGE(stream, file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        parts.push_back(text.substr(from, at - from));
        from = at + separator.size();
    }
    parts.push_back(text.substr(from));
    return parts;
}

// The last column of the glossary's table, word by word.
std::vector<std::string> words_not_used() {
    std::vector<std::string> words;
    for (const std::string& line : split(text_of(CREVICE_CHAPTERS_DIR "/zh/glossary.md"), "\n")) {
        const std::vector<std::string> columns = split(line, "|");
        if (columns.size() != 6 || columns[1] == " English ") continue;
        for (std::string word : split(columns[4], "、")) {
            std::erase(word, ' ');
            if (!word.empty() && word != "---") words.push_back(word);
        }
    }
    return words;
}

}  // namespace

TEST_CASE("glossary: no word that it rules out stands in the Chinese of the book or the lab") {
    const std::vector<std::string> words = words_not_used();
    REQUIRE(words.size() > 30);
    int files = 0;
    for (const char* folder : {CREVICE_CHAPTERS_DIR "/zh", CREVICE_CHAPTERS_DIR "/lab/page"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().filename() == "glossary.md") continue;
            ++files;
            const std::string text = text_of(entry.path());
            for (const std::string& word : words) {
                INFO(entry.path().string()
                     << ": " << word << "; chapters/zh/glossary.md has the word to use");
                CHECK(text.find(word) == std::string::npos);
            }
        }
    }
    CHECK(files > 24);
}
