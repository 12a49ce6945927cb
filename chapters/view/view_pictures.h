// The picture, or two, beside the panel: where they stand in the window, what lies over them, and which pixel is pointed at.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "chapters/view/view_state.h"

namespace crevice {

// A place in the window, pixels.
struct ViewBox {
    float x = 0, y = 0, width = 0, height = 0;
};

// The largest box of a picture's shape in the middle of another one.
ViewBox fitted(const ViewBox& room, Size picture);

class ViewPictures {
 public:
    ViewPictures() = default;
    ~ViewPictures();
    ViewPictures(const ViewPictures&) = delete;
    ViewPictures& operator=(const ViewPictures&) = delete;

    void upload(const ViewFrame& frame);
    // Between ImGui's NewFrame and Render, behind its windows.
    void draw(const ViewState& state, const ViewFrame& frame);
    // Of the picture drawn last; none where there is no picture.
    std::optional<std::pair<int, int>> pixel_at(float x, float y) const;

 private:
    struct Shown {
        std::string buffer;
        ViewBox box;
        float from = 0, to = 1;  // the part that is seen, of its width
    };

    std::vector<Shown> places(const ViewState& state) const;
    void clear();

    Size size_;                                 // of the frame, pixels
    std::map<std::string, unsigned> textures_;  // names that OpenGL gave them
    std::vector<Shown> shown_;
};

}  // namespace crevice
