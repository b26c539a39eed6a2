#include "prs/study/study_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "prs/study/idle_factors.h"
#include "prs/study/sampling.h"

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

/// The rows of up to `kMostValuesKept` designs, those whose numbers have the smallest hashes.
class KeptRows {
 public:
  explicit KeptRows(std::size_t responses) : responses_(responses) {}

  void add(std::span<const double> row, std::size_t design) {
    const std::uint64_t hash = mixed_bits(design + kGoldenStep);
    if (hash > largest_) return;
    hashes_.push_back(hash);
    values_.insert(values_.end(), row.begin(), row.end());
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
  /// Hashes of different designs differ.
  void leave_out_others() {
    if (hashes_.size() <= kMostValuesKept) return;
    std::vector<std::uint64_t> hashes = hashes_;
    const auto last = hashes.begin() + kMostValuesKept - 1;
    std::nth_element(hashes.begin(), last, hashes.end());
    largest_ = *last;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < hashes_.size(); ++k) {
      if (hashes_[k] > largest_) continue;
      hashes_[kept] = hashes_[k];
      if (kept != k) std::copy_n(&values_[k * responses_], responses_, &values_[kept * responses_]);
      ++kept;
    }
    hashes_.resize(kept);
    values_.resize(kept * responses_);
  }

  std::size_t responses_ = 0;
  std::uint64_t largest_ = std::numeric_limits<std::uint64_t>::max();  ///< Hash that is taken.
  std::vector<std::uint64_t> hashes_;
  std::vector<double> values_;
};

/// Quantiles at `kProbabilities`, from values that it sorts.
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

/// Twice the cube root of the number of values for classes (Rice's rule).
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

std::vector<std::optional<double>> numbers(const RowBlock& block, std::size_t row,
                                           std::size_t responses) {
  std::vector<std::optional<double>> numbers(responses);
  for (std::size_t j = 0; j < responses; ++j) {
    const double value = block.responses[row * responses + j];
    if (!std::isnan(value)) numbers[j] = value;
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
      reason = fmt::format("it takes at most {} factors, the study has {}", kMostFactorsOfSurface,
                           factors.size());
      factors.clear();
    }
    regression = LinearRegression(factors.size(), study.responses.size());
    if (study.plan != Plan::sobol_indices) return;
    const std::size_t d = study.factors.size();
    indices.assign(study.responses.size(), VarianceIndices(d, study.samples));
    sample.assign(study.responses.size(), std::vector<double>(d + 2));
  }

  void add(std::span<const double> row, std::size_t design, std::span<const double> inputs) {
    followed.add(row, design);
    if (design == 0) return;
    if (!indices.empty() && !add_to_sample(row, design)) return;
    if (!any_finite(row)) return;
    for (std::size_t j = 0; j < row.size(); ++j)
      if (std::isfinite(row[j])) moments[j].add(row[j], design);
    kept.add(row, design);
    if (!factors.empty() && all_finite(row)) add_to_surface(row, inputs);
  }

  void add_to_surface(std::span<const double> row, std::span<const double> inputs) {
    for (std::size_t i = 0; i < factors.size(); ++i)
      x[i] = factors[i](inputs[input_of_factor[factors[i].factor]]);
    if (all_finite(x)) regression.add(x, row);
  }

  /// Whether the design is one of the two that are drawn independently of each other.
  bool add_to_sample(std::span<const double> row, std::size_t design) {
    const std::size_t designs = study.factors.size() + 2, k = (design - 1) % designs;
    for (std::size_t j = 0; j < row.size(); ++j) {
      sample[j][k] = row[j];
      if (k + 1 == designs) indices[j].add(sample[j]);
    }
    return k < 2;
  }

  Study study;
  FollowedFactors followed;
  std::vector<FactorColumn> columns;
  std::vector<NormalisedFactor> factors;
  std::vector<std::size_t> input_of_factor;  ///< Among `drawn_inputs`.
  std::size_t next = 0;                      ///< Design.
  std::vector<Moments> moments;
  KeptRows kept;
  std::string reason;  ///< Why there is no response surface.
  LinearRegression regression;
  std::vector<double> x;                    ///< Normalised factors of one design.
  std::vector<VarianceIndices> indices;     ///< One per response, for plan sobol_indices.
  std::vector<std::vector<double>> sample;  ///< A response of the designs of one sample.
  std::optional<GridMapCollector> maps;     ///< For a study with an envelope.
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
  if (inputs.empty())
    inputs = drawn = factor_values(parts_->study, columns, block.first, block.rows);
  assert(inputs.size() == block.rows * width);
  const std::vector<double> none(responses, kNoResponse);
  for (std::size_t k = 0; k < block.rows; ++k)
    parts_->add(block.status(k).converged()
                    ? std::span(block.responses).subspan(k * responses, responses)
                    : none,
                block.first + k, inputs.subspan(k * width, width));
  if (parts_->maps) parts_->maps->add(block);
  parts_->next += block.rows;
}

StudySummary StudyAnalysis::summary() const {
  StudySummary summary;
  for (std::size_t j = 0; j < parts_->moments.size(); ++j) {
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
  for (const VarianceIndices& indices : parts_->indices)
    summary.indices.push_back(indices.result());
  summary.idle_factors = parts_->followed.idle();
  if (parts_->maps && parts_->maps->maps()) {
    summary.maps = parts_->maps->maps();
    summary.envelope = evaluate_envelope(parts_->study, *summary.maps);
  }
  return summary;
}

void add(StudyResult& result, const RowBlock& block) {
  if (result.rows.empty())
    result.rows.reserve(std::min(kMostRowsShown, design_count(result.study)));
  for (std::size_t k = 0; k < block.rows; ++k) {
    const DesignStatus status = block.status(k);
    if (!status.converged()) ++(status.name == "refused" ? result.refused : result.failed);
    if (result.rows.size() >= kMostRowsShown) continue;
    result.rows.push_back({design(result.study, block.first + k), status,
                           numbers(block, k, result.study.responses.size())});
  }
  result.designs += block.rows;
}

}  // namespace prs
