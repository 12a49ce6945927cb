#include "chapters/props/error_walk.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// What a part's picture says, by the name of its step.
std::string caption_of(const std::string& step) {
    if (step == "depth buffer")
        return "S - T, the depth buffer: red where an occluder is hidden or outside of the picture, blue "
               "where the space behind "
               "a front edge is taken for solid.";
    if (step == "definition")
        return "C - S, the definition: the method asks 14 points near the surface, not rays.";
    if (step == "half size") return "Half size: edges are stretched over two pixels.";
    if (step == "sampling") return "Sampling: the noise of 14 samples with one random turn.";
    if (step == "float16")
        return "Storage in 16-bit floats: a few pixels of slanted surfaces, where one step of depth is too "
               "coarse.";
    if (step == "rounding") return "Rounding: the last bits of floats.";
    if (step == "blur, bias") return "What the blur does wrong: it also smooths what was no noise.";
    return "What the blur does right: it takes the noise away again, so it is the sampling picture turned "
           "round.";
}

}  // namespace

std::string error_steps(const ErrorParts& parts, const std::string& title) {
    constexpr double kLeft = 150, kWidth = 360, kRow = 30, kTop = 40, kBarHeight = 18;
    double reached = 0, low = 0, high = 0;
    for (const ErrorPart& part : parts.parts) {
        reached += part.share;
        low = std::min(low, reached);
        high = std::max(high, reached);
    }
    const auto x = [&](double mse) { return kLeft + kWidth * (mse - low) / (high - low); };
    const auto millionths = [](double mse) { return decimal_text(1e6 * mse, 0); };
    std::string svg;
    double y = kTop;
    reached = 0;
    const auto row = [&](const std::string& name, double from, double to, std::string_view colour) {
        svg += svg_text({kLeft - 10, y + 13}, name, TextAnchor::end);
        svg += svg_box({x(from), y}, {x(to), y + kBarHeight}, colour, millionths(to - from));
        svg +=
            svg_text({x(std::max(from, to)) + 6, y + 13}, millionths(to - from), TextAnchor::start, kSvgSoft);
        y += kRow;
    };
    for (const ErrorPart& part : parts.parts) {
        row(part.step, reached, reached + part.share, part.share > 0 ? kSvgOccluded : kSvgOpen);
        reached += part.share;
    }
    row("all of it", 0, parts.total.share, kSvgInk);
    svg += svg_line({x(0), kTop - 4}, {x(0), y}, kSvgSoft);
    return svg_picture(title, kLeft + kWidth + 70, y + 6, svg);
}

std::vector<std::vector<std::string>> part_rows(const ErrorParts& parts) {
    std::vector<std::vector<std::string>> rows;
    const auto add = [&](const std::string& name, const ErrorPart& part) {
        rows.push_back({name, decimal_text(part.bias, 5), decimal_text(part.rmse, 4),
                        decimal_text(1e6 * part.share, 1)});
    };
    for (const ErrorPart& part : parts.parts) add(part.step, part);
    add("all of it", parts.total);
    return rows;
}

bool parts_add_up(const ErrorParts& parts) {
    double bias = 0, share = 0;
    for (const ErrorPart& part : parts.parts) bias += part.bias, share += part.share;
    return std::fabs(bias - parts.total.bias) < 1e-12 && std::fabs(share - parts.total.share) < 1e-12;
}

std::vector<Notebook::Named> part_pictures(const ErrorParts& parts) {
    std::vector<Notebook::Named> pictures;
    constexpr double kSeen = 0.002;  // RMSE; a picture of less is white
    for (const ErrorPart& part : parts.parts) {
        if (part.rmse < kSeen) continue;
        std::string name = "part_" + part.step;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }, '_');
        pictures.push_back({name, difference_picture(part.difference), caption_of(part.step)});
    }
    return pictures;
}

}  // namespace crevice
