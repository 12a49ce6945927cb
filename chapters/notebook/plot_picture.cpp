#include "chapters/notebook/plot_picture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

constexpr int kLeft = 34, kRight = 8, kTop = 8, kBottom = 14;  // margins, pixels
constexpr float kLineWidth_px = 1.6f, kDotWidth_px = 5;
constexpr glm::vec3 kGrid{0.87f}, kFrameLine{0.5f}, kDigits{0.25f};

// The characters of labels, three pixels wide and five high, the upper left one first.
constexpr const char* kGlyphs = "0123456789.-e";
constexpr std::uint16_t kGlyphBits[] = {
    0b111101101101111, 0b010110010010111, 0b111001111100111, 0b111001111001111, 0b101101111001001,
    0b111100111001111, 0b111100111101111, 0b111001010010010, 0b111101111101111, 0b111101111001111,
    0b000000000000010, 0b000000111000000, 0b000111111100111};
constexpr int kGlyphWidth = 4, kGlyphHeight = 5;  // with the gap to the next

// One axis of the frame on its way to pixels.
struct Axis {
    double low, high;
    bool logarithmic;
    float from_px, to_px;

    float at(double value) const {
        if (logarithmic) {
            const auto log = [](double v) { return log2_of(static_cast<float>(v)); };
            return from_px + (to_px - from_px) * (log(value) - log(low)) / (log(high) - log(low));
        }
        return from_px + (to_px - from_px) * static_cast<float>((value - low) / (high - low));
    }
    bool can_show(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }

    std::vector<double> grid() const {
        std::vector<double> lines;
        if (!logarithmic) {
            for (int i = 0; i <= 4; ++i) lines.push_back(low + (high - low) * i / 4);
            return lines;
        }
        for (int exponent = -30; exponent <= 30; ++exponent) {
            double power = 1;
            for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
            const double value = exponent < 0 ? 1 / power : power;
            if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) lines.push_back(value);
        }
        return lines;
    }
};

struct Canvas {
    Image3 pixels;
    int x0, y0, x1, y1;  // what series are drawn in

    void blend(int x, int y, glm::vec3 colour, float share) {
        pixels.set(x, y, pixels.at(x, y) + share * (colour - pixels.at(x, y)));
    }

    // A straight stroke with round ends; a dot where both are one point.
    void stroke(glm::vec2 a, glm::vec2 b, float width, glm::vec3 colour) {
        const float reach = 0.5f * width + 1;
        // In whole pixels within the canvas, however far away the ends are.
        const auto first = [&](float p, float q, int low, int high) {
            return static_cast<int>(std::clamp(std::min(p, q) - reach, float(low), float(high)));
        };
        const auto end = [&](float p, float q, int low, int high) {
            return static_cast<int>(std::clamp(std::max(p, q) + reach, float(low), float(high)));
        };
        const float ab_x = b.x - a.x, ab_y = b.y - a.y, squared = ab_x * ab_x + ab_y * ab_y;
        for (int y = first(a.y, b.y, y0, y1); y < end(a.y, b.y, y0, y1); ++y) {
            for (int x = first(a.x, b.x, x0, x1); x < end(a.x, b.x, x0, x1); ++x) {
                const float p_x = static_cast<float>(x) + 0.5f - a.x,
                            p_y = static_cast<float>(y) + 0.5f - a.y;
                const float t = squared > 0 ? saturate((p_x * ab_x + p_y * ab_y) / squared) : 0;
                const float off_x = p_x - t * ab_x, off_y = p_y - t * ab_y;
                const float distance = square_root(off_x * off_x + off_y * off_y);
                blend(x, y, colour, saturate(0.5f * width + 0.5f - distance));
            }
        }
    }

    void label(int x, int y, const std::string& text) {
        for (const char c : text) {
            const std::string_view glyphs = kGlyphs;
            const std::size_t glyph = glyphs.find(c);
            for (int bit = 0; glyph != glyphs.npos && bit < 15; ++bit) {
                const bool set = (kGlyphBits[glyph] >> (14 - bit) & 1) != 0;
                const int at_x = x + bit % 3, at_y = y + bit / 3;
                const bool inside =
                    at_x >= 0 && at_y >= 0 && at_x < pixels.size().width && at_y < pixels.size().height;
                if (set && inside) pixels.set(at_x, at_y, kDigits);
            }
            x += kGlyphWidth;
        }
    }
};

void draw_grid(Canvas& canvas, const Axis& x, const Axis& y) {
    const auto middle = [](float at) { return static_cast<int>(at); };
    for (const double value : x.grid()) {
        const int column = std::min(middle(x.at(value)), canvas.x1 - 1);
        for (int row = canvas.y0; row < canvas.y1; ++row) canvas.pixels.set(column, row, kGrid);
        const std::string text = significant_text(value, 6);
        const int width = kGlyphWidth * static_cast<int>(text.size());
        canvas.label(std::min(column - width / 2, canvas.pixels.size().width - width), canvas.y1 + 4, text);
    }
    for (const double value : y.grid()) {
        const int row = std::min(middle(y.at(value)), canvas.y1 - 1);
        for (int column = canvas.x0; column < canvas.x1; ++column) canvas.pixels.set(column, row, kGrid);
        const std::string text = significant_text(value, 6);
        const int width = kGlyphWidth * static_cast<int>(text.size());
        canvas.label(canvas.x0 - 4 - width, row - kGlyphHeight / 2, text);
    }
    for (int row = canvas.y0; row < canvas.y1; ++row) canvas.pixels.set(canvas.x0, row, kFrameLine);
    for (int column = canvas.x0; column < canvas.x1; ++column)
        canvas.pixels.set(column, canvas.y1 - 1, kFrameLine);
}

void draw_series(Canvas& canvas, const Axis& x, const Axis& y, const PlotSeries& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const auto shown = [&](std::size_t j) { return x.can_show(series.x[j]) && y.can_show(series.y[j]); };
        const auto point = [&](std::size_t j) { return glm::vec2(x.at(series.x[j]), y.at(series.y[j])); };
        if (!shown(i)) continue;
        if (series.mark == PlotMark::dots) {
            canvas.stroke(point(i), point(i), kDotWidth_px, series.colour);
        } else if (i > 0 && shown(i - 1)) {
            canvas.stroke(point(i - 1), point(i), kLineWidth_px, series.colour);
        }
    }
}

void check(Size size, const PlotFrame& frame, std::span<const PlotSeries> series) {
    if (size.width < 64 || size.height < 48)
        throw UsageError("plot: too small (" + std::to_string(size.width) + "x" +
                         std::to_string(size.height) + "); give it at least 64x48 pixels");
    const auto usable = [&](double low, double high) {
        return std::isfinite(low) && std::isfinite(high) && low < high && (!frame.logarithmic || low > 0);
    };
    if (!usable(frame.x_low, frame.x_high) || !usable(frame.y_low, frame.y_high))
        throw UsageError("plot: an axis ends before it begins (x " + significant_text(frame.x_low, 6) +
                         " to " + significant_text(frame.x_high, 6) + ", y " +
                         significant_text(frame.y_low, 6) + " to " + significant_text(frame.y_high, 6) +
                         "); give low < high, above 0 if logarithmic");
    for (const PlotSeries& s : series) {
        if (s.x.size() != s.y.size())
            throw UsageError("plot: " + std::to_string(s.x.size()) + " x for " + std::to_string(s.y.size()) +
                             " y; give as many of each");
    }
}

}  // namespace

Picture plot_picture(Size size, const PlotFrame& frame, std::span<const PlotSeries> series) {
    check(size, frame, series);
    Canvas canvas{Image3(size, glm::vec3(1)), kLeft, kTop, size.width - kRight, size.height - kBottom};
    const Axis x = {frame.x_low, frame.x_high, frame.logarithmic, static_cast<float>(canvas.x0),
                    static_cast<float>(canvas.x1)};
    const Axis y = {frame.y_low, frame.y_high, frame.logarithmic, static_cast<float>(canvas.y1),
                    static_cast<float>(canvas.y0)};
    draw_grid(canvas, x, y);
    for (const PlotSeries& s : series) draw_series(canvas, x, y, s);
    Picture picture = colour_picture(canvas.pixels);
    picture.mapping = std::string("plot, ") + (frame.logarithmic ? "logarithmic" : "linear") + ": x " +
                      significant_text(frame.x_low, 6) + " to " + significant_text(frame.x_high, 6) + ", y " +
                      significant_text(frame.y_low, 6) + " to " + significant_text(frame.y_high, 6);
    return picture;
}

}  // namespace crevice
