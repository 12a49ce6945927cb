// The probe's document: as its schema has it, and every float in it reads back as the same float.
#include "chapters/probe/probe_json.h"

#include <cmath>
#include <fstream>

#include <doctest/doctest.h>

#include "tests/tools/probed_frame.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/still_life.h"

using namespace crevice;
using nlohmann::json;

namespace {

constexpr Size kSmall{53, 31};

SchemaChecks probe_schema() {
    std::ifstream stream(CREVICE_SCHEMA_DIR "/probe.schema.json");
    return SchemaChecks(json::parse(stream));
}

// A float as a reader of the document gets it.
bool reads_as(const json& number, float value) {
    return std::isfinite(value) ? number.get<float>() == value : number.is_null();
}
bool reads_as(const json& numbers, const glm::vec3& v) {
    return reads_as(numbers[0], v.x) && reads_as(numbers[1], v.y) && reads_as(numbers[2], v.z);
}

bool reads_as(const json& document, const ExplainedSample& s) {
    return reads_as(document["offset"], s.offset) && reads_as(document["q_view"], s.q_view) &&
           reads_as(document["r_view"], s.r_view) && reads_as(document["dz"], s.dz) &&
           reads_as(document["weight"], s.weight) && reads_as(document["contribution"], s.contribution) &&
           document["verdict"] == s.verdict && document["numbers"].size() == s.numbers.size();
}

// What a reader adds up.
float sum_of(const json& samples) {
    float sum = 0;
    for (const json& sample : samples) sum = sum + sample["contribution"].get<float>();
    return sum;
}
float mean_of(const json& taps) {
    float sum = 0, total = 0;
    for (const json& tap : taps) {
        sum = sum + tap["weight"].get<float>() * tap["value"].get<float>();
        total = total + tap["weight"].get<float>();
    }
    return std::min(sum / total, 1.0f);
}

}  // namespace

TEST_CASE(
    "probe json: every method's document is as the schema has it, and its numbers add up to its values") {
    const SchemaChecks schema = probe_schema();
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        // A radius with which even the few rays of one pixel meet something.
        const std::vector<std::string> far = {"radius=2"};
        const ProbedFrame frame(still_life(), method, kSmall,
                                method.computes_ao() ? far : std::vector<std::string>());
        int occluded = 0, blurred = 0;
        for (const glm::ivec2 pixel : {glm::ivec2(0, 0), {17, 25}, {22, 20}, {30, 19}, {36, 22}, {52, 30}}) {
            const PixelProbe probe = frame.at(pixel.x, pixel.y);
            const json document = json::parse(probe_json(probe));
            CAPTURE(pixel.x);
            CAPTURE(pixel.y);
            CHECK(schema.against(document) == "");
            const json& ao = document["passes"]["ao"];
            CHECK(ao["value"].get<float>() == probe.ao.value);
            if (probe.ao.left_out.empty())
                CHECK(probe.ao.explanation.value_of_sum(sum_of(ao["samples"])) == probe.ao.value);
            const std::vector<ExplainedSample>& samples = probe.ao.explanation.samples;
            REQUIRE(ao["samples"].size() == samples.size());
            for (std::size_t i = 0; i < samples.size(); ++i) CHECK(reads_as(ao["samples"][i], samples[i]));
            occluded += probe.ao.sum > 0 ? 1 : 0;
            const json& blur = document["passes"]["blur"];
            CHECK(blur["value"].get<float>() == probe.blur.value);
            const json last_step = blur["passes"].empty() ? "" : blur["passes"].back()["last_step"];
            if (last_step == "sum / total" || last_step == "sum / total, at most 1") {
                CHECK(mean_of(blur["taps"]) == probe.blur.value);
                ++blurred;
            }
            CHECK(reads_as(document["passes"]["lit"]["value"], probe.lit.explanation.colour));
            CHECK(document["passes"]["raster"]["code"] == probe.raster.code);
        }
        if (method.computes_ao()) CHECK(occluded > 0);
        if (method.denoiser.denoised) CHECK(blurred > 1);
    }
}

TEST_CASE("probe json: one pass alone, and what a schema must refuse it does refuse") {
    const SchemaChecks schema = probe_schema();
    const PixelProbe probe = ProbedFrame(still_life(), find_method("xjun"), kSmall).at(22, 20);
    for (const char* pass : kProbedPasses) {
        const json document = json::parse(probe_json(probe, pass));
        CHECK(schema.against(document) == "");
        CHECK(document["passes"].contains(pass));
        CHECK(document["passes"].size() == (std::string(pass) == "normal_depth" ? 2 : 1));
    }
    const json whole = json::parse(probe_json(probe));
    const auto spoilt = [&](const char* place, const json& by) {
        json document = whole;
        document[json::json_pointer(place)] = by;
        return schema.against(document);
    };
    CHECK(spoilt("/size", json::array({1})) == "/size: holds 1 items");
    CHECK(spoilt("/passes/ao/value", "1") == "/passes/ao/value: \"1\" is no [\"number\",\"null\"]");
    CHECK(
        spoilt("/passes/raster/format", "d16s8").starts_with("/passes/raster/format: \"d16s8\" is none of"));
    CHECK(spoilt("/passes/ao/more", 1) == "/passes/ao/more: not in the schema");
    CHECK(spoilt("/passes/lit", json::object()) == "/passes/lit: has no \"surface\"");
}
