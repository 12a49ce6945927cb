#include "ssao/judge/error_parts.h"

#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/about.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

Image<float> sum_of(const Image<float>& image, float factor, const Image<float>& change) {
    Image<float> sum = image;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x) sum.at(x, y) += factor * change.at(x, y);
    return sum;
}

// `length` images that wander, some of them as halves.
std::vector<ChainImage> random_chain(Size size, std::size_t length, std::uint32_t stream) {
    std::vector<ChainImage> chain;
    for (std::size_t i = 0; i < length; ++i) {
        const std::uint32_t own = stream + 10 * static_cast<std::uint32_t>(i);
        const float scale = i % 3 == 0 ? 0.5f : 0.02f;
        ChainImage image{"step " + std::to_string(i), noise_image(size, own)};
        if (i > 0) image.first = sum_of(chain.back().first, scale, noise_image(size, own));
        if ((stream + i) % 2 == 0) image.second = sum_of(image.first, 0.3f, noise_image(size, own + 1));
        chain.push_back(std::move(image));
    }
    return chain;
}

}  // namespace

TEST_CASE("error parts: hand-counted on two pixels") {
    Image<float> truth({2, 1}, 0.5f), middle = truth, last = truth;
    middle.at(0, 0) = 0.75f;  // +.25
    last.at(0, 0) = 0.625f;   // -.125
    last.at(1, 0) = 0.25f;    // -.25
    const ChainImage chain[] = {{"truth", truth}, {"up", middle}, {"down", last}};
    const ErrorParts found = error_parts(chain);
    REQUIRE(found.parts.size() == 2);
    CHECK(found.pixels == 2);
    CHECK(found.parts[0].step == "up");
    CHECK(found.parts[1].step == "down");
    CHECK(found.parts[0].bias == 0.125);
    CHECK(found.parts[1].bias == (-0.125 - 0.25) / 2);
    CHECK(found.parts[0].mse == 0.25 * 0.25 / 2);
    CHECK(found.parts[1].rmse == std::sqrt((0.125 * 0.125 + 0.25 * 0.25) / 2));
    // D is .125 and -.25.
    CHECK(found.parts[0].share == 0.25 * 0.125 / 2);
    CHECK(found.parts[1].share == (-0.125 * 0.125 + 0.25 * 0.25) / 2);
    CHECK(found.total.bias == -0.0625);
    CHECK(found.total.mse == (0.125 * 0.125 + 0.25 * 0.25) / 2);
    CHECK(found.total.share == found.total.mse);
    CHECK(found.parts[1].difference.at(0, 0) == -0.125f);
    CHECK(found.total.difference.at(1, 0) == -0.25f);
}

TEST_CASE("error parts add up to the error, whatever the chain") {
    for (const Size size : {Size{1, 1}, Size{37, 19}, Size{8, 200}}) {
        for (std::uint32_t stream = 0; stream < 12; ++stream) {
            CAPTURE(size.width);
            CAPTURE(stream);
            const std::vector<ChainImage> chain = random_chain(size, 2 + stream % 7, stream);
            const ErrorParts found = error_parts(chain);
            REQUIRE(found.parts.size() == chain.size() - 1);
            double bias = 0, share = 0, all_biases = 0, all_shares = 0;
            Image<float> difference(size, 0.0f);
            for (const ErrorPart& part : found.parts) {
                bias += part.bias;
                share += part.share;
                all_biases += std::fabs(part.bias);
                all_shares += std::fabs(part.share);
                difference = sum_of(difference, 1, part.difference);
            }
            CHECK(std::fabs(bias - found.total.bias) <= 1e-12 * (1 + all_biases));
            CHECK(std::fabs(share - found.total.mse) <= 1e-12 * (1 + all_shares));
            CHECK(further_apart_than(2e-6, difference, found.total.difference) == "");
            // By its definition, from the first and the last image.
            double squares = 0;
            const auto second = [](const ChainImage& c) { return c.second.empty() ? c.first : c.second; };
            const Image<float> last = second(chain.back()), first = second(chain.front());
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    squares += (double(chain.back().first.at(x, y)) - chain.front().first.at(x, y)) *
                               (double(last.at(x, y)) - first.at(x, y));
            CHECK(found.total.mse == about(squares / (size.width * size.height), 1e-9));
        }
    }
}

TEST_CASE("error parts: a step that undoes the one before has a negative share") {
    const Size size{30, 30};
    const Image<float> truth(size, 0.5f), noisy = sum_of(truth, 0.2f, noise_image(size, 3)),
                                          blurred = sum_of(truth, 0.05f, noise_image(size, 3));
    const ChainImage chain[] = {{"truth", truth}, {"sampling", noisy}, {"blur", blurred}};
    const ErrorParts found = error_parts(chain);
    CHECK(found.parts[0].share > 0);
    CHECK(found.parts[1].share < 0);
    CHECK(found.parts[1].share == about(-3.0 / 4 * found.parts[0].share, 1e-5));
    CHECK(found.parts[1].rmse == about(3 * found.total.rmse, 1e-5));
}

TEST_CASE("error parts: halves take the noise of an image out of the error") {
    const Size size{160, 120};
    const Image<float> truth(size, 0.5f);
    const auto with_noise = [&](std::uint32_t stream) {
        Image<float> image(size, 0.0f);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) image.at(x, y) = 0.6f + 0.2f * (noise(stream, x, y) - 0.5f);
        return image;
    };
    const double variance = 0.2 * 0.2 / 12;
    const ChainImage both[] = {{"truth", truth}, {"definition", with_noise(1), with_noise(2)}};
    const ErrorParts debiased = error_parts(both);
    CHECK(debiased.total.mse == about(0.01, 0.01));
    CHECK(debiased.parts[0].bias == about(0.1, 0.01));
    const ChainImage one[] = {{"truth", truth}, {"definition", with_noise(1)}};
    CHECK(error_parts(one).total.mse == about(0.01 + variance, 0.01));
    // A noisy truth before an exact image: the first part takes the noise away and is not charged for it.
    const ChainImage noisy_truth[] = {{"truth", with_noise(3), with_noise(4)},
                                      {"definition", truth},
                                      {"storage", Image<float>(size, 0.55f)}};
    const ErrorParts found = error_parts(noisy_truth);
    CHECK(found.total.mse == about(0.05 * 0.05, 0.02));
    CHECK(found.parts[0].mse == about(0.01, 0.02));
    CHECK(found.parts[1].mse == about(0.05 * 0.05, 1e-5));
}

TEST_CASE("error parts: it does not matter which half is called the first") {
    const std::vector<ChainImage> chain = random_chain({23, 17}, 6, 4);
    std::vector<ChainImage> swapped = chain;
    int halved = 0;
    for (ChainImage& image : swapped) {
        if (image.second.empty()) continue;
        std::swap(image.first, image.second);
        ++halved;
    }
    REQUIRE(halved > 1);
    const ErrorParts found = error_parts(chain), other = error_parts(swapped);
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
        CAPTURE(i);
        CHECK(found.parts[i].share == about(other.parts[i].share, 1e-12));
        CHECK(found.parts[i].mse == about(other.parts[i].mse, 1e-12));
    }
}

TEST_CASE("error parts: a part alone may be below its noise; then its root is 0") {
    const Size size{2, 1};
    Image<float> first(size, 0.5f), second(size, 0.5f);
    first.at(0, 0) = 0.6f;
    second.at(0, 0) = 0.4f;
    const ChainImage chain[] = {{"truth", Image<float>(size, 0.5f)}, {"sampling", first, second}};
    const ErrorParts found = error_parts(chain);
    CHECK(found.parts[0].mse < 0);
    CHECK(found.parts[0].rmse == 0);
    CHECK(found.total.mse == found.parts[0].share);
}

TEST_CASE("error parts: only pixels that count are in the means, all are in the differences") {
    const Size size{12, 10};
    Image<std::uint8_t> counted(size, 0);
    Image<float> last(size, 0.25f);
    counted.at(3, 3) = counted.at(4, 3) = 1;
    last.at(3, 3) = 1;
    const ChainImage chain[] = {{"truth", Image<float>(size, 0.0f)}, {"definition", last}};
    const ErrorParts found = error_parts(chain, counted);
    CHECK(found.pixels == 2);
    CHECK(found.total.bias == 0.625);
    CHECK(found.parts[0].difference.at(11, 9) == 0.25f);
}

TEST_CASE("error parts add up on a large picture of one value, where rounding piles up") {
    const Size size{1280, 720};
    const ChainImage chain[] = {{"truth", Image<float>(size, 0.1f)},
                                {"definition", Image<float>(size, 0.7f)},
                                {"storage", Image<float>(size, 0.3f)}};
    CHECK_NOTHROW(error_parts(chain));
    CHECK(error_parts(chain).total.bias == about(double(0.3f) - double(0.1f), 1e-12));
}

TEST_CASE("error parts refuse what has no answer, by name") {
    const Size size{6, 5};
    const Image<float> truth(size, 0.5f);
    Image<float> broken = truth;
    broken.at(4, 2) = kNan;
    const ChainImage with_nan[] = {{"truth", truth}, {"half resolution", broken}, {"blur", truth}};
    CHECK_THROWS_WITH_AS(error_parts(with_nan),
                         "the image of step \"half resolution\" is not finite at pixel 4, 2 (nan); its error "
                         "has no parts until that is mended",
                         InputError);
    const ChainImage nan_half[] = {{"truth", truth}, {"sampling", truth, broken}};
    CHECK_THROWS_AS(error_parts(nan_half), InputError);
    const ChainImage other_size[] = {{"truth", truth}, {"sampling", Image<float>({6, 4}, 0.5f)}};
    CHECK_THROWS_AS(error_parts(other_size), InputError);
    const ChainImage other_half[] = {{"truth", truth}, {"sampling", truth, Image<float>({6, 4}, 0.5f)}};
    CHECK_THROWS_AS(error_parts(other_half), InputError);
    const ChainImage alone[] = {{"truth", truth}};
    CHECK_THROWS_AS(error_parts(alone), InputError);
    CHECK_THROWS_AS(error_parts({}), InputError);
    const ChainImage good[] = {{"truth", truth}, {"sampling", truth}};
    CHECK_THROWS_AS(error_parts(good, Image<std::uint8_t>(size, 0)), InputError);
    CHECK_THROWS_AS(error_parts(good, Image<std::uint8_t>({6, 4}, 1)), InputError);
}
