// Which settings a study of error against run time tries.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/frame_settings.h"

namespace crevice {

// One way to run a method, in parameters that methods have in common; everything else as the method's defaults.
struct ErrorSetting {
    int samples = 14;
    float ao_scale = 0.5f;
    int blur_iterations = 4;
    bool half_floats = false;  // normals, view depth and AO map as 16-bit floats, rounded toward zero
};

// "14 samples, half size, 4 blurs, float16"
std::string setting_name(const ErrorSetting& setting);

// The method's defaults (lengths times length_unit) with these settings and a seed, as far as the method has
// parameters of these names.
FrameSettings settings_of(const Method& method, const ErrorSetting& setting, float length_unit,
                          std::uint32_t seed);

// The method as its tutorial runs it: all samples, half size, its own number of blurs, float32.
ErrorSetting default_setting(const Method& method);

struct ErrorPlan {
    Size size{640, 360};
    std::vector<ErrorSetting> settings;
    std::vector<int> cast_rays;    // per-pixel ray casting
    std::vector<int> vertex_rays;  // vertex bakes
    int seeds = 8;                 // images of each setting, whose errors are averaged
    int rounds = 15;               // timings of each setting, in turns
    int slow_rounds = 5;           // of settings that take more than kSlow_ms
    int reference_rays = 1024, limit_seeds = 512;
};
inline constexpr double kSlow_ms = 100;

// Each of the method's samples_to_try at half and full size, 0 to 4 blurs, float32 and float16: 120 settings of the
// tutorials' methods; rays 1, 2, 4 ... 256. Some minutes.
ErrorPlan full_error_plan(const Method& method);
// A part of it at 320x180, the fewest, the middle and the most samples: under a minute.
ErrorPlan quick_error_plan(const Method& method);

}  // namespace crevice
