#include "prs/bodies/body_models.h"
#include "prs/indices.h"
#include "prs/input/field.h"

namespace prs::input {

namespace {
/// Deviation, offset or play, which are small against the parts.
constexpr Quantity kSmallLength{unit::length, unbounded, "10 um"};
}  // namespace

void alternatives(Choices& io, Mechanism::Type& t) {
  for (const Mechanism::Type type : contact::kMechanismTypes)
    io(contact::facts_of(type).name, t, type, contact::facts_of(type).meaning);
}

void alternatives(Choices& io, Mechanism::Geometry& g) {
  io("simulation", g, Mechanism::Geometry::simulation, "all pitch diameters and the centre distance are given");
  io("design", g, Mechanism::Geometry::design,
     "the screw's pitch diameter and the backlash are given, the others follow");
}

void alternatives(Choices& io, Mechanism::ProfilePlane& p) {
  io("normal", p, Mechanism::ProfilePlane::normal, "the plane normal to the helix");
  io("axial", p, Mechanism::ProfilePlane::axial, "the plane through the axis");
}

void alternatives(Choices& io, Profile& p) {
  const Quantity radius{unit::length, positive};
  io("straight", p.shape, Profile::Shape::straight, "straight flanks");
  io("convex", p.shape, Profile::Shape::convex, p.radius, radius, "arc that bulges outwards");
  io("concave", p.shape, Profile::Shape::concave, p.radius, radius, "hollow arc");
  io("centred", p.shape, Profile::Shape::centred,
     "convex arc about a point on the axis: pitch radius / sin(flank angle)");
}

void alternatives(Choices& io, Guidance& g) {
  io("both_end_nodes", g.kind, Guidance::Kind::both_end_nodes,
     "no radial displacement at both nodes of each end element");
  io("outer_node", g.kind, Guidance::Kind::outer_node, "no radial displacement at the two outermost nodes");
  io("ring", g.kind, Guidance::Kind::ring, g.ring_stiffness, Quantity{unit::stiffness, {.least = 1.0}},
     "a radial spring of this stiffness at both nodes of each end element", Keys{[&g](const Fields& further) {
       further("clearance", g.clearance, Quantity{unit::length, not_negative, "10 um"},
               "Radial displacement of a node up to which its spring takes no force");
     }});
}

/// A word of `Travel::SlipRatio`, or a number from 0 to 1.
struct SlipRatioOrNumber {};
Value value_of(Travel& t, const SlipRatioOrNumber&) {
  return {OneOr{.form = OneOr::Form::number,
                .one = [&t] { return value_of(t.slip_ratio, Choice{}); },
                .several =
                    [&t] {
                      return value_of(t.stated_slip_ratio, Number{{.least = 0.0, .greatest = 1.0}, "0.375"});
                    },
                .others = ", or a number from 0 to 1",
                .spread = [&t] { t.stated_slip_ratio = Travel{}.stated_slip_ratio; },
                .are_several = !std::isnan(t.stated_slip_ratio)}};
}

/// Member that the word sets, of a block that may also be one word.
inline std::optional<Rings::Carrier>& selector_of(Rings& r, const WordOrBlock&) { return r.carrier; }

template <class Io, class C>
requires std::same_as<C, Rings::Carrier> || std::same_as<C, std::optional<Rings::Carrier>>
void alternatives(Io& io, C& c) {
  io("housing", c, C(Rings::Carrier::housing), "the rings stand still");
  io("nut", c, C(Rings::Carrier::nut), "the rings go with the nut");
  io("screw", c, C(Rings::Carrier::screw), "the rings go with the screw");
}

void alternatives(Choices& io, ModelOptions::Mechanism& m) {
  io("sector", m, ModelOptions::Mechanism::sector, "one roller with its share of both bodies");
  io("full", m, ModelOptions::Mechanism::full, "all rollers on a spatial screw and nut");
}

void alternatives(Choices& io, ModelOptions::ContactPhase& p) {
  io("equal", p, ModelOptions::ContactPhase::equal, "all rollers touch at the same places");
  io("helical", p, ModelOptions::ContactPhase::helical, "contacts follow the helix");
}

void alternatives(Choices& io, ModelOptions::Bodies& b) {
  for (const auto& row : kBodyModels) io(row.model.name, b, &row.model, row.model.help);
}

void alternatives(Choices& io, ModelOptions::Loads& l) {
  io("static", l, ModelOptions::Loads::at_rest, "those of a screw at rest");
  io("running", l, ModelOptions::Loads::running,
     "those of a screw that turns: each contact with the friction that slip finds for it");
}

void alternatives(Choices& io, ModelOptions::RollerContacts& r) {
  io("opposite", r, ModelOptions::RollerContacts::opposite,
     "at the same axial position, as on a helical roller with an odd number of starts");
  io("half_pitch_apart", r, ModelOptions::RollerContacts::half_pitch_apart,
     "on the two flanks of a ring-shaped tooth, or with an even number of starts");
}

void alternatives(Choices& io, ModelOptions::ToothCompliance& t) {
  using enum ModelOptions::ToothCompliance::Kind;
  io("none", t.kind, none, "nothing besides exact Hertz");
  io("yamamoto", t.kind, yamamoto, t.width, Quantity{unit::length, positive},
     "Yamamoto's deflection on top, a contact loading this width of thread; for comparison");
}

void alternatives(Choices& io, ModelOptions::Accuracy& a) {
  io("working", a, ModelOptions::Accuracy::working, "0.5 % in stiffness");
  io("reference", a, ModelOptions::Accuracy::reference, "0.1 % in stiffness");
}

void alternatives(Choices& io, ModelOptions::Roller& r) {
  io("flexible", r, ModelOptions::Roller::flexible, "the roller bends");
  io("rigid_bending", r, ModelOptions::Roller::rigid_bending, "the roller stays straight");
}

void alternatives(Choices& io, MeasureOptions::Ends& e) {
  using enum MeasureOptions::Ends;
  io("fixed_free", e, fixed_free, "one end clamped, the other free");
  io("supported_supported", e, supported_supported, "both ends can tilt");
  io("fixed_supported", e, fixed_supported, "one end clamped, the other can tilt");
  io("fixed_fixed", e, fixed_fixed, "both ends clamped");
}

void alternatives(Choices& io, MeasureOptions::System::Axial& a) {
  using enum MeasureOptions::System::Axial;
  io("one_end", a, one_end, "one axial bearing, behind which the shaft is free");
  io("both_ends", a, both_ends, "an axial bearing at each end of `length`");
}

void alternatives(Choices& io, LifeTemperatures& t) {
  io("heat", t, LifeTemperatures::heat, "the steady ones of the spectrum's mean heat");
  io("reference", t, LifeTemperatures::reference, "that at which the nominal geometry holds");
}

void alternatives(Choices& io, Direction& d) {
  io("tension", d, Direction::tension, "the load pulls the screw out of the mechanism");
  io("compression", d, Direction::compression, "the load pushes the screw in");
}

void alternatives(Choices& io, ExtraMass::Carrier& c) {
  io("screw", c, ExtraMass::Carrier::screw, "the mass goes with the screw");
  io("nut", c, ExtraMass::Carrier::nut, "the mass goes with the nut");
}

void alternatives(Choices& io, Travel::Part& p) {
  io("screw", p, Travel::Part::screw, "the screw turns, the nut does not");
  io("nut", p, Travel::Part::nut, "the nut turns, the screw does not");
}

void alternatives(Choices& io, Travel::SlipRatio& s) {
  io("rolling", s, Travel::SlipRatio::rolling, "pitch cylinders roll: d_S/(d_S + d_N)");
  io("ideal", s, Travel::SlipRatio::ideal, "for which the sliding interface slides least");
  io("solved", s, Travel::SlipRatio::solved, "that of `prs slip`, with what it needs");
}

void alternatives(Choices& io, AxialSupport& a) {
  using enum AxialSupport::At;
  io("nut", a.at, nut, "the seat of the nut, as at rest");
  io("screw", a.at, screw, "the loaded section of the screw, rigidly; the nut is free along x");
  io("screw", a.at, screw_spring, a.stiffness, Quantity{unit::stiffness, positive}, "the same by a spring");
}

void alternatives(Choices& io, DrivenBy& d) {
  io("screw", d, DrivenBy::screw, "the screw moves its load");
  io("load", d, DrivenBy::load, "the load moves the screw");
}

void alternatives(Choices& io, HistorySource::DrivenBy& d) {
  io("travel", d, HistorySource::DrivenBy::travel,
     "by position or speed: the load drives where F dx > 0, x growing as the screw moves out");
  io("screw", d, HistorySource::DrivenBy::screw, "the screw always");
  io("load", d, HistorySource::DrivenBy::load, "the load always");
}

void alternatives(Choices& io, LoadCase::Share& s) {
  io("solved", s, LoadCase::Share::solved, "the structure decides on the thread loads");
  io("equal", s, LoadCase::Share::equal, "every thread carries the same load");
}

void alternatives(Choices& io, Preload::Arrangement& a) {
  io("single_nut", a, Preload::Arrangement::single_nut,
     "rollers wedged in the grooves of screw and nut on both flanks");
  io("double_nut", a, Preload::Arrangement::double_nut,
     "two nuts on one screw, each with its rollers, pushed apart by a spacer");
}

/// Calls take(parameter, kind) with each parameter of a law of friction and how it is written.
template <class Law, class Take>
void for_each_parameter(const Law&, Take take) {
  for (const contact::LawParameter<Law>& p : Law::parameters) {
    const Bounds bounds = p.may_be_zero ? not_negative : positive;
    if (p.unit.empty()) {
      take(p, OneOrEach{Number{bounds, p.example}});
      continue;
    }
    for (const Dimension* d : dimensions())
      if (find_unit(p.unit, *d)) return take(p, OneOrEach{Quantity{*d, bounds, p.example}});
  }
}

template <template <class> class Law>
void fields(const Fields& io, Law<PerInterface<double>>& law) {
  for_each_parameter(law, [&](const auto& p, const auto& kind) {
    io(p.key, law.*p.member, kind, p.required ? required : optional, p.meaning);
  });
}

void alternatives(Choices& io, Friction& f) {
  f.for_each([&]<class Law>(contact::FrictionKind kind, const Law&) {
    Law& law = f;
    const contact::LawFacts& facts = Law::facts;
    bool in_place = Law::parameters.empty();
    if (in_place) io(facts.name, f.kind, kind, facts.meaning);
    for_each_parameter(law, [&](const auto& p, const auto& how) {
      if (p.key.empty()) in_place = true, io(facts.name, f.kind, kind, law.*p.member, how, facts.meaning);
    });
    if (!in_place) io(facts.name, f.kind, kind, law, Block{}, facts.meaning);
  });
}

void alternatives(Choices& io, contact::FilmDirection& d) {
  io("minor_axis", d, contact::FilmDirection::minor_axis,
     "as if rolling along the minor axis of the ellipse (Nijenbanning, Venner, Moes 1994)");
  io("rolling", d, contact::FilmDirection::rolling,
     "along the rolling, at its angle to the ellipse (Chittenden, Dowson, Dunn, Taylor 1985)");
}

void alternatives(Choices& io, LubricantName& n) {
  const std::span<const NamedLubricant> known = named_lubricants();
  for (const auto i : indices(known)) io(known[i].name, n, LubricantName{i}, known[i].what);
}

void alternatives(Choices& io, BackDriving& b) {
  io("allowed", b, BackDriving::allowed, "no criterion");
  io("required", b, BackDriving::required, "the load must turn the screw");
  io("forbidden", b, BackDriving::forbidden, "the screw must lock itself");
}

void alternatives(Choices& io, Heat::Losses& l) {
  io("warm", l, Heat::Losses::warm, "those that the losses lead to");
  io("stated", l, Heat::Losses::stated,
     "those that the case states: the losses lead to others, over `duty` to their mean, which nothing follows");
}

void alternatives(Choices& io, WrittenRange::Spacing& s) {
  io("linear", s, WrittenRange::Spacing::linear, "the values");
  io("logarithmic", s, WrittenRange::Spacing::logarithmic, "their logarithms");
}

/// Commands that a study can run.
void alternatives(Choices& io, Command& c) {
  io(name(Command::contact), c, Command::contact, "contact points and Hertz constants");
  io(name(Command::solve), c, Command::solve, "load distribution, pressures and stiffness");
  io(name(Command::slip), c, Command::slip, "slip, power loss and efficiency");
  io(name(Command::life), c, Command::life, "life under a load history or spectrum");
  io(name(Command::measures), c, Command::measures, "capacity, weight, stiffness and the other design measures");
  io(name(Command::response), c, Command::response, "the screw in its drive over time and over frequency");
}

void alternatives(Choices& io, Plan& p) {
  io("one_at_a_time", p, Plan::one_at_a_time, "each value of each factor alone, all others as in the file");
  io("grid", p, Plan::grid, "every combination of the values, the last factor fastest");
  io("latin_hypercube", p, Plan::latin_hypercube,
     "each factor's range in as many strata as samples, one sample in each");
  io("sobol", p, Plan::sobol, "Sobol's sequence, which fills the space evenly");
  io("monte_carlo", p, Plan::monte_carlo, "independent draws");
  io("sobol_indices", p, Plan::sobol_indices,
     "Saltelli's design for the shares of the factors in the variance: as many designs a "
     "sample as factors, and two");
  io("tolerances", p, Plan::tolerances,
     "independent draws, and the same with the deviation of each factor from the file halved");
  io("derivatives", p, Plan::derivatives, "the file as it stands, with the derivatives by every factor");
}

void alternatives(Choices& io, Envelope::Combine& c) {
  io("product", c, Envelope::Combine::product, "multiplied, weights as exponents");
  io("sum", c, Envelope::Combine::sum, "added, weights as factors");
}

void alternatives(Choices& io, Envelope::Normalise& n) {
  io("rms", n, Envelope::Normalise::rms, "the root mean square of its map");
  io("max", n, Envelope::Normalise::max, "the largest magnitude of its map");
  io("none", n, Envelope::Normalise::none, "nothing");
}

void alternatives(Choices& io, EnvelopePointItem::Wanted& w) {
  io("best", w, EnvelopePointItem::Wanted::best, "where the envelope is largest");
}

// Blocks: io(KEY, member, kind, presence, meaning)

void fields(const Fields& io, Mechanism::Starts& s) {
  io("screw", s.screw, Whole{1, 100}, required, "Thread starts of the screw and of the nut");
  io("roller", s.roller, Whole{0, 100}, "Thread starts of a roller; 0, grooves, of a recirculating screw");
}

void fields(const Fields& io, ThreadHeight& t) {
  const Quantity height{unit::length, not_negative};
  io("addendum", t.addendum, height, required, "Height of the crest above the pitch radius");
  io("dedendum", t.dedendum, height, required, "Depth of the root below the pitch radius");
  io("thickness", t.thickness, Quantity{unit::length, positive},
     "Axial thickness of the thread at the pitch radius, half a pitch by default");
}

void fields(const Fields& io, Mechanism& m) {
  const Quantity diameter{unit::length, positive};
  const Quantity flank_angle{unit::angle, Bounds{std::numbers::pi / 180, 89 * std::numbers::pi / 180}};

  io("type", m.type, required, "Kind of mechanism");
  io("geometry", m.geometry, "What is given of the geometry");
  io("profile_plane", m.profile_plane, "Plane in which flank angle and profile radius are measured");

  const bool simulation = m.geometry == Mechanism::Geometry::simulation, grooved = contact::is_grooved(m.type);
  if (grooved) m.starts.roller = 0;
  const Presence in_simulation = required_only_if(simulation, "only with `geometry: simulation`");
  const Presence in_design = optional_only_if(!simulation, "only with `geometry: design`");

  io("lead", m.lead, Quantity{unit::length, not_zero}, required, "Lead of screw and nut; > 0 right-handed");
  io("starts", m.starts, required, "Numbers of thread starts");
  io("pitch", m.pitch, Each{diameter, optional}, "Measured axial pitch of parts where it differs from lead / starts");
  io("flank_angle", m.flank_angle, OneOrEach{flank_angle}, required, "Flank angle, from the plane normal to the axis");
  io("pitch_diameter", m.pitch_diameter, Keys{[&](const Fields& part) {
       part("screw", m.pitch_diameter.screw, diameter, required, "Of the screw");
       part("roller", m.pitch_diameter.roller, diameter,
            required_only_if(simulation || grooved, "only with `geometry: simulation` or `type: recirculating`"),
            "Of a roller");
       part("nut", m.pitch_diameter.nut, diameter, in_simulation, "Of the nut");
     }},
     required, "Pitch diameters");
  io("centre_distance", m.centre_distance, diameter, in_simulation, "Distance of the roller axes from the screw axis");
  io("backlash", m.backlash, Each{kSmallLength, optional}, in_design, "Axial play at each interface");
  io("profile", m.profile, Each{Choice{}, required}, required, "Thread profile of the material");
  io("thread", m.thread, Each{Block{}, optional},
     "Radial extent of truncated threads; the nut's addendum points inwards");
  io("rollers", m.rollers, Whole{1, 1000}, required, "Number of rollers");
  io("rollers_unloaded", m.rollers_unloaded, Whole{0, 999},
     optional_only_if(grooved, "only with `type: recirculating`"),
     "Of these, rollers in the recess, which carry nothing; 1 by default");
  io("contacts_per_roller", m.contacts_per_roller, Whole{1, 10'000}, required,
     "Threads of a roller in contact, at each interface");
}

/// Keys of a displacement or a force across the axis, or of a rotation about axes across it.
template <class Kind>
auto lateral(Lateral& value, const Kind& kind) {
  return Keys{[&value, kind](const Fields& io) {
    io("y", value.y, kind, "Component y");
    io("z", value.z, kind, "Component z");
  }};
}

void fields(const Fields& io, Bearing& b) {
  io("position", b.position, Quantity{unit::length}, required, "Axial position, counted as positions on the nut");
  io("lateral", b.lateral, Held{unit::stiffness, true}, "Against displacement");
  io("tilt", b.tilt, Held{unit::tilt_stiffness, true}, "Against rotation");
  io("offset", b.offset, lateral(b.offset, kSmallLength), "Displacement of its seat");
  io("angle", b.angle, lateral(b.angle, Quantity{unit::angle}), "Rotation of its seat");
}

void fields(const Fields& io, Rings& r) {
  io("carried_by", r.carrier,
     "What they are fixed to; nut of a standard mechanism, screw of an inverted one by "
     "default");
  io("stiffness", r.stiffness, Held{unit::stiffness}, "Of a ring against it");
}

void fields(const Fields& io, Housing& h) {
  io("axial", h.axial, Held{unit::stiffness}, "Along the axis");
  io("lateral", h.lateral, Held{unit::stiffness}, "Across the axis");
  io("tilt", h.tilt, Held{unit::tilt_stiffness}, "Against rotation");
}

/// Components along the axis and across it.
template <class Kind>
auto spatial(Spatial& value, const Kind& kind) {
  return Keys{[&value, kind](const Fields& io) {
    io("x", value.x, kind, "Component x");
    io("y", value.y, kind, "Component y");
    io("z", value.z, kind, "Component z");
  }};
}

void fields(const Fields& io, Drive& d) {
  io("position", d.position, Quantity{unit::length}, required, "Axial position, counted as positions on the nut");
  io("inertia", d.inertia, Quantity{unit::inertia, not_negative}, "Of what turns with the screw");
  io("stiffness", d.stiffness, Held{unit::tilt_stiffness}, "Against turning of the screw there");
}

void fields(const Fields& io, ExtraMass& m) {
  io("name", m.name, Text{"table"}, "Its name");
  io("carried_by", m.carrier, required, "What it goes with");
  io("position", m.position, Quantity{unit::length}, required,
     "Section that it is fixed to, counted as positions on the nut");
  io("mass", m.mass, Quantity{unit::mass, not_negative}, "Mass");
  io("centre", m.centre, spatial(m.centre, Quantity{unit::length}), "Of mass, from the axis at that section");
  io("inertia", m.inertia, spatial(m.inertia, Quantity{unit::inertia, not_negative}), "About the centre of mass");
}

void fields(const Fields& io, Structure::Screw& s) {
  const Quantity length{unit::length, not_negative};
  io("bore", s.bore, length, "Diameter of the bore");
  io("free_length", s.free_length, length, "From the loaded section to the first contact");
  io("far_length", s.far_length, length, "Behind the last contact; `mechanism: full`");
  io("bearings", s.bearings, "What holds the screw across the axis; `mechanism: full`");
  io("drive", s.drive, "What turns the screw, for modes; `mechanism: full`");
}

void fields(const Fields& io, Structure::Roller& r) {
  const Quantity length{unit::length, positive};
  io("end_length", r.end_length, length, required, "Length of each plain end");
  io("end_diameter", r.end_diameter, length, required, "Diameter of the plain ends");
  io("guidance", r.guidance, "What holds the roller ends radially");
  io("rings", r.rings, WordOrBlock{"carried_by"}, "The guide rings; `mechanism: full`");
}

void fields(const Fields& io, Structure::Flange& f) {
  const Quantity position{unit::length};
  io("from", f.from, position, required, "Axial position of its near face");
  io("to", f.to, position, required, "Axial position of its far face");
  io("outer_diameter", f.outer_diameter, Quantity{unit::length, positive}, required,
     "Replaces the nut's outer diameter there");
}

void fields(const Fields& io, Structure::Thrust& t) {
  const Quantity position{unit::length};
  io("tension", t.tension, position, "Where tension is held");
  io("compression", t.compression, position, "Where compression is held");
}

void fields(const Fields& io, Structure::Shoulder& s) {
  const Quantity diameter{unit::length, positive};
  io("inner_diameter", s.inner_diameter, diameter, required, "Inside");
  io("outer_diameter", s.outer_diameter, diameter, required, "Outside");
}

void fields(const Fields& io, Structure::Nut& n) {
  const Quantity length{unit::length, positive};
  io("length", n.length, length, required, "Axial length");
  io("outer_diameter", n.outer_diameter, length, required, "Outer diameter between flanges");
  io("flanges", n.flanges, "Flanges; they may touch, not overlap");
  io("thrust", n.thrust, "Axial position of the constrained section, for each direction of the load");
  io("shoulder", n.shoulder, "Ring of the thrust face that the housing touches; `refined` and `influence`");
  io("housing", n.housing, "What holds the thrust section; `mechanism: full`");
}

void fields(const Fields& io, Structure& s) {
  io("screw", s.screw, "Dimensions of the screw other than its thread");
  io("roller", s.roller, required, "Dimensions of a roller other than its thread");
  io("nut", s.nut, required, "The nut; axial positions count from its end that faces the loaded end of the screw");
  io("masses", s.masses, "Rigid masses on screw and nut, for modes; `mechanism: full`");
}

void fields(const Fields& io, Material& m) {
  // Moduli from rubber to bodies that are as good as rigid; others have a wrong unit.
  io("youngs_modulus", m.youngs_modulus, Quantity{unit::pressure, {.least = 1e6, .greatest = 1e18}}, required,
     "Young's modulus");
  io("poisson_ratio", m.poisson_ratio, Number{{.least = 0.0, .greatest = 0.5, .greatest_excluded = true}}, required,
     "Poisson's ratio");
  io("density", m.density, Quantity{unit::density, positive}, "Density");
  io("thermal_expansion", m.thermal_expansion, Quantity{unit::thermal_expansion, not_negative},
     "Coefficient of linear thermal expansion");
  io("conductivity", m.conductivity, Quantity{unit::thermal_conductivity, positive, "45 W/(m K)"},
     "Of heat, for flash temperatures");
  io("specific_heat", m.specific_heat, Quantity{unit::specific_heat, positive}, "For flash temperatures");
  io("static_pressure_limit", m.static_pressure_limit, Quantity{unit::pressure, positive, "1.5 GPa"},
     "Peak pressure that a contact may have at rest; of steel 4 GPa (ISO 76), of others none is known");
}

void fields(const Fields& io, PitchWave& w) {
  io("amplitude", w.amplitude, kSmallLength, required, "Largest error");
  io("period", w.period, Number{positive, "7"}, required, "Threads in one period");
  io("phase", w.phase, Quantity{unit::angle}, "At the first contact");
}

void fields(const Fields& io, PitchError& e) {
  io("linear", e.linear, kSmallLength, "Growing from 0 at the first contact to this at the last");
  io("periodic", e.periodic, "A sine over the threads");
  OneOrMany list{e.list, e.lists};
  io("list", list, ForEachRoller{List{kSmallLength}}, "One value a contact");
}

void fields(const Fields& io, EndRelief& r) {
  io("drop", r.drop, Quantity{unit::length, not_negative, "20 um"}, required,
     "Drop of the roller's pitch radius at the outermost contacts");
  io("threads", r.threads, Whole{1, 10'000}, required, "Contacts at each end over which it fades to nothing");
}

template <class Kind>
auto around(TurningError& e, const Kind& kind) {
  return [&e, kind](const Fields& io) {
    io("amount", e.amount, kind, "How much");
    io("angle", e.angle, Quantity{unit::angle}, "Azimuth on the part, from y to z");
  };
}

void fields(const Fields& io, LeadHarmonic& h) {
  io("order", h.order, Whole{1, 1000}, required, "Periods in a turn");
  io("amplitude", h.amplitude, kSmallLength, "Of the sine");
  io("phase", h.phase, Quantity{unit::angle}, "Of the sine");
}

void fields(const Fields& io, LeadWave& w) {
  io("length", w.length, Quantity{unit::length, positive, "40 mm"}, required, "Of a period");
  io("amplitude", w.amplitude, kSmallLength, "Of the sine");
  io("phase", w.phase, Quantity{unit::angle}, "Of the sine");
}

void fields(const Fields& io, MeasuredLead& m) {
  const List places{Quantity{unit::length}, 2}, deviations{kSmallLength, 2};
  io("at", m.at, places, required, "Places along the part, rising; 0 at the first contact");
  io("deviation", m.deviation, deviations, required, "One at each place, straight between");
}

void fields(const Fields& io, TurningThread& t) {
  io("eccentricity", t.eccentricity, Keys{around(t.eccentricity, kSmallLength)},
     "Of the thread's axis against journals or seat");
  io("wobble", t, Keys{[&](const Fields& keys) {
       around(t.wobble, Quantity{unit::angle})(keys);
       keys("at", t.wobble_at, Quantity{unit::length},
            "Place along the part that it leaves where it is, the middle of the contacts by "
            "default");
     }},
     "Tilt of the thread's axis");
  io("lead", t, Keys{[&](const Fields& keys) {
       keys("per_300_mm", t.per_300_mm, kSmallLength, "Proportional to length, > 0 threads too far apart");
       keys("harmonics", t.harmonics, "Over a turn, each turn alike");
       keys("waves", t.waves, "Along the part");
       keys("measured", t.measured, "As measured along the part");
     }},
     "Lead deviation of the thread");
}

template <class Kind>
void for_each_roller(const Fields& io, std::string_view key, RollerValue& value, const Kind& kind,
                     std::string_view meaning) {
  OneOrMany both{value.one, value.many};
  io(key, both, ForEachRoller{kind}, meaning);
}

template <class Kind>
auto around(TurningRollers::Error& e, const Kind& kind) {
  return Keys{[&e, kind](const Fields& io) {
    for_each_roller(io, "amount", e.amount, kind, "How much");
    for_each_roller(io, "angle", e.angle, Quantity{unit::angle}, "From the roller's mark");
  }};
}

void fields(const Fields& io, TurningRollers::Harmonic& h) {
  io("order", h.order, Whole{1, 1000}, required, "Periods in a turn");
  for_each_roller(io, "amplitude", h.amplitude, kSmallLength, "Of the sine");
  for_each_roller(io, "phase", h.phase, Quantity{unit::angle}, "Of the sine");
}

void fields(const Fields& io, Turning& t) {
  io("screw", t.thread.screw, "Of the screw");
  io("nut", t.thread.nut, "Of the nut");
  io("roller", t.rollers, Keys{[&](const Fields& keys) {
       keys("eccentricity", t.rollers.eccentricity, around(t.rollers.eccentricity, kSmallLength),
            "Of the thread's axis against the heads");
       keys("wobble", t.rollers.wobble, around(t.rollers.wobble, Quantity{unit::angle}),
            "Tilt of the thread's axis about the roller's middle");
       keys("lead", t.rollers,
            Keys{[&](const Fields& lead) { lead("harmonics", t.rollers.harmonics, "Over a turn, each alike"); }},
            "Lead deviation of the thread");
     }},
     "Of the rollers");
}

void fields(const Fields& io, Deviations& d) {
  const Quantity temperature{unit::temperature, {.least = 0.0, .greatest = kHottest, .least_excluded = true}};
  io("pitch_error", d.pitch_error, Each{Block{}, optional},
     "Axial position error of the threads, > 0 away from the loaded end of the screw");
  OneOrMany diameter{d.roller_diameter, d.roller_diameters};
  io("roller_diameter", diameter, ForEachRoller{kSmallLength}, "Pitch diameter of the rollers above the nominal one");
  io("crowning", d.crowning, Quantity{unit::length, not_negative, "10 um"},
     "Parabolic drop of the roller's pitch radius at first and last contact");
  io("end_relief", d.end_relief, "Straight taper at both ends");
  io("temperature", d.temperature, OneOrEach{temperature}, "Of the parts, uniform in each");
  io("reference_temperature", d.reference_temperature, temperature, "At which the nominal geometry holds");
  const List offsets{kSmallLength};
  io("roller_position", d.roller_position, OneOrEnds{offsets},
     "Of each roller in its rings, > 0 outwards; `mechanism: full`");
  io("missing_rollers", d.missing_rollers, List{Whole{1, 1000}}, "Their numbers; `mechanism: full`");
  io("index_error", d.index_error, Each{offsets, optional}, "Axial position error of each start; `mechanism: full`");
  io("thread_eccentricity", d.thread_eccentricity, Keys{[&](const Fields& side) {
       side("screw", d.thread_eccentricity.screw, lateral(d.thread_eccentricity.screw, kSmallLength), "Of the screw");
       side("nut", d.thread_eccentricity.nut, lateral(d.thread_eccentricity.nut, kSmallLength), "Of the nut");
     }},
     "Of the thread against the axis of its body; `mechanism: full`");
  io("turning", d.turning, "Errors that turn with their part; `mechanism: full`");
}

void fields(const Fields& io, ContactOverrides& c) {
  const Quantity hertz_constant{unit::hertz_constant, positive};
  const Quantity normal_angle{unit::angle, between(0.0, std::numbers::pi / 2)};
  io("hertz_constant", c.hertz_constant, Each{hertz_constant, optional}, "Load over approach^1.5");
  io("normal_angle", c.normal_angle, Each{normal_angle, optional}, "Angle between contact normal and axis");
}

void fields(const Fields& io, RefinedEffects& e) {
  io("core", e.core, "Sections at the thread's root");
  io("shear", e.shear, "Shear in the roller's bending");
  io("hoop", e.hoop, "Radial expansion of the nut, as a shell");
  io("poisson", e.poisson, "Poisson's effect in screw and nut");
  io("flange", e.flange, "Bending of the nut at flanges and shoulder");
  io("radial", e.radial, "Radial compliance at a thread");
  io("concentration", e.concentration, "Contacts as rows of points, not rings");
}

void fields(const Fields& io, ModelOptions& m) {
  io("mechanism", m.mechanism, "How much of the mechanism is modelled");
  io("contact_phase", m.contact_phase, "Where the rollers touch along the axis; `mechanism: full`");
  io("shear", m.shear, "Shear flexibility of screw, nut and rollers; `mechanism: full`");
  io("loads", m.loads,
     "Of `solve`, slip, heat and life; static for `solve`, running for the others by default, "
     "where shares are solved");
  io("bodies", m.bodies, "How screw, roller and nut deform");
  io("refined", m.refined, "Effects of `bodies: refined`, all by default");
  io("accuracy", m.accuracy, "Meshes of `bodies: influence`");
  io("roller_contacts", m.roller_contacts, "Where screw and nut touch a roller tooth; `refined` and `influence`");
  io("tooth_compliance", m.tooth_compliance, "Tooth deflection on top of Hertz, which counts it twice");
  io("roller", m.roller, "Whether the roller bends");
  io("roller_shear", m.roller_shear, "Shear flexibility of the roller");
  io("patch_points", m.patch_points,
     Whole{kFewestPatchPoints, 1001, "as fewer points carry up to 91 % more than the load, and friction with it"},
     "Points along each axis of a contact patch; fewer than 9 miss its load");
}

void fields(const Fields& io, Travel& t) {
  io("turns", t.turns, Whole{-100'000, 100'000}, "Of the screw against the nut; < 0 back");
  io("steps", t.steps, Whole{4, 100'000}, "Positions in a turn");
  io("from", t.from, Quantity{unit::angle}, "Turn of the screw against the nut at the start");
  io("turning_part", t.part, "Which part turns");
  io("slip_ratio", t, SlipRatioOrNumber{}, "Turn of the carrier against the nut over the screw's");
}

void fields(const Fields& io, Modes& m) {
  io("count", m.count, Whole{1, 100'000}, "Number of modes, from the lowest");
  io("axial_support", m.axial_support, "What holds the mechanism along its axis");
  io("prestress", m.prestress, "Axial forces that stiffen or soften bending");
  io("positions", m.positions, Whole{1, 100'000}, "Of the travel at which frequencies are found too; needs `travel`");
}

void fields(const Fields& io, LoadCaseItem& l) {
  io("name", l.name, Text{}, "Name of the case, `case-1` for the first by default; a range makes NAME[0], NAME[1], ..");
  io("axial_force", l.axial_force, OneOrRange{Quantity{unit::force}}, required,
     "Axial load; > 0 with a direction, of either sign without");
  io("share", l.share, "How the load spreads over the threads");

  const Presence where = required_unless(l.share == LoadCase::Share::equal, "required unless `share: equal`");
  io("direction", l.direction, where, "Sense of the load on the screw");
  io("position", l.position, Quantity{unit::length}, where, "Axial position of the first roller contact on the nut");
  io("speed", l.speed, Quantity{unit::rotational_speed}, "In place of operation.speed");

  SpatialLoad& s = l.spatial;
  const Quantity length{unit::length}, angle{unit::angle};
  io("carrier_angle", s.carrier_angle, angle, "Azimuth of the first roller, from y to z; `mechanism: full`");
  io("eccentricity", s.eccentricity, lateral(s.eccentricity, length), "Where the axial force acts; `mechanism: full`");
  const auto across = [](SpatialLoad::Across& load, const Quantity& kind) {
    return Keys{[&load, kind](const Fields& keys) {
      keys("y", load.value.y, kind, "Component y");
      keys("z", load.value.z, kind, "Component z");
      keys("at", load.at, Quantity{unit::length}, "Axial position on the screw, the loaded section by default");
    }};
  };
  io("side_force", s.side_force, across(s.side_force, Quantity{unit::force}), "On the screw; `mechanism: full`");
  io("moment", s.moment, across(s.moment, Quantity{unit::torque}), "On the screw; `mechanism: full`");
  io("misalignment", s, Keys{[&](const Fields& seat) {
       seat("nut_tilt", s.nut_tilt, lateral(s.nut_tilt, angle), "Rotation");
       seat("nut_offset", s.nut_offset, lateral(s.nut_offset, length), "Displacement");
     }},
     "Of the seat of the nut; `mechanism: full`");
  io("orbit", s.orbit,
     "A turn of the carrier: rollers and rings turn with their errors, errors of screw and nut "
     "stand still; `mechanism: full`");
  io("travel", l.travel, "Positions of the turning mechanism, whose parts carry their errors along; `mechanism: full`");
  io("modes", l.modes, "Natural frequencies under the load; `mechanism: full`");
}

void fields(const Fields& io, SpatialLoad::Orbit& o) {
  io("steps", o.steps, Whole{1, 1000}, "Positions for each spacing of the rollers");
  io("exponent", o.exponent, Number{{.least = 1.0, .greatest = 20.0}, "3"}, "Of the equivalent loads");
}

void fields(const Fields& io, Spacer& s) {
  const Quantity length{unit::length, positive};
  io("length", s.length, length, required, "Between the nuts");
  io("inner_diameter", s.inner_diameter, length, required, "Inside");
  io("outer_diameter", s.outer_diameter, length, required, "Outside");
}

void fields(const Fields& io, LoadSweep& l) {
  const Quantity force{unit::force};
  io("from", l.from, force, required, "First load; > 0 in tension");
  io("to", l.to, force, required, "Last load");
  io("steps", l.steps, Whole{2, 10'000}, "Number of loads, ends included");
}

void fields(const Fields& io, Preload& p) {
  const Quantity length{unit::length, positive};
  io("arrangement", p.arrangement, required, "What pushes against what");

  const Presence in_two_nuts =
      required_only_if(p.arrangement == Preload::Arrangement::double_nut, "only with `arrangement: double_nut`");
  io("force", p.force, Quantity{unit::force, positive}, "Axial load of each side without external load");
  io("interference", p.interference, length, optional_only_if(!p.force, "in place of `force`"),
     "Single nut: pitch diameter of the rollers above the one that just fills the grooves; "
     "double nut: length of the spacer above the one that just touches");
  io("backlash", p.backlash, Quantity{unit::length, not_negative, "20 um"},
     required_only_if(!p.force && !p.interference, "in place of `force` or `interference`"),
     "Axial play instead of preload");
  io("position", p.position, Quantity{unit::length}, required,
     "Axial position of the first roller contact on the first nut");
  io("spacer", p.spacer, in_two_nuts, "Ring between the nuts, of their material");
  io("distance", p.distance, length, in_two_nuts,
     "From the last contact of the first nut to the first one of the second");
  io("load", p.load, required, "External axial loads of the curve");
  io("load_case", p.load_case, Text{"pull"},
     "With `heat`: the load case whose steady temperatures the parts have; the first by default");
  io("lost_motion_load", p.lost_motion_load, Quantity{unit::force, positive},
     "The lost motion is the travel between this load in tension and in compression; 5 % of "
     "the largest load of the curve by default");
}

void fields(const Fields& io, CsvColumn& c) {
  io("column", c.column, Text{"force_kN"}, required, "Its name in the heading of the file");
  io("unit", c.unit, Text{"kN"}, required, "Of its numbers");
}

void fields(const Fields& io, HistorySource& h) {
  io("file", h.file, Text{"forces.csv"}, required,
     "Comma-separated values with a heading, one row per sample; relative to this file");
  io("sha256", h.sha256, Text{}, "Of the file, which then may stand anywhere; another is refused");
  io("force", h.force, required, "Axial force, > 0 in tension");
  io("position", h.position, "Axial position of the nut on the screw; it grows where tension drives");
  io("speed", h.speed, optional_only_if(!h.position, "in place of `position`"),
     "Of the screw against the nut, with the sign of `operation.speed`: > 0 where `position` falls (left-handed: "
     "grows); else `operation.speed`");
  io("time", h.time, "Time of the sample");
  io("interval", h.interval, Quantity{unit::duration, positive}, optional_only_if(!h.time, "in place of `time`"),
     "Between two samples");
  io("driven_by", h.driven_by,
     "Who drives, for running loads: travel by default where position or speed stand, else screw");
  io("hysteresis", h.hysteresis, Quantity{unit::force, not_negative}, "Ranges up to this are no load cycles");
  io("bins", h.bins, Whole{1, 200}, "Of the matrix of cycles, along each axis");
}

void fields(const Fields& io, SpectrumLoad& l) {
  io("force", l.force, Quantity{unit::force, not_negative}, required, "Axial load; 0 N under preload alone");
  io("direction", l.direction, required, "Sense of the load on the screw");
  constexpr std::string_view one = "as one of revolutions, distance, duration and share";
  const Bounds revolutions{.least = 0.0, .greatest = 1e15, .least_excluded = true};
  io("revolutions", l.revolutions, Number{revolutions, "1000"}, "Of the screw against the nut under the load");
  io("distance", l.distance, Quantity{unit::length, not_negative}, optional_only_if(!l.revolutions, one),
     "Travel under the load; 0 at rest");
  io("duration", l.duration, Quantity{unit::duration, positive}, optional_only_if(!l.revolutions && !l.distance, one),
     "Under the load, at `operation.speed`");
  const bool measured = l.revolutions || l.distance || l.duration;
  io("share", l.share, Number{{.least = 0.0, .greatest = 1.0, .least_excluded = true}},
     required_only_if(!measured, one), "Of the revolutions of the spectrum");
  io("driven_by", l.driven_by, "Who drives, for running loads");
}

void fields(const Fields& io, Life& l) {
  io("history", l.history, "Loads over time or travel, from a file");
  io("spectrum", l.spectrum, List{Block{}, l.history ? 0 : 1}, required_only_if(!l.history, "in place of `history`"),
     "Loads and how long each acts");
  io("share", l.share, "How the load spreads over the threads");
  io("temperatures", l.temperatures, "Of the parts, with a block `heat`");
  io("position", l.position, Quantity{unit::length},
     required_unless(l.share == LoadCase::Share::equal, "required unless `share: equal`"),
     "Axial position of the first roller contact on the nut");
  const bool counted = !l.history && std::ranges::all_of(l.spectrum, [](const SpectrumLoad& load) {
    return load.revolutions || load.distance;
  });
  constexpr std::string_view of_counted = "with a spectrum of revolutions or distances";
  io("period", l.period, Quantity{unit::duration, positive, "12 s"}, optional_only_if(counted, of_counted),
     "Clock time of one pass of the spectrum, rests and travel without load included: for hours");
  io("travel", l.travel, Quantity{unit::length, positive, "400 mm"}, optional_only_if(counted, of_counted),
     "Travel of one pass in both senses, travel without load included: for kilometres");
  io("stroke", l.stroke, Quantity{unit::length, positive, "150 mm"},
     "Way between the extreme positions under load: catalogues require 1.5 lengths of the nut");
  const Quantity capacity{unit::force, positive};
  io("dynamic_capacity", l.dynamic_capacity, capacity, "Of a catalogue, in place of Lemor's formula");
  io("static_capacity", l.static_capacity, capacity, "Catalogue value, in addition to that by pressure");
  io("reliability", l.reliability, Quantity{unit::share, Bounds{.least = 0.90, .greatest = 0.99}},
     "Share of many screws that shall reach the rated life: a1 of ISO 281");
  io("modification_factor", l.modification_factor,
     Number{{.least = 0.0, .greatest = 50.0, .least_excluded = true}, "1.2"},
     "a_ISO of ISO 281 (film, cleanliness, fatigue limit), by which the rated life is "
     "multiplied");
  io("contamination", l.contamination, Number{{.least = 0.0, .greatest = 1.0}, "0.5"},
     "e_C of ISO 281, 1 with extreme cleanliness, 0.5 normal, 0.1 heavy contamination: computes a_ISO from the film");
  io("load_case", l.load_case, Text{},
     "Name of the load case whose side loads, misalignment and orbit act together with all "
     "forces; `mechanism: full`");
  io("fatigue_slope", l.fatigue_slope, Number{{.least = 1.0, .greatest = 20.0}, "9"},
     "Slope of the S-N curve, for equivalent load ranges");
}

void fields(const Fields& io, MeasureOptions::Shaft& s) {
  io("length", s.length, Quantity{unit::length, positive, "1 m"}, required,
     "Greatest distance between the supports of the screw");
  io("ends", s.ends, required, "How the screw is held at both ends of it");
  io("stroke", s.stroke, Quantity{unit::length, positive, "200 mm"},
     "Way of the nut along the screw, for which the shaft must be long enough");
  io("largest_compression", s.largest_compression, Quantity{unit::force, positive, "20 kN"},
     "Compressive force that the buckling safety takes besides those of the loads, for forces of unknown sense");
}

void fields(const Fields& io, MeasureOptions::System::Shaft& s) {
  const Quantity length{unit::length, positive, "300 mm"};
  io("length", s.length, length, required,
     "From the loaded section of the screw to the axial bearing, or between two of them; that of "
     "`measures.shaft` is another one, for buckling and critical speed");
  io("axial", s.axial, "Where the shaft is held along its axis");
  const bool two_bearings = s.axial == MeasureOptions::System::Axial::both_ends;
  io("from_bearing", s.from_bearing, length, required_only_if(two_bearings, "only with `axial: both_ends`"),
     "From the nearer axial bearing to the loaded section");
  io("torsion_length", s.torsion_length, length,
     "From the loaded section to where the rotation is held; `length` by default");
}

void fields(const Fields& io, MeasureOptions::System& s) {
  const Quantity stiffness{unit::stiffness, positive, "600 N/um"};
  io("shaft", s.shaft,
     "Stretch and wind-up of the screw's shaft; not `measures.shaft`, whose length is that for "
     "buckling and critical speed");
  io("support_bearing", s.support_bearing, stiffness, "Of all bearings of the shaft together");
  io("housing", s.housing, stiffness, "Of what holds the nut");
}

void fields(const Fields& io, Bearings& b) {
  io("fixed", b.fixed, Block{"{dynamic_capacity: 50 kN}"}, required,
     "That holds the part that turns along its axis; ball bearings");
}

void fields(const Fields& io, Bearings::Fixed& b) {
  io("dynamic_capacity", b.dynamic_capacity, Quantity{unit::force, positive, "50 kN"}, "Axial, of a catalogue");
  io("static_capacity", b.static_capacity, Quantity{unit::force, positive, "90 kN"}, "Axial, of a catalogue");
  const Presence of_life = optional_only_if(b.dynamic_capacity.has_value(), "only with `dynamic_capacity`");
  io("preload", b.preload, Quantity{unit::force, not_negative, "5 kN"}, of_life, "Of the bearings against each other");
  io("stiffness", b.stiffness, Quantity{unit::stiffness, positive, "800 N/um"},
     "Axial, in place of `measures.system.support_bearing`");
  io("exponent", b.exponent, Number{{.least = 1.0, .greatest = 5.0}, "3"}, of_life, "Of the load in its life");
}

void fields(const Fields& io, MeasureOptions& m) {
  io("loaded_width", m.loaded_width, Quantity{unit::length, positive},
     "Of thread that one contact loads, for the compliance and the strength of its tooth");
  io("friction_coefficient", m.friction_coefficient, Number{{.least = 0.0, .greatest = 1.0}, "0.01"},
     "Of the whole mechanism, as catalogues state it, for the estimate of efficiency");
  io("yield_strength", m.yield_strength, Quantity{unit::pressure, positive, "900 MPa"},
     "Of the screw's shaft, for short columns");
  io("shaft", m.shaft, "Of the screw, for buckling and critical speed");
  io("system", m.system, "What is in series with the mechanism, for the stiffness of the axis");
}

void fields(const Fields& io, ViscosityPoint& p) {
  io("temperature", p.temperature, Quantity{unit::temperature, positive}, required, "Where the viscosity was measured");
  io("viscosity", p.viscosity, Quantity{unit::viscosity, positive}, "Dynamic viscosity");
  io("kinematic_viscosity", p.kinematic_viscosity, Quantity{unit::kinematic_viscosity, positive},
     required_only_if(!p.viscosity, "in place of `viscosity`"), "Kinematic viscosity");
}

void fields(const Fields& io, contact::WaltherLine& w) {
  io("intercept", w.intercept, Number{unbounded, "9.5"}, required, "At T = 1 K");
  io("slope", w.slope, Number{positive, "3.6"}, required, "Fall with log10(T/K)");
}

void fields(const Fields& io, Lubricant::Film::InletHeating& h) {
  io("conductivity", h.conductivity, Quantity{unit::thermal_conductivity, positive, "0.14 W/(m K)"}, required,
     "Of heat, of the oil");
  io("temperature_coefficient", h.temperature_coefficient, Quantity{unit::temperature_coefficient, positive},
     "-(d eta/dT)/eta of its viscosity; that of its own law by default, where it has one");
}

void fields(const Fields& io, Lubricant& l) {
  const Quantity stress{unit::pressure, positive, "5 MPa"};
  io("name", l.name, Listed{"prs list lubricants"},
     "Stands for the values of a known lubricant; keys next to it replace single ones");
  io("temperature", l.temperature, Quantity{unit::temperature, positive}, "In operation");

  const bool by_temperature = l.temperature.has_value();
  io("viscosity", l.viscosity, Quantity{unit::viscosity, positive},
     optional_only_if(!by_temperature, "in place of `temperature`"),
     "Dynamic viscosity at ambient pressure in operation");
  // With `heat` the temperature itself may be absent.
  io("walther", l.walther, optional_only_if(by_temperature || !l.viscosity, "only with `temperature`"),
     "log10 log10(nu/(mm^2/s) + 0.7) = intercept - slope log10(T/K), nu = viscosity/density");
  io("viscosity_at", l.viscosity_at, List{Block{}, 2, 2},
     Presence{by_temperature && !l.walther && !l.name, !l.viscosity && !l.walther,
              "with `temperature`, in place of `walther`"},
     "Two points through which the line goes");
  io("density", l.density, Quantity{unit::density, positive}, "Of the oil, between dynamic and kinematic viscosity");
  const Presence named = required_unless(l.name.has_value(), "required unless `name` is given");
  io("pressure_viscosity", l.pressure_viscosity, Quantity{unit::pressure_viscosity, positive}, named,
     "Pressure-viscosity coefficient; with `name` estimated from the viscosity");
  io("eyring_stress", l.eyring_stress, stress, named, "Eyring shear stress; with `name` 5 MPa by default");
  io("film", l.film, Keys{[&](const Fields& film) {
       film("direction", l.film.direction, "Direction of rolling that the central film takes");
       film("starvation", l.film.starvation, Number{{.least = 0.0, .greatest = 1.0, .least_excluded = true}, "0.7"},
            "Film over that of a full inlet, measured or chosen");
       film("inlet_heating", l.film.inlet_heating,
            "Film that the shear at the inlet warms and thins (Gupta et al. 1992)");
     }},
     "Central film of the contacts");
}

void fields(const Fields& io, Wear& w) {
  io("coefficient", w.coefficient, Quantity{unit::wear, positive}, required,
     "Volume that both flanks lose for each force and sliding path (Archard)");
}

void fields(const Fields& io, Operation& o) {
  io("speed", o.speed, Quantity{unit::rotational_speed}, required,
     "Screw against nut, or along the axis: n = v/|lead|; with the sign of the axial force "
     "(left-handed: the other) the screw drives, else the load");
  io("slip_ratio", o.slip_ratio, Number{{.least = 0.0, .greatest = 1.0}, "0.05"},
     "Imposed in place of that of the roller's equilibrium");
  io("largest_speed", o.largest_speed, Quantity{unit::rotational_speed, positive},
     "Largest speed of the motion, for critical speed and n d, where load cases have mean speeds");
}

void alternatives(Choices& io, HeadFriction& f) {
  io("hydrodynamic", f.model, HeadFriction::Model::hydrodynamic, "a full film, by short bearings");
  io("coulomb", f.model, HeadFriction::Model::coulomb, f.coefficient,
     Number{Bounds{.least = 0.0, .greatest = 1.0}, "0.1"}, "a constant coefficient, without oil");
  io("mixed", f.model, HeadFriction::Model::mixed, f.mixed, Block{},
     "a film through which head and hole touch, by film over roughness");
}

void fields(const Fields& io, HeadFriction::Mixed& m) {
  io("boundary", m.boundary, Number{Bounds{.least = 0.0, .greatest = 1.0}, "0.1"}, required,
     "Coefficient of friction where head and hole touch");
  io("roughness", m.roughness, Quantity{unit::length, positive, "0.5 um"}, required,
     "Composite rms roughness Rq of head and hole");
  io("exponent", m.exponent, Number{positive, "2"},
     "Of (1 + film over roughness)^-exponent, the share of the load where they touch");
}

void fields(const Fields& io, HeadBearing& b) {
  const Quantity length{unit::length, positive};
  io("friction", b.friction, "How a head rubs");
  const Presence of_film = required_unless(!b.has_film(), "required unless `friction: {coulomb: ..}`");
  io("length", b.length, length, of_film, "Axial length of one head's bearing");
  io("diameter", b.diameter, length, required, "Diameter of the roller's head");
  io("radial_clearance", b.radial_clearance, Quantity{unit::length, positive, "20 um"}, of_film,
     "Radius of the hole less that of the head");
}

void fields(const Fields& io, Carrier& c) {
  const Quantity torque{unit::torque, not_negative};
  const Bounds gear_pressure_angle = between(5 * std::numbers::pi / 180, 40 * std::numbers::pi / 180);
  io("roller_torque", c.roller_torque, torque, "Resists a roller's spin");
  io("screw_torque", c.screw_torque, torque, "Resists the carrier on the screw");
  io("nut_torque", c.nut_torque, torque, "Resists the carrier on the nut");
  io("bearing", c.bearing, "Plain bearings of the roller's heads, in place of roller_torque");
  io("gear_pressure_angle", c.gear_pressure_angle, Quantity{unit::angle, gear_pressure_angle},
     "Of the gears between rollers and nut, inverted: and screw");
}

void fields(const Fields& io, Heat::Conductance& c) {
  const Quantity conductance{unit::thermal_conductance, not_negative};
  io("screw_ambient", c.screw_ambient, conductance, required,
     "From the screw to its surroundings, its bearings included");
  io("nut_ambient", c.nut_ambient, conductance, required, "From the nut to its surroundings, its seat included");
  io("rollers_ambient", c.rollers_ambient, conductance, "From all rollers to their surroundings");
  io("screw_rollers", c.screw_rollers, conductance, "From the screw to all rollers");
  io("rollers_nut", c.rollers_nut, conductance, "From all rollers to the nut");
}

void fields(const Fields& io, Heat::DutyStep& s) {
  const Quantity duration{unit::duration, positive};
  io("load_case", s.load_case, Text{"pull"}, "Name of the load case that acts");
  io("duration", s.duration, duration, required_only_if(s.load_case.has_value(), "with `load_case`"),
     "For how long it acts");
  io("rest", s.rest, duration, required_only_if(!s.load_case, "in place of `load_case` and `duration`"),
     "For how long nothing moves");
}

void fields(const Fields& io, Heat::Capacity& c) {
  const Quantity capacity{unit::heat_capacity, positive};
  io("screw", c.screw, capacity, required, "Of the screw");
  io("rollers", c.rollers, capacity, required, "Of all rollers");
  io("nut", c.nut, capacity, required, "Of the nut");
}

/// One temperature, or one each of screw, rollers and nut.
struct OneOrEachPart {};

Value value_of(PerPart<double>& parts, const OneOrEachPart&) {
  const Quantity temperature{unit::temperature, positive, "20 degC"};
  return {OneOr{.form = OneOr::Form::parts,
                .one = [&parts, temperature] { return value_of(parts.screw, temperature); },
                .several =
                    [&parts, temperature] {
                      return Value{map_of([&parts, temperature](const Fields& io) {
                        io("screw", parts.screw, temperature, required, "Of the screw");
                        io("rollers", parts.roller, temperature, required, "Of all rollers");
                        io("nut", parts.nut, temperature, required, "Of the nut");
                      })};
                    },
                .others = ", or one each for {screw, rollers, nut}",
                .spread = [&parts] { parts.roller = parts.nut = parts.screw; },
                .are_several = parts.screw != parts.roller || parts.roller != parts.nut}};
}

void mission_fields(const Fields& io, std::optional<int>& cycles, std::optional<PerPart<double>>& start,
                    bool has_duty) {
  io("cycles", cycles, Whole{1, 100'000}, optional_only_if(has_duty, "with `duty`"),
     "Number of cycles of a mission, over which temperatures run from `start`; without it the state that repeats "
     "itself");
  io("start", start, OneOrEachPart{}, optional_only_if(cycles.has_value(), "with `cycles`"),
     "Temperatures at the start of the mission; `ambient` by default");
}

void fields(const Fields& io, Heat& h) {
  io("ambient", h.ambient, Quantity{unit::temperature, positive}, required, "Temperature of the surroundings");
  io("conductance", h.conductance, required, "Heat flow over the difference of temperature");
  io("losses", h.losses, "Temperatures at which losses and loads are taken");
  io("duty", h.duty, List{Block{}, 1}, "Load cases and rests one after the other, again and again");
  mission_fields(io, h.cycles, h.start, !h.duty.empty());
  io("capacity", h.capacity, "Heat capacities of the parts, for `duty`");
  io("specific_heat", h.specific_heat, Quantity{unit::specific_heat, positive},
     optional_only_if(!h.capacity, "in place of `capacity`"),
     "Of all parts, for `duty`: their masses are those of `prs measures`, the screw's over "
     "the length of the nut");
}

void fields(const Fields& io, DriveMotor& m) {
  const Quantity torque{unit::torque, positive, "3 N m"};
  io("rated_torque", m.rated_torque, torque, "Greatest rms torque");
  io("peak_torque", m.peak_torque, torque, "Greatest torque");
  io("largest_speed", m.largest_speed, Quantity{unit::rotational_speed, positive, "3000 rpm"}, "Of the motor");
  io("inertia", m.inertia, Quantity{unit::inertia, not_negative}, "At its shaft, with its gear");
  io("gear_ratio", m.gear_ratio, Number{positive, "1"}, "Turns of the motor per turn of the screw");
  io("gear_efficiency", m.gear_efficiency,
     Quantity{unit::share, {.least = 0.0, .greatest = 1.0, .least_excluded = true}}, "Of the gear");
  constexpr std::string_view kElectric = "only with `torque_constant`";
  io("torque_constant", m.torque_constant, Quantity{unit::torque_constant, positive},
     "Torque over current of the equivalent direct-current motor");
  const bool is_electric = m.torque_constant.has_value();
  io("resistance", m.resistance, Quantity{unit::resistance, positive}, optional_only_if(is_electric, kElectric),
     "Of its winding");
  io("supply", m.supply, Keys{[&m](const Fields& of) {
       of("voltage", m.supply.voltage, Quantity{unit::voltage, positive}, "Greatest");
       of("current", m.supply.current, Quantity{unit::current, positive}, "Greatest");
     }},
     optional_only_if(is_electric, kElectric), "What the supply gives");
  io("continuous_current", m.continuous_current, Quantity{unit::current, positive},
     optional_only_if(is_electric, kElectric), "Greatest rms current");
}

void fields(const Fields& io, MotorDuty::Step& s) {
  io("load_case", s.load_case, Text{"lift"}, "Whose friction it has; none at rest or without force");
  io("duration", s.duration, Quantity{unit::duration, positive}, required, "Of constant acceleration");
  io("start_speed", s.start_speed, Quantity{unit::travel_speed}, required, "Signed");
  io("end_speed", s.end_speed, Quantity{unit::travel_speed}, required, "Signed");
  io("force", s.force, Quantity{unit::force}, "Axial, on the screw, > 0 where it pushes in the positive sense");
}

void fields(const Fields& io, MotorDuty& d) {
  fields(io, d.motor);
  io("brake_torque", d.brake_torque, Quantity{unit::torque, positive, "4 N m"}, "Holds the axis at rest, at its shaft");
  io("brake_safety", d.brake_safety, Number{{.least = 1.0}, "1.5"},
     optional_only_if(d.brake_torque.has_value(), "only with `brake_torque`"),
     "Least torque of the brake over that of the holding force");
  io("drag_torque", d.drag_torque, Quantity{unit::torque, not_negative}, "Against the motion, at the part that turns");
  io("holding_force", d.holding_force, Quantity{unit::force, not_negative}, "Largest at rest");
  io("back_driving", d.back_driving, "Whether the load may turn the screw");
  io("driven_back", d.driven_back, Text{"back-driving"},
     "Load case that the load drives unless the screw locks itself");
  io("cycle", d.cycle, List{Block{}, 1}, required, "Steps of constant acceleration, again and again");
}

void fields(const Fields& io, Limits& l) {
  const Quantity length{unit::length, positive, "100 mm"};
  io("life", l.life, EitherQuantity{{unit::duration, positive, "20000 h"}, {unit::distance, positive}},
     "Least rated life, as time or travel");
  io("static_safety", l.static_safety, Number{positive, "1.5"}, "Least");
  io("peak_pressure", l.peak_pressure, Quantity{unit::pressure, positive, "4 GPa"}, "Greatest, of all contacts");
  io("buckling_safety", l.buckling_safety, Number{positive, "3"}, "Least");
  io("critical_speed_share", l.critical_speed_share, Quantity{unit::share, positive, "80 %"},
     "Greatest speed over the critical one");
  io("speed_times_diameter", l.speed_times_diameter, Quantity{unit::speed, positive},
     "Greatest n d, d the pitch diameter of the screw");
  io("nut_diameter", l.nut_diameter, length, "Greatest outer diameter of the nut, flanges left out");
  io("nut_length", l.nut_length, length, "Greatest length of the nut");
  io("weight", l.weight, Quantity{unit::mass, positive},
     "Greatest: nut, rollers and screw over `measures.shaft.length`");
  io("stiffness", l.stiffness, Quantity{unit::stiffness, positive},
     "Least axial stiffness, in series with that of `measures.shaft`");
  io("efficiency", l.efficiency, Quantity{unit::share, Bounds{0.0, 1.0, true, true, false}, "80 %"},
     "Least, where the screw drives");
  io("temperature", l.temperature, Quantity{unit::temperature, positive, "80 degC"},
     "Greatest of screw, rollers and nut");
}

/// Examples of valid texts.
constexpr Text kInputPath{"mechanism.flank_angle.screw"};
constexpr Text kResponsePath{"screw.peak_pressure_MPa.max"};
constexpr Verbatim kLimit{"{initial: 1.1}"};

void alternatives(Choices& io, Algorithm& a) {
  io("nsga2", a, Algorithm::nsga2, "non-dominated sorting genetic algorithm; several objectives");
  io("nspso", a, Algorithm::nspso, "non-dominated sorting particle swarm; several objectives");
  io("moead", a, Algorithm::moead, "decomposition with differential evolution; several objectives");
  io("sade", a, Algorithm::sade, "self-adaptive differential evolution; one objective");
  io("pso", a, Algorithm::pso, "particle swarm; one objective");
  io("cmaes", a, Algorithm::cmaes, "covariance matrix adaptation; one objective");
}

void alternatives(Choices& io, Compromise::By& b) {
  io("ideal", b, Compromise::By::ideal, "nearest to the best value of every objective");
  io("knee", b, Compromise::By::knee, "farthest from the plane through the front's ends");
  io("weights", b, Compromise::By::weights, "least weighted sum");
  io("best", b, Compromise::By::best, "best value of one objective");
}

void fields(const Fields& io, LinkedInputItem& l) {
  io("path", l.path, kInputPath, required, "What changes with the variable, as `--set` names it");
  io("values", l.values, List{Verbatim{}, 2}, required, "One for each value of the variable");
}

void fields(const Fields& io, VariableItem& v) {
  io("path", v.path, kInputPath, required, "What may change, as `--set` names it");
  io("label", v.label, Text{"lead"}, "Its name in tables and figures");
  io("values", v.values, List{Verbatim{}, 2}, "What it may be, as it would stand in the file");
  const Presence bound = required_only_if(!v.values, "in place of `values`");
  io("from", v.from, Verbatim{}, bound, "Least value; of whole numbers all up to `to`");
  io("to", v.to, Verbatim{}, bound, "Greatest value, in the same unit");
  io("with", v.companions, List{Block{}, 1}, optional_only_if(v.values.has_value(), "only with `values`"),
     "Inputs that change together with this one, value by value");
}

void fields(const Fields& io, ObjectiveItem& o) {
  io("minimize", o.minimize, kResponsePath,
     "Path of the response that shall be small: into the first load case of the JSON "
     "document of the command or into the document, of an array `.max`, `.min`, `.mean` or "
     "`[k]`");
  io("maximize", o.maximize, kResponsePath, required_only_if(!o.minimize, "in place of `minimize`"),
     "Path of the response that shall be large");
}

void fields(const Fields& io, ConstraintItem& c) {
  io("response", c.response, kResponsePath, required, "Path of a response");
  io("at_least", c.at_least, kLimit,
     "A number in the unit of the path, `{initial: 0.9}` for 0.9 times the value of the "
     "file's own design, or `{response: PATH}` for another response of the same design");
  io("at_most", c.at_most, kLimit, c.at_least ? optional : Presence{true, true, "where there is no `at_least`"},
     "The same from above");
  io("name", c.name, Text{"weight"}, "Its name in tables");
}

void fields(const Fields& io, CompromiseItem& c) {
  io("by", c.by, "Which design of the front is chosen, objectives scaled by the extent of the front");
  io("weights", c.weights, List{Number{not_negative}, 1},
     required_only_if(c.by == Compromise::By::weights, "only with `by: weights`"), "One for each objective");
  io("of", c.of, kResponsePath, required_only_if(c.by == Compromise::By::best, "only with `by: best`"),
     "The objective's path");
}

void fields(const Fields& io, OptimizeItem& o) {
  io("command", o.command, required, "What each design runs through");
  io("variables", o.variables, List{Block{}, 1}, required, "The inputs that may change");
  io("objectives", o.objectives, List{Block{}, 1, 8}, required, "What shall be as small or as large as possible");
  io("constraints", o.constraints, List{Block{}, 1}, "What a design must keep");
  io("thread_constraints", o.thread_constraints,
     "Threads that are neither sharp nor cut into each other and touch on their flanks only, "
     "Yao et al. (51) to (60)");
  io("algorithm", o.algorithm, "How designs are searched; nsga2, or sade of a single objective by default");
  io("check", o.check, "A second search to compare with");
  io("population", o.population, Whole{8, 2'000}, "Designs of a generation");
  io("generations", o.generations, Whole{1, 10'000}, "The first, random one included");
  io("seed", o.seed, Whole{0, std::int64_t{1} << 53}, "Of the random numbers: the same seed finds the same designs");
  io("compromise", o.compromise, "Which design of the front is chosen");
}

void fields(const Fields& io, WrittenInterval& i) {
  io("from", i.from, Verbatim{}, required, "Least value");
  io("to", i.to, Verbatim{}, required, "Greatest value, in the same unit");
}

void fields(const Fields& io, WrittenNormal& n) {
  io("deviation", n.deviation, Verbatim{}, required, "Standard deviation");
  io("mean", n.mean, Verbatim{}, "In place of what the file says");
}

void fields(const Fields& io, CompanionItem& c) {
  io("path", c.path, Text{"mechanism.lead"}, required, "What changes with the factor, as `--set` names it");
  io("values", c.values, ListOrRange{}, required, "One for each value of the factor");
  io("label", c.label, Text{"lead"}, "Its name in tables and figures");
}

void fields(const Fields& io, FactorItem& f) {
  io("path", f.path, Text{"mechanism.lead"}, required,
     "What to vary, as `--set` names it; of a list of numbers every entry is drawn on its "
     "own");
  io("values", f.values, ListOrRange{},
     "As they would stand in the file; one of them, all as likely, in a plan with samples");
  io("uniform", f.uniform, "In a plan with samples, in place of `values`: drawn from an interval");
  io("log_uniform", f.log_uniform, "The same, uniform in the logarithm");
  io("normal", f.normal, "In a plan with samples, in place of `values`: normally distributed");
  io("within", f.within, Verbatim{},
     "In a plan with samples, in place of `values`: uniform about what the file says, by a "
     "share `3 %` or a half width `0.02 mm` to both sides, or from the lower to the upper "
     "deviation `[-0.01 mm, 0.03 mm]`");
  io("label", f.label, Text{"lead"}, "Its name in tables and figures");
  io("together", f.together, "Whether the entries of a list, each drawn on its own, count as one factor");
  io("kept", f.kept, "Whether a plan of tolerances draws it and never halves it");
  io("with", f.companions, List{Block{}, 1}, "Inputs that change together with this one, value by value");
}

void fields(const Fields& io, Envelope::Measure& m) {
  io("response", m.response, Text{"axial_stiffness_N_per_um"}, required, "What is measured: the path of a response");
  io("weight", m.weight, Number{not_zero, "1"}, "Exponent in a product, factor in a sum; < 0 of what shall be small");
}

void fields(const Fields& io, Envelope::Target& t) {
  io("response", t.response, Text{"axial_stiffness_N_per_um"}, required, "The path of a response");
  io("value", t.value, Number{}, required, "What it shall be, in the unit of the path");
}

void fields(const Fields& io, EnvelopePointItem& p) {
  io("name", p.name, Text{"A"}, required, "In tables and figures");
  io("at", p.at, List{Verbatim{}, 2, 2}, "Values of the two factors");
  io("wanted", p.wanted, "In place of `at`");
  io("reach", p.reach, List{Block{}, 1, 2},
     "In place of `at`: one response, and the envelope as good as it gets along the lines of "
     "the grid; or two");
}

void fields(const Fields& io, EnvelopeItem& e) {
  io("combine", e.combine, "How the measures become one");
  io("normalise", e.normalise, "What each measure is divided by before");
  io("measures", e.measures, List{Block{}, 1}, required, "What makes a design good or bad");
  io("points", e.points, List{Block{}, 1}, "Designs to read off, each with one of at, wanted, reach");
}

void fields(const Fields& io, StudyItem& s) {
  io("command", s.command, required, "What each design runs through");
  io("plan", s.plan, "How designs are chosen");
  const std::string_view sampled =
      "only with the plans latin_hypercube, sobol, monte_carlo, sobol_indices and tolerances";
  io("samples", s.samples, Whole{1, kMostDesigns - 1}, required_only_if(is_sampled(s.plan), sampled),
     "Number of draws");
  io("seed", s.seed, Whole{0, std::int64_t{1} << 53}, optional_only_if(is_sampled(s.plan), sampled),
     "Of the random numbers: the same seed draws the same designs");
  io("factors", s.factors, List{Block{}, 1}, required, "The inputs that vary");
  io("responses", s.responses, List{Text{"axial_stiffness_N_per_um"}, 1},
     "What is recorded of each design: paths into the first load case of its JSON document or "
     "into the document, of an array also `.max`, `.min`, `.mean` or `[k]`; a choice that suits "
     "the command by default, with an envelope what it needs");
  io("envelope", s.envelope, optional_only_if(s.plan == Plan::grid, "with the plan grid"),
     "Maps of measures over two factors, made one, and designs read off them");
}

void alternatives(Choices& io, FitParameterItem::Scale& s) {
  io("linear", s, FitParameterItem::Scale::linear, "the value itself");
  io("log", s, FitParameterItem::Scale::log, "its logarithm");
}

void alternatives(Choices& io, FitCurveItem::Use& u) {
  io("fit", u, FitCurveItem::Use::fit, "the parameters follow it");
  io("compare", u, FitCurveItem::Use::compare, "only compared: a curve held back");
}

void fields(const Fields& io, FitParameterItem::Prior& p) {
  io("mean", p.mean, Verbatim{"207 GPa"}, required, "What was known before");
  io("deviation", p.deviation, Verbatim{"3 %"}, required, "Its standard deviation; `%` of the mean");
}

void fields(const Fields& io, FitParameterItem& p) {
  io("path", p.path, kInputPath, required, "An unknown number of the case, as `--set` names it");
  io("from", p.from, Verbatim{}, required, "Least value");
  io("to", p.to, Verbatim{}, required, "Greatest value");
  io("start", p.start, Verbatim{}, "Where the search starts; by default what the file says, else the key's default");
  io("scale", p.scale, "Scale on which search, priors and intervals are linear");
  io("prior", p.prior, "What is known besides the curves");
  io("label", p.label, Text{"friction"}, "Its name in tables and figures");
}

void fields(const Fields& io, FitConditionItem& c) {
  io("path", c.path, kInputPath, required, "What each row sets, as `--set` names it");
  io("value", c.value, Verbatim{}, "The same in all rows");
  io("column", c.column, Text{"speed_rpm"}, "Its name in the heading of the file");
  io("unit", c.unit, Text{"rpm"},
     "Of its numbers; without it words and bare numbers, as they would stand in this file");
  io("values", c.values, ListOrRange{}, "Of a band: those of all conditions with `values` run together");
}

void fields(const Fields& io, FitCurveItem::Column& c) {
  io("column", c.column, Text{"torque_Nm"}, "Its name in the heading of the file; `measured` by default");
  io("unit", c.unit, Text{"N m"}, "Of its numbers");
}

void fields(const Fields& io, FitCurveItem::Along& a) {
  io("response", a.response, Text{"heat_cycle.time_s"}, required,
     "What the rows stand over: `preload.loads[].axial_force_N`, `heat_cycle.time_s` or `response.time_s`");
  io("column", a.column, Text{"time_s"}, required, "Its name in the heading of the file");
  io("unit", a.unit, Text{"s"}, required, "Of its numbers");
}

constexpr std::string_view kFitCommand = "`contact`, `solve`, `slip`, `preload`, `life` or `measures`; by the response";

void fields(const Fields& io, FitCurveItem& c) {
  io("name", c.name, Text{"torque"}, "`curve-K` by default");
  io("file", c.file, Text{"torque.csv"}, required,
     "Comma-separated values with a heading, one row per reading; relative to this file");
  io("response", c.response, Text{"slip.torque_screw_Nm"}, required,
     "What was measured: a response of `prs list responses`, or of a series as "
     "`preload.loads[].axial_displacement_um`");
  io("measured", c.measured, required, "The readings");
  io("conditions", c.conditions, "What each row sets, in this order");
  io("along", c.along, "Of a series: where the rows stand");
  io("deviation", c.deviation, Verbatim{"0.05 N m"},
     "Standard deviation of a reading: a value, a share of the reading (`1 %`), `{column: .., unit: ..}`, or "
     "`estimated`, which is the default");
  io("offset", c.offset, "Whether an unknown constant is added: the zero of a probe");
  io("loss", c.loss, Verbatim{"huber"},
     "`squares` (default), `huber`, `cauchy`, `{huber: 1.345}` or `{cauchy: 2.385}`");
  io("use", c.use, "What the curve is for");
  io("command", c.command, Text{"slip"}, kFitCommand);
}

void fields(const Fields& io, FitBandItem& b) {
  io("name", b.name, Text{"loss"}, required, "Of the band");
  io("response", b.response, Text{"slip.power_loss_W"}, required, "A response of any command");
  io("conditions", b.conditions, "Where it is computed");
  io("command", b.command, Text{"slip"}, kFitCommand);
}

void fields(const Fields& io, FitItem& f) {
  io("parameters", f.parameters, List{Block{}, 1, 50}, required, "Inputs that nobody can look up");
  io("curves", f.curves, List{Block{}, 1, 100}, required, "What was measured");
  io("level", f.level, Quantity{unit::share, Bounds{0.5, 99.9 / 100.0}, "90 %"}, "Of all intervals");
  io("starts", f.starts, Whole{1, 1000}, "Searches: from the file's values, then from points spread over the bounds");
  io("profile", f.profile, Verbatim{"[roughness]"},
     "Paths whose intervals are searched for, too, or `true` for all of them");
  io("bands", f.bands, "Responses that are computed with their uncertainty");
}

void fields(const Fields& io, ReferenceItem::Column& c) {
  io("column", c.column, Text{"share"},
     "Its name in the heading of the file; by default the first that is neither `along` nor `load_case`");
  io("unit", c.unit, Text{"\"%\""}, "Of its numbers; by default that of the response");
}

void fields(const Fields& io, ReferenceItem::Along& a) {
  io("column", a.column, Text{"thread"}, required, "Its name in the heading of the file");
  io("input", a.input, Text{"operation.speed"},
     "`thread`, or the input that each row sets: a key of the load case (`axial_force`), or a path as `--set` names "
     "it; by the column's name if that is `thread` or begins with `force` or `axial_force`");
  io("unit", a.unit, Text{"kN"}, "Of its numbers; by default what the column's name ends in: `kN` of `force_kN`");
}

void fields(const Fields& io, ReferenceItem& r) {
  io("file", r.file, Text{"fe.csv"}, required,
     "Comma-separated values with a heading, relative to this file. Without `response` its columns are `thread` or "
     "`force_kN`, `load_case`, and responses by their names");
  io("name", r.name, Text{"3D FE"}, "Of the reference; that of the file by default");
  io("load_case", r.load_case, Text{"push"}, "Its load case; by default the column `load_case`, or the only one");
  io("response", r.response, Text{"screw.load_rate_percent"},
     "Of the load case, by `prs solve` or `prs slip`: an array over threads, else a number");
  io("measured", r.measured, "The reference's numbers");
  io("along", r.along, "What the rows stand over; by default `thread` or `force_kN`, where there is such a column");
  io("deviation", r.deviation, Verbatim{"1 % of each value"},
     "Of the reference itself: as `tolerance`, or `{column: .., unit: ..}`");
  io("tolerance", r.tolerance, Verbatim{"10 % of the mean"},
     "Largest deviation that is allowed: `10 % of the mean`, `10 % of each value`, or a value in the response's unit");
}

void alternatives(Choices& io, ReportInput::Butterfly& b) {
  io("mean", b, ReportInput::Butterfly::of_mean, "in percent of the mean thread, tension to the right");
  io("load", b, ReportInput::Butterfly::of_load, "in percent of the load, tension to the left, as in papers");
}

void fields(const Fields& io, ReportInput& r) {
  io("title", r.title, Text{"\"Press 40 kN\""}, "What was calculated");
  io("customer", r.customer, Text{"\"Customer\""}, "For whom");
  io("author", r.author, Text{"\"Author\""}, "By whom");
  io("number", r.number, Text{"\"C-1234\""}, "Of the calculation or the drawing");
  io("revision", r.revision, Text{"\"A\""}, "Of the calculation");
  io("butterfly", r.butterfly, "Shares of the threads over the load and beside references, in all pictures");
}

void alternatives(Choices& io, SignalTerm::Spacing& s) {
  io("logarithmic", s, SignalTerm::Spacing::logarithmic, "equal ratios");
  io("linear", s, SignalTerm::Spacing::linear, "equal differences");
}

void alternatives(Choices& io, ResponseInput::Feedback& f) {
  io("motor", f, ResponseInput::Feedback::motor, "the angle of the motor");
  io("load", f, ResponseInput::Feedback::load, "the position of the load");
}

void alternatives(Choices& io, ResponseInput::Ends& e) {
  io("fixed_free", e, ResponseInput::Ends::fixed_free, "one axial bearing");
  io("fixed_fixed", e, ResponseInput::Ends::fixed_fixed, "an axial bearing at each end of the span");
}

void alternatives(Choices& io, ResponseInput::ScrewState& s) {
  io("held", s, ResponseInput::ScrewState::held, "the screw does not turn");
  io("rolling", s, ResponseInput::ScrewState::rolling, "the screw turns evenly");
}

void alternatives(Choices& io, ResponseInput::Input& i) {
  io("load_force", i, ResponseInput::Input::load_force, "a force on the load");
  io("motor_torque", i, ResponseInput::Input::motor_torque, "the torque of the motor");
}

namespace signal_kinds {

/// Map {at, value} for such values.
struct Point {
  Quantity time, value;
};
Value value_of(SignalTerm::Point& point, const Point& kind) {
  return {map_of([&point, kind](const Fields& io) {
    io("at", point.at, kind.time, required, "Time");
    io("value", point.value, kind.value, required, "From then on, or then");
  })};
}

/// A map whose keys are listed by a function.
template <class List>
struct KeysOf {
  List list;
};
template <class List>
KeysOf(List) -> KeysOf<List>;
template <class T, class L>
Value value_of(T& block, const KeysOf<L>& kind) {
  return {map_of([&block, kind](const Fields& io) { kind.list(io, block); })};
}

}  // namespace signal_kinds

Value value_of(SignalTerm& term, const OneOrSum& kind) {
  using signal_kinds::KeysOf, signal_kinds::Point;
  const auto forms = [&term, kind](const Fields& io) {
    const Quantity time{unit::duration, unbounded, "10 ms"}, late{unit::duration, positive, "50 ms"};
    const Quantity frequency{unit::frequency, positive};
    const auto points = [&](std::string_view key, std::optional<std::vector<SignalTerm::Point>>& list,
                            std::string_view meaning) {
      io(key, list, List{Point{time, kind.quantity}, 1}, meaning);
    };
    points("steps", term.steps, "The value of the last time that has come, 0 before the first");
    points("points", term.points, "Straight between, the ends' values outside");
    io("sine", term.sine, KeysOf{[kind, frequency](const Fields& of, SignalTerm::Sine& s) {
         of("mean", s.mean, kind.quantity, "About which it swings");
         of("amplitude", s.amplitude, kind.quantity, required, "Of the swing");
         of("frequency", s.frequency, frequency, required, "Of the swing");
         of("phase", s.phase, Quantity{unit::angle}, "At t = 0");
       }},
       "mean + amplitude sin(2 pi f t + phase)");
    io("sweep", term.sweep, KeysOf{[kind, frequency, late](const Fields& of, SignalTerm::Sweep& s) {
         of("mean", s.mean, kind.quantity, "About which it swings");
         of("amplitude", s.amplitude, kind.quantity, required, "Of the swing");
         of("from", s.from, frequency, required, "Frequency at t = 0");
         of("to", s.to, frequency, required, "Frequency at the end and from then on");
         of("duration", s.duration, late, required, "From one to the other");
         of("spacing", s.spacing, "How the frequency goes over time");
       }},
       "A sine whose frequency moves");
    io("file", term.file, KeysOf{[](const Fields& of, SignalTerm::File& f) {
         of("name", f.name, Text{"signal.csv"}, required,
            "Comma-separated values with a heading; relative to this file");
         of("time", f.time, required, "Times, which rise");
         of("value", f.value, required, "Values, straight between");
       }},
       "As `points`, from a file");
  };
  return {OneOr{.form = OneOr::Form::signal,
                .one = [&term, kind] { return input::value_of(term.constant, kind.quantity); },
                .several =
                    [&term, forms] {
                      if (!term.has_form()) term.constant = std::nan("");
                      return Value{map_of(forms)};
                    },
                .others = ", or a map with one of steps, points, sine, sweep, file, or a list of these",
                .are_several = term.has_form() || term.file}};
}

Value value_of(Signal& signal, const OneOrSum& kind) {
  return {OneOr{.form = OneOr::Form::rollers,
                .one = [&signal, kind] { return value_of(signal.one, kind); },
                .several =
                    [&signal, kind] {
                      return input::value_of(signal.many, List{kind, 1});
                    },
                .others = "",
                .are_several = !signal.many.empty()}};
}

void fields(const Fields& io, ResponseInput::Controller& c) {
  io("speed", c.speed, OneOrSum{{unit::rotational_speed}}, "Reference of the speed; this or `position`");
  io("position", c.position, OneOrSum{{unit::length}}, "Reference of the position of the load");
  io("position_gain", c.position_gain, Quantity{unit::position_gain, positive},
     required_only_if(c.position.has_value(), "only with `position`"), "Speed over error of position");
  io("speed_gain", c.speed_gain, Quantity{unit::rotational_damping, positive}, required, "Torque over error of speed");
  io("integral_time", c.integral_time, Quantity{unit::duration, positive, "20 ms"},
     "Of the speed loop; none by default");
  io("largest_torque", c.largest_torque, Quantity{unit::torque, positive}, "Bound of the torque; none by default");
  io("largest_speed", c.largest_speed, Quantity{unit::rotational_speed, positive},
     "Largest speed that the loop may demand; none by default");
  io("feedback", c.feedback, optional_only_if(c.position.has_value(), "only with `position`"),
     "What the position loop measures");
  io("speed_feed_forward", c.speed_feed_forward, optional_only_if(c.position.has_value(), "only with `position`"),
     "Whether the slope of the reference is added");
}

void fields(const Fields& io, ResponseInput::CurrentLoop& l) {
  io("time_constant", l.time_constant, Quantity{unit::duration, positive, "0.3 ms"}, required,
     "Of the lag of the torque behind the commanded one");
}

void fields(const Fields& io, ResponseInput::Motor& m) {
  io("inertia", m.inertia, Quantity{unit::inertia, not_negative}, "Of the rotor");
  io("friction_torque", m.friction_torque, Quantity{unit::torque, not_negative}, "Dry friction at its shaft");
  io("damping", m.damping, Quantity{unit::rotational_damping, not_negative}, "Torque over speed");
  io("torque", m.torque, OneOrSum{{unit::torque}}, "Of the motor on its shaft; one of torque, speed, controller");
  io("speed", m.speed, OneOrSum{{unit::rotational_speed}}, "Prescribed, without jumps");
  io("controller", m.controller, "Of speed or position");
  constexpr std::string_view kDriven = "only with `torque` or `controller`";
  io("current_loop", m.current_loop, optional_only_if(!m.speed, kDriven), "Lag of the torque; none by default");
  io("cut_at", m.cut_at, Quantity{unit::duration, not_negative, "0.1 s"}, optional_only_if(!m.speed, kDriven),
     "From here on the commanded torque is 0; never by default");
}

void fields(const Fields& io, ResponseInput::Brake& b) {
  io("torque", b.torque, Quantity{unit::torque, not_negative}, required, "Dry friction at the motor's shaft");
  io("at", b.at, Quantity{unit::duration, not_negative, "0.1 s"}, required, "From here on, for good");
}

void fields(const Fields& io, ResponseInput::Coupling& c) {
  io("stiffness", c.stiffness, Quantity{unit::tilt_stiffness, positive, "2000 N m/rad"}, required, "Torsional");
  io("damping", c.damping, Quantity{unit::rotational_damping, not_negative}, "Torque over rate of twist");
}

void fields(const Fields& io, ResponseInput::Screw& s) {
  io("inertia", s.inertia, Quantity{unit::inertia, not_negative}, "Of all that turns behind the coupling");
  io("drag_torque", s.drag_torque, Quantity{unit::torque, not_negative}, "Dry friction of bearings and seals");
}

void fields(const Fields& io, PrsLinkage& l) {
  const Quantity length{unit::length, positive, "500 mm"};
  io("base", l.base, length, required, "From the joint of the lever to the point of the base that holds the screw");
  io("arm", l.arm, length, required, "From the joint to the point of the lever that holds the screw");
}

void fields(const Fields& io, ResponseInput::Load& l) {
  constexpr std::string_view kAlong = "without `linkage`", kOfLever = "only with `linkage`";
  io("linkage", l.linkage, Block{}, "Of a lever that the screw turns");
  const bool turns = l.linkage.has_value();
  io("mass", l.mass, Quantity{unit::mass, positive}, required_only_if(!turns, kAlong), "That moves along the axis");
  io("force", l.force, OneOrSum{{unit::force}}, optional_only_if(!turns, kAlong),
     "> 0 holds the load back against +x and puts the screw in tension");
  io("inertia", l.inertia, Quantity{unit::inertia, positive, "2 kg m^2"}, required_only_if(turns, kOfLever),
     "Of the lever about its joint");
  io("torque", l.torque, OneOrSum{{unit::torque}}, optional_only_if(turns, kOfLever),
     "At the lever; > 0 holds it back against growing angles");
  io("friction_force", l.friction_force, Quantity{unit::force, not_negative}, "Dry friction of the guides");
  io("damping", l.damping, Quantity{unit::damping, not_negative}, "Force over speed");
}

void fields(const Fields& io, ResponseInput::MaterialDamping& m) {
  io("time", m.time, Quantity{unit::duration, not_negative, "15 us"}, "Damping over stiffness of the screw");
  io("loss_factor", m.loss_factor, Quantity{unit::share, not_negative, "3 %"},
     "In place of `time`, with `at_frequency`");
  io("at_frequency", m.at_frequency, Quantity{unit::frequency, positive}, "At which the loss factor holds");
}

void fields(const Fields& io, ResponseInput::EndStop& s) {
  io("at", s.at, Quantity{unit::length}, required, "Position of the load at which it begins");
  io("stiffness", s.stiffness, Quantity{unit::stiffness, positive}, required, "Of the stop");
  io("damping", s.damping, Quantity{unit::stop_damping, not_negative}, "Share of the force over the speed of pressing");
}

void fields(const Fields& io, ResponseInput::EndStops& s) {
  io("upper", s.upper, "At large positions");
  io("lower", s.lower, "At small positions");
}

void fields(const Fields& io, ResponseInput::Shaft& s) {
  io("length", s.length, Quantity{unit::length, positive, "300 mm"}, required,
     "From the axial bearing to the loaded section at the start");
  io("ends", s.ends, "Axial bearings of the shaft");
  io("span", s.span, Quantity{unit::length, positive, "900 mm"},
     required_only_if(s.ends == ResponseInput::Ends::fixed_fixed, "only with `ends: fixed_fixed`"),
     "Between the bearings");
}

void fields(const Fields& io, ResponseInput::Start& s) {
  io("position", s.position, Quantity{unit::length}, "Of the load");
  io("speed", s.speed, Quantity{unit::travel_speed}, "Of the load, and of the motor over the lead");
  io("deflection", s.deflection, kSmallLength, "Of the screw; that of the external force by default");
  io("angle", s.angle, Quantity{unit::angle, unbounded, "60 deg"}, "Between base and arm of a lever, at `position`");
}

void fields(const Fields& io, ResponseInput::Curves& c) {
  io("force", c.force, Quantity{unit::force, positive}, "Largest force of the curves; that of the file by default");
  io("speed", c.speed, Quantity{unit::rotational_speed, positive},
     "Largest speed of the table of friction; that of the file by default");
  io("load_case", c.load_case, Text{"pull"}, "Whose conditions hold; the first that is solved by default");
}

void fields(const Fields& io, ResponseInput::Settling& s) {
  io("after", s.after, Quantity{unit::duration, not_negative, "50 ms"}, required, "From which time on settling counts");
  io("band", s.band, Quantity{unit::length, positive, "20 um"}, required, "To both sides of where the load ends");
}

void fields(const Fields& io, ResponseInput::FrequencyResponse& f) {
  io("from", f.from, Quantity{unit::frequency, positive, "10 Hz"}, required, "Lowest frequency");
  io("to", f.to, Quantity{unit::frequency, positive, "2 kHz"}, required, "Highest frequency");
  io("points", f.points, Whole{2, kMostSteps}, "Ends included");
  io("spacing", f.spacing, "Of the frequencies");
  io("force", f.force, Quantity{unit::force}, "Of the working point; `load.force` at t = 0 by default");
  io("position", f.position, Quantity{unit::length}, "Of the working point; that of the start by default");
  io("screw", f.screw, "What the screw does");
  io("speed", f.speed, Quantity{unit::rotational_speed, not_zero},
     required_only_if(f.screw == ResponseInput::ScrewState::rolling, "only with `screw: rolling`"), "Of the screw");
  io("input", f.input, "What swings");
}

void fields(const Fields& io, ResponseInput& r) {
  io("duration", r.duration, Quantity{unit::duration, positive, "0.1 s"}, required, "Of the run, from 0 on");
  io("sample_interval", r.sample_interval, Quantity{unit::duration, positive, "0.1 ms"},
     "Of the series; a thousandth of the duration by default");
  io("tolerance", r.tolerance, Number{Bounds{.least = 1e-12, .greatest = 1e-3}, "1e-8"},
     "Of the integration, relative");
  io("motor", r.motor, Block{"{inertia: 5 kg cm^2, torque: 2 N m}"}, required, "What drives");
  io("brake", r.brake, "That closes and stays closed");
  io("coupling", r.coupling, "Between motor and screw; without it both are one rigid part");
  io("screw", r.screw, "What turns with the screw");
  io("load", r.load, required, "What moves along the axis");
  io("material_damping", r.material_damping, "Of the screw's flanks and bodies");
  io("end_stops", r.end_stops, "Springs that the load runs into");
  io("shaft", r.shaft, "Axial compliance of the shaft beyond the nut");
  io("start", r.start, "State at t = 0");
  io("curves", r.curves, "Range of force and friction that are computed, as `prs export` has them");
  io("settling", r.settling, "When the load comes to rest");
  io("frequency_response", r.frequency_response, "Small vibration about a state of rest or of even rolling");
}

void fields(const Fields& io, CaseFile& file) {
  Case& c = file.values;
  io("mechanism", c.mechanism, required, "The threads");
  io("structure", c.structure, "The parts between and around the threads");
  io("materials", c.materials, OneOrEach{Block{}}, "Elastic properties");
  io("deviations", c.deviations, "How the real parts differ from their nominal geometry");
  io("contact", c.contact, "Values that replace what the geometry gives, in the load distribution only");
  io("model", c.model, "Choices of the model");
  io("load_cases", file.load_cases, List{Block{}, 1}, "Loads, each on its own");
  io("preload", c.preload, "How the play is taken out, and the curve through zero, for `prs preload`");
  io("life", c.life, "Load history or spectrum for `prs life`");
  io("measures", c.measures, "Further inputs of the design measures");
  io("bearings", c.bearings, "At the ends of the shaft, for their life and the stiffness of the axis");
  const Bounds up_to_100_um{.least = 0.0, .greatest = 1e-4, .least_excluded = true};
  io("roughness", c.roughness, OneOrEach{Quantity{unit::length, up_to_100_um, "0.4 um"}},
     "Rms roughness Rq of the flanks, for the film ratio");
  io("lubricant", c.lubricant, "The oil, or the base oil of the grease");
  io("friction", c.friction, ChoiceUnder{"model"}, "Law of friction");
  io("wear", c.wear, "Wear of the flanks, for `prs slip`");
  io("operation", c.operation, "How the mechanism runs");
  io("carrier", c.carrier, "What acts on the rollers besides the threads");
  io("heat", c.heat, "How the parts get rid of the heat of friction, for `prs slip`");
  io("response", c.response, "The screw in its drive, for `prs response`");
  io("limits", file.limits, "What the verdict of `prs check` and of the report holds the case against");
  io("motor", file.motor, "Demand of one cycle of the axis on motor and brake, and their limits, for `prs check`");
  io("study", file.study, "What `prs study` varies");
  io("optimize", file.optimize, "What `prs optimize` varies, and its aims");
  io("fit", file.fit, "What `prs fit` finds from measured curves");
  io("references", file.references, List{Block{}, 1, 100}, "Curves of other programs or tests, for `prs compare`");
  io("report", c.report, "Title block of `prs report`, and how pictures show shares");
}

Value value_of(Range& range, const OneOrRange& kind) {
  return {OneOr{.form = OneOr::Form::range,
                .one = [&range, kind] { return value_of(range.from, kind.quantity); },
                .several =
                    [&range, kind] {
                      return Value{map_of([&range, kind](const Fields& io) {
                        io("from", range.from, kind.quantity, required, "First value");
                        io("to", range.to, kind.quantity, required, "Last value");
                        io("steps", range.steps, Whole{1, kMostSteps}, required, "Number of values, ends included");
                      })};
                    },
                .others = ", or a range {from, to, steps}",
                .spread = [&range] { range.to = range.from; },
                .are_several = range.steps.value_or(1) > 1,
                .is_odd = [&range] { return range.steps == 1 && range.from != range.to; }}};
}

void fields(const Fields& io, WrittenRange& range) {
  io("from", range.from, Verbatim{}, required, "First value");
  io("to", range.to, Verbatim{}, required, "Last value, in the same unit");
  io("steps", range.steps, Whole{2, kMostSteps}, required, "Number of values, ends included");
  io("spacing", range.spacing, "What is equidistant");
}

Value value_of(WrittenValues& values, const ListOrRange&) {
  return {OneOr{.form = OneOr::Form::levels,
                .one =
                    [&values] {
                      return value_of(values.list, List{Verbatim{}, 1});
                    },
                .several =
                    [&values] {
                      if (!values.range) values.range.emplace();
                      return value_of(*values.range, Block{});
                    },
                .are_several = values.range.has_value()}};
}

}  // namespace prs::input
