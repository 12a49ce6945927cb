#include "chapters/notebook/plain_math.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>
#include <vector>

#include "chapters/notebook/math_symbols.h"

namespace crevice {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
// Part of a word, ASCII or not: what another word must not run into.
bool is_wordy(char c) { return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80; }

// A piece of a formula, and whether it is one thing, which needs no brackets to be divided by.
struct Piece {
    std::string text;
    bool single = true;
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// "(a)(b)" is no pair, "(a (b))" is one.
bool is_bracketed(const std::string& text) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') return false;
    int open = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (open == 0) return false;
    }
    return true;
}

std::string bracketed_unless_single(const Piece& piece) {
    const std::string& text = piece.text;
    const bool length = text.size() > 2 && text.front() == '|' && text.find('|', 1) + 1 == text.size();
    return piece.single || length || is_bracketed(text) ? text : "(" + text + ")";
}

// Reads from left to right; what TeX would set is appended to `out`.
class MathReader {
 public:
    explicit MathReader(std::string_view tex) : tex_(tex) {}

    // Up to a `}`, an `&`, a `\\` or an `\end` that belongs to who calls, or to the end.
    Piece sequence() {
        std::string out;
        int things = 0;
        while (at_ < tex_.size() && !ends_sequence()) {
            const std::size_t before = out.size();
            element(out);
            things += trimmed(out.substr(std::min(before, out.size()))).empty() ? 0 : 1;
        }
        return {trimmed(out), things <= 1};
    }

    bool at_end() const { return at_ >= tex_.size(); }
    // Over a bracket that nothing opened.
    void skip_one(std::string& out) { out += tex_[at_++]; }

 private:
    bool ahead(std::string_view word) const { return tex_.substr(at_).starts_with(word); }
    bool ends_sequence() const {
        return tex_[at_] == '}' || tex_[at_] == '&' || ahead("\\\\") || ahead("\\end");
    }
    void skip_spaces() {
        while (at_ < tex_.size() && (tex_[at_] == ' ' || tex_[at_] == '\n')) ++at_;
    }

    static void space(std::string& out) {
        if (!out.empty() && out.back() != ' ') out += ' ';
    }

    // One thing with its indices and powers.
    void element(std::string& out) {
        const char c = tex_[at_];
        if (c == ' ' || c == '\n' || c == '~') {
            ++at_;
            return space(out);
        }
        if (c == '^' || c == '_') return script(out);
        if (c == '\\') return command(out);
        if (c == '{') {
            out += group().text;
        } else if (is_digit(c)) {
            while (at_ < tex_.size() && (is_digit(tex_[at_]) || (tex_[at_] == '.' && digit_follows())))
                out += tex_[at_++];
        } else if (c == '\'') {
            ++at_;
            out += "′";
        } else {
            out += tex_[at_++];
        }
        scripts(out);
    }
    bool digit_follows() const { return at_ + 1 < tex_.size() && is_digit(tex_[at_ + 1]); }

    void scripts(std::string& out) {
        while (at_ < tex_.size() && (tex_[at_] == '^' || tex_[at_] == '_' || tex_[at_] == '\'')) {
            if (tex_[at_] == '\'') {
                ++at_;
                out += "′";
            } else {
                script(out);
            }
        }
    }

    void script(std::string& out) {
        const bool raised = tex_[at_++] == '^';
        const Piece piece = argument();
        const std::string small = small_text(piece.text, raised);
        if (!small.empty()) {
            out += small;
            return;
        }
        const bool plain = std::all_of(piece.text.begin(), piece.text.end(), is_wordy);
        const bool close =
            raised ? piece.single && piece.text.find_first_of("_^") == std::string::npos : plain;
        out += raised ? '^' : '_';
        out += close || is_bracketed(piece.text) ? piece.text : "(" + piece.text + ")";
    }

    // What stands in braces, or the one thing that follows.
    Piece argument() {
        skip_spaces();
        if (at_ >= tex_.size()) return {};
        if (tex_[at_] == '{') return group();
        std::string out;
        if (tex_[at_] == '\\') {
            command(out, /*alone=*/true);
        } else {
            out = tex_[at_++];
            while (at_ < tex_.size() && (static_cast<unsigned char>(tex_[at_]) & 0xc0) == 0x80)
                out += tex_[at_++];
        }
        return {trimmed(out), true};
    }

    Piece group() {
        ++at_;
        Piece inner = sequence();
        while (at_ < tex_.size() && tex_[at_] != '}') {
            skip_one(inner.text);
            inner.text += sequence().text;
        }
        if (at_ < tex_.size()) ++at_;
        return inner;
    }

    // The words of \text and its like, as they are.
    std::string words() {
        skip_spaces();
        if (at_ >= tex_.size() || tex_[at_] != '{') return argument().text;
        const std::size_t end = std::min(tex_.find('}', at_), tex_.size());
        const std::string found(tex_.substr(at_ + 1, end - at_ - 1));
        at_ = std::min(end + 1, tex_.size());
        return found;
    }

    std::string name() {
        ++at_;
        const std::size_t begin = at_;
        while (at_ < tex_.size() && is_letter(tex_[at_])) ++at_;
        if (at_ == begin && at_ < tex_.size()) ++at_;
        return std::string(tex_.substr(begin, at_ - begin));
    }

    // `alone`: the command is an argument, and what follows is not its business.
    void command(std::string& out, bool alone = false) {
        const std::string word = name();
        if (word.ends_with("frac")) {
            out += fraction();
        } else if (word == "sqrt") {
            out += "√" + bracketed_unless_single(argument());
        } else if (word == "begin") {
            out += environment(words());
        } else if (word == "text" || word == "mathrm" || word == "textit" || word == "mathrel") {
            const std::string told = words();
            out += told.substr(told.starts_with(' ') && out.ends_with(' ') ? 1 : 0);
        } else if (const char* mark = mark_over(word)) {
            out += marked(argument(), mark);
        } else if (is_large_operator(word)) {
            return large_operator(out, word);
        } else if (is_function(word)) {
            return function(out, word);
        } else if (const std::string* sign = relation_named(word)) {
            return relation(out, *sign);
        } else if (symbol_named(word) == " ") {
            return space(out);
        } else {
            out += symbol_named(word);
        }
        if (alone) return;
        scripts(out);
        if (is_letter(word[0])) end_word(out);
    }

    // TeX takes the space behind a command for its end: here it is kept before a sign alone, for \Delta z is one thing.
    void end_word(std::string& out) {
        const std::size_t before = at_;
        skip_spaces();
        constexpr std::string_view kSigns = "=+-<>";
        if (at_ > before && !at_end() && kSigns.find(tex_[at_]) != kSigns.npos) space(out);
    }

    // From what stands before a function or a sum, unless that opens a bracket or is its sign.
    static void keep_apart(std::string& out) {
        constexpr std::string_view kOpens = "(|[- ";
        if (!out.empty() && kOpens.find(out.back()) == kOpens.npos) out += ' ';
    }

    void function(std::string& out, const std::string& word) {
        keep_apart(out);
        out += word;
        scripts(out);
        skip_spaces();
        if (at_end() || tex_[at_] == '(' || ahead("\\left") || ahead("\\big")) return;
        out += ' ';
    }

    void relation(std::string& out, const std::string& sign) {
        // A sign before its number, as in -1, stands close to it.
        constexpr std::string_view kOpens = "(,[";
        const std::string before = trimmed(out);
        const bool leads = before.empty() || kOpens.find(before.back()) != kOpens.npos;
        if (!leads) space(out);
        out += sign;
        skip_spaces();
        if (!leads) out += ' ';
    }

    std::string fraction() {
        const Piece above = argument(), below = argument();
        if (above.text == "1" && below.text == "2") return "½";
        if (above.text == "1" && below.text == "4") return "¼";
        return bracketed_unless_single(above) + "/" + bracketed_unless_single(below);
    }

    // The line over a whole term is the mean of it: few terminals draw a line over more than one letter.
    static std::string marked(const Piece& piece, const char* mark) {
        return piece.text.size() == 1 ? piece.text + mark : "mean(" + piece.text + ")";
    }

    // Σ and ∫ with what they run over.
    void large_operator(std::string& out, const std::string& word) {
        keep_apart(out);
        out += symbol_named(word);
        Piece from, to;
        for (skip_spaces(); at_ < tex_.size() && (tex_[at_] == '^' || tex_[at_] == '_'); skip_spaces()) {
            const bool raised = tex_[at_++] == '^';
            (raised ? to : from) = argument();
        }
        if (!to.text.empty()) {
            out += "[" + from.text + ".." + to.text + "]";
        } else if (!from.text.empty()) {
            out += "_" + bracketed_unless_single(from);
        }
        out += ' ';
    }

    // Rows of a matrix as [a, b; c, d], of cases as { a where b; c where d }.
    std::string environment(const std::string& kind) {
        const bool cases = kind == "cases";
        std::string out = cases ? "{ " : "[";
        while (at_ < tex_.size() && !ahead("\\end")) {
            out += sequence().text;
            if (at_ >= tex_.size() || ahead("\\end")) break;
            if (ahead("\\\\")) {
                at_ += 2;
                out += "; ";
            } else {
                ++at_;
                out += cases ? " where " : ", ";
            }
        }
        if (ahead("\\end")) {
            name();
            words();
        }
        return out + (cases ? " }" : "]");
    }

    std::string_view tex_;
    std::size_t at_ = 0;
};

// The end of the code span or block that begins at `at`, or `at` when none does.
std::size_t end_of_code(std::string_view text, std::size_t at) {
    std::size_t ticks = 0;
    while (at + ticks < text.size() && text[at + ticks] == '`') ++ticks;
    if (ticks == 0) return at;
    const std::size_t end = text.find(std::string(ticks, '`'), at + ticks);
    return end == text.npos ? at + ticks : end + ticks;
}

}  // namespace

std::string plain_math(std::string_view tex) {
    MathReader reader(tex);
    std::string all = reader.sequence().text;
    while (!reader.at_end()) {
        reader.skip_one(all);
        all += reader.sequence().text;
    }
    return all;
}

std::string with_plain_math(std::string_view markdown) {
    std::string all;
    std::size_t at = 0;
    while (at < markdown.size()) {
        if (const std::size_t end = end_of_code(markdown, at); end > at) {
            all += markdown.substr(at, end - at);
            at = end;
            continue;
        }
        if (markdown[at] != '$') {
            all += markdown[at++];
            continue;
        }
        const std::string_view mark = markdown.substr(at).starts_with("$$") ? "$$" : "$";
        const std::size_t begin = at + mark.size(), end = markdown.find(mark, begin);
        const bool is_formula = end != markdown.npos && end > begin &&
                                markdown.substr(begin, end - begin).find("\n\n") == markdown.npos;
        all += is_formula ? plain_math(markdown.substr(begin, end - begin)) : std::string(mark);
        at = is_formula ? end + mark.size() : begin;
    }
    return all;
}

}  // namespace crevice
