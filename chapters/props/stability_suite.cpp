#include "chapters/props/stability_suite.h"

#include <algorithm>
#include <string_view>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

std::string_view colour_of(StabilityVerdict verdict) {
    switch (verdict) {
        case StabilityVerdict::exact: return kSvgPoint;
        case StabilityVerdict::within: return kSvgOpen;
        case StabilityVerdict::warned: return kSvgSoft;
        case StabilityVerdict::wrong: return kSvgOccluded;
    }
    return kSvgInk;
}

}  // namespace

int StabilitySuite::count(StabilityVerdict verdict) const {
    return static_cast<int>(std::ranges::count(cells, verdict, &StabilityCell::verdict));
}

StabilitySuite stability_suite(const std::vector<std::string>& methods) {
    StabilitySuite suite{stiff_cases(true), {}};
    for (const StiffCase& stiff : suite.cases) {
        for (const std::string& method : methods)
            suite.cells.push_back(stability_cell(stiff, find_method(method), {}));
    }
    return suite;
}

std::string heat_map(const std::vector<StabilityCell>& cells, const std::vector<std::string>& methods) {
    constexpr double kLeft = 250, kTop = 64, kWidth = 74, kRow = 22;
    std::string svg;
    const std::size_t columns = methods.size(), rows = cells.size() / columns;
    for (std::size_t column = 0; column < columns; ++column)
        svg += svg_text({kLeft + kWidth * (static_cast<double>(column) + 0.5), kTop - 10}, methods[column],
                        TextAnchor::middle);
    for (std::size_t row = 0; row < rows; ++row) {
        const double y = kTop + kRow * static_cast<double>(row);
        svg += svg_text({kLeft - 8, y + 15}, cells[row * columns].stiff->name, TextAnchor::end);
        for (std::size_t column = 0; column < columns; ++column) {
            const StabilityCell& cell = cells[row * columns + column];
            const double x = kLeft + kWidth * static_cast<double>(column);
            svg += svg_box(
                {x + 2, y + 2}, {x + kWidth - 2, y + kRow - 2}, colour_of(cell.verdict),
                std::string(word_of(cell.verdict)) + ", measured " + significant_text(cell.measured, 3));
        }
    }
    const double bottom = kTop + kRow * static_cast<double>(rows) + 24;
    double x = kLeft;
    for (const StabilityVerdict verdict : {StabilityVerdict::exact, StabilityVerdict::within,
                                           StabilityVerdict::warned, StabilityVerdict::wrong}) {
        svg += svg_box({x, bottom - 11}, {x + 12, bottom + 1}, colour_of(verdict), word_of(verdict)) +
               svg_text({x + 18, bottom}, word_of(verdict));
        x += 92;
    }
    return svg_picture("Stiff cases and methods", kLeft + kWidth * static_cast<double>(columns) + 10,
                       bottom + 14, svg);
}

}  // namespace crevice
