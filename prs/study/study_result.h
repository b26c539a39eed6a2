#pragma once

#include <memory>

#include "prs/model/warning.h"
#include "prs/study/sensitivity.h"

namespace prs {

/// A place in maps: from 0 to nodes - 1 on each axis.
using MapPlace = std::array<double, 2>;

/// Numbers at the nodes of a grid over two factors; those of the second axis are consecutive. NaN if a design has none.
using GridMap = std::vector<double>;

/// Responses over the two factors of a grid.
struct GridMaps {
  std::array<MapAxis, 2> axes;
  std::vector<GridMap> responses;  ///< One per response of the study.

  std::size_t nodes() const { return axes[0].nodes() * axes[1].nodes(); }
  std::size_t node(std::size_t i, std::size_t j) const { return i * axes[1].nodes() + j; }
  /// The design at a node.
  std::size_t design(std::size_t node) const;
};

/// A map at a place, bilinear between four nodes; NaN next to a node without a number.
double map_value(const GridMaps& maps, const GridMap& map, MapPlace place);

/// Values of a study's inputs (`drawn_inputs`) at a place: as written at a node, else interpolated between two nodes if
/// the input is continuous.
std::vector<Level> inputs_at(const Study& study, const GridMaps& maps, MapPlace place);

/// Collects the maps of a study from its rows, block after block in any order.
class GridMapCollector {
 public:
  explicit GridMapCollector(const Study& study);

  void add(const RowBlock& block);

  /// Maps; absent if the study has none, or too many numbers for them.
  const std::optional<GridMaps>& maps() const { return maps_; }

 private:
  std::optional<GridMaps> maps_;
  std::vector<std::size_t> nodes_;  ///< Nodes of designs 1, 2, ..
};

/// A measure over the grid.
struct MeasureMap {
  std::size_t response = 0;    ///< Index among the study's responses.
  double weight = 1.0;         ///< w_i
  double rms = 0.0;            ///< Root mean square of all its numbers, in its unit.
  double normalised_by = 1.0;  ///< n_i, in its unit.
  std::size_t without = 0;     ///< Number of nodes without a number.
};

/// A design read from the envelope, between two nodes by interpolation.
struct EnvelopePoint {
  std::string name;
  std::string reason = {};  ///< Reason why there is no such design; empty if there is one.
  MapPlace place = {};
  std::optional<std::size_t> design = {};  ///< The node's design, if it has one.
  std::vector<Level> inputs = {};          ///< One per drawn input (`drawn_inputs`).
  std::vector<double> responses = {};      ///< All responses of the study; NaN next to designs without.
  std::vector<double> normalised = {};     ///< m_i / n_i, one per measure.
  double envelope = 0.0;
};

/// An envelope over the grid and the designs read from it.
struct EnvelopeResult {
  std::vector<MeasureMap> measures;
  GridMap values;                        ///< E; NaN if it is not defined, as for a root of a negative measure.
  double rms = 0.0;                      ///< Root mean square of the values.
  std::size_t without = 0;               ///< Number of nodes without a value.
  std::optional<std::size_t> best = {};  ///< The first node with the largest value.
  std::vector<EnvelopePoint> points;
};

/// The envelope of a study that has one. Each response is bilinear between four nodes, E is that of
/// the responses at the place.
EnvelopeResult evaluate_envelope(const Study& study, const GridMaps& maps);

/// m_i / n_i over the grid.
GridMap normalised(const GridMaps& maps, const MeasureMap& measure);

/// Probabilities of the reported quantiles.
inline constexpr std::array kProbabilities{0.01, 0.05, 0.5, 0.95, 0.99};

/// Largest number of converged designs whose values are all kept for quantiles and histograms. If there are more, this
/// many are drawn at random, by a hash of the design's number.
inline constexpr std::size_t kMostValuesKept = 65'536;

/// Number of values in each of several classes of equal width.
struct Histogram {
  double from = 0.0;
  double to = 0.0;
  std::vector<std::size_t> counts;  ///< Empty if all values are equal.
};

/// A response over the converged designs, without the base case.
struct ResponseStatistics {
  std::size_t count = 0;  ///< Number of designs with a value; the rest is defined from 1 on.
  double mean = 0.0;
  std::optional<double> standard_deviation;  ///< Sample deviation, divided by count - 1; from 2 designs on.
  double min = 0.0;
  double max = 0.0;
  std::size_t min_design = 0;  ///< First design with this value.
  std::size_t max_design = 0;
  /// Values at `kProbabilities`, linear between the ordered values (Hyndman & Fan 1996, type 7).
  std::array<double, kProbabilities.size()> quantiles{};
  Histogram histogram;
  std::size_t values_kept = 0;  ///< Number of values in quantiles and histogram.
};

/// Gain from halving the deviation of a factor from the file's value.
struct ToleranceGain {
  std::size_t factor = 0;  ///< Index of the first factor of its block.
  double quantile = 0.0;   ///< 95 % quantile of the response as drawn.
  double halved = 0.0;     ///< Quantile with the factor's deviation halved.

  double gain() const { return 1.0 - halved / quantile; }
};

/// Summary of the rows of a study.
struct StudySummary {
  std::vector<ResponseStatistics> statistics;     ///< One per response.
  std::optional<ResponseSurfaces> surfaces = {};  ///< Present for sampled plans with numeric factors.
  std::vector<ResponseIndices> indices = {};      ///< One per response, for plan sobol_indices.
  /// Gains for each response, the largest first, for plan tolerances.
  std::vector<std::vector<ToleranceGain>> tolerances = {};
  /// Factors that no response follows, as far as designs that differ in one factor alone show.
  std::vector<std::size_t> idle_factors = {};
  std::optional<GridMaps> maps = {};  ///< Present for a study with an envelope.
  std::optional<EnvelopeResult> envelope = {};
};

/// Summarises a study block by block. Except for maps, the memory does not depend on the number of designs. The result
/// does not depend on how the rows are split into blocks.
class StudyAnalysis {
 public:
  /// Takes a study and the responses that it records.
  explicit StudyAnalysis(const Study& study);
  ~StudyAnalysis();
  StudyAnalysis(StudyAnalysis&&) noexcept;
  StudyAnalysis& operator=(StudyAnalysis&&) noexcept;

  /// Adds the next block: in ascending order, without gaps, from design 0 on. `inputs`: for each design the numbers of
  /// the study's `drawn_inputs`, in their units; without them they are drawn here.
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
  std::vector<std::optional<double>> responses;  ///< Values in the order of the study's responses.
};

/// Largest number of rows kept for tables, figures and documents; files hold all of them.
inline constexpr std::size_t kMostRowsShown = 20'000;

/// A study with its first rows in the order of the designs, the base case first, and a summary of all.
struct StudyResult {
  Study study;  ///< Study with the recorded responses.
  std::vector<StudyRow> rows;
  std::size_t designs = 0;  ///< Number of all designs, base case included.
  std::size_t refused = 0;
  std::size_t failed = 0;  ///< Number of designs that did not converge or failed.
  StudySummary summary;
  std::vector<Warning> warnings = {};

  const StudyRow& base() const { return rows.front(); }
};

/// Adds a block, the next in order, to the counts and, as far as they are kept, to the rows.
void add(StudyResult& result, const RowBlock& block);

}  // namespace prs
