#include "validation/standard_screws/comparison.h"

#include <tuple>

#include "prs/indices.h"
#include "validation/extensions.h"

namespace prs::standard_screws {
namespace {

constexpr double kMillimetre = 1e-3, kKilonewton = 1e3, kKilogramSquareMillimetre = 1e-6;

/// Dimensions that are equal for screws that differ in the lead only.
using Envelope = std::tuple<double, int, double, double>;

Envelope envelope(const ScrewData& s) { return {s.screw_diameter, *s.starts, *s.nut_diameter, *s.nut_length}; }

/// Radius of an arc about the roller's axis [m].
double centred_radius(const ScrewData& s) { return 0.5 * s.screw_diameter / (*s.starts - 2) / std::sin(s.flank_angle); }

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

/// Exponent x of a capacity proportional to lead^x: least squares of logarithms over groups of screws whose printed
/// data differ in the lead only, one constant for each group.
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

}  // namespace

std::vector<CatalogueScrew> read_catalogue(const std::filesystem::path& file) {
  const CsvTable table(file);
  std::vector<CatalogueScrew> screws;
  for (const auto row : up_to(table.rows())) {
    const auto number = [&](const char* key, double unit) { return table.number(row, table.column(key)) * unit; };
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

std::vector<Ratios> compare(const std::vector<CatalogueScrew>& catalogue, Flanks flanks, Rollers rollers) {
  std::map<Envelope, int> fewest;
  for (const CatalogueScrew& s : catalogue) {
    const int fit = complete_screw(s.screw).c.mechanism.rollers;
    const auto [known, is_new] = fewest.try_emplace(envelope(s.screw), fit);
    if (!is_new) known->second = std::min(known->second, fit);
  }
  std::vector<Ratios> rows;
  for (const CatalogueScrew& s : catalogue)
    rows.push_back(
        ratios(s, flanks, rollers == Rollers::as_fit ? std::numeric_limits<int>::max() : fewest.at(envelope(s.screw))));
  return rows;
}

Interval range(const std::vector<Ratios>& rows, double Ratios::*ratio, bool (*counts)(const Ratios&)) {
  Interval range{std::numeric_limits<double>::infinity(), 0.0};
  for (const Ratios& r : rows)
    if (counts(r)) range = {std::min(range.least, r.*ratio), std::max(range.greatest, r.*ratio)};
  return range;
}

namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<Ratios>;

constexpr double kDensity = 7800.0;    // kg/m^3
constexpr int kLargestDiameter = 120;  // mm

/// Cylinders of steel, one of each whole diameter in mm, per metre.
Json cylinders(const Reference&) {
  Json json = Json::object();
  for (int d = 1; d <= kLargestDiameter; ++d) {
    const RoundBody body = tube(d * 1e-3, 0.0, 1.0);
    json["cylinder"][fmt::format("d{}", d)] = {{"kg_per_m", kDensity * body.volume},
                                               {"kg_mm2_per_m", kDensity * body.polar_moment * 1e6}};
  }
  return json;
}

double printed_dynamic(const Ratios& r) { return r.printed.dynamic_capacity; }
double printed_static(const Ratios& r) { return r.printed.static_capacity; }
double computed_dynamic(const Ratios& r) { return *r.measures.dynamic_capacity; }
double computed_static(const Ratios& r) { return *r.measures.static_capacity; }

/// Whether the weight is printed to a tenth of a kilogram.
bool weight_is_known(const Ratios& r) { return r.printed.weight_digit <= 0.1 * r.printed.weight; }

std::string text(const Interval& i) { return fmt::format("{:.2f} to {:.2f}", i.least, i.greatest); }

bool within(const Interval& i, double least, double greatest) { return i.least >= least && i.greatest <= greatest; }

Finding exponent(const Rows& rows, double (*printed)(const Ratios&), double (*computed)(const Ratios&), double margin) {
  const double of_maker = lead_exponent(rows, printed), ours = lead_exponent(rows, computed);
  return {std::abs(ours - of_maker) <= margin, fmt::format("exponent {:.2f} printed, {:.2f} computed", of_maker, ours)};
}

Finding ratio(const Rows& rows, double Ratios::*of, double least, double greatest) {
  const Interval i = range(rows, of);
  return {within(i, least, greatest), "computed over printed " + text(i)};
}

/// Digits of a row are those of its class.
const Checks<Rows> kChecks{
    {"dynamic_capacity_and_lead",
     [](const Rows& rows) { return exponent(rows, printed_dynamic, computed_dynamic, 0.05); }},
    {"dynamic_capacity", [](const Rows& rows) { return ratio(rows, &Ratios::dynamic_capacity, 0.6, 1.6); }},
    {"static_capacity_and_lead",
     [](const Rows& rows) { return exponent(rows, printed_static, computed_static, 0.05); }},
    {"static_capacity", [](const Rows& rows) { return ratio(rows, &Ratios::static_capacity, 0.5, 1.8); }},
    {"flank_edge",
     [](const Rows& rows) -> Finding {
       const Interval i = range(rows, &Ratios::flank_edge);
       return {i.least >= 1.0, "load at the edge of a flank over C_0 " + text(i)};
     }},
    {"weight",
     [](const Rows& rows) -> Finding {
       const Interval i = range(rows, &Ratios::weight, weight_is_known);
       return {within(i, 0.82, 1.18), "where 0.1 kg is less than a fifth: computed over printed " + text(i)};
     }},
    {"nut_inertia", [](const Rows& rows) { return ratio(rows, &Ratios::nut_inertia, 0.82, 1.18); }},
    {"roller_inertia", [](const Rows& rows) { return ratio(rows, &Ratios::roller_inertia, 0.82, 1.18); }},
};

ValidationTable table(const Rows& rows, std::string of) {
  ValidationTable table{
      "Computed over printed, " + std::move(of),
      {"screw", "rollers", "contacts", "C_a", "C_0 (4 GPa)", "flank edge", "weight", "nut inertia", "roller inertia"},
      {},
      2};
  for (const Ratios& r : rows)
    table.rows.push_back(
        {r.printed.name,
         {static_cast<double>(r.rollers), static_cast<double>(r.contacts_per_roller), r.dynamic_capacity,
          r.static_capacity, r.flank_edge, r.weight, r.nut_inertia, r.roller_inertia}});
  return table;
}

Supplement supplement(const Case&, const Reference& maker) {
  const std::vector<CatalogueScrew> catalogue = read_catalogue(maker.folder / "screws.csv");
  const std::vector<Variant<Rows>> variants{
      {"profile radii of 5 pitches", compare(catalogue, Flanks::by_rule)},
      {"the same and as many rollers at every lead", compare(catalogue, Flanks::by_rule, Rollers::as_at_coarsest_lead)},
      {"arcs about the rollers' axes", compare(catalogue, Flanks::centred)}};
  Supplement s;
  s.statements = compare(maker.statements, kChecks, variants);
  for (const Variant<Rows>& v : variants) s.tables.push_back(table(v.results, v.name));
  return s;
}

}  // namespace

SourceExtension extension() { return {.folder = "standard_screws", .formulas = cylinders, .supplement = supplement}; }

}  // namespace prs::standard_screws
