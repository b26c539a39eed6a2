#pragma once

#include <memory>

#include "prs/model/warning.h"
#include "prs/study/envelope_result.h"
#include "prs/study/sensitivity.h"

namespace prs {

/// Quantiles that are reported.
inline constexpr std::array kProbabilities{0.01, 0.05, 0.5, 0.95, 0.99};

/// Most converged designs whose values are all kept for quantiles and histograms. Of more designs,
/// this many are drawn at random, by a hash of the design's number.
inline constexpr std::size_t kMostValuesKept = 65'536;

/// Number of values in each of several classes of equal width.
struct Histogram {
  double from = 0.0;
  double to = 0.0;
  std::vector<std::size_t> counts;  ///< Empty where all values are equal.
};

/// A response over the converged designs, the base case not among them.
struct ResponseStatistics {
  std::size_t count = 0;  ///< Designs with a number; the rest holds from 1 on.
  double mean = 0.0;
  std::optional<double> standard_deviation;  ///< Sample's, divided by count - 1; from 2 designs on.
  double min = 0.0;
  double max = 0.0;
  std::size_t min_design = 0;  ///< The first with this value.
  std::size_t max_design = 0;
  /// At `kProbabilities`, linear between the ordered values (Hyndman & Fan 1996, type 7).
  std::array<double, kProbabilities.size()> quantiles{};
  Histogram histogram;
  std::size_t values_kept = 0;  ///< Values behind quantiles and histogram.
};

/// Summary of the rows of a study.
struct StudySummary {
  std::vector<ResponseStatistics> statistics;     ///< One per response.
  std::optional<ResponseSurfaces> surfaces = {};  ///< For sampled plans with numeric factors.
  std::vector<ResponseIndices> indices = {};      ///< One per response, for plan sobol_indices.
  /// Factors that no response follows, as far as designs that differ in one factor alone tell.
  std::vector<std::size_t> idle_factors = {};
  std::optional<GridMaps> maps = {};  ///< For a study with an envelope.
  std::optional<EnvelopeResult> envelope = {};
};

/// Summarises a study block by block. Apart from maps, the memory does not depend on the number of
/// designs. The result does not depend on how the rows are split into blocks.
class StudyAnalysis {
 public:
  /// For a study and the responses that it records.
  explicit StudyAnalysis(const Study& study);
  ~StudyAnalysis();
  StudyAnalysis(StudyAnalysis&&) noexcept;
  StudyAnalysis& operator=(StudyAnalysis&&) noexcept;

  /// The next block: in ascending order, without gaps, from design 0 on. `inputs`: for each design
  /// the numbers of the study's `drawn_inputs`, as they are in their units; without them they are
  /// drawn here.
  void add(const RowBlock& block, std::span<const double> inputs = {});

  StudySummary summary() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// One design of a study and its results.
struct StudyRow {
  Design design;
  DesignStatus status;
  std::vector<std::optional<double>> responses;  ///< In the order of the study's.
};

/// Rows that are kept for tables, figures and documents; files hold all of them.
inline constexpr std::size_t kMostRowsShown = 20'000;

/// A study with its first rows in the order of the designs, the base case first, and what all of
/// them say together.
struct StudyResult {
  Study study;  ///< Its responses are those recorded.
  std::vector<StudyRow> rows;
  std::size_t designs = 0;  ///< All, base case included.
  std::size_t refused = 0;
  std::size_t failed = 0;  ///< Not converged, or failed.
  StudySummary summary;
  std::vector<Warning> warnings = {};

  const StudyRow& base() const { return rows.front(); }
};

/// Adds a block, the next in order, to the counts and, as far as they are kept, to the rows.
void add(StudyResult& result, const RowBlock& block);

}  // namespace prs
