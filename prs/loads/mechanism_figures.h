#pragma once

#include "prs/loads/load_pictures.h"

namespace prs {

/// A thread of a load case; its index counts over all rollers, from 0.
struct ChosenThread {
  const LoadCaseResult* load_case = nullptr;
  std::size_t thread = 0;

  const InterfaceLoads& at(Interface i) const { return (*load_case->threads)[i]; }
  bool has_ellipse(Interface i) const { return thread < at(i).semi_minor.size() && at(i).semi_minor[thread] > 0.0; }
};

/// The thread that the options name, else the most loaded; none without a load case for which `has` is true.
std::optional<ChosenThread> chosen_thread(const Result& result, const FigureOptions& options,
                                          bool (*has)(const LoadCaseResult&));
/// Drawings of the mechanism, made by name only.
Pictures drawings(const Case& c, const Result& result);
Pictures with_drawings(Pictures pictures, const Case& c, const Result& result);

}  // namespace prs
