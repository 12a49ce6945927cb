#include "chapters/compare/difference_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "chapters/notebook/html.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

constexpr float kAmplification = 16;
constexpr std::size_t kListedPixels = 10;

// How values become greys or colours in [0,1]: affine from [low, high], the same for both sides of a pair.
struct ShownRange {
    float low = 0, high = 1;
    bool linear_light = false;

    float operator()(float value) const {
        const float scaled = (value - low) / (high - low);
        const float clamped = scaled < 0 ? 0 : (scaled > 1 ? 1 : scaled);  // keeps NaN, to be shown
        return linear_light && !std::isnan(clamped) ? srgb_from_linear(clamped) : clamped;
    }
    std::string text() const {
        const std::string range = exact_text(low) + " black to " + exact_text(high) + " white";
        return linear_light ? range + ", sRGB curve" : range;
    }
};

// [0, 1] where it holds all finite values; else [-1, 1] for several components, all there is for one.
ShownRange shown_range(const DifferenceEntry& entry) {
    float low = 0, high = 1;
    for (const Planes* planes : {&entry.a, &entry.b}) {
        for (const Image<float>& plane : *planes) {
            const BufferStatistics statistics = buffer_statistics(plane);
            low = std::min(low, statistics.min);
            high = std::max(high, statistics.max);
        }
    }
    const Planes& known = entry.a.empty() ? entry.b : entry.a;
    if (known.size() > 1) return {low < 0 ? -1.0f : 0.0f, 1, entry.linear_light};
    return {low, high, false};
}

Planes shown_values(const Planes& planes, const ShownRange& range) {
    Planes shown = planes;
    for (Image<float>& plane : shown) {
        for (float& value : plane.pixels) value = range(value);
    }
    return shown;
}

Planes amplified_difference(const Planes& a, const Planes& b) {
    Planes difference = a;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t i = 0; i < a[c].pixels.size(); ++i) {
            difference[c].pixels[i] = kAmplification * std::fabs(a[c].pixels[i] - b[c].pixels[i]);
        }
    }
    return difference;
}

std::string picture_element(const Planes& shown, const std::string& alt, const std::string& classes = "") {
    Picture picture;
    if (shown.size() == 1) {
        picture = grey_picture(shown[0], 0, 1);
    } else {
        Image3 colours;
        colours.x = shown[0];
        colours.y = shown[1];
        colours.z = shown.size() > 2 ? shown[2] : Image<float>(shown[0].size, 0.0f);
        picture = colour_picture(colours);
    }
    return image_element(png_bytes(picture.size, picture.channels, picture.pixels), picture.size, alt,
                         classes);
}

std::string captioned(const std::string& html, const std::string& caption) {
    return "<div>" + html + "<p class=\"about\"><b>" + escape_html(caption) + "</b></p></div>\n";
}

// A, which flips to B under the pointer and stays so after a click; B; and their difference.
std::string pictures(const DifferenceEntry& entry, const DifferenceLabels& labels, bool comparable) {
    const ShownRange range = shown_range(entry);
    const Planes a = shown_values(entry.a, range), b = shown_values(entry.b, range);
    std::string html = "<figure>\n<div class=\"pictures row\">\n";
    if (comparable) {
        html += captioned("<label class=\"flip\"><input type=\"checkbox\" aria-label=\"flip\">" +
                              picture_element(a, labels.a) + "<span class=\"tag\">" + escape_html(labels.a) +
                              "</span>" + picture_element(b, labels.b, "second") +
                              "<span class=\"tag second\">" + escape_html(labels.b) + "</span></label>",
                          labels.a + ": point at it to see " + labels.b + ", click to keep it");
    } else if (!a.empty()) {
        html += captioned(picture_element(a, labels.a), labels.a);
    }
    if (!b.empty()) html += captioned(picture_element(b, labels.b), labels.b);
    if (comparable)
        html += captioned(picture_element(amplified_difference(a, b), "difference"), "|difference| × 16");
    return html + "</div>\n<p class=\"about\">Shown: " + range.text() + "; NaN magenta.</p>\n</figure>\n";
}

std::string table_row(const std::string& name, const std::string& value_html) {
    return "<tr><td>" + escape_html(name) + "</td><td class=\"number\">" + value_html + "</td></tr>\n";
}

std::string metrics_table(const ImageError& error) {
    std::string html = "<div><h3>Metrics</h3>\n<table>\n";
    for (const auto& [name, value] : error_rows(error)) html += table_row(name, escape_html(value));
    return html + "</table></div>\n";
}

// How many values differ by how much, in decades; bars are to the scale of the largest count but that of 0.
std::string histogram(const DifferenceEntry& entry) {
    constexpr std::array<float, 9> kBounds = {1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 0.1f, 1, 10};
    std::array<long long, kBounds.size() + 1> counts{};
    long long zero = 0, broken = 0;
    for (const Image<float>& plane : signed_difference(entry.a, entry.b)) {
        for (int y = 0; y < plane.size.height; ++y) {
            for (int x = 0; x < plane.size.width; ++x) {
                const float magnitude = std::fabs(plane.at(x, y));
                if (!std::isfinite(magnitude)) {
                    ++broken;
                } else if (magnitude == 0) {
                    ++zero;
                } else {
                    const auto bound = std::upper_bound(kBounds.begin(), kBounds.end(), magnitude);
                    ++counts[static_cast<std::size_t>(bound - kBounds.begin())];
                }
            }
        }
    }
    const long long largest = std::max(1LL, *std::max_element(counts.begin(), counts.end()));
    std::string html =
        "<div><h3>Values by |difference|</h3>\n<table>\n" + table_row("0", std::to_string(zero));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::string label = i < kBounds.size() ? "below " + exact_text(kBounds[i]) : "10 and more";
        const long long width_px = counts[i] == 0 ? 0 : 2 + 150 * counts[i] / largest;
        html += "<tr><td>" + label + "</td><td class=\"number\">" + std::to_string(counts[i]) +
                "</td><td><span class=\"bar\" style=\"width:" + std::to_string(width_px) +
                "px\"></span></td></tr>\n";
    }
    return html + table_row("NaN, infinite", std::to_string(broken)) + "</table></div>\n";
}

std::string values_at(const Planes& planes, PixelPosition at) {
    std::string text;
    for (const Image<float>& plane : planes)
        text += (text.empty() ? "" : " ") + exact_text(plane.at(at.x, at.y));
    return text;
}

std::string first_pixels(const DifferenceEntry& entry, const DifferenceLabels& labels) {
    const auto found = first_differing_pixels(entry.a, entry.b, kListedPixels);
    if (found.empty()) return "";
    const Planes difference = signed_difference(entry.a, entry.b);
    std::string html = "<div><h3>First differing pixels</h3>\n<div class=\"scroll\"><table>\n<tr>";
    for (const std::string& head :
         {std::string("x"), std::string("y"), labels.a, labels.b, labels.a + " − " + labels.b}) {
        html += "<th class=\"number\">" + escape_html(head) + "</th>";
    }
    html += "</tr>\n";
    for (const PixelPosition at : found) {
        html += "<tr>";
        for (const std::string& cell : {std::to_string(at.x), std::to_string(at.y), values_at(entry.a, at),
                                        values_at(entry.b, at), values_at(difference, at)}) {
            html += "<td class=\"number\">" + cell + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</table></div></div>\n";
}

struct JudgedEntry {
    const DifferenceEntry* entry = nullptr;
    std::optional<ImageError> error;  // none: the two cannot be compared

    bool differs() const { return !error || !error->identical(); }
};

JudgedEntry judge(const DifferenceEntry& entry) {
    const Planes &a = entry.a, &b = entry.b;
    const bool comparable = !a.empty() && a.size() == b.size() && !a[0].empty() && a[0].size == b[0].size;
    return {&entry, comparable ? std::optional(compare_images(a, b)) : std::nullopt};
}

std::string section(const JudgedEntry& judged, const DifferenceLabels& labels) {
    const DifferenceEntry& entry = *judged.entry;
    std::string html = "<section>\n<h2>" + escape_html(entry.title()) + " ";
    html += judged.differs() ? "<span class=\"bad\">✗ differs</span></h2>\n"
                             : "<span class=\"good\">✓ identical</span></h2>\n";
    if (!entry.note.empty()) html += "<p>" + escape_html(entry.note) + "</p>\n";
    if (!judged.error) {
        html += "<p class=\"bad\">There is no pair of one shape to compare.</p>\n";
        return html + pictures(entry, labels, false) + "</section>\n";
    }
    html += pictures(entry, labels, true) + "<div class=\"side\">\n" + metrics_table(*judged.error);
    html += histogram(entry) + "</div>\n" + first_pixels(entry, labels);
    return html + "</section>\n";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> error_rows(const ImageError& error) {
    const auto number = [](double value) { return significant_text(value, 6); };
    const std::string of_all = " of " + std::to_string(error.pixels);
    return {{"RMSE", number(error.rmse)},
            {"MAE", number(error.mae)},
            {"signed bias", number(error.bias)},
            {"max", number(error.max_abs)},
            {"p99", number(error.p99)},
            {"SSIM", number(error.ssim)},
            {"differing pixels", std::to_string(error.differing_pixels) + of_all},
            {"NaN or infinite", std::to_string(error.nan_or_inf) + of_all}};
}

std::string difference_page(std::span<const DifferenceEntry> entries, const DifferenceLabels& labels) {
    std::vector<JudgedEntry> judged;
    for (const DifferenceEntry& entry : entries) judged.push_back(judge(entry));
    std::stable_partition(judged.begin(), judged.end(),
                          [](const JudgedEntry& pair) { return pair.differs(); });
    const auto differing =
        std::count_if(judged.begin(), judged.end(), [](const JudgedEntry& pair) { return pair.differs(); });
    std::string body = "<main>\n<h1>" + escape_html(labels.title) + "</h1>\n<p>" + std::to_string(differing) +
                       " of " + std::to_string(judged.size()) + " differ.</p>\n";
    for (const JudgedEntry& pair : judged) body += section(pair, labels);
    return html_page(labels.title, body + "</main>\n");
}

}  // namespace crevice
