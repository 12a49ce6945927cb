// Work that cannot change a pixel, and is therefore left out. What can be left out is found from bounds of what
// is drawn, never from a caller's promise; tests hold every picture equal, bit for bit, with each kind kept alone
// and with all kept (--keep-all).
#pragma once

#include <bitset>

namespace crevice {

enum class Skip {
    passes,                // whose result nobody asked for, or the frame before has left
    off_screen_clusters,   // meshes, or clusters of their triangles, beyond one side of the view
    off_screen_triangles,  // whole triangles beyond one side of the view
    hidden_triangles,      // behind everything a part of a tile already shows
    empty_tiles,           // no triangle touches them: they keep their clear values
    background_pixels,     // of full-screen passes: no surface, nothing to compute
    open_tiles,        // of AO and blur: accessibility is exactly 1 in all their pixels and all those read
    faint_highlights,  // of the lit pass: too faint to change the last bit of the colour
    second_drawing,    // of the lit pass: the first pass kept what these pixels show
};
inline constexpr int kSkipCount = 9;

// The short name of a kind, as it stands in passes.json.
const char* skip_name(Skip skip);

// Why it can change no pixel.
const char* skip_reason(Skip skip);

// The kinds of work to do all the same.
class KeptWork {
 public:
    static KeptWork all() {
        KeptWork kept;
        kept.kinds_.set();
        return kept;
    }
    static KeptWork only(Skip skip) {
        KeptWork kept;
        kept.kinds_.set(static_cast<std::size_t>(skip));
        return kept;
    }
    bool contains(Skip skip) const { return kinds_.test(static_cast<std::size_t>(skip)); }
    bool operator==(const KeptWork&) const = default;

 private:
    std::bitset<kSkipCount> kinds_;
};

}  // namespace crevice
