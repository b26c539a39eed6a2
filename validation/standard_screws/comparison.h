#pragma once

#include <filesystem>

#include "prs/configurations/configurations.h"
#include "prs/life/rating_life.h"
#include "prs/measures/measures.h"

namespace prs::standard_screws {

/// A row of the catalogue. SI units.
struct CatalogueScrew {
  std::string name;  ///< Diameter x lead, mm.
  ScrewData screw;
  double dynamic_capacity = 0.0;  ///< C_a [N]
  double static_capacity = 0.0;   ///< C_0 [N]
  double efficiency = 0.0;        ///< Efficiency of converting rotation to travel.
  double weight = 0.0;            ///< Weight of nut and rollers [kg].
  double weight_digit = 0.0;      ///< Half a unit of its last digit [kg].
  double nut_inertia = 0.0;       ///< [kg m^2]
  double roller_inertia = 0.0;    ///< Inertia at the screw [kg m^2].
};

std::vector<CatalogueScrew> read_catalogue(const std::filesystem::path& file);

/// Ratios of computed to printed values.
struct Ratios {
  CatalogueScrew printed;
  int rollers = 0, contacts_per_roller = 0;
  Measures measures;
  double dynamic_capacity = 0.0;
  double static_capacity = 0.0;  ///< Static capacity by 4.0 GPa.
  double flank_edge = 0.0;       ///< Load at a flank's edge over the static capacity.
  double weight = 0.0;
  double nut_inertia = 0.0;
  double roller_inertia = 0.0;
};

/// Number of rollers of the screws: as many as fit, or for all leads of otherwise equal screws as many as fit at the
/// coarsest.
enum class Rollers { as_fit, as_at_coarsest_lead };

/// Arcs of the rollers' flanks: of `kProfileRadius` pitches, or about the roller's axis.
enum class Flanks { by_rule, centred };

/// Ratios of all screws.
std::vector<Ratios> compare(const std::vector<CatalogueScrew>& catalogue, Flanks flanks,
                            Rollers rollers = Rollers::as_fit);

/// Smallest and largest of a ratio over the screws for which `counts` is true.
Interval range(
    const std::vector<Ratios>& rows, double Ratios::*ratio,
    bool (*counts)(const Ratios&) = [](const Ratios&) { return true; });

}  // namespace prs::standard_screws
