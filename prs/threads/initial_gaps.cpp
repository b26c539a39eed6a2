#include "prs/threads/initial_gaps.h"

#include <algorithm>

#include "prs/threads/threads.h"

namespace prs {
namespace {

double pitch_error(const PitchError& e, int k, int contacts) {
  double error = contacts > 1 ? e.linear * k / (contacts - 1) : 0.0;
  if (const auto& wave = e.periodic)
    error += wave->amplitude * std::sin(2.0 * std::numbers::pi * k / wave->period + wave->phase);
  if (!e.list.empty()) error += e.list[static_cast<std::size_t>(k)];
  return error;
}

/// Drop of the roller's pitch radius at a contact [m].
double roller_drop(const Deviations& d, int k, int contacts) {
  const double middle = 0.5 * (contacts - 1);
  double drop = contacts > 1 ? d.crowning * std::pow((k - middle) / middle, 2) : 0.0;
  if (d.end_relief) {
    const int from_end = std::min(k, contacts - 1 - k);
    drop += d.end_relief->drop *
            std::max(0.0, 1.0 - static_cast<double>(from_end) / d.end_relief->threads);
  }
  return drop;
}

}  // namespace

ThreadOffsets thread_offsets(const Mechanism& m, const Deviations& d, const Materials& materials,
                             Part part) {
  const int contacts = m.contacts_per_roller;
  const double nominal = axial_pitch(m);
  const double rise = d.temperature ? (*d.temperature)[part] - d.reference_temperature : 0.0;
  const double strain = materials[part].thermal_expansion.value_or(0.0) * rise;
  const double lag = axial_pitches(m)[part] - nominal + strain * nominal;
  const double radius = 0.5 * m.pitch_diameter[part].value();
  ThreadOffsets o;
  for (int k = 0; k < contacts; ++k) {
    o.axial.push_back(k * lag + pitch_error(d.pitch_error[part], k, contacts));
    o.radial.push_back(strain * radius);
    if (part == Part::roller)
      o.radial.back() += 0.5 * d.roller_diameter - roller_drop(d, k, contacts);
  }
  return o;
}

std::vector<double> gaps_between(const ThreadOffsets& body, const ThreadOffsets& roller,
                                 Interface i, double normal_angle, Direction direction) {
  // The screw pushes the roller, the roller the nut; a nut that grows makes way.
  const double ahead = i == Interface::screw ? 1.0 : -1.0;
  std::vector<double> gaps;
  for (std::size_t k = 0; k < body.axial.size(); ++k)
    gaps.push_back(-sense(direction) * std::cos(normal_angle) * ahead *
                       (body.axial[k] - roller.axial[k]) -
                   std::sin(normal_angle) * (roller.radial[k] + ahead * body.radial[k]));
  return gaps;
}

bool deviates(const Mechanism& m, const Deviations& d) {
  if (d.roller_diameter != 0.0 || d.crowning != 0.0 || d.end_relief || d.temperature) return true;
  for (const Part part : kParts) {
    const PitchError& e = d.pitch_error[part];
    if (m.pitch[part] || e.linear != 0.0 || e.periodic || !e.list.empty()) return true;
  }
  return false;
}

PerInterface<std::vector<double>> initial_gaps(const Mechanism& mechanism,
                                               const Deviations& deviations,
                                               const Materials& materials,
                                               const PerInterface<double>& normal_angle,
                                               Direction direction) {
  const ThreadOffsets roller = thread_offsets(mechanism, deviations, materials, Part::roller);
  PerInterface<std::vector<double>> gaps;
  for (const Interface i : kInterfaces) {
    gaps[i] = gaps_between(thread_offsets(mechanism, deviations, materials, body_of(i)), roller, i,
                           normal_angle[i], direction);
    const double closest = *std::min_element(gaps[i].begin(), gaps[i].end());
    for (double& gap : gaps[i]) gap -= closest;
  }
  return gaps;
}

}  // namespace prs
