#include <fmt/format.h>

#include "modules/fit/fit_reader.h"
#include "prs/bodies/all_rollers.h"
#include "prs/cli/commands.h"
#include "prs/cli/export.h"
#include "prs/cli/report.h"
#include "prs/cli/resources.h"
#include "prs/cli/size.h"
#include "prs/cli/study.h"
#include "prs/compare/compare_analysis.h"
#include "prs/configurations/configurations_files.h"
#include "prs/heat/analyze_heat.h"
#include "prs/life/life_record.h"
#include "prs/loads/full_result.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/measures/measures_criteria.h"
#include "prs/reference/referenced_analyses.h"
#include "prs/run/analyses.h"
#include "prs/run/check.h"
#include "prs/run/compare_cases.h"
#include "prs/run/response_lists.h"
#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/influence/influence_solver.h"
#include "prs/size/requirement.h"

/// Functions of rooms that the light program omits (PRS_FULL): each throws an error with the missing command.
namespace prs {
namespace {

using modules::NotBuilt;

AnyAnalysis left_out(Command command, std::string_view help, bool is_judged = false) {
  const std::string what = fmt::format("prs {}", name(command));
  return {.command = command,
          .help = help,
          .run = [what](const input::Source&, const input::CaseInput&) -> Delivery { throw NotBuilt(what); },
          .is_built = false,
          .is_judged = is_judged};
}

/// Replaces any omitted function of a requirement.
template <class Result, class... Arguments>
using Function = Result (*)(Arguments...);
constexpr struct {
  template <class Result, class... Arguments>
  constexpr operator Function<Result, Arguments...>() const {
    return [](Arguments...) -> Result { throw NotBuilt("prs size"); };
  }
} kRefusesSize;

[[noreturn]] int refused(const char* command) { throw NotBuilt(fmt::format("prs {}", command)); }
}  // namespace

std::span<const AnyAnalysis> analyses() {
  static const AnyAnalysis all[] = {
      any(check_analysis()),
      any(contact_analysis()),
      any(solve_analysis()),
      any(compare_analysis()),
      any(slip_analysis()),
      left_out(Command::preload, "Closure, stiffness and lost motion of a preloaded nut"),
      left_out(Command::life, "Life and static safety", true),
      left_out(Command::measures, "Weight, stiffness terms, buckling, critical speed, capacities", true),
      left_out(Command::response, "The screw in its drive over time", true),
      left_out(Command::study, "Many designs"),
      left_out(Command::optimize, "The best design"),
      left_out(Command::fit, "Unknown inputs from measured curves"),
  };
  return all;
}

std::span<const AnyAnalysis> referenced_analyses() {
  static const AnyAnalysis all[] = {any(solve_analysis()), any(slip_analysis()), any(contact_analysis())};
  return all;
}

std::span<const OtherFile> other_files() {
  static const OtherFile all[] = {{.command = Command::size,
                                   .help = "A screw and a motor for a motion, a life and a stroke",
                                   .name = "requirement",
                                   .key = "motion",
                                   .run = kRefusesSize,
                                   .check = kRefusesSize,
                                   .schema = kRefusesSize,
                                   .resolved_input = kRefusesSize,
                                   .files = kRefusesSize,
                                   .record = kRefusesSize}};
  return all;
}

std::span<const DocumentForm> document_forms() {
  static const DocumentForm all[] = {{"configurations", describe<Configurations>}};
  return all;
}

std::string_view left_out(const Case& c) {
  if (c.model.all_rollers()) return "model.mechanism: full";
  if (c.model.bodies->meshes) return "model.bodies: influence";
  return c.heat ? "heat" : "";
}

// Bodies and mechanisms.
FullSolver::FullSolver(FullStart) {}
FullSolver::~FullSolver() = default;
struct FullSolver::Parts {};

LoadCaseResult full_result(const LoadCase&, const Conditions&, const Contacts&, const PerInterface<ContactLaw>&,
                           FullSolver&, Detail, const std::vector<RollerPush>&) {
  throw NotBuilt("model.mechanism: full");
}
FullDistribution full_distribution(const LoadCase&, const Conditions&, const Contacts&, const PerInterface<ContactLaw>&,
                                   FullSolver&, Detail, const std::vector<RollerPush>&) {
  throw NotBuilt("model.mechanism: full");
}
Orbit full_orbit(const LoadCase&, const Conditions&, const Contacts&, const PerInterface<ContactLaw>&,
                 const std::function<FullDistribution(double)>&, const SpatialLoad::Orbit&) {
  throw NotBuilt("model.mechanism: full");
}

bool travels(const LoadCaseResult&) { return true; }
Warning no_orbit(const Orbit::Failure&) { throw NotBuilt("model.mechanism: full"); }

std::unique_ptr<RollersOnBodies> rollers_on_beams(const LoadedMechanism&, const MakeModel&, FullSolver&) {
  throw NotBuilt("model.mechanism: full");
}
std::unique_ptr<RollersOnBodies> rollers_on_meshes(const LoadedMechanism&, const MakeModel&, FullSolver&) {
  throw NotBuilt("model.mechanism: full");
}

MatrixCache& shared_matrix_cache() { throw NotBuilt("model.bodies: influence"); }
InfluenceSolver influence_solver(const Conditions&, const Contacts&, const PerInterface<ContactLaw>&, Direction, double,
                                 MatrixCache&, bool) {
  throw NotBuilt("model.bodies: influence");
}
bool influence_is_kept(const Conditions&, const Contacts&, const PerInterface<ContactLaw>&, Direction, double) {
  throw NotBuilt("model.bodies: influence");
}
LoadDistribution InfluenceSolver::solve(double, const Turned&) const { throw NotBuilt("model.bodies: influence"); }
InfluenceSolver::Turned InfluenceSolver::turned(const RollerPush&, double, double) const {
  throw NotBuilt("model.bodies: influence");
}

// Chains serve many designs and curves; a single sector is solved by CHOLMOD.
ChainSolver::ChainSolver(const SectorModel&) { throw NotBuilt("the chain solver"); }
LoadDistribution ChainSolver::solve(double) { throw NotBuilt("the chain solver"); }

// Analyses.
Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (c.heat) throw NotBuilt("heat");
  return analyze_slip(c, std::move(contacts), options);
}
Oils warm_oils(const Conditions&, const PerInterface<double>&) { throw NotBuilt("heat"); }
OfParts of_parts(const PerPart<double>&) { throw NotBuilt("heat"); }
PerInterface<double> oil_temperatures(const OfParts&) { throw NotBuilt("heat"); }
LifeResult life_of(const input::Source&, const input::CaseInput&) { throw NotBuilt("prs life"); }
FitInput read_fit_input(const input::Source&) { throw NotBuilt("prs fit"); }

// Texts of the verdict about limits.
std::string describe(StaticLimit) { throw NotBuilt("prs life"); }
MeasuresResult analyze_measures(const Conditions&, Contacts, AnalysisOptions) { throw NotBuilt("prs measures"); }
InSeriesOf in_series_of(const MeasuresResult&, const JudgedCase&) { throw NotBuilt("prs measures"); }
std::vector<FoundCriterion> measures_criteria(const MeasuresResult&, const JudgedCase&) {
  throw NotBuilt("prs measures");
}
StaticForces solved_static_forces(const Conditions&, const Contacts&, Direction, double, double) {
  throw NotBuilt("prs life");
}

// Lists and comparisons.
std::string measure_explanations() { throw NotBuilt("prs measures"); }
Json measure_explanations_json() { throw NotBuilt("prs measures"); }
Json requirement_schema() { throw NotBuilt("prs size"); }
std::string responses_table(const std::vector<std::string>&) { throw NotBuilt("prs list responses"); }
Json responses_json(const std::vector<std::string>&) { throw NotBuilt("prs list responses"); }
std::vector<std::string> known_responses() { throw NotBuilt("prs list responses"); }
std::vector<std::string> responses_of(const input::Source&) { throw NotBuilt("prs list responses"); }
Delivery compare_cases(const input::Source&, const input::Source&) { throw NotBuilt("prs compare FILE FILE"); }

// Commands.
std::optional<Shard> parse_shard(std::string_view) { return Shard{}; }
namespace cli {
void open_matrix_cache(bool) {}
std::string matrix_cache_refusal() { return ""; }
void require_png() { throw NotBuilt("--png"); }
int study(const Options&) { return refused("study"); }
int merge_study(const Options&) { return refused("study merge"); }
int fit(const Options&) { return refused("fit"); }
int optimize(const Options&) { return refused("optimize"); }
int size(const Options&) { return refused("size"); }
int report(const Options&) { return refused("report"); }
int explore(const Options&) { return refused("explore"); }
int workbench(const Options&) { return refused("workbench"); }
int export_model(const Options&) { return refused("export"); }
}  // namespace cli

}  // namespace prs
