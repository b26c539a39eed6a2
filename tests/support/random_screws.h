#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "contact/mechanism_geometry.h"

namespace test {

/// A screw and the inputs that a study varies about it, as in a case file. SI units.
struct Screw {
  /// A drawn input: its path, unit and interval.
  struct Drawn {
    std::string path;
    std::string unit;
    double from = 0.0;
    double to = 0.0;
    bool logarithmic = false;
  };

  bool standard = false;
  double hand = 1.0;
  int starts = 3;
  double pitch = 0.0;
  double flank_angle = 0.0;  ///< [rad]
  contact::PitchRadii radius;
  bool designed = false;  ///< Whether it is given by its backlash, else by its radii.
  double profile_radius = 0.0;
  int rollers = 1;
  int threads = 1;
  double bore = 0.0, free_length = 0.0, end_length = 0.0, end_diameter = 0.0;
  std::string guidance = "both_end_nodes";
  std::string rings, bearings;  ///< Parts of a full mechanism.
  double nut_length = 0.0, nut_diameter = 0.0;
  bool flanges = false;
  double thrust_tension = 0.0, thrust_compression = 0.0;
  double position = 0.0;
  double screw_modulus = 0.0, roller_modulus = 0.0, nut_modulus = 0.0;
  bool overridden = false;  ///< Whether constants and angles of the contacts are given.
  double screw_constant = 0.0, nut_constant = 0.0;
  double screw_angle = 0.0, nut_angle = 0.0;
  std::string deviations;
  std::string model;  ///< Entries of `model`, on one line.
  double force = 0.0;
  bool exchanged = false;  ///< Whether compression comes first, then tension.
  std::string more;        ///< Blocks for slip.
  std::vector<Drawn> drawn;

  double screw_area() const { return std::numbers::pi * (radius.screw * radius.screw - 0.25 * bore * bore); }
  double nut_area() const { return std::numbers::pi * (0.25 * nut_diameter * nut_diameter - radius.nut * radius.nut); }

  /// Whether threads may touch later than others.
  bool has_gaps() const {
    return !deviations.empty() ||
           std::ranges::any_of(drawn, [](const Drawn& d) { return d.path.starts_with("deviations"); });
  }

  /// The case with its study.
  std::string text(const std::string& command, int samples, std::uint64_t seed,
                   const std::vector<std::string>& responses) const {
    const auto m = [](double x) { return fmt::format("{} m", x); };
    const contact::PitchRadii& r = radius;
    std::string t = fmt::format(
        "mechanism:\n  type: {}\n  lead: {}\n  starts: {{screw: {}, roller: 1}}\n"
        "  flank_angle: {} rad\n",
        standard ? "standard" : "inverted", m(hand * starts * pitch), starts, flank_angle);
    if (designed)
      t += fmt::format(
          "  geometry: design\n  pitch_diameter: {{screw: {}}}\n  backlash: {{screw: {}, nut: "
          "{}}}\n",
          m(2 * r.screw), m(2e-3 * pitch), m(3e-3 * pitch));
    else
      t += fmt::format("  pitch_diameter: {{screw: {}, roller: {}, nut: {}}}\n  centre_distance: {}\n", m(2 * r.screw),
                       m(2 * r.roller), m(2 * r.nut), m(r.screw + r.roller));
    t += fmt::format(
        "  profile: {{screw: straight, roller: {{convex: {}}}, nut: straight}}\n"
        "  rollers: {}\n  contacts_per_roller: {}\n",
        m(profile_radius), rollers, threads);
    t += fmt::format(
        "structure:\n  screw: {{bore: {}, free_length: {}{}}}\n"
        "  roller: {{end_length: {}, end_diameter: {}, guidance: {}{}}}\n"
        "  nut:\n    length: {}\n    outer_diameter: {}\n    thrust: {{tension: {}, compression: "
        "{}}}\n",
        m(bore), m(free_length), bearings.empty() ? "" : ", bearings: " + bearings, m(end_length), m(end_diameter),
        guidance, rings.empty() ? "" : ", rings: " + rings, m(nut_length), m(nut_diameter), m(thrust_tension),
        m(thrust_compression));
    if (flanges)
      t += fmt::format(
          "    flanges: [{{from: 0 m, to: {0}, outer_diameter: {2}}}, {{from: {1}, to: {3}, "
          "outer_diameter: {2}}}]\n",
          m(thrust_tension), m(thrust_compression), m(1.35 * nut_diameter), m(nut_length));
    t += fmt::format(
        "materials:\n  screw: {{youngs_modulus: {} Pa, poisson_ratio: 0.3, density: 7810 kg/m^3}}\n"
        "  roller: {{youngs_modulus: {} Pa, poisson_ratio: 0.3, density: 7810 kg/m^3}}\n"
        "  nut: {{youngs_modulus: {} Pa, poisson_ratio: 0.3, density: 7810 kg/m^3}}\n",
        screw_modulus, roller_modulus, nut_modulus);
    if (overridden)
      t += fmt::format(
          "contact:\n  hertz_constant: {{screw: {} N/m^1.5, nut: {} N/m^1.5}}\n"
          "  normal_angle: {{screw: {} rad, nut: {} rad}}\n",
          screw_constant, nut_constant, screw_angle, nut_angle);
    if (!deviations.empty()) t += "deviations: " + deviations + "\n";
    if (!model.empty()) t += "model: {" + model + "}\n";
    t += more;
    const char* directions[] = {"tension", "compression"};
    t += "load_cases:\n";
    for (const int k : {0, 1})
      t += fmt::format("  - {{name: {0}, axial_force: {1} N, direction: {0}, position: {2}}}\n",
                       directions[exchanged ? 1 - k : k], force, m(position));
    t += fmt::format("study:\n  command: {}\n  plan: monte_carlo\n  samples: {}\n  seed: {}\n", command, samples, seed);
    t += "  factors:\n";
    for (const Drawn& d : drawn)
      t += fmt::format("    - {{path: '{}', {}: {{from: {} {}, to: {} {}}}}}\n", d.path,
                       d.logarithmic ? "log_uniform" : "uniform", std::min(d.from, d.to), d.unit,
                       std::max(d.from, d.to), d.unit);
    t += "  responses: [";
    for (const std::string& response : responses) t += "'" + response + "', ";
    return t + "]\n";
  }
};

/// Mirror image of the screw, of the other hand.
inline Screw left_handed(Screw s) {
  s.hand = -s.hand;
  return s;
}

/// Copy with screw and nut exchanged, for bars whose contacts are given and whose nut is held before its first contact:
/// in the frame of the other body, a pull on one is a push on the other.
inline Screw swapped(Screw s) {
  const double screw = s.screw_modulus * s.screw_area(), nut = s.nut_modulus * s.nut_area();
  const double held = s.position - s.thrust_tension;
  for (Screw::Drawn& d : s.drawn) {
    const double scale = d.path == "materials.screw.youngs_modulus" ? s.screw_area() / s.nut_area()
                         : d.path == "materials.nut.youngs_modulus" ? s.nut_area() / s.screw_area()
                                                                    : 1.0;
    d.from *= scale, d.to *= scale;
    for (const char* path : {"materials.{}.youngs_modulus", "contact.hertz_constant.{}", "contact.normal_angle.{}"}) {
      const std::string of_screw = fmt::format(fmt::runtime(path), "screw");
      const std::string of_nut = fmt::format(fmt::runtime(path), "nut");
      if (d.path == of_screw)
        d.path = of_nut;
      else if (d.path == of_nut)
        d.path = of_screw;
    }
  }
  s.screw_modulus = nut / s.screw_area();
  s.nut_modulus = screw / s.nut_area();
  std::swap(s.screw_constant, s.nut_constant);
  std::swap(s.screw_angle, s.nut_angle);
  s.thrust_tension = s.thrust_compression = s.position - s.free_length;
  s.free_length = held;
  s.exchanged = !s.exchanged;
  return s;
}

/// Screws from 6 to 150 mm as makers build them: both types, all the guides, the rollers at either end and in the
/// middle of the nut, loads from those that leave threads open to those that indent them.
class RandomScrews {
 public:
  explicit RandomScrews(std::uint64_t seed) : random_(seed) {}

  enum class Kind { any, swappable };

  Screw next(Kind kind = Kind::any) {
    Screw s;
    s.standard = chance();
    s.starts = s.standard ? whole(4, 8) : whole(2, 8);
    s.hand = chance() ? 1.0 : -1.0;
    s.radius =
        contact::matched_pitch_radii(s.standard ? contact::MechanismType::standard : contact::MechanismType::inverted,
                                     log(3e-3, 75e-3), s.starts, 1);
    s.pitch = std::clamp(uniform(0.15, 0.45) * s.radius.roller, 0.2e-3, 6e-3);
    s.flank_angle = uniform(0.66, 0.88);
    s.profile_radius = s.radius.roller / std::sin(s.flank_angle) * uniform(0.7, 1.3);
    s.designed = kind == Kind::any && chance();
    const double crest = s.radius.roller + 0.3 * s.pitch;
    const int most =
        static_cast<int>(std::numbers::pi / std::asin(std::min(1.0, crest / (s.radius.screw + s.radius.roller))));
    s.rollers = whole(std::min(3, most), most);
    s.threads = whole(5, 60);

    s.bore = chance() ? 0.0 : uniform(0.1, 1.0) * s.radius.screw;
    s.free_length = uniform(0.0, 4.0) * s.radius.screw;
    s.end_length = uniform(1.0, 3.0) * s.pitch;
    s.end_diameter = uniform(1.0, 1.7) * s.radius.roller;
    const double roller_bending = 2e11 * s.radius.roller;
    const char* guidances[] = {"both_end_nodes", "outer_node", "ring"};
    s.guidance = guidances[whole(0, 2)];
    if (s.guidance == "ring") s.guidance = fmt::format("{{ring: {} N/m}}", roller_bending * log(1e-4, 1.0));

    // CONFIG 1 to 3 of Abevi: at the far end of the nut, in its middle, at its near end.
    const double contacts = (s.threads - 1) * s.pitch;
    s.nut_diameter = 2.0 * s.radius.nut * uniform(1.2, 1.6);
    s.thrust_tension = uniform(1.0, 6.0) * s.pitch;
    s.nut_length = contacts + uniform(10.0, 60.0) * s.pitch;
    s.thrust_compression = s.nut_length - s.thrust_tension;
    s.flanges = chance();
    const double room = s.nut_length - contacts;
    s.position = uniform(0.0, 0.999) * room;
    const double places[] = {0.05 * room, 0.5 * room, 0.95 * room};

    for (double* modulus : {&s.screw_modulus, &s.roller_modulus, &s.nut_modulus}) *modulus = uniform(195e9, 215e9);
    // Hertz contact of a ball of the profile's radius on a plane.
    const double least = load_at(0.1e9, s), most_load = load_at(4e9, s);
    s.force = std::sqrt(least * most_load);

    s.drawn = {{"materials.screw.youngs_modulus", "Pa", 195e9, 215e9},
               {"materials.nut.youngs_modulus", "Pa", 195e9, 215e9},
               {"load_cases[0].axial_force", "N", least, most_load, true},
               {"load_cases[1].axial_force", "N", least, most_load, true},
               {"materials.roller.youngs_modulus", "Pa", 195e9, 215e9},
               {"structure.roller.end_length", "m", s.pitch, 3.0 * s.pitch},
               {"structure.roller.end_diameter", "m", s.radius.roller, 1.7 * s.radius.roller}};
    if (kind == Kind::swappable) {
      s.flanges = false;
      s.position = std::max(places[whole(0, 2)], 1.001 * s.thrust_tension);
      s.thrust_compression = s.thrust_tension;
      s.free_length = uniform(0.0, 1.0) * s.position;
      s.overridden = true;
      s.screw_constant = log(5e9, 5e10), s.nut_constant = log(5e9, 5e10);
      s.screw_angle = uniform(0.66, 0.88), s.nut_angle = uniform(0.66, 0.88);
      for (const char* part : {"screw", "nut"}) {
        s.drawn.push_back({fmt::format("contact.hertz_constant.{}", part), "N/m^1.5", 5e9, 5e10});
        s.drawn.push_back({fmt::format("contact.normal_angle.{}", part), "rad", 0.66, 0.88});
      }
    } else {
      s.drawn.push_back({"mechanism.flank_angle", "rad", 0.99 * s.flank_angle, 1.01 * s.flank_angle});
      s.drawn.push_back({"structure.nut.outer_diameter", "m", 2.4 * s.radius.nut, 3.2 * s.radius.nut});
      if (s.flanges) s.drawn.pop_back();
      s.drawn.push_back({"structure.screw.free_length", "m", 0.0, 4.0 * s.radius.screw});
      s.drawn.push_back({"load_cases[0].position", "m", 0.0, 0.999 * room});
      s.drawn.push_back({"load_cases[1].position", "m", 0.0, 0.999 * room});
      if (s.position != 0.0) s.position = places[whole(0, 2)];
    }
    return s;
  }

  /// Axial force at which a mean thread has a peak pressure.
  static double load_at(double pressure, const Screw& s) {
    const double modulus = 115e9;
    return s.rollers * s.threads * std::sin(s.flank_angle) * std::pow(std::numbers::pi * pressure, 3) *
           std::pow(s.profile_radius, 2) / (6.0 * modulus * modulus);
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  double log(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  bool chance() { return whole(0, 1) == 1; }

 private:
  std::mt19937_64 random_;
};

}  // namespace test
