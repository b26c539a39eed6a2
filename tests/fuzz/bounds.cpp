#include "tests/fuzz/bounds.h"

#include <algorithm>
#include <cmath>

#include "prs/input/case_file.h"
#include "prs/input/reader.h"

namespace prs::fuzz {
namespace {

double points(const input::LoadCaseItem& item) {
  const double orbit = item.spatial.orbit ? 2.0 * item.spatial.orbit->steps : 1.0;
  const double positions =
      item.travel ? 1.0 + std::abs(static_cast<double>(item.travel->turns)) * item.travel->steps : 1.0;
  return item.axial_force.steps.value_or(1) * orbit * positions;
}

/// Whether an integration takes many steps: for the vibrations of the stiffest and lightest parts.
bool vibrates_much(ResponseInput in) {
  const double stiffness = std::max({1e10, in.end_stops.upper ? in.end_stops.upper->stiffness : 0.0,
                                     in.end_stops.lower ? in.end_stops.lower->stiffness : 0.0});
  double fastest = std::sqrt(stiffness / std::max(in.load.mass, 1e-9));
  if (in.coupling) fastest = std::max(fastest, std::sqrt(in.coupling->stiffness / std::max(in.screw.inertia, 1e-12)));
  if (in.motor.current_loop) fastest = std::max(fastest, 1.0 / std::max(in.motor.current_loop->time_constant, 1e-12));
  bool signals = false;
  in.for_each_signal([&](const std::string&, const Signal& signal) { signals |= signal.many.size() > 8; });
  return signals || !(in.duration * fastest < 3e3) || in.duration / in.interval() > 2e3 ||
         (in.frequency_response && in.frequency_response->points > 200);
}

/// Whether a fit takes long: rows of curves times passes over them, and the time of a row.
bool fits_much(const input::FitItem& fit) {
  const auto slow = [](const input::FitCurveItem& item) {
    return item.response.find("heat_cycle") != std::string::npos;
  };
  return fit.parameters.size() > 3 || fit.curves.size() > 2 || fit.bands.size() > 2 || fit.starts > 2 ||
         std::ranges::any_of(fit.curves, slow) || std::ranges::any_of(fit.bands, slow);
}

}  // namespace

bool asks_for_much(const input::Source& source) try {
  input::ErrorList errors(source);
  const input::CaseFile file = input::read_case_file(input::read_document(source, errors), errors);
  const Case& c = file.values;
  const Mechanism& m = c.mechanism;
  const bool full = c.model.all_rollers();
  double loads = 0.0;
  for (const input::LoadCaseItem& item : file.load_cases) {
    if (points(item) > 8) return true;
    loads += points(item);
  }
  const int threads =
      m.contacts_per_roller <= 50 && m.rollers <= 40 ? m.contacts_per_roller * (full ? m.rollers : 1) : 1000;
  const bool influence = c.model.bodies->meshes;
  if (c.response && vibrates_much(*c.response)) return true;
  if (file.fit && fits_much(*file.fit)) return true;
  return threads > 100 || loads * (full ? 4 : 1) > 24 || influence || c.model.patch_points > 25;
} catch (const input::InputError&) {
  return false;
}

}  // namespace prs::fuzz
