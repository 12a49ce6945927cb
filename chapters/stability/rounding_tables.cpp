#include "chapters/notebook/html.h"
#include "chapters/stability/rounding.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// A row of a table on the page; `tag` is th or td.
std::string row_element(const char* tag, const std::vector<std::string>& cells) {
    std::string html = "<tr>";
    for (const std::string& cell : cells)
        html += std::string("<") + tag + ">" + escape_html(cell) + "</" + tag + ">";
    return html + "</tr>\n";
}

// Ulps as whole numbers where there are many.
std::string count_text(double value) {
    constexpr double kMany = 10;
    return value < kMany ? significant_text(value, 2) : decimal_text(value, 0);
}

std::string pass_table(const CaseRounding& rounding) {
    std::string html = "<div class=\"scroll\">\n<table>\n" +
                       row_element("th", {"pass", "unit", "mean", "99th percentile", "largest"});
    for (const PassRounding& pass : rounding.passes)
        html += row_element("td", {pass.pass, pass.unit, count_text(pass.off.mean), count_text(pass.off.p99),
                                   count_text(pass.off.max)});
    return html + "</table>\n</div>\n";
}

std::string ulps_text(const std::optional<AoRounding>& rounding) {
    return rounding ? count_text(rounding->off.p99 / kAoUlp) : "none";
}

std::string method_table(const CaseRounding& rounding) {
    std::string html =
        "<div class=\"scroll\">\n<table>\n" +
        row_element("th", {"method", "kernel, ulps", "depth, ulps", "normal, ulps", "all, ulps",
                           "all, mean AO", "all, largest AO", "decided otherwise", "blurred, largest AO"});
    for (const MethodRounding& method : rounding.methods) {
        const AoRounding &all = *method.of(RoundingCause::all), &blurred = *method.of(RoundingCause::blurred);
        html += row_element(
            "td", {method.method->name, ulps_text(method.of(RoundingCause::kernel)),
                   ulps_text(method.of(RoundingCause::depth)), ulps_text(method.of(RoundingCause::normal)),
                   ulps_text(method.of(RoundingCause::all)), significant_text(all.off.mean, 2),
                   significant_text(all.off.max, 2), percent_text(all.decided_otherwise),
                   significant_text(blurred.off.max, 2)});
    }
    return html + "</table>\n</div>\n";
}

constexpr const char* kExplanation = R"html(<h2 id="rounding">Rounding against an independent judge</h2>
<p>The judge works in double from the scene itself: it sends the eye's ray through each pixel's centre onto the plane of the
triangle that the pixel shows, and interpolates the vertex normals there. The rasterizer tells it only which triangle that
is. Then it runs the same text of each method's kernel in double on its own depths and normals. So it sees errors that were
made before a pass as well as the pass's own. Maps are of the picture's size; what a texel of half size takes from its four
pixels is a pass of its own, its kernel in double as well. Settings, the tables of random numbers and the
scale of the eye's rays are floats and taken as given. Blurs run in float, because what they keep from one iteration to the
next are maps of floats; each adds less than 0.00001 of its own, which the tests hold against references in double.</p>
<p>An ulp is the step from a float to the next; of accessibility it is 2<sup>-24</sup>. Columns that are named after a cause
hold 99th percentiles: <i>kernel</i>, the map in float against the same kernel in double, from the same float buffers;
<i>depth</i> and <i>normal</i>, what the roundings of one buffer change, the kernel in double; <i>all</i>, float from end to
end against double from end to end; <i>blurred</i>, what the denoiser leaves of that. A texel that is off by more than 0.0001
was not rounded: a comparison came out otherwise (a sample just hidden or just seen), and a whole sample's share with it.</p>
<h3>Where it arises</h3>
<ul>
<li><b>Vertex transform.</b> The eye is subtracted from the vertices in double, so that no distance from the origin costs
anything: what is left is the rounding of the result.</li>
<li><b>View depth</b> is a plane through the triangle's corners and has the rounding of the farthest one everywhere: near
pixels of large triangles are off by many ulps of their own, the more the flatter the plane is seen.</li>
<li><b>Normals</b> are interpolated between corners that were snapped to 1/256 pixel. A corner that moves takes its normal
with it: on curved meshes of small triangles this is far more than rounding.</li>
<li><b>The depth buffer</b> holds numbers close to 1, where a step stands for z<sup>2</sup>/near times as much depth. A
method that reads it (luna) loses that much; all others read view depth.</li>
<li><b>Kernels</b> subtract points that lie close together: of a difference of the size of the radius they keep ulps of the
depth, depth/radius times as large a share. This is the cancellation that all screen-space methods have, and why their
tolerances grow with depth.</li>
<li><b>xjun and luna</b> look up random vectors at coordinates that run 1024 times across the picture: ten bits of a float go
into whole texels there, and what is left places the samples. It is the largest part of what xjun's kernel is off; luna's
also filters depths close to 1.</li>
</ul>
)html";

}  // namespace

Table pass_rounding_table(const std::vector<CaseRounding>& cases) {
    Table table{"rounding_passes", {"case", "pass", "unit", "mean", "p99", "max"}, {}};
    for (const CaseRounding& rounding : cases) {
        for (const PassRounding& pass : rounding.passes) {
            table.rows.push_back({rounding.of.name, pass.pass, pass.unit, TableValue(pass.off.mean, 6),
                                  TableValue(pass.off.p99, 6), TableValue(pass.off.max, 6)});
        }
    }
    return table;
}

Table method_rounding_table(const std::vector<CaseRounding>& cases) {
    Table table{
        "rounding_methods",
        {"case", "method", "cause", "mean_ao", "p99_ao", "max_ao", "p99_ulps", "decided_otherwise", "note"},
        {}};
    for (const CaseRounding& rounding : cases) {
        for (const MethodRounding& method : rounding.methods) {
            for (const RoundingCause cause : kRoundingCauses) {
                std::vector<TableValue> row = {rounding.of.name, method.method->name, word_of(cause)};
                if (const std::optional<AoRounding>& found = method.of(cause)) {
                    row.insert(row.end(),
                               {TableValue(found->off.mean, 9), TableValue(found->off.p99, 9),
                                TableValue(found->off.max, 9), TableValue(found->off.p99 / kAoUlp, 1),
                                TableValue(found->decided_otherwise, 6), ""});
                } else {
                    row.insert(row.end(), {{}, {}, {}, {}, {}, why_not_in_double(*method.method)});
                }
                table.rows.push_back(std::move(row));
            }
        }
    }
    return table;
}

std::string rounding_section(const std::vector<CaseRounding>& cases) {
    if (cases.empty()) return "";
    std::string html = kExplanation;
    html += "<p>Methods whose column is empty have no kernel in double.";
    for (const MethodRounding& method : cases.front().methods) {
        const std::string why = why_not_in_double(*method.method);
        if (!why.empty())
            html += std::string(" <b>") + method.method->name + "</b>: " + escape_html(why) + ".";
    }
    html += " Their maps are compared with those of the judge's buffers rounded to float once.</p>\n";
    for (const CaseRounding& rounding : cases)
        html += "<h3>" + escape_html(rounding.of.name) + "</h3>\n<p>" + escape_html(rounding.of.question) +
                ".</p>\n" + pass_table(rounding) + method_table(rounding);
    return html;
}

}  // namespace crevice
