// The way from ray-cast truth to a frame, step by step, as a drawing, a table and pictures: for chapter 21.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/notebook.h"
#include "ssao/judge/error_parts.h"

namespace crevice {

// The steps one below the other: what each adds to the squared error, or takes away.
std::string error_steps(const ErrorParts& parts, const std::string& title);

// A row a step: name, bias, RMSE alone, share of the squared error in millionths; and the whole.
std::vector<std::vector<std::string>> part_rows(const ErrorParts& parts);

// Whether biases and shares sum to those of the whole.
bool parts_add_up(const ErrorParts& parts);

// Of every step whose picture would not be white.
std::vector<Notebook::Named> part_pictures(const ErrorParts& parts);

}  // namespace crevice
