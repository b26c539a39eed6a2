#pragma once

#include "prs/case.h"
#include "prs/input/document.h"
#include "prs/input/source.h"
#include "prs/study/study.h"

namespace prs::input {

/// A study and the document that it starts from, parsed once for all designs.
struct StudyInput {
  Source source;
  Node base;  ///< Without the study.
  Study study;
};

/// Reads the study of a source and checks it up front: the base case in full, and that each level
/// of each factor reads well in its place. What levels contradict is left to the designs. Throws
/// InputError, which names every error found, that of a level where its value stands.
StudyInput read_study_input(const Source& source);

/// The case of a design: the base document with more overrides. Throws InputError.
Case read_design(const StudyInput& input, const std::vector<std::string>& overrides);

}  // namespace prs::input
