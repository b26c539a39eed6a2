#include "prs/model/warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// The number with `digits` significant digits, or with all digits before the point if these are more.
std::string number(double shown, int digits) {
  if (shown == 0.0 || std::abs(shown) < 1e-4) return fmt::format("{:.{}g}", shown, digits);
  const int before = 1 + static_cast<int>(std::floor(std::log10(std::abs(shown))));
  return fmt::format("{:.{}g}", shown, std::max(digits, before));
}

void put(std::string& text, std::string_view name, const std::string& number, const ShownUnit& unit) {
  if (const std::size_t at = text.find(name); at != text.npos)
    text.replace(at, name.size(), unit.text.empty() ? number : fmt::format("{{{} {}}}", number, unit.text));
}

}  // namespace

std::string marked_sentence(const Warning& w) {
  constexpr int kFewest = 3, kMost = 9;
  const auto shown = [&](const std::optional<double>& si, int digits) {
    return si ? number(*si * w.unit.factor, digits) : std::string();
  };
  int digits = kFewest;
  while (digits < kMost && w.value && w.limit && w.value != w.limit && shown(w.value, digits) == shown(w.limit, digits))
    ++digits;
  std::string text = w.what;
  put(text, "{value}", shown(w.value, digits), w.unit);
  put(text, "{limit}", shown(w.limit, digits), w.unit);
  if (!w.path.empty()) text.insert(0, w.path + ": ");
  return w.fix.empty() ? text : text.append("; ").append(w.fix);
}

std::string sentence(const Warning& warning) { return with_quantities(marked_sentence(warning), std::identity()); }

std::vector<Warning> selected(std::span<const Warning> warnings, bool assumptions) {
  std::vector<Warning> found;
  std::ranges::copy_if(warnings, std::back_inserter(found),
                       [&](const Warning& w) { return w.is_assumption == assumptions; });
  const auto effect = [](const Warning& w) { return w.unit == "%"_unit ? w.value.value_or(0.0) : 0.0; };
  if (assumptions) std::ranges::stable_sort(found, std::greater{}, effect);
  return found;
}

std::vector<std::string> sentences(std::span<const Warning> warnings) {
  std::vector<std::string> texts;
  std::ranges::transform(warnings, std::back_inserter(texts), sentence);
  return texts;
}

bool is_worse(const Warning& warning, const Warning& than) {
  if (!warning.value || !than.value) return false;
  const bool by_limit = warning.limit && than.limit && *warning.limit != 0.0 && *than.limit != 0.0;
  const auto share = [&](const Warning& w) { return by_limit ? *w.value / *w.limit : *w.value; };
  return warning.worse == Warning::Worse::larger ? share(warning) > share(than) : share(warning) < share(than);
}

}  // namespace prs
