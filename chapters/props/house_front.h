// The house of X_Jun's columns from close by: niches, bars, steps and a roof, on which the chapters of Part II compare
// their methods.
#pragma once

#include "chapters/props/judged_view.h"

namespace crevice {

inline JudgedView house_front(const Notebook& book, const std::string& own, Size size) {
    JudgedView view(book, "columns", own, size);
    if (view.scene().name == "columns") {
        Camera camera = view.camera();
        camera.eye = {-2.4, -1.1, -5.2};
        camera.target = {-0.3, -2, -1.5};
        view.look(camera, "--eye -2.4,-1.1,-5.2 --target -0.3,-2,-1.5");
    }
    return view;
}

// A texel of the house's door, close to the jamb, which stands out before it.
inline Texel beside_the_jamb(Size ao_map) {
    constexpr float kAcross = 0.53f, kDown = 0.514f;
    return {static_cast<int>(kAcross * static_cast<float>(ao_map.width)),
            static_cast<int>(kDown * static_cast<float>(ao_map.height))};
}

}  // namespace crevice
