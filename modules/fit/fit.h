#pragma once

#include <algorithm>

#include "modules/estimation/fit.h"
#include "prs/input/study_reader.h"

namespace prs {

/// An input that is fitted. Numbers are in `unit`, that of `from`.
struct FitParameter {
  std::string path, label, unit;
  bool is_log = false;
  double start = 0.0, from = 0.0, to = 0.0;
  struct Prior {
    double mean = 0.0, deviation = 0.0;
  };
  std::optional<Prior> prior = {};
  bool has_start = false;  ///< Whether `start` is stated.
  std::string stood = {};  ///< What the file said; empty: nothing.
};

/// What rows of a curve set. Numbers are in the unit of the condition, words stand as they are.
struct FitCondition {
  std::string path, unit;
  std::vector<std::string> texts;  ///< One per row.
};

/// A curve of readings, or a band without any; readings are in `unit`, that of the response.
struct FitCurve {
  using Use = modules::fit::Curve::Use;

  std::string name, file, response, unit, at;  ///< `at`: path in the document, `fit.curves[0]`.
  Command command = Command::solve;
  bool is_usual_command = true;  ///< Whether it is the command of such responses.
  Use use = Use::fit;
  modules::fit::Loss loss;
  bool has_offset = false;
  std::vector<FitCondition> conditions;  ///< Conditions of rows; those that are the same in all stand in `base`.
  std::vector<std::pair<std::string, std::string>> constants = {};  ///< The others, for a band's document.
  std::string series;                                               ///< What `places` are of; empty: rows on their own.
  std::vector<double> places;                                       ///< SI
  std::vector<std::size_t> columns = {};                            ///< Columns of the readings in their lines.
  std::vector<double> measured, deviation;
  std::vector<std::size_t> lines;  ///< Lines of the file.
  std::size_t rows = 0;
  input::Node base = {};  ///< The case with starting values and conditions, without searches.
};

struct FitInput {
  input::Source source;
  std::vector<FitParameter> parameters;
  std::vector<FitCurve> curves;  ///< Then bands.
  double level = 0.9;
  std::size_t starts = 1;
  std::vector<std::size_t> profile;
};

/// Reads the fit of a source, opens its curves and checks all of it. Throws InputError.
FitInput read_fit_input(const input::Source& source);

/// Values of the parameters in their units -> all that a fit asks for, on several threads.
class FitEvaluation {
 public:
  /// Runs the case of each curve once. Throws InputError. The input must outlive it.
  FitEvaluation(const FitInput& input, std::size_t threads);
  ~FitEvaluation();

  std::vector<modules::fit::Answer> operator()(const std::vector<modules::fit::Request>& requests);
  std::size_t rows() const;  ///< Computed so far.

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

struct FitResult {
  FitInput input;
  modules::fit::Result found;
  std::size_t evaluations = 0;
  std::vector<Warning> warnings = {};

  bool has_values() const { return std::ranges::any_of(found.starts, &modules::fit::StartResult::is_best); }
  bool converged() const { return found.status == modules::fit::Status::converged; }
  std::size_t unknowns() const { return found.unknowns.size(); }
  /// `friction.coulomb` or `offset of travel`
  std::string name(std::size_t unknown) const;
  /// The curve of an unknown behind the parameters.
  const FitCurve& curve_of_offset(std::size_t unknown) const;
  const FitParameter* parameter(std::size_t unknown) const {
    return unknown < input.parameters.size() ? &input.parameters[unknown] : nullptr;
  }
  std::string unit(std::size_t unknown) const;
};

struct FitOptions {
  std::size_t threads = 0;  ///< 0: one per processor.
};

/// Throws InputError.
FitResult fit_case(const input::Source& source, const FitOptions& options = {});

/// `torque, torque.csv:7`
std::string place_of(const FitInput& input, std::size_t curve, std::size_t row);

/// Under what name a curve's readings stand beside the fitted case.
std::string name_of_copy(const FitInput& input, std::size_t curve);

/// The text of the source with the values in their places, and above each how well it is known.
std::string fitted_case(const FitResult& result);

/// A number as it is written into files: ten digits, with its unit.
std::string fit_text(double value, std::string_view unit);

/// `not_identifiable`
std::string_view name(modules::fit::Status status);

}  // namespace prs
