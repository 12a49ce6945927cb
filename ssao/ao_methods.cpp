#include "ssao/ao_methods.h"

#include "rasterizer/base/no_such.h"
#include "ssao/rows/rows.h"

namespace crevice {

std::span<const Method> ao_methods() {
    static const Method rows[] = {xjun_row(),        luna_row(),    hemisphere_row(), unity_row(),
                                  alchemy_row(),     sao_row(),     msvo_row(),       hbao_row(),
                                  hbao_plus_row(),   gtao_row(),    vbao_row(),       ray_cast_row(),
                                  vertex_bake_row(), crevice_row(), none_row()};
    return rows;
}

const Method& find_method(const std::string& name) {
    std::vector<std::string> known;
    for (const Method& method : ao_methods()) {
        if (name == method.name) return method;
        known.push_back(method.name);
    }
    throw no_such("method", "method", name, known);
}

}  // namespace crevice
