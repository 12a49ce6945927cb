// What the names of TeX's mathematics are in Unicode.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

// "α" of "alpha", a space of the commands that are one, nothing of those that only size or set; else the name itself.
std::string symbol_named(const std::string& name);

// "≤" of "le", and of others that stand between spaces; null for what is none.
const std::string* relation_named(const std::string& name);

// "sin", "max": names that are printed, with a space behind them.
bool is_function(const std::string& name);

// Those that run over something.
bool is_large_operator(const std::string& name);

// The combining mark of \overline, \bar, \hat; null for others.
const char* mark_over(const std::string& name);

// The text in small raised or lowered characters; empty when one of them has no such form. Letters are never lowered: most
// have no such form, and those that have would stand beside others that do not.
std::string small_text(std::string_view text, bool raised);

}  // namespace crevice
