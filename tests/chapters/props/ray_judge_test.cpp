#include "chapters/props/ray_judge.h"

#include <doctest/doctest.h>

using namespace crevice;

namespace {

// A small view of X_Jun's columns with one parameter set.
struct Judged {
    SwitchedView view{"columns", {160, 90}};
    ProbedView drawn, cured;
    RayJudge judge;

    explicit Judged(const Words& words) : drawn(view, words), cured(view, {}), judge(view, drawn, 1) {}
};

}  // namespace

TEST_CASE("ray judge: planes that darken themselves are wrong by what they lack, and their samples lie") {
    const Judged of({"self_occlusion_test=false"});
    const std::vector<Texel> wrong = of.judge.wrong_texels(of.drawn, 0.1f);
    REQUIRE(!wrong.empty());
    const Texel worst = wrong[0];
    const float ao = of.drawn.ao().at(worst.x, worst.y);
    CAPTURE(worst.x);
    CAPTURE(worst.y);
    CHECK(ao < 0.5f);
    CHECK(of.judge.signed_error(of.drawn).at(worst.x, worst.y) == ao - 1);
    CHECK(wrong.size() > 10 * of.judge.wrong_texels(of.cured, 0.1f).size());
    const Explanation texel = of.drawn.explanation(worst);
    const std::optional<std::size_t> guilty = of.judge.guilty_sample(texel);
    REQUIRE(guilty);
    CHECK(of.judge.is_free(texel, *guilty));
    for (std::size_t i = 0; i < texel.samples.size(); ++i) {
        CAPTURE(i);
        const bool takes_more = texel.samples[i].contribution > texel.samples[*guilty].contribution;
        CHECK(!(takes_more && of.judge.is_free(texel, i)));
    }
}

TEST_CASE("ray judge: a sample whose q lies beneath a surface is not free") {
    const Judged of({});
    Explanation texel = of.drawn.explanation({40, 35});
    REQUIRE(texel.surface);
    texel.samples[0].offset = 0.3f * texel.n_view;
    CHECK(of.judge.is_free(texel, 0));
    texel.samples[0].offset = -0.3f * texel.n_view;
    // A ray starts on the side that it goes to: what it meets down there is the other side of the ground, if that has one.
    texel.p_view += 0.1f * texel.n_view;
    CHECK(!of.judge.is_free(texel, 0));
}

TEST_CASE("ray judge: false borders come highest first, from the darker texel to the lighter one") {
    const Judged of({"random_vectors=none"});
    const std::vector<FalseBorder> borders = of.judge.false_borders(of.drawn, 0.1f);
    REQUIRE(!borders.empty());
    const Image<float>& ao = of.drawn.ao();
    for (std::size_t i = 0; i < borders.size(); ++i) {
        const auto& [dark, light, height] = borders[i];
        CAPTURE(i);
        CHECK(height > 0.1f);
        CHECK(height == ao.at(light.x, light.y) - ao.at(dark.x, dark.y));
        CHECK(std::abs(dark.x - light.x) + std::abs(dark.y - light.y) == 1);
        if (i > 0) CHECK(height <= borders[i - 1].height);
    }
}

TEST_CASE("changed most: the sample that differs most, and its share of all differences") {
    Explanation a, b;
    a.samples.resize(3);
    b.samples.resize(3);
    CHECK(changed_most(a, b).share == 0);
    a.samples[1].contribution = 0.75f;
    b.samples[2].contribution = 0.25f;
    CHECK(changed_most(a, b).sample == 1);
    CHECK(changed_most(a, b).share == 0.75);
}
