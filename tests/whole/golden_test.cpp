// Every buffer of every built-in scene, and each artifact on purpose, against the one on record. The gate is
// the hash of the raw values, on every compiler and machine; the .npy beside it only serves to show what
// changed.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/compare/difference_page.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/lanes/wide.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/golden_options.h"
#include "tests/tools/scratch_directory.h"
#include "tests/whole/golden_buffers.h"

using namespace crevice;

namespace {

constexpr const char* kReport = "golden-report.html";
constexpr const char* kAccept = "crevice_tests --source-file=*golden_test.cpp --bless";

std::string hash_of_planes(const Planes& planes) {
    if (planes.size() == 1) return content_hash(planes[0]);
    Image3 image;
    image.x = planes[0], image.y = planes[1], image.z = planes[2];
    return content_hash(image);
}

// hashes.txt: a line "scene buffer hash" for each buffer, sorted.
using Hashes = std::map<std::string, std::string>;
Hashes read_hashes(const std::filesystem::path& directory) {
    Hashes hashes;
    std::ifstream file(directory / "hashes.txt");
    for (std::string scene, buffer, hash; file >> scene >> buffer >> hash;)
        hashes[scene + " " + buffer] = hash;
    return hashes;
}

std::size_t count_nan(const Planes& planes) {
    std::size_t count = 0;
    for (const Image<float>& plane : planes) count += static_cast<std::size_t>(buffer_statistics(plane).nan);
    return count;
}

std::string first_difference(const GoldenBuffer& actual, const Planes& expected) {
    const auto differing = first_differing_pixels(actual.values, expected, SIZE_MAX);
    const PixelPosition at = differing.front();
    const auto text = [&](const Planes& planes) {
        std::string values;
        for (const Image<float>& plane : planes) values += " " + exact_text(plane.at(at.x, at.y));
        return values;
    };
    return "pixel (" + std::to_string(at.x) + ", " + std::to_string(at.y) + ") is" + text(actual.values) +
           ", expected" + text(expected) + "; " + std::to_string(differing.size()) + " pixels differ";
}

// What is wrong with one buffer, "" for nothing, and the golden values where there are any.
struct Verdict {
    std::string complaint;
    Planes expected;
};
Verdict verdict_on(const GoldenBuffer& actual, const Hashes& hashes, const std::filesystem::path& directory) {
    Verdict verdict;
    const auto recorded = hashes.find(actual.name());
    try {
        verdict.expected = read_npy(actual.file(directory));
    } catch (const InputError& error) {
        verdict.complaint = std::string("no golden image: ") + error.what();
        return verdict;
    }
    const Planes& expected = verdict.expected;
    if (recorded == hashes.end()) {
        verdict.complaint = "no golden hash in hashes.txt";
    } else if (hash_of_planes(expected) != recorded->second) {
        verdict.complaint = "the golden image is not the one of hashes.txt";
    } else if (const std::size_t nan = count_nan(actual.values); nan > 0) {
        verdict.complaint = std::to_string(nan) + " values are NaN";
    } else if (expected.size() != actual.values.size() || expected[0].size != actual.values[0].size) {
        const Size is = actual.values[0].size, was = expected[0].size;
        verdict.complaint = "its size is " + std::to_string(is.width) + "x" + std::to_string(is.height) +
                            ", expected " + std::to_string(was.width) + "x" + std::to_string(was.height);
    } else if (hash_of_planes(actual.values) != recorded->second) {
        verdict.complaint = first_difference(actual, expected);
    }
    return verdict;
}

void bless(const std::vector<GoldenBuffer>& buffers, const std::filesystem::path& directory) {
    std::set<std::filesystem::path> written;
    std::set<std::string> lines;
    for (const GoldenBuffer& buffer : buffers) {
        if (count_nan(buffer.values) > 0)
            throw InputError(buffer.name() + ": has NaN and cannot be blessed; mend it first");
        const std::filesystem::path file = buffer.file(directory);
        std::filesystem::create_directories(file.parent_path());
        if (buffer.values.size() == 1) {
            write_npy(file, buffer.values[0]);
        } else {
            Image3 image;
            image.x = buffer.values[0], image.y = buffer.values[1], image.z = buffer.values[2];
            write_npy(file, image);
        }
        written.insert(file.lexically_normal());
        lines.insert(buffer.name() + " " + hash_of_planes(buffer.values) + "\n");
    }
    std::string text;
    for (const std::string& line : lines) text += line;
    write_file_atomically(directory / "hashes.txt", text);
    // What no scene draws any more.
    std::vector<std::filesystem::path> stale;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
        const std::filesystem::path path = entry.path().lexically_normal();
        if (path.extension() == ".npy" && !written.contains(path)) stale.push_back(path);
    }
    for (const std::filesystem::path& path : stale) std::filesystem::remove(path);
}

// The failures, and one page that shows them.
std::string report_on(const std::vector<GoldenBuffer>& buffers, const std::filesystem::path& directory) {
    Hashes hashes = read_hashes(directory);
    std::string text;
    std::vector<DifferenceEntry> entries;
    for (const GoldenBuffer& buffer : buffers) {
        const Verdict verdict = verdict_on(buffer, hashes, directory);
        hashes.erase(buffer.name());
        if (verdict.complaint.empty()) continue;
        text += buffer.name() + ": " + verdict.complaint + "\n  to replay: " + buffer.replay() + "\n";
        entries.push_back(
            {buffer.name(), buffer.values, verdict.expected, verdict.complaint, buffer.buffer == "lit"});
    }
    for (const auto& [name, hash] : hashes) text += name + ": hashes.txt has it, but nothing draws it\n";
    std::filesystem::remove(kReport);
    if (entries.empty()) return text;
    write_file_atomically(kReport, difference_page(entries, {"Golden images", "actual", "expected"}));
    return text + "pictures: " + std::filesystem::absolute(kReport).string() + "\nto accept: " + kAccept +
           "\n";
}

}  // namespace

TEST_CASE("golden: every buffer of every built-in scene has the bits on record") {
    const std::vector<GoldenBuffer> buffers = golden_buffers();
    REQUIRE(buffers.size() > 10 * builtin_scenes().size());
    std::set<std::string> names;
    for (const GoldenBuffer& buffer : buffers) names.insert(buffer.name());
    REQUIRE(names.size() == buffers.size());
    const GoldenOptions& options = golden_options();
    if (options.bless) {
        bless(buffers, options.directory);
        std::cout << buffers.size() << " golden images written to " << options.directory.string() << "\n";
    }
    const std::string failures = report_on(buffers, options.directory);
    INFO(failures);
    CHECK(failures.empty());
}

TEST_CASE("golden: the gate sees one bit, a missing image, another size and NaN") {
    const ScratchDirectory directory;
    Image<float> image({5, 4}, 0.25f);
    image.at(2, 1) = 0.75f;
    GoldenBuffer buffer{"scene", "ao_raw", "xjun", planes_of(image)};
    const auto complaint = [&] {
        return verdict_on(buffer, read_hashes(directory.path()), directory.path()).complaint;
    };
    CHECK(complaint().find("no golden image") == 0);
    bless({buffer}, directory.path());
    CHECK(complaint() == "");

    buffer.values[0].at(3, 2) = float_from_bits(float_bits(0.25f) + 1);
    CHECK(complaint().find("pixel (3, 2) is 0.25000003, expected 0.25; 1 pixels differ") == 0);
    buffer.values[0].at(3, 2) = std::numeric_limits<float>::quiet_NaN();
    CHECK(complaint() == "1 values are NaN");
    CHECK_THROWS_AS(bless({buffer}, directory.path()), InputError);
    buffer.values = planes_of(Image<float>({4, 5}, 0.25f));
    CHECK(complaint() == "its size is 4x5, expected 5x4");
    buffer.values = planes_of(Image3({5, 4}, glm::vec3(0.25f)));
    CHECK(complaint().find("its size") == 0);

    // An image that was changed without its hash, and a hash without its image.
    buffer.values = planes_of(image);
    write_npy(buffer.file(directory.path()), Image<float>({5, 4}, 0.5f));
    CHECK(complaint() == "the golden image is not the one of hashes.txt");
    write_npy(buffer.file(directory.path()), image);
    CHECK(complaint() == "");
    write_file_atomically(directory / "hashes.txt", "");
    CHECK(complaint() == "no golden hash in hashes.txt");
}

TEST_CASE("golden: blessing removes what no scene draws any more") {
    const ScratchDirectory directory;
    const Planes values = planes_of(Image<float>({2, 2}, 1));
    const GoldenBuffer first{"scene", "ao_raw", "xjun", values}, second{"other", "lit", "xjun", values};
    bless({first, second}, directory.path());
    CHECK(read_hashes(directory.path()).size() == 2);
    bless({first}, directory.path());
    CHECK(read_hashes(directory.path()).size() == 1);
    CHECK(!std::filesystem::exists(second.file(directory.path())));
    CHECK(std::filesystem::exists(first.file(directory.path())));
}
