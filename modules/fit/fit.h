#pragma once

#include <algorithm>

#include "modules/estimation/fit.h"
#include "prs/input/study_reader.h"

namespace prs {

/// A fitted input. Numbers are in `unit`, that of `from`.
struct FitParameter {
  std::string path, label, unit;
  bool is_log = false;
  double start = 0.0, from = 0.0, to = 0.0;
  struct Prior {
    double mean = 0.0, deviation = 0.0;
  };
  std::optional<Prior> prior = {};
  bool has_start = false;  ///< Whether `start` is stated.
  std::string stood = {};  ///< Value in the file before; may be empty.
};

/// An input set by the rows of a curve. Numbers are in the unit of the condition, words are unchanged.
struct FitCondition {
  std::string path, unit;
  std::vector<std::string> texts;  ///< One per row.
};

/// A curve of readings, or a band without any; readings are in `unit`, that of the response.
struct FitCurve {
  using Use = modules::fit::Curve::Use;

  std::string name, file, response, unit, at;  ///< `at`: path in the document, `fit.curves[0]`.
  Command command = Command::solve;
  bool is_usual_command = true;  ///< Whether it is the usual command of such responses.
  Use use = Use::fit;
  modules::fit::Loss loss;
  bool has_offset = false;
  std::vector<FitCondition> conditions;  ///< Conditions that differ between rows; the others are in `base`.
  std::vector<std::pair<std::string, std::string>> constants = {};  ///< The other conditions, for a band's document.
  std::string series;                     ///< Name of the series of `places`; empty: rows are independent.
  std::vector<double> places;             ///< SI
  std::vector<std::size_t> columns = {};  ///< Columns of the readings in their lines.
  std::vector<double> measured, deviation;
  std::vector<std::size_t> lines;  ///< Lines of the file.
  std::size_t rows = 0;
  input::Node base = {};  ///< The case with starting values and conditions, without searches.
};

struct FitInput {
  input::Source source;
  std::vector<FitParameter> parameters;
  std::vector<FitCurve> curves;  ///< Curves with readings, then bands.
  double level = 0.9;
  std::size_t starts = 1;
  std::vector<std::size_t> profile;
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
  /// Curve of an offset, which is an unknown after the parameters.
  const FitCurve& curve_of_offset(std::size_t unknown) const;
  const FitParameter* parameter(std::size_t unknown) const {
    return unknown < input.parameters.size() ? &input.parameters[unknown] : nullptr;
  }
  std::string unit(std::size_t unknown) const;
};

struct FitOptions {
  std::size_t threads = 0;  ///< Number of threads; 0: one per processor.
};

/// Runs the fit of a source. Throws InputError.
FitResult fit_case(const input::Source& source, const FitOptions& options = {});

/// Place of a row: `torque, torque.csv:7`.
std::string place_of(const FitInput& input, std::size_t curve, std::size_t row);

/// File name of a curve's readings in the folder of the fitted case.
std::string name_of_copy(const FitInput& input, std::size_t curve);

/// Text of the source with the fitted values, and above each its uncertainty.
std::string fitted_case(const FitResult& result);

/// A number as written into files: ten digits, with its unit.
std::string fit_text(double value, std::string_view unit);

/// Name in documents: `not_identifiable`.
std::string_view name(modules::fit::Status status);

}  // namespace prs
