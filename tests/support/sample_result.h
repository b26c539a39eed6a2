#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include "prs/loads/result.h"

namespace test {

using prs::Direction, prs::InterfaceLoads, prs::LoadCase, prs::LoadCaseResult, prs::Result;

/// Loads that decay from thread to thread and sum to the force, with plausible ellipses.
inline InterfaceLoads decaying_loads(double force, int threads, double decay) {
  InterfaceLoads loads;
  loads.hertz_constant = 1.14e10;
  loads.normal_angle = std::numbers::pi / 4;
  double sum = 0.0;
  for (int k = 0; k < threads; ++k) sum += std::exp(-decay * k);
  for (int k = 0; k < threads; ++k) {
    const double rate = std::exp(-decay * k) / sum;
    const double axial = rate * force / 11;
    const double normal = axial / std::cos(loads.normal_angle);
    const double a = 2.9e-5 * std::cbrt(normal);
    loads.load_rate.push_back(rate);
    loads.axial_load.push_back(axial);
    loads.normal_load.push_back(normal);
    loads.approach.push_back(std::pow(normal / *loads.hertz_constant, 2.0 / 3.0));
    loads.semi_major.push_back(a);
    loads.semi_minor.push_back(0.8 * a);
    loads.peak_pressure.push_back(1.5 * normal / (std::numbers::pi * 0.8 * a * a));
  }
  return loads;
}

inline LoadCaseResult solved_case(std::string name, double force, Direction direction, int threads = 20) {
  LoadCaseResult result;
  result.load_case.name = std::move(name);
  result.load_case.axial_force = force;
  result.load_case.direction = direction;
  result.load_case.position = 4e-3;
  result.solve = fe::NewtonSummary{.status = fe::NewtonStatus::converged,
                                   .initial_relative_residual = 0.25,
                                   .relative_residual = 2.5e-13,
                                   .energy = -1.25,
                                   .history = {{-1.0, 1e-3, 1.0, 0.0}, {-1.25, 2.5e-13, 1.0, 0.0}}};
  result.axial_stiffness = 8e8 * std::cbrt(force / 45e3);
  result.tangent_stiffness = 1.5 * *result.axial_stiffness;
  result.axial_displacement = force / *result.axial_stiffness;
  const double decay = 0.05 * std::cbrt(force / 45e3);
  result.threads = {decaying_loads(force, threads, decay), decaying_loads(force, threads, sense(direction) * -decay)};
  return result;
}

inline LoadCaseResult failed_case(std::string name) {
  LoadCaseResult result;
  result.load_case.name = std::move(name);
  result.load_case.axial_force = 45e3;
  result.load_case.direction = Direction::compression;
  result.load_case.position = 4e-3;
  result.solve = fe::NewtonSummary{.status = fe::NewtonStatus::line_search_failed,
                                   .relative_residual = 3.25e-5,
                                   .history = {{-1.0, 3.25e-5, 0.5, 1e-6}}};
  return result;
}

/// A case with equal shares and without ellipses, which was not solved.
inline LoadCaseResult equal_share_case(std::string name) {
  LoadCaseResult result;
  result.load_case.name = std::move(name);
  result.load_case.axial_force = 20e3;
  result.load_case.share = LoadCase::Share::equal;
  InterfaceLoads loads = decaying_loads(20e3, 4, 0.0);
  loads.semi_major = loads.semi_minor = loads.peak_pressure = {};
  result.threads = {loads, loads};
  return result;
}

/// The range NAME[0] .. NAME[points-1] up to 45 kN.
inline void add_sweep(Result& result, const std::string& name, Direction direction, int points) {
  for (int k = 0; k < points; ++k)
    result.load_cases.push_back(solved_case(name + '[' + std::to_string(k) + ']', 45e3 * (k + 1) / points, direction));
}

/// Nine loads in tension, then in compression, of each configuration.
inline Result sweeps(std::initializer_list<std::string> configurations) {
  Result result;
  for (const std::string& name : configurations) {
    add_sweep(result, name + "-tension", Direction::tension, 9);
    add_sweep(result, name + "-compression", Direction::compression, 9);
  }
  return result;
}

}  // namespace test
