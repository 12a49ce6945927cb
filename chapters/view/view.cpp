#include "chapters/view/view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <utility>

#include <SDL2/SDL.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include "chapters/lab/render_words.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/view/view_camera.h"
#include "chapters/view/view_panels.h"
#include "chapters/view/view_pictures.h"
#include "chapters/view/view_window.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr double kTurn_rad_per_px = 0.006;
constexpr double kStep = 0.06;    // of a key, parts of the distance between eye and target
constexpr double kZoom = 1.12;    // of a notch of the wheel
constexpr int kNextLook_ms = 15;  // how long to wait for an event before the next look at the frame
constexpr int kClick_px = 3;      // a press that moves no further is a click

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
void do_asked(ViewState& state, const ViewFrame& newest, const ViewWindow& window,
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
    const ViewWindow window;
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
