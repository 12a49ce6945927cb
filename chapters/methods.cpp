#include "chapters/methods.h"

#include <cstdint>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

#include "chapters/parse.h"
#include "rasterizer/error.h"
#include "ssao/luna_ssao.h"
#include "ssao/xjun_ssao.h"

namespace crevice {

namespace {

const Method kMethods[] = {
    {"xjun",
     "14 cube vectors, linear view depth",
     "seed 000: DirectX 11 tutorial, chapter 32 (X_Jun)",
     {.ao = kXjunSettings, .blur = kXjunBlur},
     true,
     xjun_fetch},
    {"luna",
     "14 cube vectors, linear ndc depth, nearest normals",
     "seed 002: Introduction to 3D Game Programming with DirectX 12, ch. 21 (F. Luna)",
     {.ao = kLunaSettings, .blur = kLunaBlur},
     true,
     luna_fetch},
    {"none", "no ambient occlusion: everything open", "the picture to compare with", {}, false, nullptr},
};

std::string text_of(double value) {
    std::ostringstream text;
    text << std::setprecision(7) << value;
    return text.str();
}

// A member that is a number, and one that is one of a few words.
template <class T>
Parameter number(const char* name, const char* range, const char* unit, const char* effect,
                 T& (*member)(MethodSettings&)) {
    return {name,
            range,
            unit,
            effect,
            [=](MethodSettings& s, const std::string& word) {
                member(s) = static_cast<T>(parse_number(name, word));
            },
            [=](const MethodSettings& s) {
                return text_of(static_cast<double>(member(const_cast<MethodSettings&>(s))));
            }};
}

template <class T>
Parameter choice(const char* name, const char* range, const char* effect, T& (*member)(MethodSettings&),
                 std::vector<std::pair<std::string, T>> choices) {
    const auto set = [=](MethodSettings& s, const std::string& word) {
        for (const auto& [text, value] : choices) {
            if (text == word) {
                member(s) = value;
                return;
            }
        }
        throw UsageError(std::string(name) + ": no such choice (" + word + "); give one of " + range);
    };
    const auto get = [=](const MethodSettings& s) {
        for (const auto& [text, value] : choices) {
            if (member(const_cast<MethodSettings&>(s)) == value) return text;
        }
        return std::string("custom");
    };
    return {name, range, "-", effect, set, get};
}

Parameter whole(const char* name, long long lowest, long long highest, const char* range, const char* effect,
                void (*set)(MethodSettings&, long long), long long (*get)(const MethodSettings&)) {
    return {
        name,
        range,
        "-",
        effect,
        [=](MethodSettings& s, const std::string& word) { set(s, parse_whole(name, word, lowest, highest)); },
        [=](const MethodSettings& s) { return std::to_string(get(s)); }};
}

constexpr const char* kFormatRange = "float32|float16|float16_nearest";
const std::vector<std::pair<std::string, BufferFormat>> kFormats = {
    {"float32", BufferFormat::float32},
    {"float16", BufferFormat::float16_toward_zero},
    {"float16_nearest", BufferFormat::float16_nearest_even}};

std::vector<Parameter> ao_parameters() {
    using S = MethodSettings;
    return {
        whole(
            "samples", 1, kCubeVectors, "1..14", "fewer is faster and noisier",
            [](S& s, long long v) { s.ao.samples = static_cast<int>(v); },
            [](const S& s) { return static_cast<long long>(s.ao.samples); }),
        number<float>("radius", "[0, inf)", "scene", "how far from the surface the samples lie",
                      [](S& s) -> float& { return s.ao.radius; }),
        number<float>("fade_start", "[0, inf)", "scene", "occluders up to this far in front count fully",
                      [](S& s) -> float& { return s.ao.fade_start; }),
        number<float>("fade_end", "[fade_start, inf)", "scene",
                      "occluders further in front do not count: halos",
                      [](S& s) -> float& { return s.ao.fade_end; }),
        number<float>("epsilon", "[0, inf)", "scene",
                      "occluders less than this in front do not count: acne or lost contact",
                      [](S& s) -> float& { return s.ao.epsilon; }),
        number<float>("exponent", "[0, 64]", "-", "contrast: accessibility is raised to it",
                      [](S& s) -> float& { return s.ao.exponent; }),
        whole(
            "seed", 0, 0xffffffffLL, "0..4294967295", "of the random lengths and the random map",
            [](S& s, long long v) { s.ao.seed = static_cast<std::uint32_t>(v); },
            [](const S& s) { return static_cast<long long>(s.ao.seed); }),
        choice<bool>("as_published", "true|false", "the tutorial's text, traps included",
                     [](S& s) -> bool& { return s.ao.as_published; },
                     {{"false", false}, {"true", true}, {"0", false}, {"1", true}}),
        choice<BufferFormat>(
            "ao_format", kFormatRange, "how the AO map is stored",
            [](S& s) -> BufferFormat& { return s.ao.format; }, kFormats),
        whole(
            "blur_iterations", 0, 64, "0..64", "times horizontal and vertical; 0: no blur",
            [](S& s, long long v) { s.blur.iterations = static_cast<int>(v); },
            [](const S& s) { return static_cast<long long>(s.blur.iterations); }),
        choice<BlurWeights>("blur_weights", "xjun|luna",
                            "the flat weights of seed 000 or the Gaussian of seed 002",
                            [](S& s) -> BlurWeights& { return s.blur.weights; },
                            {{"xjun", kXjunBlurWeights}, {"luna", kLunaBlurWeights}}),
        number<float>("blur_normal", "[-1, 1]", "cosine", "neighbours whose normals agree less do not count",
                      [](S& s) -> float& { return s.blur.normal_threshold; }),
        number<float>("blur_depth", "[0, inf)", "scene", "neighbours whose depth differs more do not count",
                      [](S& s) -> float& { return s.blur.depth_threshold; }),
    };
}

std::vector<Parameter> buffer_parameters() {
    using S = MethodSettings;
    Parameter depth{"depth_format",
                    "d16|d24|d32f|d32f_reversed",
                    "-",
                    "how the depth buffer is stored",
                    [](S& s, const std::string& word) {
                        const std::pair<const char*, DepthFormat> formats[] = {
                            {"d16", DepthFormat::d16},
                            {"d24", DepthFormat::d24},
                            {"d32f", DepthFormat::d32f},
                            {"d32f_reversed", DepthFormat::d32f}};
                        for (const auto& [text, format] : formats) {
                            if (word != text) continue;
                            s.buffers.depth_format = format;
                            s.reversed_z = word == "d32f_reversed";
                            return;
                        }
                        throw UsageError("depth_format: no such choice (" + word +
                                         "); give one of d16|d24|d32f|d32f_reversed");
                    },
                    [](const S& s) -> std::string {
                        if (s.buffers.depth_format == DepthFormat::d16) return "d16";
                        if (s.buffers.depth_format == DepthFormat::d24) return "d24";
                        return s.reversed_z ? "d32f_reversed" : "d32f";
                    }};
    return {depth, choice<BufferFormat>(
                       "buffer_format", kFormatRange, "how normals and view depth are stored",
                       [](S& s) -> BufferFormat& { return s.buffers.buffer_format; }, kFormats)};
}

}  // namespace

std::span<const Method> ao_methods() { return kMethods; }

const Method& find_method(const std::string& name) {
    std::string known;
    for (const Method& method : kMethods) {
        if (name == method.name) return method;
        known += std::string(known.empty() ? "" : ", ") + method.name;
    }
    throw UsageError("--ao: there is no such method (" + name + "); give one of " + known);
}

std::vector<Parameter> parameters_of(const Method& method) {
    std::vector<Parameter> parameters = method.computes_ao ? ao_parameters() : std::vector<Parameter>{};
    for (Parameter& parameter : buffer_parameters()) parameters.push_back(std::move(parameter));
    return parameters;
}

MethodSettings settings_of(const Method& method, const std::vector<std::string>& assignments,
                           float length_unit) {
    const std::vector<Parameter> parameters = parameters_of(method);
    MethodSettings settings = method.defaults;
    for (float* length : {&settings.ao.radius, &settings.ao.fade_start, &settings.ao.fade_end,
                          &settings.ao.epsilon, &settings.blur.depth_threshold}) {
        *length *= length_unit;
    }
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos)
            throw UsageError("--param: no value (" + assignment + "); write name=value");
        const std::string name = assignment.substr(0, equals);
        std::string known;
        const Parameter* found = nullptr;
        for (const Parameter& parameter : parameters) {
            known += std::string(known.empty() ? "" : ", ") + parameter.name;
            if (name == parameter.name) found = &parameter;
        }
        if (found == nullptr) {
            throw UsageError(std::string("--param: ") + method.name + " has no such parameter (" + name +
                             "); it has " + known);
        }
        found->set(settings, assignment.substr(equals + 1));
    }
    validate(settings.ao);
    validate(settings.blur);
    return settings;
}

void print_methods(std::ostream& out) {
    for (const Method& method : kMethods) {
        out << std::left << std::setw(8) << method.name << method.title << "\n"
            << std::string(8, ' ') << method.source << "\n";
    }
}

void print_parameters(std::ostream& out, const Method& method) {
    out << std::left << std::setw(17) << "parameter" << std::setw(12) << "default" << std::setw(33) << "range"
        << std::setw(8) << "unit"
        << "effect\n";
    for (const Parameter& p : parameters_of(method)) {
        out << std::left << std::setw(17) << p.name << std::setw(12) << p.get(method.defaults)
            << std::setw(33) << p.range << std::setw(8) << p.unit << p.effect << "\n";
    }
}

}  // namespace crevice
