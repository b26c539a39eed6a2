#include "tests/fuzz/bounds.h"

#include <algorithm>

#include "prs/input/case_file.h"
#include "prs/input/reader.h"

namespace prs::fuzz {
namespace {

int points(const input::LoadCaseItem& item) {
  const int orbit = item.spatial.orbit ? 2 * item.spatial.orbit->steps : 1;
  return item.axial_force.steps.value_or(1) * orbit;
}

}  // namespace

bool asks_for_much(const input::Source& source) try {
  input::ErrorList errors(source);
  const input::CaseFile file = input::read_case_file(input::read_document(source, errors), errors);
  const Case& c = file.values;
  const Mechanism& m = c.mechanism;
  const bool full = c.model.mechanism == ModelOptions::Mechanism::full;
  int loads = 0;
  for (const input::LoadCaseItem& item : file.load_cases) {
    if (points(item) > 8) return true;
    loads += points(item);
  }
  const int threads =
      m.contacts_per_roller <= 50 && m.rollers <= 40 ? m.contacts_per_roller * (full ? m.rollers : 1) : 1000;
  const bool influence = c.model.bodies == ModelOptions::Bodies::influence;
  return threads > 100 || loads * (full ? 4 : 1) > 24 || influence || c.model.patch_points > 25;
} catch (const input::InputError&) {
  return false;
}

}  // namespace prs::fuzz
