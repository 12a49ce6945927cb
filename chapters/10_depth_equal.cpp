// Question: the second pass tests depths for EQUAL. What if another formula, just as right, computes them?
//
// The one idea: floats round after every step, so x(WVP) and (x(WV))P differ in the last bits. EQUAL forgives
// none of them: where the passes disagree, no surface is lit and the background shows through.
//
// Source: seed 000, "Different computations make depths unequal", whose two passes do exactly this.
// Look for: magenta, which is what the background is painted in here; the bars, most of which are not at 0.
// Run: crevice chapter 10
#include <algorithm>
#include <chrono>
#include <cmath>

#include "chapters/chapter.h"
#include "rasterizer/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "ssao/shade.h"

namespace crevice {
namespace {

constexpr PositionOrder kFirstPass = PositionOrder::view_first, kSecondPass = PositionOrder::premultiplied;
constexpr glm::vec3 kMagenta(1, 0, 1);
constexpr int kBars = 9;  // differences of -9 to 9 steps have a bar; the outer two hold all beyond

std::string percent(double share) {
    return exact_text(static_cast<float>(std::round(1e5 * share) / 1e3)) + " %";
}

// The share of the pixels showing a surface for which holds(x, y).
double share_of_surface(const Image<float>& view_depth, const auto& holds) {
    double surface = 0, counted = 0;
    for (int i = 0; i < view_depth.size.width * view_depth.size.height; ++i) {
        const int x = i % view_depth.size.width, y = i / view_depth.size.width;
        if (std::isinf(view_depth.at(x, y))) continue;
        surface += 1;
        if (holds(x, y)) counted += 1;
    }
    return counted / surface;
}

double holes_in(const Image3& lit, const Image<float>& view_depth) {
    return share_of_surface(view_depth, [&](int x, int y) { return lit.at(x, y) == kMagenta; });
}

double wrong_in(const Image3& lit, const Image3& right, const Image<float>& view_depth) {
    return share_of_surface(view_depth, [&](int x, int y) {
        const glm::vec3 off = lit.at(x, y) - right.at(x, y);
        return lit.at(x, y) != kMagenta && std::fabs(off.x) + std::fabs(off.y) + std::fabs(off.z) > 0.02f;
    });
}

// Depth of the second pass minus that of the first, in steps of the format: how often each occurs.
std::vector<double> differences(const Scene& scene, const Camera& camera, Size size, DepthFormat format) {
    NormalDepthSettings settings{.depth_format = format, .position_order = kFirstPass};
    const GBuffer first = normal_depth(scene, camera, size, settings);
    settings.position_order = kSecondPass;
    const GBuffer second = normal_depth(scene, camera, size, settings);
    std::vector<double> shares;
    for (int bar = -kBars; bar <= kBars; ++bar) {
        shares.push_back(share_of_surface(first.view_depth, [&](int x, int y) {
            return std::clamp(second.depth.codes.at(x, y) - first.depth.codes.at(x, y), -kBars, kBars) == bar;
        }));
    }
    return shares;
}

Picture bars(const std::vector<double>& shares) {
    Image<float> canvas({2 * kBars + 1, 32}, 1.0f);
    for (int bar = 0; bar < canvas.size.width; ++bar) {
        const double height = 64 * shares[static_cast<std::size_t>(bar)];
        for (int y = 0; y < 32 && y < height; ++y) canvas.at(bar, 31 - y) = bar == kBars ? 0.6f : 0.2f;
    }
    return grey_picture(canvas, 0, 1);
}

// What the tutorial's two formulas do under one camera.
void mismatch(Notebook& book, const Scene& scene, const Camera& camera, const std::string& name) {
    const GBuffer first = normal_depth(scene, camera, book.size(), {.position_order = kFirstPass});
    const Image3 lit = shade(scene, camera, first.depth, {}, {DepthFunction::equal, kSecondPass, {}});
    const double holes = holes_in(lit, first.view_depth);
    book.show(name, lit_picture(lit), "EQUAL with the tutorial's two formulas, camera " + name + ".");
    book.check(name + ": more than a tenth of the surface is lost", holes > 0.1, percent(holes));
    const std::vector<double> d32f = differences(scene, camera, book.size(), DepthFormat::d32f);
    const std::vector<double> d24 = differences(scene, camera, book.size(), DepthFormat::d24);
    book.show_row("Second depth minus first, -9 (or less) to 9 (or more) steps, 0 light: D32F, D24.",
                  {{name + "_d32f", bars(d32f)}, {name + "_d24", bars(d24)}});
    const auto row = [](const char* format, const std::vector<double>& s) -> std::vector<std::string> {
        return {format, percent(1 - s[9]), percent(s[8] + s[10]), percent(s.front() + s.back())};
    };
    book.table({name + ":", "unequal", "by one step", "by 9 or more"}, {row("D32F", d32f), row("D24", d24)});
    book.check(name + ": D24 does not hide it", d24[kBars] < d32f[kBars] + 0.05);
}

void cures(Notebook& book, const Scene& scene, const Camera& camera) {
    const GBuffer first = normal_depth(scene, camera, book.size(), {.position_order = kFirstPass});
    const Image3 right = shade(scene, camera, normal_depth(scene, camera, book.size()).depth, {});
    std::vector<std::vector<std::string>> rows;
    const auto cured = [&](const char* name, const ShadeSettings& settings, const char* caption) {
        const auto start = std::chrono::steady_clock::now();
        const Image3 lit = shade(scene, camera, first.depth, {}, settings);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        book.show(name, lit_picture(lit), caption, time.count());
        const double holes = holes_in(lit, first.view_depth), wrong = wrong_in(lit, right, first.view_depth);
        // A float's step in [1/2, 1) is 2^-24; at z = 10, with near = 1, a unit is 1/100 of ndc depth.
        const float reach = static_cast<float>(-settings.depth_bias.constant) / 16777216 * 100;
        rows.push_back({name, percent(holes), percent(wrong), exact_text(reach)});
        return std::pair{holes, wrong};
    };
    ShadeSettings less_equal{DepthFunction::less_equal, kSecondPass, {}};
    const auto shared = cured("one_formula", {DepthFunction::equal, kFirstPass, {}}, "EQUAL: whole.");
    const auto looser = cured("less_equal", less_equal, "LESS_EQUAL: holes where the second is farther.");
    less_equal.depth_bias.constant = -256;
    const auto biased = cured("bias", less_equal, "LESS_EQUAL and a bias of 256 steps: closed.");
    less_equal.depth_bias.constant = -65536;
    const auto too_far = cured("large_bias", less_equal, "65536 steps: hidden things shine through.");
    book.table({"cure", "holes", "wrong surface", "pulls nearer at z = 10, units"}, rows);
    book.check("one formula leaves no hole and no wrong pixel", shared == std::pair(0.0, 0.0));
    book.check("LESS_EQUAL alone leaves holes", looser.first > 0, percent(looser.first));
    book.check("a small bias closes all but 1 in 10,000", biased.first + biased.second < 1e-4);
    book.check("a large one shows hidden surfaces", too_far.second > 0.001, percent(too_far.second));
}

void depth_equal(Notebook& book) {
    book.text(R"(
        # 10 Equal depths

        Seed 000's first pass computes `(x (W V)) P`, as it needs the view position; its second `x (W V P)`,
        one product less. Both are right. Here is its scene under a magenta sky.
    )");
    Scene scene = find_builtin_scene("columns")->make();
    scene.sky = kMagenta;
    Camera turned = scene.camera;
    turned.eye = {-7.3, 1.7, -11.1}, turned.target = {0.4, -1.2, 1.3};
    mismatch(book, scene, scene.camera, "straight");  // along an axis, where many products are exact
    mismatch(book, scene, turned, "turned");
    cures(book, scene, turned);
    book.try_it({
        "Set `kSecondPass` to `PositionOrder::view_first`: no hole under any camera or format.",
        "Use `DepthFormat::d16` for `d24`: its coarser steps hide nearly all of it, and detail too.",
        "Set the small bias to -16: a few holes are back.",
    });
    book.errata({
        "*Seed 000:* names no cure: one function for positions, and no fused multiply-add in one pass only.",
    });
}

const Chapter kChapter("10", "depth_equal", "Equal depths", depth_equal);

}  // namespace
}  // namespace crevice
