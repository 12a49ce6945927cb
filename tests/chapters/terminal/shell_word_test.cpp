// Words for a shell.
#include "chapters/terminal/shell_word.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("shell_word: what a shell would read something into stands in quotes") {
    CHECK(shell_word("columns") == "columns");
    CHECK(shell_word("--eye=-1,2.5,3e-7") == "--eye=-1,2.5,3e-7");
    CHECK(shell_word("my model's.obj") == "'my model'\\''s.obj'");
    CHECK(shell_word("$HOME") == "'$HOME'");
    CHECK(shell_word("") == "''");
}
