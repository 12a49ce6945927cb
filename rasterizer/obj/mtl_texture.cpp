#include "rasterizer/obj/mtl_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rasterizer/base/float_text.h"
#include "rasterizer/obj/obj_lines.h"
#include "rasterizer/obj/obj_numbers.h"

namespace crevice {
namespace {

// 0,5 where 0.5 is meant; a file's name may have a comma in it, too.
bool has_decimal_comma(std::string_view word) {
    return word.find(',') != std::string_view::npos &&
           word.find_first_not_of("+-.,0123456789") == std::string_view::npos;
}

// The other statements show more than one channel.
bool takes_one_channel(std::string_view keyword) {
    static constexpr std::array<std::string_view, 5> kTaking = {"map_d", "bump", "map_bump", "disp",
                                                                "map_disp"};
    return std::find(kTaking.begin(), kTaking.end(), lower_case(keyword)) != kTaking.end();
}

struct OptionReader {
    std::string_view keyword, rest;
    MtlTexture& texture;
    MtlNotes& notes;

    void wrong(std::string_view option, const std::string& what, const std::string& done = "passed over") {
        notes.wrong.push_back("`" + std::string(keyword) + " " + std::string(option) + "` " + what + "; " +
                              done);
    }
    void not_drawn(std::string_view option) { notes.not_drawn.emplace_back(option); }

    std::string_view next_word() const {
        std::string_view left = rest;
        return take_word(left);
    }

    // As many numbers as follow, at most `most`; none when one of them is not finite or not well written. The
    // last word of the line is the file's name, even where it is a number.
    std::vector<float> numbers(std::string_view option, std::size_t most) {
        std::vector<float> values;
        std::string_view malformed;
        while (values.size() < most) {
            std::string_view left = rest;
            const std::string_view word = take_word(left);
            std::string_view behind = left;
            if (texture.file.empty() && take_word(behind).empty()) break;
            const std::optional<float> value = number_in<float>(word);
            if (!value && !has_decimal_comma(word)) break;
            rest = left;
            if ((!value || !std::isfinite(*value)) && malformed.empty()) malformed = word;
            values.push_back(value.value_or(0));
        }
        if (!malformed.empty()) {
            wrong(option, "has a number that is none (" + std::string(malformed) + ")",
                  number_advice(malformed) + ", passed over");
            return {};
        }
        if (values.empty()) wrong(option, "has no number");
        return values;
    }

    // One value or two, of u and v; a third one, of w, has no meaning in a picture.
    void pair(std::string_view option, glm::vec2& into) {
        const std::vector<float> values = numbers(option, 3);
        for (const float value : values) {
            if (std::abs(value) <= kMostTextureCopies) continue;
            return wrong(option, "is beyond " + shortest_text(kMostTextureCopies) + " (" +
                                     shortest_text(value) +
                                     "), where texture coordinates lose their precision");
        }
        if (!values.empty()) into.x = values[0];
        if (values.size() > 1) into.y = values[1];
    }

    bool is_on(std::string_view option, bool by_default) {
        const std::string word = lower_case(next_word());
        if (word != "on" && word != "off") {
            wrong(option, "wants on or off");
            return by_default;
        }
        take_word(rest);
        return word == "on";
    }

    void channel(std::string_view option) {
        static constexpr std::array<std::pair<std::string_view, TexelChannel>, 5> kChannels = {
            {{"r", TexelChannel::red},
             {"g", TexelChannel::green},
             {"b", TexelChannel::blue},
             {"m", TexelChannel::alpha},
             {"l", TexelChannel::luminance}}};
        const std::string word = lower_case(next_word());
        for (const auto& [letter, meant] : kChannels) {
            if (word != letter) continue;
            take_word(rest);
            if (!takes_one_channel(keyword)) not_drawn(option);
            texture.channel = meant;
            return;
        }
        if (word == "z") take_word(rest);
        wrong(option, "wants r, g, b, m or l (" + word + ")");
    }

    // Takes one option, or says that `option` is none.
    bool take(std::string_view option) {
        const std::string name = lower_case(option);
        if (name == "-s") {
            pair(option, texture.scale);
        } else if (name == "-o") {
            pair(option, texture.offset);
        } else if (name == "-bm") {
            if (const auto values = numbers(option, 1); !values.empty()) texture.bump_factor = values[0];
        } else if (name == "-clamp") {
            texture.clamp = is_on(option, false);
        } else if (name == "-imfchan") {
            channel(option);
        } else if (name == "-t") {
            glm::vec2 turbulence(0);
            pair(option, turbulence);
            if (turbulence != glm::vec2(0)) not_drawn(option);
        } else if (name == "-mm") {
            const std::vector<float> values = numbers(option, 2);  // base and gain
            if (!values.empty() && (values[0] != 0 || (values.size() > 1 && values[1] != 1)))
                not_drawn(option);
        } else if (name == "-boost" || name == "-texres") {
            if (!numbers(option, 1).empty()) not_drawn(option);
        } else if (name == "-cc") {
            if (is_on(option, false)) not_drawn(option);
        } else if (name == "-blendu" || name == "-blendv") {
            if (!is_on(option, true)) not_drawn(option);
        } else if (name == "-type") {
            take_word(rest);  // a shape of `refl`
            not_drawn(option);
        } else {
            return false;
        }
        return true;
    }
};

}  // namespace

MtlTexture read_texture(std::string_view keyword, std::string_view rest, std::size_t line, MtlNotes& notes) {
    MtlTexture texture;
    texture.line = line;
    OptionReader options{keyword, rest, texture, notes};
    const char *begin = nullptr, *end = nullptr;  // of the name, which may have blanks in it
    for (std::string_view word = take_word(options.rest); !word.empty(); word = take_word(options.rest)) {
        if (options.take(word)) continue;
        if (begin == nullptr) {
            begin = word.data();
            const auto at = static_cast<std::size_t>(begin - rest.data());
            texture.whole_line = without_quotes(trimmed(rest.substr(at)));
        }
        end = word.data() + word.size();
        texture.file = without_quotes({begin, static_cast<std::size_t>(end - begin)});
    }
    if (texture.file.empty()) {
        notes.wrong.push_back("`" + std::string(keyword) + "` names no file; drawn without it");
    }
    return texture;
}

}  // namespace crevice
