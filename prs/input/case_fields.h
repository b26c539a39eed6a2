#pragma once

#include <concepts>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "prs/input/field.h"
#include "prs/input/optimize_fields.h"
#include "prs/model/case.h"
#include "prs/model/limits.h"
#include "prs/model/study.h"

/// The input, described once: every key, its unit and bounds, whether it must stand, its meaning.
/// Defaults are the member initialisers of the structs. See field.h for the vocabulary.
namespace prs::input {

/// A load case as it is written: a range of forces is not yet expanded.
struct LoadCaseItem {
  std::optional<std::string> name;
  LoadCase::Share share = LoadCase::Share::solved;
  std::optional<Direction> direction;
  Range axial_force;
  std::optional<double> position;
  std::optional<double> speed;
  SpatialLoad spatial;
};

/// The ends of an interval, and a normal distribution, as they are written.
struct WrittenInterval {
  std::string from, to;
};
struct WrittenNormal {
  std::optional<std::string> mean;
  std::string deviation;
};

/// An input that changes with a factor, as it is written.
struct CompanionItem {
  std::string path;
  std::optional<std::string> label;
  std::optional<WrittenValues> values;
};

/// A factor of a study as it is written.
struct FactorItem {
  std::string path;
  std::optional<std::string> label;
  std::optional<WrittenValues> values;
  std::optional<WrittenInterval> uniform, log_uniform;
  std::optional<WrittenNormal> normal;
  std::optional<std::string> within;
  std::vector<CompanionItem> companions;
};

/// A point of an envelope and the envelope itself, as they are written.
struct EnvelopePointItem {
  enum class Wanted { best };

  std::string name;
  std::optional<std::vector<std::string>> at;
  std::optional<Wanted> wanted;
  std::optional<std::vector<Envelope::Target>> reach;
};
struct EnvelopeItem {
  Envelope::Combine combine = Envelope::Combine::product;
  Envelope::Normalise normalise = Envelope::Normalise::rms;
  std::vector<Envelope::Measure> measures;
  std::vector<EnvelopePointItem> points;
};

/// A study as it is written.
struct StudyItem {
  Command command = Command::slip;
  Plan plan = Plan::one_at_a_time;
  std::optional<int> samples;
  std::int64_t seed = 1;
  std::vector<FactorItem> factors;
  std::optional<std::vector<std::string>> responses;
  std::optional<EnvelopeItem> envelope;
};

/// What a report says of itself.
struct ReportTexts {
  std::optional<std::string> title, customer, author, number, revision;
};

/// A file as it is written: `values` lacks the load cases.
struct CaseFile {
  Case values;
  std::vector<LoadCaseItem> load_cases;
  std::optional<Limits> limits;
  std::optional<StudyItem> study;
  std::optional<OptimizeItem> optimize;
  bool speeds_follow_lead = false;  ///< Speeds are written along the axis.
  std::optional<ReportTexts> report;
};

// Choices: io.word(WORD, member, value, meaning), io.map(KEY, member, value, content, kind,
// meaning)

template <class Io>
void alternatives(Io& io, Mechanism::Type& t) {
  io.word("standard", t, Mechanism::Type::standard, "the rollers stay in place on the nut");
  io.word("inverted", t, Mechanism::Type::inverted, "the rollers stay in place on the screw");
}

template <class Io>
void alternatives(Io& io, Mechanism::Geometry& g) {
  io.word("simulation", g, Mechanism::Geometry::simulation,
          "all pitch diameters and the centre distance are given");
  io.word("design", g, Mechanism::Geometry::design,
          "the screw's pitch diameter and the backlash are given, the others follow");
}

template <class Io>
void alternatives(Io& io, Mechanism::ProfilePlane& p) {
  io.word("normal", p, Mechanism::ProfilePlane::normal, "the plane normal to the helix");
  io.word("axial", p, Mechanism::ProfilePlane::axial, "the plane through the axis");
}

template <class Io>
void alternatives(Io& io, Profile& p) {
  const Quantity radius{unit::length, positive};
  io.word("straight", p.shape, Profile::Shape::straight, "straight flanks");
  io.map("convex", p.shape, Profile::Shape::convex, p.radius, radius, "arc that bulges outwards");
  io.map("concave", p.shape, Profile::Shape::concave, p.radius, radius, "hollow arc");
  io.word("centred", p.shape, Profile::Shape::centred,
          "convex arc about a point on the axis: pitch radius / sin(flank angle)");
}

template <class Io>
void alternatives(Io& io, Guidance& g) {
  io.word("both_end_nodes", g.kind, Guidance::Kind::both_end_nodes,
          "no radial displacement at both nodes of each end element");
  io.word("outer_node", g.kind, Guidance::Kind::outer_node,
          "no radial displacement at the two outermost nodes");
  io.map("ring", g.kind, Guidance::Kind::ring, g.ring_stiffness,
         Quantity{unit::stiffness, positive},
         "a radial spring of this stiffness at both nodes of each end element");
}

/// What the word of a block that may be one word chooses.
inline std::optional<Rings::Carrier>& selector_of(Rings& r) { return r.carrier; }

template <class Io, class C>
requires std::same_as<C, Rings::Carrier> || std::same_as<C, std::optional<Rings::Carrier>>
void alternatives(Io& io, C& c) {
  io.word("housing", c, C(Rings::Carrier::housing), "the rings stand still");
  io.word("nut", c, C(Rings::Carrier::nut), "the rings go with the nut");
  io.word("screw", c, C(Rings::Carrier::screw), "the rings go with the screw");
}

template <class Io>
void alternatives(Io& io, ModelOptions::Mechanism& m) {
  io.word("sector", m, ModelOptions::Mechanism::sector, "one roller with its share of both bodies");
  io.word("full", m, ModelOptions::Mechanism::full, "all rollers on a spatial screw and nut");
}

template <class Io>
void alternatives(Io& io, ModelOptions::ContactPhase& p) {
  io.word("equal", p, ModelOptions::ContactPhase::equal, "all rollers touch at the same places");
  io.word("helical", p, ModelOptions::ContactPhase::helical, "contacts follow the helix");
}

template <class Io>
void alternatives(Io& io, ModelOptions::Bodies& b) {
  io.word("bars", b, ModelOptions::Bodies::bars, "one-dimensional elements, as the paper");
  io.word("refined", b, ModelOptions::Bodies::refined,
          "one-dimensional elements with what bars miss");
  io.word("influence", b, ModelOptions::Bodies::influence,
          "grooved bodies of revolution by finite elements");
}

template <class Io>
void alternatives(Io& io, ModelOptions::RollerContacts& r) {
  io.word("opposite", r, ModelOptions::RollerContacts::opposite,
          "at the same axial position, as on a helical roller with an odd number of starts");
  io.word("half_pitch_apart", r, ModelOptions::RollerContacts::half_pitch_apart,
          "on the two flanks of a ring-shaped tooth, or with an even number of starts");
}

template <class Io>
void alternatives(Io& io, ModelOptions::ToothCompliance& t) {
  using enum ModelOptions::ToothCompliance::Kind;
  io.word("none", t.kind, none, "nothing besides exact Hertz");
  io.map("yamamoto", t.kind, yamamoto, t.width, Quantity{unit::length, positive},
         "Yamamoto's deflection on top, a contact loading this width of thread; for comparison");
}

template <class Io>
void alternatives(Io& io, ModelOptions::Accuracy& a) {
  io.word("working", a, ModelOptions::Accuracy::working, "0.5 % in stiffness");
  io.word("reference", a, ModelOptions::Accuracy::reference, "0.1 % in stiffness");
}

template <class Io>
void alternatives(Io& io, ModelOptions::Roller& r) {
  io.word("flexible", r, ModelOptions::Roller::flexible, "the roller bends");
  io.word("rigid_bending", r, ModelOptions::Roller::rigid_bending, "the roller stays straight");
}

template <class Io>
void alternatives(Io& io, MeasureOptions::Ends& e) {
  using enum MeasureOptions::Ends;
  io.word("fixed_free", e, fixed_free, "one end clamped, the other free");
  io.word("supported_supported", e, supported_supported, "both ends can tilt");
  io.word("fixed_supported", e, fixed_supported, "one end clamped, the other can tilt");
  io.word("fixed_fixed", e, fixed_fixed, "both ends clamped");
}

template <class Io>
void alternatives(Io& io, Direction& d) {
  io.word("tension", d, Direction::tension, "the load pulls the screw out of the mechanism");
  io.word("compression", d, Direction::compression, "the load pushes the screw in");
}

template <class Io>
void alternatives(Io& io, LoadCase::Share& s) {
  io.word("solved", s, LoadCase::Share::solved, "the structure decides on the thread loads");
  io.word("equal", s, LoadCase::Share::equal, "every thread carries the same load");
}

template <class Io>
void alternatives(Io& io, Preload::Arrangement& a) {
  io.word("single_nut", a, Preload::Arrangement::single_nut,
          "rollers wedged in the grooves of screw and nut on both flanks");
  io.word("double_nut", a, Preload::Arrangement::double_nut,
          "two nuts on one screw, each with its rollers, pushed apart by a spacer");
}

template <class Io>
void alternatives(Io& io, Friction& f) {
  io.word("jacod", f.model, Friction::Model::jacod, "lubricated contact, after Jacod");
  io.map("coulomb", f.model, Friction::Model::coulomb, f.coefficient, Number{not_negative},
         "a constant coefficient of friction");
  io.map("mixed", f.model, Friction::Model::mixed, f.mixed, Block{},
         "a film after Jacod through which flanks touch, by film over roughness");
}

template <class Io>
void alternatives(Io& io, contact::FilmDirection& d) {
  io.word("minor_axis", d, contact::FilmDirection::minor_axis,
          "as if rolling along the minor axis of the ellipse (Nijenbanning, Venner, Moes 1994)");
  io.word("rolling", d, contact::FilmDirection::rolling,
          "along the rolling, at its angle to the ellipse (Chittenden, Dowson, Dunn, Taylor 1985)");
}

template <class Io>
void alternatives(Io& io, LubricantName& n) {
  const std::span<const NamedLubricant> known = named_lubricants();
  for (std::size_t i = 0; i < known.size(); ++i)
    io.word(known[i].name, n, LubricantName{i}, known[i].what);
}

template <class Io>
void alternatives(Io& io, WrittenRange::Spacing& s) {
  io.word("linear", s, WrittenRange::Spacing::linear, "the values");
  io.word("logarithmic", s, WrittenRange::Spacing::logarithmic, "their logarithms");
}

/// Those that a study can run.
template <class Io>
void alternatives(Io& io, Command& c) {
  io.word(name(Command::contact), c, Command::contact, "contact points and Hertz constants");
  io.word(name(Command::solve), c, Command::solve, "load distribution, pressures and stiffness");
  io.word(name(Command::slip), c, Command::slip, "slip, power loss and efficiency");
  io.word(name(Command::life), c, Command::life, "life under a load history or spectrum");
  io.word(name(Command::measures), c, Command::measures,
          "capacity, weight, stiffness and the other design measures");
}

template <class Io>
void alternatives(Io& io, Plan& p) {
  io.word("one_at_a_time", p, Plan::one_at_a_time,
          "each value of each factor alone, all others as in the file");
  io.word("grid", p, Plan::grid, "every combination of the values, the last factor fastest");
  io.word("latin_hypercube", p, Plan::latin_hypercube,
          "each factor's range in as many strata as samples, one sample in each");
  io.word("sobol", p, Plan::sobol, "Sobol's sequence, which fills the space evenly");
  io.word("monte_carlo", p, Plan::monte_carlo, "independent draws");
  io.word("sobol_indices", p, Plan::sobol_indices,
          "Saltelli's design for the shares of the factors in the variance: as many designs a "
          "sample as factors, and two");
  io.word("derivatives", p, Plan::derivatives,
          "the file as it stands, with the derivatives by every factor");
}

template <class Io>
void alternatives(Io& io, Envelope::Combine& c) {
  io.word("product", c, Envelope::Combine::product, "multiplied, weights as exponents");
  io.word("sum", c, Envelope::Combine::sum, "added, weights as factors");
}

template <class Io>
void alternatives(Io& io, Envelope::Normalise& n) {
  io.word("rms", n, Envelope::Normalise::rms, "the root mean square of its map");
  io.word("max", n, Envelope::Normalise::max, "the largest magnitude of its map");
  io.word("none", n, Envelope::Normalise::none, "nothing");
}

template <class Io>
void alternatives(Io& io, EnvelopePointItem::Wanted& w) {
  io.word("best", w, EnvelopePointItem::Wanted::best, "where the envelope is largest");
}

// Blocks: io.field(KEY, member, kind, presence, meaning)

template <class Io>
void fields(Io& io, Mechanism::Starts& s) {
  io.field("screw", s.screw, Whole{1, 100}, required, "Thread starts of the screw and of the nut");
  io.field("roller", s.roller, Whole{1, 100}, optional, "Thread starts of a roller");
}

template <class Io>
void fields(Io& io, ThreadHeight& t) {
  const Quantity height{unit::length, not_negative};
  io.field("addendum", t.addendum, height, required, "Height of the crest above the pitch radius");
  io.field("dedendum", t.dedendum, height, required, "Depth of the root below the pitch radius");
  io.field("thickness", t.thickness, Quantity{unit::length, positive}, optional,
           "Axial thickness of the thread at the pitch radius, half a pitch by default");
}

template <class Io>
void fields(Io& io, Mechanism& m) {
  const Quantity diameter{unit::length, positive};
  const Quantity flank_angle{unit::angle,
                             Bounds{std::numbers::pi / 180, 89 * std::numbers::pi / 180}};

  io.field("type", m.type, Choice{}, required, "Kind of mechanism");
  io.field("geometry", m.geometry, Choice{}, optional, "What is given of the geometry");
  io.field("profile_plane", m.profile_plane, Choice{}, optional,
           "Plane in which flank angle and profile radius are measured");

  const bool simulation = m.geometry == Mechanism::Geometry::simulation;
  const Presence in_simulation = required_only_if(simulation, "only with `geometry: simulation`");
  const Presence in_design = optional_only_if(!simulation, "only with `geometry: design`");

  io.field("lead", m.lead, Quantity{unit::length, not_zero}, required,
           "Lead of screw and nut; > 0 right-handed");
  io.field("starts", m.starts, Block{}, required, "Numbers of thread starts");
  io.field("pitch", m.pitch, Each{diameter, optional}, optional,
           "Measured axial pitch of parts where it differs from lead / starts");
  io.field("flank_angle", m.flank_angle, OneOrEach{flank_angle}, required,
           "Flank angle, from the plane normal to the axis");
  io.field("pitch_diameter", m.pitch_diameter, Keys{[&](auto& part) {
             part.field("screw", m.pitch_diameter.screw, diameter, required, "Of the screw");
             part.field("roller", m.pitch_diameter.roller, diameter, in_simulation, "Of a roller");
             part.field("nut", m.pitch_diameter.nut, diameter, in_simulation, "Of the nut");
           }},
           required, "Pitch diameters");
  io.field("centre_distance", m.centre_distance, diameter, in_simulation,
           "Distance of the roller axes from the screw axis");
  io.field("backlash", m.backlash, Each{Quantity{unit::length}, optional}, in_design,
           "Axial play at each interface");
  io.field("profile", m.profile, Each{Choice{}, required}, required,
           "Thread profile of the material");
  io.field("thread", m.thread, Each{Block{}, optional}, optional,
           "Radial extent of truncated threads; the nut's addendum points inwards");
  io.field("rollers", m.rollers, Whole{1, 1000}, required, "Number of rollers");
  io.field("contacts_per_roller", m.contacts_per_roller, Whole{1, 10'000}, required,
           "Threads of a roller in contact, at each interface");
}

/// Of a displacement or a force across the axis, or a rotation about axes across it.
template <class Kind>
auto lateral(Lateral& value, const Kind& kind) {
  return Keys{[&value, kind](auto& io) {
    io.field("y", value.y, kind, optional, "Component y");
    io.field("z", value.z, kind, optional, "Component z");
  }};
}

template <class Io>
void fields(Io& io, Bearing& b) {
  io.field("position", b.position, Quantity{unit::length}, required,
           "Axial position, counted as positions on the nut");
  io.field("lateral", b.lateral, Held{unit::stiffness, true}, optional, "Against displacement");
  io.field("tilt", b.tilt, Held{unit::tilt_stiffness, true}, optional, "Against rotation");
  io.field("offset", b.offset, lateral(b.offset, Quantity{unit::length}), optional,
           "Displacement of its seat");
  io.field("angle", b.angle, lateral(b.angle, Quantity{unit::angle}), optional,
           "Rotation of its seat");
}

template <class Io>
void fields(Io& io, Rings& r) {
  io.field("carried_by", r.carrier, Choice{}, optional,
           "What they are fixed to; nut of a standard mechanism, screw of an inverted one by "
           "default");
  io.field("stiffness", r.stiffness, Held{unit::stiffness}, optional, "Of a ring against it");
}

template <class Io>
void fields(Io& io, Housing& h) {
  io.field("axial", h.axial, Held{unit::stiffness}, optional, "Along the axis");
  io.field("lateral", h.lateral, Held{unit::stiffness}, optional, "Across the axis");
  io.field("tilt", h.tilt, Held{unit::tilt_stiffness}, optional, "Against rotation");
}

template <class Io>
void fields(Io& io, Structure::Screw& s) {
  const Quantity length{unit::length, not_negative};
  io.field("bore", s.bore, length, optional, "Diameter of the bore");
  io.field("free_length", s.free_length, length, optional,
           "From the loaded section to the first contact");
  io.field("far_length", s.far_length, length, optional,
           "Behind the last contact; `mechanism: full`");
  io.field("bearings", s.bearings, List{Block{}}, optional,
           "What holds the screw across the axis; `mechanism: full`");
}

template <class Io>
void fields(Io& io, Structure::Roller& r) {
  const Quantity length{unit::length, positive};
  io.field("end_length", r.end_length, length, required, "Length of each plain end");
  io.field("end_diameter", r.end_diameter, length, required, "Diameter of the plain ends");
  io.field("guidance", r.guidance, Choice{}, optional, "What holds the roller ends radially");
  io.field("rings", r.rings, WordOrBlock{"carried_by"}, optional,
           "The guide rings; `mechanism: full`");
}

template <class Io>
void fields(Io& io, Structure::Flange& f) {
  const Quantity position{unit::length};
  io.field("from", f.from, position, required, "Axial position of its near face");
  io.field("to", f.to, position, required, "Axial position of its far face");
  io.field("outer_diameter", f.outer_diameter, Quantity{unit::length, positive}, required,
           "Replaces the nut's outer diameter there");
}

template <class Io>
void fields(Io& io, Structure::Thrust& t) {
  const Quantity position{unit::length};
  io.field("tension", t.tension, position, optional, "Where tension is held");
  io.field("compression", t.compression, position, optional, "Where compression is held");
}

template <class Io>
void fields(Io& io, Structure::Shoulder& s) {
  const Quantity diameter{unit::length, positive};
  io.field("inner_diameter", s.inner_diameter, diameter, required, "Inside");
  io.field("outer_diameter", s.outer_diameter, diameter, required, "Outside");
}

template <class Io>
void fields(Io& io, Structure::Nut& n) {
  const Quantity length{unit::length, positive};
  io.field("length", n.length, length, required, "Axial length");
  io.field("outer_diameter", n.outer_diameter, length, required, "Outer diameter between flanges");
  io.field("flanges", n.flanges, List{Block{}}, optional, "Flanges; they may touch, not overlap");
  io.field("thrust", n.thrust, Block{}, optional,
           "Axial position of the constrained section, for each direction of the load");
  io.field("shoulder", n.shoulder, Block{}, optional,
           "Ring of the thrust face that the housing touches; `refined` and `influence`");
  io.field("housing", n.housing, Block{}, optional,
           "What holds the thrust section; `mechanism: full`");
}

template <class Io>
void fields(Io& io, Structure& s) {
  io.field("screw", s.screw, Block{}, optional, "Dimensions of the screw other than its thread");
  io.field("roller", s.roller, Block{}, required, "Dimensions of a roller other than its thread");
  io.field("nut", s.nut, Block{}, required,
           "The nut; axial positions count from its end that faces the loaded end of the screw");
}

template <class Io>
void fields(Io& io, Material& m) {
  io.field("youngs_modulus", m.youngs_modulus, Quantity{unit::pressure, positive}, required,
           "Young's modulus");
  io.field("poisson_ratio", m.poisson_ratio,
           Number{{.least = 0.0, .greatest = 0.5, .greatest_excluded = true}}, required,
           "Poisson's ratio");
  io.field("density", m.density, Quantity{unit::density, positive}, optional, "Density");
  io.field("thermal_expansion", m.thermal_expansion,
           Quantity{unit::thermal_expansion, not_negative}, optional,
           "Coefficient of linear thermal expansion");
}

template <class Io>
void fields(Io& io, PitchWave& w) {
  io.field("amplitude", w.amplitude, Quantity{unit::length}, required, "Largest error");
  io.field("period", w.period, Number{positive}, required, "Threads in one period");
  io.field("phase", w.phase, Quantity{unit::angle}, optional, "At the first contact");
}

template <class Io>
void fields(Io& io, PitchError& e) {
  const Quantity error{unit::length};
  io.field("linear", e.linear, error, optional,
           "Growing from 0 at the first contact to this at the last");
  io.field("periodic", e.periodic, Block{}, optional, "A sine over the threads");
  OneOrMany list{e.list, e.lists};
  io.field("list", list, ForEachRoller{List{error}}, optional, "One value a contact");
}

template <class Io>
void fields(Io& io, EndRelief& r) {
  io.field("drop", r.drop, Quantity{unit::length, not_negative}, required,
           "Drop of the roller's pitch radius at the outermost contacts");
  io.field("threads", r.threads, Whole{1, 10'000}, required,
           "Contacts at each end over which it fades to nothing");
}

template <class Io>
void fields(Io& io, Deviations& d) {
  const Quantity temperature{unit::temperature, positive};
  io.field("pitch_error", d.pitch_error, Each{Block{}, optional}, optional,
           "Axial position error of the threads, > 0 away from the loaded end of the screw");
  OneOrMany diameter{d.roller_diameter, d.roller_diameters};
  io.field("roller_diameter", diameter, ForEachRoller{Quantity{unit::length}}, optional,
           "Pitch diameter of the rollers above the nominal one");
  io.field("crowning", d.crowning, Quantity{unit::length, not_negative}, optional,
           "Parabolic drop of the roller's pitch radius at first and last contact");
  io.field("end_relief", d.end_relief, Block{}, optional, "Straight taper at both ends");
  io.field("temperature", d.temperature, OneOrEach{temperature}, optional,
           "Of the parts, uniform in each");
  io.field("reference_temperature", d.reference_temperature, temperature, optional,
           "At which the nominal geometry holds");
  const List offsets{Quantity{unit::length}};
  io.field("roller_position", d.roller_position, OneOrEnds{offsets}, optional,
           "Of each roller in its rings, > 0 outwards; `mechanism: full`");
  io.field("missing_rollers", d.missing_rollers, List{Whole{1, 1000}}, optional,
           "Their numbers; `mechanism: full`");
  io.field("index_error", d.index_error, Each{offsets, optional}, optional,
           "Axial position error of each start; `mechanism: full`");
  io.field("thread_eccentricity", d.thread_eccentricity, Keys{[&](auto& side) {
             const Quantity length{unit::length};
             side.field("screw", d.thread_eccentricity.screw,
                        lateral(d.thread_eccentricity.screw, length), optional, "Of the screw");
             side.field("nut", d.thread_eccentricity.nut,
                        lateral(d.thread_eccentricity.nut, length), optional, "Of the nut");
           }},
           optional, "Of the thread against the axis of its body; `mechanism: full`");
}

template <class Io>
void fields(Io& io, ContactOverrides& c) {
  const Quantity hertz_constant{unit::hertz_constant, positive};
  const Quantity normal_angle{unit::angle, between(0.0, std::numbers::pi / 2)};
  io.field("hertz_constant", c.hertz_constant, Each{hertz_constant, optional}, optional,
           "Load over approach^1.5");
  io.field("normal_angle", c.normal_angle, Each{normal_angle, optional}, optional,
           "Angle between contact normal and axis");
}

template <class Io>
void fields(Io& io, RefinedEffects& e) {
  io.field("core", e.core, Flag{}, optional, "Sections at the thread's root");
  io.field("shear", e.shear, Flag{}, optional, "Shear in the roller's bending");
  io.field("hoop", e.hoop, Flag{}, optional, "Radial expansion of the nut, as a shell");
  io.field("poisson", e.poisson, Flag{}, optional, "Poisson's effect in screw and nut");
  io.field("flange", e.flange, Flag{}, optional, "Bending of the nut at flanges and shoulder");
  io.field("radial", e.radial, Flag{}, optional, "Radial compliance at a thread");
  io.field("concentration", e.concentration, Flag{}, optional,
           "Contacts as rows of points, not rings");
}

template <class Io>
void fields(Io& io, ModelOptions& m) {
  io.field("mechanism", m.mechanism, Choice{}, optional, "How much of the mechanism is modelled");
  io.field("contact_phase", m.contact_phase, Choice{}, optional,
           "Where the rollers touch along the axis; `mechanism: full`");
  io.field("shear", m.shear, Flag{}, optional,
           "Shear flexibility of screw, nut and rollers; `mechanism: full`");
  io.field("bodies", m.bodies, Choice{}, optional, "How screw, roller and nut deform");
  io.field("refined", m.refined, Block{}, optional, "Effects of `bodies: refined`, all by default");
  io.field("accuracy", m.accuracy, Choice{}, optional, "Meshes of `bodies: influence`");
  io.field("roller_contacts", m.roller_contacts, Choice{}, optional,
           "Where screw and nut touch a roller tooth; `refined` and `influence`");
  io.field("tooth_compliance", m.tooth_compliance, Choice{}, optional,
           "Tooth deflection on top of Hertz, which counts it twice");
  io.field("roller", m.roller, Choice{}, optional, "Whether the roller bends");
  io.field("roller_shear", m.roller_shear, Flag{}, optional, "Shear flexibility of the roller");
  io.field("patch_points", m.patch_points,
           Whole{kFewestPatchPoints, 1001,
                 "as fewer points carry up to 91 % more than the load, and friction with it"},
           optional, "Points along each axis of a contact patch; fewer than 9 miss its load");
}

template <class Io>
void fields(Io& io, LoadCaseItem& l) {
  io.field(
      "name", l.name, Text{}, optional,
      "Name of the case, `case-1` for the first by default; a range makes NAME[0], NAME[1], ..");
  io.field("axial_force", l.axial_force, OneOrRange{Quantity{unit::force}}, required,
           "Axial load; > 0 with a direction, of either sign without");
  io.field("share", l.share, Choice{}, optional, "How the load spreads over the threads");

  const Presence where =
      required_unless(l.share == LoadCase::Share::equal, "required unless `share: equal`");
  io.field("direction", l.direction, Choice{}, where, "Sense of the load on the screw");
  io.field("position", l.position, Quantity{unit::length}, where,
           "Axial position of the first roller contact on the nut");
  io.field("speed", l.speed, Quantity{unit::rotational_speed}, optional,
           "In place of operation.speed");

  SpatialLoad& s = l.spatial;
  const Quantity length{unit::length}, angle{unit::angle};
  io.field("carrier_angle", s.carrier_angle, angle, optional,
           "Azimuth of the first roller, from y to z; `mechanism: full`");
  io.field("eccentricity", s.eccentricity, lateral(s.eccentricity, length), optional,
           "Where the axial force acts; `mechanism: full`");
  const auto across = [](SpatialLoad::Across& load, const Quantity& kind) {
    return Keys{[&load, kind](auto& keys) {
      keys.field("y", load.value.y, kind, optional, "Component y");
      keys.field("z", load.value.z, kind, optional, "Component z");
      keys.field("at", load.at, Quantity{unit::length}, optional,
                 "Axial position on the screw, the loaded section by default");
    }};
  };
  io.field("side_force", s.side_force, across(s.side_force, Quantity{unit::force}), optional,
           "On the screw; `mechanism: full`");
  io.field("moment", s.moment, across(s.moment, Quantity{unit::torque}), optional,
           "On the screw; `mechanism: full`");
  io.field("misalignment", s, Keys{[&](auto& seat) {
             seat.field("nut_tilt", s.nut_tilt, lateral(s.nut_tilt, angle), optional, "Rotation");
             seat.field("nut_offset", s.nut_offset, lateral(s.nut_offset, length), optional,
                        "Displacement");
           }},
           optional, "Of the seat of the nut; `mechanism: full`");
  io.field(
      "orbit", s.orbit, Block{}, optional,
      "A turn of the carrier: rollers and rings turn with their errors, errors of screw and nut "
      "stand still; `mechanism: full`");
}

template <class Io>
void fields(Io& io, SpatialLoad::Orbit& o) {
  io.field("steps", o.steps, Whole{1, 1000}, optional, "Positions for each spacing of the rollers");
  io.field("exponent", o.exponent, Number{{.least = 1.0, .greatest = 20.0}}, optional,
           "Of the equivalent loads");
}

template <class Io>
void fields(Io& io, Spacer& s) {
  const Quantity length{unit::length, positive};
  io.field("length", s.length, length, required, "Between the nuts");
  io.field("inner_diameter", s.inner_diameter, length, required, "Inside");
  io.field("outer_diameter", s.outer_diameter, length, required, "Outside");
}

template <class Io>
void fields(Io& io, LoadSweep& l) {
  const Quantity force{unit::force};
  io.field("from", l.from, force, required, "First load; > 0 in tension");
  io.field("to", l.to, force, required, "Last load");
  io.field("steps", l.steps, Whole{2, 10'000}, optional, "Number of loads, ends included");
}

template <class Io>
void fields(Io& io, Preload& p) {
  const Quantity length{unit::length, positive};
  io.field("arrangement", p.arrangement, Choice{}, required, "What pushes against what");

  const Presence in_two_nuts = required_only_if(p.arrangement == Preload::Arrangement::double_nut,
                                                "only with `arrangement: double_nut`");
  io.field("force", p.force, Quantity{unit::force, positive}, optional,
           "Axial load of each side without external load");
  io.field("interference", p.interference, length,
           optional_only_if(!p.force, "in place of `force`"),
           "Single nut: pitch diameter of the rollers above the one that just fills the grooves; "
           "double nut: length of the spacer above the one that just touches");
  io.field("backlash", p.backlash, Quantity{unit::length, not_negative},
           required_only_if(!p.force && !p.interference, "in place of `force` or `interference`"),
           "Axial play instead of preload");
  io.field("position", p.position, Quantity{unit::length}, required,
           "Axial position of the first roller contact on the first nut");
  io.field("spacer", p.spacer, Block{}, in_two_nuts, "Ring between the nuts, of their material");
  io.field("distance", p.distance, length, in_two_nuts,
           "From the last contact of the first nut to the first one of the second");
  io.field("load", p.load, Block{}, required, "External axial loads of the curve");
  io.field("lost_motion_load", p.lost_motion_load, Quantity{unit::force, positive}, optional,
           "The lost motion is the travel between this load in tension and in compression; 5 % of "
           "the largest load of the curve by default");
}

template <class Io>
void fields(Io& io, CsvColumn& c) {
  io.field("column", c.column, Text{"force_kN"}, required, "Its name in the heading of the file");
  io.field("unit", c.unit, Text{"kN"}, required, "Of its numbers");
}

template <class Io>
void fields(Io& io, HistorySource& h) {
  io.field("file", h.file, Text{"forces.csv"}, required,
           "Comma-separated values with a heading, one row per sample; relative to this file");
  io.field("force", h.force, Block{}, required, "Axial force, > 0 in tension");
  io.field("position", h.position, Block{}, optional, "Axial position of the nut on the screw");
  io.field("speed", h.speed, Block{}, optional_only_if(!h.position, "in place of `position`"),
           "Of the screw against the nut; else `operation.speed`");
  io.field("time", h.time, Block{}, optional, "Time of the sample");
  io.field("interval", h.interval, Quantity{unit::duration, positive},
           optional_only_if(!h.time, "in place of `time`"), "Between two samples");
  io.field("hysteresis", h.hysteresis, Quantity{unit::force, not_negative}, optional,
           "Ranges up to this are no load cycles");
  io.field("bins", h.bins, Whole{1, 200}, optional, "Of the matrix of cycles, along each axis");
}

template <class Io>
void fields(Io& io, SpectrumLoad& l) {
  io.field("force", l.force, Quantity{unit::force, positive}, required, "Axial load");
  io.field("direction", l.direction, Choice{}, required, "Sense of the load on the screw");
  constexpr std::string_view one = "as one of revolutions, distance, duration and share";
  const Bounds revolutions{.least = 0.0, .greatest = 1e15, .least_excluded = true};
  io.field("revolutions", l.revolutions, Number{revolutions}, optional,
           "Of the screw against the nut under the load");
  io.field("distance", l.distance, Quantity{unit::length, positive},
           optional_only_if(!l.revolutions, one), "Travel under the load");
  io.field("duration", l.duration, Quantity{unit::duration, positive},
           optional_only_if(!l.revolutions && !l.distance, one),
           "Under the load, at `operation.speed`");
  const bool measured = l.revolutions || l.distance || l.duration;
  io.field("share", l.share, Number{{.least = 0.0, .greatest = 1.0, .least_excluded = true}},
           required_only_if(!measured, one), "Of the revolutions of the spectrum");
}

template <class Io>
void fields(Io& io, Life& l) {
  io.field("history", l.history, Block{}, optional, "Loads over time or travel, from a file");
  io.field("spectrum", l.spectrum, List{Block{}, l.history ? 0 : 1},
           required_only_if(!l.history, "in place of `history`"), "Loads and how long each acts");
  io.field("share", l.share, Choice{}, optional, "How the load spreads over the threads");
  io.field("position", l.position, Quantity{unit::length},
           required_unless(l.share == LoadCase::Share::equal, "required unless `share: equal`"),
           "Axial position of the first roller contact on the nut");
  const Quantity capacity{unit::force, positive};
  io.field("dynamic_capacity", l.dynamic_capacity, capacity, optional,
           "Of a catalogue, in place of Lemor's formula");
  io.field("static_capacity", l.static_capacity, capacity, optional,
           "Catalogue value, in addition to that by pressure");
  io.field("reliability", l.reliability,
           Quantity{unit::share, Bounds{.least = 0.90, .greatest = 0.99}}, optional,
           "Share of many screws that shall reach the rated life: a1 of ISO 281");
  io.field("modification_factor", l.modification_factor,
           Number{{.least = 0.0, .greatest = 50.0, .least_excluded = true}}, optional,
           "a_ISO of ISO 281 (film, cleanliness, fatigue limit), by which the rated life is "
           "multiplied");
  io.field("load_case", l.load_case, Text{}, optional,
           "Name of the load case whose side loads, misalignment and orbit act together with all "
           "forces; `mechanism: full`");
  io.field("fatigue_slope", l.fatigue_slope, Number{{.least = 1.0, .greatest = 20.0}}, optional,
           "Slope of the S-N curve, for equivalent load ranges");
}

template <class Io>
void fields(Io& io, MeasureOptions::Shaft& s) {
  io.field("length", s.length, Quantity{unit::length, positive}, required,
           "Greatest distance between the supports of the screw");
  io.field("ends", s.ends, Choice{}, required, "How the screw is held at both ends of it");
}

template <class Io>
void fields(Io& io, MeasureOptions& m) {
  io.field("loaded_width", m.loaded_width, Quantity{unit::length, positive}, optional,
           "Of thread that one contact loads, for the compliance and the strength of its tooth");
  io.field("friction_coefficient", m.friction_coefficient, Number{{.least = 0.0, .greatest = 1.0}},
           optional,
           "Of the whole mechanism, as catalogues state it, for the estimate of efficiency");
  io.field("yield_strength", m.yield_strength, Quantity{unit::pressure, positive}, optional,
           "Of the screw's shaft, for short columns");
  io.field("shaft", m.shaft, Block{}, optional, "Of the screw, for buckling and critical speed");
}

template <class Io>
void fields(Io& io, ViscosityPoint& p) {
  io.field("temperature", p.temperature, Quantity{unit::temperature, positive}, required,
           "Where the viscosity was measured");
  io.field("viscosity", p.viscosity, Quantity{unit::viscosity, positive}, optional,
           "Dynamic viscosity");
  io.field("kinematic_viscosity", p.kinematic_viscosity,
           Quantity{unit::kinematic_viscosity, positive},
           required_only_if(!p.viscosity, "in place of `viscosity`"), "Kinematic viscosity");
}

template <class Io>
void fields(Io& io, contact::WaltherLine& w) {
  io.field("intercept", w.intercept, Number{}, required, "At T = 1 K");
  io.field("slope", w.slope, Number{positive}, required, "Fall with log10(T/K)");
}

template <class Io>
void fields(Io& io, Lubricant& l) {
  const Quantity stress{unit::pressure, positive};
  io.field("name", l.name, Listed{"prs list lubricants"}, optional,
           "Stands for the values of a known lubricant; keys next to it replace single ones");
  io.field("temperature", l.temperature, Quantity{unit::temperature, positive}, optional,
           "In operation");

  const bool by_temperature = l.temperature.has_value();
  io.field("viscosity", l.viscosity, Quantity{unit::viscosity, positive},
           optional_only_if(!by_temperature, "in place of `temperature`"),
           "Dynamic viscosity at ambient pressure in operation");
  // With `heat` the temperature itself need not stand.
  io.field("walther", l.walther, Block{},
           optional_only_if(by_temperature || !l.viscosity, "only with `temperature`"),
           "log10 log10(nu/(mm^2/s) + 0.7) = intercept - slope log10(T/K), nu = viscosity/density");
  io.field("viscosity_at", l.viscosity_at, List{Block{}, 2, 2},
           Presence{by_temperature && !l.walther && !l.name, !l.viscosity && !l.walther,
                    "with `temperature`, in place of `walther`"},
           "Two points through which the line goes");
  io.field("density", l.density, Quantity{unit::density, positive}, optional,
           "Of the oil, between dynamic and kinematic viscosity");
  const Presence named = required_unless(l.name.has_value(), "required unless `name` is given");
  io.field("pressure_viscosity", l.pressure_viscosity, Quantity{unit::pressure_viscosity, positive},
           named, "Pressure-viscosity coefficient; with `name` estimated from the viscosity");
  io.field("eyring_stress", l.eyring_stress, stress, named,
           "Eyring shear stress; with `name` 5 MPa by default");
  io.field("film", l.film, Keys{[&](auto& film) {
             film.field("direction", l.film.direction, Choice{}, optional,
                        "Direction of rolling that the central film takes");
           }},
           optional, "Central film of the contacts");
}

template <class Io>
void fields(Io& io, MixedFriction& m) {
  io.field("boundary", m.boundary, Number{not_negative}, required,
           "Coefficient of friction of flanks that touch");
  io.field("exponent", m.exponent, Number{positive}, optional,
           "Of (1 + film over roughness)^-exponent, the share of the load on flanks that touch");
}

template <class Io>
void fields(Io& io, Wear& w) {
  io.field("coefficient", w.coefficient, Quantity{unit::wear, positive}, required,
           "Volume that both flanks lose for each force and sliding path (Archard)");
}

template <class Io>
void fields(Io& io, Operation& o) {
  io.field("speed", o.speed, Quantity{unit::rotational_speed}, required,
           "Screw against nut, or along the axis: n = v/|lead|; with the sign of the axial force "
           "(left-handed: the other) the screw drives, else the load");
  io.field("slip_ratio", o.slip_ratio, Number{{.least = 0.0, .greatest = 1.0}}, optional,
           "Imposed in place of that of the roller's equilibrium");
}

template <class Io>
void fields(Io& io, contact::JournalBearing& b) {
  const Quantity length{unit::length, positive};
  io.field("length", b.length, length, required, "Axial length of one head's bearing");
  io.field("diameter", b.diameter, length, required, "Diameter of the roller's head");
  io.field("radial_clearance", b.radial_clearance, length, required,
           "Radius of the hole less that of the head");
}

template <class Io>
void fields(Io& io, Carrier& c) {
  const Quantity torque{unit::torque, not_negative};
  const Bounds gear_pressure_angle =
      between(5 * std::numbers::pi / 180, 40 * std::numbers::pi / 180);
  io.field("roller_torque", c.roller_torque, torque, optional, "Resists a roller's spin");
  io.field("screw_torque", c.screw_torque, torque, optional, "Resists the carrier on the screw");
  io.field("nut_torque", c.nut_torque, torque, optional, "Resists the carrier on the nut");
  io.field("bearing", c.bearing, Block{}, optional,
           "Plain bearings of the roller's heads, lubricated, in place of roller_torque");
  io.field("gear_pressure_angle", c.gear_pressure_angle, Quantity{unit::angle, gear_pressure_angle},
           optional, "Of the gears between rollers and nut, inverted: and screw");
}

template <class Io>
void fields(Io& io, Heat::Conductance& c) {
  const Quantity conductance{unit::thermal_conductance, not_negative};
  io.field("screw_ambient", c.screw_ambient, conductance, required,
           "From the screw to its surroundings, its bearings included");
  io.field("nut_ambient", c.nut_ambient, conductance, required,
           "From the nut to its surroundings, its seat included");
  io.field("rollers_ambient", c.rollers_ambient, conductance, optional,
           "From all rollers to their surroundings");
  io.field("screw_rollers", c.screw_rollers, conductance, optional,
           "From the screw to all rollers");
  io.field("rollers_nut", c.rollers_nut, conductance, optional, "From all rollers to the nut");
}

template <class Io>
void fields(Io& io, Heat::DutyStep& s) {
  const Quantity duration{unit::duration, positive};
  io.field("load_case", s.load_case, Text{"pull"}, optional, "Name of the load case that acts");
  io.field("duration", s.duration, duration,
           required_only_if(s.load_case.has_value(), "with `load_case`"), "For how long it acts");
  io.field("rest", s.rest, duration,
           required_only_if(!s.load_case, "in place of `load_case` and `duration`"),
           "For how long nothing moves");
}

template <class Io>
void fields(Io& io, Heat::Capacity& c) {
  const Quantity capacity{unit::heat_capacity, positive};
  io.field("screw", c.screw, capacity, required, "Of the screw");
  io.field("rollers", c.rollers, capacity, required, "Of all rollers");
  io.field("nut", c.nut, capacity, required, "Of the nut");
}

template <class Io>
void fields(Io& io, Heat& h) {
  io.field("ambient", h.ambient, Quantity{unit::temperature, positive}, required,
           "Temperature of the surroundings");
  io.field("conductance", h.conductance, Block{}, required,
           "Heat flow over the difference of temperature");
  io.field("duty", h.duty, List{Block{}, 1}, optional,
           "Load cases and rests one after the other, again and again");
  io.field("capacity", h.capacity, Block{}, optional, "Heat capacities of the parts, for `duty`");
  io.field("specific_heat", h.specific_heat, Quantity{unit::specific_heat, positive},
           optional_only_if(!h.capacity, "in place of `capacity`"),
           "Of all parts, for `duty`: their masses are those of `prs measures`, the screw's over "
           "the length of the nut");
}

template <class Io>
void fields(Io& io, Limits& l) {
  const Quantity length{unit::length, positive};
  io.field("life", l.life, EitherQuantity{{unit::duration, positive}, {unit::distance, positive}},
           optional, "Least rated life, as time or travel");
  io.field("static_safety", l.static_safety, Number{positive}, optional, "Least");
  io.field("peak_pressure", l.peak_pressure, Quantity{unit::pressure, positive}, optional,
           "Greatest, of all contacts");
  io.field("buckling_safety", l.buckling_safety, Number{positive}, optional, "Least");
  io.field("critical_speed_share", l.critical_speed_share, Quantity{unit::share, positive},
           optional, "Greatest speed over the critical one");
  io.field("speed_times_diameter", l.speed_times_diameter, Quantity{unit::speed, positive},
           optional, "Greatest n d, d the pitch diameter of the screw");
  io.field("nut_diameter", l.nut_diameter, length, optional,
           "Greatest outer diameter of the nut, flanges left out");
  io.field("nut_length", l.nut_length, length, optional, "Greatest length of the nut");
  io.field("weight", l.weight, Quantity{unit::mass, positive}, optional,
           "Greatest: nut, rollers and screw over `measures.shaft.length`");
  io.field("stiffness", l.stiffness, Quantity{unit::stiffness, positive}, optional,
           "Least axial stiffness, in series with that of `measures.shaft`");
  io.field("efficiency", l.efficiency, Quantity{unit::share, Bounds{0.0, 1.0, true, true, false}},
           optional, "Least, where the screw drives");
  io.field("temperature", l.temperature, Quantity{unit::temperature, positive}, optional,
           "Greatest of screw, rollers and nut");
}

template <class Io>
void fields(Io& io, WrittenInterval& i) {
  io.field("from", i.from, Verbatim{}, required, "Least value");
  io.field("to", i.to, Verbatim{}, required, "Greatest value, in the same unit");
}

template <class Io>
void fields(Io& io, WrittenNormal& n) {
  io.field("deviation", n.deviation, Verbatim{}, required, "Standard deviation");
  io.field("mean", n.mean, Verbatim{}, optional, "In place of what the file says");
}

template <class Io>
void fields(Io& io, CompanionItem& c) {
  io.field("path", c.path, Text{"mechanism.lead"}, required,
           "What changes with the factor, as `--set` names it");
  io.field("values", c.values, ListOrRange{}, required, "One for each value of the factor");
  io.field("label", c.label, Text{"lead"}, optional, "Its name in tables and figures");
}

template <class Io>
void fields(Io& io, FactorItem& f) {
  io.field("path", f.path, Text{"mechanism.lead"}, required,
           "What to vary, as `--set` names it; of a list of numbers every entry is drawn on its "
           "own");
  io.field("values", f.values, ListOrRange{}, optional,
           "As they would stand in the file; one of them, all as likely, in a plan with samples");
  io.field("uniform", f.uniform, Block{}, optional,
           "In a plan with samples, in place of `values`: drawn from an interval");
  io.field("log_uniform", f.log_uniform, Block{}, optional, "The same, uniform in the logarithm");
  io.field("normal", f.normal, Block{}, optional,
           "In a plan with samples, in place of `values`: normally distributed");
  io.field("within", f.within, Verbatim{}, optional,
           "In a plan with samples, in place of `values`: uniform about what the file says, by a "
           "share `3 %` or a half width `0.02 mm` to both sides, or from the lower to the upper "
           "deviation `[-0.01 mm, 0.03 mm]`");
  io.field("label", f.label, Text{"lead"}, optional, "Its name in tables and figures");
  io.field("with", f.companions, List{Block{}, 1}, optional,
           "Inputs that change together with this one, value by value");
}

template <class Io>
void fields(Io& io, Envelope::Measure& m) {
  io.field("response", m.response, Text{"axial_stiffness_N_per_um"}, required,
           "What is measured: the path of a response");
  io.field("weight", m.weight, Number{not_zero}, optional,
           "Exponent in a product, factor in a sum; < 0 of what shall be small");
}

template <class Io>
void fields(Io& io, Envelope::Target& t) {
  io.field("response", t.response, Text{"axial_stiffness_N_per_um"}, required,
           "The path of a response");
  io.field("value", t.value, Number{}, required, "What it shall be, in the unit of the path");
}

template <class Io>
void fields(Io& io, EnvelopePointItem& p) {
  io.field("name", p.name, Text{"A"}, required, "In tables and figures");
  io.field("at", p.at, List{Verbatim{}, 2, 2}, optional, "Values of the two factors");
  io.field("wanted", p.wanted, Choice{}, optional, "In place of `at`");
  io.field("reach", p.reach, List{Block{}, 1, 2}, optional,
           "In place of `at`: one response, and the envelope as good as it gets along the lines of "
           "the grid; or two");
}

template <class Io>
void fields(Io& io, EnvelopeItem& e) {
  io.field("combine", e.combine, Choice{}, optional, "How the measures become one");
  io.field("normalise", e.normalise, Choice{}, optional, "What each measure is divided by before");
  io.field("measures", e.measures, List{Block{}, 1}, required, "What makes a design good or bad");
  io.field("points", e.points, List{Block{}, 1}, optional,
           "Designs to read off, each with one of at, wanted, reach");
}

template <class Io>
void fields(Io& io, StudyItem& s) {
  io.field("command", s.command, Choice{}, required, "What each design runs through");
  io.field("plan", s.plan, Choice{}, optional, "How designs are chosen");
  const std::string_view sampled =
      "only with the plans latin_hypercube, sobol, monte_carlo and sobol_indices";
  io.field("samples", s.samples, Whole{1, kMostDesigns - 1},
           required_only_if(is_sampled(s.plan), sampled), "Number of draws");
  io.field("seed", s.seed, Whole{0, std::int64_t{1} << 53},
           optional_only_if(is_sampled(s.plan), sampled),
           "Of the random numbers: the same seed draws the same designs");
  io.field("factors", s.factors, List{Block{}, 1}, required, "The inputs that vary");
  io.field(
      "responses", s.responses, List{Text{"axial_stiffness_N_per_um"}, 1}, optional,
      "What is recorded of each design: paths into the first load case of its JSON document or "
      "into the document, of an array `.max`, `.min`, `.mean` or `[k]`; a choice that suits "
      "the command by default, with an envelope what it needs");
  io.field("envelope", s.envelope, Block{},
           optional_only_if(s.plan == Plan::grid, "with the plan grid"),
           "Maps of measures over two factors, made one, and designs read off them");
}

template <class Io>
void fields(Io& io, ReportTexts& r) {
  io.field("title", r.title, Text{"\"Press 40 kN\""}, optional, "What was calculated");
  io.field("customer", r.customer, Text{"\"Customer\""}, optional, "For whom");
  io.field("author", r.author, Text{"\"Author\""}, optional, "By whom");
  io.field("number", r.number, Text{"\"C-1234\""}, optional, "Of the calculation or the drawing");
  io.field("revision", r.revision, Text{"\"A\""}, optional, "Of the calculation");
}

template <class Io>
void fields(Io& io, CaseFile& file) {
  Case& c = file.values;
  io.field("mechanism", c.mechanism, Block{}, required, "The threads");
  io.field("structure", c.structure, Block{}, optional, "The parts between and around the threads");
  io.field("materials", c.materials, OneOrEach{Block{}}, optional, "Elastic properties");
  io.field("deviations", c.deviations, Block{}, optional,
           "How the real parts differ from their nominal geometry");
  io.field("contact", c.contact, Block{}, optional,
           "Values that replace what the geometry gives, in the load distribution only");
  io.field("model", c.model, Block{}, optional, "Choices of the model");
  io.field("load_cases", file.load_cases, List{Block{}, 1}, optional, "Loads, each on its own");
  io.field("preload", c.preload, Block{}, optional,
           "How the play is taken out, and the curve through zero, for `prs preload`");
  io.field("life", c.life, Block{}, optional, "Load history or spectrum for `prs life`");
  io.field("measures", c.measures, Block{}, optional, "Further inputs of the design measures");
  const Bounds up_to_100_um{.least = 0.0, .greatest = 1e-4, .least_excluded = true};
  io.field("roughness", c.roughness, OneOrEach{Quantity{unit::length, up_to_100_um}}, optional,
           "Rms roughness Rq of the flanks, for the film ratio");
  io.field("lubricant", c.lubricant, Block{}, optional, "The oil, or the base oil of the grease");
  io.field("friction", c.friction, ChoiceUnder{"model"}, optional, "Law of friction");
  io.field("wear", c.wear, Block{}, optional, "Wear of the flanks, for `prs slip`");
  io.field("operation", c.operation, Block{}, optional, "How the mechanism runs");
  io.field("carrier", c.carrier, Block{}, optional, "What acts on the rollers besides the threads");
  io.field("heat", c.heat, Block{}, optional,
           "How the parts get rid of the heat of friction, for `prs slip`");
  io.field("limits", file.limits, Block{}, optional,
           "What the verdict of `prs check` and of the report holds the case against");
  io.field("study", file.study, Block{}, optional, "What `prs study` varies");
  io.field("optimize", file.optimize, Block{}, optional,
           "What `prs optimize` varies, and its aims");
  io.field("report", file.report, Block{}, optional, "Title block of `prs report`");
}

}  // namespace prs::input
