#pragma once

#include "prs/loads/load_analysis.h"
#include "prs/optimize/optimizer.h"

namespace prs {

Record<OptimizationResult> record_of(Type<OptimizationResult>);

/// The document of `prs optimize --json`: what was asked for, the file's own design, the
/// compromise with changes in percent, the front by numbers of its designs, of each search its own
/// front, and of a check how the two compare.
nlohmann::ordered_json optimize_json(const OptimizationResult& result, const DocumentInfo& info);

/// Result of an optimization within 100 columns: variables, objectives and constrained responses of
/// the file's own design and of the compromise, then the constraints and the check.
std::string optimize_table(const OptimizationResult& result);

/// Why there is no compromise; empty where there is one.
std::string optimize_failure(const OptimizationResult& result);

/// The front of both searches, one row per design: where it stands in history.csv, whether it is
/// the compromise, the variables and what is linked to them (`mechanism.flank_angle.screw_deg`),
/// the responses under their paths.
std::string front_csv(const OptimizationResult& result, const CsvStyle& style = {});

/// Every design in the order in which it was evaluated, the file's own first: its number, the
/// algorithm, generation from 1, feasible, violation (empty without an answer), status, reason,
/// variables, responses.
std::string history_csv(const OptimizationResult& result, const CsvStyle& style = {});

/// The text of a source with its overrides, and more of them, written into it, and `remark` as its
/// first line. Values take the place of those in the file, or are added to it, and nothing else of
/// the text changes. Where that would not give the document that the overrides mean, as with
/// aliases, it is written anew, without comments.
std::string case_with(const input::Source& source, const std::vector<std::string>& overrides,
                      const std::string& remark);

/// What an optimization can show. The result must outlive the list.
Pictures optimization_pictures(const OptimizationResult& result);

}  // namespace prs
