#include "prs/study/study_text.h"

#include <fmt/format.h>

namespace prs {
namespace {

constexpr std::size_t kLongNumber = 14;
constexpr std::size_t kMaxTitle = 36;

}  // namespace

std::string level_text(const Level& level, const std::string& unit) {
  const std::string text = printable(level.text);
  if (!level.number || width(text) <= kLongNumber || text.starts_with('{')) return text;
  return fmt::format("{:.6g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
}

std::string factor_title(const Factor& factor) {
  const std::string text = shortened(printable(factor.label), kMaxTitle);
  return factor.label == factor.path ? text : capitalised(text);
}

}  // namespace prs
