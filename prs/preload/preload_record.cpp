#include "prs/preload/preload_record.h"

#include "prs/loads/load_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

using SideOf = Within<PreloadResult, SideLoads>;
using CurveOf = Within<PreloadResult, PreloadCurve>;

/// A fit at the temperatures of the parts.
struct WarmOf {
  const PreloadResult* result = nullptr;
};

}  // namespace

Record<SideOf> record_of(Type<SideOf>);
Record<PerDirection<SideOf>> record_of(Type<PerDirection<SideOf>>);
Record<CurveOf> record_of(Type<CurveOf>);
Record<WarmOf> record_of(Type<WarmOf>);

namespace {

bool is_at_rest(const PreloadResult& r) { return r.at_rest.solve.converged(); }
bool has_heat(const WarmOf& w) { return w.result->load_case.has_value(); }
bool is_known(const WarmOf& w) { return w.result->heat_status == HeatStatus::converged && is_at_rest(*w.result); }

constexpr Quantity<SideOf> kSide[] = {
    {"axial_load_N", of<[](auto& s) { return s.item->axial_load.screw; }>, "of all threads of this side"},
    {"max_normal_load_N",
     of<[](auto& s) { return std::max(s.item->max_normal_load.screw, s.item->max_normal_load.nut); }>,
     "of a thread of one roller"},
    {"peak_pressure_MPa", of<[](auto& s) { return s.whole->peak_pressure(*s.item); }>, "largest of a thread",
     source::kHertz},
};

constexpr Quantity<PerDirection<SideOf>> kSides[] = {
    {"tension", of<&PerDirection<SideOf>::tension>, "contacts that carry tension"},
    {"compression", of<&PerDirection<SideOf>::compression>, "contacts that carry compression"},
};

bool is_solved(const PreloadPointOf& p) { return p.point->solve.converged(); }

template <auto get>
constexpr auto of_point_solve = of<[](auto& p) { return std::invoke(get, p.point->solve); }>;

constexpr Quantity<PreloadPointOf> kPoint[] = {
    {"axial_force_N", of<[](auto& p) { return p.point->axial_force; }>, "external load, > 0 in tension"},
    {"converged", of<is_solved>, "whether there is an equilibrium"},
    {"status", of_point_solve<&fe::NewtonSummary::status>, "how the solve ended"},
    {"iterations", of_point_solve<&fe::NewtonSummary::iterations>, "linear solves"},
    {"relative_residual", of_point_solve<&fe::NewtonSummary::relative_residual>,
     "largest force out of balance over the load"},
    {"axial_displacement_um", of<[](auto& p) { return p.point->axial_displacement; }, is_solved>,
     "of the loaded section, 0 without external load, > 0 in tension"},
    {"tangent_stiffness_N_per_um", of<[](auto& p) { return p.point->tangent_stiffness; }, is_solved>,
     "derivative of the force by the displacement; absent where the screw is loose"},
    {"sides",
     of<[](auto& p) {
       return PerDirection<SideOf>{{p.result, &p.point->sides.tension}, {p.result, &p.point->sides.compression}};
     },
        is_solved>,
     "contacts by the sense of the load that they carry"},
};

constexpr Quantity<CurveOf> kCurve[] = {
    {"stiffness_at_zero_N_per_um", of<its<&PreloadCurve::stiffness_at_zero>>,
     "tangent without external load, reached from either sense"},
    {"lost_motion_um", of<its<&PreloadCurve::lost_motion>>,
     "displacement between the lost-motion load in tension and in compression"},
    {"loads", of<[](auto& c) {
       return each(c.item->points, [&](const PreloadPoint& point) { return PreloadPointOf{c.whole, &point}; });
     }>,
     "one equilibrium per external load"},
};

constexpr Quantity<WarmOf> kWarm[] = {
    {"load_case", of<[](auto& w) { return w.result->load_case; }>, "whose steady temperatures these are, by `heat`"},
    {"temperature_status", of<[](auto& w) { return w.result->heat_status; }, has_heat>,
     "how the search for them ended"},
    {"temperature_degC", of<[](auto& w) { return celsius_of(*w.result->temperature); }, is_known>, "of the parts"},
    {"preload_force_N", of<[](auto& w) { return w.result->force(); }, is_known>,
     "axial load of each side without external load"},
    {"stiffness_at_zero_N_per_um", of<[](auto& w) { return w.result->curve.stiffness_at_zero; }, is_known>,
     "tangent without external load, reached from either sense"},
    {"opening_force_N", of<[](auto& w) { return w.result->opening_force; }, is_known>,
     "external load at which the side that opposes it opens"},
    {"lost_motion_um", of<[](auto& w) { return w.result->curve.lost_motion; }, is_known>,
     "displacement between the lost-motion load in tension and in compression"},
};

constexpr Quantity<PreloadResult> kPreload[] = {
    {"thread_loads", of<[](const PreloadResult&) { return "static"; }>, "static: of a screw at rest, without friction"},
    {"arrangement", of<[](auto& r) {
       return r.preload.arrangement == Preload::Arrangement::single_nut ? "single_nut" : "double_nut";
     }>,
     "single_nut | double_nut"},
    {"position_mm", of<[](auto& r) { return r.preload.position; }>, "of the first roller contact on the nut"},
    {"held_at_mm", of<&PreloadResult::section>, "section at which the first nut is held, by the sense of the load"},
    {"reference_temperature_degC", of<[](auto& r) { return r.reference_temperature - kZeroCelsius; }>,
     "of all parts where the fit is made"},
    {"preload_force_N", of<&PreloadResult::reference_force, is_at_rest>,
     "axial load of each side without external load, of the fit at the reference temperature"},
    {"interference_um", of<&PreloadResult::interference>,
     "oversize of the rollers' pitch diameter, or of the spacer, at the reference temperature; "
     "absent with play"},
    {"backlash_um", of<[](auto& r) { return r.preload.backlash; }>, "axial play"},
    {"opening_force_N", of<&PreloadResult::opening_force>, "external load at which the side that opposes it opens"},
    {"lost_motion_load_N", of<&PreloadResult::lost_motion_load>, "to both senses"},
    {"", of<[](auto& r) {
       return CurveOf{&r, &r.curve};
     }>},
    {"at_temperature", of<[](auto& r) { return r.temperature ? std::optional(WarmOf{&r}) : std::nullopt; }>,
     "the same fit at the temperatures of the parts, of `deviations` or of `heat`"},
    {"without_preload", of<[](auto& r) {
       return r.without_preload ? std::optional(CurveOf{&r, &*r.without_preload}) : std::nullopt;
     }>,
     "neither preload nor play"},
};

}  // namespace

PRS_RECORD(SideOf, "PreloadSide", "Contacts that carry one sense of the load.", kSide);
PRS_RECORD(PerDirection<SideOf>, "PreloadSides", "Contacts by the sense of the load that they carry.", kSides);
PRS_RECORD(PreloadPointOf, "PreloadPoint", "Equilibrium under one external load.", kPoint);
PRS_RECORD(CurveOf, "WithoutPreload", "The same nut without preload.", kCurve);
PRS_RECORD(WarmOf, "WarmPreload", "A fit at the temperatures of the parts.", kWarm);
PRS_RECORD(PreloadResult, "Preload", "The preloaded nut: forces and displacements are > 0 in tension.", kPreload);

}  // namespace prs
