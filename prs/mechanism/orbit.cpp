#include "prs/mechanism/orbit.h"

namespace prs {
namespace {

/// Loads that differ by less are the same load, as rounding has it.
constexpr double kSameLoad = 1e-9;

class Collector {
 public:
  Collector(const FullModel& f, const SpatialLoad::Orbit& wanted) : f_(f) {
    orbit_.steps = wanted.steps;
    orbit_.positions = wanted.steps * f.rollers;
    orbit_.exponent = wanted.exponent;
    for (const Interface i : kInterfaces) {
      orbit_.loads[i].equivalent = orbit_.loads[i].peak =
          RollerThreads(static_cast<std::size_t>(f.rollers),
                        std::vector<double>(static_cast<std::size_t>(f.threads()), 0.0));
      orbit_.loads[i].least = std::numeric_limits<double>::infinity();
    }
  }

  /// Roller j carries what roller j + shift does in the distribution.
  void add(const FullDistribution& d, int shift, double carrier_angle) {
    const double share = 1.0 / orbit_.positions;
    orbit_.carrier_angle.push_back(carrier_angle);
    for (const Interface i : kInterfaces) {
      OrbitLoads& loads = orbit_.loads[i];
      const int first = (f_.present.front().number + shift) % f_.rollers;
      loads.first_roller.push_back(
          std::ranges::max(d.normal_load[i][static_cast<std::size_t>(first)]));
      for (const FullModel::Roller& r : f_.present) {
        const auto j = static_cast<std::size_t>(r.number);
        const auto from = static_cast<std::size_t>((r.number + shift) % f_.rollers);
        for (std::size_t k = 0; k < loads.equivalent[j].size(); ++k) {
          const double load = d.normal_load[i][from][k];
          loads.equivalent[j][k] += share * std::pow(load, orbit_.exponent);
          loads.peak[j][k] = std::max(loads.peak[j][k], load);
          loads.least = std::min(loads.least, load);
          if (load <= loads.largest * (1.0 + kSameLoad)) continue;
          loads.largest = load;
          loads.carrier_angle = carrier_angle;
          loads.roller = r.number + 1;
          loads.thread = static_cast<int>(k) + 1;
        }
      }
    }
  }

  Orbit finished(std::vector<double> displacement) && {
    for (const Interface i : kInterfaces)
      for (std::vector<double>& roller : orbit_.loads[i].equivalent)
        for (double& load : roller) {
          load = std::pow(load, 1.0 / orbit_.exponent);
          orbit_.loads[i].largest_equivalent = std::max(orbit_.loads[i].largest_equivalent, load);
        }
    const auto [least, largest] = std::ranges::minmax(displacement);
    orbit_.axial_error = largest - least;
    orbit_.axial_displacement = std::move(displacement);
    return std::move(orbit_);
  }

 private:
  const FullModel& f_;
  Orbit orbit_;
};

}  // namespace

Orbit orbit(const std::function<FullModel(double)>& model,
            const std::function<FullDistribution(const FullModel&)>& solver,
            const SpatialLoad::Orbit& wanted, double carrier_angle, OrbitSymmetry symmetry) {
  const FullModel first = model(carrier_angle);
  const int positions = wanted.steps * first.rollers;
  const auto angle = [&](int m) { return carrier_angle + 2.0 * std::numbers::pi * m / positions; };
  const int different = symmetry.alike ? wanted.steps : positions;
  const auto solved_at = [&](int m) {
    return static_cast<std::size_t>(symmetry.round ? 0 : m % different);
  };
  std::vector<FullDistribution> solved;
  std::vector<double> displacement;
  for (int m = 0; m < different; ++m) {
    if (solved_at(m) == solved.size()) solved.push_back(solver(model(angle(m))));
    if (const FullDistribution& d = solved.back(); !d.solve.converged()) {
      Orbit failed;
      failed.failure = {angle(m),
                        d.reason.empty() ? std::string(fe::name(d.solve.status)) : d.reason};
      return failed;
    }
    displacement.push_back(solved[solved_at(m)].axial_displacement);
  }
  Collector collector(first, wanted);
  for (int m = 0; m < positions; ++m)
    collector.add(solved[solved_at(m)], symmetry.round ? 0 : m / different, angle(m));
  return std::move(collector).finished(std::move(displacement));
}

}  // namespace prs
