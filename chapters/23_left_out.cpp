// %% setup tags=["setup"]
// Source: hierarchical Z (Greene, Kass and Miller 1993, "Hierarchical Z-Buffer Visibility"); pass culling (O'Donnell
// 2017, "FrameGraph"); the bounds of the tutorials' own formulas (X_Jun and Luna).
// Run: crevice chapter 23
#include <algorithm>

#include "chapters/frame/frame.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/tile_proofs.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

FrameRequest request_of(const Notebook& book) {
    FrameRequest request;
    request.size = book.size();
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method, book.options().words);
    return request;
}

std::string buffer_hashes(const Frame& frame) {
    return content_hash(frame.gbuffer.normal) + content_hash(frame.gbuffer.view_depth) +
           content_hash(ndc_depth(frame.gbuffer.depth)) + content_hash(frame.ao_raw) +
           content_hash(frame.ao_blurred) + content_hash(frame.lit);
}

// X_Jun's columns from right above: the floor is as far everywhere, and nothing on it lies in front of it.
Scene columns_from_above() {
    Scene scene = columns_scene();
    scene.name = "columns_from_above";
    scene.camera.eye = {0, 20, -6};
    scene.camera.target = {0, 0, -5.9};
    return scene;
}

// One scene, with each kind of work kept alone, with all kept and with none.
struct KeptAndLeftOut {
    Frame frame;
    bool same = true;             // bit for bit, however much is kept
    bool all_is_computed = true;  // where all is kept
};
KeptAndLeftOut kept_and_left_out(const Scene& scene, FrameRequest request) {
    KeptAndLeftOut result;
    result.frame = render_frame(scene, scene.camera, request);
    const std::string expected = buffer_hashes(result.frame);
    for (int kind = 0; kind < kSkipCount; ++kind) {
        request.run.kept = KeptWork::only(static_cast<Skip>(kind));
        result.same = result.same && buffer_hashes(render_frame(scene, scene.camera, request)) == expected;
    }
    request.run.kept = KeptWork::all();
    const Frame kept = render_frame(scene, scene.camera, request);
    result.same = result.same && buffer_hashes(kept) == expected;
    std::size_t still_left_out = 0;
    for (const SkippedWork& work : kept.skipped) still_left_out += work.count;
    const bool nothing_to_compute = triangle_count(scene) == 0;
    result.all_is_computed = still_left_out == 0 && (kept.left_out.empty() || nothing_to_compute);
    return result;
}

std::vector<std::string> table_row(const std::string& name, const Frame& frame) {
    std::vector<std::string> row = {name};
    for (const SkippedWork& work : frame.skipped)
        row.push_back(std::to_string(work.count) + " / " + std::to_string(work.of));
    return row;
}

double share_of_ones(const Image<float>& ao) {
    double ones = 0;
    for (int y = 0; y < ao.size.height; ++y)
        ones += static_cast<double>(std::count(ao.row(y), ao.row(y) + ao.size.width, 1.0f));
    return ones / (static_cast<double>(ao.size.width) * ao.size.height);
}

int texels_that_differ(const Image<float>& a, const Image<float>& b) {
    int count = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) count += a.at(x, y) != b.at(x, y) ? 1 : 0;
    }
    return count;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void left_out(Notebook& book) {

// %% question [markdown]
// # What a scene does not need
//
// Here are the AO map of the columns and the picture that it shades. Chapter 06 spent fourteen samples on
// every texel of that map, and most of them for nothing: there is no stone within reach, all fourteen answer "open", and
// the result is the 1 that we could have written down at once. Other passes do the same. They draw triangles that end up
// behind a wall, blur white with white, and light the floor a second time although nothing has changed since the first.
//
// Could we have known?

// %% start
const FrameRequest request = request_of(book);
const Scene columns = find_builtin_scene("columns")->make();
const KeptAndLeftOut first = kept_and_left_out(columns, request);
const Frame& frame = first.frame;
book.number("ones", 100 * share_of_ones(frame.ao_raw), 0);
book.show_row({{"ao_raw", ao_picture(frame.ao_raw), "The AO map. {ones} % of its texels are exactly 1."},
               {"lit", lit_picture(frame.lit), "The picture that it shades."}});

// %% idea [markdown]
// ## The idea
//
// **Prove from bounds, before the work begins, that its result is already known; and then do not begin.**
//
// Passes work on *tiles*, squares of 16 by 16 texels, one after another. A *bound* is a number that a value cannot pass. If
// the farthest surface of a tile is at depth 20.00, and the nearest thing that any of its samples could possibly meet is at
// depth 19.98, then no sample finds anything more than epsilon = 0.05 in front of its texel. That settles 256 texels with
// two comparisons. The proof uses nothing but the numbers in the buffers. It never trusts a promise of the caller ("this
// object is in front", "nothing here is transparent"), because one day the promise is wrong, and then so is the picture.

// %% a_tile tags=["setup"]
const Scene crates = crates_from_above(book.size());
const LunaSettings settings = request.settings.method.ao.as<LunaSettings>();
const Frame of_crates = render_frame(crates, crates.camera, request);
const AoInputs inputs = ao_inputs(of_crates.gbuffer, crates.camera, xjun_fetch(settings));
const TileMap right = ao_tiles(inputs, settings), naive = own_depths_only(inputs, settings);
const HarmedTexel harmed = most_harmed(naive, right, of_crates.ao_raw);
book.draw(
    "tile", tile_diagram(inputs, settings, harmed),
    "A cut through the depth buffer: crates on a floor, which the eye sees from above, far to the left. "
    "Green is one tile of the "
    "AO map, blue how far its samples reach. The dashed line lies epsilon in front of the tile's "
    "farthest texel: only what "
    "crosses it within the blue span can occlude. Here a crate does, so this tile must be computed.");

// %% reach_text [markdown]
// ## How far a sample can look
//
// We need the nearest depth among everything that a tile's samples may read. So, how far from its own texel does a sample
// read? The point $q$ lies at most one radius $R$ from $p$: $q = p + e$ with $|e| \le R$. Its place on the screen is
// proportional to $q_x / q_z$. Write $t = p_x / p_z$ for the slope of the ray through $p$. With $p_x = t\,p_z$ and
// $p_z = q_z - e_z$,
//
// $$ \frac{q_x}{q_z} - t = \frac{p_x + e_x}{q_z} - t = \frac{t (q_z - e_z) + e_x}{q_z} - t = \frac{e_x - t\, e_z}{q_z} $$
//
// The numerator is the product of $e$ with the vector $(1, -t)$, so it is at most $R\sqrt{1 + t^2}$. For the denominator we
// take its smallest value: $q_z$ is at least $p_z - R$, and a sample in front of the near plane does not count at all
// (chapter 06). Altogether
//
// $$ \left|\frac{q_x}{q_z} - t\right| \le \frac{R \sqrt{1 + t^2}}{\max(p_z - R,\; near)} $$
//
// Half the picture's width over the tangent of half the field of view turns this into pixels. The depth map is read by a
// linear filter, which looks one pixel further. The filter mixes four depths and never goes below the least of them, except
// by rounding; how much that can be is worked out in the source, and subtracted.
//
// With $z_{far}$ the farthest texel of the tile and $r_{near}$ the nearest depth within reach, every sample has
//
// $$ dz = p_z - r_z \le z_{far} - r_{near} \le \varepsilon \quad\Rightarrow\quad \mathrm{occlusion}(dz) = 0 $$
//
// The sum is 0, one minus that is 1, and 1 to any power is 1. Not nearly 1: the same bits.

// %% the_code [markdown]
// ## The code
//
// Reach, in pixels of one axis. `ray_scale` is the tangent of half the field of view, which is also the largest slope $t$
// in the picture:

// %% code_of_tiles tags=["setup"]
book.listing_part("ssao/methods/open_tiles.cpp", "Reach", "double in_px", "q_z;",
                  "The bound from above.");
book.listing_part("ssao/methods/open_tiles.cpp", "ao_tiles", "const auto may_be_open",
                  "candidates.push_back",
                  "For each tile. The cheap tests come first: the tile itself, then whole tiles around "
                  "it. Few tiles get as "
                  "far as the exact test against the depth map.");
book.listing_part("rasterizer/draw/hidden_triangles.h", "HiddenTriangles", "static bool may_pass",
                  "return true;",
                  "The same thought for triangles. `stored` is the range of depths in a square of 16 x "
                  "16 pixels, `low` and "
                  "`high` that of the triangle. If none of its depths can pass the depth test, none of "
                  "its pixels is drawn.");

// %% pictures [markdown]
// ## What each pass leaves out
//
// The pictures below paint what was not computed. **Blue** tiles show nothing but background, **green** tiles were proved
// to be open, **yellow** ones were lit from what the first pass has kept, where the tutorials draw the whole scene once
// more with the depth test EQUAL (chapter 10). What is not painted was computed.

// %% tiles_of_columns
book.show_row({{"columns_raster", painted(frame.lit, frame.tiles.raster),
                "First pass: tiles that no triangle reaches keep their clear values."},
               {"columns_ao", painted(frame.lit, frame.tiles.ao),
                "AO: tiles of sky are left out. The floor is open too, but seen at a slant, its depths "
                "differ by more than epsilon."},
               {"columns_blur", painted(frame.lit, frame.tiles.blur),
                "Blur: only where all that it would read is 1. These are fewer tiles, since it reads "
                "beyond its own."},
               {"columns_lit", painted(frame.lit, frame.tiles.lit),
                "Light: the second drawing is hardly ever needed."}});

// %% other_scenes
const Scene above = columns_from_above(), cornell = cornell_scene(), noise = noise_wall_scene(),
            ball = find_builtin_scene("sphere_on_plane")->make(), empty = empty_scene();
const KeptAndLeftOut of_cornell = kept_and_left_out(cornell, request),
                     of_ball = kept_and_left_out(ball, request),
                     of_noise = kept_and_left_out(noise, request),
                     of_empty = kept_and_left_out(empty, request),
                     of_above = kept_and_left_out(above, request);
book.show_row({{"above_ao", painted(of_above.frame.lit, of_above.frame.tiles.ao),
                "AO from above: the floor faces the eye, so its depths are alike, and only the "
                "surroundings of things are computed."},
               {"cornell_ao", painted(of_cornell.frame.lit, of_cornell.frame.tiles.ao),
                "AO of a room: outside of it there is nothing, and inside everything must be computed."},
               {"ball_ao", painted(of_ball.frame.lit, of_ball.frame.tiles.ao),
                "AO of a ball on a plane: only the strip of sky is left out."},
               {"noise_ao", painted(of_noise.frame.lit, of_noise.frame.tiles.ao),
                "AO of a wall of bumps: nothing can be proved anywhere, and nothing is left out."}});

// %% table
book.table(
    {"scene", "off-screen clusters", "off-screen triangles", "hidden triangles", "empty tiles",
     "background tiles (AO)", "open tiles (AO + blur)", "tiles lit once"},
    {table_row("columns", frame), table_row("columns from above", of_above.frame),
     table_row("cornell", of_cornell.frame), table_row("sphere_on_plane", of_ball.frame),
     table_row("noise_wall", of_noise.frame), table_row("empty", of_empty.frame)},
    "How much of its work each scene was spared. A triangle counts once for every tile that it reaches. A cluster is "
    "128 neighbouring triangles of a large mesh, or all of a small one.");

// %% how_wrong [markdown]
// ## How wrong is it?
//
// Not at all, and that is the point: whatever is left out must not change one bit of what remains. So we compute every
// picture again, once with each kind of work done all the same, and once with all of it, and compare all six buffers.

// %% same_bits
const KeptAndLeftOut* const all[] = {&first, &of_above, &of_cornell, &of_ball, &of_noise, &of_empty};
book.numbers({{"scenes", std::size(all)}, {"kinds", kSkipCount}});
book.check(
    "In all {scenes} scenes, every bit of the six buffers is the same with each of the {kinds} kinds of "
    "work kept, and "
    "with all of them kept.",
    std::ranges::all_of(all, [](const KeptAndLeftOut* scene) { return scene->same; }));
book.check(
    "With all of them kept, which is `--keep-all` on the command line, nothing is left out any more.",
    std::ranges::all_of(all, [](const KeptAndLeftOut* scene) { return scene->all_is_computed; }));
const FrameTiles& of_nothing = of_empty.frame.tiles;
book.check("Of a scene without triangles every tile is left out, and AO and blur do not even run.",
           of_nothing.raster.count(TileWork::background) == of_nothing.raster.count() &&
               of_nothing.ao.count() == 0 && of_nothing.blur.count() == 0);
std::size_t left_out_of_noise = 0;
for (const SkippedWork& work : of_noise.frame.skipped) {
    const bool could_be_seen =
        work.skip != Skip::off_screen_triangles && work.skip != Skip::second_drawing;
    if (could_be_seen) left_out_of_noise += work.count;
}
const bool bumps_are_small =
    std::min(book.size().width, book.size().height) < 64;  // then a tile may happen to be flat
book.check("Of the wall of bumps no tile and no visible triangle is left out, only the second drawing.",
           left_out_of_noise == 0 || bumps_are_small);

// %% passes_text [markdown]
// Whole passes can be known to be useless, too. Somebody who asks for the view depth alone (`--only view_depth`) needs no
// normals, no AO, no light. Every pass says what it reads; what nothing reads is not made, and the report gives the reason
// for each:

// %% passes
FrameRequest depth_only = request;
depth_only.wanted = {"view_depth"};
std::vector<std::vector<std::string>> reasons;
for (const LeftOut& item : render_frame(noise, noise.camera, depth_only).left_out)
    reasons.push_back({item.what, item.why});
book.table({"left out", "because"}, reasons);

// %% own_depths_text [markdown]
// ## What can go wrong
//
// **The bound forgets the neighbours.** It is tempting to look at a tile's own depths only: a flat tile cannot occlude
// itself. But its samples leave the tile. The first picture calls every tile open whose own texels lie within
// epsilon; squares of contact shadow are cut out of it, and in a film they flicker as the tiles move over the scene.

// %% own_depths
const Image<float>& ao_of_crates = of_crates.ao_raw;
const Image<float> cut_out = with_ones(ao_of_crates, naive);
const int lost = texels_that_differ(cut_out, ao_of_crates);
book.number("cut_out", std::to_string(lost));
book.compare(
    {"own_depths", ao_picture(cut_out),
     "Flat tiles taken for open: {cut_out} texels have lost their shadow."},
    {"reach", ao_picture(ao_of_crates), "With everything in reach in the bound: no texel has changed."});
book.check(
    "Judged by their own depths alone, tiles lose the shadow of {cut_out} texels; judged by all within "
    "reach, of none.",
    lost > 0 && texels_that_differ(with_ones(ao_of_crates, right), ao_of_crates) == 0);

// %% probes_text [markdown]
// **A few probes stand for a whole tile.** Looking at the corners of a tile is four reads instead of 256. Where all four
// show sky the tile is probably sky. *Probably* is not a proof: what is thin slips between the probes.

// %% probes
const Scene leaves = find_builtin_scene("leaves")->make();
const Frame of_leaves = render_frame(leaves, leaves.camera, request);
const AoInputs leaf_inputs = ao_inputs(of_leaves.gbuffer, leaves.camera, xjun_fetch(settings));
const Image<float> probed = with_ones(of_leaves.ao_raw, corners_only(leaf_inputs));
book.number("slipped", std::to_string(texels_that_differ(probed, of_leaves.ao_raw)));
book.compare(
    {"corners", ao_picture(probed),
     "Four probes a tile: {slipped} texels have lost their shadow, and the crown has square gaps."},
    {"every_texel", ao_picture(of_leaves.ao_raw),
     "Every texel of a tile is asked whether it shows a surface."});

// %% ties_text [markdown]
// **Equal depths.** A triangle that lies exactly in the plane of what is already there ties with it. Under LESS it loses,
// and may be left out as soon as its nearest depth *equals* the farthest stored one. Under LESS_EQUAL it wins, and may not.
// One `<` in place of a `<=` in `may_pass`, and a poster on a wall is gone, but only in those tiles where the wall was
// drawn early enough. Look at the listing again: each of the eight depth functions has its own comparison.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 23 --cell other_scenes --param epsilon=1`. Why is the whole wall of bumps green now, of which
//    nothing could be proved before, and what has become of its shade?
// 2. Run `crevice render columns --repeat 9` and then the same with `--keep-all`. Both print what each pass took. Which
//    kind of work was worth leaving out?
// 3. Draw with `crevice render columns --param depth_format=d16 --near 0.001`. Many tiles are drawn a second time after
//    all. Why?
// 4. Why is it right to leave out the AO of a tile that shows only sky, but wrong to leave out its blur without looking at
//    the tiles around it?
// 5. (Open) The floor of the columns is flat, and yet it is rarely proved to be open, because it is seen at a slant. Find a
//    bound that uses the tile's plane, and say what it costs.
//
// <details><summary>Answers</summary>
//
// 1. Its bumps are lower than 1, so nothing within reach of a texel is more than epsilon in front of it, and the bound
//    proves it. The shade is gone, but not by the proof: epsilon itself has ruled it out.
// 2. Times are your machine's. The open tiles of AO and blur count for most in pictures with much sky or a facing wall; the
//    second drawing is the largest part of the lit pass.
// 3. Sixteen bits and a near plane at a thousandth leave few different depths far away. Surfaces tie, and a tile in which
//    they may do so is drawn again, since the last of the equal ones must win.
// 4. The AO of a sky texel is 1 whatever is around it. The blur of a texel reads its neighbours; it may be left out only if
//    all those are 1.
// 5. Subtract from every depth in reach that of the plane there: what is left is the height over the plane, and the facing
//    term dp is 0 for what lies in it. The bound must then hold for dp times occlusion, rounding of the fitted plane
//    included; fitting it costs about as much as one sample.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun and Luna* (tutorials for Direct3D 11 and 12) run AO over the sky as over any surface and rely on the result being 1 there, but do not say why it
//   is. Luna clears normals to $(0, 0, 1)$, away from the eye, so that dp is 0 for everything in front of the far plane.
//   X_Jun clears them to $(0, 0, -1)$, towards the eye; there the fade alone keeps the sky white, since everything is too
//   far in front of it to count.
//
// </details>
//
// ## Where to go on
//
// Chapter 24 asks the same of the machine: every bit stays the same, whatever computes it. Chapter 21 asks what is gained
// by computing less where the result is *not* known.

// %% end tags=["setup"]
}

const Chapter kChapter23("23", "left_out", "What a scene does not need", left_out);

}  // namespace
}  // namespace crevice
