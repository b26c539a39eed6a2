#include "prs/study/study_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "prs/indices.h"

namespace prs {
namespace {

constexpr std::size_t kMostClasses = 48;

/// Mean, deviation and extremes (Welford 1962).
class Moments {
 public:
  void add(double value, std::size_t design) {
    const double d = value - mean_;
    mean_ += d / static_cast<double>(++count_);
    squares_ += d * (value - mean_);
    if (count_ == 1 || value < min_) min_ = value, min_design_ = design;
    if (count_ == 1 || value > max_) max_ = value, max_design_ = design;
  }

  ResponseStatistics statistics() const {
    ResponseStatistics s;
    s.count = count_;
    s.mean = mean_;
    if (count_ > 1) s.standard_deviation = std::sqrt(squares_ / static_cast<double>(count_ - 1));
    s.min = min_;
    s.max = max_;
    s.min_design = min_design_;
    s.max_design = max_design_;
    return s;
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
  double min_ = 0.0;
  double max_ = 0.0;
  std::size_t min_design_ = 0;
  std::size_t max_design_ = 0;
};

/// Rows of up to `kMostValuesKept` designs, those whose numbers have the smallest hashes.
class KeptRows {
 public:
  explicit KeptRows(std::size_t responses) : responses_(responses) {}

  void add(std::span<const double> row, std::size_t design) {
    const std::uint64_t hash = mixed_bits(design + kGoldenStep);
    if (hash > largest_) return;
    hashes_.push_back(hash);
    append(values_, row);
    if (hashes_.size() == 2 * kMostValuesKept) leave_out_others();
  }

  std::vector<double> numbers(std::size_t response) {
    leave_out_others();
    std::vector<double> values;
    values.reserve(hashes_.size());
    for (std::size_t k = response; k < values_.size(); k += responses_)
      if (std::isfinite(values_[k])) values.push_back(values_[k]);
    return values;
  }

 private:
  /// Removes rows with larger hashes, which differ between designs.
  void leave_out_others() {
    if (hashes_.size() <= kMostValuesKept) return;
    std::vector<std::uint64_t> hashes = hashes_;
    const auto last = hashes.begin() + kMostValuesKept - 1;
    std::nth_element(hashes.begin(), last, hashes.end());
    largest_ = *last;
    std::size_t kept = 0;
    for (const auto k : indices(hashes_)) {
      if (hashes_[k] > largest_) continue;
      hashes_[kept] = hashes_[k];
      if (kept != k) std::copy_n(&values_[k * responses_], responses_, &values_[kept * responses_]);
      ++kept;
    }
    hashes_.resize(kept);
    values_.resize(kept * responses_);
  }

  std::size_t responses_ = 0;
  std::uint64_t largest_ = std::numeric_limits<std::uint64_t>::max();  ///< Largest hash that is kept.
  std::vector<std::uint64_t> hashes_;
  std::vector<double> values_;
};

/// Quantiles at `kProbabilities`, from values that are sorted here.
std::array<double, kProbabilities.size()> quantiles(std::vector<double>& values) {
  std::ranges::sort(values);
  std::array<double, kProbabilities.size()> found{};
  std::ranges::transform(kProbabilities, found.begin(), [&](double probability) {
    const double at = probability * static_cast<double>(values.size() - 1);
    const auto k = static_cast<std::size_t>(at);
    if (k + 1 == values.size()) return values[k];
    return values[k] + (at - static_cast<double>(k)) * (values[k + 1] - values[k]);
  });
  return found;
}

/// Histogram with twice the cube root of the number of values as number of classes (Rice's rule).
Histogram histogram(const std::vector<double>& values) {
  const auto [least, largest] = std::ranges::minmax(values);
  Histogram h{least, largest, {}};
  if (!(h.from < h.to)) return h;
  const double rice = std::ceil(2.0 * std::cbrt(static_cast<double>(values.size())));
  h.counts.resize(std::min(kMostClasses, static_cast<std::size_t>(rice)));
  const double classes = static_cast<double>(h.counts.size());
  for (const double value : values) {
    const auto k = static_cast<std::size_t>(classes * ((value - h.from) / (h.to - h.from)));
    ++h.counts[std::min(k, h.counts.size() - 1)];
  }
  return h;
}

bool is_finite(double value) { return std::isfinite(value); }
bool all_finite(std::span<const double> values) { return std::ranges::all_of(values, is_finite); }
bool any_finite(std::span<const double> values) { return std::ranges::any_of(values, is_finite); }

std::vector<std::optional<double>> numbers(const RowBlock& block, std::size_t row, std::size_t responses) {
  std::vector<std::optional<double>> numbers(responses);
  for (const auto j : up_to(responses)) {
    const double value = block.responses[row * responses + j];
    if (std::isfinite(value)) numbers[j] = value;
  }
  return numbers;
}

}  // namespace

struct StudyAnalysis::Parts {
  explicit Parts(const Study& s)
      : study(s),
        followed(s),
        columns(factor_columns(s)),
        factors(normalised_factors(s)),
        moments(s.responses.size()),
        kept(s.responses.size()),
        x(factors.size()) {
    if (s.envelope) maps.emplace(s);
    for (std::size_t input = 0; const Factor& factor : study.factors) {
      input_of_factor.push_back(input);
      input += 1 + factor.companions.size();
    }
    if (factors.size() > kMostFactorsOfSurface) {
      reason = fmt::format("it takes at most {} factors, the study has {}", kMostFactorsOfSurface, factors.size());
      factors.clear();
    }
    regression = LinearRegression(factors.size(), study.responses.size());
    if (study.plan == Plan::tolerances)
      drawn.assign(1 + halved_blocks(study).size(), std::vector<std::vector<double>>(study.responses.size()));
    if (study.plan != Plan::sobol_indices) return;
    const std::size_t d = blocks_of(study).size();
    indices.assign(study.responses.size(), VarianceIndices(d, study.samples));
    sample.assign(study.responses.size(), std::vector<double>(d + 2));
  }

  void add(std::span<const double> row, std::size_t design, std::span<const double> inputs) {
    followed.add(row, design);
    if (design == 0) return;
    if (!indices.empty() && !add_to_sample(row, design)) return;
    if (!drawn.empty()) {
      const std::size_t k = (design - 1) % drawn.size();
      for (const auto j : prs::indices(row))
        if (std::isfinite(row[j])) drawn[k][j].push_back(row[j]);
      if (k > 0) return;
    }
    if (!any_finite(row)) return;
    for (const auto j : prs::indices(row))
      if (std::isfinite(row[j])) moments[j].add(row[j], design);
    kept.add(row, design);
    if (!factors.empty() && all_finite(row)) add_to_surface(row, inputs);
  }

  void add_to_surface(std::span<const double> row, std::span<const double> inputs) {
    for (const auto i : prs::indices(factors)) x[i] = factors[i](inputs[input_of_factor[factors[i].factor]]);
    if (all_finite(x)) regression.add(x, row);
  }

  /// Whether the design is one of the two that are drawn independently of each other.
  bool add_to_sample(std::span<const double> row, std::size_t design) {
    const std::size_t designs = sample.front().size(), k = (design - 1) % designs;
    for (const auto j : prs::indices(row)) {
      sample[j][k] = row[j];
      if (k + 1 == designs) indices[j].add(sample[j]);
    }
    return k < 2;
  }

  Study study;
  FollowedFactors followed;
  std::vector<FactorColumn> columns;
  std::vector<NormalisedFactor> factors;
  std::vector<std::size_t> input_of_factor;  ///< Index among `drawn_inputs`.
  std::size_t next = 0;                      ///< Next design.
  std::vector<Moments> moments;
  KeptRows kept;
  std::string reason;  ///< Reason why there is no response surface.
  LinearRegression regression;
  std::vector<double> x;                    ///< Normalised factors of one design.
  std::vector<VarianceIndices> indices;     ///< One per response, for plan sobol_indices.
  std::vector<std::vector<double>> sample;  ///< A response of the designs of one sample.
  /// Values as drawn and with each factor halved, by responses, for plan tolerances.
  std::vector<std::vector<std::vector<double>>> drawn;

  std::vector<ToleranceGain> gains(std::size_t response) {
    std::vector<ToleranceGain> all;
    const std::vector<std::size_t> blocks = blocks_of(study), halved = halved_blocks(study);
    for (std::size_t k = 1; k < drawn.size(); ++k)
      if (!drawn[0][response].empty() && !drawn[k][response].empty())
        all.push_back({blocks[halved[k - 1]], quantiles(drawn[0][response])[3], quantiles(drawn[k][response])[3]});
    std::ranges::stable_sort(all, std::greater<>(), &ToleranceGain::gain);
    return all;
  }
  std::optional<GridMapCollector> maps;  ///< Present for a study with an envelope.
};

StudyAnalysis::StudyAnalysis(const Study& study) : parts_(std::make_unique<Parts>(study)) {}
StudyAnalysis::~StudyAnalysis() = default;
StudyAnalysis::StudyAnalysis(StudyAnalysis&&) noexcept = default;
StudyAnalysis& StudyAnalysis::operator=(StudyAnalysis&&) noexcept = default;

void StudyAnalysis::add(const RowBlock& block, std::span<const double> inputs) {
  const std::size_t responses = parts_->study.responses.size();
  assert(block.first == parts_->next && block.responses.size() == block.rows * responses);
  const std::vector<FactorColumn>& columns = parts_->columns;
  const std::size_t width = columns.size();
  std::vector<double> drawn;
  if (inputs.empty()) inputs = drawn = factor_values(parts_->study, columns, block.first, block.rows);
  assert(inputs.size() == block.rows * width);
  const std::vector<double> none(responses, kNoResponse);
  for (const auto k : up_to(block.rows))
    parts_->add(block.status(k).converged() ? std::span(block.responses).subspan(k * responses, responses) : none,
                block.first + k, inputs.subspan(k * width, width));
  if (parts_->maps) parts_->maps->add(block);
  parts_->next += block.rows;
}

StudySummary StudyAnalysis::summary() const {
  StudySummary summary;
  for (const auto j : indices(parts_->moments)) {
    ResponseStatistics s = parts_->moments[j].statistics();
    std::vector<double> values = parts_->kept.numbers(j);
    s.values_kept = values.size();
    if (!values.empty()) {
      s.quantiles = quantiles(values);
      s.histogram = histogram(values);
    }
    summary.statistics.push_back(std::move(s));
  }
  if (!parts_->factors.empty())
    summary.surfaces = response_surfaces(parts_->regression, parts_->factors, parts_->study);
  if (!parts_->reason.empty()) summary.surfaces = ResponseSurfaces{0, parts_->reason};
  for (const VarianceIndices& indices : parts_->indices) {
    summary.indices.push_back(indices.result());
    for (FactorIndices& f : summary.indices.back().factors) f.factor = blocks_of(parts_->study)[f.factor];
  }
  if (!parts_->drawn.empty())
    for (const auto j : indices(parts_->moments)) summary.tolerances.push_back(parts_->gains(j));
  summary.idle_factors = parts_->followed.idle();
  if (parts_->maps && parts_->maps->maps()) {
    summary.maps = parts_->maps->maps();
    summary.envelope = evaluate_envelope(parts_->study, *summary.maps);
  }
  return summary;
}

void add(StudyResult& result, const RowBlock& block) {
  if (result.rows.empty()) result.rows.reserve(std::min(kMostRowsShown, design_count(result.study)));
  for (const auto k : up_to(block.rows)) {
    const DesignStatus status = block.status(k);
    if (!status.converged()) ++(status.name == "refused" ? result.refused : result.failed);
    if (result.rows.size() >= kMostRowsShown) continue;
    result.rows.push_back(
        {design(result.study, block.first + k), status, numbers(block, k, result.study.responses.size())});
  }
  result.designs += block.rows;
}

namespace {

/// Nodes of designs 1, 2, ..: the last factor changes fastest.
std::vector<std::size_t> nodes_of(const GridMaps& maps) {
  std::array<std::vector<std::size_t>, 2> node_of_level;
  for (const auto a : up_to(2)) {
    node_of_level[a].resize(maps.axes[a].nodes());
    for (const auto k : up_to(maps.axes[a].nodes())) node_of_level[a][maps.axes[a].levels[k]] = k;
  }
  std::vector<std::size_t> nodes;
  nodes.reserve(maps.nodes());
  for (const std::size_t i : node_of_level[0])
    for (const std::size_t j : node_of_level[1]) nodes.push_back(maps.node(i, j));
  return nodes;
}

/// An input between two nodes; that of the nearer node if it has no such value.
Level level_at(const Factor& input, const MapAxis& axis, double place) {
  const auto [node, share] = between(place, axis.nodes());
  const Level& from = input.levels[axis.levels[node]];
  const Level& to = input.levels[axis.levels[node + 1]];
  if (share == 0.0 || share == 1.0 || !axis.continuous) return share < 0.5 ? from : to;
  const double number = interpolated(*from.number, *to.number, share, input.logarithmic);
  return {fmt::format("{:.15g}{}{}", number, input.unit.empty() ? "" : " ", input.unit), number};
}

/// Distance beyond a cell, in shares of it, at which rounding may put a root.
constexpr double kRoundingOfRoot = 1e-9;

std::size_t index_of(const Study& study, const std::string& response) {
  return static_cast<std::size_t>(std::ranges::find(study.responses, response) - study.responses.begin());
}

/// Root mean square and number of the finite values.
struct MeanSquare {
  double rms = 0.0;
  double largest = 0.0;  ///< Magnitude.
  std::size_t count = 0;
};

MeanSquare mean_square(const GridMap& map) {
  MeanSquare mean;
  for (const double value : map)
    if (std::isfinite(value)) mean.largest = std::max(mean.largest, std::abs(value)), ++mean.count;
  if (mean.largest == 0.0) return mean;
  double sum = 0.0;
  for (const double value : map)
    if (std::isfinite(value)) sum += (value / mean.largest) * (value / mean.largest);
  mean.rms = mean.largest * std::sqrt(sum / static_cast<double>(mean.count));
  return mean;
}

double normalisation(Envelope::Normalise normalise, const MeanSquare& mean) {
  const double by = normalise == Envelope::Normalise::rms   ? mean.rms
                    : normalise == Envelope::Normalise::max ? mean.largest
                                                            : 1.0;
  return by > 0.0 ? by : 1.0;
}

/// E of normalised measures; NaN if it is not finite.
double combined(Envelope::Combine combine, std::span<const MeasureMap> measures, std::span<const double> normalised) {
  const bool product = combine == Envelope::Combine::product;
  double value = product ? 1.0 : 0.0;
  for (const auto k : indices(measures))
    if (product)
      value *= std::pow(normalised[k], measures[k].weight);
    else
      value += measures[k].weight * normalised[k];
  return std::isfinite(value) ? value : kNoResponse;
}

/// Roots of a x^2 + b x + c.
std::vector<double> roots(double a, double b, double c) {
  const double scale = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (scale == 0.0) return {};
  if (std::abs(a) <= 1e-14 * scale) return b == 0.0 ? std::vector<double>{} : std::vector{-c / b};
  const double d = b * b - 4.0 * a * c;
  if (d < 0.0) return {};
  const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (q == 0.0) return {0.0};
  return {q / a, c / q};
}

/// f = a + b u + c v + d u v on a cell, u and v from 0 to 1.
struct Bilinear {
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
};

/// Places at which both are 0.
std::vector<MapPlace> zeros(const Bilinear& f, const Bilinear& g) {
  std::vector<MapPlace> found;
  const auto in_cell = [](double x) { return x >= -kRoundingOfRoot && x <= 1.0 + kRoundingOfRoot; };
  for (const double u :
       roots(f.b * g.d - g.b * f.d, f.a * g.d + f.b * g.c - g.a * f.d - g.b * f.c, f.a * g.c - g.a * f.c)) {
    if (!in_cell(u)) continue;
    const double slope_f = f.c + f.d * u, slope_g = g.c + g.d * u;
    const bool by_f = std::abs(slope_f) > std::abs(slope_g);
    const double slope = by_f ? slope_f : slope_g;
    if (slope == 0.0) continue;
    const double v = -(by_f ? f.a + f.b * u : g.a + g.b * u) / slope;
    if (in_cell(v)) found.push_back({std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)});
  }
  return found;
}

/// Evaluates the envelope of one study anywhere in its maps.
class Evaluator {
 public:
  Evaluator(const Study& study, const GridMaps& maps) : study_(study), maps_(maps) {
    for (const Envelope::Measure& measure : envelope().measures) {
      const std::size_t response = index_of(study, measure.response);
      const MeanSquare mean = mean_square(maps.responses[response]);
      result_.measures.push_back(
          {response, measure.weight, mean.rms, normalisation(envelope().normalise, mean), maps.nodes() - mean.count});
    }
    for (const auto i : up_to(maps.axes[0].nodes()))
      for (const auto j : up_to(maps.axes[1].nodes()))
        result_.values.push_back(value({static_cast<double>(i), static_cast<double>(j)}));
    const MeanSquare mean = mean_square(result_.values);
    result_.rms = mean.rms;
    result_.without = maps.nodes() - mean.count;
    for (const auto k : indices(result_.values))
      if (!std::isnan(result_.values[k]) && (!result_.best || result_.values[k] > result_.values[*result_.best]))
        result_.best = k;
  }

  EnvelopeResult result() {
    for (const Envelope::Point& point : envelope().points) result_.points.push_back(read_back(point));
    return std::move(result_);
  }

 private:
  const Envelope& envelope() const { return *study_.envelope; }

  std::vector<double> normalised_at(MapPlace place) const {
    std::vector<double> values;
    for (const MeasureMap& measure : result_.measures)
      values.push_back(map_value(maps_, maps_.responses[measure.response], place) / measure.normalised_by);
    return values;
  }
  double value(MapPlace place) const { return combined(envelope().combine, result_.measures, normalised_at(place)); }
  MapPlace place_of(std::size_t node) const {
    const std::size_t row = maps_.axes[1].nodes();
    return {static_cast<double>(node / row), static_cast<double>(node % row)};
  }

  /// The place with the largest envelope; any place if none has an envelope.
  std::optional<MapPlace> best_of(const std::vector<MapPlace>& places) const {
    std::optional<MapPlace> best;
    double largest = -HUGE_VAL;
    for (const MapPlace& place : places) {
      const double e = value(place);
      if (best && !(e > largest)) continue;
      best = place;
      if (!std::isnan(e)) largest = e;
    }
    return best;
  }

  /// The nodes where a response is closest to a value.
  std::vector<MapPlace> closest_nodes(const GridMap& map, double wanted) const {
    double least = HUGE_VAL;
    for (const double v : map)
      if (std::abs(v - wanted) < least) least = std::abs(v - wanted);
    std::vector<MapPlace> places;
    for (const auto k : indices(map))
      if (std::abs(map[k] - wanted) <= least) places.push_back(place_of(k));
    return places;
  }

  /// Places at which the lines of the grid meet a value of a response.
  std::vector<MapPlace> crossings(const GridMap& map, double wanted) const {
    std::vector<MapPlace> places;
    for (const auto k : indices(map))
      if (map[k] == wanted) places.push_back(place_of(k));
    for (const auto axis : up_to(2)) {
      if (!maps_.axes[axis].continuous) continue;
      const std::size_t ahead = axis == 0 ? maps_.axes[1].nodes() : 1;
      for (const auto k : indices(map)) {
        MapPlace place = place_of(k);
        if (place[axis] + 1.0 >= static_cast<double>(maps_.axes[axis].nodes())) continue;
        const double from = map[k] - wanted, to = map[k + ahead] - wanted;
        if (!(from * to < 0.0)) continue;
        place[axis] += from / (from - to);
        places.push_back(place);
      }
    }
    return places;
  }

  /// Places at which two responses have two values.
  std::vector<MapPlace> meetings(const Envelope::Target& first, const Envelope::Target& second) const {
    std::vector<MapPlace> places;
    for (std::size_t i = 0; i + 1 < maps_.axes[0].nodes(); ++i)
      for (std::size_t j = 0; j + 1 < maps_.axes[1].nodes(); ++j)
        for (const auto& [u, v] : zeros(cell(first, i, j), cell(second, i, j)))
          places.push_back({static_cast<double>(i) + u, static_cast<double>(j) + v});
    return places;
  }
  Bilinear cell(const Envelope::Target& target, std::size_t i, std::size_t j) const {
    const GridMap& map = maps_.responses[index_of(study_, target.response)];
    const double low = map[maps_.node(i, j)], right = map[maps_.node(i + 1, j)], up = map[maps_.node(i, j + 1)],
                 both = map[maps_.node(i + 1, j + 1)];
    return {low - target.value, right - low, up - low, both - right - up + low};
  }

  std::vector<MapPlace> places_of(const std::vector<Envelope::Target>& targets) const {
    if (targets.size() == 2) return meetings(targets[0], targets[1]);
    const GridMap& map = maps_.responses[index_of(study_, targets[0].response)];
    const auto [least, largest] = range(targets[0].response);
    if (!(targets[0].value >= least && targets[0].value <= largest)) return {};
    const bool between_nodes = maps_.axes[0].continuous || maps_.axes[1].continuous;
    return between_nodes ? crossings(map, targets[0].value) : closest_nodes(map, targets[0].value);
  }

  std::array<double, 2> range(const std::string& response) const {
    std::array<double, 2> ends{HUGE_VAL, -HUGE_VAL};
    for (const double v : maps_.responses[index_of(study_, response)])
      if (!std::isnan(v)) ends = {std::min(ends[0], v), std::max(ends[1], v)};
    return ends;
  }

  /// Reason why no place meets the targets.
  std::string reason(const std::vector<Envelope::Target>& targets) const {
    std::string text;
    for (const Envelope::Target& target : targets) {
      const auto [least, largest] = range(target.response);
      if (least > largest) return fmt::format("no design has a number for {}", target.response);
      if (target.value >= least && target.value <= largest) continue;
      text += fmt::format("{}{} lies between {:.6g} and {:.6g} in the grid, {:.6g} is wanted", text.empty() ? "" : "; ",
                          target.response, least, largest, target.value);
    }
    if (!text.empty()) return text;
    return targets.size() == 2 ? "no place of the grid has both values" : "no line of the grid meets the value";
  }

  std::optional<MapPlace> place_of(const Envelope::Point& point, std::string& why) const {
    if (point.at) {
      MapPlace place;
      for (const auto a : up_to(2)) {
        const std::optional<double> at = maps_.axes[a].place((*point.at)[a]);
        if (!at) return why = "it lies outside of the grid", std::nullopt;
        place[a] = *at;
      }
      return place;
    }
    if (!point.reach.empty()) {
      const std::optional<MapPlace> place = best_of(places_of(point.reach));
      if (!place) why = reason(point.reach);
      return place;
    }
    if (!result_.best) return why = "no design has an envelope", std::nullopt;
    return place_of(*result_.best);
  }

  EnvelopePoint read_back(const Envelope::Point& point) const {
    EnvelopePoint read{.name = point.name};
    const std::optional<MapPlace> place = place_of(point, read.reason);
    if (!place) return read;
    if (std::isnan(value(*place))) {
      read.reason = "a design there or next to it has no envelope";
      return read;
    }
    read.place = *place;
    if (std::floor(read.place[0]) == read.place[0] && std::floor(read.place[1]) == read.place[1])
      read.design =
          maps_.design(maps_.node(static_cast<std::size_t>(read.place[0]), static_cast<std::size_t>(read.place[1])));
    read.inputs = inputs_at(study_, maps_, read.place);
    for (const GridMap& map : maps_.responses) read.responses.push_back(map_value(maps_, map, read.place));
    read.normalised = normalised_at(read.place);
    read.envelope = value(read.place);
    return read;
  }

  const Study& study_;
  const GridMaps& maps_;
  EnvelopeResult result_;
};

}  // namespace

std::size_t GridMaps::design(std::size_t node) const {
  const std::size_t i = axes[0].levels[node / axes[1].nodes()];
  const std::size_t j = axes[1].levels[node % axes[1].nodes()];
  return 1 + i * axes[1].nodes() + j;
}

double map_value(const GridMaps& maps, const GridMap& map, MapPlace place) {
  const Between u = between(place[0], maps.axes[0].nodes());
  const Between v = between(place[1], maps.axes[1].nodes());
  double sum = 0.0;
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {0U, 1U}) {
      const double weight = (i == 0 ? 1.0 - u.share : u.share) * (j == 0 ? 1.0 - v.share : v.share);
      if (weight != 0.0) sum += weight * map[maps.node(u.node + i, v.node + j)];
    }
  return sum;
}

std::vector<Level> inputs_at(const Study& study, const GridMaps& maps, MapPlace place) {
  std::vector<Level> levels;
  for (const DrawnInput& drawn : drawn_inputs(study))
    levels.push_back(level_at(*drawn.input, maps.axes[drawn.factor], place[drawn.factor]));
  return levels;
}

GridMapCollector::GridMapCollector(const Study& study) {
  std::optional<std::array<MapAxis, 2>> axes = map_axes(study);
  if (!axes) return;
  GridMaps maps{std::move(*axes), {}};
  if (maps.nodes() > kMostMapValues / std::max<std::size_t>(1, study.responses.size())) return;
  maps.responses.assign(study.responses.size(), GridMap(maps.nodes(), kNoResponse));
  nodes_ = nodes_of(maps);
  maps_ = std::move(maps);
}

void GridMapCollector::add(const RowBlock& block) {
  if (!maps_) return;
  const std::size_t width = maps_->responses.size();
  for (const auto row : up_to(block.rows)) {
    const std::size_t design = block.first + row;
    if (design == 0) continue;
    for (const auto k : up_to(width)) maps_->responses[k][nodes_[design - 1]] = block.responses[row * width + k];
  }
}

EnvelopeResult evaluate_envelope(const Study& study, const GridMaps& maps) { return Evaluator(study, maps).result(); }

GridMap normalised(const GridMaps& maps, const MeasureMap& measure) {
  GridMap map = maps.responses[measure.response];
  for (double& value : map) value /= measure.normalised_by;
  return map;
}

}  // namespace prs
