// The order in which positions are multiplied, as a parameter: both drawings have one.
#pragma once

#include "rasterizer/draw/vertex_transform.h"
#include "ssao/methods/parameter.h"

namespace crevice {

template <class S>
Parameter<S> position_order(const char* name, const char* effect, PositionOrder S::*member) {
    return choice<S, PositionOrder>(name, effect, member,
                                    {{"relative", PositionOrder::relative},
                                     {"premultiplied", PositionOrder::premultiplied},
                                     {"view_first", PositionOrder::view_first}});
}

}  // namespace crevice
