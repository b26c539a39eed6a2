#include "validation/standard_screws/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "prs/threads/contacts.h"
#include "prs/validation/csv_table.h"

namespace prs::standard_screws {
namespace {

constexpr double kMillimetre = 1e-3, kKilonewton = 1e3, kKilogramSquareMillimetre = 1e-6;

/// What is equal where only the lead differs.
using Envelope = std::tuple<double, int, double, double>;

Envelope envelope(const ScrewData& s) {
  return {s.screw_diameter, *s.starts, *s.nut_diameter, *s.nut_length};
}

/// Radius of an arc about the roller's axis [m].
double centred_radius(const ScrewData& s) {
  return 0.5 * s.screw_diameter / (*s.starts - 2) / std::sin(s.flank_angle);
}

Ratios ratios(const CatalogueScrew& printed, Flanks flanks, int most_rollers) {
  ScrewData screw = printed.screw;
  if (flanks == Flanks::centred) screw.roller_profile_radius = centred_radius(screw);
  Case c = complete_screw(screw).c;
  c.mechanism.rollers = std::min(c.mechanism.rollers, most_rollers);
  const Measures m = measures_of(c, find_contacts(c.mechanism, c.materials, Detail::numbers));
  Ratios r;
  r.printed = printed;
  r.rollers = c.mechanism.rollers;
  r.contacts_per_roller = c.mechanism.contacts_per_roller;
  r.measures = m;
  r.dynamic_capacity = m.dynamic_capacity.value() / printed.dynamic_capacity;
  r.static_capacity = m.static_capacity.value() / printed.static_capacity;
  r.flank_edge = m.flank_edge_load.value() / printed.static_capacity;
  r.weight = m.weight.value() / printed.weight;
  r.nut_inertia = m.nut_inertia.value() / printed.nut_inertia;
  r.roller_inertia = m.roller_inertia.value() / printed.roller_inertia;
  return r;
}

}  // namespace

std::vector<CatalogueScrew> read_catalogue(const std::filesystem::path& file) {
  const CsvTable table(file);
  std::vector<CatalogueScrew> screws;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto number = [&](const char* key, double unit) {
      return table.number(row, table.column(key)) * unit;
    };
    CatalogueScrew s;
    s.name = table.text(row, table.column("screw"));
    s.screw.screw_diameter = number("screw_diameter_mm", kMillimetre);
    s.screw.lead = number("lead_mm", kMillimetre);
    s.screw.starts = static_cast<int>(number("starts", 1.0));
    s.screw.nut_diameter = number("nut_diameter_mm", kMillimetre);
    s.screw.nut_length = number("nut_length_mm", kMillimetre);
    s.dynamic_capacity = number("dynamic_capacity_kN", kKilonewton);
    s.static_capacity = number("static_capacity_kN", kKilonewton);
    s.efficiency = number("efficiency", 1.0);
    s.weight = number("nut_and_rollers_kg", 1.0);
    s.weight_digit = table.half_unit(row, table.column("nut_and_rollers_kg"));
    s.nut_inertia = number("nut_inertia_kg_mm2", kKilogramSquareMillimetre);
    s.roller_inertia = number("roller_inertia_seen_by_screw_kg_mm2", kKilogramSquareMillimetre);
    screws.push_back(std::move(s));
  }
  return screws;
}

std::vector<Ratios> compare(const std::vector<CatalogueScrew>& catalogue, Flanks flanks,
                            Rollers rollers) {
  std::map<Envelope, int> fewest;
  for (const CatalogueScrew& s : catalogue) {
    const int fit = complete_screw(s.screw).c.mechanism.rollers;
    const auto [known, is_new] = fewest.try_emplace(envelope(s.screw), fit);
    if (!is_new) known->second = std::min(known->second, fit);
  }
  std::vector<Ratios> rows;
  for (const CatalogueScrew& s : catalogue)
    rows.push_back(ratios(s, flanks,
                          rollers == Rollers::as_fit ? std::numeric_limits<int>::max()
                                                     : fewest.at(envelope(s.screw))));
  return rows;
}

Interval range(const std::vector<Ratios>& rows, double Ratios::*ratio,
               bool (*counts)(const Ratios&)) {
  Interval range{std::numeric_limits<double>::infinity(), 0.0};
  for (const Ratios& r : rows)
    if (counts(r)) range = {std::min(range.least, r.*ratio), std::max(range.greatest, r.*ratio)};
  return range;
}

double lead_exponent(const std::vector<Ratios>& rows, double (*capacity)(const Ratios&)) {
  std::map<Envelope, std::vector<const Ratios*>> alike;
  for (const Ratios& r : rows) alike[envelope(r.printed.screw)].push_back(&r);
  double covariance = 0.0, variance = 0.0;
  for (const auto& [key, group] : alike) {
    double lead = 0.0, size = 0.0;
    for (const Ratios* r : group) {
      lead += std::log(r->printed.screw.lead) / static_cast<double>(group.size());
      size += std::log(capacity(*r)) / static_cast<double>(group.size());
    }
    for (const Ratios* r : group) {
      const double off = std::log(r->printed.screw.lead) - lead;
      covariance += off * (std::log(capacity(*r)) - size);
      variance += off * off;
    }
  }
  return covariance / variance;
}

}  // namespace prs::standard_screws
