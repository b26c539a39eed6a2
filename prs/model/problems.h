#pragma once

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prs {

/// Error in an input: the one type for such messages, from the model, from an impossible result, or from the reader.
struct Problem {
  std::string path;     ///< Key path in the input: `structure.nut.length`; may be empty.
  std::string message;  ///< `got VALUE; expected WHAT; how to fix it`

  std::string text() const { return path.empty() ? message : path + ": " + message; }
  bool operator==(const Problem&) const = default;

  /// Whether adding the block at the path fixes the problem.
  bool is_missing() const { return message.starts_with(kMissing); }

  static constexpr std::string_view kMissing = "missing; ";
};

/// Collects problems, one for each path: the first found is the one to fix.
class Problems {
 public:
  void add(std::string path, std::string message) {
    if (paths_.insert(path).second) found_.push_back({std::move(path), std::move(message)});
  }
  template <class Arg, class... Args>
  void add(std::string path, fmt::format_string<Arg, Args...> message, Arg&& arg, Args&&... args) {
    add(std::move(path), fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
  }
  /// Adds a block that a command needs and the case lacks.
  void add_missing(std::string path, std::string_view what, std::string_view example) {
    std::string message =
        fmt::format("{}expected {}; add `{}: {}`, for example", Problem::kMissing, what, path, example);
    add(std::move(path), std::move(message));
  }
  std::vector<Problem> take() && { return std::move(found_); }

 private:
  std::set<std::string> paths_;
  std::vector<Problem> found_;
};

/// A case that is valid text but describes no mechanism. what() is the message of the problem; the reader of the case
/// adds file and line.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(Problem problem) : std::runtime_error(problem.message), problem_(std::move(problem)) {}
  CaseError(std::string path, std::string message) : CaseError(Problem{std::move(path), std::move(message)}) {}

  const Problem& problem() const { return problem_; }
  const std::string& path() const { return problem_.path; }

 private:
  Problem problem_;
};

}  // namespace prs
