#include "prs/loads/contact_record.h"

#include "prs/record/record_table.h"

namespace prs {
namespace {

using contact::MechanismGeometry;
using TwoValues = std::array<double, 2>;

template <class T>
constexpr Quantity<PerPart<T>> kPerPart[] = {
    {"screw", of<&PerPart<T>::screw>},
    {"roller", of<&PerPart<T>::roller>},
    {"nut", of<&PerPart<T>::nut>},
};

constexpr Quantity<PerInterface<double>> kPerInterface[] = {
    {"screw", of<&PerInterface<double>::screw>},
    {"nut", of<&PerInterface<double>::nut>},
};

template <class T>
constexpr Quantity<PerDirection<T>> kPerDirection[] = {
    {"tension", of<&PerDirection<T>::tension>},
    {"compression", of<&PerDirection<T>::compression>},
};

template <auto get>
constexpr auto point =
    of<[](const ContactAt& c) { return std::invoke(get, c.contact().geometry.point); }>;

template <contact::PrincipalValues contact::InterfaceGeometry::*values>
constexpr auto both = of<[](const ContactAt& c) {
  return TwoValues{(c.contact().geometry.*values).first, (c.contact().geometry.*values).second};
}>;

template <auto get>
constexpr auto geometry =
    of<[](const ContactAt& c) { return std::invoke(get, c.contact().geometry); }>;

template <double contact::HertzConstants::*get>
constexpr auto hertz = of<[](const ContactAt& c) { return c.contact().hertz.*get; },
                          [](const ContactAt& c) { return c.contact().hertz.ok(); }>;

template <double contact::SubsurfaceShear::*get>
constexpr auto shear = of<[](const ContactAt& c) { return (*c.contact().shear).*get; },
                          [](const ContactAt& c) { return c.contact().shear.has_value(); }>;

template <auto get>
constexpr auto clearance = of<[](const ContactAt& c) {
  return c.contact().clearance ? std::optional<double>((*c.contact().clearance).*get)
                               : std::nullopt;
}>;

using contact::HertzConstants;
using contact::InterfaceGeometry;
using Point = contact::ContactPoint;

constexpr std::string_view kSandu = "Sandu 2018, chapter 1", kYao = "Yao 2023, (55) to (58)";

constexpr Quantity<ContactAt> kInterfaceContact[] = {
    {"radius_on_body_mm", point<&Point::radius_on_body>,
     "of the contact point from the body's axis", kSandu, "radius on the body"},
    {"radius_on_roller_mm", point<&Point::radius_on_roller>,
     "of the contact point from the roller's axis", kSandu, "radius on the roller"},
    {"angle_on_body_deg", point<&Point::angle_on_body>,
     "of the contact point about the body's axis, from the line of centres", kSandu,
     "angle on the body"},
    {"angle_on_roller_deg", point<&Point::angle_on_roller>,
     "of the contact point about the roller's axis, from the line of centres", kSandu,
     "angle on the roller"},
    {"flank_clearance_mm", clearance<&ThreadClearance::flank>,
     "along the axis, each thread in the middle of the other's groove; half the backlash", kYao,
     "flank to flank when centred"},
    {"body_crest_clearance_mm", clearance<&ThreadClearance::body_crest>,
     "along the axis, from the edge of the body's crest to the roller's flank", kYao,
     "crest of the body to flank"},
    {"roller_crest_clearance_mm", clearance<&ThreadClearance::roller_crest>,
     "along the axis, from the edge of the roller's crest to the body's flank", kYao,
     "crest of the roller to flank"},
    {"body_curvatures_per_mm", both<&InterfaceGeometry::body>,
     "principal curvatures, convex > 0, ascending in absolute value", kSandu,
     "curvatures of the body"},
    {"roller_curvatures_per_mm", both<&InterfaceGeometry::roller>,
     "principal curvatures, convex > 0, ascending in absolute value", kSandu,
     "curvatures of the roller"},
    {"relative_curvatures_per_mm", both<&InterfaceGeometry::relative>,
     "eigenvalues of the sum of both curvature tensors, without a factor 1/2", kSandu,
     "relative curvatures"},
    {"curvature_sum_per_mm", geometry<&InterfaceGeometry::curvature_sum>, "kappa_1 + kappa_2",
     "Sandu 2018, (1.77)", "sum of the relative curvatures"},
    {"equivalent_radius_mm",
     geometry<[](const InterfaceGeometry& g) { return 1.0 / g.curvature_sum(); }>,
     "1 over the sum of the relative curvatures"},
    {"first_directions_angle_deg", geometry<&InterfaceGeometry::first_directions_angle>,
     "between the first principal directions of body and roller", "Sandu 2018, (1.61)",
     "angle of the first directions"},
    {"normal_angle_deg", point<&Point::normal_angle>, "psi = arccos|n_z|", kSandu,
     "normal against the axis"},
    {"normal", of<[](const ContactAt& c) {
       const contact::Vector3<double>& n = c.contact().geometry.point.normal;
       return std::array{n.x, n.y, n.z};
     }>,
     "unit vector, outward from the roller: radial, across, axial", kSandu},
    {"backlash_mm",
     of<[](const ContactAt& c) { return c.contact().geometry.point.backlash; },
        [](const ContactAt& c) { return c.same_pitch(); }>,
     "axial play of both faces; < 0: the threads are too thick; needs equal pitches",
     "Sandu 2018, (1.40)"},
    {"hertz_constant_N_per_mm1_5", hertz<&HertzConstants::hertz_constant>,
     "k_0 of N = k_0 delta^1.5", source::kHertz, "Hertz constant"},
    {"ellipticity", hertz<&HertzConstants::ellipticity>, "b/a of the contact ellipse",
     source::kHertz, "ellipticity b/a"},
    {"semi_major_mm_per_N1_3", hertz<&HertzConstants::semi_major_per_cbrt_load>,
     "semi-axis a over the cube root of the normal load", source::kHertz,
     "semi-axis a over cube root of the load"},
    {"semi_minor_mm_per_N1_3", hertz<&HertzConstants::semi_minor_per_cbrt_load>,
     "semi-axis b over the cube root of the normal load", source::kHertz,
     "semi-axis b over cube root of the load"},
    {"max_shear_over_peak_pressure", shear<&contact::SubsurfaceShear::shear_over_pressure>,
     "largest shear stress below the surface over p_0", source::kHertz,
     "largest shear stress over peak pressure", "", "", Reach::complete},
    {"max_shear_depth_over_semi_minor", shear<&contact::SubsurfaceShear::depth_over_semi_minor>,
     "its depth over b", source::kHertz, "depth of the largest shear stress over semi-axis b", "",
     "", Reach::complete},
};

PerPart<double> of_threads(const MechanismGeometry& threads, auto value) {
  return {value(threads.screw), value(threads.roller), value(threads.nut)};
}

template <Interface i>
constexpr auto contact_of = of<[](const Contacts& c) {
  return c.interfaces[i].geometry.ok() ? std::optional(ContactAt{&c, i}) : std::nullopt;
}>;

constexpr Quantity<Contacts> kContacts[] = {
    {"centre_distance_mm", of<[](const Contacts& c) { return c.threads.centre_distance; }>,
     "from the axis of the screw to that of a roller"},
    {"pitch_diameter_mm", of<[](const Contacts& c) {
       return of_threads(c.threads, [](const auto& thread) { return 2.0 * thread.pitch_radius; });
     }>,
     "where thread and groove are equally wide, or as the file has it"},
    {"helix_angle_deg", of<[](const Contacts& c) {
       return of_threads(c.threads, [](const auto& thread) {
         return contact::ThreadSurface(thread).helix_angle();
       });
     }>,
     "at the pitch diameter"},
    {"profile_radius_limits_mm", of<[](const Contacts& c) {
       const auto range = [](const contact::Thread& thread) {
         const contact::RadiusLimits limits = contact::flank_limits(thread);
         return TwoValues{limits.smallest, limits.largest};
       };
       return PerPart<TwoValues>{range(c.threads.screw), range(c.threads.roller),
                                 range(c.threads.nut)};
     }>,
     "radii between which there is a flank", "", "radii of the flanks"},
    {"max_rollers", of<[](const Contacts& c) { return contact::largest_roller_count(c.threads); }>,
     "that fit side by side", "", "rollers that fit"},
    {"screw", contact_of<Interface::screw>, "of roller and screw"},
    {"nut", contact_of<Interface::nut>, "of roller and nut"},
};

constexpr Quantity<ThreadWidths> kThreadWidths[] = {
    {"crest_width_mm", of<&ThreadWidths::crest>, "along the axis; < 0: the profile ends before",
     "Yao 2023, (52) to (54)", "crest width"},
    {"root_width_mm", of<&ThreadWidths::root>, "along the axis", "Yao 2023, (52) to (54)",
     "root width"},
};

template <contact::Thread MechanismGeometry::*part>
constexpr auto widths = of<[](const MechanismGeometry& threads) {
  const std::optional<ThreadWidths> widths = thread_widths(threads.*part);
  return widths && (widths->crest || widths->root) ? widths : std::nullopt;
}>;

constexpr Quantity<MechanismGeometry> kThreads[] = {
    {"screw", widths<&MechanismGeometry::screw>},
    {"roller", widths<&MechanismGeometry::roller>},
    {"nut", widths<&MechanismGeometry::nut>},
};

}  // namespace

Record<PerPart<double>> record_of(Type<PerPart<double>>) {
  return {"PerPart", "One number each of screw, roller and nut.", kPerPart<double>};
}

Record<PerPart<TwoValues>> record_of(Type<PerPart<TwoValues>>) {
  return {"PerPartRange", "Smallest and largest value each of screw, roller and nut.",
          kPerPart<TwoValues>};
}

Record<PerInterface<double>> record_of(Type<PerInterface<double>>) {
  return {"PerInterface", "One number each of the roller's contacts with screw and nut.",
          kPerInterface};
}

Record<PerDirection<double>> record_of(Type<PerDirection<double>>) {
  return {"PerDirection", "One number for each sense of the load.", kPerDirection<double>};
}

Record<PerDirection<std::optional<double>>> record_of(Type<PerDirection<std::optional<double>>>) {
  return {"PerDirection", "One number for each sense of the load.",
          kPerDirection<std::optional<double>>};
}

Record<ContactAt> record_of(Type<ContactAt>) {
  return {"InterfaceContact",
          "Where two threads touch: Sandu 2018, chapter 1. `body` is the screw or the nut.",
          kInterfaceContact};
}

Record<Contacts> record_of(Type<Contacts>) {
  return {"Contacts", "Mechanism and contacts of both interfaces.", kContacts};
}

Record<ThreadWidths> record_of(Type<ThreadWidths>) {
  return {"ThreadWidths", "Axial widths of a truncated thread.", kThreadWidths};
}

Record<MechanismGeometry> record_of(Type<MechanismGeometry>) {
  return {"Threads", "Threads of the parts by themselves; needs their heights.", kThreads};
}

}  // namespace prs
