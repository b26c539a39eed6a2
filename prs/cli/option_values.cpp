#include "prs/cli/option_values.h"

#include "prs/input/source.h"

namespace prs::cli {

void fail_option(std::string_view option, std::string_view message) {
  throw UsageError("{}: {}", option, message);
}

double quantity_option(std::string_view option, const std::string& text,
                       const input::Dimension& dimension, const input::Bounds& bounds,
                       std::string_view expected) {
  const input::ParsedQuantity parsed = input::parse_quantity(text, dimension);
  if (!parsed.value)
    fail_option(option, "got {}; expected {} with its unit, for example `{}`{}{}",
                input::shown(text), dimension.name, dimension.example,
                parsed.hint.empty() ? "" : "; ", parsed.hint);
  if (!bounds.contain(*parsed.value))
    fail_option(option, "got {}; expected {}", input::shown(text), expected);
  return *parsed.value;
}

}  // namespace prs::cli
