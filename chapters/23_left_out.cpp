// Question: what of a frame can be left out without changing a single bit of it?
//
// The one idea: prove from bounds, before the work, that its result is known: no triangle reaches this tile, none
// of these lies in front, no surface, nothing near enough to occlude. Never from a promise of the caller.
//
// Source: hierarchical Z (Greene, Kass and Miller 1993, "Hierarchical Z-Buffer Visibility"); pass culling (O'Donnell
// 2017, "FrameGraph"); the bounds of the tutorials' own formulas (X_Jun and Luna).
// Look for: which tiles keep their colours. Only those were computed.
// Run: crevice chapter 23
#include <algorithm>

#include "chapters/frame/frame.h"
#include "chapters/notebook/chapter.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"

namespace crevice {
namespace {

constexpr glm::vec3 kBackground(0.13f, 0.19f, 0.42f), kOpen(0.16f, 0.62f, 0.3f), kLitOnce(0.95f, 0.75f, 0.2f);
constexpr float kTint = 0.75f;

FrameRequest request_of(const Notebook& book) {
    FrameRequest request;
    request.size = book.size();
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method);
    return request;
}

// The final image, with the tiles that a pass left out painted over; their edges show the tile size.
Picture painted(const Image3& lit, const TileMap& map) {
    Image3 image = lit;
    for (int y = 0; y < lit.size().height && map.tile_px > 0; ++y) {
        for (int x = 0; x < lit.size().width; ++x) {
            const int tile_x = x * map.picture.width / lit.size().width / map.tile_px,
                      tile_y = y * map.picture.height / lit.size().height / map.tile_px;
            const TileWork work = map.tiles.at(tile_x, tile_y);
            if (work == TileWork::done) continue;
            const glm::vec3 paint = work == TileWork::background ? kBackground
                                    : work == TileWork::open     ? kOpen
                                                                 : kLitOnce;
            const float shade = (tile_x + tile_y) % 2 == 0 ? 1.0f : 0.85f;
            image.set(x, y, (1 - kTint) * lit.at(x, y) + kTint * shade * paint);
        }
    }
    Picture picture = lit_picture(image);
    picture.mapping = "the lit picture; painted blue: background, green: open, yellow: lit once";
    return picture;
}

std::string hashes_of(const Frame& frame) {
    return content_hash(frame.gbuffer.normal) + content_hash(frame.gbuffer.view_depth) +
           content_hash(ndc_depth(frame.gbuffer.depth)) + content_hash(frame.ao_raw) +
           content_hash(frame.ao_blurred) + content_hash(frame.lit);
}

std::string share_text(const SkippedWork& work) {
    return std::to_string(work.count) + " of " + std::to_string(work.of);
}

// One scene: the pictures, and a line of the table.
std::vector<std::string> left_out_of(Notebook& book, const std::string& name, const Scene& scene) {
    FrameRequest request = request_of(book);
    const Frame frame = render_frame(scene, scene.camera, request);
    const FrameTiles& tiles = frame.tiles;
    book.show_row(name + ": left out of the first pass, AO, blur, lit pass.",
                  {{name + "_raster", painted(frame.lit, tiles.raster)},
                   {name + "_ao", painted(frame.lit, tiles.ao)},
                   {name + "_blur", painted(frame.lit, tiles.blur)},
                   {name + "_lit", painted(frame.lit, tiles.lit)}});

    bool same = true;
    const std::string expected = hashes_of(frame);
    for (int kind = 0; kind < kSkipCount; ++kind) {
        request.run.kept = KeptWork::only(static_cast<Skip>(kind));
        same = same && hashes_of(render_frame(scene, scene.camera, request)) == expected;
    }
    request.run.kept = KeptWork::all();
    const Frame kept = render_frame(scene, scene.camera, request);
    book.check(name + ": every bit is the same with each kind of work kept, and with all of it",
               same && hashes_of(kept) == expected);
    std::size_t still_left_out = 0;
    for (const SkippedWork& work : kept.skipped) still_left_out += work.count;
    const bool nothing_to_compute = triangle_count(scene) == 0;
    book.check(name + ": --keep-all leaves nothing out",
               still_left_out == 0 && (kept.left_out.empty() || nothing_to_compute));

    std::vector<std::string> row = {name};
    for (const SkippedWork& work : frame.skipped) row.push_back(share_text(work));
    return row;
}

void left_out(Notebook& book) {
    book.text(R"(
        # 23 What a scene does not need

        A frame is mostly work whose result is known beforehand. Tiles painted **blue** show nothing but background;
        **green** ones cannot be occluded: nothing within the sample radius lies more than `epsilon` in front of
        them, so every term of the sum is 0 and accessibility is exactly 1; **yellow** ones are lit from what the
        first pass kept, where the tutorials draw the scene again with EQUAL. Unpainted tiles are computed.
    )");
    std::vector<std::vector<std::string>> rows;
    for (const char* name : {"columns", "cornell", "sphere_on_plane", "noise_wall", "empty"})
        rows.push_back(left_out_of(book, name, find_builtin_scene(name)->make()));
    Scene above = columns_scene();  // the floor is as far everywhere: nothing on it lies in front of it
    above.camera.eye = {0, 20, -6};
    above.camera.target = {0, 0, -5.9};
    rows.push_back(left_out_of(book, "columns_from_above", above));
    book.table({"left out", "off-screen triangles", "hidden triangles", "empty tiles",
                "background tiles (AO)", "open tiles (AO + blur)", "tiles lit once"},
               rows);

    FrameRequest request = request_of(book);
    const Scene empty = empty_scene(), noise = noise_wall_scene();
    const Frame nothing = render_frame(empty, empty.camera, request);
    book.check("empty: all tiles are left out, AO and blur do not even run",
               nothing.tiles.raster.count(TileWork::background) == nothing.tiles.raster.count() &&
                   nothing.tiles.ao.count() == 0 && nothing.tiles.blur.count() == 0);
    std::size_t left_out_of_noise = 0;
    for (const SkippedWork& work : render_frame(noise, noise.camera, request).skipped) {
        const bool could_be_seen =
            work.skip != Skip::off_screen_triangles && work.skip != Skip::second_drawing;
        if (could_be_seen) left_out_of_noise += work.count;
    }
    // Of a picture smaller than its bumps, a tile may be flat.
    if (std::min(book.size().width, book.size().height) >= 64)
        book.check("noise_wall: no tile and no visible triangle is left out, only the second drawing",
                   left_out_of_noise == 0);
    request.wanted = {"view_depth"};
    std::string reasons;
    for (const LeftOut& item : render_frame(noise, noise.camera, request).left_out)
        reasons += "\n- " + item.what + ": " + item.why;
    book.text("Asked for the view depth alone, `--only view_depth`, the same frame also leaves out:\n" +
              reasons);
    book.try_it({
        "Set `xjun`'s `epsilon` to 1: nearly every tile turns green, and the contact shadows are gone.",
        "In `left_out_of`, draw with `depth_format=d16` and the near plane at 0.001: depths tie, and the "
        "tiles "
        "where they do are drawn again.",
        "`crevice render columns --repeat 9` measures what each kind saves; `--keep-all` leaves nothing out.",
    });
}

const Chapter kChapter("23", "left_out", "What a scene does not need", left_out);

}  // namespace
}  // namespace crevice
