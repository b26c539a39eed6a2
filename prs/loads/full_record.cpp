#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

constexpr Quantity<RollerShares> kRollerShares[] = {
    {"roller_share_percent", of<&RollerShares::share>, "of the axial load, one for each roller"},
    {"largest_normal_load_N", of<&RollerShares::largest_normal_load>, "of all rollers"},
    {"largest_roller", of<&RollerShares::largest_roller>, "where the largest load acts, from 1"},
    {"largest_thread", of<&RollerShares::largest_thread>, "where the largest load acts, from 1"},
    {"overload_factor", of<&RollerShares::overload_factor>,
     "largest load over that of the same screw with the axial force only"},
    {"unloaded_threads", of<&RollerShares::unloaded_threads>, "of the rollers present"},
};

std::vector<double> pair_of(const Lateral& l) { return {l.y, l.z}; }

std::vector<std::vector<double>> rows_of(const Eigen::MatrixXd& m) {
  std::vector<std::vector<double>> rows;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    rows.emplace_back();
    for (Eigen::Index j = 0; j < m.cols(); ++j) rows.back().push_back(m(i, j));
  }
  return rows;
}

std::optional<std::vector<std::vector<double>>> given(const Eigen::MatrixXd& m) {
  return m.size() ? std::optional(rows_of(m)) : std::nullopt;
}

constexpr Quantity<ScrewEnd> kScrewEnd[] = {
    {"displacement_um", of<[](const ScrewEnd& s) {
       return std::vector<double>{s.displacement[0], s.displacement[1], s.displacement[2]};
     }>,
     "x, y, z; misalignment included"},
    {"rotation_mrad", of<[](const ScrewEnd& s) {
       return std::vector<double>{s.displacement[3], s.displacement[4]};
     }>,
     "about y and z"},
    {"freedoms", of<[](const ScrewEnd& s) {
       static const std::string names[] = {"x", "y", "z", "theta_y", "theta_z"};
       return each(s.freedoms, [](int k) { return names[k]; });
     }>,
     "those that no bearing holds there: the order of both matrices"},
    {"stiffness_SI", of<[](const ScrewEnd& s) { return given(s.stiffness); }>,
     "tangent, N/m, N and N m/rad; the inverse of the compliance", "", "stiffness in N/m, N, N m/rad"},
    {"compliance_SI", of<[](const ScrewEnd& s) { return given(s.compliance); }>, "displacements per load at the load",
     "", "compliance in m/N, 1/N, rad/(N m)"},
};

std::vector<double> list_of(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

struct NutSupport {
  const SupportForce* support;
};

constexpr Quantity<NutSupport> kNutSupport[] = {
    {"force_N", of<[](const NutSupport& s) { return list_of(s.support->force); }>,
     "x, y, z, of the housing on the nut"},
    {"moment_Nm", of<[](const NutSupport& s) { return pair_of(s.support->moment); }>, "about y and z"},
    {"at_mm", of<[](const NutSupport& s) { return s.support->position; }>, "the thrust section", "", "position"},
};

constexpr Quantity<SupportForce> kSupport[] = {
    {"at_mm", of<&SupportForce::position>, "x", "", "position"},
    {"force_N", of<[](const SupportForce& s) {
       return std::vector<double>{s.force[1], s.force[2]};
     }>,
     "y, z, of the bearing on the screw"},
    {"moment_Nm", of<[](const SupportForce& s) { return pair_of(s.moment); }>, "about y and z"},
};

constexpr Quantity<RingForce> kRing[] = {
    {"force_N", of<[](const RingForce& r) { return pair_of(r.force); }>, "y, z, of the ring on the rollers"},
    {"moment_Nm", of<[](const RingForce& r) { return pair_of(r.moment); }>,
     "of the ring on the rollers about y and z, at `at_mm`"},
    {"at_mm", of<&RingForce::position>, "x"},
    {"roller_N", of<&RingForce::rollers>, "on each roller, outwards", "", "force on each roller"},
};

struct Reactions {
  const FullLoads* full;
};

constexpr Quantity<Reactions> kReactions[] = {
    {"nut", of<[](const Reactions& r) { return NutSupport{&r.full->nut}; }>, "of the nut's seat"},
    {"rings", of<[](const Reactions& r) { return std::vector<RingForce>(r.full->rings.begin(), r.full->rings.end()); }>,
     "near and far"},
    {"bearings", of<[](const Reactions& r) -> const std::vector<SupportForce>& { return r.full->bearings; }>,
     "as the file has them"},
};

struct Symmetric {
  const FullLoads* full;
};

constexpr Quantity<Symmetric> kSymmetric[] = {
    {"axial_displacement_um", of<[](const Symmetric& s) { return s.full->symmetric.axial_displacement; }>,
     "of the loaded section"},
    {"axial_stiffness_N_per_um", of<[](const Symmetric& s) { return s.full->symmetric_stiffness; }>,
     "secant: force over displacement"},
    {"tangent_stiffness_N_per_um", of<[](const Symmetric& s) { return s.full->symmetric.tangent_stiffness; }>,
     "derivative of the force by the displacement"},
    {"largest_normal_load_N", of<[](const Symmetric& s) {
       const PerInterface<double>& largest = s.full->symmetric.largest_normal_load;
       return std::vector<double>{largest.screw, largest.nut};
     }>,
     "at the screw and at the nut"},
};

constexpr Quantity<OrbitLoads> kOrbitLoads[] = {
    {"first_roller_largest_normal_load_N", of<&OrbitLoads::first_roller>,
     "of the first roller that is there, at each position"},
    {"equivalent_normal_load_N", of<&OrbitLoads::equivalent>,
     "(mean N^exponent)^(1/exponent) over the turn, by roller and thread"},
    {"largest_normal_load_N", of<&OrbitLoads::largest>, "of the whole turn"},
    {"at_carrier_angle_deg", of<&OrbitLoads::carrier_angle>, "where the largest load acts"},
    {"largest_roller", of<&OrbitLoads::roller>, "where the largest load acts, from 1"},
    {"largest_thread", of<&OrbitLoads::thread>, "where the largest load acts, from 1"},
    {"largest_equivalent_normal_load_N", of<&OrbitLoads::largest_equivalent>, "of all threads"},
    {"least_normal_load_N", of<&OrbitLoads::least>, "of the whole turn"},
};

template <Interface i>
constexpr auto orbit_loads = of<[](const Orbit& o) -> const OrbitLoads& { return o.loads[i]; }>;

constexpr Quantity<Orbit> kOrbit[] = {
    {"steps", of<&Orbit::steps>, "positions for each spacing of the rollers"},
    {"positions", of<&Orbit::positions>, "of the whole turn"},
    {"exponent", of<&Orbit::exponent>, "of the equivalent loads"},
    {"carrier_angles_deg", of<&Orbit::carrier_angle>, "of each position"},
    {"screw", orbit_loads<Interface::screw>, "contacts at the screw"},
    {"nut", orbit_loads<Interface::nut>, "contacts at the nut"},
    {"axial_displacement_um", of<&Orbit::axial_displacement>, "at the positions that differ"},
    {"axial_error_um", of<&Orbit::axial_error>, "peak to peak"},
};

constexpr Quantity<FullLoads> kFullLoads[] = {
    {"dofs", of<&FullLoads::freedoms>, "freedoms of the model", "", "degrees of freedom of the model"},
    {"rollers", of<&FullLoads::rollers>, "missing ones included"},
    {"carrier_angle_deg", of<&FullLoads::carrier_angle>, "azimuth of the first roller"},
    {"idle_rollers", of<&FullLoads::idle_rollers>, "that carry nothing, from 1"},
    {"screw_end", of<&FullLoads::screw_end>, "displacement and stiffness of the loaded section"},
    {"reactions", of<[](const FullLoads& f) { return Reactions{&f}; }>, "forces of the supports on the parts"},
    {"symmetric", of<[](const FullLoads& f) { return Symmetric{&f}; }>,
     "the same screw with the axial force only: aligned, all rollers, nominal parts", "",
     "the same screw, axial force only"},
    {"orbit", of<&FullLoads::orbit>, "what a turn of the carrier does", "", "a turn of the carrier"},
    {"travel", of<&FullLoads::travel>, "positions of the turning mechanism", "", "travel"},
    {"modes", of<&FullLoads::modes>, "natural vibration about the equilibrium", "", "natural frequencies"},
};

}  // namespace

PRS_RECORD(RollerShares, "RollerShares", "How the load spreads over the rollers of a full mechanism.", kRollerShares);
PRS_RECORD(ScrewEnd, "ScrewEnd", "The loaded section of the screw of a full mechanism.", kScrewEnd);
PRS_RECORD(NutSupport, "NutSupport", "What holds the nut.", kNutSupport);
PRS_RECORD(SupportForce, "BearingForce", "What a bearing does to the screw.", kSupport);
PRS_RECORD(RingForce, "RingForce", "What a guide ring does to the rollers.", kRing);
PRS_RECORD(Reactions, "Reactions", "Forces of the supports of a full mechanism on its parts.", kReactions);
PRS_RECORD(Symmetric, "SymmetricLoads", "The screw under its axial force alone.", kSymmetric);
PRS_RECORD(OrbitLoads, "OrbitLoads", "What a turn of the carrier does at an interface.", kOrbitLoads);
PRS_RECORD(Orbit, "Orbit", "A turn of the carrier of a full mechanism.", kOrbit);
PRS_RECORD(FullLoads, "FullLoads", "What the full mechanism adds to a load case.", kFullLoads);

}  // namespace prs
