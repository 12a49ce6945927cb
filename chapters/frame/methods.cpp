#include "chapters/frame/methods.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <utility>

#include "chapters/frame/parameter_kinds.h"
#include "rasterizer/base/error.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

namespace {

const Method kMethods[] = {
    {"xjun",
     "14 cube vectors, linear view depth",
     "X_Jun: DirectX 11 tutorial, chapter 32",
     {.ao = kXjunSettings, .blur = kXjunBlur},
     true,
     xjun_fetch},
    {"luna",
     "14 cube vectors, linear ndc depth, nearest normals",
     "F. Luna: Introduction to 3D Game Programming with DirectX 12, chapter 21",
     {.ao = kLunaSettings, .blur = kLunaBlur},
     true,
     luna_fetch},
    {"none", "no ambient occlusion: everything open", "the picture to compare with", {}, false, nullptr},
};

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
    std::vector<Parameter> parameters;
    const auto add = [&](std::vector<Parameter> table) {
        for (Parameter& parameter : table) parameters.push_back(std::move(parameter));
    };
    if (method.computes_ao) {
        add(ao_parameters());
        add(artifact_parameters());
        add(blur_parameters());
    }
    add(buffer_parameters());
    add(lit_parameters());
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
    constexpr int kGap = 2;
    const std::vector<Parameter> parameters = parameters_of(method);
    const auto width_of = [&](const std::string& heading, const auto& text) {
        std::size_t width = heading.size();
        for (const Parameter& p : parameters) width = std::max(width, std::string(text(p)).size());
        return static_cast<int>(width) + kGap;
    };
    const int names = width_of("parameter", [](const Parameter&p) { return p.name; }),
              defaults = width_of("default", [&](const Parameter&p) { return p.get(method.defaults); }),
              ranges = width_of("range", [](const Parameter&p) { return p.range; }),
              units = width_of("unit", [](const Parameter&p) { return p.unit; });
    const auto print_row = [&](const std::string& name, const std::string& value, const std::string& range,
                               const std::string& unit, const std::string& effect) {
        out << std::left << std::setw(names) << name << std::setw(defaults) << value << std::setw(ranges)
            << range << std::setw(units) << unit << effect << "\n";
    };
    print_row("parameter", "default", "range", "unit", "effect");
    for (const Parameter& p : parameters)
        print_row(p.name, p.get(method.defaults), p.range, p.unit, p.effect);
}

}  // namespace crevice
