// A word of a command line that somebody will paste into a shell.
#pragma once

#include <string>

namespace crevice {

// As it is where no shell reads anything into it, else in single quotes.
std::string shell_word(const std::string& word);

}  // namespace crevice
