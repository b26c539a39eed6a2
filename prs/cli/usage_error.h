#pragma once

#include <stdexcept>

namespace prs::cli {

/// The command line is wrong. `what()` says what was found, what is allowed and how to fix it;
/// whoever reports it names the help of the command.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace prs::cli
