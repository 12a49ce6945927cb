#include "rasterizer/obj/texel_images.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/vec3.h"

namespace crevice {
namespace {

glm::vec3 colour_of_normal(Vec3<float> steep) {
    const Vec3<float> n = normalize_or<float>(steep, {0, 0, 1});
    return 0.5f * glm::vec3(n.x, n.y, n.z) + 0.5f;
}

// The texels on both sides of `at` texels (a centre lies at .5), and how far it is from the first to the
// second.
struct Between {
    int first, second;
    float share;
    Between(float at, int count) {
        const float from_first = std::clamp(at - 0.5f, 0.0f, static_cast<float>(count - 1));
        first = static_cast<int>(from_first);
        second = std::min(first + 1, count - 1);
        share = from_first - static_cast<float>(first);
    }
};

}  // namespace

Image<float> channel_of(const DecodedImage& image, TexelChannel channel) {
    const Image3& c = image.colour;
    const bool has_alpha = !image.alpha.empty();
    switch (channel) {
        case TexelChannel::red: return c.x;
        case TexelChannel::green: return c.y;
        case TexelChannel::blue: return c.z;
        case TexelChannel::alpha: return has_alpha ? image.alpha : Image<float>(c.size(), 1.0f);
        case TexelChannel::unsaid:
            if (has_alpha) return image.alpha;
            break;
        case TexelChannel::luminance: break;
    }
    Image<float> luminance(c.size(), 0.0f);
    for (int y = 0; y < c.size().height; ++y) {
        for (int x = 0; x < c.size().width; ++x) {
            const glm::vec3 rgb = c.at(x, y);  // differences, so that a grey is exactly itself
            luminance.at(x, y) = rgb.x + 0.7152f * (rgb.y - rgb.x) + 0.0722f * (rgb.z - rgb.x);
        }
    }
    return luminance;
}

Image<float> resized(const Image<float>& image, Size size) {
    Image<float> result(size, 0.0f);
    const float per_column = static_cast<float>(image.size.width) / static_cast<float>(size.width),
                per_row = static_cast<float>(image.size.height) / static_cast<float>(size.height);
    for (int y = 0; y < size.height; ++y) {
        const Between rows((static_cast<float>(y) + 0.5f) * per_row, image.size.height);
        for (int x = 0; x < size.width; ++x) {
            const Between columns((static_cast<float>(x) + 0.5f) * per_column, image.size.width);
            const auto in_row = [&](int row) {
                const float a = image.at(columns.first, row), b = image.at(columns.second, row);
                return a + columns.share * (b - a);
            };
            const float above = in_row(rows.first), below = in_row(rows.second);
            result.at(x, y) = above + rows.share * (below - above);
        }
    }
    return result;
}

bool holds_normals(const Image3& data) {
    constexpr float kGreySlack = 3.0f / 255;
    double outward = 0, length = 0;
    bool grey = true;
    for (int y = 0; y < data.size().height; ++y) {
        for (int x = 0; x < data.size().width; ++x) {
            const glm::vec3 c = data.at(x, y), n = 2.0f * c - 1.0f;
            grey = grey && std::abs(c.x - c.y) <= kGreySlack && std::abs(c.y - c.z) <= kGreySlack;
            outward += n.z;
            length += std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        }
    }
    const double texels = static_cast<double>(data.size().width) * data.size().height;
    return !grey && outward > 0.5 * texels && length > 0.8 * texels && length < 1.2 * texels;
}

Image3 normals_with_green_down(Image3 data, float steepness) {
    for (int y = 0; y < data.size().height; ++y) {
        for (int x = 0; x < data.size().width; ++x) {
            const glm::vec3 n = 2.0f * data.at(x, y) - 1.0f;
            data.set(x, y, colour_of_normal({steepness * n.x, steepness * -n.y, n.z}));
        }
    }
    return data;
}

Image3 normals_of_heights(const Image<float>& heights, float rise) {
    const Size size = heights.size;
    Image3 normals(size, glm::vec3(0));
    // From the texel before to the one after: two texels, each 1 / width of the picture.
    const float slope = 0.5f * rise * static_cast<float>(size.width);
    for (int y = 0; y < size.height; ++y) {
        const float *above = heights.row(y > 0 ? y - 1 : size.height - 1),
                    *below = heights.row(y + 1 < size.height ? y + 1 : 0);
        for (int x = 0; x < size.width; ++x) {
            const int left = x > 0 ? x - 1 : size.width - 1, right = x + 1 < size.width ? x + 1 : 0;
            normals.set(x, y,
                        colour_of_normal({slope * (heights.at(left, y) - heights.at(right, y)),
                                          slope * (above[x] - below[x]), 1.0f}));
        }
    }
    return normals;
}

}  // namespace crevice
