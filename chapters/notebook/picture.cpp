#include "chapters/notebook/picture.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/run.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

using Rgb = std::array<float, 3>;  // in [0,1], as displayed

constexpr Rgb kMagenta = {1, 0, 1};
constexpr Rgb kBlue = {0.02f, 0.30f, 0.75f}, kWhite = {1, 1, 1}, kRed = {0.80f, 0.05f, 0.10f};
constexpr float kFarthestGrey = 0.1f;  // of view depth, so that the background's black is no depth

std::uint8_t byte_of(float value) {
    const float clamped = value > 0 ? (value < 1 ? value : 1.0f) : 0.0f;
    return static_cast<std::uint8_t>(clamped * 255 + 0.5f);
}

// paint_row(y, row) gives the colours of each row.
template <class PaintRow>
Picture picture_of_rows(Size size, std::string mapping, const BufferStatistics& statistics,
                        PaintRow paint_row) {
    Picture picture{size, 3, {}, std::move(mapping), statistics, {}};
    picture.pixels.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 3);
    std::vector<Rgb> row(static_cast<std::size_t>(size.width));
    for (int y = 0; y < size.height; ++y) {
        paint_row(y, row);
        for (const Rgb& colour : row) {
            for (const float channel : colour) picture.pixels.push_back(byte_of(channel));
        }
    }
    return picture;
}

// colour_at(x, y) for every pixel.
template <class ColourAt>
Picture rgb_picture(Size size, std::string mapping, const BufferStatistics& statistics, ColourAt colour_at) {
    return picture_of_rows(size, std::move(mapping), statistics, [&](int y, std::vector<Rgb>& row) {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = colour_at(static_cast<int>(x), y);
    });
}

// grey_of(value) for every pixel; with a NaN anywhere an RGB picture where it is magenta.
template <class GreyOf>
Picture grey_or_magenta(const Image<float>& image, const BufferStatistics& statistics, std::string mapping,
                        GreyOf grey_of, PictureValues values = PictureValues::kept) {
    const Size size = image.size;
    if (statistics.nan > 0) {
        mapping += "; NaN magenta";
        Picture picture = rgb_picture(size, std::move(mapping), statistics, [&](int x, int y) {
            const float value = image.at(x, y);
            const float grey = std::isnan(value) ? 0 : grey_of(value);
            return std::isnan(value) ? kMagenta : Rgb{grey, grey, grey};
        });
        if (values == PictureValues::kept) picture.values = planes_of(image);
        return picture;
    }
    Picture picture{size, 1, {}, std::move(mapping), statistics, {}};
    if (values == PictureValues::kept) picture.values = planes_of(image);
    picture.pixels.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) picture.pixels.push_back(byte_of(grey_of(image.at(x, y))));
    }
    return picture;
}

bool any_nan(glm::vec3 v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); }

Rgb diverging(float value, float scale) {
    const float strength = std::fabs(value) < scale ? std::fabs(value) / scale : 1.0f;
    const Rgb& end = value < 0 ? kBlue : kRed;
    Rgb colour = kWhite;
    for (std::size_t c = 0; c < 3; ++c) colour[c] += strength * (end[c] - kWhite[c]);
    return colour;
}

std::string difference_mapping(float scale, const char* which) {
    return "signed difference: -" + exact_text(scale) + " blue, 0 white, +" + exact_text(scale) + " red" +
           which;
}

}  // namespace

Picture normal_picture(const Image3& normals, PictureValues values) {
    const std::string mapping = "normal: RGB = n / 2 + 1/2; background black";
    Picture picture = rgb_picture(normals.size(), mapping, buffer_statistics(normals), [&](int x, int y) {
        const glm::vec3 n = normals.at(x, y);
        if (any_nan(n)) return kMagenta;
        if (n == glm::vec3(0)) return Rgb{0, 0, 0};
        return Rgb{n.x * 0.5f + 0.5f, n.y * 0.5f + 0.5f, n.z * 0.5f + 0.5f};
    });
    if (values == PictureValues::kept) picture.values = planes_of(normals);
    return picture;
}

Picture view_depth_picture(const Image<float>& view_depth, PictureValues values) {
    const BufferStatistics range = buffer_statistics(view_depth);
    const float extent = range.max > range.min ? range.max - range.min : 1.0f;
    return grey_or_magenta(
        view_depth, range,
        "view depth: affine from " + exact_text(range.min) + " (nearest, white) to " + exact_text(range.max) +
            " (farthest, dark); background black",
        [&](float depth) {
            if (std::isinf(depth)) return 0.0f;
            return 1 - (1 - kFarthestGrey) * ((depth - range.min) / extent);
        },
        values);
}

Picture ndc_depth_picture(const Image<float>& ndc_depth, bool reversed_z, PictureValues values) {
    const BufferStatistics range = buffer_statistics(ndc_depth);
    if (reversed_z) {
        const float nearest = range.max > 0 ? range.max : 1.0f;
        return grey_or_magenta(
            ndc_depth, range,
            "reversed ndc depth, not linear in distance: 0 (background, black) to " + exact_text(nearest) +
                " (nearest, white)",
            [nearest](float depth) { return depth / nearest; }, values);
    }
    const float nearest = range.min < 1 ? range.min : 0.0f;
    return grey_or_magenta(
        ndc_depth, range,
        "ndc depth, not linear in distance: " + exact_text(nearest) +
            " (nearest, white) to 1 (background, black)",
        [nearest](float depth) { return (1 - depth) / (1 - nearest); }, values);
}

Picture ao_picture(const Image<float>& ao, PictureValues values) {
    return grey_or_magenta(
        ao, buffer_statistics(ao), "accessibility: 0 (closed) black to 1 (open) white, linear",
        [](float value) { return value; }, values);
}

Picture lit_picture(const Image3& lit) {
    const std::string mapping = "lit: linear light clamped to [0,1], then the sRGB curve";
    const Image<float>* const planes[] = {&lit.x, &lit.y, &lit.z};
    const Run run;
    std::vector<float> encoded(static_cast<std::size_t>(lit.x.stride));
    return picture_of_rows(lit.size(), mapping, buffer_statistics(lit), [&](int y, std::vector<Rgb>& row) {
        for (std::size_t c = 0; c < 3; ++c) {
            run_kernel(run, [&]<class F>(Lanes<F>) {
                for (int x = 0; x < lit.x.stride; x += kLanes<F>)
                    store(encoded.data() + x, srgb_from_linear(saturate(load<F>(planes[c]->row(y) + x))));
            });
            for (std::size_t x = 0; x < row.size(); ++x) row[x][c] = encoded[x];
        }
        for (std::size_t x = 0; x < row.size(); ++x) {
            if (any_nan(lit.at(static_cast<int>(x), y))) row[x] = kMagenta;
        }
    });
}

Picture colour_picture(const Image3& colours) {
    return rgb_picture(colours.size(), "RGB as stored", buffer_statistics(colours), [&](int x, int y) {
        const glm::vec3 colour = colours.at(x, y);
        return any_nan(colour) ? kMagenta : Rgb{colour.x, colour.y, colour.z};
    });
}

Picture difference_picture(const Image<float>& difference, float scale) {
    const std::string mapping = difference_mapping(scale, "");
    Picture picture = rgb_picture(difference.size, mapping, buffer_statistics(difference), [&](int x, int y) {
        const float value = difference.at(x, y);
        return std::isnan(value) ? kMagenta : diverging(value, scale);
    });
    picture.values = planes_of(difference);
    return picture;
}

Picture difference_picture(const Image3& difference, float scale) {
    const std::string mapping = difference_mapping(scale, "; the component farthest from 0");
    Picture picture =
        rgb_picture(difference.size(), mapping, buffer_statistics(difference), [&](int x, int y) {
            const glm::vec3 d = difference.at(x, y);
            if (any_nan(d)) return kMagenta;
            float farthest = d.x;
            if (std::fabs(d.y) > std::fabs(farthest)) farthest = d.y;
            if (std::fabs(d.z) > std::fabs(farthest)) farthest = d.z;
            return diverging(farthest, scale);
        });
    picture.values = planes_of(difference);
    return picture;
}

Picture mask_picture(const Image<float>& mask) {
    return grey_or_magenta(mask, buffer_statistics(mask), "mask: 0 black, everything else white",
                           [](float value) { return value == 0 ? 0.0f : 1.0f; });
}

Picture mask_picture(const Image<std::uint8_t>& mask) {
    Image<float> values(mask.size, 0.0f);
    for (int y = 0; y < mask.size.height; ++y) {
        for (int x = 0; x < mask.size.width; ++x) values.at(x, y) = mask.at(x, y) == 0 ? 0.0f : 1.0f;
    }
    return mask_picture(values);
}

Picture grey_picture(const Image<float>& values, float low, float high) {
    return grey_or_magenta(values, buffer_statistics(values),
                           "values: " + exact_text(low) + " black to " + exact_text(high) + " white, affine",
                           [low, high](float value) { return (value - low) / (high - low); });
}

std::string statistics_text(const BufferStatistics& statistics) {
    const auto digits = [](double value) { return significant_text(value, 6); };
    std::string line = "no finite value";
    if (statistics.finite > 0)
        line = "min " + digits(double(statistics.min)) + ", mean " + digits(statistics.mean) + ", max " +
               digits(double(statistics.max));
    if (statistics.nan > 0) line += ", " + std::to_string(statistics.nan) + " NaN";
    if (statistics.inf > 0) line += ", " + std::to_string(statistics.inf) + " infinite";
    return line;
}

std::string values_png(const Planes& values) {
    const Size size = values.front().size;
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> bytes(pixels * sizeof(float) * values.size());
    for (std::size_t c = 0; c < values.size(); ++c) {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                std::uint8_t of_value[sizeof(float)];
                std::memcpy(of_value, &values[c].at(x, y), sizeof(float));
                const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x);
                for (std::size_t byte = 0; byte < sizeof(float); ++byte)
                    bytes[(c * sizeof(float) + byte) * pixels + pixel] = of_value[byte];
            }
        }
    }
    const int height = size.height * static_cast<int>(sizeof(float) * values.size());
    return png_bytes({size.width, height}, 1, bytes);
}

void write_picture(const std::filesystem::path& path, const Picture& picture, const Run& run) {
    write_png(path, picture.size, picture.channels, picture.pixels, run);
}

}  // namespace crevice
