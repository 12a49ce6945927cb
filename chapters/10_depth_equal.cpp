// Question: the second pass tests depths for EQUAL. What if another formula, just as right, computes them?
//
// The one idea: floats round after every step, so x(WVP) and (x(WV))P differ in the last bits. EQUAL forgives
// none of them: where the passes disagree, no surface is lit and the background shows through.
//
// Source: X_Jun, "Different computations make depths unequal", whose two passes do exactly this.
// Look for: magenta, which is what the background is painted in here; the bars, most of which are not at 0; a
//           lattice that closes, and one that lets the background through.
// Run: crevice chapter 10
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/depth_mismatch.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/shade.h"

namespace crevice {
namespace {

constexpr PositionOrder kFirstPass = PositionOrder::view_first, kSecondPass = PositionOrder::premultiplied;

// What the tutorial's two formulas do under one camera.
void mismatch(Notebook& book, const Scene& scene, const Camera& camera, const std::string& name) {
    const GBuffer first = normal_depth(scene, camera, book.size(), {.position_order = kFirstPass});
    const Image3 lit = shade(scene, camera, first.depth, {}, {DepthFunction::equal, kSecondPass, {}});
    const double holes = lit_shares(lit, lit, first.view_depth).holes;
    book.show(name, lit_picture(lit), "EQUAL with the tutorial's two formulas, camera " + name + ".");
    book.check(name + ": more than a tenth of the surface is lost", holes > 0.1, percent_text(holes));
    const auto differences = [&](DepthFormat format) {
        return depth_differences(scene, camera, book.size(), format, kFirstPass, kSecondPass);
    };
    const std::vector<double> d32f = differences(DepthFormat::d32f), d24 = differences(DepthFormat::d24);
    book.show_row("Second depth minus first, -9 (or less) to 9 (or more) steps, 0 light: D32F, D24.",
                  {{name + "_d32f", bars_picture(d32f)}, {name + "_d24", bars_picture(d24)}});
    const auto row = [](const char* format, const std::vector<double>& s) -> std::vector<std::string> {
        return {format, percent_text(1 - s[9]), percent_text(s[8] + s[10]),
                percent_text(s.front() + s.back())};
    };
    book.table({name + ":", "unequal", "by one step", "by 9 or more"}, {row("D32F", d32f), row("D24", d24)});
    book.check(name + ": D24 does not hide it", d24[kMostSteps] < d32f[kMostSteps] + 0.05);
}

void cures(Notebook& book, const Scene& scene, const Camera& camera) {
    const GBuffer first = normal_depth(scene, camera, book.size(), {.position_order = kFirstPass});
    const Image3 right = shade(scene, camera, normal_depth(scene, camera, book.size()).depth, {});
    std::vector<std::vector<std::string>> rows;
    const auto cured = [&](const char* name, const ShadeSettings& settings, const char* caption) {
        const Image3 lit = shade(scene, camera, first.depth, {}, settings);
        book.show(name, lit_picture(lit), caption);
        const LitShares shares = lit_shares(lit, right, first.view_depth);
        // A float's step in [1/2, 1) is 2^-24; at z = 10, with near = 1, a unit is 1/100 of ndc depth.
        const float reach = static_cast<float>(-settings.depth_bias.constant) / 16777216 * 100;
        rows.push_back({name, percent_text(shares.holes), percent_text(shares.wrong), exact_text(reach)});
        return shares;
    };
    ShadeSettings less_equal{DepthFunction::less_equal, kSecondPass, {}};
    const LitShares shared = cured("one_formula", {DepthFunction::equal, kFirstPass, {}}, "EQUAL: whole.");
    const LitShares looser =
        cured("less_equal", less_equal, "LESS_EQUAL: holes where the second is farther.");
    less_equal.depth_bias.constant = -256;
    const LitShares biased = cured("bias", less_equal, "LESS_EQUAL and a bias of 256 steps: closed.");
    less_equal.depth_bias.constant = -65536;
    const LitShares too_far = cured("large_bias", less_equal, "65536 steps: hidden things shine through.");
    book.table({"cure", "holes", "wrong surface", "pulls nearer at z = 10, units"}, rows);
    book.check("one formula leaves no hole and no wrong pixel", shared.holes == 0 && shared.wrong == 0);
    book.check("LESS_EQUAL alone leaves holes", looser.holes > 0, percent_text(looser.holes));
    book.check("a small bias closes all but 1 in 10,000", biased.holes + biased.wrong < 1e-4);
    book.check("a large one shows hidden surfaces", too_far.wrong > 0.001, percent_text(too_far.wrong));
}

// The same surfaces must be cut out by both passes; what happens when one of them does not.
void cutouts(Notebook& book) {
    const Scene cut = lattice_scene(), whole = without_cutouts(cut);
    const Camera& camera = cut.camera;
    const Image3 right = shade(cut, camera, normal_depth(cut, camera, book.size()).depth, {});
    std::vector<std::vector<std::string>> rows;
    std::vector<Notebook::Named> pictures;
    std::vector<LitShares> shares;
    const auto lit_with = [&](bool first_cut, bool second_cut, DepthFunction function) {
        const GBuffer first = normal_depth(first_cut ? cut : whole, camera, book.size());
        const Image3 lit =
            shade(cut, camera, first.depth, {}, {function, PositionOrder::relative, {}, second_cut});
        shares.push_back(lit_shares(lit, right, first.view_depth));
        rows.push_back({first_cut ? "yes" : "no", second_cut ? "yes" : "no",
                        function == DepthFunction::equal ? "EQUAL" : "LESS_EQUAL",
                        percent_text(shares.back().holes), percent_text(shares.back().wrong)});
        if (shares.size() != 2)
            pictures.push_back({"cut_" + std::to_string(shares.size()), lit_picture(lit)});
        return lit;
    };
    const Image3 both = lit_with(true, true, DepthFunction::equal),
                 first_only = lit_with(true, false, DepthFunction::equal);
    lit_with(true, false, DepthFunction::less_equal);
    lit_with(false, true, DepthFunction::equal);
    book.text(R"(
        A lattice is cut out of a rectangle by its texture's alpha, X_Jun's `clip`. Both passes and the
        shadow map must cut alike: EQUAL lights whatever surface the first pass left, and nothing else.
    )");
    book.show_row("Cut in both passes; only in the first, with LESS_EQUAL; only in the second.", pictures);
    book.table({"cut in the first pass", "in the second", "test", "holes", "wrong surface"}, rows);
    book.check("cut in both, EQUAL leaves no hole", shares[0].holes == 0 && shares[0].wrong == 0);
    book.check("cut in the first alone, EQUAL still gives the same bits: the depth itself is cut",
               content_hash(first_only) == content_hash(both));
    book.check("but LESS_EQUAL closes the lattice", shares[2].wrong > 0.05, percent_text(shares[2].wrong));
    book.check("cut in the second alone, the background shows through every gap", shares[3].holes > 0.05,
               percent_text(shares[3].holes));
}

void depth_equal(Notebook& book) {
    book.text(R"(
        # 10 Equal depths

        X_Jun's first pass computes `(x (W V)) P`, as it needs the view position; its second `x (W V P)`,
        one product less. Both are right. Here is its scene under a magenta sky.

            crevice render columns --param depth_position=view_first --param lit_position=premultiplied

        and cured with `--param lit_depth_test=less_equal --param lit_depth_bias=-256` as well.
    )");
    Scene scene = find_builtin_scene("columns")->make();
    scene.sky = kMagenta;
    Camera turned = scene.camera;
    turned.eye = {-7.3, 1.7, -11.1}, turned.target = {0.4, -1.2, 1.3};
    mismatch(book, scene, scene.camera, "straight");  // along an axis, where many products are exact
    mismatch(book, scene, turned, "turned");
    cures(book, scene, turned);
    cutouts(book);
    book.try_it({
        "Set `kSecondPass` to `PositionOrder::view_first`: no hole under any camera or format.",
        "Use `DepthFormat::d16` for `d24`: its coarser steps hide nearly all of it, and detail too.",
        "Set the small bias to -16: a few holes are back.",
    });
    book.errata({
        "*X_Jun:* names no cure: one function for positions, and no fused multiply-add in one pass only. "
        "`one_formula`.",
        "*X_Jun:* repeats its clip in the lit pass. EQUAL does not need it there, the first pass does: "
        "last table.",
    });
}

const Chapter kChapter("10", "depth_equal", "Equal depths", depth_equal);

}  // namespace
}  // namespace crevice
