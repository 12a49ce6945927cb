// Plans: what they say, and what is said of those that are wrong.
#include "chapters/sweep/sweep_plan.h"

#include <fstream>
#include <iterator>

#include <doctest/doctest.h>

#include "chapters/notebook/embedded_files.h"
#include "tests/tools/error_message.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/sweep_plans.h"

using namespace crevice;

namespace {

// What the reader of plans or the maker of jobs says of the small plan with one text in the place of another.
std::string refusal(const std::string& old_text, const std::string& new_text) {
    return message_of<UsageError>([&] { jobs_of(plan_with(old_text, new_text)); });
}

nlohmann::json schema() {
    std::ifstream file(CREVICE_SCHEMA_DIR "/sweep_plan.schema.json");
    return nlohmann::json::parse(file);
}

}  // namespace

TEST_CASE("plan: what it says") {
    const SweepPlan plan = plan_from_text(kSmallPlan, "plan.json");
    CHECK(plan.name == "small");
    REQUIRE(plan.scenes.size() == 1);
    CHECK(plan.scenes[0].name == "cornell");
    CHECK(plan.sizes == std::vector<Size>{{48, 27}});
    REQUIRE(plan.methods.size() == 2);
    CHECK(plan.methods[1].method == &find_method("gtao"));
    CHECK(plan.seeds == std::vector<std::uint32_t>{1000, 1001});
    CHECK(plan.threads == std::vector<int>{1, 2});
    CHECK(plan.repetitions == 0);
    CHECK(plan.reference_rays == 16);
    CHECK(!plan.parts);
    using Words = std::vector<std::pair<std::string, std::string>>;
    const std::vector<SweepSetting> settings = settings_of(plan.methods[1]);
    REQUIRE(settings.size() == 4);
    // In the order of the method's parameters, whatever that of the plan.
    CHECK(settings[0].parameters == Words{{"samples", "4"}, {"ao_scale", "0.5"}});
    CHECK(settings[1].parameters == Words{{"samples", "4"}, {"ao_scale", "1"}});
    CHECK(settings[3].parameters == Words{{"samples", "8"}, {"ao_scale", "1"}});
}

TEST_CASE(
    "plan: a parameter of all methods is for those that have it, and a method's own values come first") {
    const auto settings = [](const std::string& plan, std::size_t method) {
        return settings_of(plan_from_text(plan, "plan.json").methods[method]).size();
    };
    // Of the two only xjun has an exponent.
    const std::string plan =
        plan_with("\"ao_scale\": [0.5, 1]", "\"samples\": [6], \"ao_format\": [\"float32\", \"float16\"]");
    CHECK(settings(plan, 0) == 2);
    CHECK(settings(plan, 1) == 2);  // its own samples, no ao_format
    const std::string all =
        plan_with("[\"xjun\", {\"method\": \"gtao\", \"parameters\": {\"samples\": [4, 8]}}]", "\"all\"",
                  plan_with("[0.5, 1]", "[1], \"samples\": \"all\""));
    const SweepPlan every = plan_from_text(all, "plan.json");
    CHECK(every.methods.size() == ao_methods().size() - 1);  // all but `none`
    for (const PlannedMethod& method : every.methods) {
        CAPTURE(method.method->name);
        CHECK(settings_of(method).size() == method.method->samples_to_try.size());
    }
}

TEST_CASE("plan: a camera of its own, in the words of the command line") {
    const SweepPlan plan = plan_from_text(
        plan_with("\"cornell\"",
                  R"({"scene": "cornell", "eye": [0, 1.5, -4], "target": [0, 1, 0], "fov_y": 45})"),
        "plan.json");
    CHECK(plan.scenes[0].camera.eye == "0,1.5,-4");
    CHECK(plan.scenes[0].camera.target == "0,1,0");
    CHECK(plan.scenes[0].camera.fov_y == "45");
    CHECK(!plan.scenes[0].camera.near_plane);
}

TEST_CASE("plan: what is wrong is told with its line") {
    CHECK(refusal("xjun", "xjum")
              .starts_with("plan.json:5: method: there is no such method (xjum); did you mean xjun? "));
    CHECK(refusal("cornell", "cornel")
              .starts_with("plan.json:3: scenes: there is no such scene and no such file (cornel); did you "
                           "mean cornell? "));
    CHECK(refusal("\"seeds\"", "\"sedes\"")
              .starts_with("plan.json:7: plan: there is no such member (sedes); did you mean seeds? "));
    CHECK(refusal("{\"samples\": [4", "{\"sample\": [4")
              .starts_with("plan.json:5: parameters: there is no such parameter of gtao (sample); did you "
                           "mean samples? "));
    CHECK(refusal("\"ao_scale\"", "\"ao_scales\"")
              .starts_with("plan.json:6: parameters: there is no such parameter of any of these methods "
                           "(ao_scales); did you mean ao_scale? "));
    CHECK(refusal("[4, 8]", "[]") == "plan.json:5: samples: an empty list ([]); give at least one value");
    CHECK(refusal("[4, 8]", "[4, 4]") == "plan.json:5: samples: given twice (4); leave one away");
    CHECK(refusal("[4, 8]", "[4, \"4\"]") == "plan.json:5: samples: given twice (4); leave one away");
    CHECK(refusal("\"cornell\"", "\"cornell\", {\"scene\": \"cornell\"}")
              .starts_with("plan.json:3: scenes: given twice (cornell 48x27); "));
    CHECK(refusal("[4, 8]", "[4,\n 5000]") ==
          "plan.json:6: gtao: samples: not a whole number in 4..192 (5000); choose one");
    CHECK(refusal("[4, 8]", "4") == "plan.json:5: samples: not a list (4); write [...]");
    CHECK(refusal("\"ao_scale\": [0.5, 1]", "\"radius\": [-1]").starts_with("plan.json:6: xjun: radius: "));
    CHECK(refusal("\"ao_scale\": [0.5, 1]", "\"seed\": [1]")
              .starts_with("plan.json:6: seed: not among parameters"));
    CHECK(
        refusal("[[48, 27]]", "[[48, 0]]").starts_with("plan.json:4: sizes: not a size in pixels (48x0); "));
    CHECK(refusal("[[48, 27]]", "[48, 27]").starts_with("plan.json:4: sizes: not two numbers (48); "));
    CHECK(refusal("[[48, 27]]", "[]").starts_with("plan.json:4: sizes: an empty list ([]); "));
    CHECK(refusal("\"repetitions\": 0", "\"repetitions\": -1")
              .starts_with("plan.json:9: repetitions: not a whole number in "));
    CHECK(refusal("\"repetitions\": 0", "\"repetitions\": 1.5")
              .starts_with("plan.json:9: repetitions: not a whole number in "));
    CHECK(refusal("[1000, 1001]", "[1000, -1]").starts_with("plan.json:7: seeds: not a whole number in "));
    CHECK(refusal("\"small\"", "\"../small\"").starts_with("plan.json:2: name: not 1 to 64 letters"));
    CHECK(refusal("\"cornell\"", "{\"scene\": \"cornell\", \"eye\": [1, 2]}")
              .starts_with("plan.json:3: eye: not three numbers ([1,2]); "));
    CHECK(refusal("\"cornell\"", "{\"scene\": \"cornell\", \"fov_y\": 400}")
              .starts_with("plan.json:3: --fov-y: "));
    CHECK(refusal("\"cornell\"", "\"empty\"")
              .starts_with("plan.json:3: scenes: nothing to be seen (empty has 0 triangles); "));
    CHECK(refusal("\"xjun\"", "\"none\"").starts_with("plan.json:5: methods: computes no AO (none); "));
    CHECK(refusal("\"xjun\"", "\"gtao\"").starts_with("plan.json:5: methods: given twice (gtao); "));
    CHECK(refusal("\"scenes\": [\"cornell\"],\n", "").starts_with("plan.json:1: scenes: missing (); "));
}

TEST_CASE("plan: texts that are no JSON, or end too soon") {
    const auto said = [](const std::string& text) {
        return message_of<UsageError>([&] { plan_from_text(text, "plan.json"); });
    };
    CHECK(said("").starts_with("plan.json:1: the file ends too soon (0 bytes); "));
    CHECK(said(kSmallPlan.substr(0, 60)).starts_with("plan.json:4: the file ends too soon (60 bytes); "));
    CHECK(said("{\n\"name\": small}").starts_with("plan.json:2: not JSON (at byte 11); "));
    const std::string deep = "{\"scenes\":\n" + std::string(300000, '[') + std::string(300000, ']') + "}";
    CHECK(said(deep) == "plan.json:2: nested too deeply (more than 100 levels); write it flatter");
    CHECK(said("{\"name\": \"a\\u0000b\"}").find('\0') == std::string::npos);
    CHECK(
        said(plan_with("small", std::string(65, 'a'))).starts_with("plan.json:2: name: not 1 to 64 letters"));
    CHECK(said(plan_with("[1000, 1001]", "[1000, \"1001\"]"))
              .starts_with("plan.json:7: seeds: not a whole number in "));
    CHECK(said(plan_with("\"reference_rays\": 16", "\"parts\": 1"))
              .starts_with("plan.json:10: parts: neither true nor false (1); "));
    CHECK(said("[1]").starts_with("plan.json:1: not an object ([1]); "));
    CHECK(said(plan_with("48", "1e999"))
              .starts_with("plan.json:4: a number is too large to be read (1e999); "));
    CHECK(said("{\"name\": \"\xff\"}").starts_with("plan.json:1: not JSON"));
}

TEST_CASE("plan: the lines of values in awkward texts") {
    const JsonFile file("{ \"a\\\"]\": [1, \"}\\\\\",\n {\"b\": [],\n\"c\" : null}], \"d\":\n2}", "a.json",
                        ExitCode::input);
    CHECK(file.line_of({}) == 1);
    CHECK(file.line_of({"a\"]", "1"}) == 1);
    CHECK(file.line_of({"a\"]", "2"}) == 2);
    CHECK(file.line_of({"a\"]", "2", "c"}) == 3);
    CHECK(file.line_of({"d"}) == 3);
    CHECK(file.line_of({"e"}) == 1);
    CHECK(file.line_of({"a\"]", "7"}) == 1);
}

TEST_CASE("plan: the built-in ones can be read, are as the schema has it, and stay what the demo needs") {
    const SchemaChecks checks(schema());
    for (const char* name : {"quick", "full"}) {
        CAPTURE(name);
        const SweepPlan plan = find_plan(name);
        CHECK(plan.name == name);
        CHECK(checks.against(nlohmann::json::parse(plan.text)) == "");
    }
    CHECK(checks.against(nlohmann::json::parse(kSmallPlan)) == "");
    CHECK(checks.against(nlohmann::json::parse(plan_with("\"seeds\"", "\"sedes\""))) ==
          "/sedes: not in the schema");
    CHECK(find_plan("full").methods.size() == ao_methods().size() - 1);
    CHECK(find_plan("full").sizes.size() == 2);
    CHECK(message_of<UsageError>([] {
              find_plan("quik");
          }).starts_with("PLAN: there is no such plan and no such file (quik); did you mean quick? "));
}
