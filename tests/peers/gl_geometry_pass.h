// A pass that draws all triangles: a program for each kind of surface among them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "tests/peers/gl_geometry.h"
#include "tests/peers/gl_program.h"

namespace crevice {

// What of a surface's textures a pass reads.
enum class GlReads { holes, colours };

class GlGeometryPass {
 public:
    // `geometry` must outlive it.
    GlGeometryPass(const std::string& prefix, const GlGeometry& geometry, const std::string& pixels,
                   GlReads reads);

    template <class Value>
    void set(const char* name, const Value& value) const {
        for (const auto& [kind, program] : programs_) program->set(name, value);
    }
    void draw() const;

 private:
    int kind_of(const PeerDraw& draw) const;

    const GlGeometry& geometry_;
    GlReads reads_;
    std::map<int, std::unique_ptr<GlProgram>> programs_;
};

// From where a pass sees them: of GlGeometryPass.
void set_view(const GlGeometryPass& pass, const glm::vec3& eye_world, const glm::mat4& clip_from_relative,
              const glm::mat4& view_from_relative);

}  // namespace crevice
