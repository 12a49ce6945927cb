#include "chapters/bench/instruction_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "chapters/terminal/json_text.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

bool differs(long long stored, long long measured) {
    return std::fabs(static_cast<double>(measured - stored)) >
           kInstructionLimit * static_cast<double>(stored);
}

double change_percent(long long stored, long long measured) {
    return 100 * (static_cast<double>(measured) / static_cast<double>(stored) - 1);
}

}  // namespace

std::string figures_text(const InstructionFigures& figures) {
    Json scenes = Json::object();
    for (const InstructionCount& count : figures.counts) scenes[count.scene][count.pass] = count.instructions;
    return json_text(Json{{"compiler", figures.compiler}, {"instructions", scenes}});
}

InstructionFigures figures_from_text(std::string_view text, const std::string& file) {
    const auto fail = [&](const std::string& what) {
        throw InputError(file + ": " + what + "; write it anew with crevice bench --instructions --bless");
    };
    InstructionFigures figures;
    try {
        const Json whole = json_from_text(std::string(text));
        figures.compiler = whole.at("compiler").get<std::string>();
        for (const auto& [scene, passes] : whole.at("instructions").items()) {
            if (!passes.is_object()) fail("no passes (" + scene + ")");
            for (const auto& [pass, count] : passes.items()) {
                if (!count.is_number_integer()) fail("not a whole number (" + scene + ", " + pass + ")");
                figures.counts.push_back({scene, pass, count.get<long long>()});
                if (figures.counts.back().instructions <= 0) fail("no count (" + scene + ", " + pass + ")");
            }
        }
    } catch (const Json::exception& error) {
        fail(std::string("not stored figures (") + error.what() + ")");
    }
    return figures;
}

const InstructionCount* find_count(const InstructionFigures& figures, const std::string& scene,
                                   const std::string& pass) {
    const auto at = std::find_if(
        figures.counts.begin(), figures.counts.end(),
        [&](const InstructionCount& count) { return count.scene == scene && count.pass == pass; });
    return at == figures.counts.end() ? nullptr : &*at;
}

std::vector<std::string> changed_counts(const InstructionFigures& stored,
                                        const InstructionFigures& measured) {
    std::vector<std::string> lines;
    for (const InstructionCount& now : measured.counts) {
        const std::string what = now.scene + ", " + now.pass + ": " + std::to_string(now.instructions);
        const InstructionCount* const before = find_count(stored, now.scene, now.pass);
        if (before == nullptr) {
            lines.push_back(what + " instructions, no stored figure");
        } else if (differs(before->instructions, now.instructions)) {
            char percent[64];
            std::snprintf(percent, sizeof percent, " (%+.1f %%, limit %.0f %%)",
                          change_percent(before->instructions, now.instructions), 100 * kInstructionLimit);
            lines.push_back(what + " instructions, stored " + std::to_string(before->instructions) + percent);
        }
    }
    for (const InstructionCount& before : stored.counts) {
        if (find_count(measured, before.scene, before.pass) != nullptr) continue;
        lines.push_back(before.scene + ", " + before.pass + ": not measured, stored " +
                        std::to_string(before.instructions));
    }
    return lines;
}

}  // namespace crevice
