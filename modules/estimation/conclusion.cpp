#include "modules/estimation/conclusion.h"

#include <algorithm>
#include <cmath>

#include "modules/estimation/profile.h"

namespace modules::fit {
namespace {

UnknownResult& unknown_result(Result& result, Index j) { return result.unknowns[static_cast<std::size_t>(j)]; }

// Identifiability and tests.

Spectrum spectrum_at(const Search& s, const State& state, const Normal& n) {
  const Model& model = s.model;
  std::vector<MatrixXd> blocks{model.prior.cwiseSqrt()};
  for (const std::size_t c : model.fitted)
    blocks.push_back(std::sqrt(n.curves[c].a) / s.spread[c] * model.curves[c].weight.asDiagonal() *
                     state.slopes.by_z[c]);
  Index rows = 0;
  for (const MatrixXd& block : blocks) rows += block.rows();
  MatrixXd all(rows, model.count());
  for (const MatrixXd& block : blocks) all.middleRows(rows -= block.rows(), block.rows()) = block;
  return spectrum_of(all);
}

void add_unidentified(Result& result, Unidentified direction) {
  if (direction.direction[0] < 0.0)
    for (double& v : direction.direction) v = -v;
  for (const std::size_t j : direction.unknowns) result.unknowns[j].is_identified = false;
  result.unidentified.push_back(std::move(direction));
}

void set_unidentified(const Spectrum& spectrum, Result& result) {
  result.singular_value_ratios.assign(spectrum.ratios.begin(), spectrum.ratios.end());
  for (Index k = 0; k < spectrum.ratios.size(); ++k) {
    if (spectrum.ratios[k] >= Spectrum::kLeastRatio) continue;
    Unidentified direction{.unknowns = {}, .direction = {}, .ratio = spectrum.ratios[k]};
    for (std::size_t i = 0; i < spectrum.columns.size(); ++i) {
      const double v = spectrum.vectors(static_cast<Index>(i), k);
      if (std::abs(v) < 0.1) continue;
      direction.unknowns.push_back(static_cast<std::size_t>(spectrum.columns[i]));
      direction.direction.push_back(v);
    }
    add_unidentified(result, std::move(direction));
  }
  for (Index j = 0; j < spectrum.length.size(); ++j)
    if (std::ranges::find(spectrum.columns, j) == spectrum.columns.end()) {
      result.singular_value_ratios.push_back(0.0);
      add_unidentified(result, {.unknowns = {static_cast<std::size_t>(j)}, .direction = {1.0}, .ratio = 0.0});
    }
}

/// Factor of the identified combination of two unknowns of one scale.
void set_factor(const Model& model, const Spectrum& spectrum, Unidentified& d) {
  if (d.unknowns.size() != 2) return;
  const auto a = static_cast<Index>(d.unknowns[0]), b = static_cast<Index>(d.unknowns[1]);
  if (model.unknown(a).is_log == model.unknown(b).is_log)
    d.factor = -(d.direction[0] * model.range(a) / spectrum.length[a]) /
               (d.direction[1] * model.range(b) / spectrum.length[b]);
}

/// Sets values; an unidentified unknown is never held at a bound.
void set_values(const Search& s, Normal& n, Result& result) {
  std::vector<Index> free;
  for (Index j = 0; j < s.model.count(); ++j) {
    UnknownResult& one = unknown_result(result, j);
    if (one.is_identified) one.at_bound = pushed_out(s.model, s.z, n.gradient, j);
    if (one.at_bound == 0) free.push_back(j);
    if (one.is_identified) one.value = s.model.value(j, s.z[j]);
  }
  invert(n, s.model, std::move(free));
}

void set_tests(const Search& s, const State& state, Normal& n, Result& result) {
  double tested_redundancy = 0.0;
  for (const std::size_t c : s.model.fitted) {
    Weighed& w = n.curves[c];
    const bool is_robust = s.model.curves[c].loss.is_robust();
    const Robust r = robust_at(s.model, state, c, s.spread);
    if (is_robust && w.redundancy > 0.0) w.b = r.psi.square().sum() / w.redundancy;
    result.degrees_of_freedom += w.redundancy;
    const bool spent = (w.is_estimated && w.redundancy < 1.0 - 1e-9) || (is_robust && w.a <= kLeastSlope);
    if (spent && !result.without_redundancy) result.without_redundancy = c;
    if (w.has_own_spread) continue;
    result.chi_square = result.chi_square.value_or(0.0) + r.scaled.square().sum();
    tested_redundancy += w.redundancy;
  }
  if (!(tested_redundancy > 1e-9)) return;
  result.reduced_chi_square = *result.chi_square / tested_redundancy;
  result.p_value = chi_square_beyond(*result.chi_square, tested_redundancy);
}

// Deviations.

void set_estimates(const Search& s, const Normal& n, const Covariance& covariance, Result& result) {
  const Model& model = s.model;
  for (const Index j : n.free) {
    UnknownResult& one = unknown_result(result, j);
    if (!one.is_identified) continue;
    result.with_deviation.push_back(static_cast<std::size_t>(j));
    const Estimate e =
        covariance.of(VectorXd::Unit(model.count(), j) * model.range(j), model.u(j, s.z[j]), model.problem.level);
    const auto& prior = model.unknown(j).prior;
    one.prior_decides = prior && e.deviation > 0.9 * prior->deviation;
    one.estimate = model.shown(j, e);
  }
}

void set_covariance(const Model& model, const MatrixXd& full, Result& result) {
  VectorXd by_z(model.count());
  for (Index j = 0; j < model.count(); ++j)
    by_z[j] = model.range(j) * (model.unknown(j).is_log ? unknown_result(result, j).value.value_or(0.0) : 1.0);
  for (const std::size_t i : result.with_deviation) {
    std::vector<double>&row = result.covariance.emplace_back(), &correlations = result.correlation.emplace_back();
    for (const std::size_t k : result.with_deviation) {
      const auto a = static_cast<Index>(i), b = static_cast<Index>(k);
      row.push_back(full(a, b) * by_z[a] * by_z[b]);
      correlations.push_back(i == k ? 1.0 : full(a, b) / std::sqrt(full(a, a) * full(b, b)));
    }
  }
}

void set_combination(const Search& s, const Covariance* covariance, Unidentified& d) {
  if (d.factor == 0.0) return;
  const Model& model = s.model;
  const auto a = static_cast<Index>(d.unknowns[0]), b = static_cast<Index>(d.unknowns[1]);
  const double value = model.u(a, s.z[a]) + d.factor * model.u(b, s.z[b]);
  VectorXd g = VectorXd::Zero(model.count());
  g[a] = model.range(a), g[b] = d.factor * model.range(b);
  d.combination = model.shown(a, covariance ? covariance->of(g, value, model.problem.level) : Estimate{.value = value});
}

// Curves.

/// Adds the curves that are not fitted; one without an answer leaves the others theirs.
void add_others(const Search& s, const std::vector<std::size_t>& others, State& state, Result& result) {
  std::vector<Request> requests;
  const std::size_t count = s.model.curves.size();
  for (const std::size_t c : others) {
    std::vector<bool> alone(count);
    alone[c] = true;
    requests.push_back(s.model.request(s.z, alone));
  }
  const std::vector<Answer> answers = s.model.problem.evaluate(requests);
  Mask answered = Mask::Constant(static_cast<Index>(count), s.model.count(), false);
  for (std::size_t k = 0; k < others.size(); ++k)
    if (answers[k].failure) {
      if (!result.failure) result.failure = answers[k].failure;
    } else {
      state.values[others[k]] = vector_of(answers[k].values[others[k]]);
      answered.row(static_cast<Index>(others[k])).setConstant(true);
    }
  Slopes found = s.function.slopes(s.z, state.values, answered);
  if (!found && !result.failure) result.failure = found.failure;
  if (result.failure) result.status = Status::no_equilibrium;
  for (const std::size_t c : others)
    if (found)
      state.slopes.by_z[c] = std::move(found.by_z[c]);
    else
      state.values[c].resize(0);
}

void set_band(const Covariance& covariance, const MatrixXd& slopes, double level, CurveResult& curve) {
  for (std::size_t i = 0; i < curve.fitted.size(); ++i) {
    const Estimate e = covariance.of(slopes.row(static_cast<Index>(i)).transpose(), curve.fitted[i], level);
    curve.band_deviation.push_back(e.deviation);
    curve.low.push_back(e.low);
    curve.high.push_back(e.high);
  }
}

/// How the readings lie about the curve.
void set_residuals(const Readings& readings, const VectorXd& fitted, CurveResult& curve) {
  const VectorXd &y = readings.measured, residual = y - fitted;
  curve.residual.assign(residual.begin(), residual.end());
  curve.rms = std::sqrt(residual.squaredNorm() / static_cast<double>(y.size()));
  if (y.maxCoeff() > y.minCoeff())
    curve.r_squared = 1.0 - residual.squaredNorm() / (y.array() - y.mean()).square().sum();
  curve.runs = runs_of(curve.residual);
}

void set_weights(const Search& s, const State& state, const Normal& n, std::size_t c, CurveResult& curve) {
  const Readings& readings = s.model.curves[c];
  const ArrayXd deviation = s.spread[c] / readings.weight.array();
  const Robust r = robust_at(s.model, state, c, s.spread);
  curve.deviation.assign(deviation.begin(), deviation.end());
  curve.weight.assign(r.weight.begin(), r.weight.end());
  curve.is_without_noise = readings.is_estimated && s.spread[c] <= readings.floor;
  curve.redundancy = n.curves[c].redundancy;
  curve.chi_square = r.scaled.square().sum();
}

}  // namespace

Normal conclude(const Search& s, Status status, Result& result) {
  const StatePtr state = s.function.with_slopes(s.z);
  Normal n = normal_at(s.model, *state, s.spread);
  result.objective = n.objective;
  result.status = status;
  result.unknowns.assign(s.model.unknowns.size(), {});
  const Spectrum spectrum = spectrum_at(s, *state, n);
  set_unidentified(spectrum, result);
  for (Unidentified& direction : result.unidentified) set_factor(s.model, spectrum, direction);
  set_values(s, n, result);
  set_tests(s, *state, n, result);
  if (!result.unidentified.empty()) result.status = std::min(result.status, Status::not_identifiable);
  if (result.without_redundancy) result.status = std::min(result.status, Status::no_redundancy);
  return n;
}

void add_uncertainty(Search& s, const Normal& n, Result& result) {
  const Model& model = s.model;
  const Covariance covariance = covariance_of(n.curves, model.prior, n.inverse);
  const bool has_deviations = !result.without_redundancy;
  if (has_deviations) set_estimates(s, n, covariance, result);
  set_covariance(model, covariance.full, result);
  for (Unidentified& direction : result.unidentified)
    set_combination(s, has_deviations ? &covariance : nullptr, direction);

  const bool everywhere = has_deviations && result.unidentified.empty();
  State state = *s.function.with_slopes(s.z);
  std::vector<std::size_t> others;
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    if (!model.curves[c].is_fitted && (everywhere || model.problem.curves[c].use == Curve::Use::compare))
      others.push_back(c);
  if (!others.empty()) add_others(s, others, state, result);
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    CurveResult& curve = result.curves[c];
    const Readings& readings = model.curves[c];
    VectorXd fitted = state.values[c];
    if (fitted.size() == 0) continue;
    if (model.problem.curves[c].has_free_mean) fitted.array() += (readings.measured - fitted).mean();
    curve.fitted.assign(fitted.begin(), fitted.end());
    if (has_deviations && (readings.is_fitted || everywhere))
      set_band(covariance, state.slopes.by_z[c], model.problem.level, curve);
    if (readings.measured.size() > 0) set_residuals(readings, fitted, curve);
    if (readings.is_fitted) set_weights(s, state, n, c, curve);
  }

  for (const std::size_t j : model.problem.profile)
    if (result.unknowns[j].estimate) set_profile(s, n, covariance, static_cast<Index>(j), result.unknowns[j]);
}

}  // namespace modules::fit
