#include "prs/study/derivatives.h"

#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/input/units.h"
#include "prs/slip/running.h"
#include "prs/study/design_engine.h"
#include "prs/study/response.h"

namespace prs {
namespace {

using Eigen::VectorXd;

/// Steps of the difference formulas over the value of the factor, each tried where the one before
/// does not converge.
constexpr double kSteps[] = {2e-3, 2e-4, 2e-5};

/// A derivative whose two step widths differ by more than this share does not converge.
constexpr double kSettled = 1e-6;

/// df/dx = sum_m c_m (f(m h) - f(-m h))/h, m = 1, 2, 3, of sixth order.
constexpr std::array<double, 3> kDifference = {3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0};

template <class Values>
auto derivative(const std::array<Values, 3>& forward, const std::array<Values, 3>& backward, double step) {
  Values sum = kDifference[0] * (forward[0] - backward[0]);
  for (std::size_t m = 1; m < kDifference.size(); ++m) sum += kDifference[m] * (forward[m] - backward[m]);
  return Values(sum / step);
}

std::vector<ResultNumber> response_numbers(const Study& study) {
  std::vector<ResultNumber> numbers;
  for (const auto k : indices(study.responses)) {
    std::optional<ResultNumber> number = result_number(study.responses[k]);
    if (!number)
      throw UnknownResponse(k, fmt::format("got {}; expected a number of a contact, of the threads "
                                           "or of a load case, which has derivatives; write for "
                                           "example `axial_displacement_um`",
                                           study.responses[k]));
    numbers.push_back(std::move(*number));
  }
  return numbers;
}

/// The chain up to the equilibrium at one value of a factor.
struct Model {
  Contacts contacts;
  PerInterface<ContactLaw> laws;
  std::vector<LoadCase> load_cases;
  std::vector<std::unique_ptr<SectorSolver>> solvers;  ///< One per load case, or null.
  /// Results of a full mechanism in place of solvers: one per load case that is needed.
  std::vector<std::optional<LoadCaseResult>> solved;
};

std::string without_equilibrium(const LoadCase& load, Command command) {
  return fmt::format(
      "got {}, which does not converge; expected a load case that `prs {}` answers; its "
      "derivatives do not exist",
      load.name, name(command));
}

/// A load case by the whole chain, with its modes or not.
LoadCaseResult solved_anew(const Case& given, Command command, const LoadCase& load, bool with_modes) {
  Case one = given;
  one.load_cases = {load};
  if (!with_modes) one.load_cases.front().modes.reset();
  Result all = command == Command::slip ? analyze_heat(one) : analyze_loads(one);
  LoadCaseResult& result = all.load_cases.front();
  if (!result.converged() || (result.slip && !result.slip->has_answer()))
    throw CaseError(load.input_path, without_equilibrium(load, command));
  return std::move(result);
}

/// Whether a load case is solved at each step of the differences: all rollers, and what runs.
bool is_solved_anew(const Case& c, Command command, const LoadCase& load) {
  return command == Command::slip || c.model.all_rollers() || solve_takes_running_loads(c.model, load.share);
}

/// The load cases that responses need stand at their index, all others are left out.
Model model_of(const Case& given, Command command, const std::vector<ResultNumber>& numbers, bool with_modes) {
  bool complete = false;
  for (const ResultNumber& number : numbers) complete = complete || number.needs_complete;
  Model model;
  model.contacts = checked_contacts(given, complete ? Detail::complete : Detail::numbers);
  const Conditions& c = given;
  model.load_cases = c.load_cases;
  if (command == Command::contact)  // The command answers load cases of equal shares only.
    std::erase_if(model.load_cases, [](const LoadCase& load) { return load.share != LoadCase::Share::equal; });
  model.solvers.resize(model.load_cases.size());
  model.solved.resize(model.load_cases.size());
  if (command == Command::contact) return model;
  model.laws = contact_laws(c, model.contacts);
  for (const ResultNumber& number : numbers) {
    if (!number.load_case || *number.load_case >= c.load_cases.size()) continue;
    const LoadCase& load = c.load_cases[*number.load_case];
    std::unique_ptr<SectorSolver>& solver = model.solvers[*number.load_case];
    if (solver || (load.share == LoadCase::Share::equal && command == Command::solve)) continue;
    if (is_solved_anew(given, command, load)) {
      std::optional<LoadCaseResult>& solved = model.solved[*number.load_case];
      if (!solved) solved = solved_anew(given, command, load, with_modes);
      continue;
    }
    solver = std::make_unique<SectorSolver>(build_sector(model.contacts.mechanism, *c.structure, *c.materials, c.model,
                                                         model.laws, *load.direction, *load.position, c.deviations));
  }
  return model;
}

/// The responses; `states` are those of the solvers, by load case.
VectorXd responses(Model& model, Command command, const std::vector<ResultNumber>& numbers,
                   const std::vector<fe::State>& states) {
  std::vector<std::optional<LoadCaseResult>> results(model.load_cases.size());
  VectorXd values(static_cast<Eigen::Index>(numbers.size()));
  for (const auto k : indices(numbers)) {
    const LoadCaseResult* result = nullptr;
    if (const std::optional<std::size_t> index = numbers[k].load_case) {
      const LoadCase& load = model.load_cases[*index];
      std::optional<LoadCaseResult>& answer = results[*index];
      if (model.solved[*index]) answer = model.solved[*index];
      if (!answer && model.solvers[*index]) {
        LoadDistribution loads = model.solvers[*index]->at(states[*index], load.axial_force);
        loads.solve.status = fe::NewtonStatus::converged;
        answer = solved_result(load, model.contacts, model.laws, std::move(loads));
      } else if (!answer) {
        answer = command == Command::contact ? equal_share_result(load, model.contacts)
                                             : equal_share_result(load, model.contacts, model.laws);
      }
      result = &*answer;
    }
    values[static_cast<Eigen::Index>(k)] =
        numbers[k].value({model.contacts, result}).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

/// dE/dq of a load case of a model at a state, less the load.
VectorXd residual(const SectorSolver& solver, const LoadCase& load, const fe::State& state) {
  VectorXd r(solver.equations().size());
  const double sector_force = load.axial_force / solver.sector().rollers;
  solver.equations().energy_and_residual(state, sector_force * solver.unit_load(), r);
  return r;
}

/// A solved case that is moved along factors.
class BaseCase {
 public:
  BaseCase(const input::StudyInput& input, const Study& study, bool with_modes)
      : input_(input),
        study_(study),
        with_modes_(with_modes),
        numbers_(response_numbers(study)),
        model_(model_of(input::read_design(input, {}), study.command, numbers_, with_modes)) {
    states_.resize(model_.solvers.size());
    for (const auto k : indices(states_)) {
      if (!model_.solvers[k]) continue;
      const LoadCase& load = model_.load_cases[k];
      if (!model_.solvers[k]->solve(load.axial_force).solve.converged())
        throw CaseError(load.input_path, without_equilibrium(load, study.command));
      states_[k] = model_.solvers[k]->state();
    }
  }

  bool full() const {
    return std::ranges::any_of(model_.solved, [](const auto& s) { return s.has_value(); });
  }
  VectorXd values() { return responses(model_, study_.command, numbers_, states_); }

  /// dR/dx with one step width. Throws if a value on the way has no mechanism.
  VectorXd rates(const Factor& factor, double step) {
    std::array<Model, 3> forward, backward;
    for (const auto m : indices(kDifference)) {
      const double shift = static_cast<double>(m + 1) * step;
      forward[m] = moved(factor, shift);
      backward[m] = moved(factor, -shift);
    }
    std::vector<VectorXd> state_rates(states_.size());
    for (const auto k : indices(states_))
      if (model_.solvers[k]) state_rates[k] = state_rate(k, forward, backward, step);
    std::array<VectorXd, 3> ahead, behind;
    for (const auto m : indices(kDifference)) {
      const double shift = static_cast<double>(m + 1) * step;
      ahead[m] = responses(forward[m], study_.command, numbers_, shifted(state_rates, shift));
      behind[m] = responses(backward[m], study_.command, numbers_, shifted(state_rates, -shift));
    }
    return derivative(ahead, behind, step);
  }

 private:
  Model moved(const Factor& factor, double shift) const {
    const double number = *factor.base->number + shift;
    const std::string text = fmt::format("{}={}{}{}", factor.path, number, factor.unit.empty() ? "" : " ", factor.unit);
    return model_of(input::read_design(input_, {text}), study_.command, numbers_, with_modes_);
  }

  VectorXd state_rate(std::size_t k, const std::array<Model, 3>& forward, const std::array<Model, 3>& backward,
                      double step) {
    const int size = model_.solvers[k]->equations().size();
    std::array<VectorXd, 3> ahead, behind;
    for (const auto m : indices(kDifference)) {
      const auto residual_in = [&](const Model& model) {
        if (model.solvers[k]->equations().size() != size)
          throw CaseError("study", "two sections of the nut meet here: faces, thrust section, contacts");
        return residual(*model.solvers[k], model.load_cases[k], states_[k]);
      };
      ahead[m] = residual_in(forward[m]);
      behind[m] = residual_in(backward[m]);
    }
    VectorXd rate;
    if (!model_.solvers[k]->state_rate(derivative(ahead, behind, step), rate))
      throw CaseError("study", "the tangent stiffness is singular");
    return rate;
  }

  std::vector<fe::State> shifted(const std::vector<VectorXd>& rates, double shift) const {
    std::vector<fe::State> states = states_;
    for (const auto k : indices(states))
      if (rates[k].size() > 0) states[k].set_to_step(states_[k], -shift, rates[k]);
    return states;
  }

  const input::StudyInput& input_;
  const Study& study_;
  bool with_modes_ = false;  ///< Whether a response is of natural modes.
  std::vector<ResultNumber> numbers_;
  Model model_;
  std::vector<fe::State> states_;
};

/// Size of the deviations and loads of a full mechanism that are 0 in the file, in a unit; 0 where
/// the unit is of something else. Steps are shares of it.
double usual_size(std::string_view unit) {
  const std::pair<const input::Dimension*, double> sizes[] = {{&input::unit::length, 1e-5},
                                                              {&input::unit::force, 1e3},
                                                              {&input::unit::angle, 1e-3},
                                                              {&input::unit::torque, 10.0}};
  for (const auto& [dimension, size] : sizes)
    if (const input::Unit* u = input::find_unit(unit, *dimension)) return size / u->multiply * u->divide;
  return 0.0;
}

/// Keeps, response by response, the derivative with the smallest difference of its step widths.
void keep_better(FactorDerivatives& kept, const VectorXd& wide, const VectorXd& narrow, const VectorXd& values,
                 double x, double size) {
  for (const auto k : indices(kept.responses)) {
    const auto at = static_cast<Eigen::Index>(k);
    const double error = std::abs(wide[at] - narrow[at]);
    // A change of less than this share of the response over the factor counts as none.
    const double scale = std::abs(wide[at]) + 1e-6 * std::abs(values[at] / size);
    if (!(error <= kSettled * scale)) continue;
    std::optional<Derivative>& best = kept.responses[k];
    if (best && best->error <= error) continue;
    best = Derivative{wide[at], std::nullopt, error};
    if (values[at] != 0.0 && x != 0.0) best->elasticity = wide[at] * x / values[at];
  }
}

bool complete(const FactorDerivatives& factor, const VectorXd& values) {
  for (const auto k : indices(factor.responses))
    if (std::isfinite(values[static_cast<Eigen::Index>(k)]) && !factor.responses[k]) return false;
  return true;
}

FactorDerivatives derivatives_by(const Factor& factor, BaseCase& base, const VectorXd& values) {
  FactorDerivatives result;
  result.responses.resize(static_cast<std::size_t>(values.size()));
  if (!factor.base || !factor.base->number) {
    result.reason = "the file states no number for it";
    return result;
  }
  const double x = *factor.base->number;
  const double size = x == 0.0 && base.full() ? usual_size(factor.unit) : std::abs(x);
  if (size == 0.0) {
    result.reason = "it is 0, of which a step cannot be a share";
    return result;
  }
  for (const double share : kSteps) {
    const double step = share * size;
    try {
      keep_better(result, base.rates(factor, step), base.rates(factor, 0.5 * step), values, x, size);
      result.reason.clear();
    } catch (const input::InputError& error) {
      result.reason = error.what();
    } catch (const CaseError& error) {
      result.reason = error.what();
    }
    if (complete(result, values)) return result;
  }
  if (result.reason.empty()) result.reason = "some derivatives do not exist: the response has a kink here";
  return result;
}

void require_model(const Study& study, const Case& c) {
  if (study.command != Command::contact && study.command != Command::solve && study.command != Command::slip)
    throw CaseError("study.command",
                    "got another command than `contact`, `solve` or `slip`; expected one of them "
                    "with `plan: derivatives`; write `command: solve`");
  if (study.command != Command::contact && !c.model.bodies->derivatives)
    throw CaseError("model.bodies", fmt::format("got {}; expected `bars` or `refined` with `plan: derivatives`; write "
                                                "`bodies: refined`",
                                                c.model.bodies->name));
}

}  // namespace

CaseDerivatives case_derivatives(const input::StudyInput& input) {
  require_model(input.study, input::read_design(input, {}));
  CaseDerivatives result;
  const DesignEngine engine(input);
  result.study = engine.study();
  BaseCase base(input, result.study, engine.needs_modes());
  const VectorXd values = base.values();
  for (const double value : values) result.values.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
  for (const Factor& factor : result.study.factors) result.factors.push_back(derivatives_by(factor, base, values));
  return result;
}

}  // namespace prs
