#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "prs/input/study_reader.h"
#include "prs/slip_result.h"
#include "prs/study/study.h"

namespace prs {

/// How a design ended.
struct DesignStatus {
  /// `refused` (the case describes no mechanism), `failed` (the program does not know why), or how
  /// the solve of the first load case that did not converge ended.
  std::string name = "converged";
  std::string reason = {};  ///< Empty where converged.

  bool converged() const { return name == "converged"; }
};

/// What one design answers.
struct Answer {
  DesignStatus status;
  nlohmann::ordered_json document = {};  ///< That of the command; null where refused or failed.
  std::optional<SlipResult> slip = {};   ///< Of the first load case, without its threads.
};

/// One design of a study and its results.
struct StudyRow {
  Design design;
  DesignStatus status;
  std::vector<std::optional<double>> responses;  ///< In the order of the study's.
  std::optional<SlipResult> slip;                ///< As in the answer.
};

/// A study and its rows in the order of the designs, the base case first.
struct StudyResult {
  Study study;  ///< Its responses are those recorded.
  std::vector<StudyRow> rows;

  const StudyRow& base() const { return rows.front(); }
};

/// A response that the base case does not have: which of the study's, and what to do about it.
class UnknownResponse : public std::runtime_error {
 public:
  UnknownResponse(std::size_t index, const std::string& message)
      : std::runtime_error(message), index_(index) {}
  std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// Answers a design, given by its overrides.
using Solve = std::function<Answer(const std::vector<std::string>& overrides)>;

/// Told after each design how many of how many are done.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// The chain of the study's command on the base document with the overrides. Never throws for what
/// is wrong with a design.
Answer solve_design(const input::StudyInput& input, const std::vector<std::string>& overrides);

/// Runs every design of a study, the base case first. Throws UnknownResponse after the base case.
StudyResult run_study(const Study& study, const Solve& solve, const Progress& progress = {});

}  // namespace prs
