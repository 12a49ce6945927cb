#include "chapters/notebook/plain_math.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <doctest/doctest.h>

#include "chapters/notebook/percent_format.h"
#include "chapters/notebook/terminal_text.h"

using namespace crevice;

TEST_CASE("plain math: formulas in one line of Unicode") {
    const std::pair<const char*, const char*> rows[] = {
        {R"(\frac{1}{2\pi} \int_0^{2\pi} \sin h \, d\varphi)", "1/(2π) ∫[0..2π] sin h dφ"},
        {R"(\frac12 + \frac14)", "½ + ¼"},
        {R"(\tfrac{a + b}{c})", "(a + b)/c"},
        {R"(\frac hN)", "h/N"},
        {R"(\sqrt{x_0^2 + 1})", "√(x₀² + 1)"},
        {R"(\sqrt N)", "√N"},
        {R"(2^{-24})", "2⁻²⁴"},
        {R"(2^{k_{front}} - 1)", "2^(k_front) - 1"},
        {R"(e^{-i^2 / 2\sigma^2})", "e^(-i² / 2σ²)"},
        {R"(p_z, q_{i,z}, h_1', z_{far})", "p_z, q_(i,z), h₁′, z_far"},
        {R"(N^\top W)", "Nᵀ W"},
        {R"(a \le b \cdot c \approx \infty)", "a ≤ b · c ≈ ∞"},
        {R"(\alpha = 1)", "α = 1"},
        {R"(\Delta z)", "Δz"},
        {R"((\pm x, \pm y))", "(±x, ±y)"},
        {R"(\max\left(0,\ n \cdot \frac{v}{|v|}\right))", "max(0, n · v/|v|)"},
        {R"(\cos\gamma + \gamma\sin\gamma)", "cos γ + γ sin γ"},
        {R"(\sum_{t=1}^{T} w_t)", "Σ[t=1..T] w_t"},
        {R"(\sum_i w_i)", "Σ_i w_i"},
        {R"(\int_\Omega V(\omega)\, d\omega)", "∫_Ω V(ω) dω"},
        {R"(\overline{D^2}, \bar h, \hat a)", "mean(D²), h\u0305, a\u0302"},
        {R"(52{,}429)", "52,429"},
        {R"(\begin{pmatrix} I & 0 \\ -t & 1 \end{pmatrix})", "[I, 0; -t, 1]"},
        {R"(\begin{cases} 0 & x \le 1 \\ x & x > 1 \end{cases})", "{ 0 where x ≤ 1; x where x > 1 }"},
        {R"(\sigma = 2.5 \text{ texels})", "σ = 2.5 texels"},
        {R"(mask \mathrel{|}= 1)", "mask |= 1"},
        {R"(\unknown{x})", "unknownx"},
    };
    for (const auto& row : rows) {
        CAPTURE(std::string(row.first));
        CHECK(plain_math(row.first) == row.second);
    }
    // Whatever is typed comes to an end.
    for (const char* torn : {"", "{", "}", "\\", "\\frac", "\\frac{", "^", "_", "a_", "\\begin{cases} a",
                             "\\left", "&", "\\sqrt{", "\\\\"})
        CHECK_NOTHROW(plain_math(torn));
}

TEST_CASE("plain math: of Markdown the formulas, and not what is code or a sum of money") {
    CHECK(with_plain_math("a $x_0$ b `$y_0$` c") == "a x₀ b `$y_0$` c");
    CHECK(with_plain_math("$$ \\frac{a}{b} $$\n") == "a/b\n");
    CHECK(with_plain_math("```\n$x_0$\n```\n$x_0$") == "```\n$x_0$\n```\nx₀");
    CHECK(with_plain_math("costs 5 $ only") == "costs 5 $ only");
    CHECK(with_plain_math("5 $\n\n6 $") == "5 $\n\n6 $");
    CHECK(terminal_prose("$a\n+ b$", false) == "a + b\n\n");
    CHECK(terminal_text(CheckOutput{{"$x_0 \\le 1$", ""}, true, ""}, {}).find("x₀ ≤ 1") != std::string::npos);
}

namespace {

std::string text_in(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// Prose without its code spans and blocks, in which everything stays as it is.
std::string without_code(const std::string& text) {
    return std::regex_replace(text, std::regex("```[^]*?```|``[^]*?``|`[^`]*`"), "");
}

}  // namespace

TEST_CASE("plain math: of no chapter, in neither language, the terminal shows TeX") {
    std::size_t formulas = 0;
    const auto check = [&](const std::string& prose) {
        formulas += static_cast<std::size_t>(std::ranges::count(prose, '$')) / 2;
        const std::string shown = without_code(terminal_prose(prose, false));
        CAPTURE(shown);
        CHECK(shown.find('\\') == shown.npos);
        CHECK(shown.find('$') == shown.npos);
    };
    for (const auto& entry : std::filesystem::directory_iterator(CREVICE_CHAPTERS_DIR)) {
        if (entry.path().extension() != ".cpp") continue;
        CAPTURE(entry.path().string());
        for (const SourceCell& cell : percent_cells(text_in(entry.path()), "a.cpp")) {
            if (cell.kind == SourceCell::Kind::prose) check(cell.text);
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator(CREVICE_CHAPTERS_DIR "/zh")) {
        CAPTURE(entry.path().string());
        check(text_in(entry.path()));
    }
    CHECK(formulas > 200);
}
