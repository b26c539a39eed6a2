#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "contact/mechanism_geometry.h"

namespace {

using namespace contact;

constexpr double mm = 1e-3;
constexpr double deg = std::numbers::pi / 180.0;

/// The inverted screw of Abevi 2015, and a standard one whose two contacts both lie off the line
/// of centres (Sandu 2018, table 1.6, example 1, centre distance 0.02 mm larger).
MechanismGeometry mechanism(bool inverted) {
  const auto thread = [](double radius, double lead, double pitch, double arc, bool internal) {
    Thread t;
    t.internal = internal;
    t.pitch_radius = radius;
    t.lead = lead;
    t.pitch = pitch;
    t.flank_angle = 45 * deg;
    t.profile_curvature = arc;
    return t;
  };
  const double s = std::sin(45 * deg);
  if (inverted) {
    const double p = 5 * mm / 3;
    return {MechanismType::inverted, thread(10.5 * mm, 3 * p, p, 0, false),
            thread(3.5 * mm, -p, p, s / (3.5 * mm), false), thread(17.5 * mm, 3 * p, p, 0, true), 14 * mm};
  }
  const double p = 2 * mm;
  return {MechanismType::standard, thread(15 * mm, 5 * p, p, 0, false), thread(5 * mm, p, p, s / (5 * mm), false),
          thread(25.05 * mm, 5 * p, p, 0, true), 20.02 * mm};
}

void EllipticityOnly(benchmark::State& state) {
  double ratio = 0.3;
  for (auto _ : state) {
    ratio = ratio < 0.5 ? ratio + 1e-9 : 0.3;
    benchmark::DoNotOptimize(ellipticity(ratio));
  }
}
BENCHMARK(EllipticityOnly);

void HertzConstantsOnly(benchmark::State& state) {
  double kappa = 150.0;
  for (auto _ : state) {
    kappa = kappa < 200.0 ? kappa + 1e-6 : 150.0;
    benchmark::DoNotOptimize(hertz_constants(kappa, 210.0, 115e9));
  }
}
BENCHMARK(HertzConstantsOnly);

void ContactPointOnly(benchmark::State& state) {
  ThreadPair pair = nut_pair(mechanism(true));
  for (auto _ : state) {
    benchmark::DoNotOptimize(pair);
    benchmark::DoNotOptimize(find_contact_point(pair, RollerFace::bottom));
  }
}
BENCHMARK(ContactPointOnly);

/// All geometric inputs of the load distribution of one mechanism: points, curvatures, ellipticity and Hertz constants
/// of both interfaces, from the drawing. Target: 6 us.
void BothInterfaces(benchmark::State& state) {
  MechanismGeometry m = mechanism(state.range(0) == 0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(m);
    const MechanismContact contact = mechanism_contact(m, Configuration::i1_j2);
    benchmark::DoNotOptimize(hertz_constants(contact.screw.relative.first, contact.screw.relative.second, 115e9));
    benchmark::DoNotOptimize(hertz_constants(contact.nut.relative.first, contact.nut.relative.second, 115e9));
  }
}
BENCHMARK(BothInterfaces)->ArgName("standard")->Arg(0)->Arg(1);

void DesignByBacklash(benchmark::State& state) {
  MechanismGeometry draft = mechanism(false);
  for (auto _ : state) {
    benchmark::DoNotOptimize(draft);
    benchmark::DoNotOptimize(design_by_backlash(draft, 5, 1, {0.01 * mm, 0.02 * mm}));
  }
}
BENCHMARK(DesignByBacklash);

void SubsurfaceShearOnly(benchmark::State& state) {
  double k = 0.7;
  for (auto _ : state) {
    k = k < 0.9 ? k + 1e-6 : 0.7;
    benchmark::DoNotOptimize(largest_subsurface_shear(k, 0.3));
  }
}
BENCHMARK(SubsurfaceShearOnly);

}  // namespace
