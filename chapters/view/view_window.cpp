#include "chapters/view/view_window.h"

#include <cstdlib>
#include <vector>

#include <SDL2/SDL.h>
#include <SDL2/SDL_opengl.h>
#include <backends/imgui_impl_opengl2.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

constexpr int kWindowWidth_px = 1280, kWindowHeight_px = 760;

// Throws UsageError with SDL's own words.
[[noreturn]] void fail(const std::string& what) {
    throw UsageError("crevice view: " + what + " (" + SDL_GetError() +
                     "); it needs a display, such as that of a desktop or of xvfb-run");
}

// Without a display SDL falls back to drivers that show nothing to nobody.
void require_screen() {
    const std::string driver = SDL_GetCurrentVideoDriver();
    if (std::getenv("SDL_VIDEODRIVER") != nullptr || (driver != "offscreen" && driver != "dummy")) return;
    SDL_SetError("only the driver %s is there", driver.c_str());
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    fail("no window can be opened");
}

}  // namespace

ViewWindow::ViewWindow() {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
    require_screen();
    window_ = SDL_CreateWindow("Crevice", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, kWindowWidth_px,
                               kWindowHeight_px, SDL_WINDOW_RESIZABLE | SDL_WINDOW_OPENGL);
    if (window_ == nullptr) fail("no window can be opened");
    context_ = SDL_GL_CreateContext(window_);
    if (context_ == nullptr) fail("the window cannot be drawn in");
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is written unasked
    ImGui_ImplSDL2_InitForOpenGL(window_, context_);
    ImGui_ImplOpenGL2_Init();
}

ViewWindow::~ViewWindow() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
    SDL_GL_DeleteContext(context_);
    SDL_DestroyWindow(window_);
    SDL_Quit();
}

void ViewWindow::begin() const {
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
}

void ViewWindow::end() const {
    ImGui::Render();
    const Size size = drawn_size();
    glViewport(0, 0, size.width, size.height);
    glClearColor(0.09f, 0.09f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void ViewWindow::present() const { SDL_GL_SwapWindow(window_); }

void ViewWindow::save(const std::filesystem::path& path) const {
    const Size size = drawn_size();
    const auto row = 3 * static_cast<std::size_t>(size.width);
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(size.height)), pixels;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
    pixels.reserve(upside_down.size());
    for (auto end = upside_down.end(); end != upside_down.begin(); end -= static_cast<std::ptrdiff_t>(row))
        pixels.insert(pixels.end(), end - static_cast<std::ptrdiff_t>(row), end);
    write_png(path, size, 3, pixels);
}

Size ViewWindow::drawn_size() const {
    Size size;
    SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
    return size;
}

}  // namespace crevice
