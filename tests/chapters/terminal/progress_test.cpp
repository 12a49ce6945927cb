#include "chapters/terminal/progress.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("progress_line: bar, part and time left") {
    CHECK(progress_line("truth", 0, 10, 5) == "truth  [........................]    0%");
    CHECK(progress_line("truth", 5, 10, 12) == "truth  [############............]   50%  0:12 left");
    CHECK(progress_line("truth", 1, 4, 30) == "truth  [######..................]   25%  1:30 left");
    CHECK(progress_line("truth", 10, 10, 12) == "truth  [########################]  100%  0:00 left");
    CHECK(progress_line("nothing", 0, 0, 0) == "nothing  [########################]  100%  0:00 left");
    // More steps than announced are no reason to draw outside the bar.
    CHECK(progress_line("truth", 12, 10, 12) == "truth  [########################]  100%  0:00 left");
}
