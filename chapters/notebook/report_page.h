// The parts that the pages of all benchmarks share.
#pragma once

#include <span>
#include <string>

#include "chapters/notebook/table.h"

namespace crevice {

// A <table> of two columns.
std::string facts_element(const Facts& facts);

// Each table under its name, as on the terminal.
std::string table_elements(std::span<const Table> tables);

}  // namespace crevice
