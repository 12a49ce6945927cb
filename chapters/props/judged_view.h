// One view of a built-in scene on which methods stand side by side: their maps, the numbers of one texel, and how far
// each is from ray-cast truth of its own question.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "chapters/frame/frame_settings.h"
#include "chapters/notebook/notebook.h"
#include "chapters/props/switched_ao.h"
#include "ssao/judge/reference_image.h"
#include "ssao/rays/ray_cast_ao.h"
#include "ssao/rays/surface_points.h"

namespace crevice {

// The size at which the chapters measure errors, whatever the size of their pictures.
inline constexpr Size kJudgedSize = {240, 135};
inline constexpr int kJudgedRays = 64;  // a pixel, of truth
inline constexpr int kJudgedSeeds = 8;  // whose mean stands for what a method tends to

// What a method makes of the view, once.
struct MethodMap {
    const Method* method = nullptr;
    MethodSettings settings;
    RawAo raw;
    Image<float> denoised;  // AO map size
    Image<float> picture;   // the same at picture size, as the lit pass reads it
    // The `crevice render` command of this frame; empty where the scene is none of the built-in ones.
    std::string rendered;

    // The command that draws one of its buffers, such as "ao_raw"; or empty.
    std::string command(const std::string& buffer) const {
        return rendered.empty() ? "" : rendered + " --only " + buffer;
    }
};

// The same without the chance in it: at picture size, unfiltered, the mean over kJudgedSeeds seeds.
struct MethodLimit {
    AoQuestion question;
    ReferenceImage image;
    double noise = 0;  // root mean square difference of one map from it, over the pixels that show a surface
};

// Ray-cast accessibility, which a method's question asks for.
struct Truth {
    AoQuestion question;
    ReferenceImage image;
    double noise = 0;  // root mean square of its own standard error, over the same pixels
};

// Over the pixels that show a surface. Free of the noise of the truth, and of that of a limit.
struct MapError {
    double rmse = 0, bias = 0;
};

class JudgedView {
 public:
    // From the scene's own camera.
    JudgedView(Scene scene, Size size, std::uint32_t seed);
    // Throws UsageError for a scene there is not.
    JudgedView(const std::string& scene, Size size, std::uint32_t seed);
    // The same as the reader of a chapter wants it: with his scene instead of this one, and his parameters for every
    // method that has them. `own`, the chapter's, is given all, so that what no method knows is an error.
    JudgedView(const Notebook& book, const std::string& scene, const std::string& own, Size size);
    JudgedView(const Notebook& book, const std::string& scene, const std::string& own)
        : JudgedView(book, scene, own, book.size()) {}
    // From another camera; `flags` is how the command line says so.
    void look(const Camera& camera, const std::string& flags);

    // Throws UsageError as settings_of().
    MethodMap map(const std::string& method, const Words& words = {}) const;
    Explanation explanation(const MethodMap& map, int x, int y) const;
    AoQuestion question_of(const MethodMap& map) const;
    MethodLimit limit(const std::string& method, const Words& words = {}) const;
    Truth truth(const AoQuestion& question) const;
    // The same of the depth map alone (depth_mesh.h, joined up to the radius): all that a screen-space method can know.
    Truth depth_truth(const AoQuestion& question) const;
    // Of one map as the lit pass reads it, its own noise included; and of what a method tends to.
    MapError error(const MethodMap& map, const Truth& truth) const;
    MapError error(const MethodLimit& limit, const Truth& truth) const;
    // Map minus truth; 0 where there is no surface.
    Picture difference(const MethodMap& map, const Truth& truth) const;
    // A map at picture size, as the lit pass reads it.
    Image<float> at_picture_size(const Image<float>& ao) const;
    // "crevice render SCENE ...", Markdown.
    std::string command(const std::string& method, const Words& words = {}) const;

    const Scene& scene() const { return scene_; }
    const Camera& camera() const { return camera_; }
    const GBuffer& gbuffer() const { return gbuffer_; }

 private:
    void draw();
    Truth cast(const AoQuestion& question, const RayScene& rays, const SurfacePoints& points) const;
    // With the reader's that the method has.
    Words all_words(const Method& method, const Words& words) const;
    MethodSettings settings_for(const Method& method, const Words& words) const;
    double root_mean_square(const Image<float>& errors) const;
    using Halves = std::array<Image<float>, 2>;
    MapError error_of(const Image<float>& mean, const Halves& halves, const Truth& truth) const;

    Scene scene_;
    Camera camera_;
    Size size_;
    std::uint32_t seed_;
    std::string flags_;
    std::string own_;
    Words reader_words_;
    GBuffer gbuffer_;
    std::shared_ptr<const RayScene> rays_;
};

// X_Jun's columns from near the foot of one, as column_foot() has them.
JudgedView judged_column_foot(const Notebook& book, const std::string& own, Size size);

// Of any map or picture of that view the part around the foot: nearly all the rest is open.
Image<float> around_foot(const Image<float>& ao);

// A row of a table: the name, the error and its bias; and, of what a method tends to, the noise of one map.
std::vector<std::string> error_row(const std::string& name, const MapError& error);
std::vector<std::string> error_row(const std::string& name, const MapError& error, const MethodLimit& limit);
inline const std::vector<std::string> kErrorHeader = {"method", "RMS error", "mean error",
                                                      "noise of one map"};

}  // namespace crevice
