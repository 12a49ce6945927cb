// %% setup tags=["setup"]
// Source: X_Jun, "Different computations make depths unequal", whose two passes do exactly this.
// Run: crevice chapter 10
#include <bit>
#include <cmath>

#include "chapters/diagrams/float_line.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/depth_mismatch.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/vertex_transform.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/shade.h"

namespace crevice {
namespace {

constexpr PositionOrder kFirstPass = PositionOrder::view_first, kSecondPass = PositionOrder::premultiplied;

// The picture of the tutorial's two formulas under one camera.
struct Mismatch {
    Image3 lit;
    double holes = 0;                // share of the surface
    std::vector<double> d32f, d24;  // depth_differences()
};
Mismatch mismatch(const Scene& scene, const Camera& camera, Size size) {
    const GBuffer first = normal_depth(scene, camera, size, {.position_order = kFirstPass});
    const auto differences = [&](DepthFormat format) {
        return depth_differences(scene, camera, size, format, kFirstPass, kSecondPass);
    };
    Mismatch m{shade(scene, camera, first.depth, {}, {DepthFunction::equal, kSecondPass, {}}), 0,
               differences(DepthFormat::d32f), differences(DepthFormat::d24)};
    m.holes = lit_shares(m.lit, m.lit, first.view_depth).holes;
    return m;
}

std::vector<std::string> row_of(const char* camera, const char* format, const std::vector<double>& shares) {
    return {camera, format, percent_text(1 - shares[kMostSteps]),
            percent_text(shares[kMostSteps - 1] + shares[kMostSteps + 1]),
            percent_text(shares.front() + shares.back())};
}

PlotCurve curve_of(const std::string& name, const std::vector<double>& shares) {
    PlotCurve curve{name, {}, {}};
    for (int i = 0; i < static_cast<int>(shares.size()); ++i) {
        curve.x.push_back(i - kMostSteps);
        curve.y.push_back(100 * shares[static_cast<std::size_t>(i)]);
    }
    return curve;
}

// A vertex of the scene by both formulas: of those in the picture, the first whose depths are some steps apart.
struct TwoVertices {
    glm::vec4 first_clip, second_clip;
    float first = 0, second = 0;  // ndc depth
    int steps = 0;                // floats from the first to the second
};
TwoVertices two_vertices(const Scene& scene, const Camera& camera, Size size) {
    const TransformedVertices first = transform_vertices(scene, camera, size, {.position_order = kFirstPass}, {});
    const TransformedVertices second =
        transform_vertices(scene, camera, size, {.position_order = kSecondPass}, {});
    for (std::size_t i = 0; i < first.projected.size(); ++i) {
        const float a = first.projected[i].z_ndc, b = second.projected[i].z_ndc;
        const int steps = std::bit_cast<std::int32_t>(b) - std::bit_cast<std::int32_t>(a);
        if (first.projected[i].outside == 0 && std::abs(steps) >= 4 && std::abs(steps) <= 12)
            return {first.p_clip[i], second.p_clip[i], a, b, steps};
    }
    return {};
}

std::vector<std::string> row_of(const char* formula, const glm::vec4& clip, float depth) {
    const auto text = [](float value) { return decimal_text(static_cast<double>(value), 7); };
    return {formula, text(clip.z), text(clip.w), decimal_text(static_cast<double>(depth), 9)};
}

// A lit picture with the second drawing's shares of holes and wrong surfaces.
struct Lit {
    Image3 image;
    LitShares shares;
    Picture picture() const { return lit_picture(image); }
};

// How far a bias pulls a surface at view depth 10 to the eye, scene units. A float's step in [1/2, 1) is 2^-24; ndc depth
// changes with view depth by near / z^2, which is 1/100 there.
float reach_of(const ShadeSettings& settings) {
    return static_cast<float>(-settings.depth_bias.constant) / 16777216 * 100;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void depth_equal(Notebook& book) {

// %% question [markdown]
// # Equal depths
//
// Nothing in this picture is wrong on paper. Its second drawing (chapter 09) lights the surfaces whose depths equal those of the first
// pass, and both compute these depths by correct formulas. The background is painted magenta here, so that it is seen where it
// should not be.

// %% turned
Scene scene = find_builtin_scene("columns")->make();
scene.sky = kMagenta;
Camera camera = scene.camera;
camera.eye = {-7.3, 1.7, -11.1}, camera.target = {0.4, -1.2, 1.3};
const Mismatch turned = mismatch(scene, camera, book.size());
book.show("turned", lit_picture(turned.lit), "The scene of X_Jun's tutorial for Direct3D 11, lit with EQUAL, with the two formulas of its two passes.");
book.number("turned_holes", percent_text(turned.holes));
book.check("{turned_holes} of the surface's pixels are not lit.", turned.holes > 0.1);

// %% idea [markdown]
// ## The idea
//
// **A float rounds after every operation. Two formulas that are equal for real numbers differ in the last bits for floats, and
// EQUAL compares all bits.**
//
// X_Jun's first pass needs the position in view space anyway, so it multiplies twice: $(x\,(WV))\,P$. Its second pass has all three
// matrices multiplied beforehand and multiplies once: $x\,(WVP)$. Multiplication of matrices is associative, rounding is not.

// %% one_vertex
const TwoVertices vertex = two_vertices(scene, camera, book.size());
book.number("steps", std::to_string(std::abs(vertex.steps)));
book.table({"formula", "z of clip space", "w", "z / w"}, {row_of("(x (W V)) P", vertex.first_clip, vertex.first),
                                                          row_of("x (W V P)", vertex.second_clip, vertex.second)},
           "One vertex of the scene by both formulas.");
book.draw("float_line", float_line(vertex.first, "first pass", vertex.second, "second pass", "The depths of one vertex, among the floats around them"),
          "Every tick is a float. The depths of this vertex are {steps} floats apart.");
book.check("Both formulas give this vertex the same depth to six digits, and not the same float.",
           vertex.steps != 0 && std::fabs(vertex.first - vertex.second) < 1e-6f);

// %% how_large [markdown]
// ## How large the difference is
//
// Floats between 1/2 and 1 lie $2^{-24}$ apart, about $6 \cdot 10^{-8}$. Each product and each sum may be off by half of such a step, relative to
// its size, and the errors of a dozen of them add up. The depth of a pixel is interpolated between three vertices, and inherits their
// errors.
//
// That makes some steps here. How many depends on the camera: one that looks along an axis has matrices full of zeros and ones,
// where many products are exact. A depth buffer of 24 bits has steps of the same size, and does not help.

// %% differences
const Mismatch straight = mismatch(scene, scene.camera, book.size());
book.plot("differences", {"The second pass's depth minus the first's", {"steps of the format; the outer two hold all beyond", false, -9, 9},
                          {"% of the surface's pixels", false, 0},
                          {curve_of("turned camera", turned.d32f), curve_of("straight camera", straight.d32f)}},
          "Depths of 32-bit floats. Only what stands at 0 passes the test EQUAL. What is right of 0 is farther, and would fail LESS_EQUAL as well.");
book.table({"camera", "format", "unequal", "by one step", "by 9 or more"},
           {row_of("turned", "D32F", turned.d32f), row_of("turned", "D24", turned.d24),
            row_of("straight", "D32F", straight.d32f), row_of("straight", "D24", straight.d24)});
book.show("straight", lit_picture(straight.lit), "The same scene from its own camera, which looks along the z axis: other holes, not none.");
book.number("straight_holes", percent_text(straight.holes));
book.check("Looking along an axis, {straight_holes} of the surface are still lost.", straight.holes > 0.1);
book.check("D24 does not hide it under either camera.",
           turned.d24[kMostSteps] < turned.d32f[kMostSteps] + 0.05 && straight.d24[kMostSteps] < straight.d32f[kMostSteps] + 0.05);

// %% the_code [markdown]
// ## The code
//
// X_Jun's two vertex shaders write `mul(vOut.PosV, g_Proj)` and `mul(vIn.PosL, g_WorldViewProj)`. This lab has both orders, to show
// what they do, and a third one that all passes share.

// %% kernel_order tags=["setup"]
book.listing("rasterizer/draw/vertex_transform.h", "PositionOrder", "The three orders.");
book.listing("rasterizer/draw/vertex_transform.cpp", "position_transform", "Which matrices they multiply beforehand, and which afterwards.");
book.listing("rasterizer/draw/vertex_transform.cpp", "row_product", "The one expression behind every product: always in this order.");

// %% cures_text [markdown]
// ## Cures, good and bad
//
// **One formula for both passes** is the cure. With the same operations in the same order, every bit is the same. (A compiler
// that fuses a multiplication and an addition into one operation in one of the two shaders breaks this again; HLSL's `precise`
// forbids it.)
//
// **LESS_EQUAL** passes what is equal or nearer. Where the second depth is the smaller one, the hole is closed. With these two
// formulas that happens to be so nearly everywhere. Where the second depth is the larger one, the hole stays.
//
// **LESS_EQUAL with a bias** subtracts a constant number of steps from the second depth, so that rounding no longer matters. The
// bias must be larger than the rounding errors, and smaller than the distance to what lies behind, which no program knows
// beforehand. With the near plane at $z_n$ (here 1), a step of depth is $2^{-24} z^2 / z_n$ scene units long: the table says how
// far each bias reaches at $z = 10$.

// %% cures
const GBuffer first = normal_depth(scene, camera, book.size(), {.position_order = kFirstPass});
const Image3 right = shade(scene, camera, normal_depth(scene, camera, book.size()).depth, {});
std::vector<std::vector<std::string>> rows;
const auto cured = [&](const char* name, const ShadeSettings& settings) {
    const Image3 image = shade(scene, camera, first.depth, {}, settings);
    const Lit lit{image, lit_shares(image, right, first.view_depth)};
    rows.push_back({name, percent_text(lit.shares.holes), percent_text(lit.shares.wrong), exact_text(reach_of(settings))});
    return lit;
};
ShadeSettings settings{DepthFunction::less_equal, kSecondPass, {}};
const Lit shared = cured("one formula, EQUAL", {DepthFunction::equal, kFirstPass, {}});
const Lit looser = cured("LESS_EQUAL", settings);
settings.depth_bias.constant = -256;
const Lit biased = cured("LESS_EQUAL, bias 256 steps", settings);
settings.depth_bias.constant = -65536;
const Lit too_far = cured("LESS_EQUAL, bias 65536 steps", settings);
book.compare({"two_formulas", lit_picture(turned.lit), "Two formulas, EQUAL: most of the scene is missing."}, {"one_formula", shared.picture(), "One formula, EQUAL: whole."});
book.show_row({{"less_equal", looser.picture(), "LESS_EQUAL alone: a column in the background and the rim of the near sphere have holes."},
               {"bias", biased.picture(), "LESS_EQUAL with a bias of 256 steps: closed."},
               {"large_bias", too_far.picture(), "With 65536 steps what is behind shines through: at the ridge of the roof, in the frames of door and windows."}});
book.table({"cure", "holes", "wrong surface", "reach at z = 10, units"}, rows);
book.numbers({{"holes_left", percent_text(looser.shares.holes)}, {"hidden_seen", percent_text(too_far.shares.wrong)}});
book.check("One formula leaves no hole and no wrong pixel.", shared.shares.holes == 0 && shared.shares.wrong == 0);
book.check("LESS_EQUAL alone leaves {holes_left} of the surface unlit.", looser.shares.holes > 0);
book.number("bias_left", percent_text(biased.shares.holes + biased.shares.wrong));
book.check("A small bias leaves {bias_left} of the surface, less than a tenth of these holes.",
           biased.shares.holes + biased.shares.wrong < 0.1 * looser.shares.holes);
book.check("A large one shows hidden surfaces at {hidden_seen} of the pixels.", too_far.shares.wrong > 0.001);

// %% commands [markdown]
// The same with the command: `crevice render columns --param depth_position=view_first --param lit_position=premultiplied` breaks
// it, and with `--param lit_depth_test=less_equal --param lit_depth_bias=-256` as well it is whole.

// %% cutouts_text [markdown]
// ## Holes that are meant
//
// A fence is often drawn as one rectangle. The fourth channel of its texture, *alpha*, is 0 where there is a hole, and the shader
// throws these pixels away; HLSL's word for it is `clip`, ours is *cutting*. X_Jun has such a fence, a lattice, and cuts in both
// drawings. Must both?

// %% cutouts
const Scene cut = lattice_scene(), whole = without_cutouts(cut);
const Image3 right_lattice = shade(cut, cut.camera, normal_depth(cut, cut.camera, book.size()).depth, {});
const auto drawn = [&](bool first_cut, bool second_cut, DepthFunction function) {
    const GBuffer gbuffer = normal_depth(first_cut ? cut : whole, cut.camera, book.size());
    const Image3 image = shade(cut, cut.camera, gbuffer.depth, {}, {function, PositionOrder::relative, {}, second_cut});
    return Lit{image, lit_shares(image, right_lattice, gbuffer.view_depth)};
};
const Lit both = drawn(true, true, DepthFunction::equal), only_first = drawn(true, false, DepthFunction::equal);
const Lit closed = drawn(true, false, DepthFunction::less_equal), only_second = drawn(false, true, DepthFunction::equal);
book.show_row({{"cut_1", both.picture(), "Both drawings cut the holes: the lattice is right."},
               {"cut_3", closed.picture(), "Only the first cuts, and the second tests LESS_EQUAL: its rectangle has no holes, is nearer than what the first "
                "has seen through them, and covers it."},
               {"cut_4", only_second.picture(), "Only the second cuts: in the holes the first has left the depth of the rectangle, so what lies behind is not "
                "equal to it, and the background shows."}});
const auto row = [](const char* in_first, const char* in_second, const char* test, const Lit& lit) -> std::vector<std::string> {
    return {in_first, in_second, test, percent_text(lit.shares.holes), percent_text(lit.shares.wrong)};
};
book.table({"cut in the first drawing", "in the second", "test", "holes", "wrong surface"},
           {row("yes", "yes", "EQUAL", both), row("yes", "no", "EQUAL", only_first), row("yes", "no", "LESS_EQUAL", closed),
            row("no", "yes", "EQUAL", only_second)});
book.numbers({{"panel", percent_text(closed.shares.wrong)}, {"gaps", percent_text(only_second.shares.holes)}});
book.check("Cut in both, EQUAL leaves no hole.", both.shares.holes == 0 && both.shares.wrong == 0);
book.check("Cut in the first alone, EQUAL still gives the same picture, to the bit: the depth itself has the holes.",
           content_hash(only_first.image) == content_hash(both.image));
book.check("With LESS_EQUAL instead, the rectangle covers {panel} of the surface that should be seen through its holes.", closed.shares.wrong > 0.05);
book.check("Cut in the second alone, {gaps} of the surface is missing.", only_second.shares.holes > 0.05);

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice render columns --eye -7.3,1.7,-11.1 --target 0.4,-1.2,1.3 --param depth_position=view_first --param
//    lit_position=view_first`. Are there holes, and under which cameras?
// 2. Set `lit_position=premultiplied` in it, and add `--param depth_format=d16`. Why are there hardly any holes, and what is the price?
// 3. Set `depth_format=d32f` and `--param lit_depth_test=less_equal`, and try `lit_depth_bias` of -1, -16 and -256. Which is the smallest that
//    closes all?
// 4. Where would a *slope* bias, a multiple of how fast depth changes from pixel to pixel, be better than a constant one?
// 5. Reversed Z stores $z_n / z$. Would it change the number of holes?
//
// <details><summary>Answers</summary>
//
// 1. None, under any: both passes do the same operations.
// 2. A step of 16 bits is 256 times as long as one of 24, so both depths mostly fall onto the same one. The price is
//    precision: surfaces less than a step apart become one (chapter 04).
// 3. At -16 a few holes are left. The smallest that closes all depends on the camera, which is why a bias is no cure.
// 4. On surfaces seen at a slant: there a small error in the position of a vertex moves the depth of a pixel most.
// 5. Yes, somewhat: other numbers round otherwise (`--param depth_format=d32f_reversed`). But most stay. The two formulas are still two.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun:* shows the damage and names no cure. It is one function for positions in both shaders, without a fused multiply-add in only one of
//   them, as shown above.
// - *X_Jun:* repeats `clip` in the lit pass. With EQUAL it is not needed there, while the first pass cannot do without: the last table.
//
// </details>
//
// ## Where to go on
//
// EQUAL is now safe. What no care can make safe is the idea of AO from one depth map; chapter 11 shows where it ends. Chapter 24
// is about equal bits on a larger scale: between machines.

// %% end tags=["setup"]
}

const Chapter kChapter10("10", "depth_equal", "Equal depths", depth_equal);

}  // namespace
}  // namespace crevice
