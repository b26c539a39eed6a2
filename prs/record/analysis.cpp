#include "prs/record/analysis.h"

namespace prs {

void put_first(const std::vector<std::string>& values, std::vector<std::string>& warnings) {
  for (const std::string& value : values) {
    const std::string path = value.substr(0, value.find(": ") + 2);
    std::erase_if(warnings, [&](const std::string& w) { return w.starts_with(path); });
  }
  warnings.insert(warnings.begin(), values.begin(), values.end());
}

std::vector<std::string> as_notes(const std::vector<std::string>& warnings) {
  std::vector<std::string> notes;
  for (const std::string& text : warnings) notes.push_back("warning: " + text);
  return notes;
}

}  // namespace prs
