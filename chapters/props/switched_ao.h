// One view of a built-in scene under different `--param` words: what a chapter shows of an artifact and its
// cure, and the command that shows the same.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/frame.h"
#include "chapters/notebook/notebook.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

// The words of `--param`, name=value.
using Words = std::vector<std::string>;

// A built-in scene. Throws UsageError where there is none of this name.
Scene scene_named(const std::string& name);

struct SwitchedAo {
    LunaSettings settings;  // of the estimator
    BlurSettings blur;
    GBuffer gbuffer;
    AoInputs inputs;
    Image<float> raw, blurred;  // of the AO map's size
};

// Of an AO map.
struct Texel {
    int x = 0, y = 0;
};

// The pixel of a picture that lies at the texel's centre.
Texel pixel_of(const Texel& texel, Size ao_map, Size picture);

class SwitchedView {
 public:
    // The scene's own camera, and xjun's settings. Throws UsageError for a scene or a method there is not.
    SwitchedView(const std::string& scene, Size size, const std::string& method = "xjun");
    // The same as the reader of a chapter wants it: of the notebook's size, with its scene instead of this one, and its
    // parameters after the chapter's own.
    SwitchedView(const Notebook& book, const std::string& scene, const std::string& method = "xjun");
    // The same of another size.
    SwitchedView(const Notebook& book, const std::string& scene, Size size,
                 const std::string& method = "xjun");
    // From another camera; `flags` is how the command line says so.
    void look(const Camera& camera, const std::string& flags);

    // Throws UsageError as settings_of(). `ao_scale` is .5 or 1.
    SwitchedAo ao(const Words& words = {}, float ao_scale = 0.5f) const;
    // The numbers behind one texel of a map that ao() made.
    Explanation explanation(const SwitchedAo& shown, int x, int y) const;
    // "crevice render SCENE ...", Markdown.
    std::string command(const Words& words) const;
    // The whole frame, all of its buffers. Throws UsageError as settings_of().
    FrameRequest request(const Words& words) const;
    // All that follows SCENE in a command of the same frame: size, camera, method and every parameter, the reader's too.
    std::string flags(const Words& words) const;
    // What draws a buffer of that frame; and what probes the pixel at the centre of a texel of its AO map.
    std::string render_command(const Words& words = {}, const std::string& buffer = "ao_raw") const;
    std::string probe_command(const Words& words, const Texel& texel) const;

    const Scene& scene() const { return scene_; }
    const Camera& camera() const { return camera_; }

 private:
    FrameSettings settings(const Words& words) const;

    Scene scene_;
    Camera camera_;
    Size size_;
    const Method& method_;
    std::string flags_;
    Words reader_words_;  // after the chapter's own
};

// X_Jun's columns from near the foot of one, where contact shade is large.
SwitchedView column_foot(const Notebook& book);
SwitchedView column_foot(const Notebook& book, Size size);

// The texel of that view whose numbers chapters 03 to 09 carry along: ground beside the column, which hides a part of the
// surroundings from it.
Texel followed_texel(Size ao_map);

// a - b, of images of one size.
Image<float> difference_of(Image<float> a, const Image<float>& b);
Image3 difference_of(Image3 a, const Image3& b);

}  // namespace crevice
