#include "prs/life/static_limits.h"

#include "prs/life/rating_life.h"
#include "prs/loads/analyze.h"

namespace prs {
namespace {

/// 1.3e-7 mm^4/N^2 in m^4/N^2.
constexpr double kPalmgren = 1.3e-19;

}  // namespace

double load_at_permanent_deformation(double diameter, double kappa_1, double kappa_2, double share) {
  return diameter * std::sqrt(share / (kPalmgren * kappa_1 * kappa_2));
}

std::optional<double> flank_element_diameter(const contact::Thread& roller) {
  if (!(roller.profile_curvature > 0.0)) return std::nullopt;
  return 2.0 / roller.profile_curvature;
}

const char* name(StaticLimit limit) {
  constexpr const char* kNames[] = {"pressure", "given"};
  return kNames[static_cast<std::size_t>(limit)];
}

contact::FlankEdge nearest_flank_edge(const Contacts& contacts, Interface i) {
  const InterfaceContact& c = contacts.interfaces[i];
  return contact::nearest_flank_edge(pair_of(contacts.threads, i), c.geometry, c.hertz.semi_major_per_cbrt_load,
                                     c.hertz.semi_minor_per_cbrt_load);
}

StaticLimits static_limits(const std::optional<Materials>& materials, const Contacts& contacts, Interface i) {
  StaticLimits limits;
  const InterfaceContact& c = contacts.interfaces[i];
  if (!c.has_hertz()) return limits;
  const std::optional<double> pressure = materials ? static_pressure_limit((*materials)[body_of(i)], materials->roller)
                                                   : std::optional(kStaticPressureLimit);
  if (pressure) limits.pressure = load_at_pressure(c.hertz, *pressure);
  limits.flank_edge = std::pow(nearest_flank_edge(contacts, i).scale, 3.0);
  const bool deforms_as_steel = !materials || is_steel(*materials);
  if (const auto diameter = flank_element_diameter(contacts.threads.roller); diameter && deforms_as_steel)
    limits.deformation =
        load_at_permanent_deformation(*diameter, c.geometry.relative.first, c.geometry.relative.second);
  return limits;
}

std::optional<StaticRating> static_rating(std::optional<double> pressure, std::optional<double> given) {
  if (given) return StaticRating{*given, StaticLimit::given};
  if (pressure) return StaticRating{*pressure, StaticLimit::pressure};
  return std::nullopt;
}

std::optional<StaticRating> smaller(const std::optional<StaticRating>& a, const std::optional<StaticRating>& b) {
  if (!a || !b) return a ? a : b;
  return b->force < a->force ? b : a;
}

std::optional<Warning> flank_edge_near(std::string_view ellipse, double edge_load, double static_capacity,
                                       double load) {
  if (!(edge_load < static_capacity && edge_load < kUsualStaticSafety * load)) return std::nullopt;
  return Warning{"", "flank_edge_near",
                 fmt::format("the load is {:.1f} % of the {{limit}} at which {} reaches the edge of a "
                             "flank, which is below the static capacity of {{{:.4g} kN}}; expected at most "
                             "{:.0f} %",
                             load / edge_load * "%"_per_si, ellipse, static_capacity * "kN"_per_si,
                             "%"_per_si / kUsualStaticSafety),
                 "lower the load or the profile radius, or take a coarser pitch"}
      .with(load, edge_load, "kN"_unit);
}

std::optional<Warning> dynamic_above_static(double dynamic_capacity, double static_capacity, bool is_stated) {
  if (!(dynamic_capacity > static_capacity)) return std::nullopt;
  return Warning{"", "dynamic_above_static",
                 fmt::format("the dynamic capacity of {{value}} is above the static one of {{limit}}{}; makers' static "
                             "capacities are 1.4 to 4 times the dynamic",
                             is_stated ? "" : " with equal thread loads"),
                 "check stated capacities, which must be one maker's, or the profile radius"}
      .with(dynamic_capacity, static_capacity, "kN"_unit);
}

std::optional<Warning> beyond_static_rating(double load, const StaticRating& rating, std::string_view shares) {
  if (!(load > rating.force)) return std::nullopt;
  if (rating.force == 0.0)
    return Warning{
        "", "beyond_static_rating",
        fmt::format("{}the static limit ({}) is exceeded without any axial load", shares, describe(rating.limit)),
        "lower the preload, or what acts across the axis"};
  return Warning{"", "beyond_static_rating",
                 fmt::format("{}the load is {:.3f} times the static limit ({}): {{value}} "
                             "above {{limit}}",
                             shares, load / rating.force, describe(rating.limit)),
                 "reduce it"}
      .with(load, rating.force, "kN"_unit);
}

std::string describe(StaticLimit limit) {
  switch (limit) {
    case StaticLimit::pressure:
      return "contact pressure at its limit";
    case StaticLimit::given:
      return "stated static capacity";
  }
  return "";
}

}  // namespace prs
