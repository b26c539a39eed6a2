#include "modules/estimation/model.h"

#include <algorithm>
#include <cmath>

#include "modules/estimation/statistics.h"

namespace modules::fit {
namespace {

Unknown in_logarithms(Unknown unknown) {
  for (double* const value : {&unknown.from, &unknown.to, &unknown.start}) *value = std::log(*value);
  if (auto& prior = unknown.prior) prior = {std::log(prior->mean), prior->deviation / prior->mean};
  return unknown;
}

Readings readings_of(const Curve& curve) {
  Readings r{.measured = vector_of(curve.measured),
             .weight = vector_of(curve.deviation).cwiseInverse(),
             .loss = curve.loss,
             .is_fitted = curve.use == Curve::Use::fit};
  r.is_estimated = r.is_fitted && curve.deviation.empty();
  if (curve.deviation.empty()) r.weight = VectorXd::Ones(r.measured.size());
  // The zero of a probe says nothing of its noise.
  const double middle = r.is_estimated && curve.offset ? r.measured.mean() : 0.0;
  if (r.is_estimated) r.floor = std::max(1e-6 * (r.measured.array() - middle).abs().maxCoeff(), 1e-150);
  return r;
}

}  // namespace

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double Model::value(Index j, double z) const { return unknown(j).is_log ? std::exp(u(j, z)) : u(j, z); }

Estimate Model::shown(Index j, const Estimate& e) const {
  if (!unknown(j).is_log) return e;
  const double value = std::exp(e.value);
  return {value, e.deviation * value, std::exp(e.low), std::exp(e.high), e.degrees_of_freedom};
}

double Model::offset(std::size_t curve, const VectorXd& z) const {
  const auto& of_curve = problem.curves[curve].offset;
  const auto j = static_cast<Index>(of_curve.value_or(0));
  return of_curve ? u(j, z[j]) : 0.0;
}

Request Model::request(const VectorXd& z, std::vector<bool> of_curves) const {
  Request r{.values = {}, .curves = std::move(of_curves)};
  for (Index j = 0; j < count(); ++j) r.values.push_back(value(j, z[j]));
  return r;
}

VectorXd Model::moved(const VectorXd& z, const VectorXd& step) const {
  VectorXd next = z + step;
  for (Index j = 0; j < count(); ++j)
    if (unknown(j).is_bounded) next[j] = std::clamp(next[j], 0.0, 1.0);
  return next;
}

Model model_of(const Problem& problem) {
  Model m{.problem = problem, .unknowns = {}, .curves = {}, .fitted = {}, .prior = {}};
  for (const Unknown& unknown : problem.unknowns)
    m.unknowns.push_back(unknown.is_log ? in_logarithms(unknown) : unknown);
  for (const Curve& curve : problem.curves) {
    if (curve.use == Curve::Use::fit) m.fitted.push_back(m.curves.size());
    m.curves.push_back(readings_of(curve));
  }
  m.prior = MatrixXd::Zero(m.count(), m.count());
  for (Index j = 0; j < m.count(); ++j)
    if (const auto& prior = m.unknown(j).prior) m.prior(j, j) = std::pow(m.range(j) / prior->deviation, 2);
  return m;
}

Spread first_spread(const Model& model) {
  Spread spread;
  for (const Readings& r : model.curves)
    spread.push_back(r.is_estimated
                         ? std::max(0.05 * std::sqrt((r.measured.array() - r.measured.mean()).square().mean()), r.floor)
                         : 1.0);
  return spread;
}

VectorXd start_of(const Model& model, std::size_t k) {
  VectorXd z(model.count());
  for (Index j = 0; j < model.count(); ++j)
    z[j] = k == 0 ? (model.unknown(j).start - model.unknown(j).from) / model.range(j)
                  : halton(k, static_cast<std::size_t>(j));
  return z;
}

}  // namespace modules::fit
