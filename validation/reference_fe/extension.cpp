#include "validation/reference_fe/extension.h"

#include "modules/module.h"
#include "prs/bodies/body_models.h"
#include "prs/indices.h"
#include "prs/record/csv_rows.h"
#include "validation/extensions.h"

namespace prs::reference_fe {
namespace {

/// Range of a discrepancy of the bar model. The bands are the range over all cases, widened by the reference's error
/// bar: they describe the gap and are not a tolerance.
struct Band {
  double from = 0.0;
  double to = 0.0;

  bool holds(double least, double greatest) const { return least >= from && greatest <= to; }
};

constexpr Band kBarsInTension{0.25, 0.33};
constexpr Band kBarsInCompression{0.16, 0.20};
constexpr Band kBarsLoadRate{0.005, 0.016};

ErrorBar sum(const ErrorBar& a, const ErrorBar& b) { return {a.stiffness + b.stiffness, a.load_rate + b.load_rate}; }

/// `-1.20 % (3 tension both_end_nodes opposite, 45 kN)`, the value times a factor.
std::string shown(const Extreme& e, const char* format, int factor = 1) {
  return fmt::format(fmt::runtime(format), percent(e.value * factor)) +
         fmt::format(" ({}, {:g} kN)", name(e.setup), e.load * "kN"_per_si);
}

int threads(const Fidelities& f) { return static_cast<int>(f.reference.front().points.back().load_rate.screw.size()); }

/// Load rate in % of the mean thread load, comparable for any number of threads.
double of_mean_load(double load_rate, int threads) { return percent(load_rate * threads); }

double full_load(const Fidelities& f) { return f.reference.front().points.back().load; }

Summary bars_at_full_load(const Fidelities& f, Direction direction) {
  return summary(f.bars, f.reference,
                 [&](const Setup& setup, double load) { return setup.direction == direction && load == full_load(f); });
}

Finding bars_are_too_stiff(const Fidelities& f) {
  const Summary tension = bars_at_full_load(f, Direction::tension);
  const Summary compression = bars_at_full_load(f, Direction::compression);
  const auto in = [](const Band& band, const Summary& s) {
    return s.unsolved == 0 && band.holds(s.least_stiff.value, s.stiffest.value);
  };
  return {in(kBarsInTension, tension) && in(kBarsInCompression, compression),
          fmt::format("tension {:.1f} to {:.1f} %, compression {:.1f} to {:.1f} %", percent(tension.least_stiff.value),
                      percent(tension.stiffest.value), percent(compression.least_stiff.value),
                      percent(compression.stiffest.value))};
}

Finding bars_shift_the_loads(const Fidelities& f) {
  const Summary s = summary(f.bars, f.reference, [&](const Setup&, double load) { return load == full_load(f); });
  return {s.unsolved == 0 && kBarsLoadRate.holds(s.best_loads.value, s.worst_loads.value),
          fmt::format("{} to {}", shown(s.best_loads, "{:.1f} %", threads(f)),
                      shown(s.worst_loads, "{:.1f} %", threads(f)))};
}

/// Whether curves stay within limits of others, at all setups and loads.
Finding stays_within(const ErrorBar& limits, const Curves& curves, const Curves& reference, int threads) {
  const Summary s = summary(curves, reference, [](const Setup&, double) { return true; });
  const bool holds = s.unsolved == 0 && std::abs(s.farthest_stiffness().value) <= limits.stiffness &&
                     s.worst_loads.value <= limits.load_rate;
  std::string evidence =
      fmt::format("stiffness {} to {}; a thread's load up to {}, mean {:.1f} %", shown(s.least_stiff, "{:+.2f} %"),
                  shown(s.stiffest, "{:+.2f} %"), shown(s.worst_loads, "{:.1f} %", threads),
                  of_mean_load(0.5 * (s.mean_load.screw + s.mean_load.nut), threads));
  if (s.unsolved > 0) evidence += fmt::format("; {} of {} points without an answer", s.unsolved, s.points);
  return {holds, std::move(evidence)};
}

}  // namespace

std::vector<ComparedStatement> compare_statements(const Fidelities& f) {
  const int count = threads(f);
  std::vector<ComparedStatement> all;
  const auto add = [&](const char* section, std::string text, Finding found) {
    const std::vector<Variant<Finding>> only{{"all cases", std::move(found)}};
    all.push_back({section, std::move(text), compare<Finding>(std::identity(), "", only)});
  };
  const auto limits_text = [&](const ErrorBar& limits) {
    return fmt::format("{:g} % of the stiffness and, at every thread, {:g} % of the mean thread load ({} threads)",
                       percent(limits.stiffness), of_mean_load(limits.load_rate, count), count);
  };
  const ErrorBar joint = sum(kReferenceError, kInfluenceError);
  add("bars",
      fmt::format("at full load the paper's bars are {:g} to {:g} % too stiff in tension and {:g} "
                  "to {:g} % in compression",
                  percent(kBarsInTension.from), percent(kBarsInTension.to), percent(kBarsInCompression.from),
                  percent(kBarsInCompression.to)),
      bars_are_too_stiff(f));
  add("bars",
      fmt::format("at full load the worst thread of a case is {:g} to {:g} % of the mean thread "
                  "load off ({} threads)",
                  of_mean_load(kBarsLoadRate.from, count), of_mean_load(kBarsLoadRate.to, count), count),
      bars_shift_the_loads(f));
  add("refined", "within " + limits_text(kRefinedError) + " of the reference, at all loads",
      stays_within(kRefinedError, f.refined, f.reference, count));
  if (f.influence.empty()) return all;
  add("refined", "within " + limits_text(kRefinedError) + " of the influence model, at all loads",
      stays_within(kRefinedError, f.refined, f.influence, count));
  add("influence", "within both error bars of the reference at all loads: " + limits_text(joint),
      stays_within(joint, f.influence, f.reference, count));
  return all;
}

namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

bool all_loads(const Setup&, double) { return true; }

std::string at_full_load(const Curves& reference) {
  return fmt::format("{:g} kN", reference.front().points.back().load * "kN"_per_si);
}

/// The unit of load rates and how to read it.
std::string of_sector_load(const Curves& reference) {
  const std::size_t threads = reference.front().points.back().load_rate.screw.size();
  return fmt::format("in % of the sector load, of which the mean thread of {} carries {:g} %", threads,
                     percent(1.0 / static_cast<double>(threads)));
}

ValidationTable stiffness_table(const Models& models, const Curves& reference) {
  ValidationTable table{fmt::format("Axial stiffness at {} in N/um; the models less the reference, "
                                    "in %, there and as the mean over all {} loads",
                                    at_full_load(reference), reference.front().points.size()),
                        {"CONFIG, direction, guidance, contacts", "reference"},
                        {},
                        2};
  for (const char* what : {"", ", mean"})
    for (const Model& model : models) table.columns.push_back(model.name + what);
  for (const auto k : indices(reference)) {
    const CurvePoint& full = reference[k].points.back();
    ValidationTable::Row row{name(reference[k].setup), {full.stiffness() * "N/µm"_per_si}};
    for (const Model& model : models) {
      const auto d = discrepancy(model.curves[k].points.back(), full);
      row.values.push_back(d ? percent(d->stiffness) : kAbsent);
    }
    for (const Model& model : models)
      row.values.push_back(percent(summary({model.curves[k]}, {reference[k]}, all_loads).mean_stiffness));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ValidationTable load_table(const Models& models, const Curves& reference, Interface i) {
  ValidationTable table{fmt::format("Load rates at the {} at {}: mean and largest discrepancy over the threads, {}",
                                    prs::name(i), at_full_load(reference), of_sector_load(reference)),
                        {"CONFIG, direction, guidance, contacts"},
                        {},
                        3};
  for (const Model& model : models) {
    table.columns.push_back(model.name);
    table.columns.push_back("largest");
  }
  for (const auto k : indices(reference)) {
    ValidationTable::Row row{name(reference[k].setup), {}};
    for (const Model& model : models) {
      const auto d = discrepancy(model.curves[k].points.back(), reference[k].points.back());
      row.values.push_back(d ? percent(d->loads[i].mean) : kAbsent);
      row.values.push_back(d ? percent(d->loads[i].largest) : kAbsent);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ValidationTable::Row summary_row(std::string label, const Summary& s) {
  return {
      std::move(label),
      {percent(s.least_stiff.value), percent(s.mean_stiffness), percent(s.stiffest.value), percent(s.mean_load.screw),
       percent(s.largest_load.screw), percent(s.mean_load.nut), percent(s.largest_load.nut)}};
}

ValidationTable summary_table(const Models& models, const Curves& reference) {
  ValidationTable table{fmt::format("All {} cases at all {} loads: stiffness less that of the reference, in %; load "
                                    "rates, mean and largest discrepancy, {}",
                                    reference.size(), reference.front().points.size(), of_sector_load(reference)),
                        {"", "softest", "mean", "stiffest", "screw", "largest", "nut", "largest"},
                        {},
                        3};
  for (const Model& model : models)
    table.rows.push_back(summary_row(model.name, summary(model.curves, reference, all_loads)));
  return table;
}

void setup_fields(CsvRows& csv, const Setup& setup, double load) {
  constexpr std::string_view kNames[] = {"config", "direction", "guidance", "contacts"};
  const auto all = words(setup);
  for (const auto k : indices(all)) csv(kNames[k], all[k]);
  csv("load_kN", load);
}

std::string comparison_csv(const Models& models, const Curves& reference) {
  constexpr std::pair<std::string_view, double LoadDiscrepancy::*> kDiscrepancies[] = {
      {"mean", &LoadDiscrepancy::mean},
      {"largest", &LoadDiscrepancy::largest},
      {"relative_mean", &LoadDiscrepancy::relative_mean},
      {"relative_highest", &LoadDiscrepancy::relative_highest},
      {"relative_lowest", &LoadDiscrepancy::relative_lowest}};
  CsvRows csv(CsvStyle{});
  for (const Model& model : models)
    for (const auto k : indices(reference))
      for (const auto n : indices(reference[k].points)) {
        const CurvePoint &point = model.curves[k].points[n], &target = reference[k].points[n];
        const std::optional<Discrepancy> d = discrepancy(point, target);
        const auto known = [&](double value) { return d ? std::optional(value) : std::nullopt; };
        setup_fields(csv, reference[k].setup, target.load);
        csv("model", model.name);
        csv("displacement_um", known(point.displacement));
        csv("reference_displacement_um", target.displacement);
        csv("stiffness_N_per_um", known(point.stiffness()));
        csv("stiffness_discrepancy_percent", d ? std::optional(d->stiffness) : std::nullopt);
        for (const Interface i : kInterfaces)
          for (const auto& [key, value] : kDiscrepancies)
            csv(fmt::format("{}_{}_discrepancy_percent", prs::name(i), key),
                d ? std::optional(d->loads[i].*value) : std::nullopt);
        csv.end_row();
      }
  return csv.take();
}

std::optional<double> rate_of(const CurvePoint& point, Interface i, std::size_t thread) {
  return point.is_solved() ? std::optional(point.load_rate[i][thread]) : std::nullopt;
}

std::string load_rates_csv(const Models& models, const Curves& reference) {
  CsvRows csv(CsvStyle{});
  for (const auto k : indices(reference))
    for (const auto n : indices(reference[k].points)) {
      const CurvePoint& target = reference[k].points[n];
      for (const Interface i : kInterfaces)
        for (const auto thread : indices(target.load_rate[i])) {
          setup_fields(csv, reference[k].setup, target.load);
          csv("interface", prs::name(i));
          csv("thread", thread + 1);
          csv("reference_percent", target.load_rate[i][thread]);
          for (const Model& model : models) csv(model.name + "_percent", rate_of(model.curves[k].points[n], i, thread));
          csv.end_row();
        }
    }
  return csv.take();
}

/// Table of the rates of one case at its largest load.
std::string markdown_table(const Models& models, const Curve& reference, std::size_t curve) {
  const CurvePoint& target = reference.points.back();
  std::string text = fmt::format("\n## {}, {:g} kN\n\n| thread |", name(reference.setup), target.load * "kN"_per_si);
  std::string rule = "\n| ---: |";
  for (const Interface i : kInterfaces) {
    text += fmt::format(" {}: reference |", prs::name(i));
    rule += " ---: |";
    for (const Model& model : models) {
      text += fmt::format(" {} |", model.name);
      rule += " ---: |";
    }
  }
  text += rule + '\n';
  for (const auto thread : indices(target.load_rate.screw)) {
    text += fmt::format("| {} |", thread + 1);
    for (const Interface i : kInterfaces) {
      text += fmt::format(" {:.3f} |", percent(target.load_rate[i][thread]));
      for (const Model& model : models) {
        const auto rate = rate_of(model.curves[curve].points.back(), i, thread);
        text += rate ? fmt::format(" {:.3f} |", percent(*rate)) : " |";
      }
    }
    text += '\n';
  }
  return text;
}

std::string load_rates_markdown(const Models& models, const Curves& reference) {
  std::string text = "# Load rates of all threads, in % of the sector load\n";
  for (const auto k : indices(reference)) text += markdown_table(models, reference[k], k);
  return text;
}

/// Dashes distinguish the models in grey print; thinner lines lie on top.
constexpr Style kModelStyles[] = {line_of(Colour::orange, Dash::dash_dotted, Weight::strong),
                                  line_of(Colour::vermillion, Dash::dashed, Weight::strong), line_of(Colour::blue)};
constexpr Style kPointStyle = points_of(Colour::ink, Mark::circle, Weight::thin);
constexpr Style kBarStyle = line_of(Colour::ink, Dash::solid, Weight::thin);

bool is_drawn(const Setup& setup) { return setup.contacts == ModelOptions::RollerContacts::opposite; }

/// `both end nodes`
std::string guidance_title(const Setup& setup) {
  std::string title = words(setup)[2];
  std::ranges::replace(title, '_', ' ');
  return title;
}

std::string case_title(const Setup& setup) {
  return fmt::format("CONFIG {}, {}", setup.config, prs::name(setup.direction));
}

/// Styles in the order of the legend: the models by their indices, then points and bars of the reference.
struct StyleIndices {
  std::size_t points = 0;
  std::size_t bars = 0;
};

StyleIndices add_styles(Figure& figure, const Models& models) {
  for (const auto m : indices(models)) figure.add(models[m].name, kModelStyles[m % std::size(kModelStyles)]);
  StyleIndices styles;
  styles.points = figure.add("reference with its error bar", kPointStyle);
  styles.bars = figure.add(kBarStyle);
  return styles;
}

/// A vertical stroke at each point, of twice its half width.
Series error_bars(std::size_t style, const Polyline& points, const std::vector<double>& half_widths) {
  Series line{style};
  for (const auto k : indices(points)) {
    const auto [x, y] = points[k];
    line.parts.push_back({{x, y - half_widths[k]}, {x, y + half_widths[k]}});
  }
  return line;
}

/// Load rates minus those of `base`, in %.
Polyline differences(const std::vector<double>& rates, const std::vector<double>& base) {
  Polyline points;
  for (const auto k : indices(rates)) points.push_back({static_cast<double>(k + 1), (rates[k] - base[k]) * "%"_per_si});
  return points;
}

/// Rates of all models and the reference, minus those of `base`.
Panel rate_panel(const Models& models, std::size_t curve, const CurvePoint& reference, Interface i,
                 const std::vector<double>& base, const StyleIndices& styles, const ErrorBar& error) {
  Panel panel;
  for (const auto m : indices(models)) {
    const CurvePoint& point = models[m].curves[curve].points.back();
    if (point.is_solved()) panel.series.push_back({m, {differences(point.load_rate[i], base)}});
  }
  const Polyline points = differences(reference.load_rate[i], base);
  panel.series.push_back(
      error_bars(styles.bars, points, std::vector<double>(points.size(), error.load_rate * "%"_per_si)));
  panel.series.push_back({styles.points, {points}});
  return panel;
}

/// Axis as wide as its lines on both sides of zero.
Axis difference_axis(const std::vector<const Panel*>& panels) {
  Range range;
  for (const Panel* panel : panels) range.include(range_of_y(panel->series));
  const double widest = std::max(std::abs(range.from), std::abs(range.to));
  return {"Less the reference", "%", -1.08 * widest, 1.08 * widest};
}

Figure load_rate_figure(const Models& models, std::size_t curve, const Curve& reference, const ErrorBar& error) {
  const CurvePoint& point = reference.points.back();
  const std::size_t threads = point.load_rate.screw.size();
  Figure figure;
  const auto w = words(reference.setup);
  figure.name = fmt::format("load_rate_config{}_{}_{}", w[0], w[1], w[2]);
  figure.title = fmt::format("{}, {:.4g} kN, guidance: {}", case_title(reference.setup), point.load * "kN"_per_si,
                             guidance_title(reference.setup));
  figure.x = thread_axis(threads);
  figure.y = {"Share of the load", "%"};
  figure.columns = std::size(kInterfaces);
  const StyleIndices styles = add_styles(figure, models);
  for (const Interface i : kInterfaces) {
    figure.panels.push_back(rate_panel(models, curve, point, i, std::vector<double>(threads, 0.0), styles, error));
    figure.panels.back().title = interface_title(i);
  }
  fit_y_range(figure);
  for (const Interface i : kInterfaces)
    figure.panels.push_back(rate_panel(models, curve, point, i, point.load_rate[i], styles, error));
  const Axis difference = difference_axis({&figure.panels[2], &figure.panels[3]});
  for (std::size_t k : {2u, 3u}) figure.panels[k].y = difference;
  return figure;
}

Polyline over_load(const Curve& curve) {
  Polyline points{{0.0, 0.0}};
  for (const CurvePoint& point : curve.points)
    if (point.is_solved()) points.push_back({point.load * "kN"_per_si, point.displacement * "µm"_per_si});
  return points;
}

Panel displacement_panel(const Models& models, std::size_t curve, const Curve& reference, const StyleIndices& styles,
                         const ErrorBar& error) {
  Panel panel;
  panel.title = case_title(reference.setup);
  for (const auto m : indices(models)) panel.series.push_back({m, {over_load(models[m].curves[curve])}});
  Polyline points = over_load(reference);
  points.erase(points.begin());
  std::vector<double> half_widths;
  for (const auto& [load, displacement] : points) half_widths.push_back(error.stiffness * displacement);
  panel.series.push_back(error_bars(styles.bars, points, half_widths));
  panel.series.push_back({styles.points, {std::move(points)}});
  return panel;
}

}  // namespace

std::vector<ValidationTable> tables(const Models& models, const Curves& reference) {
  return {stiffness_table(models, reference), load_table(models, reference, Interface::screw),
          load_table(models, reference, Interface::nut), summary_table(models, reference)};
}

std::vector<OutputFile> files(const Models& models, const Curves& reference) {
  return {{"comparison.csv", comparison_csv(models, reference)},
          {"load_rates.csv", load_rates_csv(models, reference)},
          {"load_rates.md", load_rates_markdown(models, reference)}};
}

std::vector<Figure> load_rate_figures(const Models& models, const Curves& reference, const ErrorBar& error) {
  std::vector<Figure> figures;
  for (const auto k : indices(reference))
    if (is_drawn(reference[k].setup)) figures.push_back(load_rate_figure(models, k, reference[k], error));
  return figures;
}

std::vector<Figure> displacement_figures(const Models& models, const Curves& reference, const ErrorBar& error) {
  std::vector<Figure> figures;
  for (const Guidance::Kind guidance : {Guidance::Kind::both_end_nodes, Guidance::Kind::outer_node}) {
    Figure figure;
    const Setup shown{1, Direction::tension, guidance, {}};
    figure.name = "displacement_" + words(shown)[2];
    figure.title = "Axial displacement, guidance: " + guidance_title(shown);
    figure.x = {"Axial load", "kN", 0.0};
    figure.y = {"Axial displacement", "µm"};
    figure.columns = 2;
    const StyleIndices styles = add_styles(figure, models);
    for (const auto k : indices(reference)) {
      const Setup& setup = reference[k].setup;
      if (!is_drawn(setup) || setup.guidance != guidance) continue;
      figure.x.to = reference[k].points.back().load * "kN"_per_si;
      figure.panels.push_back(displacement_panel(models, k, reference[k], styles, error));
    }
    fit_y_range(figure);
    figures.push_back(std::move(figure));
  }
  return figures;
}

namespace {

Supplement compared(const Case& screw, const Reference& of) {
  const Curves reference = read_curves(of.folder / "data" / "curves.csv");
  const auto curves = [&](ModelOptions::Bodies bodies) { return computed_curves(screw, bodies, reference); };
  Fidelities f{reference, curves(&kBars), curves(&kRefined), {}};
  Models models{{"bars", f.bars}, {"refined", f.refined}};
  std::vector<std::string> not_built;
  try {
    f.influence = curves(&kInfluence);
    models.push_back({"influence", f.influence});
  } catch (const modules::NotBuilt&) {
    not_built = {"bodies: influence"};
  }
  Supplement supplement{compare_statements(f), tables(models, reference),
                        load_rate_figures(models, reference, kReferenceError), files(models, reference)};
  for (Figure& figure : displacement_figures(models, reference, kReferenceError))
    supplement.figures.push_back(std::move(figure));
  supplement.not_built = std::move(not_built);
  return supplement;
}

}  // namespace

SourceExtension extension() { return {.folder = "reference_fe", .supplement = compared}; }

}  // namespace prs::reference_fe
