// The line for a terminal that draws the same bits as a frame of the lab.
#pragma once

#include <string>

#include "chapters/lab/frame_reply.h"

namespace crevice {

// "crevice render SCENE --size WxH --ao METHOD --eye=X,Y,Z ... --param name=value": camera flags with an equals sign,
// because a number below 0 would be taken for a flag.
std::string render_command(const LabWords& words);

// Sets a parameter, or sets it anew.
void set_param(LabWords& words, const std::string& name, const std::string& word);

}  // namespace crevice
