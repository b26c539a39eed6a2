#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "prs/input/units.h"

namespace prs::cli {

/// The command line is wrong. `what()` says what was found, what is allowed and how to fix it;
/// whoever reports it names the help of the command.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  template <class Arg, class... Args>
  UsageError(fmt::format_string<Arg, Args...> message, Arg&& arg, Args&&... args)
      : UsageError(fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...)) {}
};

/// Throws UsageError on an option of the command line: `--lead: MESSAGE`.
[[noreturn]] void fail_option(std::string_view option, std::string_view message);
template <class Arg, class... Args>
[[noreturn]] void fail_option(std::string_view option, fmt::format_string<Arg, Args...> message,
                              Arg&& arg, Args&&... args) {
  fail_option(option, fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
}

/// The value of an option [SI] within bounds that `expected` puts into words. A blank between
/// number and unit may be missing.
double quantity_option(std::string_view option, const std::string& text,
                       const input::Dimension& dimension, const input::Bounds& bounds,
                       std::string_view expected);

}  // namespace prs::cli
