// Instruction counts of passes: as a file, and compared with one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crevice {

struct InstructionCount {
    std::string scene, pass;
    long long instructions = 0;

    friend bool operator==(const InstructionCount&, const InstructionCount&) = default;
};

struct InstructionFigures {
    std::string compiler;  // compiler_name() of the program that was counted
    std::vector<InstructionCount> counts;
};

// Another compiler makes other instructions of the same text: its counts say nothing about ours.
inline constexpr double kInstructionLimit = 0.03;  // part by which a count may grow or shrink unnoticed

// {"compiler": ..., "instructions": {SCENE: {PASS: count, ...}, ...}}
std::string figures_text(const InstructionFigures& figures);
// Throws InputError naming the file when the text is not of that form or a count is not above 0.
InstructionFigures figures_from_text(std::string_view text, const std::string& file);

// The count of this scene and pass; null when there is none.
const InstructionCount* find_count(const InstructionFigures& figures, const std::string& scene,
                                   const std::string& pass);

// One line for each count that differs from the stored one by more than the limit, or stands on one side
// only. Empty: all is as it was.
std::vector<std::string> changed_counts(const InstructionFigures& stored, const InstructionFigures& measured);

}  // namespace crevice
