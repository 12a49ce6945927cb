#include "ssao/blur/temporal_accumulation.h"

#include <algorithm>
#include <limits>
#include <string>

#include <glm/mat3x3.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// From the view space of this frame into that of the last one.
struct ViewChange {
    glm::vec3 x, y, z, shift;  // columns of the rotation; what is added after it

    // The way between the eyes is taken in double, so that it is exact however far out the scene lies.
    ViewChange(const Camera& now, const Camera& last, Size size) {
        const glm::dmat3 last_from_relative(glm::mat3(camera_matrices(last, size).view_from_relative));
        const glm::mat3 turn(last_from_relative *
                             glm::dmat3(glm::mat3(camera_matrices(now, size).relative_from_view)));
        x = turn[0];
        y = turn[1];
        z = turn[2];
        shift = last_from_relative * (now.eye - last.eye);
    }

    template <class F>
    CREVICE_INLINE Vec3<F> turned(Vec3<F> v) const {
        return v.x * spread<F>(x) + v.y * spread<F>(y) + v.z * spread<F>(z);
    }
};

// A position among the last frame's texels: the upper left of the four around it, and how far on from that.
template <class F>
struct TexelPosition {
    Int<F> column, row;
    F right, down;  // [0, 1)
};

// What the last frame holds of some texels' surfaces.
template <class F>
struct TakenOver {
    F ao, frames;
    Mask<F> any;
};

struct Accumulation {
    const AoInputs& inputs;
    const Image<float>& ao;
    const AoHistory& last;
    const TemporalSettings& settings;
    ViewChange change;
    float near_plane;

    // Steps of 1/256, so that what hits a texel's centre but for rounding takes that texel alone.
    template <class F>
    CREVICE_INLINE static Int<F> in_steps(F position, int size) {
        const F inside = min_of(max_of(position, F(-2)), F(static_cast<float>(size + 1)));
        return floor_to_int(inside * F(256) + F(0.5f));
    }

    template <class F>
    CREVICE_INLINE TexelPosition<F> position_of(Vec3<F> p_last) const {
        const Size picture = last.rays.size, map = ao.size;
        const Screen2<F> at = last.rays.p_screen(p_last, F(1) / max_of(p_last.z, F(near_plane)));
        const F across = F(static_cast<float>(map.width) / static_cast<float>(picture.width)),
                down = F(static_cast<float>(map.height) / static_cast<float>(picture.height));
        const Int<F> x = in_steps(at.x * across - F(0.5f), map.width),
                     y = in_steps(at.y * down - F(0.5f), map.height);
        const Int<F> column = x >> 8, row = y >> 8;
        return {column, row, F(to_float(x - (column << 8))) * F(1.0f / 256),
                F(to_float(y - (row << 8))) * F(1.0f / 256)};
    }

    // Adds one texel of the last frame to the sums, if it shows the surface at p_last.
    template <class F>
    CREVICE_INLINE void add(F column, F row, F weight, Vec3<F> p_last, Vec3<F> n_last, F& total, F& sum,
                            F& frames) const {
        const F width = F(static_cast<float>(ao.size.width)), height = F(static_cast<float>(ao.size.height));
        const Mask<F> inside = (column >= F(0)) & (column < width) & (row >= F(0)) & (row < height);
        const Int<F> index =
            select(inside, floor_to_int(row) * Int<F>(ao.stride) + floor_to_int(column), Int<F>(0));
        const F depth = F(gather(last.view_depth.pixels.data(), index));
        const Mask<F> surface = depth < F(std::numeric_limits<float>::infinity());
        const Vec3<F> q = last.rays.p_view((column + F(0.5f)) / width, (row + F(0.5f)) / height,
                                           select(surface, depth, F(1)));
        const Vec3<F> n = {F(gather(last.normal.x.pixels.data(), index)),
                           F(gather(last.normal.y.pixels.data(), index)),
                           F(gather(last.normal.z.pixels.data(), index))};
        // Methods that read depths alone know no plane.
        const Mask<F> known = dot(n_last, n_last) > F(0);
        const F apart = select(known, dot(n_last, q - p_last), q.z - p_last.z);
        const Mask<F> near = absolute(apart) <= F(settings.depth) * p_last.z;
        const Mask<F> facing = (!known) | (dot(n_last, n) >= F(settings.normal));
        const F counted = select(inside & surface & near & facing, weight, F(0));
        total = total + counted;
        sum = sum + counted * F(gather(last.ao.pixels.data(), index));
        frames = frames + counted * F(gather(last.frames.pixels.data(), index));
    }

    template <class F>
    CREVICE_INLINE TakenOver<F> taken_over(const TexelPoint<F>& texel) const {
        const Vec3<F> p_last = change.turned(texel.p) + spread<F>(change.shift);
        const Vec3<F> n_last = normalize_or<F>(change.turned(texel.n), {F(0), F(0), F(0)});
        const TexelPosition<F> at = position_of(p_last);
        F total(0), sum(0), frames(0);
        for (const int down : {0, 1}) {
            for (const int right : {0, 1}) {
                const F weight =
                    (right == 1 ? at.right : F(1) - at.right) * (down == 1 ? at.down : F(1) - at.down);
                add(F(to_float(at.column + Int<F>(right))), F(to_float(at.row + Int<F>(down))), weight,
                    p_last, n_last, total, sum, frames);
            }
        }
        const Mask<F> any = texel.surface & (p_last.z > F(near_plane)) & (total > F(0));
        const F inverse = F(1) / select(any, total, F(1));
        return {sum * inverse, frames * inverse, any};
    }

    // Limited to what the texel and the eight around it hold now.
    template <class F>
    CREVICE_INLINE F clamped(F history, int x, int y) const {
        F low(1), high(0);
        const F last_column = F(static_cast<float>(ao.size.width - 1));
        for (int down = -1; down <= 1; ++down) {
            const float* const row = ao.row(std::clamp(y + down, 0, ao.size.height - 1));
            for (int right = -1; right <= 1; ++right) {
                const F column = F(to_float(lane_index<F>() + Int<F>(x + right)));
                const F value = F(gather(row, floor_to_int(min_of(max_of(column, F(0)), last_column))));
                low = min_of(low, value);
                high = max_of(high, value);
            }
        }
        return min_of(max_of(history, low), high);
    }
};

AoHistory without_past(const Image<float>& ao, const AoInputs& inputs, const Camera& camera) {
    return {ao, Image<float>(ao.size, 0.0f), Image3(ao.size), inputs.view_depth, inputs.rays, camera};
}

}  // namespace

void validate(const TemporalSettings& s) {
    require_within("history", s.longest, 1, kMostFramesOfHistory);
    require_within("history_depth", static_cast<double>(s.depth), 0, 1);
    require_within("history_normal", static_cast<double>(s.normal), -1, 1);
}

AoHistory temporal_accumulation(const Image<float>& ao, const AoInputs& inputs, const Camera& camera,
                                const AoHistory& last, const TemporalSettings& settings, const Run& run) {
    validate(settings);
    if (!last.empty() && last.ao.size != ao.size)
        throw UsageError("history: the last frame's AO map has another size (" +
                         std::to_string(last.ao.size.width) + "x" + std::to_string(last.ao.size.height) +
                         "); give maps of one size");
    AoHistory next = without_past(ao, inputs, camera);
    const bool has_past = !last.empty() && settings.longest > 1;
    const AoHistory& past = has_past ? last : next;
    const Accumulation kernel{
        inputs, ao, past, settings, ViewChange(camera, past.camera, inputs.picture), inputs.near_plane};
    parallel_rows(ao.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < ao.size.width; x += kLanes<F>) {
                    const TexelPoint<F> texel = texel_point<F>(inputs, x, y);
                    const Vec3<F> n = normalize_or<F>(texel.n, {F(0), F(0), F(0)});
                    store(next.normal.x.row(y) + x, n.x);
                    store(next.normal.y.row(y) + x, n.y);
                    store(next.normal.z.row(y) + x, n.z);
                    const F now = load<F>(ao.row(y) + x);
                    F value = now, frames = select(texel.surface, F(1), F(0));
                    if (has_past) {
                        const TakenOver<F> taken = kernel.taken_over(texel);
                        const F history = settings.clamp ? kernel.clamped(taken.ao, x, y) : taken.ao;
                        const F count = min_of(taken.frames + F(1), F(static_cast<float>(settings.longest)));
                        value = select(taken.any, history + (now - history) / max_of(count, F(1)), now);
                        frames = select(taken.any, count, frames);
                    }
                    store(next.ao.row(y) + x, value);
                    store(next.frames.row(y) + x, frames);
                }
            }
        });
    });
    return next;
}

}  // namespace crevice
