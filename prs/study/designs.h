#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "prs/model/study.h"

namespace prs {

/// Number of designs, the base case included.
std::size_t design_count(const Study& study);

/// Values of design k, one per factor; the base case is the first. A pure function of the study, so
/// that designs can be run in any order, in parts and again.
std::vector<Draw> draws(const Study& study, std::size_t k);
/// The same into memory that is kept.
void set_draws(const Study& study, std::size_t k, std::vector<Draw>& draws);

/// The settings of design k, with the values as texts.
Design design(const Study& study, std::size_t k);
Design design(const Study& study, const std::vector<Draw>& draws);

/// Whether every value of a design is that of the file.
bool is_base(const Study& study, const Design& design);

/// The settings as `--set` takes them: `mechanism.rollers=9`.
std::vector<std::string> overrides(const Study& study, const Design& design);
std::vector<std::string> overrides(const Study& study, const std::vector<Draw>& draws);

}  // namespace prs
