#include "prs/model/check_case.h"

#include <utility>

#include "prs/model/block_checks.h"

namespace prs {

std::vector<Problem> check_case(const Case& c) {
  Problems problems;
  check_threads(c.mechanism, problems);
  check_bodies(c, problems);
  check_meshing(c.mechanism, problems);
  if (c.structure) check_structure(*c.structure, c.mechanism, problems);
  check_load_cases(c, problems);
  check_loads(c, problems);
  check_thickness(c, problems);
  check_deviations(c, problems);
  check_full_mechanism(c, problems);
  if (c.preload) check_preload(c, problems);
  if (c.life) check_life(c, problems);
  if (c.lubricant) check_lubricant(*c.lubricant, c.heat, problems);
  check_carrier(c.carrier, problems);
  if (c.heat) check_heat(c, problems);
  if (c.measures) check_measures(*c.measures, problems);
  return std::move(problems).take();
}

}  // namespace prs
