#include "prs/compare/comparison_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/loads/load_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

struct ComparedLoad {
  const ModelComparison* comparison = nullptr;
  std::size_t load_case = 0;

  const LoadCaseResult& best() const { return comparison->best().load_cases[load_case]; }
  const LoadCase& load() const { return best().load_case; }
};

/// Threads of one interface.
struct MostLoaded {
  const InterfaceLoads* loads = nullptr;
  int threads_per_roller = 0;

  const std::vector<double>& shares() const { return loads->load_rate; }
};

std::optional<double> largest_of(const std::vector<double>& values) {
  return entry(values, index_of_largest(values));
}

std::optional<double> over(std::optional<double> value, std::optional<double> best) {
  if (!value || !best || *best == 0.0) return std::nullopt;
  return *value / *best;
}

std::optional<MostLoaded> most_loaded(const ComparedModel& m, Interface i) {
  if (!m.result().threads) return std::nullopt;
  const InterfaceLoads& loads = (*m.result().threads)[i];
  return MostLoaded{&loads, loads.threads_per_roller};
}

std::vector<std::string> model_names(const ModelComparison& c) {
  std::vector<std::string> names;
  for (const Result& model : c.models) names.emplace_back(name_of_model(model.model));
  return names;
}

}  // namespace

template <>
Record<MostLoaded> record_of();
template <>
Record<ComparedLoad> record_of();

namespace {

constexpr Quantity<MostLoaded> kMostLoaded[] = {
    {"most_loaded_thread",
     of<[](const MostLoaded& m) { return most_loaded_thread(*m.loads).value_or(1); }>,
     "1 is next to the loaded end of the screw"},
    {"most_loaded_roller", of<[](const MostLoaded& m) {
       return m.loads->rollers ? std::optional(m.loads->rollers->largest_roller) : std::nullopt;
     }>,
     "from 1; of a full mechanism"},
    {"largest_load_rate_percent", of<[](const MostLoaded& m) { return largest_of(m.shares()); }>,
     "its share: axial load over force per roller"},
    {"largest_peak_pressure_MPa",
     of<[](const MostLoaded& m) { return largest_of(m.loads->peak_pressure); }>,
     "largest of a thread"},
    {"load_rate_percent", of<&MostLoaded::shares>,
     "share of each thread; of a full mechanism [roller][thread]"},
};

constexpr Quantity<ComparedModel> kModel[] = {
    {"bodies", of<&ComparedModel::model_name>,
     "bars | refined | influence of one sector, or full: all rollers"},
    {"converged", of<[](const ComparedModel& m) { return m.result().converged(); }>,
     "whether there is an equilibrium"},
    {"axial_stiffness_N_per_um",
     of<[](const ComparedModel& m) { return m.result().axial_stiffness; }>,
     "secant: force over displacement"},
    {"stiffness_over_best", of<stiffness_over_best>, "over that of the best model"},
    {"axial_displacement_um",
     of<[](const ComparedModel& m) { return m.result().axial_displacement; }>,
     "of the loaded section; > 0 along the load"},
    {"largest_peak_pressure_MPa",
     of<[](const ComparedModel& m) { return largest_pressure(m.result()); }>,
     "largest of a thread at either interface"},
    {"pressure_over_best", of<pressure_over_best>, "largest over that of the best model"},
    {"screw", of<[](const ComparedModel& m) { return most_loaded(m, Interface::screw); }>,
     "threads of one roller at the screw"},
    {"nut", of<[](const ComparedModel& m) { return most_loaded(m, Interface::nut); }>,
     "threads of one roller at the nut"},
};

constexpr Quantity<ComparedLoad> kLoad[] = {
    {"name", of<[](const ComparedLoad& l) -> const std::string& { return l.load().name; }>,
     "as the file has it"},
    {"axial_force_N", of<[](const ComparedLoad& l) { return l.load().axial_force; }>,
     "on the whole screw"},
    {"direction", of<[](const ComparedLoad& l) { return l.load().direction; }>,
     "tension | compression"},
    {"position_mm", of<[](const ComparedLoad& l) { return l.load().position; }>,
     "of the first roller contact on the nut"},
    {"models", of<[](const ComparedLoad& l) {
       std::vector<ComparedModel> models;
       for (std::size_t m = 0; m < l.comparison->models.size(); ++m)
         models.push_back({l.comparison, l.load_case, m});
       return models;
     }>,
     "the best last"},
    {"warnings", of<[](const ComparedLoad& l) { return sentences(l.best().warnings); }>,
     "what is unusual about this load, by the best model"},
};

constexpr Quantity<ModelComparison> kComparison[] = {
    {"models", of<model_names>,
     "that were compared: bars | refined | influence, or one of them | full; the best last"},
    {"load_cases", of<[](const ModelComparison& c) {
       std::vector<ComparedLoad> loads;
       for (std::size_t k = 0; k < c.load_cases(); ++k) loads.push_back({&c, k});
       return loads;
     }>,
     "those that are solved, not of equal shares"},
};

}  // namespace

std::optional<std::size_t> most_loaded_thread(const InterfaceLoads& loads) {
  if (loads.rollers) return static_cast<std::size_t>(loads.rollers->largest_thread);
  const auto thread = index_of_largest(loads.load_rate);
  return thread ? std::optional(*thread + 1) : std::nullopt;
}

std::optional<double> largest_pressure(const LoadCaseResult& result) {
  if (!result.threads) return std::nullopt;
  const std::optional<double> screw = largest_of(result.threads->screw.peak_pressure);
  const std::optional<double> nut = largest_of(result.threads->nut.peak_pressure);
  return screw && nut ? std::max(*screw, *nut) : screw ? screw : nut;
}

std::optional<double> stiffness_over_best(const ComparedModel& m) {
  return over(m.result().axial_stiffness, m.best().axial_stiffness);
}

std::optional<double> pressure_over_best(const ComparedModel& m) {
  return over(largest_pressure(m.result()), largest_pressure(m.best()));
}

template <>
Record<MostLoaded> record_of() {
  return {"MostLoadedThread", "What an interface's threads carry, by one model.", kMostLoaded};
}

template <>
Record<ComparedModel> record_of() {
  return {"ComparedModel", "The answer of one model of the bodies to a load case.", kModel};
}

template <>
Record<ComparedLoad> record_of() {
  return {"ComparedLoadCase", "A load case by each model of the bodies.", kLoad};
}

template <>
Record<ModelComparison> record_of() {
  return {"Comparison", "The models of the bodies side by side.", kComparison};
}

}  // namespace prs
