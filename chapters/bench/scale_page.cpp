#include "chapters/bench/scale_page.h"

#include "chapters/notebook/html.h"
#include "chapters/notebook/plot.h"
#include "chapters/notebook/report_page.h"

namespace crevice {

namespace {

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
    std::string body = "<h1>How time and memory grow</h1>\n" + facts_element(report.facts) +
                       "<p>Here grow whole frames of one method, each in a program of its own. How the AO "
                       "passes of every method grow, with "
                       "intervals, the report of <code>crevice sweep full</code> shows.</p>\n";
    for (const ScaleStudy& study : studies) {
        body += "<h2>Over " + escape_html(study.name) + "</h2>\n" + time_plot(study);
        if (study.name != "samples") body += memory_plot(study);
    }
    return html_page("crevice bench --scale", body + table_elements(report.tables));
}

}  // namespace crevice
