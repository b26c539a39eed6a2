#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// Sandu 2018, chapters 2 and 3, in an independent and simple implementation: one number after the other, extended
/// precision, no header of the program. Equation numbers are those of the thesis, read with the errata: factor 2 in
/// (2.30), |u| = sqrt(u.u - (u.n)^2) in (2.36), static loads in (2.38), cell-centred points for (3.7), gear arms at the
/// operating pitch radii in (3.30), (3.31), (3.38), axial equilibrium (3.11), (3.12) thread by thread and all other
/// sums over the threads.
///
/// Frame: carrier, z the axis of screw and nut, x from it to the roller's axis. SI units.
namespace plain {

using Real = long double;
using Vec = std::array<Real, 3>;

inline const Real pi = std::acos(Real(-1));

inline Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(Real s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Real sign(Real x) { return x > 0 ? Real(1) : x < 0 ? Real(-1) : Real(0); }

/// One thread of one roller at one interface, under its static load.
struct Thread {
  Real axial_load = 0;     ///< F_i >= 0 [N].
  Real semi_major = 0;     ///< a [m].
  Real semi_minor = 0;     ///< b [m].
  Real peak_pressure = 0;  ///< P_h [Pa].
};

/// Screw-roller (I) or nut-roller (J).
struct Interface {
  Real x = 0, y = 0;              ///< Contact point from the axis of screw and nut [m].
  Vec normal{};                   ///< n, unit, external to the roller.
  Vec major{};                    ///< t1, unit; the minor axis is n x t1.
  Real larger_curvature = 0;      ///< rho_x of (2.31), relative [1/m].
  Real curvature_ratio = 1;       ///< lambda, smaller over larger relative curvature.
  Real relative_modulus = 0;      ///< E' = 2 E* [Pa].
  Real roughness = 0;             ///< Composite Rq [m]; 0: not given.
  std::optional<Real> coulomb{};  ///< Friction coefficient; without it Jacod's law.
  std::vector<Thread> threads{};  ///< Threads of one roller.
};

struct Lubricant {
  Real viscosity = 0;           ///< eta_0 [Pa s].
  Real pressure_viscosity = 0;  ///< alpha [1/Pa].
  Real eyring_stress = 0;       ///< tau_0 [Pa].
};

struct Case {
  bool standard = true;               ///< chi.
  Real lead = 0;                      ///< Lead of screw and nut, signed [m].
  Real gear_ratio = 0;                ///< Gamma of (2.1) > 0.
  Real centre_distance = 0;           ///< c [m].
  int rollers = 0;                    ///< N_R.
  Real force_on_nut = 0;              ///< F_N, signed [N].
  Real speed = 0;                     ///< omega_s/n, signed [rad/s].
  Interface screw{};                  ///< I.
  Interface nut{};                    ///< J.
  Lubricant lubricant{};              ///< For Jacod's law.
  std::optional<Real> boundary{};     ///< Friction coefficient of touching flanks: mixed.
  Real exponent = 2;                  ///< Exponent of the share of touching flanks.
  Real carrier_roller_torque = 0;     ///< |C_P/R| of one roller [N m].
  Real carrier_screw_torque = 0;      ///< |C_P/S| [N m].
  Real carrier_nut_torque = 0;        ///< |C_P/N| [N m].
  Real gear_pressure_angle = pi / 9;  ///< alpha_g [rad].
  Real roller_mass = 0;               ///< m_R [kg].
  bool film_along_rolling = false;    ///< Whether to use the central film of the true direction of rolling.
  int patch_points = 21;              ///< N_1 = N_2.
  std::optional<Real> slip_ratio{};   ///< Imposed value, instead of the root of (3.43).
};

/// Velocities at one contact, body (screw or nut) against roller.
struct Motion {
  Vec sliding{};  ///< v_M, body minus roller (2.10), (2.11) [m/s].
  Vec sum{};      ///< u_M, body plus roller (2.32), (2.33) [m/s].
  Real spin = 0;  ///< omega_1/2 about z (2.23), (2.24) [rad/s].
};

/// lambda of (2.4): speed of the roller in the carrier over that of the screw against the nut.
inline Real roller_ratio(const Case& c, Real slip) { return -(c.standard ? slip : 1 - slip) / c.gear_ratio; }

/// (2.6) applied to body and roller; both turn about z, only the advancing body moves along it.
inline Motion motion(const Case& c, bool screw, Real slip) {
  const Interface& m = screw ? c.screw : c.nut;
  const Real omega_pn = slip * c.speed;                   // (2.2)
  const Real omega_rp = roller_ratio(c, slip) * c.speed;  // (2.2)
  const Real omega_bp = screw ? c.speed - omega_pn : -omega_pn;
  const Real advance_ns = -c.lead / (2 * pi) * c.speed;  // (2.5)
  const Real advance = screw ? (c.standard ? -advance_ns : 0) : (c.standard ? 0 : advance_ns);
  const Vec body = cross(Vec{0, 0, omega_bp}, Vec{m.x, m.y, 0}) + Vec{0, 0, advance};
  const Vec roller = cross(Vec{0, 0, omega_rp}, Vec{m.x - c.centre_distance, m.y, 0});
  return {body - roller, body + roller, omega_bp - omega_rp};
}

/// (2.16), (2.17): where the sliding speed at I (standard) or J (inverted) is least.
inline Real ideal_slip_ratio(const Case& c) {
  const Interface& m = c.standard ? c.screw : c.nut;
  const Real g = c.gear_ratio;
  const Real r = std::hypot(m.x, m.y);
  const Real q = c.centre_distance / r;
  const Real cosine = m.x / r;
  if (c.standard) return -g * (1 - g - q * cosine) / ((1 - g) * (1 - g - 2 * q * cosine) + q * q);
  return (1 + g - (2 + g) * q * cosine + q * q) / ((1 + g) * (1 + g - 2 * q * cosine) + q * q);
}

/// Ideal slip ratio by golden section on |v_M|, to about 1e-9.
inline Real ideal_slip_ratio_by_search(const Case& c) {
  const auto speed = [&](Real slip) {
    const Vec v = motion(c, c.standard, slip).sliding;
    return dot(v, v);
  };
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  Real low = -1, high = 2;
  for (int i = 0; i < 100; ++i) {
    const Real left = high - golden * (high - low);
    const Real right = low + golden * (high - low);
    (speed(left) < speed(right) ? high : low) = speed(left) < speed(right) ? right : left;
  }
  return (low + high) / 2;
}

/// v_M . n of (2.12): zero if the gear ratio obeys (2.14).
inline Real penetration_speed(const Case& c, bool screw, Real slip) {
  return dot(motion(c, screw, slip).sliding, screw ? c.screw.normal : c.nut.normal);
}

struct Film {
  Real number = 0;     ///< H_c (2.37).
  Real thickness = 0;  ///< h_c (2.39) [m].
  Real central = 0;    ///< Film by the full fit [m].
};

/// H of Nijenbanning, Venner and Moes (Wear 176, 1994), as they print it; long double has the range
/// for its powers.
inline Real full_film_number(Real m, Real l, Real lambda) {
  const Real k = 1 + Real(0.006L) * std::log(lambda) + Real(0.63L) * std::pow(lambda, Real(4) / 7);
  const Real ri = 145 * std::pow(1 + Real(0.796L) * std::pow(lambda, Real(14) / 15), -Real(15) / 7) / lambda / (m * m);
  const Real ei =
      Real(3.18L) * std::pow(k, -Real(14) / 25) * std::pow(lambda, -Real(1) / 15) * std::pow(m, -Real(2) / 15);
  const Real rp = Real(1.29L) * std::pow(1 + Real(0.691L) * lambda, -Real(2) / 3) * std::pow(l, Real(2) / 3);
  const Real ep = Real(1.48L) * std::pow(k, -Real(7) / 20) * std::pow(lambda, -Real(1) / 24) *
                  std::pow(m, -Real(1) / 12) * std::pow(l, Real(3) / 4);
  const Real h00 = Real(1.80L) * std::pow(lambda, -Real(5) / 7);
  const Real s = Real(1.5L) * (1 + std::exp(-Real(1.2L) * ei / ep));
  const Real isoviscous =
      std::pow(ri, Real(1.5L)) + std::pow(std::pow(ei, Real(-4)) + std::pow(h00, Real(-4)), -Real(3) / 8);
  const Real piezoviscous = std::pow(rp, Real(-8)) + std::pow(ep, Real(-8));
  return std::pow(std::pow(isoviscous, 2 * s / 3) + std::pow(piezoviscous, -s / 8), 1 / s);
}

/// (2.36) as corrected: the part of the sum velocity in the contact plane.
inline Real rolling_speed(const Motion& v, const Vec& n) {
  const Real normal = dot(v.sum, n);
  return std::sqrt(dot(v.sum, v.sum) - normal * normal);
}

inline Film film(const Interface& m, const Lubricant& l, Real rolling, Real normal_load) {
  const Real rho = m.larger_curvature;
  const Real e = m.relative_modulus;
  const Real u = l.viscosity * rolling * rho / e;
  const Real moes_m = normal_load * rho * rho / (e * std::pow(u, Real(3) / 4));
  const Real moes_l = l.pressure_viscosity * e * std::pow(u, Real(1) / 4);
  const Real h = Real(1.7L) * std::pow(moes_m, -Real(1) / 9) * std::pow(moes_l, Real(3) / 4);
  return {h, h * std::sqrt(u) / rho, full_film_number(moes_m, moes_l, m.curvature_ratio) * std::sqrt(u) / rho};
}

/// Central film of Chittenden, Dowson, Dunn and Taylor (1985) at the angle theta of the rolling to
/// the minor axis, which their x axis is: 1/R_e = cos^2/R_x + sin^2/R_y, 1/R_s = sin^2/R_x +
/// cos^2/R_y, with mean velocity and E' = 2 E* [m].
inline Real film_along_rolling(const Interface& m, const Lubricant& l, const Motion& v, Real normal_load) {
  const Real u_1 = dot(v.sum, m.major), u_2 = dot(v.sum, cross(m.normal, m.major));
  const Real theta = std::atan2(u_1, u_2), c = std::cos(theta), s = std::sin(theta);
  const Real r_x = 1 / m.larger_curvature, r_y = r_x / m.curvature_ratio;
  const Real r_e = 1 / (c * c / r_x + s * s / r_y), r_s = 1 / (s * s / r_x + c * c / r_y);
  const Real e = m.relative_modulus;
  const Real mean_speed = rolling_speed(v, m.normal) / 2;
  return r_e * Real(4.31L) * std::pow(l.viscosity * mean_speed / (e * r_e), Real(0.68L)) *
         std::pow(l.pressure_viscosity * e, Real(0.49L)) * std::pow(normal_load / (e * r_e * r_e), Real(-0.073L)) *
         (1 - std::exp(Real(-1.23L) * std::pow(r_s / r_e, Real(2) / 3)));
}

/// (2.27), (2.29), (2.30) at one point.
inline Real jacod(const Interface& m, const Lubricant& l, Real pressure, Real sliding, Real rolling, Real film_number) {
  const Real viscosity =
      std::exp((std::log(l.viscosity) + Real(9.67L)) * (std::pow(1 + pressure / Real(0.198e9L), Real(0.6L)) - 1));
  const Real slide = 2 / l.eyring_stress * (sliding / rolling) *
                     std::sqrt(rolling * l.viscosity * m.relative_modulus * m.larger_curvature);
  return l.eyring_stress / pressure * std::asinh(viscosity * slide / (5 * film_number));
}

/// Effect of one thread on the roller.
struct ThreadFriction {
  Vec direction{};                ///< m_M (3.8): the body pushes the roller with -N_M m_M.
  Real normal_load = 0;           ///< N_M (3.11), (3.12) [N].
  Real spin_torque = 0;           ///< C_M (3.10) [N m].
  Real power = 0;                 ///< Loss, -W_M of (3.51) [W].
  Real friction_coefficient = 0;  ///< mu_a (2.40).
  Real max_sliding_speed = 0;     ///< Largest value over the points inside [m/s].
  Real film_thickness = 0;        ///< h_c [m], with a lubricant.
  Real central_film = 0;          ///< Film by the full fit [m].
  Real boundary_share = 0;        ///< Given with a roughness.
  int points = 0;                 ///< Number of points inside the ellipse.
};

inline ThreadFriction friction(const Case& c, bool screw, Motion v, const Thread& t) {
  const Interface& m = screw ? c.screw : c.nut;
  ThreadFriction out;
  out.direction = m.normal;
  if (!(t.axial_load > 0)) return out;

  // A contact without slip slides by the rounding of its input.
  if (dot(v.sliding, v.sliding) < Real(1e-24L) * dot(v.sum, v.sum)) v.sliding = {};
  const Vec t1 = m.major;
  const Vec t2 = cross(m.normal, t1);
  const Real rolling = rolling_speed(v, m.normal);
  const Real normal_spin = v.spin * m.normal[2];
  Film central;
  if (c.lubricant.viscosity > 0) {
    central = film(m, c.lubricant, rolling, t.axial_load / std::abs(m.normal[2]));
    if (c.film_along_rolling)
      central.central = film_along_rolling(m, c.lubricant, v, t.axial_load / std::abs(m.normal[2]));
    out.film_thickness = central.thickness;
    out.central_film = central.central;
    if (m.roughness > 0) out.boundary_share = std::pow(1 + central.central / m.roughness, -c.exponent);
  }

  const int n = c.patch_points;
  const Real weight = 6 / (pi * n * n);
  Real push_1 = 0, push_2 = 0, spin = 0, power = 0, coefficients = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const long long p = 2 * i + 1 - n, q = 2 * j + 1 - n;  // cell centres, in units of a/n, b/n
      const long long rest = static_cast<long long>(n) * n - p * p - q * q;
      if (rest <= 0) continue;
      const Real root = std::sqrt(Real(rest)) / n;
      const Real d1 = t.semi_major * Real(p) / n;
      const Real d2 = t.semi_minor * Real(q) / n;
      const Real v1 = dot(v.sliding, t1) - normal_spin * d2;  // (2.22)
      const Real v2 = dot(v.sliding, t2) + normal_spin * d1;
      const Real speed = std::hypot(v1, v2);
      out.max_sliding_speed = std::max(out.max_sliding_speed, speed);
      Real mu = m.coulomb ? *m.coulomb : jacod(m, c.lubricant, t.peak_pressure * root, speed, rolling, central.number);
      if (c.boundary) mu = mu + (*c.boundary - mu) * out.boundary_share;
      ++out.points;
      coefficients += mu;
      if (speed < Real(1e-11L)) continue;  // no direction
      push_1 += mu * root * v1 / speed;
      push_2 += mu * root * v2 / speed;
      spin += mu * root * (v2 * d1 - v1 * d2) / speed;
      power += mu * root * speed;
    }
  out.direction = m.normal - weight * (push_1 * t1 + push_2 * t2);
  out.normal_load = t.axial_load / std::abs(out.direction[2]);
  out.spin_torque = weight * out.normal_load * spin;
  out.power = weight * out.normal_load * power;
  out.friction_coefficient = out.points > 0 ? coefficients / out.points : 0;
  return out;
}

/// All results at one slip ratio; signs of forces and torques are those of the thesis.
struct State {
  Real slip_ratio = 0;
  Real ideal_slip_ratio = 0;
  Real optimality_percent = 0;                    ///< (2.19).
  std::vector<ThreadFriction> screw{}, nut{};     ///< Threads of one roller.
  Real screw_sliding_speed = 0;                   ///< |v_I| [m/s].
  Real nut_sliding_speed = 0;                     ///< |v_J| [m/s].
  Real screw_rolling_speed = 0;                   ///< |u_I| in the contact plane [m/s].
  Real nut_rolling_speed = 0;                     ///< |u_J| in the contact plane [m/s].
  Real torque_screw = 0, torque_nut = 0;          ///< C_S (3.30), C_N (3.31) [N m].
  Real efficiency = 0;                            ///< H (3.52).
  Real power_loss = 0;                            ///< -W_t of (3.47) [W].
  Real power_loss_input_output = 0;               ///< -W_t of (3.53) [W].
  Real power_screw = 0, power_nut = 0;            ///< All rollers and threads [W].
  Real power_carrier_roller = 0;                  ///< (3.48), all rollers [W].
  Real power_carrier_screw = 0;                   ///< (3.49) [W].
  Real power_carrier_nut = 0;                     ///< (3.50) [W].
  Vec contact_force{};                            ///< Sum of (3.27) over one roller's threads [N].
  Real gear_force_x = 0, gear_force_y = 0;        ///< F_E/R (3.29), (3.28) [N].
  Real carrier_force_x = 0, carrier_force_y = 0;  ///< F_R/P (3.32), (3.26) [N].
  Real centrifugal_force = 0;                     ///< (3.33) [N].
  Real residue = 0;                               ///< Left side of (3.38) [N m].
  Real residue_contact = 0;                       ///< Part of it from m_I, m_J [N m].
  Real residue_spin = 0;                          ///< By C_I, C_J [N m].
  Real residue_carrier = 0;                       ///< By C_P/R [N m].
  Real residue_gear = 0;                          ///< By F_E/R [N m].
  // Results of the bisection only:
  Real residue_low = 0, residue_high = 0;  ///< Close to the two ends of (3.44) [N m].
  bool bracketed = false;                  ///< Whether these two differ in sign.
};

inline State state(const Case& c, Real slip) {
  State s;
  s.slip_ratio = slip;
  s.ideal_slip_ratio = ideal_slip_ratio(c);
  const Real chi = c.standard ? 1 : 0;
  s.optimality_percent = 100 * (slip + chi - 1) / (s.ideal_slip_ratio + chi - 1);

  const Motion vi = motion(c, true, slip);
  const Motion vj = motion(c, false, slip);
  s.screw_sliding_speed = std::sqrt(dot(vi.sliding, vi.sliding));
  s.nut_sliding_speed = std::sqrt(dot(vj.sliding, vj.sliding));
  s.screw_rolling_speed = rolling_speed(vi, c.screw.normal);
  s.nut_rolling_speed = rolling_speed(vj, c.nut.normal);

  // Sums over one roller's threads: force on the roller, moments about its axis and about z.
  Real about_screw_axis = 0, about_nut_axis = 0;
  const auto add = [&](bool screw, const Motion& v, std::vector<ThreadFriction>& threads, Real& about_axis,
                       Real& power) {
    const Interface& m = screw ? c.screw : c.nut;
    for (const Thread& t : m.threads) {
      const ThreadFriction f = friction(c, screw, v, t);
      const Vec force = -f.normal_load * f.direction;
      const Real spin = f.spin_torque * m.normal[2];
      s.contact_force = s.contact_force + force;
      s.residue_contact += (m.x - c.centre_distance) * force[1] - m.y * force[0];
      s.residue_spin += spin;
      about_axis += spin + m.x * force[1] - m.y * force[0];
      power += c.rollers * f.power;
      threads.push_back(f);
    }
  };
  add(true, vi, s.screw, about_screw_axis, s.power_screw);
  add(false, vj, s.nut, about_nut_axis, s.power_nut);

  // Carrier torques with the signs of table 3.2 and (3.37): each brakes.
  const Real lambda = roller_ratio(c, slip);
  const Real c_pr = sign(c.speed) * c.carrier_roller_torque;
  const Real c_ps = -sign(c.speed) * c.carrier_screw_torque;
  const Real c_pn = sign(c.speed) * c.carrier_nut_torque;
  s.power_carrier_roller = -c.rollers * c_pr * lambda * c.speed;
  s.power_carrier_screw = -c_ps * (1 - slip) * c.speed;
  s.power_carrier_nut = c_pn * slip * c.speed;

  // Carrier (3.26), gears (3.28), (3.29), radial force (3.32).
  s.carrier_force_y = (c.rollers * c_pr + c_pn + c_ps) / (c.centre_distance * c.rollers);
  s.gear_force_y = s.carrier_force_y - s.contact_force[1];
  s.gear_force_x = (1 - 2 * chi) * std::abs(s.gear_force_y) * std::tan(c.gear_pressure_angle);
  // Speed of the carrier against the part that does not turn: the nut, or the screw of an inverted mechanism.
  const Real orbit = c.standard ? slip * c.speed : slip * c.speed - c.speed;
  s.centrifugal_force = c.roller_mass * c.centre_distance * orbit * orbit;
  s.carrier_force_x = s.gear_force_x + s.contact_force[0] + s.centrifugal_force;

  // Operating pitch radius of the roller's gear, and the moment on the roller (3.38).
  const Real gear_radius = c.centre_distance * c.gear_ratio / (c.standard ? 1 - c.gear_ratio : 1 + c.gear_ratio);
  s.residue_carrier = c_pr;
  s.residue_gear = (2 * chi - 1) * gear_radius * s.gear_force_y;
  s.residue = s.residue_contact + s.residue_spin + s.residue_carrier + s.residue_gear;

  // (3.30), (3.31).
  s.torque_screw = c.rollers * about_screw_axis - c_ps;
  s.torque_nut = c.rollers * about_nut_axis - c_pn;
  if (c.standard)
    s.torque_nut += c.rollers * (c.centre_distance + gear_radius) * s.gear_force_y;
  else
    s.torque_screw += c.rollers * (c.centre_distance - gear_radius) * s.gear_force_y;

  s.power_loss = s.power_screw + s.power_nut + s.power_carrier_roller + s.power_carrier_screw + s.power_carrier_nut;
  const Real force_on_screw = -c.force_on_nut;  // (3.1)
  if (c.standard) {
    s.efficiency = c.force_on_nut * c.lead / (2 * pi * s.torque_screw);
    s.power_loss_input_output = -(s.efficiency - 1) * s.torque_screw * c.speed;
  } else {
    s.efficiency = force_on_screw * c.lead / (2 * pi * s.torque_nut);
    s.power_loss_input_output = (s.efficiency - 1) * s.torque_nut * c.speed;
  }
  return s;
}

/// The interval (3.44), or, if a driven carrier passes the ideal slip ratio, the rest of 0 to 1.
inline std::pair<Real, Real> bracket(const Case& c) {
  const Real ideal = ideal_slip_ratio(c);
  const bool lags = c.speed * state(c, ideal).residue > 0;
  return c.standard == lags ? std::pair<Real, Real>{0, ideal} : std::pair<Real, Real>{ideal, 1};
}

/// Stationary slip by (3.45), literally, to 1e-17; an imposed slip ratio is used unchanged. Without braking the slip
/// ratio is undetermined: then the ideal one.
inline State solve(const Case& c) {
  if (c.slip_ratio) return state(c, *c.slip_ratio);
  const bool no_friction = c.screw.coulomb == Real(0) && c.nut.coulomb == Real(0);
  if (no_friction && c.carrier_roller_torque == 0 && c.carrier_screw_torque == 0 && c.carrier_nut_torque == 0)
    return state(c, ideal_slip_ratio(c));

  auto [low, high] = bracket(c);
  // At slip ratio 0 (standard) and 1 (inverted) nothing rolls and the film is not defined.
  const Real at_low = state(c, std::max(low, Real(1e-9L))).residue;
  const Real at_high = state(c, std::min(high, 1 - Real(1e-9L))).residue;
  const Real direction = (c.standard ? 1 : -1) * sign(c.speed);
  while (high - low > Real(1e-17L)) {
    const Real middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (direction * state(c, middle).residue < 0 ? low : high) = middle;
  }
  State s = state(c, (low + high) / 2);
  s.residue_low = at_low;
  s.residue_high = at_high;
  s.bracketed = at_low * at_high < 0;
  return s;
}

}  // namespace plain
