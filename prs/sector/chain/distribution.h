#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/load_distribution.h"

namespace prs {

/// Results of a chain kernel for many solves, as `ThreadLoads` with memory of its own.
class ThreadLoadBuffer {
 public:
  void resize(std::size_t solves, std::size_t stride) {
    stride_ = stride;
    for (const Interface i : kInterfaces) {
      normal_load_[i].resize(solves * stride);
      approach_[i].resize(solves * stride);
    }
    for (auto* values :
         {&axial_displacement_, &tangent_stiffness_, &initial_, &residual_, &energy_})
      values->resize(solves);
    status_.resize(solves);
    iterations_.resize(solves);
  }

  ThreadLoads view() {
    return {{normal_load_.screw, normal_load_.nut},
            {approach_.screw, approach_.nut},
            stride_,
            axial_displacement_,
            tangent_stiffness_,
            status_,
            iterations_,
            initial_,
            residual_,
            energy_};
  }

  /// Solve k to `place` of `r`.
  void copy(std::size_t k, int contacts, std::size_t place, const ThreadLoads& r) const {
    const auto threads = [&](const std::vector<double>& from, std::span<double> to) {
      const auto first = from.begin() + static_cast<std::ptrdiff_t>(k * stride_);
      if (!to.empty())
        std::copy(first, first + contacts,
                  to.begin() + static_cast<std::ptrdiff_t>(place * r.stride));
    };
    for (const Interface i : kInterfaces) {
      threads(normal_load_[i], r.normal_load[i]);
      threads(approach_[i], r.approach[i]);
    }
    const auto number = [&](const auto& from, auto to) {
      if (!to.empty()) to[place] = from[k];
    };
    number(axial_displacement_, r.axial_displacement);
    number(tangent_stiffness_, r.tangent_stiffness);
    number(status_, r.status);
    number(iterations_, r.iterations);
    number(initial_, r.initial_relative_residual);
    number(residual_, r.relative_residual);
    number(energy_, r.energy);
  }

  /// Solve k as a LoadDistribution. Of the history only the last iteration's outcome is known.
  void copy(std::size_t k, int contacts, double residual_tolerance, LoadDistribution& r) const {
    for (const Interface i : kInterfaces) {
      const auto copy = [&](const std::vector<double>& from, std::vector<double>& to) {
        const auto first = from.begin() + static_cast<std::ptrdiff_t>(k * stride_);
        to.assign(first, first + contacts);
      };
      copy(normal_load_[i], r.normal_load[i]);
      copy(approach_[i], r.approach[i]);
    }
    r.axial_displacement = axial_displacement_[k];
    r.tangent_stiffness.reset();
    if (tangent_stiffness_[k] > 0.0) r.tangent_stiffness = tangent_stiffness_[k];

    fe::NewtonSummary& s = r.solve;
    s.status = status_[k];
    s.initial_relative_residual = initial_[k];
    s.relative_residual = residual_[k];
    s.energy = energy_[k];
    s.at_rounding = s.converged() && s.relative_residual > residual_tolerance;
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    s.history.assign(static_cast<std::size_t>(iterations_[k]),
                     {kUnknown, kUnknown, kUnknown, kUnknown});
    if (!s.history.empty()) s.history.back() = {s.energy, s.relative_residual, kUnknown, kUnknown};
  }

 private:
  PerInterface<std::vector<double>> normal_load_, approach_;
  std::vector<double> axial_displacement_, tangent_stiffness_, initial_, residual_, energy_;
  std::vector<fe::NewtonStatus> status_;
  std::vector<int> iterations_;
  std::size_t stride_ = 0;
};

}  // namespace prs
