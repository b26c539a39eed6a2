#include "prs/compare/compare_analysis.h"

#include "prs/compare/compare_references.h"
#include "prs/compare/reference_figures.h"
#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"
#include "prs/model/check_case.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/reference/reference_reader.h"
#include "prs/text.h"

namespace prs {
namespace {

struct ComparedLoad {
  const ModelComparison* comparison = nullptr;
  std::size_t load_case = 0;

  const LoadCaseResult& best() const { return comparison->best().load_cases[load_case]; }
  const LoadCase& load() const { return best().load_case; }
};

/// Threads of one interface.
struct MostLoaded {
  const InterfaceLoads* loads = nullptr;
  int threads_per_roller = 0;

  const std::vector<double>& shares() const { return loads->load_rate; }
};

std::optional<double> largest_of(const std::vector<double>& values) {
  return entry_if_any(values, index_of_largest(values));
}

std::optional<double> over(std::optional<double> value, std::optional<double> best) {
  if (!value || !best || *best == 0.0) return std::nullopt;
  return *value / *best;
}

std::optional<MostLoaded> most_loaded(const ComparedModel& m, Interface i) {
  if (!m.result().threads) return std::nullopt;
  const InterfaceLoads& loads = (*m.result().threads)[i];
  return MostLoaded{&loads, loads.threads_per_roller};
}

std::vector<std::string> model_names(const ModelComparison& c) {
  return each(c.models, [](const Result& r) { return std::string(name_of_model(r.model)); });
}

}  // namespace

Record<MostLoaded> record_of(Type<MostLoaded>);
Record<ComparedLoad> record_of(Type<ComparedLoad>);

namespace {

constexpr Quantity<MostLoaded> kMostLoaded[] = {
    {"most_loaded_thread", of<[](auto& m) { return most_loaded_thread(*m.loads).value_or(1); }>,
     "1 is next to the loaded end of the screw"},
    {"most_loaded_roller",
     of<[](auto& m) { return m.loads->rollers ? std::optional(m.loads->rollers->largest_roller) : std::nullopt; }>,
     "from 1; of a full mechanism"},
    {"largest_load_rate_percent", of<[](auto& m) { return largest_of(m.shares()); }>,
     "its share: axial load over force per roller"},
    {"largest_peak_pressure_MPa", of<[](auto& m) { return largest_of(m.loads->peak_pressure); }>,
     "largest of a thread"},
    {"load_rate_percent", of<&MostLoaded::shares>, "share of each thread; of a full mechanism [roller][thread]"},
};

/// Largest pressure of a thread at either interface [Pa].
std::optional<double> largest_pressure(const LoadCaseResult& result) {
  if (!result.threads) return std::nullopt;
  const std::optional<double> screw = largest_of(result.threads->screw.peak_pressure);
  const std::optional<double> nut = largest_of(result.threads->nut.peak_pressure);
  return screw && nut ? std::max(*screw, *nut) : screw ? screw : nut;
}

/// Stiffness over the best model's; absent if either is.
std::optional<double> stiffness_over_best(const ComparedModel& m) {
  return over(m.result().axial_stiffness, m.best().axial_stiffness);
}

std::optional<double> pressure_over_best(const ComparedModel& m) {
  return over(largest_pressure(m.result()), largest_pressure(m.best()));
}

constexpr Quantity<ComparedModel> kModel[] = {
    {"bodies", of<&ComparedModel::model_name>, "bars | refined | influence of one sector, or full: all rollers"},
    {"converged", of<[](auto& m) { return m.result().converged(); }>, "whether there is an equilibrium"},
    {"axial_stiffness_N_per_um", of<[](auto& m) { return m.result().axial_stiffness; }>,
     "secant: force over displacement"},
    {"stiffness_over_best", of<stiffness_over_best>, "over that of the best model"},
    {"axial_displacement_um", of<[](auto& m) { return m.result().axial_displacement; }>,
     "of the loaded section; > 0 along the load"},
    {"largest_peak_pressure_MPa", of<[](auto& m) { return largest_pressure(m.result()); }>,
     "largest of a thread at either interface"},
    {"pressure_over_best", of<pressure_over_best>, "largest over that of the best model"},
    {"screw", of<[](auto& m) { return most_loaded(m, Interface::screw); }>, "threads of one roller at the screw"},
    {"nut", of<[](auto& m) { return most_loaded(m, Interface::nut); }>, "threads of one roller at the nut"},
};

constexpr Quantity<ComparedLoad> kLoad[] = {
    {"name", of<[](const ComparedLoad& l) -> const std::string& { return l.load().name; }>, "as the file has it"},
    {"axial_force_N", of<[](auto& l) { return l.load().axial_force; }>, "on the whole screw"},
    {"direction", of<[](auto& l) { return l.load().direction; }>, "tension | compression"},
    {"position_mm", of<[](auto& l) { return l.load().position; }>, "of the first roller contact on the nut"},
    {"models", of<[](auto& l) {
       std::vector<ComparedModel> models;
       for (const auto m : indices(l.comparison->models)) models.push_back({l.comparison, l.load_case, m});
       return models;
     }>,
     "the best last"},
    {"warnings", of<[](auto& l) { return sentences(l.best().warnings); }>,
     "what is unusual about this load, by the best model"},
};

constexpr Quantity<ModelComparison> kComparison[] = {
    {"models", of<model_names>, "that were compared: bars | refined | influence, or one of them | full; the best last"},
    {"load_cases", of<[](auto& c) {
       std::vector<ComparedLoad> loads;
       for (const auto k : up_to(c.load_cases())) loads.push_back({&c, k});
       return loads;
     }>,
     "those that are solved, not of equal thread loads"},
};

}  // namespace

std::optional<std::size_t> most_loaded_thread(const InterfaceLoads& loads) {
  if (loads.rollers) return static_cast<std::size_t>(loads.rollers->largest_thread);
  const auto thread = index_of_largest(loads.load_rate);
  return thread ? std::optional(*thread + 1) : std::nullopt;
}

PRS_RECORD(MostLoaded, "MostLoadedThread", "What an interface's threads carry, by one model.", kMostLoaded);
PRS_RECORD(ComparedModel, "ComparedModel", "The answer of one model of the bodies to a load case.", kModel);
PRS_RECORD(ComparedLoad, "ComparedLoadCase", "A load case by each model of the bodies.", kLoad);
PRS_RECORD(ModelComparison, "Comparison", "The models of the bodies side by side.", kComparison);

namespace {

constexpr std::size_t kLongestName = 19;

std::string comparison_row(std::initializer_list<std::string> cells) {
  constexpr std::size_t kWidths[] = {0, 10, 10, 6, 8, 12, 12, 13, 6};  // Widths of the columns after the name.
  std::string line = "  ";
  std::size_t column = 0;
  for (const std::string& cell : cells) {
    line += padded(cell, kWidths[column], column <= 1);
    ++column;
  }
  return ended(line);
}

std::string model_row(const std::string& load_case, const ComparedModel& m) {
  const LoadCaseResult& r = m.result();
  const std::string bodies(m.model_name());
  if (!r.converged()) return comparison_row({load_case, bodies, not_converged(r)});
  return comparison_row({load_case, bodies, stiffness_cell(r), fixed(stiffness_over_best(m), 1.0, 3),
                         displacement_cell(r), most_loaded_cell(r, Interface::screw),
                         most_loaded_cell(r, Interface::nut), pressure_cell(r), fixed(pressure_over_best(m), 1.0, 3)});
}

}  // namespace

std::string comparison_table(const ModelComparison& c) {
  const std::size_t shown = std::min(c.load_cases(), kMaxUnfoldedCases);
  std::size_t name_width = std::string_view("load case").size();
  for (const auto k : up_to(shown)) name_width = std::max(name_width, width(case_name_cell(c.best().load_cases[k])));
  name_width = std::min(name_width, kLongestName);
  const auto cell = [&](const std::string& text) { return fitted(text, name_width, true) + "  "; };
  std::string text =
      comparison_row({cell(""), "", "stiffness", "over", "displ.", "screw max.", "nut max.", "pressure", "over"}) +
      comparison_row({cell("load case"), "model", with_table_unit("N/µm"), "best", with_table_unit("µm"), "thread: %",
                      "thread: %", with_table_unit("max. GPa"), "best"});
  for (const auto k : up_to(shown))
    for (const auto m : indices(c.models))
      text += model_row(cell(m == 0 ? case_name_cell(c.best().load_cases[k]) : ""), {&c, k, m});
  if (shown < c.load_cases())
    text += fmt::format("  … {} of {} load cases; {}\n", shown, c.load_cases(), all_in("comparison.csv"));
  return text + reference_table(c) + warning_section(all_warnings(c.warnings, c.best().load_cases));
}

std::string comparison_csv(const ModelComparison& c, const CsvStyle& style) {
  CsvRows csv(style);
  for (const auto k : up_to(c.load_cases()))
    for (const auto model : indices(c.models)) {
      const ComparedModel m{&c, k, model};
      csv.load_case(m.result().load_case);
      csv.record("", m, "", "largest_peak_pressure_MPa");
      for (const Interface i : kInterfaces) {
        const std::optional<MostLoaded> most = most_loaded(m, i);
        const std::string prefix = fmt::format("{}_", name(i));
        csv.record(prefix, most, "", "most_loaded_roller");
        csv.record(prefix, most, "largest_load_rate_percent", "largest_peak_pressure_MPa");
      }
      csv.record("", m, "largest_peak_pressure_MPa");
      csv.end_row();
    }
  return csv.take();
}

namespace {

/// Shares of the roller with the largest load; of a sector those of its roller.
std::vector<double> of_most_loaded_roller(const InterfaceLoads& loads) {
  if (!loads.rollers) return loads.load_rate;
  const auto from = loads.load_rate.begin() + (loads.rollers->largest_roller - 1) * loads.threads_per_roller;
  return {from, from + loads.threads_per_roller};
}

/// One line per model, that of the most loaded roller of a full mechanism, and one panel per interface; for the load
/// case that the options choose, else the first with a result from every model.
Figures loads_by_model(const ModelComparison& c, const FigureOptions& options) {
  const auto answered = [&](std::size_t k) {
    return std::ranges::all_of(c.models, [&](const Result& model) { return model.load_cases[k].threads.has_value(); });
  };
  std::size_t k = options.load_case.value_or(0);
  while (!options.load_case && k < c.load_cases() && !answered(k)) ++k;
  if (k >= c.load_cases() || !answered(k)) return {};
  const LoadCase& load = c.best().load_cases[k].load_case;
  Figure figure{"loads_by_model", fmt::format("Load distribution by model, {}, {}, at rest", shown_name(load.name),
                                              in_table_unit(fmt::format("{:.4g} kN", load.axial_force * "kN"_per_si)))};
  figure.y = {"Share of the load", "%"};
  figure.columns = std::size(kInterfaces);
  for (const auto m : indices(c.models)) figure.add(std::string(name_of_model(c.models[m].model)), case_line(m));
  const auto threads = static_cast<std::size_t>(c.best().contacts.mechanism.contacts_per_roller);
  for (const Interface i : kInterfaces) {
    Panel& panel = figure.panels.emplace_back(Panel{interface_title(i)});
    for (const auto m : indices(c.models)) {
      const InterfaceLoads& loads = (*c.models[m].load_cases[k].threads)[i];
      panel.series.push_back({m, {over_threads(of_most_loaded_roller(loads), "%"_per_si)}});
    }
  }
  figure.x = thread_axis(threads);
  add_mean(figure, "%"_per_si / static_cast<double>(threads));
  fit_y_range(figure, true);
  return {std::move(figure)};
}

ModelComparison compared(const input::Source& source, const input::CaseInput& in) {
  std::vector<ReferenceCurve> references = read_references(source, in.values);
  ModelComparison result = compare_models(in.values);
  compare_references(source, in.values, std::move(references), result);
  add_preload_note(in.values, result.warnings);
  return result;
}

std::vector<Warning> warnings_of(const ModelComparison& r) { return all_warnings(r.warnings, r.best().load_cases); }

/// The curve that leaves its tolerance most.
std::vector<FoundCriterion> reference_criterion(const ModelComparison& c, const JudgedCase&) {
  const ReferenceComparison* worst = nullptr;
  const auto use = [](const ReferenceComparison& r) { return r.models[r.stated].tolerance_use.value_or(0.0); };
  for (const ReferenceComparison& r : c.references)
    if (r.reference.tolerance && (!worst || use(r) > use(*worst))) worst = &r;
  if (!worst) return {};
  FoundCriterion found("references");
  if (std::isfinite(use(*worst))) found.value = use(*worst);
  found.limit = 1.0;
  found.standing = worst->met() ? Standing::green : Standing::red;
  found.where = worst->reference.load_case;
  found.note = fmt::format("{} against {}, tolerance {}", worst->reference.response, worst->reference.name,
                           worst->reference.tolerance->text);
  return {found};
}

std::vector<std::string> notes(const ModelComparison& r) {
  std::string text = warning_summary(warnings_of(r));
  return text.empty() ? std::vector<std::string>{} : std::vector{std::move(text)};
}

}  // namespace

const Analysis<ModelComparison>& compare_analysis() {
  static const std::vector<Place> places =
      with_contacts({{"comparison", describe<ModelComparison>},
                     {"references[]", describe<ComparedReference>, false, "with `references` or `--reference`"}});
  static const Analysis<ModelComparison> analysis{
      .command = Command::compare,
      .help = "The models of the bodies side by side, or two cases",
      .file = "comparison.json",
      .run = compared,
      .places = places,
      .put =
          [](nlohmann::ordered_json& document, const ModelComparison& r) {
            put_contacts(document, r.best().contacts);
            document["comparison"] = object_of(r);
            put_references(document, r);
          },
      .table = comparison_table,
      .notes = notes,
      .files =
          [](const ModelComparison& r, const CsvStyle& style) {
            std::vector<OutputFile> files{{"comparison.csv", comparison_csv(r, style)}};
            if (!r.references.empty()) files.push_back({"references.csv", references_csv(r, style)});
            return files;
          },
      .pictures = [](const ModelComparison& r, const Case& c) -> Pictures {
        return {{"loads_by_model", "a load case that converged with every model", of_result(r, loads_by_model)},
                {"references", "references, and answers to their load cases", of_result(r, reference_figures)},
                {"reference_butterfly", "references over the threads in tension and compression",
                 [&r, left = has_butterflies_of_load(c)](const FigureOptions&) {
                   return in_shown_units(reference_butterfly(r, left));
                 }}};
      },
      .converged = [](const ModelComparison& r) { return std::ranges::all_of(r.models, all_converged); },
      .within_tolerance =
          [](const ModelComparison& r) { return std::ranges::all_of(r.references, &ReferenceComparison::met); },
      .criteria = reference_criterion,
      .all_warnings = warnings_of,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
