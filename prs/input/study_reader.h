#pragma once

#include "prs/input/case_file.h"
#include "prs/input/document.h"
#include "prs/input/varied_input.h"

namespace prs::input {

/// A study and the document that it starts from, parsed once for all designs.
struct StudyInput {
  Source source;
  Node base;  ///< Document without the study, with every list whose entries are drawn one by one.
  Study study;
};

/// Reads the study of a source and checks it up front: the base case in full, and that each level of each factor, and
/// the ends of each distribution, can be read at their places. Contradictions between values are left to the designs.
/// Throws InputError, which names every error found, errors of values at their places.
StudyInput read_study_input(const Source& source);

/// `load_cases[3].converged` of `load_cases[push].converged`, where the load cases before `push`
/// have three points; other paths as they are.
std::string response_path(const Node& root, const std::vector<LoadCaseItem>& load_cases, const std::string& path);

/// Adds an error if an input that varies changes the number of load cases before that of a response.
void check_load_cases(const std::vector<std::string>& responses, const std::vector<SetPath>& inputs, const Node& root,
                      const std::vector<LoadCaseItem>& load_cases, ErrorList& errors);

/// A design's file, its values not yet checked against each other.
struct DesignFile {
  Node root;
  CaseFile file;
};

/// The base document with more overrides. Throws InputError.
DesignFile read_design_file(const StudyInput& input, const std::vector<std::string>& overrides);

/// The case of a design: the base document with more overrides. Throws InputError.
Case read_design(const StudyInput& input, const std::vector<std::string>& overrides);

/// An optimization and the document that it starts from.
struct OptimizeInput {
  StudyInput start;  ///< Input for the engine: its study is that of `optimization`.
  Optimization optimization;
  std::vector<std::string> asked_at;  ///< Places in the document at which each response is first named.
};

}  // namespace prs::input
