#include "chapters/frame/demo_view.h"

#include <algorithm>

namespace crevice {

Picture demo_view(const Frame& frame, bool inset) {
    Picture view = lit_picture(frame.lit);
    if (!inset) return view;
    const Image<float> open({1, 1}, 1.0f);
    const Image<float>& map = !frame.ao_blurred.empty() ? frame.ao_blurred
                              : !frame.ao_raw.empty()   ? frame.ao_raw
                                                        : open;
    const Picture ao = ao_picture(map, PictureValues::left);
    const Size quad{std::max(view.size.width / 2, 1), std::max(view.size.height / 2, 1)};
    const int left = view.size.width - quad.width, top = view.size.height - quad.height;
    for (int y = 0; y < quad.height; ++y) {
        for (int x = 0; x < quad.width; ++x) {
            const int column = x * ao.size.width / quad.width, row = y * ao.size.height / quad.height;
            const auto from = static_cast<std::ptrdiff_t>(ao.channels) * (row * ao.size.width + column);
            const auto to = std::ptrdiff_t{3} * ((top + y) * view.size.width + left + x);
            for (int c = 0; c < 3; ++c)
                view.pixels[static_cast<std::size_t>(to + c)] =
                    ao.pixels[static_cast<std::size_t>(from + (ao.channels == 3 ? c : 0))];
        }
    }
    view.mapping += "; lower right: AO, " + ao.mapping;
    return view;
}

}  // namespace crevice
