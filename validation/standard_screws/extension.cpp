#include "validation/extensions.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "prs/model/units.h"
#include "prs/sector/bodies.h"
#include "validation/standard_screws/comparison.h"

namespace prs::standard_screws {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<Ratios>;

constexpr double kDensity = 7800.0;    // kg/m^3
constexpr int kLargestDiameter = 120;  // mm

/// Cylinders of steel, one of each whole diameter in mm, per metre.
Json cylinders() {
  Json json = Json::object();
  for (int d = 1; d <= kLargestDiameter; ++d) {
    const RoundBody body = tube(d * 1e-3, 0.0, 1.0);
    json["cylinder"][fmt::format("d{}", d)] = {
        {"kg_per_m", kDensity * body.volume},
        {"kg_mm2_per_m", kDensity * body.polar_moment * per_si::square_millimetre}};
  }
  return json;
}

double printed_dynamic(const Ratios& r) { return r.printed.dynamic_capacity; }
double printed_static(const Ratios& r) { return r.printed.static_capacity; }
double computed_dynamic(const Ratios& r) { return *r.measures.dynamic_capacity; }
double computed_static(const Ratios& r) { return *r.measures.static_capacity; }

/// Printed to a tenth of a kilogram.
bool weight_is_known(const Ratios& r) { return r.printed.weight_digit <= 0.1 * r.printed.weight; }

std::string text(const Interval& i) { return fmt::format("{:.2f} to {:.2f}", i.least, i.greatest); }

bool within(const Interval& i, double least, double greatest) {
  return i.least >= least && i.greatest <= greatest;
}

Finding exponent(const Rows& rows, double (*printed)(const Ratios&),
                 double (*computed)(const Ratios&), double margin) {
  const double of_maker = lead_exponent(rows, printed), ours = lead_exponent(rows, computed);
  return {std::abs(ours - of_maker) <= margin,
          fmt::format("exponent {:.2f} printed, {:.2f} computed", of_maker, ours)};
}

/// What the columns say, the digits of a row being those of its class.
std::vector<Statement<Rows>> statements() {
  return {
      {"dynamic capacity", "C_a grows as lead^0.23 where nothing else differs",
       [](const Rows& rows) { return exponent(rows, printed_dynamic, computed_dynamic, 0.05); },
       "the rule puts in more rollers at fine pitch, whose crests are lower; the maker does not "
       "seem to"},
      {"dynamic capacity", "Lemor's C_a is 0.6 to 1.6 times the maker's",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::dynamic_capacity);
         return {within(i, 0.6, 1.6), "computed over printed " + text(i)};
       },
       "the smallest screw, 4 x 1, is out: its 82 contacts of 0.33 mm pitch count as fully as "
       "large ones in Lemor's formula; from 8 mm on 0.7 to 1.3"},
      {"static capacity", "C_0 hardly depends on the lead",
       [](const Rows& rows) { return exponent(rows, printed_static, computed_static, 0.05); },
       "the rule puts in more rollers at fine pitch; with arcs about the rollers' axes, of one "
       "radius for all leads, C_0 falls with the pitch"},
      {"static capacity", "the load of 4.0 GPa is 0.5 to 1.8 times the maker's C_0",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::static_capacity);
         return {within(i, 0.5, 1.8), "computed over printed " + text(i)};
       },
       "the profile radius, which is not printed, decides"},
      {"static capacity", "at the maker's C_0 the ellipse stays on the flank",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::flank_edge);
         return {i.least >= 1.0, "load at the edge of a flank over C_0 " + text(i)};
       },
       "crests end 0.15 p beyond the nominal diameter, as outer diameters are printed, and "
       "ellipses of unbounded flanks are wider: the maker counts on what bears beyond, or on "
       "another profile; neither is printed"},
      {"weight", "nut and rollers weigh what plain cylinders do, within 18 %",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::weight, weight_is_known);
         return {within(i, 0.82, 1.18),
                 "where 0.1 kg is less than a fifth: computed over printed " + text(i)};
       }},
      {"inertia", "the nut has the inertia of a plain tube, within 18 %",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::nut_inertia);
         return {within(i, 0.82, 1.18), "computed over printed " + text(i)};
       }},
      {"inertia",
       "the rollers' inertia seen by the screw is that of their spin and orbit, within 18 %",
       [](const Rows& rows) -> Finding {
         const Interval i = range(rows, &Ratios::roller_inertia);
         return {within(i, 0.82, 1.18), "computed over printed " + text(i)};
       }},
  };
}

ValidationTable table(const Rows& rows, std::string of) {
  ValidationTable table{"Computed over printed, " + std::move(of),
                        {"screw", "rollers", "contacts", "C_a", "C_0 (4 GPa)", "flank edge",
                         "weight", "nut inertia", "roller inertia"},
                        {},
                        2};
  for (const Ratios& r : rows)
    table.rows.push_back(
        {r.printed.name,
         {static_cast<double>(r.rollers), static_cast<double>(r.contacts_per_roller),
          r.dynamic_capacity, r.static_capacity, r.flank_edge, r.weight, r.nut_inertia,
          r.roller_inertia}});
  return table;
}

Supplement supplement(const Case&, const std::filesystem::path& folder) {
  const std::vector<CatalogueScrew> catalogue = read_catalogue(folder / "screws.csv");
  const std::vector<Variant<Rows>> variants{
      {"profile radii of 5 pitches", compare(catalogue, Flanks::by_rule)},
      {"the same and as many rollers at every lead",
       compare(catalogue, Flanks::by_rule, Rollers::as_at_coarsest_lead)},
      {"arcs about the rollers' axes", compare(catalogue, Flanks::centred)}};
  Supplement s;
  s.statements = compare(statements(), variants);
  for (const Variant<Rows>& v : variants) s.tables.push_back(table(v.results, v.name));
  return s;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "standard_screws", .formulas = cylinders, .supplement = supplement};
}

}  // namespace prs::standard_screws
