#include "rasterizer/obj/mtl_read.h"

#include <algorithm>
#include <array>
#include <utility>

#include "rasterizer/obj/obj_lines.h"
#include "rasterizer/obj/obj_numbers.h"
#include "rasterizer/obj/text_encoding.h"

namespace crevice {
namespace {

// Statements that change nothing in what is drawn here. The transparency they tell of has its own warning.
bool is_harmless_property(std::string_view keyword) {
    static constexpr std::array<std::string_view, 4> kHarmless = {"illum", "ni", "tf", "sharpness"};
    return std::find(kHarmless.begin(), kHarmless.end(), keyword) != kHarmless.end();
}

// A file of another kind may start with a very long word.
constexpr std::size_t kMostOfKeyword = 40;

template <class Member>
struct Keyword {
    std::string_view name;
    Member MtlMaterial::*member;
};
constexpr std::array<Keyword<std::optional<glm::vec3>>, 3> kColours = {
    {{"ka", &MtlMaterial::ambient}, {"kd", &MtlMaterial::diffuse}, {"ks", &MtlMaterial::specular}}};
constexpr std::array<Keyword<std::optional<float>>, 2> kNumbers = {
    {{"ns", &MtlMaterial::shininess}, {"tr", &MtlMaterial::transparency}}};
constexpr std::array<Keyword<MtlTexture>, 10> kTextures = {{{"map_ka", &MtlMaterial::ambient_map},
                                                            {"map_kd", &MtlMaterial::diffuse_map},
                                                            {"map_ks", &MtlMaterial::specular_map},
                                                            {"map_d", &MtlMaterial::opacity_map},
                                                            {"norm", &MtlMaterial::normal_map},
                                                            {"map_kn", &MtlMaterial::normal_map},
                                                            {"bump", &MtlMaterial::bump_map},
                                                            {"map_bump", &MtlMaterial::bump_map},
                                                            {"disp", &MtlMaterial::displacement_map},
                                                            {"map_disp", &MtlMaterial::displacement_map}}};

template <class Member, std::size_t kCount>
Member MtlMaterial::*member_of(std::string_view keyword, const std::array<Keyword<Member>, kCount>& known) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.name == keyword; });
    return found == known.end() ? nullptr : found->member;
}

struct Reader {
    MtlFile file;
    std::size_t line = 0;
    std::size_t orphans = 0;  // statements before the first material

    MtlMaterial& material() { return file.materials.back(); }
    std::string here() const { return file.name + ":" + std::to_string(line) + ": "; }
    // Of a file that is something else, a few lines say enough.
    void warn(const std::string& what) {
        constexpr std::size_t kMost = 8;
        std::vector<std::string>& warnings = material().warnings;
        if (warnings.size() < kMost) {
            warnings.push_back(here() + what);
        } else {
            material().notes.push_back(
                {"a material has more lines that cannot be read", "passed over", line});
        }
    }
    void note_not_drawn(std::string_view keyword) {
        constexpr std::size_t kMost = 32;
        std::vector<MtlNote>& notes = material().notes;
        notes.push_back(not_drawn(notes.size() < kMost ? keyword : "others", line));
    }

    // The numbers that a statement begins with; what stands behind `most` of them is passed over, with a warning. Nothing,
    // with a warning, when there are fewer and one is none.
    std::optional<std::vector<float>> numbers(std::string_view keyword, std::string_view rest,
                                              std::size_t most) {
        std::vector<float> values;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            if (values.size() == most) {
                warn("`" + std::string(keyword) + "` goes on behind its numbers (" + std::string(word) +
                     "); end the line there, the rest is passed over");
                break;
            }
            const std::optional<float> value = number_in<float>(word);
            if (!value) {
                warn("`" + std::string(keyword) + "` has a number that is none (" + std::string(word) +
                     "); " + number_advice(word) + ", passed over");
                return std::nullopt;
            }
            values.push_back(*value);
        }
        return values;
    }
    void wrong_count(std::string_view keyword, std::size_t count, const char* wanted) {
        warn("`" + std::string(keyword) + "` has the wrong count of numbers (" + std::to_string(count) +
             "); give " + wanted + ", passed over");
    }

    void colour(std::string_view keyword, std::string_view rest, std::optional<glm::vec3>& into) {
        std::string_view first_of = rest;
        const std::string space = lower_case(take_word(first_of));
        if (space == "xyz" || space == "spectral") {
            return warn("`" + std::string(keyword) + " " + space +
                        "` is not read here; give red, green and blue, passed over");
        }
        const auto values = numbers(keyword, rest, 3);
        if (!values) return;
        if (values->size() == 1) {
            into = glm::vec3((*values)[0]);
        } else if (values->size() == 3) {
            into = glm::vec3((*values)[0], (*values)[1], (*values)[2]);
        } else {
            wrong_count(keyword, values->size(), "3, or 1 for grey");
        }
    }

    std::optional<float> number(std::string_view keyword, std::string_view rest) {
        const auto values = numbers(keyword, rest, 1);
        if (values && values->size() == 1) return values->front();
        if (values) wrong_count(keyword, values->size(), "1");
        return std::nullopt;
    }

    void texture(std::string_view keyword, std::string_view rest, MtlTexture MtlMaterial::*member) {
        MtlNotes notes;
        MtlTexture read = read_texture(keyword, rest, line, notes);
        for (const std::string& wrong : notes.wrong) warn(wrong);
        for (const std::string& option : notes.not_drawn) note_not_drawn(option);
        if (!read.file.empty()) material().*member = std::move(read);
    }

    void dissolve(std::string_view keyword, std::string_view rest) {
        std::string_view behind = rest;
        if (lower_case(take_word(behind)) == "-halo") {
            note_not_drawn("-halo");
            rest = behind;
        }
        if (const auto value = number(keyword, rest)) material().opacity = *value;
    }

    void emission(std::string_view keyword, std::string_view rest) {
        const auto values = numbers(keyword, rest, 3);
        const bool glows =
            values && std::any_of(values->begin(), values->end(), [](float v) { return v != 0; });
        if (glows) note_not_drawn(keyword);
    }

    void new_material(std::string_view rest) {
        MtlMaterial started;
        started.name = without_quotes(without_comment(rest));
        started.whole_name = trimmed(rest);
        started.line = line;
        file.materials.push_back(std::move(started));
        if (material().name.empty()) {
            file.warnings.push_back(here() +
                                    "`newmtl` without a name; give the name of a material, passed over");
        }
    }

    // `written` is the keyword as it stands, for messages.
    void property(std::string_view written, std::string_view rest) {
        const std::string keyword = lower_case(written);
        if (const auto colour_member = member_of(keyword, kColours)) {
            colour(written, rest, material().*colour_member);
        } else if (const auto number_member = member_of(keyword, kNumbers)) {
            if (const auto value = number(written, rest)) material().*number_member = *value;
        } else if (const auto texture_member = member_of(keyword, kTextures)) {
            texture(written, rest, texture_member);
        } else if (keyword == "d") {
            dissolve(written, rest);
        } else if (keyword == "ke") {
            emission(written, rest);
        } else if (!is_harmless_property(keyword)) {
            note_not_drawn(written);
        }
    }

    void statement(std::string_view rest) {
        const std::string_view keyword = take_word(rest);
        if (keyword.empty()) return;
        if (lower_case(keyword) == "newmtl") return new_material(rest);
        if (!file.materials.empty()) return property(keyword, rest);
        if (++orphans > 1) return;
        file.warnings.push_back(
            here() + "`" + std::string(keyword.substr(0, kMostOfKeyword)) +
            "` stands before the first `newmtl`; passed over, and all others up to there");
    }
};

}  // namespace

MtlNote not_drawn(std::string_view keyword, std::size_t line) {
    return {"`" + std::string(keyword.substr(0, kMostOfKeyword)) + "` is not drawn here", "passed over",
            line};
}

MtlFile read_mtl(std::string bytes, std::string name) {
    const std::string text = utf8_text(std::move(bytes), name);
    Reader reader;
    reader.file.name = std::move(name);
    LogicalLines lines(text);
    while (lines.advance()) {
        reader.line = lines.line;
        reader.statement(lines.text);
    }
    return std::move(reader.file);
}

}  // namespace crevice
