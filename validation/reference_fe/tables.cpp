#include "validation/reference_fe/tables.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "prs/model/units.h"
#include "prs/record/csv_writer.h"

namespace prs::reference_fe {
namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

bool all_loads(const Setup&, double) { return true; }

std::string at_full_load(const std::vector<Curve>& reference) {
  return fmt::format("{:g} kN", reference.front().points.back().load * per_si::kilonewton);
}

/// The unit of load rates and how to read it.
std::string of_sector_load(const std::vector<Curve>& reference) {
  const std::size_t threads = reference.front().points.back().load_rate.screw.size();
  return fmt::format("in % of the sector load, of which the mean thread of {} carries {:g} %",
                     threads, percent(1.0 / static_cast<double>(threads)));
}

ValidationTable stiffness_table(const std::vector<Model>& models,
                                const std::vector<Curve>& reference) {
  ValidationTable table{fmt::format("Axial stiffness at {} in N/um; the models less the reference, "
                                    "in %, there and as the mean over all {} loads",
                                    at_full_load(reference), reference.front().points.size()),
                        {"CONFIG, direction, guidance, contacts", "reference"},
                        {},
                        2};
  for (const char* what : {"", ", mean"})
    for (const Model& model : models) table.columns.push_back(model.name + what);
  for (std::size_t k = 0; k < reference.size(); ++k) {
    const CurvePoint& full = reference[k].points.back();
    ValidationTable::Row row{name(reference[k].setup),
                             {full.stiffness() * per_si::newton_per_micrometre}};
    for (const Model& model : models) {
      const auto d = discrepancy(model.curves[k].points.back(), full);
      row.values.push_back(d ? percent(d->stiffness) : kAbsent);
    }
    for (const Model& model : models)
      row.values.push_back(
          percent(summary({model.curves[k]}, {reference[k]}, all_loads).mean_stiffness));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ValidationTable load_table(const std::vector<Model>& models, const std::vector<Curve>& reference,
                           Interface i) {
  ValidationTable table{
      fmt::format("Load rates at the {} at {}: mean and largest discrepancy over the threads, {}",
                  prs::name(i), at_full_load(reference), of_sector_load(reference)),
      {"CONFIG, direction, guidance, contacts"},
      {},
      3};
  for (const Model& model : models) {
    table.columns.push_back(model.name);
    table.columns.push_back("largest");
  }
  for (std::size_t k = 0; k < reference.size(); ++k) {
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
  return {std::move(label),
          {percent(s.least_stiff.value), percent(s.mean_stiffness), percent(s.stiffest.value),
           percent(s.mean_load.screw), percent(s.largest_load.screw), percent(s.mean_load.nut),
           percent(s.largest_load.nut)}};
}

ValidationTable summary_table(const std::vector<Model>& models,
                              const std::vector<Curve>& reference) {
  ValidationTable table{
      fmt::format("All {} cases at all {} loads: stiffness less that of the reference, in %; load "
                  "rates, mean and largest discrepancy, {}",
                  reference.size(), reference.front().points.size(), of_sector_load(reference)),
      {"", "softest", "mean", "stiffest", "screw", "largest", "nut", "largest"},
      {},
      3};
  for (const Model& model : models)
    table.rows.push_back(summary_row(model.name, summary(model.curves, reference, all_loads)));
  return table;
}

void setup_header(CsvWriter& csv) {
  for (const char* key : {"config", "direction", "guidance", "contacts", "load_kN"}) csv.text(key);
}

void setup_fields(CsvWriter& csv, const Setup& setup, double load) {
  for (const std::string& word : words(setup)) csv.text(word);
  csv.number(load, per_si::kilonewton);
}

void load_discrepancy_fields(CsvWriter& csv, const std::optional<Discrepancy>& d, Interface i) {
  for (const auto value :
       {&LoadDiscrepancy::mean, &LoadDiscrepancy::largest, &LoadDiscrepancy::relative_mean,
        &LoadDiscrepancy::relative_highest, &LoadDiscrepancy::relative_lowest})
    csv.number(d ? std::optional(d->loads[i].*value) : std::nullopt, per_si::percent);
}

std::string comparison_csv(const std::vector<Model>& models, const std::vector<Curve>& reference) {
  CsvWriter csv(CsvStyle{});
  setup_header(csv);
  for (const char* key : {"model", "displacement_um", "reference_displacement_um",
                          "stiffness_N_per_um", "stiffness_discrepancy_percent"})
    csv.text(key);
  for (const Interface i : kInterfaces)
    for (const char* key :
         {"mean", "largest", "relative_mean", "relative_highest", "relative_lowest"})
      csv.text(fmt::format("{}_{}_discrepancy_percent", prs::name(i), key));
  csv.end_row();
  for (const Model& model : models)
    for (std::size_t k = 0; k < reference.size(); ++k)
      for (std::size_t n = 0; n < reference[k].points.size(); ++n) {
        const CurvePoint &point = model.curves[k].points[n], &target = reference[k].points[n];
        const std::optional<Discrepancy> d = discrepancy(point, target);
        setup_fields(csv, reference[k].setup, target.load);
        csv.text(model.name);
        csv.number(d ? std::optional(point.displacement) : std::nullopt, per_si::micrometre);
        csv.number(target.displacement, per_si::micrometre);
        csv.number(d ? std::optional(point.stiffness()) : std::nullopt,
                   per_si::newton_per_micrometre);
        csv.number(d ? std::optional(d->stiffness) : std::nullopt, per_si::percent);
        for (const Interface i : kInterfaces) load_discrepancy_fields(csv, d, i);
        csv.end_row();
      }
  return csv.take();
}

std::optional<double> rate_of(const CurvePoint& point, Interface i, std::size_t thread) {
  return point.is_solved() ? std::optional(point.load_rate[i][thread]) : std::nullopt;
}

std::string load_rates_csv(const std::vector<Model>& models, const std::vector<Curve>& reference) {
  CsvWriter csv(CsvStyle{});
  setup_header(csv);
  for (const char* key : {"interface", "thread", "reference_percent"}) csv.text(key);
  for (const Model& model : models) csv.text(model.name + "_percent");
  csv.end_row();
  for (std::size_t k = 0; k < reference.size(); ++k)
    for (std::size_t n = 0; n < reference[k].points.size(); ++n) {
      const CurvePoint& target = reference[k].points[n];
      for (const Interface i : kInterfaces)
        for (std::size_t thread = 0; thread < target.load_rate[i].size(); ++thread) {
          setup_fields(csv, reference[k].setup, target.load);
          csv.text(prs::name(i));
          csv.integer(thread + 1);
          csv.number(target.load_rate[i][thread], per_si::percent);
          for (const Model& model : models)
            csv.number(rate_of(model.curves[k].points[n], i, thread), per_si::percent);
          csv.end_row();
        }
    }
  return csv.take();
}

/// Rates of one case at its largest load.
std::string markdown_table(const std::vector<Model>& models, const Curve& reference,
                           std::size_t curve) {
  const CurvePoint& target = reference.points.back();
  std::string text = fmt::format("\n## {}, {:g} kN\n\n| thread |", name(reference.setup),
                                 target.load * per_si::kilonewton);
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
  for (std::size_t thread = 0; thread < target.load_rate.screw.size(); ++thread) {
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

std::string load_rates_markdown(const std::vector<Model>& models,
                                const std::vector<Curve>& reference) {
  std::string text = "# Load rates of all threads, in % of the sector load\n";
  for (std::size_t k = 0; k < reference.size(); ++k)
    text += markdown_table(models, reference[k], k);
  return text;
}

}  // namespace

std::vector<ValidationTable> tables(const std::vector<Model>& models,
                                    const std::vector<Curve>& reference) {
  return {stiffness_table(models, reference), load_table(models, reference, Interface::screw),
          load_table(models, reference, Interface::nut), summary_table(models, reference)};
}

std::vector<OutputFile> files(const std::vector<Model>& models,
                              const std::vector<Curve>& reference) {
  return {{"comparison.csv", comparison_csv(models, reference)},
          {"load_rates.csv", load_rates_csv(models, reference)},
          {"load_rates.md", load_rates_markdown(models, reference)}};
}

}  // namespace prs::reference_fe
