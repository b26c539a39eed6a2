#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prs {

/// What is wrong with an input: the one type that carries such a message, from the model, from a
/// result that cannot be, or from the reader.
struct Problem {
  std::string path;     ///< Key path in the input: `structure.nut.length`; empty where none is.
  std::string message;  ///< `got VALUE; expected WHAT; how to fix it`

  std::string text() const { return path.empty() ? message : path + ": " + message; }
  bool operator==(const Problem&) const = default;

  /// Whether it is fixed by adding what stands at the path.
  bool is_missing() const { return message.starts_with(kMissing); }

  static constexpr std::string_view kMissing = "missing; ";
};

/// Collects problems, one for each path: the first found is the one to fix.
class Problems {
 public:
  void add(std::string path, std::string message) {
    if (paths_.insert(path).second) found_.push_back({std::move(path), std::move(message)});
  }
  /// A block that a command needs and the case lacks.
  void add_missing(std::string path, std::string_view what, std::string_view example) {
    std::string message = fmt::format("{}expected {}; add `{}: {}`, for example", Problem::kMissing,
                                      what, path, example);
    add(std::move(path), std::move(message));
  }
  std::vector<Problem> take() && { return std::move(found_); }

 private:
  std::set<std::string> paths_;
  std::vector<Problem> found_;
};

}  // namespace prs
