// FLIP: how different two pictures look when one is flipped into the other in the same place.
// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference
//         Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2) (HPG); all
//         constants are the paper's, the filters' extents those of its authors' tool.
// In:     two pictures of one size, grey or in colour: display values in [0,1], encoded with the sRGB curve;
//         beyond the border a picture goes on as its outermost pixels
// Out:    one number a pixel: 0 no difference is seen, 1 the largest the measure knows
// Reach:  ceil(0.135 ppd) pixels for what is seen of a pixel, ceil(0.123 ppd) for edges and points: 10 and 9
// Grey:   a grey pixel has no chroma (Cx = Cz = 0) before the filters and none after them, so the chroma
//         filters, the Hunt adjustment and the chroma part of the distance give nothing; they are left out.
//         tests/ssao/judge/flip_test.cpp holds both forms against the whole computation, nothing separated.
// Cost:   about 350 multiply-adds and 4 powers a pixel, in double; in colour twice as much.
// Differs from the rest of the lab: libm's powers, rounded to float. A score to report, not a golden.
#pragma once

#include "rasterizer/base/image.h"

namespace crevice {

// Pixels per degree of the visual angle: of a picture width_m wide that is width_px pixels wide, seen from
// distance_m.
double pixels_per_degree(double distance_m, double width_m, double width_px);

// The paper's observer, and its tool's default: 0.7 m before a monitor 0.7 m and 3840 pixels wide.
inline constexpr double kPixelsPerDegree = 67.0206432765823;

struct Flip {
    Image<float> map;  // [0,1]
    double mean = 0;   // of all pixels
    double p99 = 0;    // percentile 99 of all pixels
};

// `ppd` is pixels per degree, in [1, 1000]. Values beyond [0,1] are clamped. Throws InputError for a NaN,
// naming the pixel, and for images of unlike or no size; UsageError for a ppd out of range.
Flip flip(const Image<float>& a, const Image<float>& b, double ppd = kPixelsPerDegree);
Flip flip(const Image3& a, const Image3& b, double ppd = kPixelsPerDegree);

// What a monitor is sent when accessibility is shown: the byte of ao_picture(), floor(255 v + 1/2) of v
// clamped to [0,1], divided by 255. Accessibility is linear and the byte is its value: no curve is applied,
// and the monitor takes the byte for an sRGB one. This is the picture people look at, so it is the one FLIP
// is given. NaN stays NaN.
Image<float> displayed(const Image<float>& accessibility);

}  // namespace crevice
