#include "chapters/sweep/planned_methods.h"

#include <algorithm>
#include <set>

#include "chapters/frame/parameter_words.h"
#include "chapters/terminal/json_text.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

using Json = JsonFile::Json;

// In the place of a list: all methods, or all of a method's samples_to_try.
constexpr const char* kAll = "all";

void require_object(const JsonFile& plan, const Json& value, const JsonPlace& place) {
    if (!value.is_object())
        plan.refuse("parameters: not an object (" + json_line(value) + "); write {\"samples\": [4, 8]}", place);
}

[[noreturn]] void refuse_parameter(const JsonFile& plan, const std::string& name, const std::string& of,
                                   const std::set<std::string>& known, const JsonPlace& place) {
    if (name == "seed") plan.refuse("seed: not among parameters (seed); give \"seeds\" beside them", place);
    plan.refuse(no_such("parameters", "parameter of " + of, name, {known.begin(), known.end()}).what(),
                place);
}

std::set<std::string> names_of(const std::vector<Parameter<FrameSettings>>& parameters) {
    std::set<std::string> names;
    for (const Parameter<FrameSettings>& parameter : parameters) names.insert(parameter.name);
    return names;
}

PlannedValues values_of(const JsonFile& plan, const Method& method, const std::string& name,
                        const Json& values, const JsonPlace& place) {
    const std::vector<Parameter<FrameSettings>> parameters = sweep_parameters(method);
    const auto found = std::ranges::find(parameters, name, &Parameter<FrameSettings>::name);
    if (found == parameters.end()) refuse_parameter(plan, name, method.name, names_of(parameters), place);
    PlannedValues planned{name, {}, place};
    if (name == "samples" && values == kAll) {
        for (const int samples : method.samples_to_try) planned.words.push_back(std::to_string(samples));
        return planned;
    }
    FrameSettings trial;
    trial.method = defaults_of(method);
    plan.for_each(values, place, [&](const Json& value, const JsonPlace& at) {
        // 0.5 and "0.5" are the same word.
        if (std::ranges::count(planned.words, word_of(value)) > 0)
            plan.refuse(name + ": given twice (" + word_of(value) + "); leave one away", at);
        planned.words.push_back(word_of(value));
        try {
            set_from_word(*found, trial, planned.words.back());
        } catch (const UsageError& error) {
            plan.refuse(std::string(method.name) + ": " + error.what(), at);
        }
    });
    return planned;
}

PlannedMethod planned_method(const JsonFile& plan, const Json& item, const JsonPlace& place) {
    const Json* name = &item;
    if (item.is_object()) {
        plan.require_known(item, place, {"method", "parameters"});
        if (!item.contains("method"))
            plan.refuse("methods: parameters of no method (" + json_line(item) + "); add \"method\"", place);
        name = &item["method"];
    }
    if (!name->is_string())
        plan.refuse("methods: not a name (" + name->dump() + "); give a method or {\"method\": ...}", place);
    const Method& method =
        plan.at(place, [&]() -> const Method& { return find_method(name->get<std::string>()); });
    if (!method.computes_ao())
        plan.refuse(std::string("methods: computes no AO (") + method.name + "); leave it away", place);
    PlannedMethod planned{&method, {}, place};
    if (!item.is_object() || !item.contains("parameters")) return planned;
    const JsonPlace parameters = below(place, "parameters");
    require_object(plan, item["parameters"], parameters);
    for (const auto& [parameter, values] : item["parameters"].items())
        planned.values.push_back(values_of(plan, method, parameter, values, below(parameters, parameter)));
    return planned;
}

// Values for all methods are for those that have the parameter and no values of their own for it.
void add_common_values(const JsonFile& plan, std::vector<PlannedMethod>& all) {
    if (!plan.root().contains("parameters")) return;
    require_object(plan, plan.root()["parameters"], {"parameters"});
    for (const auto& [parameter, values] : plan.root()["parameters"].items()) {
        const JsonPlace place = {"parameters", parameter};
        std::set<std::string> known;
        for (PlannedMethod& planned : all) {
            const std::set<std::string> names = names_of(sweep_parameters(*planned.method));
            known.insert(names.begin(), names.end());
            const bool own = std::ranges::count(planned.values, parameter, &PlannedValues::parameter) > 0;
            if (names.contains(parameter) && !own)
                planned.values.push_back(values_of(plan, *planned.method, parameter, values, place));
        }
        if (!known.contains(parameter))
            refuse_parameter(plan, parameter, "any of these methods", known, place);
    }
}

void bring_in_order(PlannedMethod& planned) {
    std::vector<PlannedValues> ordered;
    for (const Parameter<FrameSettings>& parameter : sweep_parameters(*planned.method)) {
        const auto found = std::ranges::find(planned.values, parameter.name, &PlannedValues::parameter);
        if (found != planned.values.end()) ordered.push_back(std::move(*found));
    }
    planned.values = std::move(ordered);
}

}  // namespace

std::vector<Parameter<FrameSettings>> sweep_parameters(const Method& method) {
    std::vector<Parameter<FrameSettings>> all = within<FrameSettings>(
        parameters_of(method), [](auto& settings) -> auto& { return settings.method; });
    std::erase_if(all, [](const auto& parameter) { return parameter.name == "seed"; });
    for (Parameter<FrameSettings>& parameter : buffer_parameters()) {
        if (parameter.name == "buffer_format") all.push_back(std::move(parameter));
    }
    return all;
}

std::vector<PlannedMethod> planned_methods(const JsonFile& plan) {
    if (!plan.root().contains("methods"))
        plan.refuse("methods: missing (); list those to try, or write \"methods\": \"all\"", {});
    const Json& methods = plan.root()["methods"];
    std::vector<PlannedMethod> all;
    if (methods == kAll) {
        for (const Method& method : ao_methods()) {
            if (method.computes_ao()) all.push_back({&method, {}, {"methods"}});
        }
    } else {
        plan.for_each(methods, {"methods"}, [&](const Json& item, const JsonPlace& place) {
            PlannedMethod planned = planned_method(plan, item, place);
            if (std::ranges::count(all, planned.method, &PlannedMethod::method) > 0)
                plan.refuse(std::string("methods: given twice (") + planned.method->name +
                                "); put its values into one list",
                            place);
            all.push_back(std::move(planned));
        });
    }
    add_common_values(plan, all);
    std::ranges::for_each(all, bring_in_order);
    return all;
}

std::vector<SweepSetting> settings_of(const PlannedMethod& planned) {
    std::vector<SweepSetting> settings = {{planned.method->name, {}}};
    for (const PlannedValues& values : planned.values) {
        std::vector<SweepSetting> more;
        for (const SweepSetting& setting : settings) {
            for (const std::string& word : values.words) {
                more.push_back(setting);
                more.back().parameters.emplace_back(values.parameter, word);
            }
        }
        settings = std::move(more);
    }
    return settings;
}

}  // namespace crevice
