// The window of the viewer.
#pragma once

#include <filesystem>
#include <string>

#include "rasterizer/base/image.h"

struct SDL_Window;

namespace crevice {

// SDL, a window in it, OpenGL in the window (of any version: that only shows what was drawn here), and Dear ImGui on top, for
// as long as this lives. Throws UsageError, with SDL's own words, where no window can be opened or drawn in.
class ViewWindow {
 public:
    ViewWindow();
    ~ViewWindow();
    ViewWindow(const ViewWindow&) = delete;
    ViewWindow& operator=(const ViewWindow&) = delete;

    void begin() const;
    void end() const;
    void present() const;
    // What end() drew, as a PNG. Throws OutputError.
    void save(const std::filesystem::path& path) const;

 private:
    Size drawn_size() const;

    SDL_Window* window_ = nullptr;
    void* context_ = nullptr;  // an SDL_GLContext
};

}  // namespace crevice
