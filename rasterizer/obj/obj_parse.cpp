#include "rasterizer/obj/obj_parse.h"

#include <sstream>

#include <tiny_obj_loader.h>

namespace crevice {
namespace {

// What the callbacks see: where the statement comes from, and where its result goes.
struct Reading {
    const ObjPrescan& prescan;
    ObjFaces result;
};

// `index` as written: from 1, negative ones back from the `listed_before`, 0 for none.
std::int32_t absolute_index(int index, std::int32_t listed_before) {
    if (index > 0) return index - 1;
    if (index == 0) return kAbsentIndex;
    return -static_cast<std::int64_t>(index) <= listed_before ? listed_before + index : kBeforeFirst;
}

void on_face(void* user, tinyobj::index_t* indices, int count) {
    Reading& reading = *static_cast<Reading*>(user);
    ObjFaces& result = reading.result;
    const FaceOrigin& origin = reading.prescan.face_origins[result.faces.size()];
    result.faces.push_back({result.corners.size(), static_cast<std::uint32_t>(count), origin.material,
                            origin.line, origin.smoothing});
    for (int i = 0; i < count; ++i) {
        result.corners.push_back({absolute_index(indices[i].vertex_index, origin.positions),
                                  absolute_index(indices[i].texcoord_index, origin.texcoords),
                                  absolute_index(indices[i].normal_index, origin.normals)});
    }
}

}  // namespace

ObjFaces parse_faces(const ObjPrescan& prescan) {
    Reading reading{.prescan = prescan, .result = {}};
    reading.result.faces.reserve(prescan.face_origins.size());
    reading.result.corners.reserve(prescan.face_origins.size() * 3);
    tinyobj::callback_t callbacks;
    callbacks.index_cb = on_face;
    std::istringstream stream(prescan.statements);
    tinyobj::LoadObjWithCallback(stream, callbacks, &reading);
    return std::move(reading.result);
}

}  // namespace crevice
