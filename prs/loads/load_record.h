#pragma once

#include "prs/loads/result.h"
#include "prs/model/units.h"
#include "prs/record/record.h"

namespace prs {

Record<FrictionForces> record_of(Type<FrictionForces>);
Record<RunningLoads> record_of(Type<RunningLoads>);
Record<RunningLoads::AtRest> record_of(Type<RunningLoads::AtRest>);
Record<InterfaceLoads> record_of(Type<InterfaceLoads>);
Record<RollerShares> record_of(Type<RollerShares>);
Record<FullLoads> record_of(Type<FullLoads>);
Record<fe::NewtonIteration> record_of(Type<fe::NewtonIteration>);
Record<LoadCaseResult> record_of(Type<LoadCaseResult>);

/// How the solve of a case ended; equal shares need no solve and count as converged.
inline std::string_view status_name(const LoadCaseResult& result) {
  if (result.running) return name(result.running->status);
  return fe::name(result.solve ? result.solve->status : fe::NewtonStatus::converged);
}

/// Index of the largest value; absent where there is none.
inline std::optional<std::size_t> index_of_largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto largest = std::max_element(values.begin(), values.end());
  return static_cast<std::size_t>(largest - values.begin());
}

/// The entry of a thread; absent where the list has none.
inline std::optional<double> entry(const std::vector<double>& values,
                                   std::optional<std::size_t> thread) {
  return thread && *thread < values.size() ? std::optional(values[*thread]) : std::nullopt;
}

}  // namespace prs
