#include "prs/record/analysis.h"

namespace prs {

void put_first(const std::vector<Warning>& values, std::vector<Warning>& warnings) {
  for (const Warning& value : values)
    std::erase_if(warnings, [&](const Warning& w) { return w.path == value.path; });
  warnings.insert(warnings.begin(), values.begin(), values.end());
}

std::vector<std::string> as_notes(const std::vector<Warning>& warnings) {
  std::vector<std::string> notes = sentences(warnings);
  for (std::string& note : notes) note.insert(0, "warning: ");
  return notes;
}

}  // namespace prs
