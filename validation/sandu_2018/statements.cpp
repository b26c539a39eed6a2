#include "validation/sandu_2018/statements.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_pictures.h"

namespace prs::sandu_2018 {
namespace {

using Values = std::vector<double>;
using Results = std::vector<SlipResult>;

// Ranges of the text or, if it gives none, around the reference.
const Values kDiameters{20, 25, 30, 35, 40, 45, 50};         // 2 r_S [mm]
const Values kLeads{5, 7.5, 10, 12.5, 15, 20};               // [mm]
const Values kFlankAngles{40, 42.5, 45, 47.5, 50};           // [deg]
const Values kRollerProfiles{4, 5, 6, 7, 8, 10};             // r_BR, convex [mm]
const Values kScrewProfiles{-20, -50, 50, 20};               // r_BS, convex > 0 [mm]
const Values kRollers{5, 7, 9, 11};                          //
const Values kClearances{0.1, 0.15, 0.2, 0.25};              // e_b, half the play [mm]
const Values kStresses{4, 6, 8, 10, 12, 14, 16};             // tau_0 [MPa]
const Values kViscosities{28.4, 50, 100, 166.5, 266};        // eta_0 [mPa s], table 2.2
const Values kSpeeds{50, 100, 200, 300, 400, 600, 800};      // [rpm]
const Values kForces{5, 10, 20, 35, 50, 70};                 // F_N [kN]
const Values kNutTorques{0, 0.5, 1, 2, 4};                   // C_P/N [N m]
const Values kPressureAngles{30, 35, 40, 42.5, 45, 50, 60};  // alpha_n [deg]

// Varied inputs.
void diameter(Case& c, double mm) { c.mechanism.pitch_diameter.screw = mm * 1e-3; }
void lead(Case& c, double mm) { c.mechanism.lead = mm * 1e-3; }
void flank_angle(Case& c, double deg) {
  const double angle = deg / "deg"_per_si;
  c.mechanism.flank_angle = {angle, angle, angle};
}
void roller_profile(Case& c, double mm) { c.mechanism.profile.roller.radius = mm * 1e-3; }
void screw_profile(Case& c, double mm) {
  c.mechanism.profile.screw = {mm > 0.0 ? Profile::Shape::convex : Profile::Shape::concave, std::abs(mm) * 1e-3};
}
void rollers(Case& c, double n) { c.mechanism.rollers = static_cast<int>(n); }
void clearance(Case& c, double mm) { c.carrier.bearing->radial_clearance = mm * 1e-3; }
void eyring_stress(Case& c, double mpa) { c.lubricant->eyring_stress = mpa * 1e6; }
void viscosity(Case& c, double mpas) { c.lubricant->viscosity = mpas * 1e-3; }
void speed(Case& c, double rpm) { c.operation->speed = rpm / "rpm"_per_si; }
void force(Case& c, double kn) { c.load_cases.front().axial_force = kn * 1e3; }
void nut_torque(Case& c, double nm) { c.carrier.nut_torque = nm; }
void slip_ratio(Case& c, double ratio) { c.operation->slip_ratio = ratio; }
void patch_points(Case& c, double n) { c.model.patch_points = static_cast<int>(n); }

Case inverted(Case c) {
  c.mechanism.type = Mechanism::Type::inverted;
  return c;
}
Case with_coulomb(Case c, double coefficient) {
  c.friction = friction_by(contact::Coulomb{at_both(coefficient)});
  return c;
}
Case at(Case c, void (*change)(Case&, double), double value) {
  change(c, value);
  return c;
}
/// Mechanism under load without friction, as at rest.
Case without_friction(Case c) {
  c.carrier.bearing.reset();
  return with_coulomb(c, 0.0);
}

bool coulomb(const Case& c) { return c.friction->kind == contact::kind_of<contact::Coulomb>; }

Values of(const Results& results, const std::function<double(const SlipResult&)>& quantity) {
  Values values;
  for (const SlipResult& r : results) values.push_back(quantity(r));
  return values;
}
Values swept(const Case& c, const Values& values, const std::function<void(Case&, double)>& change,
             const std::function<double(const SlipResult&)>& quantity) {
  return of(sweep(c, values, change), quantity);
}
double efficiency(const SlipResult& s) { return s.efficiency.value_or(0.0); }
double loss(const SlipResult& s) { return s.power.total(); }
double optimality_of(const SlipResult& s) { return s.optimality; }
double screw_share(const SlipResult& s) { return s.power.screw / s.power.total(); }
double friction_at_screw(const SlipResult& s) { return s.threads.screw.friction_coefficient.front(); }
double friction_at_nut(const SlipResult& s) { return s.threads.nut.friction_coefficient.front(); }

double least(const Values& v) { return *std::min_element(v.begin(), v.end()); }
double greatest(const Values& v) { return *std::max_element(v.begin(), v.end()); }
double spread(const Values& v) { return greatest(v) - least(v); }
bool rises(const Values& v) { return std::ranges::adjacent_find(v, std::greater_equal{}) == v.end(); }
bool falls(const Values& v) { return std::ranges::adjacent_find(v, std::less_equal{}) == v.end(); }

std::string listed(const Values& v, double factor = 1.0, int decimals = 2) {
  std::vector<std::string> texts;
  for (const double value : v) texts.push_back(fmt::format("{:.{}f}", factor * value, decimals));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string range(const Values& v, const char* unit) {
  return fmt::format("{:g} to {:g} {}", v.front(), v.back(), unit);
}

/// Contacts and the mechanical model behind a result, for quantities that the result lacks.
struct Mechanics {
  Result result;
  SlipModels models;
  SlipModel model;

  explicit Mechanics(const Case& c)
      : result(analyze_slip(c)), models(c, result.contacts), model(models.of(result.load_cases.front())) {}
  Mechanics(const Mechanics&) = delete;
  Mechanics& operator=(const Mechanics&) = delete;

  const SlipResult& slip() const { return *result.load_cases.front().slip; }
  SlipBalance balance() const {
    SlipBalance b;
    balance_at(model, slip().slip_ratio, b);
    return b;
  }
  double static_load(Interface i) const { return (*result.load_cases.front().threads)[i].normal_load.front(); }
};

// Chapter 2 ---------------------------------------------------------------------------------------

Finding optimality_is_high(const Case& c) {
  const double measured = slip_of(at(c, slip_ratio, kMeasuredSlipRatio)).optimality;
  const double computed = slip_of(c).optimality;
  return {measured > 0.995, fmt::format("experiment 6, the only one that the text quotes: {:.2f} "
                                        "%; computed equilibrium: {:.2f} %",
                                        100 * measured, 100 * computed)};
}

Finding optimality_is_higher_at_low_speed(const Case& c) {
  const Values optimality = swept(c, kSpeeds, speed, optimality_of);
  return {falls(optimality), range(kSpeeds, "rpm: ") + listed(optimality, 100, 3) + " %"};
}

Finding optimality_rises_with_force(const Case& c) {
  const Values optimality = swept(c, kForces, force, optimality_of);
  return {rises(optimality), range(kForces, "kN: ") + listed(optimality, 100, 3) + " %"};
}

Finding jones_lies_below_the_ideal(const Case& c) {
  const SlipResult s = slip_of(c);
  return {s.ideal_slip_ratio - *s.estimates.jones > 1e-12,
          fmt::format("epsilon* less (2.20): {:.1e}", s.ideal_slip_ratio - *s.estimates.jones)};
}

Finding more_friction_raises_the_slip_ratio(const Case& c) {
  const auto ratio = [](const SlipResult& s) { return s.slip_ratio; };
  if (coulomb(c)) {
    const Values coefficients{0.03, 0.05, 0.08, 0.111, 0.16};
    const Values ratios =
        of(sweep(c, coefficients, [](Case& varied, double mu) { varied.friction->coefficient = at_both(mu); }), ratio);
    return {rises(ratios), "mu = " + listed(coefficients, 1, 3) + ": " + listed(ratios, 1, 5)};
  }
  const Values by_stress = swept(c, kStresses, eyring_stress, ratio);
  const Values by_viscosity = swept(c, kViscosities, viscosity, ratio);
  return {rises(by_stress) && rises(by_viscosity), range(kStresses, "MPa Eyring stress: ") + listed(by_stress, 1, 5) +
                                                       "; " + range(kViscosities, "mPa s: ") +
                                                       listed(by_viscosity, 1, 5)};
}

Finding nut_contact_spins(const Case& c) {
  const InterfaceSlip nut = slip_of(at(c, slip_ratio, kMeasuredSlipRatio)).threads.nut;
  const double ratio = nut.sliding_speed.front() / nut.max_sliding_speed.front();
  return {ratio < 1e-9, fmt::format("the centre slides at {:.0e} of the largest speed", ratio)};
}

Finding screw_contact_mostly_slides(const Case& c) {
  const InterfaceSlip screw = slip_of(at(c, slip_ratio, kMeasuredSlipRatio)).threads.screw;
  return {screw.sliding_speed.front() > 0.5 * screw.max_sliding_speed.front(),
          fmt::format("the centre slides at {:.1f} of at most {:.1f} mm/s", screw.sliding_speed.front() * "mm"_per_si,
                      screw.max_sliding_speed.front() * "mm"_per_si)};
}

Finding sliding_is_least_at_the_ideal(const Case& c) {
  bool least_there = true;
  const auto compare_type = [&](const Case& type, Interface sliding) {
    const auto speed_at = [&](double ratio) {
      return slip_of(at(type, slip_ratio, ratio)).threads[sliding].sliding_speed.front() * "mm"_per_si;
    };
    const double ideal = slip_of(type).ideal_slip_ratio, least = speed_at(ideal);
    for (const double step : {1e-4, 1e-2, 0.3})
      least_there = least_there && speed_at(ideal - step) > least && speed_at(ideal + step) > least;
    return fmt::format("{:.1f} mm/s at {:.4f}", least, ideal);
  };
  const double along_axis = c.mechanism.lead * c.operation->speed / (2.0 * std::numbers::pi) * "mm"_per_si;
  const std::string standard = compare_type(c, Interface::screw), other = compare_type(inverted(c), Interface::nut);
  return {least_there, fmt::format("standard {}, inverted {}, of which {:.1f} mm/s along the axis remain", standard,
                                   other, along_axis)};
}

/// (2.25) at the roller-screw contact: 1 Pa s, 300 nm.
double newtonian_friction(const Case& c, double viscosity_pa_s) {
  const Mechanics m(at(c, slip_ratio, kMeasuredSlipRatio));
  const InterfaceLoads& loads = m.result.load_cases.front().threads->screw;
  const double area = std::numbers::pi * loads.semi_major.front() * loads.semi_minor.front();
  return viscosity_pa_s * m.slip().threads.screw.sliding_speed.front() / 300e-9 * area / loads.normal_load.front();
}

Finding newtonian_friction_is_tiny(const Case& c) {
  const double mu = newtonian_friction(c, 1.0);
  return {mu > 0.5e-4 && mu < 5e-4, fmt::format("mu = {:.1e}", mu)};
}

Finding newtonian_friction_under_pressure_exceeds_one(const Case& c) {
  const Mechanics m(at(c, slip_ratio, kMeasuredSlipRatio));
  const double mean = 2.0 / 3.0 * m.result.load_cases.front().threads->screw.peak_pressure.front();
  const double mu = newtonian_friction(
      c, c.lubricant->viscosity.value() * contact::roelands_viscosity_ratio(c.lubricant->viscosity.value(), mean));
  return {mu > 10.0, fmt::format("mu = {:.1g} with Roelands' viscosity at the mean pressure", mu)};
}

Finding friction_is_higher_at_the_screw(const Case& c) {
  const SlipResult s = slip_of(at(c, slip_ratio, kMeasuredSlipRatio));
  return {friction_at_screw(s) > friction_at_nut(s),
          fmt::format("mu_a = {:.4f} and {:.4f}", friction_at_screw(s), friction_at_nut(s))};
}

Finding coulomb_would_do(const Case& c) {
  const SlipResult s = slip_of(at(c, slip_ratio, kMeasuredSlipRatio));
  const auto coulomb_power = [&](double mu) {
    return slip_of(at(with_coulomb(c, mu), slip_ratio, kMeasuredSlipRatio)).power;
  };
  const double screw = coulomb_power(friction_at_screw(s)).screw / s.power.screw - 1.0;
  const double nut = coulomb_power(friction_at_nut(s)).nut / s.power.nut - 1.0;
  return {std::max(std::abs(screw), std::abs(nut)) < 0.1,
          fmt::format("with mu_a as coefficient the power changes by {:+.1f} % at I and {:+.1f} % "
                      "at J (judged against 10 %)",
                      100 * screw, 100 * nut)};
}

/// Table 2.2: alpha [1/GPa], eta_0 [mPa s], tau_0 [MPa].
struct TabulatedLubricant {
  double pressure_viscosity, viscosity, eyring_stress;
};
constexpr TabulatedLubricant kLubricants[] = {{28.7, 28.4, 8},  {16.5, 4.6, 8},    {35.0, 266.0, 8},
                                              {30.0, 166.5, 8}, {30.0, 166.5, 10}, {30.0, 166.5, 12}};

/// mu_a of every lubricant of table 2.2 along the slip ratio.
std::vector<Values> friction_along_slip(const Case& c, double (*quantity)(const SlipResult&)) {
  std::vector<Values> friction;
  for (const TabulatedLubricant& l : kLubricants) {
    Case with = c;
    with.lubricant->pressure_viscosity = l.pressure_viscosity * 1e-9;
    with.lubricant->viscosity = l.viscosity * 1e-3;
    with.lubricant->eyring_stress = l.eyring_stress * 1e6;
    friction.push_back(swept(with, {0.05, 0.1, 0.2, 0.3, 0.35, 0.37}, slip_ratio, quantity));
  }
  return friction;
}

Finding friction_at_screw_falls_with_the_slip_ratio(const Case& c) {
  const std::vector<Values> friction = friction_along_slip(c, friction_at_screw);
  return {std::ranges::all_of(friction, falls),
          "slip ratio 0.05 to 0.37, lubricants of table 2.2; SKF LGWA2: " + listed(friction.back(), 1, 4)};
}

Finding friction_at_nut_rises_less(const Case& c) {
  const std::vector<Values> screw = friction_along_slip(c, friction_at_screw);
  const std::vector<Values> nut = friction_along_slip(c, friction_at_nut);
  bool holds = std::ranges::all_of(nut, rises);
  for (const auto k : indices(nut)) holds = holds && spread(nut[k]) < spread(screw[k]);
  return {holds, "SKF LGWA2: " + listed(nut.back(), 1, 4)};
}

Finding eight_megapascals_leave_friction_low(const Case& c) {
  const std::vector<Values> friction = friction_along_slip(c, friction_at_screw);
  const Values& most_viscous = friction[2];
  return {most_viscous.back() < friction.back().back() && most_viscous.back() < 0.1,
          fmt::format("at a slip ratio of 0.37: 5P4E {:.4f}, SKF LGWA2 with 12 MPa {:.4f} (judged against 0.1)",
                      most_viscous.back(), friction.back().back())};
}

Finding friction_falls_with_viscosity_and_stress(const Case& c) {
  const Results thinner = sweep(c, kViscosities, viscosity);
  const Results weaker = sweep(c, kStresses, eyring_stress);
  const bool holds = rises(of(thinner, friction_at_screw)) && rises(of(thinner, friction_at_nut)) &&
                     rises(of(weaker, friction_at_screw)) && rises(of(weaker, friction_at_nut));
  return {holds, "at I, " + range(kViscosities, "mPa s: ") + listed(of(thinner, friction_at_screw), 1, 4) + "; " +
                     range(kStresses, "MPa: ") + listed(of(weaker, friction_at_screw), 1, 4)};
}

// Chapter 3, model --------------------------------------------------------------------------------

/// Power of the tangential forces at the speed of the centres, the rest being that of the spin.
double uniform_sliding_share(const Case& c) {
  const Mechanics m(c);
  const SlipBalance b = m.balance();
  double power = 0.0;
  for (const Interface i : kInterfaces) {
    const PatchBalance& side = b.patches[i];
    power += m.model.threads[i].alike * side.normal_load.front() *
             (side.friction.front().traction_major * b.sliding[i].sliding_major +
              side.friction.front().traction_minor * b.sliding[i].sliding_minor);
  }
  return m.model.rollers * power / m.slip().power.total();
}

Finding sliding_friction_dominates(const Case& c) {
  const double share = uniform_sliding_share(c);
  return {share > 0.9, fmt::format("{:.1f} %, without any part of the spin; inverted: {:.1f} %", 100 * share,
                                   100 * uniform_sliding_share(inverted(c)))};
}

Finding spin_torques_oppose_the_roller(const Case& c) {
  bool oppose = true;
  const auto in_equilibrium = [&](const Case& type) {
    const Mechanics m(type);
    const SlipBalance b = m.balance();
    Values torques;
    for (const Interface i : kInterfaces) {
      torques.push_back(b.interfaces[i].spin_torque);
      oppose = oppose && torques.back() * b.motion.roller_to_carrier < 0.0;
    }
    return fmt::format("{} N mm at {:.1f} rad/s", listed(torques, "N mm"_per_si), b.motion.roller_to_carrier);
  };
  const std::string standard = in_equilibrium(c), other = in_equilibrium(inverted(c));
  return {oppose, fmt::format("in equilibrium: standard {}, inverted {}; an inverted roller-nut contact "
                              "spins the other way, and helps, beyond epsilon = 1/(1 + Gamma) = {:.3f}",
                              standard, other, 1.0 / (1.0 + slip_of(inverted(c)).gear_ratio))};
}

Finding static_torques_are_those_of_the_lead(const Case& c) {
  const double torque = c.load_cases.front().axial_force * c.mechanism.lead / (2.0 * std::numbers::pi);
  const SlipResult s = slip_of(without_friction(c));
  const double error = std::max(std::abs(s.torque_screw / torque - 1.0), std::abs(s.torque_nut / torque + 1.0));
  return {error < 1e-10, fmt::format("F_N l/(2 pi) = {:.4f} N m, C_S = {:.4f}, C_N = {:.4f} N m", torque,
                                     s.torque_screw, s.torque_nut)};
}

Finding static_force_along_the_orbit_vanishes(const Case& c) {
  const RollerForces f = slip_of(without_friction(c)).forces;
  return {std::abs(f.contacts_y) < 1e-9 * std::abs(f.contacts_x) && f.contacts_x > 0.0,
          fmt::format("{:.1e} N along the orbit, {:.2f} N radially on each roller", f.contacts_y, f.contacts_x)};
}

Finding carrier_is_loaded_radially(const Case& c) {
  const RollerForces f = slip_of(c).forces;
  return {std::abs(f.carrier_x) > 100.0 * std::abs(f.carrier_y),
          fmt::format("{:.1f} N radially, {:.2f} N along the orbit on each roller", f.carrier_x, f.carrier_y)};
}

Finding rollers_are_pushed_to_the_geared_part(const Case& c) {
  const double standard = slip_of(c).forces.carrier_x;
  const double other = slip_of(inverted(c)).forces.carrier_x;
  return {standard > 0.0 && other < 0.0,
          fmt::format("standard {:+.0f} N, inverted {:+.0f} N on each roller", standard, other)};
}

Finding centrifugal_force_is_negligible(const Case& c) {
  const RollerForces f = slip_of(c).forces;
  return {f.centrifugal > 0.0 && f.centrifugal < 0.01 * std::abs(f.carrier_x),
          fmt::format("{:.2f} N against {:.0f} N", f.centrifugal, f.carrier_x)};
}

Finding dynamic_loads_rise_slightly(const Case& c) {
  const Mechanics m(c);
  const auto rise = [&](Interface i) {
    return std::abs(m.slip().threads[i].dynamic_normal_load.front() / m.static_load(i) - 1.0);
  };
  return {std::max(rise(Interface::screw), rise(Interface::nut)) < 0.05,
          fmt::format("by {:.1f} % at I and {:.2f} % at J (judged against 5 %)", 100 * rise(Interface::screw),
                      100 * rise(Interface::nut))};
}

/// Power if ellipse, pressure and film follow from the dynamic loads.
Finding dynamic_ellipses_change_little(const Case& c) {
  const Mechanics m(c);
  SlipModel model = m.models.of(m.result.load_cases.front());
  SlipEquilibrium e = find_slip_equilibrium(model);
  for (int pass = 0; pass < 3; ++pass) {
    for (const Interface i : kInterfaces) {
      const InterfaceContact& contact = m.result.contacts.interfaces[i];
      const double load = e.balance.patches[i].normal_load.front();
      const contact::HertzContact ellipse = contact::at_load(contact.hertz, load);
      std::vector<contact::Patch>& patches = model.threads[i].patches;
      patches.clear();
      if (coulomb(c))
        patches.emplace_back(m.models.grid(), ellipse, c.friction->at(i));
      else
        patches.emplace_back(m.models.grid(), ellipse,
                             contact::friction_law(contact::Jacod<double>{}, *model.oils.threads[i],
                                                   {load, contact.geometry.relative.second, contact.contact_modulus}));
    }
    e = find_slip_equilibrium(model);
  }
  const double change = lost_power(model, e.balance).total() / m.slip().power.total() - 1.0;
  return {std::abs(change) < 0.005, fmt::format("{:+.2f} % (judged against 0.5 %)", 100 * change)};
}

Finding residue_is_monotonous(const Case& c) {
  bool holds = true;
  for (const Case& type : {c, inverted(c)}) {
    const Result result = analyze_slip(type);
    Values residue;
    for (const RollerMoments& m : slip_pictures(type, result, 0).residue.moments) residue.push_back(m.residue());
    holds = holds && (rises(residue) || falls(residue)) && residue.front() * residue.back() < 0.0;
  }
  return {holds,
          "one sign at pure sliding, the other at the ideal slip ratio, monotonous at 121 points "
          "between, standard and inverted"};
}

Finding solution_lies_between_measurement_and_ideal(const Case& c) {
  const SlipResult s = slip_of(c);
  return {s.slip_ratio > kMeasuredSlipRatio && s.slip_ratio < s.ideal_slip_ratio,
          fmt::format("{:.4f} < {:.6f} < {:.6f}", kMeasuredSlipRatio, s.slip_ratio, s.ideal_slip_ratio)};
}

Finding only_gears_drive_the_roller(const Case& c) {
  const Mechanics m(c);
  const RollerMoments r = m.slip().moments;
  const double turns = m.balance().motion.roller_to_carrier;
  const bool holds =
      r.gears * turns > 0.0 && r.contacts * turns < 0.0 && r.spin * turns < 0.0 && r.carrier * turns < 0.0;
  const double mm = "N mm"_per_si;
  return {holds, fmt::format("gears {:.1f}, contacts {:.1f}, spin {:.1f}, carrier {:.1f} N mm", r.gears * mm,
                             r.contacts * mm, r.spin * mm, r.carrier * mm)};
}

Finding bearing_moment_is_small(const Case& c) {
  const RollerMoments r = slip_of(c).moments;
  return {r.carrier < 0.05 * std::abs(r.gears),
          fmt::format("{:.1f} % of the moment of the gears (judged against 5 %)", 100 * r.carrier / std::abs(r.gears))};
}

Finding torques_are_equal_and_opposite(const Case& c) {
  const SlipResult s = slip_of(c);
  return {std::abs(s.torque_screw / s.torque_nut + 1.0) < 1e-10,
          fmt::format("C_S = {:.6f}, C_N = {:.6f} N m", s.torque_screw, s.torque_nut)};
}

Finding dynamic_torque_exceeds_the_static_one(const Case& c) {
  const double at_rest = slip_of(without_friction(c)).torque_screw;
  const double moving = slip_of(c).torque_screw;
  return {moving > at_rest, fmt::format("{:.2f} against {:.2f} N m", moving, at_rest)};
}

Finding both_powers_agree_in_equilibrium(const Case& c) {
  const auto difference = [](const SlipResult& s) { return s.power_loss_input_output / s.power.total() - 1.0; };
  const double free = difference(slip_of(c));
  const double imposed = difference(slip_of(at(c, slip_ratio, kMeasuredSlipRatio)));
  return {std::abs(free) < 1e-10 && std::abs(imposed) > 1e-3,
          fmt::format("they differ by {:.0e} in equilibrium, by {:.1f} % at the measured slip ratio", std::abs(free),
                      100 * imposed)};
}

/// Error of the power against 301 x 301 points.
double patch_error(const Case& c, double points) {
  return loss(slip_of(at(c, patch_points, points))) / loss(slip_of(at(c, patch_points, 301))) - 1.0;
}

Finding patch_points_suffice(const Case& c) {
  const double error = patch_error(c, 21);
  return {std::abs(error) < 0.005,
          fmt::format("{:+.2f} % against 301 x 301 points (judged against 0.5 %)", 100 * error)};
}

Finding single_points_are_wrong(const Case& c) {
  const SlipResult s = slip_of(at(c, patch_points, 1));
  return {std::abs(patch_error(c, 1)) > 0.1,
          fmt::format("the power is {:+.0f} % off, that of the roller-nut contacts is {:.1e} W",
                      100 * patch_error(c, 1), s.power.nut)};
}

// Chapter 3, parameters ---------------------------------------------------------------------------

Finding screw_contacts_take_most(const Case& c) {
  const double share = screw_share(slip_of(c));
  const PowerBySource other = slip_of(inverted(c)).power;
  return {share > 0.9, fmt::format("{:.1f} %; inverted, roller-nut contacts: {:.1f} %", 100 * share,
                                   100 * other.nut / other.total())};
}

Finding nut_spin_counts(const Case& c) {
  const PowerBySource p = slip_of(c).power;
  const double share = p.nut / p.total();
  return {share > 0.01 && share < 0.1, fmt::format("{:.1f} % (judged against 1 and 10 %)", 100 * share)};
}

Finding bearing_power_is_very_small(const Case& c) {
  const PowerBySource p = slip_of(c).power;
  Case without = c;
  without.carrier.bearing.reset();
  return {
      p.carrier_roller < 0.02 * p.total(),
      fmt::format("{:.2f} % of the power (judged against 2 %), {:.2f} points of efficiency",
                  100 * p.carrier_roller / p.total(), 100 * (efficiency(slip_of(without)) - efficiency(slip_of(c))))};
}

Finding power_falls_with_the_diameter(const Case& c) {
  const Results results = sweep(c, kDiameters, diameter);
  const Values power = of(results, loss), eff = of(results, efficiency);
  return {falls(power) && spread(eff) < 0.02,
          range(kDiameters, "mm: ") + listed(power, 1, 1) + " W; efficiency " + listed(eff, 100) + " %"};
}

Finding efficiency_is_constant(const Case& c) {
  bool holds = true;
  std::string evidence = "spread of the efficiency in points:";
  const auto add = [&](const Values& values, auto change, const char* what) {
    const double points = 100 * spread(swept(c, values, change, efficiency));
    holds = holds && points < 2.0;
    evidence += fmt::format(" {} {:.2f},", what, points);
  };
  add(kDiameters, diameter, "diameter (20 to 50 mm)");
  add(kLeads, lead, "lead (5 to 20 mm)");
  add(kFlankAngles, flank_angle, "pressure angle (40 to 50 deg)");
  add(kRollerProfiles, roller_profile, "roller profile (4 to 10 mm)");
  add(kScrewProfiles, screw_profile, "screw profile (20 mm concave to 20 mm convex)");
  add(kRollers, rollers, "rollers (5 to 11)");
  if (c.carrier.bearing) add(kClearances, clearance, "e_b (0.1 to 0.25 mm)");
  add(kSpeeds, speed, "speed (50 to 800 rpm)");
  add({10, 20, 35, 50, 70}, force, "force (10 to 70 kN)");
  const double by_viscosity = 100 * spread(swept(c, kViscosities, viscosity, efficiency));
  const double by_stress = 100 * spread(swept(c, kStresses, eyring_stress, efficiency));
  return {holds && by_viscosity > 2.0 && by_stress > 2.0,
          evidence + fmt::format(" judged against 2; viscosity (28.4 to 266 mPa s) {:.1f}, Eyring "
                                 "stress (4 to 16 MPa) {:.1f}",
                                 by_viscosity, by_stress)};
}

/// Deviation from a line: its largest error over the range of the values.
double nonlinearity(const Values& x, const Values& y) { return line_through(x, y).worst / spread(y); }

Values logarithms(Values v) {
  for (double& x : v) x = std::log(x);
  return v;
}

Finding efficiency_falls_linearly(const Case& c) {
  const Values by_stress = swept(c, kStresses, eyring_stress, efficiency);
  const Values by_viscosity = swept(c, kViscosities, viscosity, efficiency);
  const double stress = nonlinearity(kStresses, by_stress);
  const double viscosities = nonlinearity(logarithms(kViscosities), by_viscosity);
  return {falls(by_stress) && falls(by_viscosity) && std::max(stress, viscosities) < 0.05,
          fmt::format("a line misses by {:.1f} % of the change over {} and {:.1f} % over {} "
                      "(judged against 5 %)",
                      100 * stress, range(kStresses, "MPa"), 100 * viscosities, range(kViscosities, "mPa s"))};
}

Finding efficiency_tends_to_one(const Case& c) {
  const double stress = efficiency(slip_of(at(c, eyring_stress, 0.01)));
  const double thin = efficiency(slip_of(at(c, viscosity, 0.07)));
  return {std::min(stress, thin) > 0.998,
          fmt::format("{:.2f} % at tau_0 = 0.01 MPa, {:.2f} % at eta_0 = 0.07 mPa s; (3.55) itself "
                      "gives 98.1 % at tau_0 = 0",
                      100 * stress, 100 * thin)};
}

Finding printed_fit_is_near(const Case& c) {
  double worst = 0.0;
  for (const double stress : {8.0, 10.0, 12.0, 14.0, 16.0})
    for (const double eta : {100.0, 133.0, 166.5, 200.0, 266.0}) {
      const double printed = 0.981 - 0.0032 * stress * std::log(eta);
      const double computed = efficiency(slip_of(at(at(c, eyring_stress, stress), viscosity, eta)));
      worst = std::max(worst, std::abs(printed - computed));
    }
  return {worst < 0.02, fmt::format("with the printed constants it misses by {:.2f} points at most "
                                    "over 8 to 16 MPa and 100 to 266 mPa s (judged against 2)",
                                    100 * worst)};
}

/// Least and greatest ratio of two lists.
Values ratios(const Values& power, const Values& x) {
  Values ratio;
  for (const auto k : indices(x)) ratio.push_back(power[k] / x[k]);
  return {least(ratio), greatest(ratio)};
}

Finding power_is_linear_in_speed_and_force(const Case& c) {
  const Values by_speed = ratios(swept(c, kSpeeds, speed, loss), kSpeeds);
  const Values forces{10, 20, 35, 50, 70};
  const Values by_force = ratios(swept(c, forces, force, loss), forces);
  return {by_speed[1] < 1.1 * by_speed[0] && by_force[1] < 1.1 * by_force[0],
          fmt::format("{:.3f} to {:.3f} W/rpm over {}; {:.2f} to {:.2f} W/kN over 10 to 70 kN "
                      "(judged against 10 %)",
                      by_speed[0], by_speed[1], range(kSpeeds, "rpm"), by_force[0], by_force[1])};
}

Finding power_is_proportional_to_stress_and_viscosity(const Case& c) {
  const Values stress = ratios(swept(c, kStresses, eyring_stress, loss), kStresses);
  const Values thick = ratios(swept(c, kViscosities, viscosity, loss), logarithms(kViscosities));
  return {stress[1] < 1.1 * stress[0] && thick[1] < 1.1 * thick[0],
          fmt::format("{:.1f} to {:.1f} W/MPa over {}; {:.1f} to {:.1f} W per unit of ln(eta_0/mPa "
                      "s) over {} (judged against 10 %)",
                      stress[0], stress[1], range(kStresses, "MPa"), thick[0], thick[1], range(kViscosities, "mPa s"))};
}

Finding nut_torque_adds_linearly(const Case& c) {
  const Values power = swept(c, kNutTorques, nut_torque, loss);
  const double error = nonlinearity(kNutTorques, power);
  return {rises(power) && error < 0.01,
          fmt::format("{} W; a line misses by {:.2f} % of the change (judged against 1 %)",
                      range(kNutTorques, "N m: ") + listed(power, 1, 1), 100 * error)};
}

Finding precise_bearings_cost(const Case& c) {
  const auto ratio = [&](double mm) {
    const PowerBySource p = slip_of(at(c, clearance, mm)).power;
    return p.carrier_roller / p.nut;
  };
  const Values values{0.0005, 0.001, 0.005, 0.02, 0.1, 0.25};
  Values ratios;
  for (const double mm : values) ratios.push_back(ratio(mm));
  return {ratios.front() > 0.5 && least({ratio(0.1), ratio(0.15), ratio(0.25)}) < 0.5 &&
              greatest({ratio(0.1), ratio(0.15), ratio(0.25)}) < 0.5,
          "bearing over roller-nut power for e_b = " + listed(values, 1, 4) + " mm: " + listed(ratios) +
              " (judged: below 0.5 from 0.1 mm on)"};
}

Finding profiles_and_rollers_hardly_matter(const Case& c) {
  const double reference = loss(slip_of(c));
  const auto change = [&](const Values& values, auto vary) {
    double worst = 0.0;
    for (const double power : swept(c, values, vary, loss)) worst = std::max(worst, std::abs(power / reference - 1.0));
    return worst;
  };
  const double roller = change(kRollerProfiles, roller_profile);
  const double screw = change(kScrewProfiles, screw_profile);
  const double number = change(kRollers, rollers);
  return {std::max({roller, screw, number}) < 0.02,
          fmt::format("power changes by at most {:.2f} % with the roller's profile, {:.2f} % with "
                      "the screw's, {:.2f} % with 5 to 11 rollers (judged against 2 %)",
                      100 * roller, 100 * screw, 100 * number)};
}

Finding forty_five_degrees_is_good(const Case& c) {
  const Values eff = swept(c, kPressureAngles, flank_angle, efficiency);
  const double loss_at_45 = greatest(eff) - efficiency(slip_of(c));
  return {loss_at_45 < 0.005, listed(kPressureAngles, 1, 1) + " deg: " + listed(eff, 100) + " %"};
}

Finding lead_raises_the_power(const Case& c) {
  const Results results = sweep(c, kLeads, lead);
  const Values power = of(results, loss), eff = of(results, efficiency);
  return {rises(power) && power.back() > 2.0 * power.front() && spread(eff) < 0.02,
          range(kLeads, "mm: ") + listed(power, 1, 0) + " W; efficiency " + listed(eff, 100) + " %"};
}

Finding efficiency_is_around_80_percent(const Case& c) {
  const double eff = efficiency(slip_of(c));
  return {std::abs(eff - 0.8) < 0.05, fmt::format("{:.2f} %", 100 * eff)};
}

const Checks<Case> kChecks{
    {"optimality_is_high", optimality_is_high},
    {"optimality_is_higher_at_low_speed", optimality_is_higher_at_low_speed},
    {"optimality_rises_with_force", optimality_rises_with_force},
    {"jones_lies_below_the_ideal", jones_lies_below_the_ideal},
    {"more_friction_raises_the_slip_ratio", more_friction_raises_the_slip_ratio},
    {"nut_contact_spins", nut_contact_spins},
    {"screw_contact_mostly_slides", screw_contact_mostly_slides},
    {"sliding_is_least_at_the_ideal", sliding_is_least_at_the_ideal},
    {"newtonian_friction_is_tiny", newtonian_friction_is_tiny},
    {"newtonian_friction_under_pressure_exceeds_one", newtonian_friction_under_pressure_exceeds_one},
    {"friction_is_higher_at_the_screw", friction_is_higher_at_the_screw},
    {"coulomb_would_do", coulomb_would_do},
    {"friction_at_screw_falls_with_the_slip_ratio", friction_at_screw_falls_with_the_slip_ratio},
    {"friction_at_nut_rises_less", friction_at_nut_rises_less},
    {"eight_megapascals_leave_friction_low", eight_megapascals_leave_friction_low},
    {"friction_falls_with_viscosity_and_stress", friction_falls_with_viscosity_and_stress},
    {"sliding_friction_dominates", sliding_friction_dominates},
    {"spin_torques_oppose_the_roller", spin_torques_oppose_the_roller},
    {"static_torques_are_those_of_the_lead", static_torques_are_those_of_the_lead},
    {"static_force_along_the_orbit_vanishes", static_force_along_the_orbit_vanishes},
    {"carrier_is_loaded_radially", carrier_is_loaded_radially},
    {"rollers_are_pushed_to_the_geared_part", rollers_are_pushed_to_the_geared_part},
    {"centrifugal_force_is_negligible", centrifugal_force_is_negligible},
    {"dynamic_loads_rise_slightly", dynamic_loads_rise_slightly},
    {"dynamic_ellipses_change_little", dynamic_ellipses_change_little},
    {"residue_is_monotonous", residue_is_monotonous},
    {"solution_lies_between_measurement_and_ideal", solution_lies_between_measurement_and_ideal},
    {"only_gears_drive_the_roller", only_gears_drive_the_roller},
    {"bearing_moment_is_small", bearing_moment_is_small},
    {"torques_are_equal_and_opposite", torques_are_equal_and_opposite},
    {"dynamic_torque_exceeds_the_static_one", dynamic_torque_exceeds_the_static_one},
    {"patch_points_suffice", patch_points_suffice},
    {"single_points_are_wrong", single_points_are_wrong},
    {"both_powers_agree_in_equilibrium", both_powers_agree_in_equilibrium},
    {"screw_contacts_take_most", screw_contacts_take_most},
    {"nut_spin_counts", nut_spin_counts},
    {"bearing_power_is_very_small", bearing_power_is_very_small},
    {"power_falls_with_the_diameter", power_falls_with_the_diameter},
    {"efficiency_is_constant", efficiency_is_constant},
    {"efficiency_falls_linearly", efficiency_falls_linearly},
    {"efficiency_tends_to_one", efficiency_tends_to_one},
    {"printed_fit_is_near", printed_fit_is_near},
    {"power_is_linear_in_speed_and_force", power_is_linear_in_speed_and_force},
    {"power_is_proportional_to_stress_and_viscosity", power_is_proportional_to_stress_and_viscosity},
    {"nut_torque_adds_linearly", nut_torque_adds_linearly},
    {"precise_bearings_cost", precise_bearings_cost},
    {"profiles_and_rollers_hardly_matter", profiles_and_rollers_hardly_matter},
    {"forty_five_degrees_is_good", forty_five_degrees_is_good},
    {"lead_raises_the_power", lead_raises_the_power},
    {"efficiency_is_around_80_percent", efficiency_is_around_80_percent},
};

}  // namespace

std::vector<ComparedStatement> compare_statements(const Case& reference, const Reference& thesis) {
  const std::vector<Variant<Case>> variants{{"table 3.2", reference},
                                            {"Coulomb friction of 0.111", with_coulomb(reference, 0.111)}};
  return compare(thesis.statements, kChecks, variants);
}

}  // namespace prs::sandu_2018
