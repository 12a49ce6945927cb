// Which triangle each pixel shows. This is all that the rasterizer writes: a depth code and the number of a
// triangle. Everything else is computed afterwards, once a visible pixel (surfaces.h).
// Source: Burns & Hunt 2013, "The visibility buffer: a cache-friendly approach to deferred shading", JCGT 2(2).
// In:     a ScreenGeometry: triangles set up and sorted into tiles
// Out:    Visibility; background: the cleared depth and kNoTriangle
// How:    tile by tile, on all threads; of each tile the triangles in the order in which they were submitted; of
//         each triangle groups of pixels (as many as there are lanes) that are covered, whose depth passes, and
//         that are not cut out. tile_raster.h has it in that order; triangles of a few pixels go many at a time.
// Cost:   about 15 operations a covered pixel, 8 bytes a pixel.
#pragma once

#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "rasterizer/draw/screen_geometry.h"

namespace crevice {

inline constexpr std::int32_t kNoTriangle = -1;

// What became of a tile's triangles.
struct TileRecord {
    std::uint32_t triangles = 0;  // entries of its lists
    std::uint32_t hidden = 0;     // of those, left out as a whole
    PixelRect tied = {};  // around the pixels where a fragment's depth equalled the stored one, or might
                          // have; whole groups of kRowAlignment pixels in pairs of rows; mostly empty
};

struct Visibility {
    DepthBuffer depth;
    Image<std::int32_t> triangle;   // for ScreenGeometry::triangle(), or kNoTriangle
    std::vector<TileRecord> tiles;  // one a tile of the geometry
};

// Pixels of one triangle that may be seen, for a function that knows its holes.
struct FragmentGroup {
    const TriangleBlock& block;
    const ScreenTriangle& triangle;
    int x, y, lanes;  // the pixels (x, y) ... (x + lanes - 1, y)
    // Bits set where a pixel is covered and its depth passes or equals the stored one. The function clears them
    // where the triangle has a hole: what is cut out leaves no depth, so it hides nothing and ties with nothing.
    std::int32_t* kept;
    const std::int32_t* passes;  // bits set where the depth passes
};

// Which fragments of triangles are cut out. Empty: all triangles are whole.
class Holes {
 public:
    Holes() = default;
    // `cut` is called for groups of fragments, on all threads. It must depend on triangle and pixel alone, the same way
    // in all passes of a view: then EQUAL finds what the first pass left. It is not asked of triangles whose material
    // is `whole` (beyond its end none is): they are drawn faster.
    template <class Cut>
    requires std::is_invocable_v<const Cut&, const FragmentGroup&> Holes(Cut cut,
                                                                         std::vector<bool> whole = {})
        : cut_(std::move(cut)), whole_(std::move(whole)) {}

    bool may_be_in(const ScreenTriangle& t) const {
        const auto material = static_cast<std::size_t>(t.material);
        return cut_ && !(material < whole_.size() && whole_[material]);
    }
    void cut_out(const FragmentGroup& group) const { cut_(group); }

 private:
    std::function<void(const FragmentGroup&)> cut_;
    std::vector<bool> whole_;  // one a material
};

// Called with the rows of pixels [first_row, end_row) of each row of tiles when all of these have been drawn, by the
// thread that drew the last: what else is computed of them then finds their triangles in the cache.
using WhenDrawn = std::function<void(const Visibility&, int first_row, int end_row)>;

// The comparison that keeps the nearest surface: LESS, or GREATER with reversed z.
DepthFunction nearest_wins(bool reversed_z);

// The first drawing of a view: the nearest triangle at every pixel, of equal depths the first. `format` is that
// which the geometry's depth bias was computed for.
Visibility visibility(const ScreenGeometry& geometry, DepthFormat format, bool reversed_z,
                      const Holes& holes = {}, const Run& run = {}, const WhenDrawn& when_drawn = {});

// The same with any comparison, over depths that are there already.
Visibility drawn_over(DepthBuffer depth, const ScreenGeometry& geometry, DepthFunction test,
                      const Holes& holes = {}, const Run& run = {});

// The tutorials' second drawing: depths are tested and not written. The last triangle that passes at every
// pixel of the wanted parts of the tiles (one a tile, whole groups of kRowAlignment pixels, from an even row on; an empty one
// keeps what `triangle` holds). Without parts the whole picture.
Image<std::int32_t> drawn_again(const ScreenGeometry& geometry, const DepthBuffer& depth, DepthFunction test,
                                const Holes& holes = {}, const Run& run = {});
Image<std::int32_t> drawn_again(Image<std::int32_t> triangle, std::span<const PixelRect> parts,
                                const ScreenGeometry& geometry, const DepthBuffer& depth, DepthFunction test,
                                const Holes& holes = {}, const Run& run = {});

// The numbers of the triangles that visibility() leaves out of a tile as a whole, in their order.
std::vector<std::int32_t> hidden_triangles(const ScreenGeometry& geometry, DepthFormat format,
                                           bool reversed_z, int tile, const Holes& holes = {},
                                           const Run& run = {});

// Nearest depths and nothing else: what a shadow map is made of.
DepthBuffer nearest_depth(const ScreenGeometry& geometry, DepthFormat format, const Holes& holes = {},
                          const Run& run = {});

}  // namespace crevice
