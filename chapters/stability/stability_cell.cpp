#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "chapters/stability/stability.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

Frame frame_of(const StiffView& view, const Method& method, const Run& run) {
    FrameRequest request;
    request.size = view.size;
    request.method = &method;
    request.settings = settings_of(view, method);
    request.wanted = {"ao_raw", "ao_blurred"};
    request.run = run;
    return render_frame(view.scene, view.camera, request);
}

// What a map holds of surfaces, and whether all of it is a number in [0,1].
struct MapFigures {
    double below_one = 0;  // the mean of 1 - AO
    double largest_below = 0;
    bool in_range = true;
};
MapFigures figures_of(const Image<float>& ao) {
    MapFigures figures;
    const double count = static_cast<double>(ao.size.width) * ao.size.height;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const float value = ao.at(x, y);
            figures.in_range = figures.in_range && value >= 0 && value <= 1;
            figures.below_one += (1 - static_cast<double>(value)) / count;
            figures.largest_below = std::max(figures.largest_below, 1 - static_cast<double>(value));
        }
    }
    return figures;
}

double largest_difference(const Image<float>& a, const Image<float>& b) {
    if (!(a.size == b.size)) return 1;
    double largest = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x)
            largest = std::max(largest,
                               std::fabs(static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y))));
    }
    return largest;
}

std::string first_warning(const Frame& frame) {
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) return loss.warning;
    }
    return "";
}

double covered_share(const Image<float>& view_depth) {
    double surfaces = 0;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x)
            surfaces += view_depth.at(x, y) < std::numeric_limits<float>::infinity() ? 1 : 0;
    }
    return surfaces / (static_cast<double>(view_depth.size.width) * view_depth.size.height);
}

bool covers(const StiffCase& stiff, double covered, Size size) {
    if (!stiff.covered) return true;
    const double row = 1.0 / std::min(size.width, size.height);
    return std::fabs(covered - *stiff.covered) <= row;
}

StabilityVerdict verdict_of(bool in_range, double off, double stated, bool warned) {
    if (!in_range) return StabilityVerdict::wrong;
    if (off == 0) return StabilityVerdict::exact;
    if (off <= stated) return StabilityVerdict::within;
    return warned ? StabilityVerdict::warned : StabilityVerdict::wrong;
}

// How far the frame is from the stated answer, and how far it may be.
struct Measured {
    double off = 0, stated = 0;
};
Measured measured_of(const StiffCase& stiff, const Method& method, const Frame& frame, const Run& run) {
    const MapFigures raw = figures_of(frame.ao_raw), smooth = figures_of(frame.ao_blurred);
    switch (stiff.answer) {
        case Answer::open: return {std::max(raw.below_one, smooth.below_one), kStatedBias};
        case Answer::same:
            return {largest_difference(frame.ao_raw, frame_of(stiff.same_as(), method, run).ao_raw), 0};
        case Answer::background: return {std::max(raw.largest_below, smooth.largest_below), 0};
        case Answer::in_range:
        case Answer::refused: break;
    }
    return {};
}

bool in_range(const Frame& frame) {
    return figures_of(frame.ao_raw).in_range && figures_of(frame.ao_blurred).in_range;
}

}  // namespace

StabilityCell stability_cell(const StiffCase& stiff, const Method& method, const Run& run) {
    StabilityCell cell;
    cell.stiff = &stiff;
    cell.method = &method;
    std::optional<Frame> frame;
    try {
        frame = frame_of(stiff.view(), method, run);
    } catch (const Error& refusal) {
        cell.warning = refusal.what();
        cell.verdict = stiff.answer == Answer::refused ? StabilityVerdict::exact : StabilityVerdict::warned;
        return cell;
    }
    cell.warning = first_warning(*frame);
    cell.ao = ao_picture(frame->ao_raw);
    cell.covered = covered_share(frame->gbuffer.view_depth);
    const Measured measured = measured_of(stiff, method, *frame, run);
    cell.measured = measured.off;
    const bool warned = !cell.warning.empty();
    cell.verdict = verdict_of(in_range(*frame), measured.off, measured.stated, warned);
    if (!covers(stiff, cell.covered, frame->gbuffer.view_depth.size))
        cell.verdict = std::max(cell.verdict, warned ? StabilityVerdict::warned : StabilityVerdict::wrong);
    if (stiff.answer == Answer::refused) cell.verdict = StabilityVerdict::wrong;
    return cell;
}

}  // namespace crevice
