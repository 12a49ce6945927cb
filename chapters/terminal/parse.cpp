#include "chapters/terminal/parse.h"

#include <charconv>
#include <cmath>
#include <cstdint>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/memory.h"

namespace crevice {

namespace {

// What the buffers of a frame take at least.
constexpr std::uintmax_t kFrameBytesPerPixel = 64;

// The whole word, or nothing.
bool is_whole(const std::string& word, std::from_chars_result read) {
    return read.ec == std::errc() && read.ptr == word.data() + word.size() && !word.empty();
}
bool reads_as(const std::string& word, double& value) {
    return is_whole(word, number_from_text(word.data(), word.data() + word.size(), value));
}
template <class Whole>
bool reads_as(const std::string& word, Whole& value) {
    return is_whole(word, std::from_chars(word.data(), word.data() + word.size(), value));
}

}  // namespace

double parse_number(const std::string& flag, const std::string& word) {
    // ".5" it reads, "+5" it does not, on purpose.
    double value = 0;
    if (!reads_as(word, value) || !std::isfinite(value)) {
        throw UsageError(flag + ": not a finite number (" + word + "); write it like 0.5 or 1e-3");
    }
    return value;
}

long long parse_whole(const std::string& flag, const std::string& word, long long lowest, long long highest) {
    long long value = 0;
    if (!reads_as(word, value) || value < lowest || value > highest) {
        throw UsageError(flag + ": not a whole number in " + std::to_string(lowest) + ".." +
                         std::to_string(highest) + " (" + word + "); choose one");
    }
    return value;
}

bool parse_yes_no(const std::string& flag, const std::string& word) {
    if (word == "true" || word == "1") return true;
    if (word == "false" || word == "0") return false;
    throw UsageError(flag + ": neither true nor false (" + word + "); write one of them");
}

glm::dvec3 parse_point(const std::string& flag, const std::string& word) {
    const std::size_t first = word.find(','),
                      second = first == std::string::npos ? first : word.find(',', first + 1);
    if (second == std::string::npos)
        throw UsageError(flag + ": not three numbers (" + word + "); write x,y,z");
    return {parse_number(flag, word.substr(0, first)),
            parse_number(flag, word.substr(first + 1, second - first - 1)),
            parse_number(flag, word.substr(second + 1))};
}

glm::ivec2 parse_pixel(const std::string& flag, const std::string& word) {
    const std::size_t comma = word.find(',');
    glm::ivec2 pixel(0);
    if (comma == std::string::npos || !reads_as(word.substr(0, comma), pixel.x) ||
        !reads_as(word.substr(comma + 1), pixel.y))
        throw UsageError(flag + ": not a pixel (" + word + "); write x,y");
    return pixel;
}

Size parse_size(const std::string& flag, const std::string& word) {
    const std::size_t cross = word.find('x');
    int width = 0, height = 0;
    if (cross == std::string::npos || !reads_as(word.substr(0, cross), width) ||
        !reads_as(word.substr(cross + 1), height) || width < 1 || height < 1) {
        throw UsageError(flag + ": not a size in pixels (" + word + "); write it like 1280x720");
    }
    constexpr long long kMostPixels = 1LL << 28;
    if (width > kLargestSide || height > kLargestSide ||
        static_cast<long long>(width) * height > kMostPixels) {
        throw UsageError(flag + ": too large (" + word + "); a side has at most " +
                         std::to_string(kLargestSide) + " pixels, a picture at most " +
                         std::to_string(kMostPixels));
    }
    const auto bytes =
        static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height) * kFrameBytesPerPixel;
    if (bytes > memory_bytes()) {
        throw UsageError(flag + ": too large for this machine's memory (" + word + " takes " +
                         std::to_string(bytes) + " bytes or more, " + std::to_string(memory_bytes()) +
                         " are there); choose fewer pixels");
    }
    return {width, height};
}

}  // namespace crevice
