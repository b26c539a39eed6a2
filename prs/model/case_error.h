#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "prs/model/problems.h"

namespace prs {

/// A case that reads well and still describes no mechanism. what() is the message of the problem;
/// the reader of the case adds file and line.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(Problem problem)
      : std::runtime_error(problem.message), problem_(std::move(problem)) {}
  CaseError(std::string path, std::string message)
      : CaseError(Problem{std::move(path), std::move(message)}) {}

  const Problem& problem() const { return problem_; }
  const std::string& path() const { return problem_.path; }

 private:
  Problem problem_;
};

}  // namespace prs
