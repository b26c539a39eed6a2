#include "prs/configurations/screw_case.h"

#include "prs/configurations/configurations_files.h"
#include "prs/input/units.h"
#include "prs/life/rating_life.h"
#include "prs/model/groove.h"
#include "prs/model/quantity_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kCaseWidth = 100;

/// Comment `# TEXT` over as many lines as needed.
std::string case_remark(const std::string& text, std::size_t indent = 0) {
  return wrapped(text, std::string(indent, ' ') + "# ", kCaseWidth);
}

/// Remark from which assumptions are read, see prs/input/echo.h: about `value`, as written in the file.
std::string assumption(const std::string& value, const std::string& reason) {
  return fmt::format("assumed {}: {}", value, reason);
}

constexpr std::string_view kAssumed = "assumed: ";

/// A line of the case with its remark at the end or, if that is too long, above. A remark that begins with `assumed: `
/// marks the value of the line.
std::string case_line(const std::string& content, std::string text) {
  if (text.starts_with(kAssumed))
    text = assumption(content.substr(content.find(": ") + 2), text.substr(kAssumed.size()));
  const std::string whole = fmt::format("{:<38}  # {}", content, text);
  if (width(whole) <= kCaseWidth) return whole + "\n";
  return case_remark(text, content.find_first_not_of(' ')) + content + "\n";
}

/// Remark on a value: given, or how it was assumed.
std::string origin_of(bool given, const std::string& assumed) {
  return given ? "given" : std::string(kAssumed) + assumed;
}

std::string degrees(double angle) { return fmt::format("{:.6g} deg", angle * 180.0 / std::numbers::pi); }
/// Given length with 15 digits: 0.3937 in is 9.99998 mm, not 9.999979999999999 mm.
std::string exact(double length) { return fmt::format("{:.15g} mm", 1e3 * length); }
std::string kilonewton(double force) { return fmt::format("{:.7g} kN", 1e-3 * force); }

/// A member of the data as the user wrote it, else the other text.
std::string written_or(const ScrewData& d, const std::string& member, std::string otherwise) {
  const auto known = d.as_written.find(member);
  return known == d.as_written.end() ? std::move(otherwise) : known->second;
}
std::string length_text(const ScrewData& d, const std::string& member, const std::optional<double>& given,
                        double otherwise) {
  return written_or(d, member, given ? exact(*given) : mm(otherwise));
}
std::string diameter_text(const ScrewData& d) { return written_or(d, "screw_diameter", exact(d.screw_diameter)); }
std::string lead_text(const ScrewData& d) { return written_or(d, "lead", exact(d.lead)); }
std::string roller_diameter_text(const CompleteScrew& s) {
  return length_text(s.data, "roller_diameter", s.data.roller_diameter, *s.c.mechanism.pitch_diameter.roller);
}
std::string load_text(const CompleteScrew& s) { return written_or(s.data, "load", kilonewton(s.load)); }
/// Speed with which the screw drives a load in tension or in compression. For a speed along the axis the hand of the
/// thread does not matter.
std::string speed_text(const CompleteScrew& s, Direction direction) {
  const std::string text = written_or(s.data, "speed", rpm(s.speed));
  const bool turns_back = s.c.mechanism.lead < 0.0 && !input::is_travel_speed(text);
  return (turns_back == (direction == Direction::tension) ? "-" : "") + text;
}

using ModelOf = ModelOptions::Mechanism;

bool on_nut(const CompleteScrew& s) { return carrier_part(s.data.type) == Part::nut; }
bool is_grooved(const CompleteScrew& s) { return contact::is_grooved(s.data.type); }

std::string case_heading(const CompleteScrew& s, const std::string& origin) {
  const Mechanism& m = s.c.mechanism;
  const bool right_handed = on_nut(s) == (m.lead > 0.0);
  const std::string_view type = contact::facts_of(m.type).name;
  std::string text =
      case_remark(fmt::format("{} {} planetary roller screw, {} x {}.", type.starts_with('i') ? "An" : "A", type,
                              diameter_text(s.data), lead_text(s.data)));
  text += "#\n" + case_remark(origin);
  text += case_remark(
      "What was not given is marked `assumed`, with its value and the reason: replace what you "
      "know; what differs from its mark counts as given. The rules, and how near they come to "
      "makers' screws, stand in docs/new_case.md.");
  text +=
      "#\n"
      "#   prs check FILE --all             every value, its default, what is unusual\n"
      "#   prs contact FILE                 contact points, ellipses, backlash\n"
      "#   prs solve FILE --output out      load per thread, stiffness, pressures, pictures\n"
      "#   prs slip FILE --output out       slip, friction, lost power, efficiency, pictures\n"
      "#   prs measures FILE                capacities, weight, inertia, buckling, critical speed\n"
      "#   prs life FILE                    life under the loads of `life`\n"
      "#\n";
  const std::string without_play =
      fmt::format("Without backlash: nut {:.4f} mm, screw {:.4f} mm, centre distance {:.4f} mm. Up to {} rollers fit; ",
                  1e3 * s.pitch_diameter.nut, 1e3 * s.pitch_diameter.screw, 1e3 * s.centre_distance, s.most_rollers);
  if (is_grooved(s))
    return text + case_remark(fmt::format(
                      "Rollers of {} with grooves, without helix and teeth, run along the nut by a lead per orbit and "
                      "are led back in a recess. {}any number of them meets both threads at equal spacing, each {:.6g} "
                      "mm further along the axis than the one before, to whole pitches.",
                      mm(s.pitch_diameter.roller), without_play, 1e3 * m.lead / m.rollers));
  text +=
      case_remark(fmt::format("Rollers of {}, {}-handed, keep their place on the {}, whose diameter is {:.6g} times "
                              "theirs. "
                              "{}any number of them meshes at equal spacing. From one place to the next a roller goes "
                              "in "
                              "turned by {:.6g} deg against the carrier, in the sense in which the places are counted.",
                              mm(s.pitch_diameter.roller), right_handed ? "right" : "left", name(carrier_part(m.type)),
                              static_cast<double>(m.starts.screw) / m.starts.roller, without_play,
                              indexing_angle(m.type, m.starts, m.rollers) * 180.0 / std::numbers::pi));
  if (s.gears.empty())
    text += case_remark("Gears: no pair of standard module fits; see `prs configurations`.");
  else
    text += case_remark(
        fmt::format("Gears: {} teeth on the rollers, {} {}, module {:.4g} mm, working pressure angle {:.2f} "
                    "deg, profile shifts {:+.2f} in all. `prs configurations` lists others.",
                    s.gears.front().roller_teeth, s.gears.front().body_teeth,
                    on_nut(s) ? "in the nut's rings" : "on the screw", s.gears.front().module * 1e3,
                    s.gears.front().working_pressure_angle * 180.0 / std::numbers::pi, s.gears.front().profile_shift));
  return text;
}

std::string thread_text(const CompleteScrew& s) {
  const Mechanism& m = s.c.mechanism;
  if (!m.thread.screw)
    return case_remark(
        "thread heights are left out: contacts lie beyond crests of 0.15 pitches, as makers have "
        "them; flanks end where they meet",
        2);
  const double pitch = axial_pitch(m);
  const PerPart<double> nominal = nominal_radii(s.data, s.pitch_diameter.roller);
  const auto outer = [&](Part p, double direction) {
    return 0.5 * s.pitch_diameter[p] + direction * m.thread[p]->addendum;
  };
  const PerPart<double> crest = {outer(Part::screw, 1.0) - nominal.screw, outer(Part::roller, 1.0) - nominal.roller,
                                 nominal.nut - outer(Part::nut, -1.0)};
  const double lowest = std::min({crest.screw, crest.roller, crest.nut});
  const double root = m.thread.roller->dedendum;
  const bool as_makers = lowest > 0.999 * kCrestHeight * pitch && root > 0.999 * kMeshedRootDepth * pitch;
  std::string lines, value;
  for (const Part p : kParts) {
    const std::string part = fmt::format("{}: {{addendum: {}, dedendum: {}}}", name(p), mm(m.thread[p]->addendum),
                                         mm(m.thread[p]->dedendum));
    lines += "    " + part + "\n";
    value += (value.empty() ? "{" : ", ") + part;
  }
  const std::string reason = fmt::format(
      "crests {:.2g} pitches beyond diameters of {}, {} and {}, roots {:.2g} from the pitch line, "
      "{}. At the static capacity ellipses reach beyond such crests: `prs life` has the load at "
      "the edge, and warns where yours comes near",
      lowest / pitch, mm(2.0 * nominal.screw), mm(2.0 * nominal.roller), mm(2.0 * nominal.nut), root / pitch,
      as_makers ? "after outer and root diameters of a catalogue" : "as far as these flanks reach: makers have more");
  return case_remark(assumption(value + "}", reason), 2) + "  thread:\n" + lines;
}

std::string mechanism_text(const CompleteScrew& s) {
  const Mechanism& m = s.c.mechanism;
  const ScrewData& d = s.data;
  const std::string rule = on_nut(s) ? fmt::format("threads over {:g} of the nut's length", kThreadedShare)
                                     : fmt::format(
                                           "threads over {:g} screw diameters, as on a published "
                                           "screw, but no more than {:g} of the nut's length",
                                           kInvertedThreads, kThreadedShare);
  return "\nmechanism:\n" +
         case_line(fmt::format("  type: {}", contact::facts_of(m.type).name),
                   std::string(contact::facts_of(m.type).meaning)) +
         case_line("  geometry: design", "assumed: roller, nut and centre distance follow") +
         case_line(fmt::format("  lead: {}", lead_text(d)), "given; < 0 left-handed") +
         case_line(fmt::format("  starts: {{screw: {}, roller: {}}}", m.starts.screw, m.starts.roller),
                   is_grooved(s)
                       ? d.starts ? assumption("{roller: 0}", "grooves; the screw's are given, the nut has as many")
                                  : "assumed: one start, and grooves on the rollers; the nut has the screw's"
                   : d.starts ? assumption(fmt::format("{{roller: {}}}", m.starts.roller),
                                           "rollers with as few starts as mesh; the screw's are given, the nut "
                                           "has as many")
                              : fmt::format("assumed: of 5, 4, 3 the first whose rollers are {} or "
                                            "thicker, as in makers' catalogues; the nut has the screw's",
                                            mm(kThinnestRoller))) +
         case_line(fmt::format("  flank_angle: {}", degrees(d.flank_angle)),
                   "assumed: as on nearly all screws; one value, or {screw: .., roller: .., nut: ..}") +
         (is_grooved(s)
              ? case_line(fmt::format("  pitch_diameter: {{screw: {}, roller: {}}}", diameter_text(d),
                                      roller_diameter_text(s)),
                          d.roller_diameter ? "given"
                                            : assumption(fmt::format("{{roller: {}}}", roller_diameter_text(s)),
                                                         "the diameter that a standard screw of three starts has; any "
                                                         "other rolls as well. The screw's is given"))
              : case_line(fmt::format("  pitch_diameter: {{screw: {}}}", diameter_text(d)),
                          "given: weights in catalogues show that the nominal diameter is this one")) +
         case_line("  backlash: {screw: 0 mm, nut: 0 mm}",
                   "assumed: a nut without play; take a half of yours for each") +
         case_line(
             fmt::format("  profile: {{screw: straight, roller: {{convex: {}}}, nut: straight}}",
                         length_text(d, "roller_profile_radius", d.roller_profile_radius, m.profile.roller.radius)),
             d.roller_profile_radius
                 ? assumption("{screw: straight, nut: straight}", "as of most published screws; the radius is given")
                 : fmt::format("assumed: screw and nut straight, rollers with arcs of {:g} "
                               "pitches: with it, as in makers' catalogues, the "
                               "static capacity hardly depends on the lead. No catalogue prints "
                               "it, and pressures depend on it: ask the maker, or measure",
                               kProfileRadius)) +
         thread_text(s) +
         case_line(fmt::format("  rollers: {}", m.rollers),
                   origin_of(d.rollers.has_value(), "as many as fit with half a pitch between their crests")) +
         (is_grooved(s) ? case_line("  rollers_unloaded: 1", "assumed: of these, in the recess, carries nothing")
                        : "") +
         case_line(fmt::format("  contacts_per_roller: {}", m.contacts_per_roller), "assumed: " + rule);
}

std::string structure_text(const CompleteScrew& s, ModelOf model) {
  const Structure& of = *s.c.structure;
  const ScrewData& d = s.data;
  const bool standard = on_nut(s), full = model == ModelOf::full;
  const std::string nut_length = length_text(d, "nut_length", d.nut_length, of.nut.length);
  return "\nstructure:\n" +
         case_line(fmt::format("  screw: {{bore: 0 mm, free_length: {}{}}}", mm(of.screw.free_length),
                               full ? ", far_length: 0 mm" : ""),
                   fmt::format("assumed: solid; loaded at {}, add your shaft's length{}",
                               standard ? "the nut's face" : "the end of the rollers",
                               full ? "; far_length: of the shaft behind the last contact" : "")) +
         (full ? case_remark("Assumed: the rollers alone hold the screw across its axis; bearings of its "
                             "shaft: see `bearings` in docs/full_mechanism.md",
                             2)
               : "") +
         case_line(fmt::format("  roller: {{end_length: {}, end_diameter: {}, guidance: "
                               "both_end_nodes{}}}",
                               mm(of.roller.end_length), mm(of.roller.end_diameter),
                               !full      ? ""
                               : standard ? ", rings: nut"
                                          : ", rings: screw"),
                   is_grooved(s)
                       ? "assumed: ends without teeth, which the cage guides, as long as the toothed ends of a "
                         "standard screw: over 0.9 of the length that the grooves leave in the nut"
                   : standard ? "assumed: toothed ends over 0.9 of the length that the threads leave in "
                                "the nut, 0.92 of the rollers' diameter, after inertias of a catalogue"
                              : "assumed: toothed ends 0.7 of the rollers' diameter long and 0.92 thick") +
         "  nut:\n" +
         case_line(fmt::format("    length: {}", nut_length),
                   origin_of(d.nut_length.has_value(),
                             standard ? fmt::format("{:g} times the nut's pitch diameter and {}, 0.84 to 1.15 "
                                                    "times the lengths of a catalogue, with threads of no more "
                                                    "than {:g} roller diameters",
                                                    kNutLengthSlope, mm(kNutLengthOffset), kSlendernessOfRollers)
                                      : fmt::format("{:g} times the rollers' threads, so that these can "
                                                    "travel: take stroke and threads",
                                                    kInvertedNut))) +
         case_line(fmt::format("    outer_diameter: {}",
                               length_text(d, "nut_diameter", d.nut_diameter, of.nut.outer_diameter)),
                   origin_of(d.nut_diameter.has_value(),
                             fmt::format("{:g} times the nut's pitch diameter and {}, 0.96 to 1.03 times "
                                         "the diameters of a catalogue",
                                         kNutDiameterSlope, mm(kNutDiameterOffset))) +
                       "; a plain cylinder") +
         case_line(fmt::format("    thrust: {{tension: 0 mm, compression: {}}}", nut_length),
                   "assumed: the housing holds the nut at its end faces; with a flange, see "
                   "`structure.nut.flanges`") +
         (full ? case_line("    housing: {axial: rigid, lateral: rigid, tilt: rigid}",
                           "assumed: the nut's seat does not give; or as 5e5 N/mm, 2e5 N m/rad")
               : "");
}

/// Model, and inputs common to all rollers that are not loads.
std::string model_text(ModelOf model) {
  if (model == ModelOf::sector)
    return case_line("model: {bodies: refined}",
                     "assumed: bars are faster but stiffer, influence is slower: see `prs compare`");
  return case_line("model: {mechanism: full, bodies: refined}",
                   assumption("{bodies: refined}", "on a screw and a nut that bend; bars are faster but stiffer")) +
         case_remark(
             "Assumed: equal rollers, all there, and nominal threads; one value per roller or "
             "start, in braces: deviations: {roller_diameter: [..], missing_rollers: [1], "
             "index_error: {screw: [..]}, thread_eccentricity: {screw: {y: 4 um, z: 0 um}}}");
}

/// Lateral loads and misalignment of one load case, `line` between lines.
std::string spatial_text(ModelOf model, std::string_view line) {
  if (model == ModelOf::sector) return "";
  return fmt::format(
      ",{0}eccentricity: {{y: 0 mm, z: 0 mm}}, side_force: {{y: 0 N, z: 0 N}},{0}"
      "moment: {{y: 0 N m, z: 0 N m}}, misalignment: {{nut_tilt: {{y: 0 mrad, z: 0 mrad}}}}",
      line);
}

std::string loads_text(const CompleteScrew& s, ModelOf model) {
  const ScrewData& d = s.data;
  const std::string force = fmt::format(", axial_force: {}", load_text(s));
  const auto load_case = [&](const char* name, const std::string& load, std::string_view line) {
    const bool is_tension = name == std::string_view("tension");
    return fmt::format("{{name: {0}{1}, direction: {0}, position: {2}{3}{4}}}", name, load, mm(s.position),
                       is_tension ? "" : fmt::format(", speed: {}", speed_text(s, Direction::compression)),
                       spatial_text(model, line));
  };
  const auto in_mark = [&](const char* name) { return load_case(name, d.load ? std::string() : force, " "); };
  const auto in_file = [&](const char* name) { return load_case(name, force, "\n     "); };
  return "\n" + model_text(model) +
         case_remark(assumption(
             fmt::format("[{}, {}]", in_mark("tension"), in_mark("compression")),
             (d.load ? "the force is given"
                     : fmt::format("the load of {:g} GPa with equal thread loads, 9 % of the static "
                                   "capacity by 4.0 GPa, but no more than {:g} MPa in the "
                                   "screw and {:g} times what brings an ellipse to the end of a "
                                   "flank",
                                   1e-9 * kModeratePressure, 1e-6 * kModerateStress, kModerateEdgeShare)) +
                 "; rollers in the middle of the nut. The screw drives in both cases." +
                 (model == ModelOf::full ? " In line, no load across the axis; y and z lie across it, roller 1 "
                                           "on y. What a turn of the carrier does: add `orbit: {steps: 8}`."
                                         : ""))) +
         "load_cases:\n  - " + in_file("tension") + "\n  - " + in_file("compression") + "\n\n" +
         case_line(
             fmt::format("operation: {{speed: {}}}", speed_text(s, Direction::tension)),
             origin_of(d.speed.has_value(), "a half of 150,000 mm/min over the screw's diameter, which makers allow"));
}

std::string lubricant_text(const CaseLubricant& l) {
  const bool assumed_temperature = l.temperature_as_written.empty();
  const std::string name = "name: " + l.name,
                    temperature =
                        "temperature: " + (assumed_temperature ? celsius(l.temperature) : l.temperature_as_written);
  const std::string assumed = l.assumed && assumed_temperature ? name + ", " + temperature
                              : l.assumed                      ? name
                              : assumed_temperature            ? temperature
                                                               : "";
  return case_line(fmt::format("lubricant: {{{}, {}}}", name, temperature),
                   assumed.empty()
                       ? "given"
                       : assumption("{" + assumed + "}",
                                    l.assumed ? "a common grade; others: `prs list lubricants`" : "of an oil at work"));
}

/// Proposed length of the shaft between its supports [m].
double shaft_length(const CompleteScrew& s) { return 20.0 * s.data.screw_diameter; }

std::string heat_text(const CompleteScrew& s) {
  const Heat::Conductance k = estimated_conductance(s, shaft_length(s));
  return case_remark(fmt::format("For temperatures that follow from the losses, with `prs slip`, for example the next "
                                 "two lines. Assumed: bare nut and shaft in still air, {:g} W/(m^2 K), and conduction "
                                 "through the contact spots alone. A housing, grease and motion take several times as "
                                 "much.",
                                 kStillAir)) +
         fmt::format(
             "# heat: {{ambient: 25 degC, conductance: {{screw_ambient: {:.2g} W/K, "
             "nut_ambient: {:.2g} W/K,\n"
             "#   screw_rollers: {:.2g} W/K, rollers_nut: {:.2g} W/K}}}}\n",
             k.screw_ambient, k.nut_ambient, k.screw_rollers, k.rollers_nut);
}

/// Lead deviation that ISO 3408-3 allows in 300 mm of a screw of grade 5 [m].
constexpr double kGradeFive = 23e-6;

std::string deviations_text(const CompleteScrew& s) {
  const Mechanism& m = s.c.mechanism;
  const double length = (m.contacts_per_roller - 1) * axial_pitch(m);
  return case_remark(fmt::format("Parts are perfect here. For real ones state what you measured or allow; on a screw "
                                 "of grade 5 of ISO 3408-3, {:g} um in 300 mm, over the contacts of a roller:",
                                 1e6 * kGradeFive)) +
         fmt::format("# deviations: {{pitch_error: {{screw: {{linear: {:.2g} um}}}}}}\n",
                     1e6 * kGradeFive * length / 0.3);
}

std::string rest_text(const CompleteScrew& s, const CaseLubricant& lubricant) {
  return case_line(fmt::format("friction: {{model: {{coulomb: {:g}}}}}", kFlankFriction),
                   "assumed: flanks that touch, with the heads' friction 0.89 to 1.05 times the "
                   "efficiencies of a catalogue; jacod: full films") +
         lubricant_text(lubricant) +
         case_line("roughness: 0.2 um", "assumed: Rq of finely ground flanks; for the film ratio") +
         case_line(fmt::format("carrier: {{bearing: {{length: {}, diameter: {}, radial_clearance: {}, friction: "
                               "{{mixed: {{boundary: 0.1, roughness: 0.4 um}}}}}}}}",
                               mm(kHeadLength * s.pitch_diameter.roller), mm(kHeadDiameter * s.pitch_diameter.roller),
                               mm(kHeadClearance * s.pitch_diameter.roller)),
                   "assumed: plain bearings of the rollers' ends, which guide the rollers and touch in part; "
                   "{coulomb: 0.1} where they run dry") +
         heat_text(s) + deviations_text(s) + "\nlife:\n" +
         case_line(fmt::format("  position: {}", mm(s.position)), "assumed: rollers in the middle of the nut") +
         case_line(fmt::format("  spectrum: [{{force: {}, direction: tension, share: 1}}]", load_text(s)),
                   (s.data.load ? assumption("[{direction: tension, share: 1}]", "") : std::string(kAssumed)) +
                       "one load all the time; or several with their shares, or `history`, a file") +
         "  # dynamic_capacity: .. kN             # of your catalogue, in place of Lemor's "
         "formula\n"
         "  # static_capacity: .. kN\n"
         "\nmeasures:\n" +
         case_line("  friction_coefficient: 0.01",
                   "assumed: of the whole screw, for the estimate of "
                   "efficiency") +
         case_line("  yield_strength: 700 MPa", "assumed: core of a hardened screw, for buckling") +
         case_line(fmt::format("  shaft: {{length: {}, ends: fixed_supported}}", mm(shaft_length(s))),
                   "assumed: 20 screw diameters between the supports") +
         "  # loaded_width: .. mm                # of a thread under one contact, for its tooth\n";
}

}  // namespace

std::string screw_case(const CompleteScrew& screw, const CaseLubricant& lubricant, const std::string& origin,
                       ModelOf model) {
  required_capacity(screw);
  return screw_text(screw, origin, model) + loads_text(screw, model) + rest_text(screw, lubricant);
}

std::string screw_text(const CompleteScrew& screw, const std::string& origin, ModelOf model) {
  return case_heading(screw, origin) + mechanism_text(screw) + structure_text(screw, model) + "\n" +
         case_line(fmt::format("materials: {{youngs_modulus: {:g} GPa, poisson_ratio: {:g}, density: "
                               "{:g} kg/m^3, thermal_expansion: {:g} um/m/K}}",
                               1e-9 * kSteel.youngs_modulus, kSteel.poisson_ratio, *kSteel.density,
                               1e6 * *kSteel.thermal_expansion),
                   "assumed: steel; density of a catalogue's screws");
}

CompleteScrew as_written(CompleteScrew s) {
  const auto write = [](double& length) { length = *input::parse_quantity(mm(length), input::unit::length).value; };
  if (!s.data.roller_profile_radius) write(s.c.mechanism.profile.roller.radius);
  for (const Part p : kParts)
    if (std::optional<ThreadHeight>& height = s.c.mechanism.thread[p]) write(height->addendum), write(height->dedendum);
  Structure& of = *s.c.structure;
  for (double* length : {&of.screw.free_length, &of.roller.end_length, &of.roller.end_diameter}) write(*length);
  if (!s.data.nut_length) write(of.nut.length);
  if (!s.data.nut_diameter) write(of.nut.outer_diameter);
  of.nut.thrust.compression = of.nut.length;
  write(s.position);
  return s;
}

/// With n starts the ratio is cos(alpha)/n, inverted cos(alpha)/(n + 2).
double required_capacity(const CompleteScrew& s) {
  const Contacts contacts = find_contacts(s.c.mechanism, s.c.materials, Detail::numbers);
  const PerInterface<InterfaceContact>& of = contacts.interfaces;
  const LemorGeometry g =
      lemor_geometry(contacts.mechanism, contact_angle({of.screw.normal_angle(), of.nut.normal_angle()}));
  if (const std::optional<LemorCapacity> found = lemor_capacity(g)) return found->capacity;
  if (is_grooved(s))
    throw CaseError(
        "roller_diameter",
        fmt::format("got {}; Lemor's capacity, which `life` needs, is not known for this ratio to the nut's "
                    "{}; take one nearer to the screw's",
                    mm(s.pitch_diameter.roller), mm(s.pitch_diameter.nut)));
  const int starts = s.c.mechanism.starts.screw, more = 2 - contact::facts_of(s.data.type).starts_over_diameters;
  throw CaseError("starts",
                  fmt::format("got {}; expected at most {:.0f}: rollers of {:.3g} mm are too thin for this "
                              "nut: Lemor's "
                              "capacity, which `life` needs, is not known for this ratio of diameters; take "
                              "fewer starts",
                              starts, std::floor((starts + more) * factor_ratio(g) / kFactorRatios.least) - more,
                              1e3 * s.pitch_diameter.roller));
}

ScrewData data_of(const Configuration& c) {
  ScrewData d;
  d.type = c.mechanism.type;
  d.screw_diameter = *c.mechanism.pitch_diameter.screw;
  d.lead = c.mechanism.lead;
  d.starts = c.mechanism.starts.screw;
  d.roller_starts = c.mechanism.starts.roller;
  d.flank_angle = c.mechanism.flank_angle.screw;
  d.rollers = c.mechanism.rollers;
  d.roller_profile_radius = c.mechanism.profile.roller.radius;
  d.roller_diameter = c.mechanism.pitch_diameter.roller;
  d.nut_diameter = c.nut_diameter;
  return d;
}

std::string configuration_case(const Configuration& c) {
  return screw_case(
      complete_screw(data_of(c)), {},
      fmt::format("Given by `prs configurations`: screw diameter, lead, starts, rollers, profile radius of "
                  "the rollers{}{}.",
                  c.mechanism.pitch_diameter.roller ? ", roller diameter" : "",
                  c.nut_diameter ? ", nut diameter" : ""));
}

}  // namespace prs
