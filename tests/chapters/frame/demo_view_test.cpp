#include "chapters/frame/demo_view.h"

#include <doctest/doctest.h>

#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

Frame frame_of(const std::vector<std::string>& params, const char* method, Size size) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, params);
    const Scene scene = cornell_scene();
    return render_frame(scene, scene.camera, request);
}

}  // namespace

TEST_CASE("demo view: the lit picture, and over its lower right quarter the AO map, texel for texel") {
    for (const Size size : {Size{64, 36}, Size{65, 37}}) {
        CAPTURE(size.width);
        const Frame frame = frame_of({}, "xjun", size);
        const Picture lit = lit_picture(frame.lit), ao = ao_picture(frame.ao_blurred),
                      plain = demo_view(frame, false), view = demo_view(frame, true);
        CHECK(plain.pixels == lit.pixels);
        REQUIRE(view.pixels.size() == lit.pixels.size());
        CHECK(view.mapping.find("accessibility") != std::string::npos);
        const int left = size.width - size.width / 2, top = size.height - size.height / 2;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                const auto at = static_cast<std::size_t>(3 * (y * size.width + x));
                const bool inside = x >= left && y >= top;
                // The map has as many texels as the quad or one more.
                const auto texel =
                    static_cast<std::size_t>((y - top) * ao.size.height / (size.height / 2) * ao.size.width +
                                             (x - left) * ao.size.width / (size.width / 2));
                for (std::size_t c = 0; c < 3; ++c)
                    CHECK(view.pixels[at + c] == (inside ? ao.pixels[texel] : lit.pixels[at + c]));
            }
        }
    }
}

TEST_CASE("demo view: the raw map where nothing is blurred, white where there is no map") {
    const Frame raw = frame_of({"blur_iterations=0"}, "xjun", {32, 18}),
                none = frame_of({}, "none", {32, 18});
    const auto last = [](const Picture& p) { return p.pixels[p.pixels.size() - 1]; };
    CHECK(last(demo_view(raw, true)) == last(ao_picture(raw.ao_raw)));
    CHECK(last(demo_view(none, true)) == 255);
    CHECK(demo_view(none, true).pixels.size() == 3 * 32 * 18);
}
