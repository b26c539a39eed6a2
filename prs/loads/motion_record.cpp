#include "prs/indices.h"
#include "prs/loads/load_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

constexpr std::string_view kIso = "ISO 3408-3, names of its actual values";

/// Getter for travels that have an equilibrium at all positions.
template <auto get>
constexpr auto travelled = of<get, &TravelResult::converged>;

std::vector<std::vector<double>> rows_of_lateral(const std::vector<Lateral>& all) {
  return each(all, [](const Lateral& l) { return std::vector<double>{l.y, l.z}; });
}

struct TravelNut {
  std::vector<Eigen::Vector3d> force;
  std::vector<Lateral> moment;
};

constexpr Quantity<TravelNut> kTravelNut[] = {
    {"force_N", of<[](const TravelNut& s) {
       return each(s.force, [](const Eigen::Vector3d& f) { return std::vector<double>{f[0], f[1], f[2]}; });
     }>,
     "x, y, z, of the housing on the nut, at each position"},
    {"moment_Nm", of<[](const TravelNut& s) { return rows_of_lateral(s.moment); }>, "about y and z, at each position"},
};

constexpr Quantity<TravelSupport> kTravelBearing[] = {
    {"at_mm", of<&TravelSupport::position>, "x", "", "position"},
    {"force_N", of<[](const TravelSupport& s) {
       return each(s.force, [](const Eigen::Vector3d& f) { return std::vector<double>{f[1], f[2]}; });
     }>,
     "y, z, of the bearing on the screw, at each position"},
    {"moment_Nm", of<[](const TravelSupport& s) { return rows_of_lateral(s.moment); }>,
     "about y and z, at each position"},
};

struct TravelEnd {
  const TravelResult* travel;
};

constexpr Quantity<TravelEnd> kTravelEnd[] = {
    {"displacement_um", of<[](const TravelEnd& e) {
       const std::vector<double> x = e.travel->deviation();
       std::vector<std::vector<double>> rows;
       for (const auto k : indices(x))
         rows.push_back({x[k], e.travel->end_displacement[k].y, e.travel->end_displacement[k].z});
       return rows;
     }>,
     "x: the deviation; y, z as at rest, at each position"},
    {"rotation_mrad", of<[](const TravelEnd& e) { return rows_of_lateral(e.travel->end_rotation); }>,
     "about y and z, at each position"},
};

constexpr Quantity<TravelLoads> kTravelLoads[] = {
    {"largest_normal_load_N", of<&TravelLoads::largest>, "of all rollers, threads and positions"},
    {"at_angle_deg", of<&TravelLoads::angle>, "turn at which it acts"},
    {"largest_roller", of<&TravelLoads::roller>, "where it acts, from 1"},
    {"largest_thread", of<&TravelLoads::thread>, "where it acts, from 1"},
    {"least_normal_load_N", of<&TravelLoads::least>, "of all rollers, threads and positions"},
    {"mean_normal_load_N", of<&TravelLoads::mean>, "over the positions, by roller and thread"},
    {"ripple_normal_load_N", of<&TravelLoads::ripple>, "largest less least over the positions, by roller and thread"},
};

struct Spectrum {
  std::vector<double> order, amplitude;
};

constexpr Quantity<Spectrum> kSpectrum[] = {
    {"order", of<&Spectrum::order>, "periods in a turn"},
    {"amplitude_um", of<&Spectrum::amplitude>, "of the deviation, less its drift"},
};

constexpr Quantity<OrderAmplitude> kOrder[] = {
    {"name", of<&OrderAmplitude::name>,
     "turn | carrier | carrier_on_screw | roller_spin | rollers_past_nut | rollers_past_screw"},
    {"order", of<&OrderAmplitude::order>, "periods in a turn"},
    {"amplitude_um", of<&OrderAmplitude::amplitude>, "by one least-squares fit of all orders"},
};

std::optional<double> ripple_of(const std::vector<double>& k) {
  if (k.empty()) return std::nullopt;
  double mean = 0.0;
  for (const double value : k) mean += value / static_cast<double>(k.size());
  const auto [least, most] = std::ranges::minmax(k);
  return (most - least) / mean;
}

template <Interface i>
constexpr auto travel_loads = travelled<[](const TravelResult& r) -> const TravelLoads& { return r.loads[i]; }>;

constexpr Quantity<TravelResult> kTravel[] = {
    {"converged", of<&TravelResult::converged>, "whether every position has an equilibrium"},
    {"status", of<[](const TravelResult& r) { return r.failure ? r.failure->status : fe::NewtonStatus::converged; }>,
     "how the first position without equilibrium ended"},
    {"at_angle_deg",
     of<[](const TravelResult& r) { return r.failure ? std::optional(r.failure->angle) : std::nullopt; }>,
     "turn of the first position without equilibrium"},
    {"turns", travelled<[](const TravelResult& r) { return r.travel.turns; }>, "of the screw against the nut"},
    {"steps", travelled<[](const TravelResult& r) { return r.travel.steps; }>, "in a turn"},
    {"positions", travelled<&TravelResult::positions>, "both ends included"},
    {"slip_ratio", travelled<&TravelResult::slip_ratio>, "turn of the carrier against the nut over that of the screw"},
    {"angle_deg", travelled<&TravelResult::angle>, "turn of the screw against the nut"},
    {"deviation_um", travelled<&TravelResult::deviation>, "of the loaded section along x, less its mean"},
    {"peak_to_peak_um", travelled<[](const TravelResult& r) {
       const auto [least, most] = std::ranges::minmax(r.displacement);
       return most - least;
     }>,
     "of the deviation"},
    {"mean_travel_deviation_um", travelled<[](const TravelResult& r) { return r.bands.mean; }>,
     "e_0a: rise of the least-squares line over the travel; > 0 goes too far", kIso},
    {"variation_um", travelled<[](const TravelResult& r) { return r.bands.variation; }>,
     "v_ua: width of the band along that line", kIso},
    {"variation_300_mm_um", travelled<[](const TravelResult& r) { return r.bands.variation_300_mm; }>,
     "v_300a: largest over 300 mm; absent of a shorter travel", kIso},
    {"variation_one_turn_um", travelled<[](const TravelResult& r) { return r.bands.variation_one_turn; }>,
     "v_2pia: largest over a turn", kIso},
    {"spectrum", travelled<[](const TravelResult& r) {
       return Spectrum{each(r.spectrum, &OrderAmplitude::order), each(r.spectrum, &OrderAmplitude::amplitude)};
     }>,
     "of the deviation"},
    {"orders", travelled<&TravelResult::orders>, "amplitudes of the orders of the parts"},
    {"tangent_stiffness_N_per_um",
     travelled<[](const TravelResult& r) { return r.tangent_stiffness.empty() ? nullptr : &r.tangent_stiffness; }>,
     "derivative of the force by the displacement, at each position"},
    {"stiffness_ripple_percent", travelled<[](const TravelResult& r) { return ripple_of(r.tangent_stiffness); }>,
     "largest less least stiffness over the mean"},
    {"screw_end", travelled<[](const TravelResult& r) { return TravelEnd{&r}; }>, "the loaded section of the screw"},
    {"nut_reaction", travelled<[](const TravelResult& r) {
       return TravelNut{r.nut.force, r.nut.moment};
     }>,
     "of the nut's seat"},
    {"bearings", travelled<&TravelResult::bearings>, "as the file has them"},
    {"side_force_ripple_N", travelled<&TravelResult::side_force_ripple>,
     "largest distance of the nut's force across the axis from its mean"},
    {"tilt_ripple_mrad", travelled<&TravelResult::tilt_ripple>,
     "largest distance of the rotation of the screw's end from its mean"},
    {"screw", travel_loads<Interface::screw>, "contacts at the screw"},
    {"nut", travel_loads<Interface::nut>, "contacts at the nut"},
};

struct AlongAxes {
  double x = 0.0, y = 0.0, z = 0.0;
};
AlongAxes axes_of(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

constexpr Quantity<AlongAxes> kAlongAxes[] = {
    {"x", of<&AlongAxes::x>, "along the axis"},
    {"y", of<&AlongAxes::y>, "across it"},
    {"z", of<&AlongAxes::z>, "across it"},
};

/// A mode with the data common to all.
struct ModeOf {
  const ModesResult* all;
  const Mode* mode;
};

struct KineticOf : ModeOf {};
struct StrainOf : ModeOf {};
struct RollerShapeOf : ModeOf {};
struct ShapeOf : ModeOf {};

template <auto member>
constexpr auto of_mode = of<[](const ModeOf& m) { return (*m.mode).*member; }>;

template <class Part>
constexpr auto part_of_mode = of<[](const ModeOf& m) { return Part{m}; }>;

constexpr Quantity<KineticOf> kKinetic[] = {
    {"screw", of<[](const ModeOf& m) { return m.mode->kinetic.screw; }>, "of the screw"},
    {"nut", of<[](const ModeOf& m) { return m.mode->kinetic.nut; }>, "of the nut"},
    {"rollers", of<[](const ModeOf& m) { return m.mode->kinetic.roller; }>,
     "of the rollers, also as they orbit and spin"},
    {"masses", of_mode<&Mode::kinetic_of_masses>, "of masses and drive"},
};

constexpr Quantity<StrainOf> kStrain[] = {
    {"screw", of<[](const ModeOf& m) { return m.mode->strain.screw; }>, "of the screw"},
    {"nut", of<[](const ModeOf& m) { return m.mode->strain.nut; }>, "of the nut"},
    {"rollers", of<[](const ModeOf& m) { return m.mode->strain.roller; }>, "of the rollers"},
    {"screw_contacts", of<[](const ModeOf& m) { return m.mode->contact_strain.screw; }>,
     "of the contacts at the screw"},
    {"nut_contacts", of<[](const ModeOf& m) { return m.mode->contact_strain.nut; }>, "of the contacts at the nut"},
    {"supports", of_mode<&Mode::support_strain>, "of springs of supports, rings and drive"},
    {"prestress",
     of<[](const ModeOf& m) { return m.all->prestressed ? std::optional(m.mode->prestress) : std::nullopt; }>,
     "of axial forces in bending; < 0 in compression"},
};

struct BodyShape {
  const std::vector<double>* x;
  const std::vector<std::vector<double>>* displacement;
};

constexpr Quantity<BodyShape> kBodyShape[] = {
    {"x_mm", of<[](const BodyShape& b) { return *b.x; }>, "of the nodes"},
    {"displacement", of<[](const BodyShape& b) { return *b.displacement; }>, "x, y, z"},
};

constexpr Quantity<RollerShapeOf> kRollerShape[] = {
    {"axial", of_mode<&Mode::axial>, "of the middle of each roller"},
    {"radial", of_mode<&Mode::radial>, "of the middle of each roller"},
};

template <Interface i>
constexpr auto body_shape = of<[](const ModeOf& m) {
  return BodyShape{&m.all->x[i], &m.mode->shape[i]};
}>;

constexpr Quantity<ShapeOf> kShape[] = {
    {"screw", body_shape<Interface::screw>, "of the screw"},
    {"nut", body_shape<Interface::nut>, "of the nut"},
    {"rollers", part_of_mode<RollerShapeOf>, "of the rollers"},
};

constexpr Quantity<ModeOf> kMode[] = {
    {"frequency_Hz", of_mode<&Mode::frequency>, "natural frequency"},
    {"effective_mass_kg", of<[](const ModeOf& m) { return axes_of(m.mode->effective_mass); }>,
     "what takes part along each axis"},
    {"kinetic_energy_percent", part_of_mode<KineticOf>, "shares of the parts"},
    {"strain_energy_percent", part_of_mode<StrainOf>, "shares of parts, contacts and supports"},
    {"shape", part_of_mode<ShapeOf>, "scaled so that its largest number is 1"},
    {"critical_speed_rpm", of<[](const ModeOf& m) {
       return each(m.all->orders,
                   [&](const MotionOrder& o) { return 2.0 * std::numbers::pi * m.mode->frequency / o.order; });
     }>,
     "of screw against nut, at which each of `orders` meets the frequency"},
};

constexpr Quantity<MotionOrder> kMotionOrder[] = {
    {"name", of<&MotionOrder::name>, "as those of `travel`"},
    {"order", of<&MotionOrder::order>, "periods in a turn of screw against nut"},
};

using AlongTravel = ModesResult::AlongTravel;

constexpr Quantity<AlongTravel> kAlongTravel[] = {
    {"angle_deg", of<&AlongTravel::angle>, "turn of the screw against the nut"},
    {"frequency_Hz", of<&AlongTravel::frequency>, "natural frequencies at each, from the lowest"},
};

constexpr Quantity<ModesResult> kModes[] = {
    {"mass_kg", of<[](const ModesResult& m) { return axes_of(m.mass); }>, "that moves along each axis"},
    {"dofs", of<&ModesResult::freedoms>, "freedoms of the model", "", "degrees of freedom of the model"},
    {"idle_rollers", of<&ModesResult::idle_rollers>, "that have no part in it, from 1"},
    {"orders", of<&ModesResult::orders>, "of the parts"},
    {"mode",
     of<[](const ModesResult& m) { return each(m.modes, [&](const Mode& mode) {
                                     return ModeOf{&m, &mode};
                                   }); }>,
     "from the lowest frequency"},
    {"along_travel", of<&ModesResult::along_travel>, "frequencies at positions of the travel"},
};

}  // namespace

PRS_RECORD(TravelLoads, "TravelLoads", "Normal loads over a travel at an interface.", kTravelLoads);
PRS_RECORD(Spectrum, "TravelSpectrum", "Amplitudes of the travel deviation by orders.", kSpectrum);
PRS_RECORD(OrderAmplitude, "TravelOrder", "Amplitude of the travel deviation at an order of a part.", kOrder);
PRS_RECORD(TravelResult, "Travel", "Positions of the turning mechanism, whose parts carry their errors along.",
           kTravel);
PRS_RECORD(TravelNut, "TravelNut", "The nut's seat over a travel.", kTravelNut);
PRS_RECORD(TravelSupport, "TravelBearing", "A bearing over a travel.", kTravelBearing);
PRS_RECORD(TravelEnd, "TravelEnd", "The loaded section of the screw over a travel.", kTravelEnd);
PRS_RECORD(AlongAxes, "AlongAxes", "A number for each axis.", kAlongAxes);
PRS_RECORD(KineticOf, "KineticEnergy", "Where the kinetic energy of a mode is.", kKinetic);
PRS_RECORD(StrainOf, "StrainEnergy", "Where the strain energy of a mode is.", kStrain);
PRS_RECORD(BodyShape, "BodyShape", "Displacements of screw or nut in a mode.", kBodyShape);
PRS_RECORD(RollerShapeOf, "RollerShape", "Displacements of the rollers in a mode.", kRollerShape);
PRS_RECORD(ShapeOf, "ModeShape", "Shape of a mode.", kShape);
PRS_RECORD(ModeOf, "Mode", "A natural mode.", kMode);
PRS_RECORD(MotionOrder, "MotionOrder", "How often a motion comes back in a turn.", kMotionOrder);
PRS_RECORD(AlongTravel, "ModesAlongTravel", "Natural frequencies at positions of the travel.", kAlongTravel);
PRS_RECORD(ModesResult, "Modes", "Natural vibration of the loaded mechanism, without damping.", kModes);

}  // namespace prs
