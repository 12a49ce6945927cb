// Numbers that a chapter computes and its prose names: "the error falls to {rmse}". None is ever typed.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

using ProseNumbers = std::map<std::string, std::string>;  // by name, as they are to be read

// Every {name} of a Markdown text with its number. Inside `code` braces are left alone; inside $mathematics$ a number is
// {{name}}, since mathematics has braces of its own. Throws UsageError naming each name that has no number.
std::string with_numbers(std::string_view markdown, const ProseNumbers& numbers);

// The other way: "from 2 to 1e+06" becomes "from {1} to {2}", and `numbers`, empty before, holds what {1} and {2} were.
std::string numbers_taken_out(std::string_view text, ProseNumbers& numbers);

// The names that a text asks for, in their order.
std::vector<std::string> numbers_named(std::string_view markdown);

}  // namespace crevice
