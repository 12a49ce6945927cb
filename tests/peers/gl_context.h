// An OpenGL 4.5 context without a window, on Mesa's software renderer.
#pragma once

#include <string>

namespace crevice {

// Current on this thread while it lives. Throws InputError when EGL offers none.
class GlContext {
 public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    // Who draws, and which version: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
    std::string renderer() const;

 private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace crevice
