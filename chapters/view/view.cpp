#include "chapters/view/view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

#include <SDL2/SDL.h>
#include <SDL2/SDL_opengl.h>
#include <backends/imgui_impl_opengl2.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include "chapters/lab/render_words.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/view/view_camera.h"
#include "chapters/view/view_panels.h"
#include "chapters/view/view_pictures.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

constexpr int kWindowWidth_px = 1280, kWindowHeight_px = 760;
constexpr double kTurn_rad_per_px = 0.006;
constexpr double kStep = 0.06;    // of a key, parts of the distance between eye and target
constexpr double kZoom = 1.12;    // of a notch of the wheel
constexpr int kNextLook_ms = 15;  // how long to wait for an event before the next look at the frame
constexpr int kClick_px = 3;      // a press that moves no further is a click

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

// SDL, a window in it, OpenGL in the window (of any version: that only shows what was drawn here), and Dear ImGui on top, for
// as long as this lives.
class Window {
 public:
    Window() {
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
    ~Window() {
        ImGui_ImplOpenGL2_Shutdown();
        ImGui_ImplSDL2_Shutdown();
        ImGui::DestroyContext();
        SDL_GL_DeleteContext(context_);
        SDL_DestroyWindow(window_);
        SDL_Quit();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void begin() const {
        ImGui_ImplOpenGL2_NewFrame();
        ImGui_ImplSDL2_NewFrame();
        ImGui::NewFrame();
    }
    void end() const {
        ImGui::Render();
        const Size size = drawn_size();
        glViewport(0, 0, size.width, size.height);
        glClearColor(0.09f, 0.09f, 0.1f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    }
    void present() const { SDL_GL_SwapWindow(window_); }
    // What end() drew, as a PNG. Throws OutputError.
    void save(const std::filesystem::path& path) const {
        const Size size = drawn_size();
        const auto row = 3 * static_cast<std::size_t>(size.width);
        std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(size.height)), pixels;
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
        pixels.reserve(upside_down.size());
        for (auto end = upside_down.end(); end != upside_down.begin();
             end -= static_cast<std::ptrdiff_t>(row))
            pixels.insert(pixels.end(), end - static_cast<std::ptrdiff_t>(row), end);
        write_png(path, size, 3, pixels);
    }

 private:
    Size drawn_size() const {
        Size size;
        SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
        return size;
    }

    SDL_Window* window_ = nullptr;
    SDL_GLContext context_ = nullptr;
};

void press(ViewState& state, SDL_Keycode key, const ViewFrame& newest) {
    const auto go = [&](double right, double up, double forward) {
        state.move_camera(newest, [&](const Camera& camera) {
            return moved(camera, kStep * glm::dvec3(right, up, forward));
        });
    };
    switch (key) {
        case SDLK_w: return go(0, 0, 1);
        case SDLK_s: return go(0, 0, -1);
        case SDLK_a: return go(-1, 0, 0);
        case SDLK_d: return go(1, 0, 0);
        case SDLK_e: return go(0, 1, 0);
        case SDLK_q: return go(0, -1, 0);
        case SDLK_r: return state.reset_camera();
        case SDLK_t: return state.ask_truth(!state.wish.truth);
        case SDLK_l: state.shows_left_out = !state.shows_left_out; return;
        case SDLK_f: state.flies = !state.flies; return;
        case SDLK_c: state.copies_command = true; return;
        case SDLK_F12: state.takes_screenshot = true; return;
        case SDLK_SPACE: state.flips = !state.flips; return;
        case SDLK_ESCAPE: state.wish.pixel.reset(); return;
        default: break;
    }
    const std::vector<std::string> buffers = buffers_to_show(state.wish.words.ao);
    const auto number = static_cast<std::size_t>(key - SDLK_1);
    if (key >= SDLK_1 && number < buffers.size()) state.show(0, buffers[number]);
}

// Dragging and the wheel over the picture; a click asks about a pixel. From SDL's own events: the positions that Dear ImGui
// asks the system for stand still on some displays while a button is held.
class PictureMouse {
 public:
    void handle(const SDL_Event& event, ViewState& state, const ViewFrame& newest,
                const ViewPictures& pictures) {
        if (ImGui::GetIO().WantCaptureMouse) return;
        if (event.type == SDL_MOUSEWHEEL) {
            const double factor = std::pow(kZoom, -event.wheel.y);
            state.move_camera(newest, [&](const Camera& camera) { return zoomed(camera, factor); });
        } else if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT) {
            is_down_ = true;
            way_px_ = 0;
        } else if (event.type == SDL_MOUSEMOTION && is_down_) {
            drag(state, newest, event.motion.xrel, event.motion.yrel);
        } else if (event.type == SDL_MOUSEBUTTONUP && event.button.button == SDL_BUTTON_LEFT && is_down_) {
            is_down_ = false;
            if (way_px_ > kClick_px) return;
            const auto pixel =
                pictures.pixel_at(static_cast<float>(event.button.x), static_cast<float>(event.button.y));
            if (pixel) state.wish.pixel = pixel;
        }
    }

 private:
    void drag(ViewState& state, const ViewFrame& newest, int dx_px, int dy_px) {
        way_px_ += std::abs(dx_px) + std::abs(dy_px);
        if (way_px_ <= kClick_px) return;
        const double x = kTurn_rad_per_px * dx_px, y = kTurn_rad_per_px * dy_px;
        state.move_camera(newest, [&](const Camera& camera) {
            return state.flies ? looked_aside(camera, -x, y) : orbited(camera, x, y);
        });
    }

    bool is_down_ = false;
    int way_px_ = 0;  // since the button went down
};

// What was asked for by key or button and is done with the frame that is on the screen.
void do_asked(ViewState& state, const ViewFrame& newest, const Window& window,
              const std::filesystem::path& out) {
    if (std::exchange(state.copies_command, false)) {
        const std::string command = render_command(newest.words);
        SDL_SetClipboardText(command.c_str());
        std::cout << command << "\n";
        for (const auto& [buffer, hash] : newest.hashes) std::cout << "# " << buffer << " " << hash << "\n";
        std::cout.flush();
        state.said = "copied: " + command;
    }
    if (std::exchange(state.takes_screenshot, false)) {
        int number = 0;
        std::filesystem::path path;
        do {
            path = out / ("view_" + std::to_string(number++) + ".png");
        } while (std::filesystem::exists(path));
        try {
            try_output_directory(out);
            window.save(path);
            state.said = "written: " + path.string();
        } catch (const OutputError& error) {
            state.said = error.what();
        }
        std::cout << state.said << std::endl;
    }
}

}  // namespace

void view(const ViewOptions& options) {
    const Window window;
    FrameThread frames(options.run);
    ViewState state;
    state.wish.words = options.words;
    state.wish.shown = options.shown;
    state.first_camera = options.words.camera;
    if (options.shown.size() > 1) state.layout = ViewLayout::split;
    ViewPictures pictures;
    std::shared_ptr<const ViewFrame> newest;
    frames.wish(state.wish);
    PictureMouse mouse;
    const auto handle = [&](const SDL_Event& event) {
        ImGui_ImplSDL2_ProcessEvent(&event);
        if (event.type == SDL_QUIT) state.ends = true;
        if (newest == nullptr) return;
        mouse.handle(event, state, *newest, pictures);
        if (event.type == SDL_KEYDOWN && !ImGui::GetIO().WantTextInput)
            press(state, event.key.keysym.sym, *newest);
    };
    while (!state.ends) {
        const ViewWish before = state.wish;
        SDL_Event event;
        if (SDL_WaitEventTimeout(&event, kNextLook_ms) != 0) handle(event);
        while (SDL_PollEvent(&event) != 0) handle(event);
        if (const auto frame = frames.newest(); frame != newest) {
            if (newest == nullptr || newest->drawn != frame->drawn) state.note_times(*frame);
            newest = frame;
            pictures.upload(*newest);
        }
        window.begin();
        draw_controls(state, newest.get());
        if (newest) {
            pictures.draw(state, *newest);
            if (state.wish.pixel) draw_probe(*newest);
        }
        window.end();
        if (newest) do_asked(state, *newest, window, options.out);
        window.present();
        if (!state.wish.same_work_as(before)) frames.wish(state.wish);
    }
}

}  // namespace crevice
