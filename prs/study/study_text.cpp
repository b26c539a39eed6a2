#include "prs/study/study_text.h"

#include <fmt/format.h>

#include "prs/quantities/response_title.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLongNumber = 14;
constexpr std::size_t kMaxTitle = 36;

}  // namespace

std::string response_text(const std::string& path) {
  const ResponseTitle title = response_title(path);
  return title.unit.empty() ? title.name : fmt::format("{} ({})", title.name, title.unit);
}

std::string level_text(const Level& level, const std::string& unit) {
  const std::string text = printable(level.text);
  if (!level.number || width(text) <= kLongNumber || text.starts_with('{')) return text;
  return fmt::format("{:.6g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
}

std::string factor_title(const Factor& factor) {
  const std::string text = shortened(printable(factor.label), kMaxTitle);
  return factor.label == factor.path ? text : capitalised(text);
}

std::string capitalised(std::string text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  if (text.size() > 1 && is_small(text[0]) && is_small(text[1]))
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace prs
