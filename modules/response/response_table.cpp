#include "modules/response/response_table.h"

#include "prs/loads/case_table.h"
#include "prs/record/table_layout.h"

namespace prs {
namespace {

std::string line(const std::string& what, const std::string& value) { return hanging("  " + what, 34, value); }

std::string largest_text(const LargestForce& l) {
  std::string text = fmt::format("{} at {:.6g} ms", fixed_with_unit(l.force, "kN", 3), 1e3 * l.time);
  if (l.peak_pressure) text += ", " + fixed_with_unit(l.peak_pressure, "GPa", 3) + " peak pressure";
  return text;
}

std::string impact_text(const DriveImpact& i) {
  return fmt::format("{:.6g} ms, {}, {:.3g} J, up to {}", 1e3 * i.time, significant_with_unit(i.speed, "mm/s"),
                     i.energy, fixed_with_unit(i.force.value, "kN", 3));
}

/// Force, as a share of the largest, below which it is rounding or a touch.
constexpr double kTouch = 1e-3;

std::string impacts_text(const DriveResult& run) {
  const double least = kTouch * run.largest_force;
  std::vector<DriveImpact> all;
  std::ranges::copy_if(run.impacts, std::back_inserter(all), [&](auto& i) { return i.force.value >= least; });
  const std::size_t touches = run.impacts.size() - all.size();
  std::string text =
      line("impacts",
           (all.empty() ? std::string("none") : fmt::format("{}", all.size())) +
               (touches > 0 ? fmt::format(", and {} below {}", touches, significant_with_unit(least, "N", 3)) : ""));
  if (all.empty()) return text;
  const auto fastest = std::ranges::max_element(all, {}, &DriveImpact::speed);
  const auto hardest = std::ranges::max_element(all, {}, [](const DriveImpact& i) { return i.force.value; });
  text += line("  fastest", impact_text(*fastest));
  if (hardest != fastest) text += line("  hardest", impact_text(*hardest));
  return text;
}

std::string energies_text(const ResponseResult& r) {
  const DriveResult& d = r.run;
  std::string text = line("energy of motor, of load", fmt::format("{:.5g} J, {:.5g} J", d.motor, d.load)) +
                     line("stored at start, at end", fmt::format("{:.5g} J, {:.5g} J", d.stored_start, d.stored_end));
  std::string parts;
  for (const auto& [what, energy] : kEnergyLosses)
    if (d.*energy != 0.0) parts += fmt::format("{}{} {:.4g} J", parts.empty() ? "" : ", ", what, d.*energy);
  text += line("lost", parts.empty() ? "nothing" : parts);
  return text + line("residual", fmt::format("{:.1e} J of {:.4g} J turned over", r.residual(), d.turnover));
}

std::string settling_text(const SettlingResult& s, double band) {
  const std::string where = fixed_with_unit(s.final_position, "mm", 4);
  if (s.time) return fmt::format("{:.5g} ms, at {}", 1e3 * *s.time, where);
  return fmt::format("not settled: ends at {}, {} off its reference, band {}", where,
                     fixed_with_unit(std::abs(s.final_position - s.reference.value_or(0.0)), "µm", 1),
                     fixed_with_unit(band, "µm", 1));
}

std::string curves_text(const ResponseResult& r) {
  std::string text = fmt::format("to {}", fixed_with_unit(r.curves_force, "kN", 1));
  if (r.curves_speed > 0.0) text += fmt::format(", {:.4g} rpm", r.curves_speed * "rpm"_per_si);
  if (!r.load_case.empty()) text += fmt::format(", load case `{}`", r.load_case);
  return text;
}

std::string motion_text(const DriveResult& d) {
  const auto [least, most] = std::ranges::minmax(d.x);
  double speed = 0.0;
  for (const double v : d.v) speed = std::max(speed, std::abs(v));
  return fmt::format("{} to {}, ends at {}; up to {}, {:.4g} rpm of the screw", fixed_with_unit(least, "mm", 3),
                     fixed_with_unit(most, "mm", 3), fixed_with_unit(d.x.back(), "mm", 3),
                     significant_with_unit(speed, "mm/s"), d.largest_speed * "rpm"_per_si);
}

}  // namespace

std::string response_table(const ResponseResult& r) {
  std::string text = fmt::format("Screw in its drive, {:.6g} s, {} samples\n", r.input.duration, r.run.time.size());
  if (!r.converged())
    text += fmt::format("NOT CONVERGED ({}): stopped at {:.6g} s\n", name(r.run.status), r.run.stopped_at);
  text += line("curves", curves_text(r));
  if (!r.run.x.empty()) text += line("position", motion_text(r.run));
  for (const Direction d : kDirections)
    if (r.largest[d] && r.largest[d]->force >= kTouch * r.run.largest_force)
      text += line(fmt::format("largest force in {}", name(d)), largest_text(*r.largest[d]));
  text += line("motor torque", fmt::format("{} at the most, {} rms", fixed_with_unit(r.run.torque.value, "N m", 3),
                                           fixed_with_unit(r.rms_torque(), "N m", 3)));
  if (r.has_stops()) text += line("largest force of an end stop", fixed_with_unit(r.run.stop.value, "kN", 3));
  if (r.can_open) text += impacts_text(r.run);
  text += line("lost motion", fixed_with_unit(r.run.lost_motion, "µm", 3));
  if (const auto& f = r.following_error)
    text += line("following error", f->of_position
                                        ? fmt::format("{} at {:.6g} ms, {} rms", fixed_with_unit(f->largest, "µm", 2),
                                                      1e3 * f->time, fixed_with_unit(f->rms, "µm", 2))
                                        : fmt::format("{:.4g} rpm at {:.6g} ms, {:.4g} rpm rms",
                                                      f->largest * "rpm"_per_si, 1e3 * f->time, f->rms * "rpm"_per_si));
  text += energies_text(r);
  if (r.settling) text += line("settled after", settling_text(*r.settling, r.input.settling->band));
  if (r.frequency_response) {
    text += line("tangent stiffness", fixed_with_unit(r.frequency_response->tangent_stiffness, "N/µm", 1));
    for (const Resonance& resonance : r.frequency_response->resonances)
      text +=
          line("resonance", fmt::format("{:.5g} Hz, damping {:.3g} %", resonance.frequency, 100.0 * resonance.damping));
  }
  return text + warning_section(r.warnings);
}

}  // namespace prs
