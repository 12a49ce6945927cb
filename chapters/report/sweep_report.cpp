#include "chapters/report/sweep_report.h"

#include "chapters/notebook/svg.h"
#include "chapters/report/report_html.h"
#include "chapters/report/report_markdown.h"
#include "chapters/report/report_sections.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

void write_sweep_report(const SweepResults& results, const std::filesystem::path& dir) {
    const std::string title = "Error against run time: the sweep " + results.plan;
    const std::vector<ReportSection> sections = report_sections(results);
    try_output_directory(dir / "plots");
    for (const ReportSection& section : sections) {
        for (const ReportBlock& block : section.blocks) {
            for (const Output& output : block.outputs) {
                if (const auto* const drawing = std::get_if<DrawingOutput>(&output))
                    write_file_atomically(dir / (drawing->name + ".svg"), standalone_svg(drawing->svg.en));
            }
        }
    }
    write_file_atomically(dir / "report.md", report_markdown(title, sections));
    write_file_atomically(dir / "report.html", report_html(title, sections));
}

}  // namespace crevice
