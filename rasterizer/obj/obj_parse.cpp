#include "rasterizer/obj/obj_parse.h"

#include <sstream>

#include <tiny_obj_loader.h>

namespace crevice {
namespace {

void on_face(void* user, tinyobj::index_t* indices, int count) {
    WrittenFaces& written = *static_cast<WrittenFaces*>(user);
    written.corner_counts.push_back(static_cast<std::uint32_t>(count));
    for (int i = 0; i < count; ++i) {
        written.corners.push_back(
            {indices[i].vertex_index, indices[i].texcoord_index, indices[i].normal_index});
    }
}

}  // namespace

WrittenFaces parse_faces(const std::string& statements) {
    WrittenFaces written;
    tinyobj::callback_t callbacks;
    callbacks.index_cb = on_face;
    std::istringstream stream(statements);
    tinyobj::LoadObjWithCallback(stream, callbacks, &written);
    return written;
}

}  // namespace crevice
