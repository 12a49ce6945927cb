#include "chapters/bench/scale_page.h"

#include "chapters/bench/plot.h"
#include "chapters/html.h"

namespace crevice {

namespace {

std::string facts_element(const Facts& facts) {
    std::string html = "<table>\n";
    for (const auto& [name, value] : facts)
        html += "<tr><th>" + escape_html(name) + "</th><td>" + escape_html(value) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string time_plot(const ScaleStudy& study) {
    std::vector<PlotCurve> curves;
    for (const PassTime& pass : study.figures.front().passes)
        curves.push_back({pass.name, study.x, study.wall_ms(pass.name)});
    return log_log_plot("Time over " + study.name, study.name, "median wall time, ms", curves);
}

std::string memory_plot(const ScaleStudy& study) {
    std::vector<double> megabytes = study.peak_bytes();
    for (double& value : megabytes) value *= 1e-6;
    return log_log_plot("Memory over " + study.name, study.name, "peak memory, MB",
                        {{"peak", study.x, megabytes}});
}

}  // namespace

std::string scale_page(const BenchReport& report, const std::vector<ScaleStudy>& studies) {
    std::string body = "<h1>How time and memory grow</h1>\n" + facts_element(report.facts);
    for (const ScaleStudy& study : studies) {
        body += "<h2>Over " + escape_html(study.name) + "</h2>\n" + time_plot(study);
        if (study.name != "samples") body += memory_plot(study);
    }
    for (const Table& table : report.tables)
        body +=
            "<h2>" + escape_html(table.name) + "</h2>\n<pre>" + escape_html(table_text(table)) + "</pre>\n";
    return html_page("crevice bench --scale", body);
}

}  // namespace crevice
