// The rows of the table of methods, each a function of its own; ao_methods.cpp puts them in order.
#pragma once

#include "ssao/methods/method.h"

namespace crevice {

// tutorial_rows.cpp
Method xjun_row();
Method luna_row();
Method none_row();
// hemisphere_rows.cpp
Method hemisphere_row();
Method unity_row();
// obscurance_rows.cpp
Method alchemy_row();
Method sao_row();
Method msvo_row();
// screen_ray_rows.cpp
Method hbao_row();
Method hbao_plus_row();
// slice_rows.cpp
Method gtao_row();
Method vbao_row();
// ray_rows.cpp
Method ray_cast_row();
Method vertex_bake_row();
Method crevice_row();

}  // namespace crevice
