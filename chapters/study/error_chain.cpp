#include "chapters/study/error_chain.h"

#include "scenes/builtin_scenes.h"
#include "ssao/judge/fitted_power.h"
#include "ssao/judge/reference_image.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

// image + b - a, pixel by pixel.
Image<float> moved_by(Image<float> image, const Image<float>& a, const Image<float>& b) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] += b.pixels[i] - a.pixels[i];
    return image;
}

ReferenceImage limit_of(const MethodView& view, const FrameSettings& settings, int limit_seeds,
                        const Run& run) {
    return view.method->limit(ao_view_of(view, settings), settings.method.ao, limit_seeds, run, {});
}

// What the denoiser alone does to the method's limit, on top of the image `before` it.
ChainImage blurred_limit(const MethodView& view, const FrameSettings& settings, const Image<float>& before,
                         int limit_seeds, const Run& run) {
    const ReferenceImage limit = limit_of(view, settings, limit_seeds, run);
    RawAo raw = raw_ao_of(view, settings, run);
    raw.format = BufferFormat::float32;
    const auto half = [&](std::size_t i) {
        raw.ao = limit.half[i];
        return moved_by(
            before, ao_at_picture_size(limit.half[i], view.size, run),
            ao_at_picture_size(denoised(*view.method, raw, settings.method, run).ao, view.size, run));
    };
    return {"blur, bias", half(0), half(1)};
}

constexpr const char* kMapFormat = "ao_format";

bool stores_half_floats(const Method& method, const FrameSettings& settings) {
    return settings.buffers.buffer_format != BufferFormat::float32 ||
           value_of(method, settings.method, kMapFormat).value_or(0) != 0;
}

FrameSettings in_float32(const Method& method, FrameSettings settings) {
    settings.buffers.buffer_format = BufferFormat::float32;
    settings.method = with_value(method, settings.method, kMapFormat, 0);
    return settings;
}

constexpr Size kFitSize{160, 90};
constexpr int kFitRays = 128, kFitSeeds = 64;

}  // namespace

std::vector<ChainImage> error_chain(const MethodView& view, const References& references,
                                    const FrameSettings& settings, int limit_seeds, const Run& run) {
    const auto noisy = [](const char* step, const Reference& r) {
        return ChainImage{step, r.image.half[0], r.image.half[1]};
    };
    std::vector<ChainImage> chain = {noisy("truth", references.soft),
                                     noisy("depth buffer", references.screen),
                                     noisy("definition", references.limit)};
    const Method& method = *view.method;
    const FrameSettings plain = in_float32(method, settings);
    if (value_of(method, settings.method, "ao_scale").value_or(1) < 1) {
        const ReferenceImage limit = limit_of(view, plain, limit_seeds, run);
        chain.push_back({"half size", ao_at_picture_size(limit.half[0], view.size, run),
                         ao_at_picture_size(limit.half[1], view.size, run)});
    }
    const auto add = [&](const char* step, const Image<float>& map) {
        chain.push_back({step, ao_at_picture_size(map, view.size, run)});
    };
    if (method.ao_in_double) {
        add("sampling", method.ao_in_double(ao_view_of(view, plain), plain.method.ao, run));
        add("rounding", raw_ao_of(view, plain, run).ao);
    } else {
        add("sampling", raw_ao_of(view, plain, run).ao);
    }
    if (stores_half_floats(method, settings)) add("float16", raw_ao_of(view, settings, run).ao);
    if (has_blur(method, settings)) {
        chain.push_back(blurred_limit(view, settings, chain.back().first, limit_seeds, run));
        chain.push_back({"blur, noise removed", ao_picture_of(view, settings, run)});
    }
    return chain;
}

FittedElsewhere fitted_elsewhere(const Method& method, const std::string& name, const Run& run) {
    FittedElsewhere fitted;
    std::vector<References> references;
    for (const char* candidate : {"columns", "columns_luna", "cornell"}) {
        if (name == candidate) continue;
        const Scene scene = find_builtin_scene(candidate)->make();
        ReferenceRequest request;
        request.size = kFitSize;
        request.method = &method;
        request.settings = defaults_of(method, scene.length_unit);
        request.rays = rays_asking(method.question(request.settings.ao));
        request.rays.rays = kFitRays;
        request.limit_seeds = kFitSeeds;
        request.run = run;
        references.push_back(make_references(scene, scene.camera, request));
        fitted.scenes.push_back(candidate);
    }
    std::vector<Image<std::uint8_t>> surfaces;
    for (const References& r : references) {
        Image<std::uint8_t> surface(kFitSize, 0);
        for (const std::int32_t pixel : r.points.pixel)
            surface.at(pixel % kFitSize.width, pixel / kFitSize.width) = 1;
        surfaces.push_back(std::move(surface));
    }
    std::vector<PowerExample> examples;
    for (std::size_t i = 0; i < references.size(); ++i)
        examples.push_back({references[i].limit.image.mean, references[i].soft.image.mean, surfaces[i]});
    fitted.exponent = fitted_power(examples).exponent;
    return fitted;
}

}  // namespace crevice
