#include "prs/study/study_json.h"

#include "prs/indices.h"
#include "prs/study/recorded.h"

namespace prs {
namespace study_document {

template <class T>
using In = Within<StudyResult, T>;
using InRow = In<StudyRow>;
using InPoint = In<EnvelopePoint>;

struct FactorOf {
  const Factor* factor = nullptr;
  bool is_sampled = false;

  std::vector<FactorOf> companions() const {
    return each(factor->companions, [](const Factor& f) { return FactorOf{&f}; });
  }
};

}  // namespace study_document

Record<study_document::FactorOf> record_of(Type<study_document::FactorOf>);

namespace study_document {

// Varied inputs

constexpr Quantity<Level> kLevel[] = {
    {"value", always<&Level::text>},
    {"number", of<&Level::number>},
};

using Draws = Distribution::Kind;
template <Draws kind>
constexpr auto is = [](const Distribution& d) { return d.kind == kind; };

constexpr Quantity<Distribution> kInterval[] = {
    {"from", always<&Distribution::first>},
    {"to", always<&Distribution::second>},
};

constexpr Quantity<Distribution> kNormal[] = {
    {"mean", always<&Distribution::first>},
    {"deviation", always<&Distribution::second>},
};

constexpr Quantity<Distribution> kDistribution[] = {
    {"uniform", of_table<kInterval, std::identity{}, is<Draws::uniform>>},
    {"log_uniform", of_table<kInterval, std::identity{}, is<Draws::log_uniform>>},
    {"normal", of_table<kNormal, std::identity{}, is<Draws::normal>>},
    {"levels", of<is<Draws::levels>, is<Draws::levels>>},
};

template <auto get>
constexpr auto in = [](const FactorOf& f) -> decltype(auto) { return std::invoke(get, *f.factor); };

constexpr Quantity<FactorOf> kFactor[] = {
    {"path", always<in<&Factor::path>>},
    {"label", always<in<&Factor::label>>},
    {"unit", filled<in<&Factor::unit>>},
    {"base", of<in<&Factor::base>>},
    {"distribution", of_table<kDistribution, in<&Factor::distribution>, &FactorOf::is_sampled>},
    {"with", filled<&FactorOf::companions>, "inputs that change with it"},
};

constexpr auto sampled = [](const Study& study) { return is_sampled(study.plan); };

constexpr Quantity<Study> kStudy[] = {
    {"command", always<[](auto& study) { return name(study.command); }>},
    {"plan", always<&Study::plan>},
    {"samples", of<&Study::samples, sampled>},
    {"seed", of<&Study::seed, sampled>},
    {"factors", always<[](auto& study) {
       return each(study.factors, [&](const Factor& factor) { return FactorOf{&factor, sampled(study)}; });
     }>},
    {"responses", always<&Study::responses>},
};

// Statistics of the designs

constexpr Quantity<Histogram> kHistogram[] = {
    {"from", always<&Histogram::from>},
    {"to", always<&Histogram::to>},
    {"counts", always<&Histogram::counts>},
};

using Statistics = ResponseStatistics;
template <auto get>
constexpr auto of_some = of<get, [](const Statistics& s) { return s.count != 0; }>;

constexpr Quantity<Statistics> kStatistics[] = {
    {"count", always<&Statistics::count>},
    {"mean", of_some<&Statistics::mean>},
    {"standard_deviation", of_some<&Statistics::standard_deviation>},
    {"min", of_some<&Statistics::min>},
    {"min_design", of_some<&Statistics::min_design>},
    {"max", of_some<&Statistics::max>},
    {"max_design", of_some<&Statistics::max_design>},
    {"quantiles", of_some<[](auto& s) {
       ByKey<double> quantiles;
       for (const auto k : indices(kProbabilities))
         quantiles.emplace_back(fmt::format("{:g}", kProbabilities[k]), s.quantiles[k]);
       return quantiles;
     }>,
     "by their probability"},
    {"quantiles_from", of<&Statistics::values_kept, [](auto& s) { return s.values_kept < s.count; }>,
     "values that they are taken from"},
    {"histogram", of_table<kHistogram, &Statistics::histogram, [](auto& s) { return !s.histogram.counts.empty(); }>},
};

constexpr auto factor_of = [](const auto& part) -> const Factor& {
  return part.whole->study.factors[part.item->factor];
};
constexpr auto path = [](const auto& part) -> const std::string& { return factor_of(part).path; };

constexpr Quantity<In<FactorEffect>> kEffect[] = {
    {"path", always<path>},
    as_shown<In<FactorEffect>>({"contribution_percent", always<its<&FactorEffect::contribution_percent>>}),
    {"coefficient", always<its<&FactorEffect::coefficient>>},
    {"standard_error", of<its<&FactorEffect::standard_error>>},
};

template <auto list>
constexpr auto parts = [](const auto& part) { return within(*part.whole, std::invoke(list, *part.item)); };

constexpr Quantity<In<LinearFit>> kFit[] = {
    {"r_squared", always<its<&LinearFit::r_squared>>},
    {"adjusted_r_squared", of<its<&LinearFit::adjusted_r_squared>>},
    {"intercept", always<its<&LinearFit::intercept>>},
    {"factors", always_table<kEffect, parts<&LinearFit::effects>>},
};

constexpr Quantity<StudyResult> kSurface[] = {
    {"designs", always<[](auto& r) { return r.summary.surfaces->designs; }>},
    {"reason", filled<[](auto& r) { return r.summary.surfaces->reason; }>},
    {"responses", filled_table<kFit,
                               [](auto& r) {
                                 ByKey<In<LinearFit>> fits;
                                 for (const auto k : indices(r.summary.surfaces->fits))
                                   if (const std::optional<LinearFit>& fit = r.summary.surfaces->fits[k])
                                     fits.push_back({r.study.responses[k], {&r, &*fit}});
                                 return fits;
                               }>},
};

constexpr Quantity<Estimate> kEstimate[] = {
    {"value", always<&Estimate::value>},
    {"half_width_95", of<&Estimate::half_width>},
};

constexpr auto path_of_list = [](const auto& part) { return path_of_block(part.whole->study, part.item->factor); };

constexpr Quantity<In<FactorIndices>> kFactorIndices[] = {
    {"path", always<path_of_list>},
    {"first", always_table<kEstimate, its<&FactorIndices::first>>},
    {"total", always_table<kEstimate, its<&FactorIndices::total>>},
};

constexpr Quantity<In<ResponseIndices>> kIndices[] = {
    {"samples", always<its<&ResponseIndices::samples>>},
    {"samples_left_out", always<its<&ResponseIndices::left_out>>},
    {"variance", always<its<&ResponseIndices::variance>>},
    {"factors", always_table<kFactorIndices, parts<&ResponseIndices::factors>>},
};

constexpr Quantity<In<ToleranceGain>> kGain[] = {
    {"path", always<path_of_list>},
    {"quantile_95", always<its<&ToleranceGain::quantile>>},
    {"quantile_95_halved", always<its<&ToleranceGain::halved>>},
    {"gain_percent", of<its<&ToleranceGain::gain>>, "100 (1 - halved/quantile): what half the tolerance buys"},
};

constexpr Quantity<StudyResult> kSummary[] = {
    {"designs", always<&StudyResult::designs>},
    {"refused", always<&StudyResult::refused>},
    {"not_converged", always<&StudyResult::failed>},
    {"statistics", always_table<kStatistics, [](auto& r) { return by_key(r.study.responses, r.summary.statistics); }>,
     "by the paths of the responses"},
    {"response_surface", of_table<kSurface, std::identity{}, [](auto& r) { return r.summary.surfaces.has_value(); }>,
     "a plane through the responses over the ranges of the factors"},
    {"sobol_indices",
     filled_table<kIndices, [](auto& r) { return by_key(r.study.responses, within(r, r.summary.indices)); }>},
    {"tolerances",
     filled_table<kGain,
                  [](auto& r) {
                    return by_key(r.study.responses,
                                  each(r.summary.tolerances, [&](const auto& gains) { return within(r, gains); }));
                  }>,
     "what halving each deviation does to each response, the largest gain first"},
};

// The envelope.

constexpr Quantity<In<MapAxis>> kAxis[] = {
    {"path", always<path>},
    {"unit", filled<[](auto& a) { return factor_of(a).unit; }>},
    {"numbers", always<its<&MapAxis::numbers>>},
};

using Map = std::vector<std::vector<double>>;

/// The map as rows along the second factor.
static Map rows_of(const StudyResult& result, const GridMap& map) {
  const GridMaps& maps = *result.summary.maps;
  Map rows;
  for (const auto i : up_to(maps.axes[0].nodes()))
    rows.emplace_back(&map[maps.node(i, 0)], &map[maps.node(i, 0)] + maps.axes[1].nodes());
  return rows;
}

constexpr auto shows_maps = [](const StudyResult& r) { return r.summary.maps->nodes() <= kMostRowsShown; };

constexpr Quantity<In<MeasureMap>> kMeasure[] = {
    {"response", always<[](auto& m) { return m.whole->study.responses[m.item->response]; }>},
    {"weight", always<its<&MeasureMap::weight>>},
    {"rms", always<its<&MeasureMap::rms>>},
    {"normalised_by", always<its<&MeasureMap::normalised_by>>},
    {"designs_without", always<its<&MeasureMap::without>>},
    {"normalised", of<[](auto& m) { return rows_of(*m.whole, normalised(*m.whole->summary.maps, *m.item)); },
                      [](auto& m) { return shows_maps(*m.whole); }>},
};

template <auto get>
constexpr auto of_found = of<get, [](const InPoint& p) { return p.item->reason.empty(); }>;

constexpr Quantity<InPoint> kPoint[] = {
    {"name", always<its<&EnvelopePoint::name>>},
    {"reason", filled<its<&EnvelopePoint::reason>>},
    {"design", of_found<its<&EnvelopePoint::design>>},
    {"settings", filled<[](auto& p) {
       return by_key(each(drawn_inputs(p.whole->study), [](auto& drawn) { return drawn.input->path; }), p.item->inputs);
     }>,
     "by the paths of the inputs"},
    {"responses", of_found<[](auto& p) { return by_key(p.whole->study.responses, p.item->responses); }>,
     "by their paths"},
    {"normalised", of_found<[](auto& p) {
       const auto response = [&](auto& m) { return p.whole->study.responses[m.response]; };
       return by_key(each(p.whole->summary.envelope->measures, response), p.item->normalised);
     }>,
     "by the paths of the responses"},
    {"envelope", of_found<its<&EnvelopePoint::envelope>>},
};

template <auto get>
constexpr auto found = [](const StudyResult& r) -> decltype(auto) { return std::invoke(get, *r.summary.envelope); };
constexpr auto has_best = [](const StudyResult& r) { return r.summary.envelope->best.has_value(); };

constexpr Quantity<StudyResult> kEnvelope[] = {
    {"combine",
     always<[](auto& r) { return r.study.envelope->combine == Envelope::Combine::product ? "product" : "sum"; }>,
     "product | sum"},
    {"normalise", always<[](auto& r) {
       constexpr std::array kNames{"rms", "max", "none"};
       return kNames.at(static_cast<std::size_t>(r.study.envelope->normalise));
     }>,
     "rms | max | none"},
    {"axes", always_table<kAxis,
                          [](auto& r) {
                            const std::array<MapAxis, 2>& axes = r.summary.maps->axes;
                            return std::vector<In<MapAxis>>{{&r, &axes[0]}, {&r, &axes[1]}};
                          }>},
    {"measures", always_table<kMeasure, [](auto& r) { return within(r, r.summary.envelope->measures); }>},
    {"rms", of<found<&EnvelopeResult::rms>>},
    {"designs_without", of<found<&EnvelopeResult::without>>},
    {"max", of<[](auto& r) { return r.summary.envelope->values[*r.summary.envelope->best]; }, has_best>},
    {"max_design", of<[](auto& r) { return r.summary.maps->design(*r.summary.envelope->best); }, has_best>},
    {"values", of<[](auto& r) { return rows_of(r, r.summary.envelope->values); }, shows_maps>},
    {"maps_in", of<[](const StudyResult&) { return "envelope.csv"; }, [](auto& r) { return !shows_maps(r); }>,
     "the file with maps that are too large for here"},
    {"points", always_table<kPoint, [](auto& r) { return within(r, r.summary.envelope->points); }>},
};

// The document.

/// Entries of an array in a row, as far as the design has them.
static std::vector<double> entries_of(const StudyRow& row, const Recorded& array) {
  std::vector<double> entries;
  for (std::size_t k = 0; k < array.count && row.responses[array.first + k]; ++k)
    entries.push_back(*row.responses[array.first + k]);
  return entries;
}

constexpr Quantity<InRow> kRow[] = {
    {"settings", always<[](auto& row) {
       ByKey<const Level*> settings;
       for (const Setting& setting : row.item->design.settings) {
         const Factor& factor = row.whole->study.factors[setting.factor];
         settings.emplace_back(factor.path, &setting.level);
         for (const auto k : indices(factor.companions))
           settings.emplace_back(factor.companions[k].path, &setting.companions[k]);
       }
       return settings;
     }>,
     "by the paths of the inputs"},
    {"base", always<[](auto& row) { return is_base(row.whole->study, row.item->design); }>, "as in the file"},
    {"converged", always<[](auto& row) { return row.item->status.converged(); }>},
    {"status", always<[](auto& row) { return row.item->status.name; }>},
    {"reason", filled<[](auto& row) { return row.item->status.reason; }>},
    {"responses", always<[](auto& row) {
       ByKey<std::optional<double>> numbers;
       for (const Recorded& r : recorded(row.whole->study.responses))
         if (!r.is_array()) numbers.emplace_back(r.path, row.item->responses[r.first]);
       return numbers;
     }>,
     "by their paths"},
    {"arrays", filled<[](auto& row) {
       ByKey<std::vector<double>> arrays;
       for (const Recorded& r : recorded(row.whole->study.responses))
         if (std::vector<double> entries = entries_of(*row.item, r); r.is_array() && !entries.empty())
           arrays.emplace_back(r.path, std::move(entries));
       return arrays;
     }>,
     "responses that are arrays, by their paths; as long as in this design"},
};

constexpr Quantity<StudyDocument> kDocument[] = {
    {"study", always_table<kStudy, [](auto& d) -> const Study& { return d.result->study; }>},
    {"summary", always_table<kSummary, &StudyDocument::result>},
    {"envelope", of_table<kEnvelope, &StudyDocument::result, [](auto& d) { return !!d.result->summary.envelope; }>},
    {"designs_shown",
     of<[](auto& d) { return d.result->rows.size(); },
        [](auto& d) { return d.result->rows.size() < d.result->designs; }>,
     "where not all are; study.csv has all"},
    {"designs",
     always_table<kRow,
                  [](auto& d) { return d.with_rows ? within(*d.result, d.result->rows) : std::vector<InRow>(); }>},
};

}  // namespace study_document

PRS_RECORD(Level, "Level", "As in the file; the number in the unit of the factor.", study_document::kLevel);
PRS_RECORD(study_document::FactorOf, "Factor", "An input that varies.", study_document::kFactor);
PRS_RECORD(StudyDocument, "Study", "What a study finds.", study_document::kDocument);

std::string_view name(Plan plan) {
  constexpr std::array kNames{"one_at_a_time", "grid",          "latin_hypercube", "sobol",
                              "monte_carlo",   "sobol_indices", "derivatives",     "tolerances"};
  return kNames.at(static_cast<std::size_t>(plan));
}

Json study_outline(const StudyResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_object(document, StudyDocument{&result, false});
  return document;
}

Json study_json(const StudyResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_object(document, StudyDocument{&result});
  return document;
}

void write_study(const Json& outline, const StudyResult& result, const TextSink& sink) {
  const auto row = [&](std::size_t k) {
    return k < result.rows.size() ? std::optional(detail::json_by<study_document::kRow>(
                                        study_document::InRow{&result, &result.rows[k]}, kNoUnit))
                                  : std::nullopt;
  };
  write_with_list(outline, "designs", row, sink);
}

}  // namespace prs
