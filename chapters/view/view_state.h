// What the window shows and how: changed by mouse, keys and panels, drawn by view.cpp.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "chapters/view/frame_thread.h"

namespace crevice {

// Frames whose times stand in the graph.
inline constexpr std::size_t kFramesInGraph = 120;

enum class ViewLayout { one, side_by_side, split, flip };

struct ViewState {
    ViewWish wish;
    CameraFlags first_camera;  // of the command line: where a reset goes
    ViewLayout layout = ViewLayout::one;
    float split_at = 0.5f;  // part of the picture's width
    bool flips = false;     // of `flip`: the second one is seen
    bool flies = false;     // dragging turns the eye instead of going round the target
    bool shows_left_out = false;
    std::deque<std::vector<PassTime>> times;  // of the last frames
    std::string said;                         // what was done last, for the status line
    bool copies_command = false, takes_screenshot = false, ends = false;  // asked for, not yet done

    // A frame must be drawn anew.
    void redraw() { ++wish.revision; }

    // Another scene, method, preset or size: what was set for the one before goes.
    void use_scene(const std::string& name);
    void use_method(const std::string& name);
    void use_size(const std::string& word);
    void use_preset(const std::string& name);
    // One buffer in the first (0) or second (1) place; an empty name leaves the second place empty.
    void show(std::size_t place, const std::string& buffer);
    void reset_camera();
    // Of methods that compute AO only: rays could judge nothing else.
    void ask_truth(bool asked);
    // A motion of the camera that the newest frame was drawn with, or of the one that was asked for since.
    template <class Motion>
    void move_camera(const ViewFrame& newest, const Motion& motion) {
        wish.camera = motion(wish.camera ? *wish.camera : newest.camera);
        redraw();
    }
    // Notes a frame that has just been drawn.
    void note_times(const ViewFrame& frame);
};

// What can be shown of a method: its buffers, and with AO what rays say of it.
std::vector<std::string> buffers_to_show(const std::string& method);

// A buffer's picture in that frame; null where it is not there (yet).
const Picture* picture_in(const ViewFrame& frame, const std::string& buffer);

}  // namespace crevice
