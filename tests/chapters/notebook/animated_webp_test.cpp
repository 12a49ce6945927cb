// Films as the container's own chunks tell: https://developers.google.com/speed/webp/docs/riff_container
#include "chapters/notebook/animated_webp.h"

#include <doctest/doctest.h>

#include <cstdint>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

std::uint32_t little_endian(const std::string& bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = count - 1; i >= 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    return value;
}

struct Container {
    int width = 0, height = 0, loops = -1;
    std::vector<int> durations_ms;
};

Container read(const std::string& webp) {
    REQUIRE(webp.substr(0, 4) == "RIFF");
    REQUIRE(webp.substr(8, 4) == "WEBP");
    REQUIRE(little_endian(webp, 4, 4) + 8 == webp.size());
    Container found;
    for (std::size_t at = 12; at + 8 <= webp.size();) {
        const std::string kind = webp.substr(at, 4);
        const std::size_t size = little_endian(webp, at + 4, 4), content = at + 8;
        if (kind == "VP8X") {
            found.width = static_cast<int>(little_endian(webp, content + 4, 3)) + 1;
            found.height = static_cast<int>(little_endian(webp, content + 7, 3)) + 1;
        }
        if (kind == "ANIM") found.loops = static_cast<int>(little_endian(webp, content + 4, 2));
        if (kind == "ANMF")
            found.durations_ms.push_back(static_cast<int>(little_endian(webp, content + 12, 3)));
        at = content + size + size % 2;
    }
    return found;
}

}  // namespace

TEST_CASE("animated WebP: every frame, its time and its size, over and over; the same bytes each time") {
    std::vector<Picture> frames;
    for (const float value : {0.0f, 0.5f, 1.0f}) frames.push_back(ao_picture(Image<float>({21, 9}, value)));
    const std::optional<std::string> webp = animated_webp(frames, 250);
    if (!webp) {
        MESSAGE("built without libwebp");
        return;
    }
    const Container found = read(*webp);
    CHECK(found.width == 21);
    CHECK(found.height == 9);
    CHECK(found.loops == 0);
    CHECK(found.durations_ms == std::vector<int>{250, 250, 250});
    CHECK(*animated_webp(frames, 250) == *webp);
    frames.push_back(ao_picture(Image<float>({20, 9}, 1.0f)));
    CHECK_THROWS_AS(animated_webp(frames, 250), OutputError);
}
