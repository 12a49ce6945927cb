#include "ssao/methods/msvo_scales.h"

#include <algorithm>

#include "rasterizer/base/hash.h"
#include "rasterizer/base/parallel.h"
#include "ssao/inputs/pixel_fetch.h"

namespace crevice {

namespace {

constexpr float kNoSurface = std::numeric_limits<float>::infinity();

// Where the texel that stands for a cell of `cell` texels lies in it, in x or in y.
int picked(std::uint32_t seed, std::uint32_t axis, int cell) {
    return seed == 0 ? 0 : static_cast<int>(hash_of(seed, axis, 0) & static_cast<std::uint32_t>(cell - 1));
}

// What the balls around a grid's texels leave open; 1 where there is no surface.
Image<float> open_of(const DepthGrid& grid, const DepthGrid& map, const MsvoBall& ball, const Run& run) {
    Image<float> open(grid.size(), 1.0f);
    parallel_rows(grid.size().height, run, [&](int first_row, int end_row) {
        const auto rows = [&]<class F>(Lanes<F>) {
            for (int row = first_row; row < end_row; ++row) {
                for (int column = 0; column < grid.size().width; column += kLanes<F>) {
                    const Int<F> x = lane_index<F>() + Int<F>(column), y(row);
                    const F z = grid.at<F>(x, y);
                    const auto surface = z < F(kNoSurface);
                    F sum(0);
                    for (const auto& pair :
                         ball.pairs<F>(map, grid.texel_x(x), grid.texel_y(y), select(surface, z, F(1))))
                        sum = sum + pair.taken;
                    store(open.row(row) + column, to_float(select(surface, saturate(F(1) - sum), F(1))));
                }
            }
        };
        if (grid.in_double()) {
            rows(Lanes<double>{});
        } else {
            run_kernel(run, rows);
        }
    });
    return open;
}

}  // namespace

DepthGrid::DepthGrid(const AoInputs& inputs, int number, std::uint32_t seed, const Run& run)
    : map_(inputs.size()),
      cell_(1 << number),
      right_(picked(seed, 0, cell_)),
      lower_(picked(seed, 1, cell_)) {
    depth_ = Image<float>({(map_.width + cell_ - 1) / cell_, (map_.height + cell_ - 1) / cell_});
    parallel_rows(size().height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            const float* const row = inputs.view_depth.row(texel_y(y));
            for (int x = 0; x < size().width; ++x) depth_.at(x, y) = row[texel_x(x)];
        }
    });
    if (!inputs.in_double) return;
    in_double_ = Image<double>(size());
    for (int y = 0; y < size().height; ++y) {
        for (int x = 0; x < size().width; ++x)
            in_double_.at(x, y) = inputs.in_double->view_depth.at(texel_x(x), texel_y(y));
    }
}

MsvoBall::MsvoBall(const AoInputs& inputs, const MsvoSettings& settings, int number)
    : perspective(inputs.rays.perspective),
      thickness(settings.thickness),
      intensity(settings.intensity),
      limit(settings.pairs) {
    const int scales = settings.samples / kMsvoTaps;
    const auto over_largest = [&](int scale) { return 1 / static_cast<float>(1 << (scales - 1 - scale)); };
    radius = settings.radius * over_largest(number);
    spacing = radius / kBallRadius * pixels_per_unit(inputs) * inputs.fetch.scale;
}

namespace {

// Texel (x, y) of the finer grid, at view depth z.
template <class F>
CREVICE_INLINE F upsampled_texel(const Image<float>& open, const DepthGrid& coarse, int x, int y, F z) {
    // By how much depths may differ, over p's, for a texel to count half; and the weight of an open texel that
    // is always among them (Unity's noise filter at 0), which decides where all four are background.
    const F like_depth(0.01f), always_open(1);
    const int row = y / 2, next_row = std::clamp(row + (y % 2 == 0 ? -1 : 1), 0, open.size.height - 1);
    const int column = x / 2,
              next_column = std::clamp(column + (x % 2 == 0 ? -1 : 1), 0, open.size.width - 1);
    F sum = always_open, total = always_open;
    const auto add = [&](int i, int j, float nearness) __attribute__((always_inline)) {
        const F weight = F(nearness) / (absolute(coarse.within<F>(i, j) - z) / z + like_depth);
        sum = sum + weight * F(open.at(i, j));
        total = total + weight;
    };
    add(column, row, 9);
    add(next_column, row, 3);
    add(column, next_row, 3);
    add(next_column, next_row, 1);
    return saturate(sum / total);
}

}  // namespace

Image<float> upsampled(const Image<float>& open, const DepthGrid& coarse, const DepthGrid& fine,
                       const Run& run) {
    const Size size = fine.size();
    Image<float> result(size, 1.0f);
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (!(fine.at(x, y) < kNoSurface)) continue;
                result.at(x, y) =
                    fine.in_double()
                        ? to_float(upsampled_texel(open, coarse, x, y, fine.within<double>(x, y)))
                        : upsampled_texel(open, coarse, x, y, fine.at(x, y));
            }
        }
    });
    return result;
}

std::vector<Image<float>> coarser_scales(const AoInputs& inputs, const MsvoSettings& settings,
                                         const Run& run) {
    const int scales = settings.samples / kMsvoTaps;
    std::vector<DepthGrid> grids;
    for (int number = 0; number <= std::min(scales - 1, kCoarsestGrid); ++number)
        grids.emplace_back(inputs, number, settings.seed, run);
    const auto grid = [&](int number) -> const DepthGrid& { return grids[static_cast<std::size_t>(number)]; };
    std::vector<Image<float>> maps;
    for (int number = 1; number < scales; ++number) {
        int own = std::min(number, kCoarsestGrid);
        Image<float> open = open_of(grid(own), grid(0), MsvoBall(inputs, settings, number), run);
        for (; own > 0; --own) open = upsampled(open, grid(own), grid(own - 1), run);
        maps.push_back(std::move(open));
    }
    return maps;
}

}  // namespace crevice
