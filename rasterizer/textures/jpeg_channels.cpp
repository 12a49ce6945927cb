#include "rasterizer/textures/jpeg_channels.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace crevice {
namespace {

using namespace std::string_view_literals;

constexpr unsigned kScanMarker = 0xda;

unsigned byte_of(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0u;
}

struct Segment {
    unsigned marker;
    std::size_t begin;  // of its content, behind marker and length
    std::string_view content;
};

// Those with a length, in their order; coded data and restart markers between them are passed over.
std::vector<Segment> segments_of(std::string_view jpeg) {
    std::vector<Segment> segments;
    std::size_t at = 2;
    while (at + 4 <= jpeg.size()) {
        const unsigned marker = byte_of(jpeg, at + 1);
        const bool is_segment = byte_of(jpeg, at) == 0xff && marker >= 0xc0 && marker != 0xff &&
                                !(marker >= 0xd0 && marker <= 0xd9);
        if (!is_segment) {
            ++at;
            continue;
        }
        const std::size_t length = byte_of(jpeg, at + 2) << 8 | byte_of(jpeg, at + 3);
        if (length < 2 || at + 2 + length > jpeg.size()) break;
        segments.push_back({marker, at + 4, jpeg.substr(at + 4, length - 2)});
        at += 2 + length;
    }
    return segments;
}

// Baseline and progressive frames, which alone are read here.
bool is_frame(unsigned marker) { return marker >= 0xc0 && marker <= 0xc2; }

// Where the names of the channels stand, if they are three: in the frame every third byte from the seventh on, in a scan
// every second from the second on.
std::vector<std::size_t> names_in(const Segment& segment) {
    const bool frame = is_frame(segment.marker);
    const std::size_t first = frame ? 6 : 1, step = frame ? 3 : 2;
    const std::size_t count = byte_of(segment.content, first - 1);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count && first + i * step < segment.content.size(); ++i)
        places.push_back(segment.begin + first + i * step);
    return places;
}

bool says_ycbcr(const Segment& segment) {
    constexpr unsigned kJfif = 0xe0, kAdobe = 0xee;
    constexpr std::size_t kTransform = 11;
    if (segment.marker == kJfif) return segment.content.starts_with("JFIF\0"sv);
    return segment.marker == kAdobe && segment.content.starts_with("Adobe"sv) &&
           byte_of(segment.content, kTransform) != 0;
}

}  // namespace

std::string with_channels_as_marked(std::string jpeg) {
    constexpr std::string_view kColours = "RGB";
    bool marked = false, named = false;
    const std::vector<Segment> segments = segments_of(jpeg);
    for (const Segment& segment : segments) {
        marked = marked || says_ycbcr(segment);
        if (!is_frame(segment.marker)) continue;
        std::string names;
        for (const std::size_t at : names_in(segment)) names += jpeg[at];
        named = names == kColours;
    }
    if (!marked || !named) return jpeg;
    std::string numbered = jpeg;
    for (const Segment& segment : segments) {
        if (!is_frame(segment.marker) && segment.marker != kScanMarker) continue;
        for (const std::size_t at : names_in(segment)) {
            const std::size_t channel = kColours.find(jpeg[at]);
            if (channel != std::string_view::npos) numbered[at] = static_cast<char>(channel + 1);
        }
    }
    return numbered;
}

}  // namespace crevice
