#pragma once

#include "prs/loads/load_analysis.h"
#include "prs/optimize/optimizer.h"

namespace prs {

Record<OptimizationResult> record_of(Type<OptimizationResult>);

/// The document of `prs optimize --json`: the optimization, the file's own design, the compromise with changes in
/// percent, the front by numbers of its designs, the front of each search, and a comparison with the check.
nlohmann::ordered_json optimize_json(const OptimizationResult& result, const DocumentInfo& info);

/// Result of an optimization within 100 columns: variables, objectives and constrained responses of
/// the file's own design and of the compromise, then the constraints and the check.
std::string optimize_table(const OptimizationResult& result);

/// Reason why there is no compromise; empty if there is one.
std::string optimize_failure(const OptimizationResult& result);

/// The front of both searches, one row per design: its row in history.csv, whether it is the compromise, the variables
/// and their linked inputs (`mechanism.flank_angle.screw_deg`), the responses under their paths.
std::string front_csv(const OptimizationResult& result, const CsvStyle& style = {});

/// Every design in the order of evaluation, the file's own first: its number, the algorithm, generation from 1,
/// feasible, violation (empty without a result), status, reason, variables, responses.
std::string history_csv(const OptimizationResult& result, const CsvStyle& style = {});

/// The text of a source with its overrides, and further ones, written into it, and `remark` as its first line. Values
/// replace those in the file, or are added, and the rest of the text is unchanged. If that would not give the document
/// that the overrides mean, as with aliases, the document is rewritten without comments.
std::string case_with(const input::Source& source, const std::vector<std::string>& overrides,
                      const std::string& remark);

}  // namespace prs
