#include "prs/sector/chain/thread_loads.h"

#include "prs/sector/sector.h"

namespace prs {

void ThreadLoads::resize(std::size_t solves, std::size_t threads, bool with_tangent) {
  stride = threads;
  for (const Interface i : kInterfaces) {
    normal_load[i].resize(solves * stride);
    approach[i].resize(solves * stride);
  }
  for (auto* values : {&axial_displacement, &initial_relative_residual, &relative_residual, &energy})
    values->resize(solves);
  tangent_stiffness.resize(with_tangent ? solves : 0);
  status.resize(solves);
  iterations.resize(solves);
}

void ThreadLoads::copy(std::size_t k, double residual_tolerance, LoadDistribution& r) const {
  const auto threads = [&](const std::vector<double>& from, std::vector<double>& to) {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(k * stride);
    to.assign(first, first + static_cast<std::ptrdiff_t>(stride));
  };
  for (const Interface i : kInterfaces) {
    threads(normal_load[i], r.normal_load[i]);
    threads(approach[i], r.approach[i]);
  }
  r.axial_displacement = axial_displacement[k];
  r.tangent_stiffness.reset();
  if (!tangent_stiffness.empty() && tangent_stiffness[k] > 0.0) r.tangent_stiffness = tangent_stiffness[k];
  fe::NewtonSummary& s = r.solve;
  s.status = status[k];
  s.initial_relative_residual = initial_relative_residual[k];
  s.relative_residual = relative_residual[k];
  s.energy = energy[k];
  s.at_rounding = s.converged() && s.relative_residual > residual_tolerance;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  s.history.assign(static_cast<std::size_t>(iterations[k]), {kUnknown, kUnknown, kUnknown, kUnknown});
  if (!s.history.empty()) s.history.back() = {s.energy, s.relative_residual, kUnknown, kUnknown};
}

}  // namespace prs
