#pragma once

#include "prs/bodies/meshed.h"
#include "prs/bodies/one_dimensional.h"

namespace prs {

/// All models of the bodies with their solvers: reader, schema, `compare` and analyses know them from here.
inline constexpr struct {
  const BodyModel& model;
  const BodySolver& solver;
} kBodyModels[] = {
    {kBars, kOneDimensional},
    {kRefined, kOneDimensional},
    {kInfluence, kMeshed},
};

/// Their names, `a | b | c`.
inline constexpr struct BodyWords {
  char text[128]{};
  constexpr BodyWords() {
    char* end = text;
    for (const auto& row : kBodyModels) {
      if (end != text)
        for (const char c : std::string_view(" | ")) *end++ = c;
      for (const char c : row.model.name) *end++ = c;
    }
  }
} kBodyWords;

}  // namespace prs
