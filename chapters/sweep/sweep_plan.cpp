#include "chapters/sweep/sweep_plan.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "chapters/notebook/embedded_files.h"
#include "chapters/study/candidates.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/no_such.h"
#include "scenes/builtin_scenes.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

namespace {

using Json = JsonFile::Json;

constexpr std::size_t kLongestName = 64;
constexpr std::uintmax_t kLargestPlan = 1 << 20;  // bytes
constexpr int kMostRepetitions = 10000, kMostThreads = 1024, kMostRays = 1 << 20;
constexpr const char* kBuiltinPlans[] = {"quick", "full"};

class PlanReader {
 public:
    explicit PlanReader(const JsonFile& file) : file_(file), root_(file.root()) {}

    void read_into(SweepPlan& plan) const {
        file_.require_known(root_, {},
                            {"name", "scenes", "sizes", "methods", "parameters", "seeds", "threads",
                             "repetitions", "reference_rays", "parts"});
        plan.name = name();
        for_each("scenes", [&](const Json& item, const JsonPlace& place) {
            plan.scenes.push_back(scene(item, place));
        });
        for_each("sizes",
                 [&](const Json& item, const JsonPlace& place) { plan.sizes.push_back(size(item, place)); });
        plan.methods = planned_methods(file_);
        plan.seeds =
            wholes<std::uint32_t>("seeds", kFirstStudySeed, 0, std::numeric_limits<std::uint32_t>::max());
        plan.threads = wholes<int>("threads", 1, 1, kMostThreads);
        plan.repetitions = whole("repetitions", plan.repetitions, 0, kMostRepetitions);
        plan.reference_rays = whole("reference_rays", plan.reference_rays, kReplicates, kMostRays);
        if (!root_.contains("parts")) return;
        if (!root_["parts"].is_boolean())
            file_.refuse("parts: neither true nor false (" + json_line(root_["parts"]) + "); write one of them",
                         {"parts"});
        plan.parts = root_["parts"].get<bool>();
    }

 private:
    template <class Body>
    void for_each(const char* name, const Body& body) const {
        if (!root_.contains(name)) file_.refuse(std::string(name) + ": missing (); list those to try", {});
        file_.for_each(root_[name], {name}, body);
    }

    template <class Whole>
    std::vector<Whole> wholes(const char* name, Whole otherwise, long long lowest, long long highest) const {
        if (!root_.contains(name)) return {otherwise};
        std::vector<Whole> values;
        for_each(name, [&](const Json& item, const JsonPlace& place) {
            values.push_back(static_cast<Whole>(
                file_.at(place, [&] { return parse_whole(name, json_line(item), lowest, highest); })));
        });
        return values;
    }

    int whole(const char* name, int otherwise, int lowest, int highest) const {
        if (!root_.contains(name)) return otherwise;
        return static_cast<int>(
            file_.at({name}, [&] { return parse_whole(name, json_line(root_[name]), lowest, highest); }));
    }

    std::string name() const {
        if (!root_.contains("name")) file_.refuse("name: missing (); call the plan something", {});
        const std::string given = word_of(root_["name"]);
        const auto fits = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
        };
        if (!root_["name"].is_string() || given.empty() || given.size() > kLongestName ||
            !std::ranges::all_of(given, fits))
            file_.refuse(
                "name: not 1 to 64 letters, digits, _ and - (" + given + "); directories are called by it",
                {"name"});
        return given;
    }

    Size size(const Json& item, const JsonPlace& place) const {
        if (!item.is_array() || item.size() != 2)
            file_.refuse("sizes: not two numbers (" + json_line(item) + "); write [640, 360]", place);
        return file_.at(place, [&] { return parse_size("sizes", json_line(item[0]) + "x" + json_line(item[1])); });
    }

    PlannedScene scene(const Json& item, const JsonPlace& place) const {
        PlannedScene scene;
        scene.place = place;
        const Json* name = &item;
        if (item.is_object()) {
            file_.require_known(item, place,
                                {"scene", "eye", "target", "fov_y", "near", "far", "ortho", "crease"});
            if (!item.contains("scene"))
                file_.refuse("scenes: a camera without a scene (" + json_line(item) + "); add \"scene\"", place);
            name = &item["scene"];
            scene.camera = {point(item, "eye", place),    point(item, "target", place),
                            number(item, "fov_y", place), number(item, "near", place),
                            number(item, "far", place),   number(item, "ortho", place)};
            scene.crease = number(item, "crease", place);
        }
        if (!name->is_string())
            file_.refuse("scenes: not a name (" + name->dump() + "); give a scene or {\"scene\": ...}",
                         place);
        scene.name = name->get<std::string>();
        require_scene(scene.name, place);
        return scene;
    }

    // Camera flags of a scene.
    std::optional<std::string> number(const Json& scene, const char* flag, const JsonPlace& place) const {
        if (!scene.contains(flag)) return std::nullopt;
        if (!scene[flag].is_number())
            file_.refuse(std::string(flag) + ": not a number (" + json_line(scene[flag]) + "); write one",
                         below(place, flag));
        return word_of(scene[flag]);
    }
    std::optional<std::string> point(const Json& scene, const char* flag, const JsonPlace& place) const {
        if (!scene.contains(flag)) return std::nullopt;
        const Json& value = scene[flag];
        if (!value.is_array() || value.size() != 3 ||
            !std::ranges::all_of(value, [](const Json& n) { return n.is_number(); }))
            file_.refuse(std::string(flag) + ": not three numbers (" + json_line(value) + "); write [x, y, z]",
                         below(place, flag));
        return word_of(value[0]) + "," + word_of(value[1]) + "," + word_of(value[2]);
    }

    void require_scene(const std::string& name, const JsonPlace& place) const {
        std::error_code ignored;
        if (find_builtin_scene(name) != nullptr || std::filesystem::exists(name, ignored)) return;
        std::vector<std::string> known;
        for (const BuiltinScene& scene : builtin_scenes()) known.emplace_back(scene.name);
        file_.refuse(no_such("scenes", "scene and no such file", name, known).what(), place);
    }

    const JsonFile& file_;
    const Json& root_;
};

}  // namespace

SweepPlan plan_from_text(const std::string& text, const std::string& file) {
    SweepPlan plan{JsonFile(text, file, ExitCode::usage), {}, text, {}, {}, {}, {}, {}};
    PlanReader(plan.file).read_into(plan);
    return plan;
}

SweepPlan find_plan(const std::string& name_or_path) {
    for (const char* name : kBuiltinPlans) {
        if (name_or_path != name) continue;
        const std::string file = std::string("chapters/sweep/plans/") + name + ".json";
        return plan_from_text(std::string(embedded_file(file).value()), file);
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name_or_path, ignored))
        throw no_such("PLAN", "plan and no such file", name_or_path,
                      {std::begin(kBuiltinPlans), std::end(kBuiltinPlans)});
    return plan_from_text(read_file(name_or_path, kLargestPlan), name_or_path);
}

}  // namespace crevice
