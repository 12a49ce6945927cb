#include "chapters/notebook/math_symbols.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace crevice {

std::string symbol_named(const std::string& name) {
    static const std::map<std::string, std::string> kSymbols = {
        {"alpha", "α"},   {"beta", "β"},       {"gamma", "γ"},   {"delta", "δ"},  {"varepsilon", "ε"},
        {"epsilon", "ε"}, {"theta", "θ"},      {"lambda", "λ"},  {"mu", "μ"},     {"pi", "π"},
        {"rho", "ρ"},     {"sigma", "σ"},      {"tau", "τ"},     {"varphi", "φ"}, {"phi", "φ"},
        {"psi", "ψ"},     {"omega", "ω"},      {"Omega", "Ω"},   {"Delta", "Δ"},  {"Gamma", "Γ"},
        {"Sigma", "Σ"},   {"Phi", "Φ"},        {"top", "ᵀ"},     {"infty", "∞"},  {"partial", "∂"},
        {"dots", "…"},    {"ldots", "…"},      {"cdots", "…"},   {"sum", "Σ"},    {"int", "∫"},
        {"prod", "Π"},    {"lfloor", "⌊"},     {"rfloor", "⌋"},  {"lceil", "⌈"},  {"rceil", "⌉"},
        {"langle", "⟨"},  {"rangle", "⟩"},     {"nabla", "∇"},   {"ell", "ℓ"},    {"circ", "°"},
        {"prime", "′"},   {"quad", "   "},     {"qquad", "   "}, {",", " "},      {";", " "},
        {":", " "},       {" ", " "},          {"!", ""},        {"left", ""},    {"right", ""},
        {"big", ""},      {"Big", ""},         {"bigl", ""},     {"bigr", ""},    {"Bigl", ""},
        {"Bigr", ""},     {"displaystyle", ""}};
    const auto found = kSymbols.find(name);
    return found == kSymbols.end() ? name : found->second;
}

const std::string* relation_named(const std::string& name) {
    static const std::map<std::string, std::string> kRelations = {
        {"cdot", "·"}, {"times", "×"},      {"div", "÷"},    {"le", "≤"},     {"leq", "≤"},
        {"ge", "≥"},   {"geq", "≥"},        {"ne", "≠"},     {"neq", "≠"},    {"approx", "≈"},
        {"to", "→"},   {"Rightarrow", "⇒"}, {"in", "∈"},     {"otimes", "⊗"}, {"oplus", "⊕"},
        {"pm", "±"},   {"mp", "∓"},         {"equiv", "≡"},  {"sim", "~"},    {"ll", "≪"},
        {"gg", "≫"},   {"mapsto", "↦"},     {"propto", "∝"}, {"cup", "∪"},    {"cap", "∩"}};
    const auto found = kRelations.find(name);
    return found == kRelations.end() ? nullptr : &found->second;
}

bool is_function(const std::string& name) {
    static const std::set<std::string> kFunctions = {"sin", "cos", "tan",    "log",    "ln",     "exp",
                                                     "max", "min", "arccos", "arcsin", "arctan", "lim"};
    return kFunctions.contains(name);
}

bool is_large_operator(const std::string& name) { return name == "sum" || name == "int" || name == "prod"; }

const char* mark_over(const std::string& name) {
    if (name == "overline" || name == "bar") return "\u0305";
    if (name == "hat") return "\u0302";
    return name == "vec" ? "\u20d7" : nullptr;
}

std::string small_text(std::string_view text, bool raised) {
    static const std::map<char, std::pair<std::string, std::string>> kSmall = {
        {'0', {"⁰", "₀"}}, {'1', {"¹", "₁"}}, {'2', {"²", "₂"}}, {'3', {"³", "₃"}},
        {'4', {"⁴", "₄"}}, {'5', {"⁵", "₅"}}, {'6', {"⁶", "₆"}}, {'7', {"⁷", "₇"}},
        {'8', {"⁸", "₈"}}, {'9', {"⁹", "₉"}}, {'+', {"⁺", "₊"}}, {'-', {"⁻", "₋"}},
        {'k', {"ᵏ", ""}},  {'n', {"ⁿ", ""}},  {'i', {"ⁱ", ""}},  {'T', {"ᵀ", ""}}};
    if (text == "ᵀ" || text == "′") return raised ? std::string(text) : "";
    std::string small;
    for (const char c : text) {
        const auto found = kSmall.find(c);
        if (found == kSmall.end()) return "";
        const std::string& form = raised ? found->second.first : found->second.second;
        if (form.empty()) return "";
        small += form;
    }
    return small;
}

}  // namespace crevice
