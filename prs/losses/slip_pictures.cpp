#include "prs/losses/slip_pictures.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

#include "prs/loads/load_pictures.h"
#include "prs/losses/slip_parts.h"
#include "prs/losses/slip_record.h"

namespace prs {

// Each stands in a file `*_figures.cpp`; absent, or none, where the result holds no data.
Figures roller_power(const Result& result, const FigureOptions& options);
Figures roller_friction(const Result& result, const FigureOptions& options);
Figures thread_friction(const Case& c, const Result& result, const FigureOptions& options);
Figures thread_power(const Result& result, const FigureOptions& options);
Figures friction(const Result& result, const FigureOptions& options);
Figures power_by_source(const Result& result, const FigureOptions& options);
Figures heat_cycle(const Result& result);

namespace {

using enum Picture::Drawn;

constexpr const char* kSlip = "a load case whose slip converged";
constexpr const char* kSlipOfRollers =
    "a load case of `model: {mechanism: full}` whose slip converged";

/// Fields of the load cases, by their index: integrated once for all pictures of them.
using SlipFields = std::map<std::size_t, SlipPictures>;

/// For the load cases whose slip converged, at most four; of several, names end in `_1`, `_2`, ..
auto of_slip(const Result& result, std::function<Figure(std::size_t)> make) {
  return [&result, make = std::move(make)](const FigureOptions& options) {
    constexpr std::size_t kMost = 4;
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < result.load_cases.size() && cases.size() < kMost; ++k)
      if (has_slip(result.load_cases[k]) && (!options.load_case || k == *options.load_case))
        cases.push_back(k);
    Figures figures;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      figures.push_back(make(cases[k]));
      if (cases.size() > 1) figures.back().name += fmt::format("_{}", k + 1);
    }
    return figures;
  };
}

}  // namespace

Pictures slip_pictures(const Case& c, const Result& r) {
  const auto fields = std::make_shared<SlipFields>();
  using OfFields = Figure (*)(const LoadCaseResult&, const SlipPictures&);
  const auto of_fields = [&](OfFields make) {
    return of_slip(r, [&c, &r, fields, make](std::size_t k) {
      if (!fields->contains(k)) fields->emplace(k, slip_pictures(c, r, k));
      return make(r.load_cases[k], fields->at(k));
    });
  };
  const bool mixed = c.friction && c.friction->model == Friction::Model::mixed;
  return with(
      {{"power_by_source", kSlip, of_result(r, power_by_source)},
       {"thread_power", kSlip, of_result(r, thread_power)},
       {"friction", kSlip, of_result(r, friction)},
       {"roller_power", kSlipOfRollers, of_result(r, roller_power)},
       {"roller_friction", kSlipOfRollers, of_result(r, roller_friction)},
       {"stribeck", kSlip,
        of_slip(r,
                [&c, &r](std::size_t k) {
                  return stribeck_figure(r.load_cases[k], stribeck_curve(c, r, k));
                }),
        drawn_if(mixed)},
       {"slip_patches", kSlip, of_fields(slip_patch_figure)},
       {"slip_residue", kSlip, of_fields(slip_residue_figure)},
       {"thread_friction", kSlip,
        [&c, &r](const FigureOptions& options) { return thread_friction(c, r, options); }, by_name},
       {"heat_cycle", "a `duty` in `heat` that comes to repeat itself", of_result(r, heat_cycle)}},
      solve_pictures(r));
}

}  // namespace prs
