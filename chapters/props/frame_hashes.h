// Hashes of frames, those on record among them, and every form of the kernels that this machine can run: for chapter 24.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/frame.h"

namespace crevice {

// A frame of X_Jun's method with its defaults.
FrameRequest xjun_request(Size size);

// Of one buffer: normal, view_depth, ndc_depth, ao_raw or ao_blurred; and of all of them and the lit picture, in a row.
std::string hash_named(const Frame& frame, const std::string& buffer);
std::string hashes_of(const Frame& frame);
// The hash on record of a buffer of the scene `columns`, 160x90; "none" where there is none.
std::string recorded_hash(const std::string& wanted);

struct KernelForm {
    std::string name;
    Run run;
};
std::vector<KernelForm> forms_of_this_machine();

}  // namespace crevice
