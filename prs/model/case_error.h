#pragma once

#include <stdexcept>
#include <string>

namespace prs {

/// A case that reads well and still describes no mechanism: `path` names the input that is wrong,
/// what() says what was expected and how to fix it. The reader of the case adds file and line.
class CaseError : public std::runtime_error {
 public:
  CaseError(std::string path, const std::string& message)
      : std::runtime_error(message), path_(std::move(path)) {}

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace prs
