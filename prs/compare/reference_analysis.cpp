#include "prs/compare/reference_analysis.h"

#include <array>

#include "prs/bodies/body_models.h"
#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

/// A model's answer to a reference.
struct ReferenceModel {
  ComparedReference of;
  std::size_t model = 0;

  const ReferenceCurve& reference() const { return of.reference(); }
  const ReferenceAnswer& answer() const { return of.found().models[model]; }
  std::string_view bodies() const { return name_of_model(of.comparison->models[model].model); }
  /// A number of the deviations.
  template <class Get>
  std::optional<double> deviation(Get get) const {
    return answer().deviations ? std::optional<double>(std::invoke(get, *answer().deviations)) : std::nullopt;
  }
  template <class Get>
  std::optional<double> percent_of_mean(Get get) const {
    const double mean = reference().mean_magnitude();
    return mean > 0.0 ? scaled(deviation(get), 100.0 / mean) : std::nullopt;
  }
  std::optional<double> largest_at() const {
    if (!answer().deviations || reference().along.empty()) return std::nullopt;
    return reference().readings[answer().deviations->largest_at].along;
  }
};

/// The deviation of largest magnitude.
struct LargestDeviation {
  ReferenceModel of;
};

std::optional<LargestDeviation> largest_deviation(const ReferenceModel& m) {
  return m.answer().deviations ? std::optional(LargestDeviation{m}) : std::nullopt;
}

/// The answer of the model that the case states.
ReferenceModel stated_model(const ComparedReference& r) { return {r, r.found().stated}; }

/// A reading and the result of each model for it.
struct ComparedReading {
  ComparedReference of;
  std::size_t index = 0;

  const ReferenceReading& reading() const { return of.reference().readings[index]; }
};

std::vector<ReferenceModel> models_of(const ComparedReference& r) {
  std::vector<ReferenceModel> models;
  for (const auto m : indices(r.found().models)) models.push_back({r, m});
  return models;
}

std::vector<ComparedReading> readings_of(const ComparedReference& r) {
  std::vector<ComparedReading> readings;
  for (const auto k : indices(r.reference().readings)) readings.push_back({r, k});
  return readings;
}

/// Results of the models at a reading.
struct ComputedThere {
  ComparedReading at;
};

template <std::size_t kModel>
constexpr auto computed_by = of<[](const ComputedThere& c) -> std::optional<double> {
  for (const ReferenceModel& m : models_of(c.at.of))
    if (m.of.comparison->models[m.model].model.bodies == &kBodyModels[kModel].model)
      return m.answer().computed[c.at.index];
  return std::nullopt;
}>;

constexpr double kPerKilonewton = 1e3;  ///< Slopes are shown per kN.

std::optional<std::string> slope_unit(const ComparedReference& r) {
  if (!r.found().slope) return std::nullopt;
  return fmt::format("{}/kN", r.reference().unit.empty() ? "1" : r.reference().unit);
}

/// Stiffness of a curve of displacements over the force [N/m].
std::optional<double> stiffness(const ReferenceCurve& reference, std::optional<double> slope) {
  if (reference.response != "axial_displacement_um" || !slope || *slope == 0.0) return std::nullopt;
  return "µm"_per_si / *slope;
}

template <class T>
std::optional<std::string> unless_empty(const T& text) {
  return text.empty() ? std::nullopt : std::optional<std::string>(text);
}

}  // namespace

Record<LargestDeviation> record_of(Type<LargestDeviation>);
Record<ReferenceModel> record_of(Type<ReferenceModel>);
Record<ComparedReading> record_of(Type<ComparedReading>);
Record<ComputedThere> record_of(Type<ComputedThere>);

namespace {

constexpr auto kMean = &CurveDeviations::mean;
constexpr auto kRms = &CurveDeviations::rms;
constexpr auto kLargest = &CurveDeviations::largest;

constexpr Quantity<LargestDeviation> kLargestDeviation[] = {
    {"value", of<[](auto& d) { return d.of.deviation(kLargest); }>, "with its sign"},
    {"percent_of_mean", of<[](auto& d) { return d.of.percent_of_mean(kLargest); }>,
     "of the mean magnitude of the reference"},
    {"at", of<[](auto& d) { return d.of.largest_at(); }>, "where it is, in `along_unit`"},
};

constexpr Quantity<ReferenceModel> kReferenceModel[] = {
    {"bodies", of<&ReferenceModel::bodies>, "bars | refined | influence of one sector, or full: all rollers"},
    {"mean_deviation", of<[](auto& m) { return m.deviation(kMean); }>, "mean of computed less reference"},
    {"rms_deviation", of<[](auto& m) { return m.deviation(kRms); }>, "root mean square"},
    {"largest_deviation", of<largest_deviation>, "of largest magnitude"},
    {"mean_deviation_percent_of_mean", of<[](auto& m) { return m.percent_of_mean(kMean); }>,
     "of the mean magnitude of the reference"},
    {"rms_deviation_percent_of_mean", of<[](auto& m) { return m.percent_of_mean(kRms); }>, "of the same"},
    {"slope", of<[](auto& m) { return scaled(m.answer().slope, kPerKilonewton); }>,
     "over the force, by least squares, in `slope_unit`"},
    {"stiffness_N_per_um", of<[](auto& m) { return stiffness(m.reference(), m.answer().slope); }>,
     "force over displacement, by the same line"},
    {"met", of<[](auto& m) { return m.reference().tolerance ? std::optional(m.answer().met()) : std::nullopt; }>,
     "whether no deviation is beyond the tolerance"},
};

constexpr Quantity<ComparedReading> kReading[] = {
    {"along",
     of<[](auto& r) { return r.of.reference().along.empty() ? std::nullopt : std::optional(r.reading().along); }>,
     "where it stands, in `along_unit`; threads from 1"},
    {"reference", of<[](auto& r) { return r.reading().value; }>, "the reference's number"},
    {"reference_deviation", of<[](auto& r) { return r.reading().deviation; }>, "its own deviation, where it is stated"},
    {"computed", of<[](auto& r) { return ComputedThere{r}; }>, "by the models"},
};

const auto kComputedThere = []<std::size_t... kModels>(std::index_sequence<kModels...>) {
  return std::array{Quantity<ComputedThere>{kBodyModels[kModels].model.name, computed_by<kModels>,
                                            kBodyModels[kModels].model.help}...};
}
(std::make_index_sequence<std::size(kBodyModels)>());

template <auto member>
constexpr auto of_reference = of<[](auto& r) { return r.reference().*member; }>;

constexpr Quantity<ComparedReference> kReference[] = {
    {"name", of_reference<&ReferenceCurve::name>, "of the reference; by default that of its file"},
    {"file", of_reference<&ReferenceCurve::file>, "as the case names it"},
    {"load_case", of<[](auto& r) { return unless_empty(r.reference().load_case); }>,
     "that it belongs to; absent of the whole case"},
    {"response", of_reference<&ReferenceCurve::response>, "path in the load case or the whole case"},
    {"unit", of_reference<&ReferenceCurve::unit>, "of the response and of all deviations; empty of ratios"},
    {"along", of<[](auto& r) { return unless_empty(r.reference().along); }>,
     "`thread`, or the input that readings set; absent of a single number"},
    {"along_unit", of<[](auto& r) { return unless_empty(r.reference().along_unit); }>, "of the places"},
    {"count", of<[](auto& r) { return r.reference().readings.size(); }>, "of readings"},
    {"mean", of<[](auto& r) { return r.reference().mean_magnitude(); }>, "mean magnitude of the reference"},
    {"sum", of<[](auto& r) { return r.found().sum; }>, "over a complete set of threads, of shares and of axial loads"},
    {"expected_sum", of<[](auto& r) { return r.found().expected_sum; }>, "what the load of a roller makes of it"},
    {"reference_sum_percent",
     of<[](auto& r) { return r.found().sum ? std::optional(*r.found().sum / *r.found().expected_sum) : std::nullopt; }>,
     "that sum in % of the expected one"},
    {"mean_deviation", of<[](auto& r) { return stated_model(r).deviation(kMean); }>,
     "mean of computed less reference, by the model of the bodies that the case states, as the next two"},
    {"rms_deviation", of<[](auto& r) { return stated_model(r).deviation(kRms); }>, "root mean square"},
    {"largest_deviation", of<[](auto& r) { return largest_deviation(stated_model(r)); }>, "of largest magnitude"},
    {"slope", of<[](auto& r) { return scaled(r.found().slope, kPerKilonewton); }>,
     "of the reference over the force, by least squares"},
    {"slope_unit", of<slope_unit>, "of slopes"},
    {"stiffness_N_per_um", of<[](auto& r) { return stiffness(r.reference(), r.found().slope); }>,
     "force over displacement, by the same line"},
    {"tolerance",
     of<[](auto& r) { return r.reference().tolerance ? std::optional(r.reference().tolerance->text) : std::nullopt; }>,
     "as the case has it"},
    {"met", of<[](auto& r) { return r.reference().tolerance ? std::optional(r.found().met()) : std::nullopt; }>,
     "by the model of the bodies that the case states"},
    {"models", of<models_of>, "as in `comparison`"},
    {"points", of<readings_of>, "readings, ascending"},
};

}  // namespace

PRS_RECORD(ComputedThere, "ComputedThere", "Results of the models at a reading of a reference.", kComputedThere);
PRS_RECORD(LargestDeviation, "LargestDeviation", "The deviation of largest magnitude from a reference.",
           kLargestDeviation);
PRS_RECORD(ReferenceModel, "ReferenceModel", "How far a model lies from a reference.", kReferenceModel);
PRS_RECORD(ComparedReading, "ReferencePoint", "A reading of a reference, and what is computed there.", kReading);
PRS_RECORD(ComparedReference, "ComparedReference", "A curve of another program or a test against the case.",
           kReference);

namespace {

std::vector<ComparedReference> references_of(const ModelComparison& c) {
  std::vector<ComparedReference> all;
  for (const auto k : indices(c.references)) all.push_back({&c, k});
  return all;
}

std::string with_sign(const std::string& text) { return text.starts_with('-') || text == kAbsent ? text : "+" + text; }

/// Cells of a model in the table: mean, rms and largest deviation, its place, the last two in % of the mean, verdict.
std::vector<std::string> cells_of(const ReferenceModel& m) {
  const double factor = table_response(m.reference().response).factor;
  const double largest = std::abs(m.deviation(kLargest).value_or(0.0) * factor);
  const int decimals = largest > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 9) : 0;
  const auto number = [&](std::optional<double> value) { return fixed(value, factor, decimals); };
  const auto percent = [&](std::optional<double> value) { return fixed(value, 1.0, 1); };
  std::string verdict;
  if (m.reference().tolerance) verdict = m.answer().met() ? "met" : "not met";
  return {with_sign(number(m.deviation(kMean))),
          number(m.deviation(kRms)),
          with_sign(number(m.deviation(kLargest))),
          digits(m.largest_at(), 4),
          percent(m.percent_of_mean(kRms)),
          with_sign(percent(m.percent_of_mean(kLargest))),
          std::move(verdict)};
}

/// `fe, push: screw share of the load, %`
std::string title_of(const ReferenceCurve& r) {
  return fmt::format("{}{}{}: {}", printable(r.name), r.load_case.empty() ? "" : ", ", shown_name(r.load_case),
                     table_response(r.response).text());
}

/// Lines on the reference alone, above those of the models.
std::string facts_of(const ComparedReference& of) {
  const ReferenceCurve& r = of.reference();
  const double factor = table_response(r.response).factor;
  std::string text = fmt::format("{} point{}", r.readings.size(), r.readings.size() == 1 ? "" : "s");
  text += fmt::format(", mean {}", digits(r.mean_magnitude() * factor, 4));
  if (of.found().sum)
    text += fmt::format(", sum {} of {}", digits(*of.found().sum * factor, 4),
                        digits(*of.found().expected_sum * factor, 4));
  if (const auto k = stiffness(r, of.found().slope))
    text += fmt::format(", stiffness {}", fixed_with_unit(k, "N/µm", 1));
  else if (of.found().slope)
    text += fmt::format(", slope {} {}", digits(*of.found().slope * kPerKilonewton, 4), *slope_unit(of));
  if (r.tolerance) text += fmt::format("; tolerance {}", printable(r.tolerance->text));
  return text;
}

std::string model_cell(const ReferenceModel& m) {
  std::string text(m.bodies());
  if (const auto k = stiffness(m.reference(), m.answer().slope))
    text += fmt::format(", {}", fixed_with_unit(k, "N/µm", 1));
  else if (m.answer().slope)
    text += fmt::format(", {} {}", digits(*m.answer().slope * kPerKilonewton, 4), *slope_unit(m.of));
  return text;
}

}  // namespace

void put_references(Json& document, const ModelComparison& c) {
  for (const ComparedReference& r : references_of(c)) document["references"].push_back(object_of(r));
}

std::string reference_table(const ModelComparison& c) {
  if (c.references.empty()) return {};
  constexpr TableRows kRow{24, 10, 1};
  std::string text = "\n" + kRow("computed less reference", {"mean", "rms", "largest", "at", "rms, %", "largest, %"}) +
                     kRow("", {"", "", "", "", "of mean", "of mean"});
  const std::size_t shown = std::min(c.references.size(), kMaxUnfoldedCases);
  for (const auto k : up_to(shown)) {
    const ComparedReference of{&c, k};
    text += ended("  " + title_of(of.reference())) + ended("    " + facts_of(of));
    for (const ReferenceModel& m : models_of(of)) {
      std::vector<std::string> cells = cells_of(m);
      const std::string verdict = std::move(cells.back());
      cells.pop_back();
      text += kRow("    " + model_cell(m), cells, "  " + verdict);
    }
  }
  if (shown < c.references.size())
    text += fmt::format("  … {} of {} references; {}\n", shown, c.references.size(), all_in("references.csv"));
  return text;
}

PageTable reference_page_table(const ModelComparison& c) {
  PageTable table{"References",
                  {"Reference", "Model", "Mean", "Rms", "Largest", "At", "Rms, % of the mean", "Largest, % of the mean",
                   "Tolerance"},
                  {}};
  for (const ComparedReference& of : references_of(c))
    for (const ReferenceModel& m : models_of(of)) {
      std::vector<std::string> row{m.model == 0 ? fmt::format("{} ({})", title_of(of.reference()), facts_of(of)) : "",
                                   model_cell(m)};
      std::ranges::move(cells_of(m), std::back_inserter(row));
      table.rows.push_back(std::move(row));
    }
  return table;
}

std::string references_csv(const ModelComparison& c, const CsvStyle& style) {
  CsvRows csv(style);
  for (const ComparedReference& of : references_of(c))
    for (const ComparedReading& reading : readings_of(of)) {
      csv.record("", of, "", "count");
      csv("at", of.reference().along.empty() ? std::nullopt : std::optional(reading.reading().along));
      csv.record("", reading, "reference", "computed");
      for (const auto m : indices(c.models))
        csv(name_of_model(c.models[m].model), of.found().models[m].computed[reading.index]);
      csv.end_row();
    }
  return csv.take();
}

}  // namespace prs
