#include "chapters/props/mirrored_vectors.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "chapters/notebook/svg.h"
#include "chapters/props/crops.h"
#include "chapters/props/number_words.h"

namespace crevice {

Vectors mirrored(Vectors vectors, glm::vec3 r) {
    for (glm::vec3& v : vectors) v = mirrored(v, r);
    return vectors;
}

VectorPanel panel(const std::string& words, const Vectors& vectors) {
    VectorPanel result{words, {}};
    for (const glm::vec3& v : vectors)
        result.vectors.push_back({v, glm::length(v) > 1.00001f ? kSvgOccluded : kSvgOpen});
    return result;
}

VectorPanel panel_with_mirror(const std::string& words, const Vectors& vectors, glm::vec3 r) {
    VectorPanel drawn = panel(words, vectors);
    drawn.vectors.push_back({r, kSvgPoint, "r"});
    return drawn;
}

std::vector<std::vector<std::string>> offset_rows(const Vectors& offsets) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < offsets.size(); i += 2) {
        const glm::vec3 way = glm::sign(offsets[i]);
        rows.push_back({exact_text(way.x) + ", " + exact_text(way.y) + ", " + exact_text(way.z),
                        text(glm::length(offsets[i])), text(glm::length(offsets[i + 1]))});
    }
    return rows;
}

Evenness evenness(const Vectors& vectors) {
    Evenness result;
    double cosine = -1;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const glm::dvec3 a(vectors[i]), b(vectors[j]);
            cosine = std::max(cosine, glm::dot(glm::normalize(a), glm::normalize(b)));
        }
    }
    result.closest_deg = 57.29577951308232 * std::acos(cosine);
    glm::vec3 mean(0);
    for (std::size_t i = 0; i < vectors.size(); i += 2) {
        const glm::vec3 first = glm::normalize(vectors[i]), second = glm::normalize(vectors[i + 1]);
        mean += (first + second) / static_cast<float>(vectors.size());
        result.opposite = std::min(result.opposite, -glm::dot(first, second));
    }
    result.mean = glm::length(mean);
    return result;
}

std::vector<glm::vec3> all_mirrored(Vectors offsets, const RandomMap& map, bool unit) {
    for (glm::vec3& o : offsets) o = glm::normalize(o);
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < map.x.size(); ++i) {
        const glm::vec3 r(map.x[i], map.y[i], map.z[i]);
        const Vectors d = mirrored(offsets, unit ? glm::normalize(r) : r);
        result.insert(result.end(), d.begin(), d.end());
    }
    return result;
}

std::vector<float> sorted_lengths(const std::vector<glm::vec3>& vectors) {
    std::vector<float> lengths;
    for (const glm::vec3& v : vectors) lengths.push_back(glm::length(v));
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

PlotCurve length_shares(const std::vector<float>& sorted) {
    PlotCurve curve{"raw r", {}, {}, {}, {}, PlotStyle::smooth};
    const auto first = [&](float value) { return std::lower_bound(sorted.begin(), sorted.end(), value); };
    for (int bar = 0; bar < 60; ++bar) {
        const float low = 0.05f * static_cast<float>(bar);
        curve.x.push_back(static_cast<double>(low + 0.025f));
        curve.y.push_back(100.0 * static_cast<double>(first(low + 0.05f) - first(low)) /
                          static_cast<double>(sorted.size()));
    }
    return curve;
}

Image<float> density(const std::vector<glm::vec3>& directions) {
    constexpr int kCells = 48;
    Image<float> cells({kCells, kCells}, 0.0f);
    for (const glm::vec3& d : directions) {
        const glm::vec3 n = d.z < 0 ? -d : d;
        const float scale = 1 / std::sqrt(1 + n.z);
        const auto cell = [&](float a) { return static_cast<int>((a * scale + 1) * 23.99f); };
        cells.at(cell(n.x), kCells - 1 - cell(n.y)) +=
            3.14159265f * 24 * 24 / static_cast<float>(directions.size());
    }
    return enlarged(cells, 4);
}

}  // namespace crevice
