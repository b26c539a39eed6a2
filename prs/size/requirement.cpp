#include "prs/size/requirement.h"

#include <nlohmann/json.hpp>
#include <tuple>

#include "prs/configurations/screw_case.h"
#include "prs/input/described_file.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"

namespace prs {

std::vector<double> DesignValues::values() const {
  if (!span) return list;
  std::vector<double> all;
  if (!span->series) {
    const int steps = span->steps.value_or(1);
    for (int k = 0; k < steps; ++k)
      all.push_back(k + 1 == steps ? span->to : span->from + (span->to - span->from) * k / (steps - 1));
    return all;
  }
  constexpr int kR40[] = {100, 106, 112, 118, 125, 132, 140, 150, 160, 170, 180, 190, 200, 212,
                          224, 236, 250, 265, 280, 300, 315, 335, 355, 375, 400, 425, 450, 475,
                          500, 530, 560, 600, 630, 670, 710, 750, 800, 850, 900, 950};
  const int stride = 8 >> static_cast<int>(*span->series);
  for (int power = -4; power <= 4; ++power)
    for (int k = 0; k < 40; k += stride) {
      const double hundredths = kR40[k] * std::pow(10.0, std::max(power, 0));
      const double value = hundredths / (1e5 * std::pow(10.0, std::max(-power, 0)));
      if (value >= span->from * (1.0 - 1e-12) && value <= span->to * (1.0 + 1e-12)) all.push_back(value);
    }
  return all;
}

namespace input {
namespace {

/// One value, a list of them, or a range.
template <class Kind>
struct OneListOrRange {
  Kind kind;
};
template <class Kind>
OneListOrRange(Kind) -> OneListOrRange<Kind>;

/// One value or a list of at least one.
template <class Kind>
struct OneOrList {
  Kind kind;
};
template <class Kind>
OneOrList(Kind) -> OneOrList<Kind>;
template <class T, class Kind>
Value value_of(std::vector<T>& list, const OneOrList<Kind>& how) {
  return {OneOr{.form = OneOr::Form::rollers,
                .one =
                    [&list, kind = how.kind] {
                      if (list.empty()) list.resize(1);
                      return value_of(list.front(), kind);
                    },
                .several =
                    [&list, kind = how.kind] {
                      return value_of(list, List{kind, 1});
                    },
                .others = ", or a list of them",
                .are_several = list.size() > 1}};
}

template <class Kind>
Value value_of(DesignValues& values, const OneListOrRange<Kind>& how) {
  return {OneOr{.form = OneOr::Form::range,
                .one = [&values, how] { return value_of(values.list, OneOrList{how.kind}); },
                .several =
                    [&values, how] {
                      if (!values.span) values.span = DesignValues::Span{};
                      DesignValues::Span& span = *values.span;
                      return Value{map_of([&span, how](const Fields& io) {
                        io("from", span.from, how.kind, required, "First value");
                        io("to", span.to, how.kind, required, "Last value");
                        io("steps", span.steps, Whole{1, kMostSteps}, "Number of values, ends included");
                        io("series", span.series, Choice{}, required_only_if(!span.steps, "in place of `steps`"),
                           "Preferred numbers of ISO 3, in mm");
                      })};
                    },
                .others = ", or a range {from, to, steps} or {from, to, series}",
                .are_several = values.span.has_value()}};
}

}  // namespace

void alternatives(Choices& io, DesignValues::Series& s) {
  using enum DesignValues::Series;
  io("R5", s, R5, "5 per decade");
  io("R10", s, R10, "10 per decade");
  io("R20", s, R20, "20 per decade");
  io("R40", s, R40, "40 per decade");
}

void alternatives(Choices& io, Requirement::Basis& b) {
  io("maker", b, Requirement::Basis::maker, "the formulas of catalogues, with C_a and C_0 as printed, else computed");
  io("threads", b, Requirement::Basis::threads, "the loads of the threads, as `prs life`");
}

void alternatives(Choices& io, Requirement::Losses& l) {
  io("slip", l, Requirement::Losses::slip, "by slip, at each load and speed");
  io("catalogue", l, Requirement::Losses::catalogue, "by the efficiencies of the catalogue");
}

void alternatives(Choices& io, Requirement::Objective& o) {
  using enum Requirement::Objective;
  io("weight", o, weight, "lightest first");
  io("nut_diameter", o, nut_diameter, "smallest first");
  io("life", o, life, "longest first");
  io("motor_torque", o, motor_torque, "least rms torque first");
  io("power_lost", o, power_lost, "least first");
}

constexpr std::string_view kAlong = "without `linkage`", kOfLever = "only with `linkage`";

/// Speed along the axis or of a lever.
static Quantity speed_of(bool is_lever) {
  // A lever has no lead, by which a speed along the axis would be one of its speeds.
  static const Dimension of_lever = [] {
    Dimension turning = unit::rotational_speed;
    turning.by_lead = nullptr;
    return turning;
  }();
  return is_lever ? Quantity{of_lever, unbounded, "30 deg/s"} : Quantity{unit::travel_speed};
}

/// A block whose keys are those along the axis or those of a lever.
struct BlockOf {
  bool is_lever;
};
template <class T>
Value value_of(T& block, const BlockOf& kind) {
  return {map_of([&block, kind](const Fields& io) { fields(io, block, kind.is_lever); })};
}

void fields(const Fields& io, Requirement::Segment& s, bool is_lever) {
  io("name", s.name, Text{"lift"}, "`segment-K` by default, K from 1");
  io("duration", s.duration, Quantity{unit::duration, positive, "0.2 s"}, required, "Of constant acceleration");
  io("end_speed", s.end_speed, speed_of(is_lever), required, "Signed, at the end; with `linkage` of the lever");
  io("force", s.force, Quantity{unit::force}, optional_only_if(!is_lever, kAlong),
     "External, > 0 against the positive sense");
  io("torque", s.torque, Quantity{unit::torque}, optional_only_if(is_lever, kOfLever),
     "External, at the lever, > 0 against growing angles");
}

void fields(const Fields& io, Requirement::ConstantLoad& l) {
  io("name", l.name, Text{"press"}, "`segment-K` by default, K from 1");
  io("force", l.force, Quantity{unit::force}, "External, > 0 against the positive sense");
  io("speed", l.speed, Quantity{unit::travel_speed}, required, "Constant, signed");
  io("share", l.share, Quantity{unit::share, {.least = 0.0, .greatest = 1.0, .least_excluded = true}, "30 %"}, required,
     "Of the time");
}

void fields(const Fields& io, Requirement::History& h, bool is_lever) {
  io("file", h.file, Text{"cycle.csv"}, required,
     "Comma-separated values with a heading, one row per sample; relative to this file");
  const auto column = [](CsvColumn& c) {
    return Keys{[&c](const Fields& of) {
      of("column", c.column, Text{"F"}, "Its name in the heading; by default the key");
      of("unit", c.unit, Text{"kN"}, required, "Of its numbers");
    }};
  };
  io("time", h.time, column(h.time), required, "Time of the sample");
  io("speed", h.speed, column(h.speed), required_only_if(!is_lever, kAlong), "Signed, along the axis");
  io("force", h.force, column(h.force), required_only_if(!is_lever, kAlong),
     "External, > 0 against the positive sense");
  io("angle", h.angle, column(h.angle), required_only_if(is_lever, kOfLever), "Of the lever, between base and arm");
  io("torque", h.torque, column(h.torque), required_only_if(is_lever, kOfLever),
     "External, at the lever, > 0 against growing angles");
}

void fields(const Fields& io, Requirement::Motion& m, bool is_lever) {
  io("segments", m.segments, List{BlockOf{is_lever}, 1}, "Constant accelerations one after the other");
  io("history", m.history, BlockOf{is_lever}, "Samples from a file, in place of `segments`");
  io("loads", m.loads, List{Block{}, 1}, optional_only_if(!is_lever, kAlong),
     "Constant speeds and their shares of time, in their place");
  io("start_speed", m.start_speed, speed_of(is_lever), optional_only_if(m.segments.has_value(), "with `segments`"),
     "Before the first segment");
  io("start_angle", m.start_angle, Quantity{unit::angle, unbounded, "60 deg"},
     required_only_if(is_lever && m.segments.has_value(), "only with `segments` and `linkage`"),
     "Of the lever before the first segment, between base and arm");
  io("period", m.period, Quantity{unit::duration, positive}, optional_only_if(m.loads.has_value(), "with `loads`"),
     "Of the cycle; scales numbers per cycle");
}

void fields(const Fields& io, Requirement::Load& l, bool is_lever) {
  constexpr double kRight = 0.5 * std::numbers::pi;
  const Presence along = optional_only_if(!is_lever, kAlong);
  io("moved_mass", l.moved_mass, Quantity{unit::mass, not_negative, "50 kg"}, along, "Along the axis");
  io("inertia", l.inertia, Quantity{unit::inertia, not_negative, "2 kg m^2"}, optional_only_if(is_lever, kOfLever),
     "Of the lever about its joint");
  io("inclination", l.inclination, Quantity{unit::angle, {.least = -kRight, .greatest = kRight}}, along,
     "Of the axis; > 0: the positive sense goes up");
  io("guide_friction", l.guide_friction, Number{not_negative, "0.003"}, along,
     "Coefficient of the guides under the mass");
  io("resistance", l.resistance, Quantity{unit::force, not_negative, "20 N"},
     "Constant, against the motion, as of seals");
  io("drag_torque", l.drag_torque, Quantity{unit::torque, not_negative},
     "Constant, against the motion, at the part that turns, as of bearings");
  io("positive_force", l.positive_force, Choice{},
     "What a force > 0 is for the screw; compression by default, and then either sense buckles");
}

void fields(const Fields& io, Requirement::Shaft& s) {
  io("length", s.length, Quantity{unit::length, positive, "1 m"},
     "Between the supports; by default stroke, nut and two diameters");
  io("ends", s.ends, Choice{}, "How the screw is held at both ends of it");
}

void fields(const Fields& io, Requirement::Life& l) {
  io("hours", l.hours, Quantity{unit::hours, positive, "20000 h"}, "Least, rests included");
  io("distance", l.distance, Quantity{unit::distance, positive}, "Least travel, in place of `hours`");
  io("reliability", l.reliability, Quantity{unit::share, Bounds{.least = 0.90, .greatest = 0.99}},
     "Share of many screws that shall reach the life: a1 of ISO 281");
  io("modification_factor", l.modification_factor,
     Number{{.least = 0.0, .greatest = 50.0, .least_excluded = true}, "1.2"}, "a_ISO of ISO 281");
  io("basis", l.basis, Choice{}, "What life and static safety rest on");
}

/// Keys of a block of a case without some.
template <class T>
void fields_without(const Fields& io, T& block, std::initializer_list<std::string_view> keys) {
  const Fields::Take take = [&](const Field& field) {
    if (std::ranges::find(keys, field.key) == keys.end()) io.take(field);
  };
  fields(Fields(take), block);
}

void fields(const Fields& io, Requirement::Limits& l) {
  fields_without(io, static_cast<Limits&>(l), {"life", "peak_pressure"});
  io("back_driving", l.back_driving, Choice{}, "Whether the load may turn the screw");
  io("relubrication", l.relubrication, Quantity{unit::hours, positive, "500 h"}, "Least interval");
}

void fields(const Fields& io, Requirement::Conductance& c) {
  const Quantity conductance{unit::thermal_conductance, not_negative};
  io("screw_ambient", c.screw_ambient, conductance, "As in a case; by the rule of `prs new`");
  io("nut_ambient", c.nut_ambient, conductance, "The same");
  io("rollers_ambient", c.rollers_ambient, conductance, "The same; none by default");
  io("screw_rollers", c.screw_rollers, conductance, "The same");
  io("rollers_nut", c.rollers_nut, conductance, "The same");
}

void fields(const Fields& io, Requirement::Catalogue& c) {
  io("file", c.file, Text{"standard_screws.csv"}, required,
     "Comma-separated values, a screw per row; relative to this file");
  io("source", c.source, Text{"\"maker A\""}, "Of its rows, in the list of candidates; by default the file");
}

void fields(const Fields& io, Requirement::Designs& d) {
  const Quantity length{unit::length, positive, "30 mm"};
  const Number starts{{.least = 1.0, .greatest = 100.0}, "5"};
  io("type", d.type, OneOrList{Choice{}}, "standard by default");
  io("screw_diameter", d.screw_diameter, OneListOrRange{length}, required, "Nominal");
  io("lead", d.lead, OneListOrRange{Quantity{unit::length, not_zero, "10 mm"}}, required, "< 0 left-handed");
  io("starts", d.starts, OneListOrRange{starts}, "By the rule of `prs new`");
}

void fields(const Fields& io, Requirement& r) {
  io("linkage", r.linkage, Block{}, "Of a lever that the screw turns: `motion` then has its angle and torque");
  const bool is_lever = r.linkage.has_value();
  io("motion", r.motion, BlockOf{is_lever}, required, "One cycle, which is repeated");
  io("load", r.load, BlockOf{is_lever}, "What moves, and what resists");
  io("stroke", r.stroke, Quantity{unit::length, positive, "650 mm"},
     "By default the way between the extreme positions of the cycle");
  io("measures", r.measures, Keys{[&](const Fields& measures) {
       fields_without(measures, static_cast<MeasureOptions&>(r.measures), {"shaft", "system"});
       measures("shaft", r.shaft, Block{}, "Of the screw, for buckling and critical speed");
     }},
     "As in a case");
  io("bearings", r.bearings, Block{}, "As in a case");
  io("life", r.life, Block{"{hours: 20000 h}"}, "Required life");
  io("limits", r.limits, Block{}, "What candidates are held against");
  io("motor", r.motor, Block{}, "Without a limit there is no criterion");
  io("brake", r.brake_torque, Keys{[&](const Fields& brake) {
       brake("torque", *r.brake_torque, Quantity{unit::torque, positive, "4 N m"}, required, "At the motor's shaft");
       brake("safety", r.brake_safety, Number{{.least = 1.0}, "1.5"}, "Least torque over the holding torque");
     }},
     "Holds the axis at rest");
  io("preload", r.preload, Keys{[&](const Fields& of) {
       of("force", r.preload->force, Quantity{unit::force, positive, "2 kN"}, "Of each flank without load");
       of("share", r.preload->share,
          Quantity{unit::share, {.least = 0.0, .greatest = 0.5, .least_excluded = true}, "5 %"},
          "The same as a share of C_a, of the row or else Lemor's; in place of `force`");
     }},
     "Of a single nut with oversized rollers");
  io("losses", r.losses, Choice{}, "Where efficiencies come from");
  io("model", r.loads,
     Keys{[&](const Fields& model) { model("loads", r.loads, Choice{}, "Of the threads, for slip and life"); }},
     "Choices of the model");
  io("friction", r.friction, ChoiceUnder{"model"}, "As in a case");
  io("lubricant", r.lubricant, Block{}, "As in a case");
  const Bounds up_to_100_um{.least = 0.0, .greatest = 1e-4, .least_excluded = true};
  io("roughness", r.roughness, OneOrEach{Quantity{unit::length, up_to_100_um}}, "As in a case");
  io("carrier", r.carrier, Block{}, "As in a case");
  io("heat", r.heat, Keys{[&](const Fields& heat) {
       heat("ambient", r.heat->ambient, Quantity{unit::temperature, positive}, "Temperature of the surroundings");
       heat("conductance", r.heat->conductance, Block{}, "Heat flow over temperature");
       mission_fields(heat, r.heat->cycles, r.heat->start, true);
     }},
     "How the parts get rid of the heat of friction; without it temperatures are not known");
  io("relubrication", r.relubrication, Keys{[&](const Fields& rule) {
       rule("static_load_factor", r.relubrication->static_load_factor, Number{positive, "0.24"}, required,
            "S of the actuator");
       rule("peak_force", r.relubrication->peak_force, Quantity{unit::force, positive}, required,
            "Printed, of the actuator");
     }},
     "Of the makers' rule for the interval");
  io("candidates", r.candidates, Keys{[&](const Fields& from) {
       from("catalogue", r.candidates.catalogue, OneOrList{Block{}}, "Of a maker, or of several");
       from("designs", r.candidates.designs, Block{}, "All combinations, by the rules of `prs new`");
     }},
     "What is chosen from; by default the catalogue of the program");
  io("objective", r.objective, Choice{}, "What orders the candidates that pass");
}

namespace {

Value description(Requirement& r) { return value_of(r, Block{}); }

/// Sets the defaults that depend on other values of the file.
void complete(Requirement& r) {
  if (!r.friction) r.friction = friction_by(contact::Coulomb{at_both(kFlankFriction)});
  if (!r.lubricant) {
    r.lubricant.emplace();
    const auto all = named_lubricants();
    const auto found = std::ranges::find(all, CaseLubricant{}.name, &NamedLubricant::name);
    r.lubricant->name = LubricantName(found - all.begin());
  }
  if (!r.lubricant->temperature && !r.lubricant->viscosity) r.lubricant->temperature = CaseLubricant{}.temperature;
  if (!r.roughness) r.roughness = {2e-7, 2e-7, 2e-7};
  if (!r.life.basis)
    r.life.basis = r.candidates.designs || r.preload ? Requirement::Basis::threads : Requirement::Basis::maker;
}

/// Checks contradictions between values.
class Checker {
 public:
  Checker(const Requirement& r, const Node& root, ErrorList& errors) : r_(r), root_(root), errors_(errors) {}

  void check() {
    check_motion();
    if (r_.life.hours && r_.life.distance)
      refuse("life.distance", "stands next to `hours`; expected one of them; delete one");
    for (const Problem& wrong : check_drive_motor(r_.motor)) refuse(wrong.path, "{}", wrong.message);
    if (r_.preload && r_.preload->force.has_value() == r_.preload->share.has_value())
      refuse("preload", "got {}; expected exactly one of force, share; write `{{share: 5 %}}`, for example",
             r_.preload->force ? "both" : "neither");
    const double ambient = r_.heat.value_or(Requirement::Surroundings{}).ambient;
    if (r_.limits.temperature && !(*r_.limits.temperature > ambient))
      refuse("limits.temperature",
             "got {:.6g} degC; expected more than the surroundings have, heat.ambient: {:.6g} "
             "degC; raise the limit",
             *r_.limits.temperature - 273.15, ambient - 273.15);
    check_candidates();
    if (!r_.heat) return;
    if (const std::string wrong = wrong_start(r_.heat->start, r_.limits); !wrong.empty())
      refuse("heat.start", "{}", wrong);
    if (r_.heat->cycles && r_.losses == Requirement::Losses::catalogue)
      refuse("heat.cycles",
             "got a mission together with `losses: catalogue`, which does not say where losses arise; expected "
             "`losses: slip`; delete one of them");
  }

  /// Checks its forces and names.
  void check(const MotionCycle& cycle) {
    const Requirement::Motion& m = r_.motion;
    const std::string_view form = m.segments ? "motion.segments" : m.loads ? "motion.loads" : "motion.history";
    std::set<std::string> names;
    for (const MotionSegment& s : m.history ? std::vector<MotionSegment>() : cycle.all) {
      if (s.name == kBackDriving)
        refuse(form,
               "got a segment called {}; expected another name: the case that is written has a "
               "load case of this one; rename it",
               s.name);
      if (!names.insert(s.name).second)
        refuse(form,
               "got two segments called {}, where one that changes its sense is NAME-a and NAME-b; "
               "expected different names; rename one",
               shown(s.name));
    }
    if (const std::string wrong = wrong_length(r_.heat ? r_.heat->cycles : std::nullopt,
                                               cycle.in_classes ? 2 * cycle.shown.size() : cycle.shown.size());
        !wrong.empty())
      refuse("heat.cycles", "{}", wrong);
    if (cycle.largest_force == 0.0)
      refuse(form, "got no force in the whole cycle; expected one; add {}, for example",
             r_.linkage ? "`torque: 2 kN m` to a segment or `load: {inertia: 50 kg m^2}`"
                        : "`force: 10 kN` to a segment or `load: {moved_mass: 50 kg}`");
    if (r_.stroke && !m.loads && *r_.stroke < cycle.way * (1.0 - 1e-9))
      refuse("stroke",
             "got {:.7g} mm; expected at least the way between the extreme positions of the cycle, "
             "{:.7g} mm; lengthen it, or leave it out",
             1e3 * *r_.stroke, 1e3 * cycle.way);
  }

 private:
  template <class... Args>
  void refuse(std::string_view path, fmt::format_string<Args...> message, Args&&... args) {
    input::refuse(root_, path, fmt::format(message, std::forward<Args>(args)...), errors_);
  }

  void check_motion() {
    const Requirement::Motion& m = r_.motion;
    std::vector<std::string_view> forms;
    if (m.segments) forms.emplace_back("segments");
    if (m.history) forms.emplace_back("history");
    if (m.loads) forms.emplace_back("loads");
    if (forms.empty())
      refuse("motion",
             "has none of segments, history, loads; expected one of them; add `segments: "
             "[{{duration: 1 s, end_speed: 100 mm/s, force: 10 kN}}]`, for example");
    else if (forms.size() > 1)
      refuse(fmt::format("motion.{}", forms[1]),
             "stands next to `{}`; expected one of segments, history, loads; delete one of the two", forms[0]);
    if (!m.loads) return;
    double sum = 0.0;
    for (const Requirement::ConstantLoad& l : *m.loads) sum += l.share;
    if (std::abs(sum - 1.0) > 1e-3)
      refuse("motion.loads",
             "got shares with the sum {:.6g} %; expected 100 %, within 0.1 %; fix a share, or add "
             "the rest at 0 mm/s",
             100.0 * sum);
  }

  void check_candidates() {
    const Requirement::Candidates& c = r_.candidates;
    if (!c.catalogue && !c.designs && find_path(root_, "candidates"))
      refuse("candidates",
             "is empty; expected `catalogue` or `designs`; delete it for the "
             "catalogue of the program");
    if (!c.designs) return;
    const Requirement::Designs& d = *c.designs;
    const auto check = [&](const char* key, const DesignValues& values) {
      if (!values.span) return;
      const DesignValues::Span& s = *values.span;
      const std::string path = fmt::format("candidates.designs.{}", key);
      if (s.to < s.from || (s.steps == 1 && s.to != s.from))
        refuse(path,
               "got a range whose `to` is not beyond `from`, or one step between different "
               "ends; expected a rising range; exchange the ends, or write `steps: 2`");
      else if (values.values().empty())
        refuse(path,
               "got a range without a number of its series; expected one between `from` and "
               "`to`; widen it");
    };
    check("screw_diameter", d.screw_diameter);
    check("lead", d.lead);
    if (!d.starts) return;
    check("starts", *d.starts);
    for (const double n : d.starts->values())
      if (n != std::round(n))
        return refuse("candidates.designs.starts", "got {:g}; expected whole numbers; write for example `[4, 5]`", n);
  }

  const Requirement& r_;
  const Node& root_;
  ErrorList& errors_;
};

/// Adds problems of the blocks that a case would have.
void check_blocks(const Requirement& r, const Node& root, ErrorList& errors) {
  Case c = complete_screw({.screw_diameter = 30e-3, .lead = 10e-3, .starts = 5}).c;
  c.load_cases = {{.name = "a", .axial_force = 1e3, .direction = Direction::tension, .position = 0.01}};
  c.friction = r.friction;
  c.lubricant = r.lubricant;
  c.roughness = r.roughness;
  c.carrier = r.carrier;
  c.bearings = r.bearings;
  c.operation = Operation{.speed = 1.0};
  if (r.heat) {
    const Requirement::Conductance& k = r.heat->conductance;
    c.heat = Heat{
        .ambient = r.heat->ambient,
        .conductance = {k.screw_ambient.value_or(1.0), k.nut_ambient.value_or(1.0), k.rollers_ambient.value_or(0.0),
                        k.screw_rollers.value_or(1.0), k.rollers_nut.value_or(1.0)}};
    c.heat->start = r.heat->start;
    if (r.has_mission())
      c.lubricant->temperature.reset();
    else
      c.heat->losses = Heat::Losses::stated;
  }
  for (const Problem& p : problems_of(c, Command::slip)) refuse(root, p.path, p.message, errors);
}

std::vector<MotionSegment> history_segments(const Requirement::History& h, const Source& source) {
  std::vector<double> t, v, f;
  std::vector<WantedColumn> columns{{"time", &h.time, &unit::duration, &t},
                                    {"speed", &h.speed, &unit::travel_speed, &v},
                                    {"force", &h.force, &unit::force, &f}};
  read_columns(named_file_text(h.file, kHistoryFile, source), name_in_messages(h.file, source), "motion.history",
               columns, source);
  constexpr double kRounding = 1e-9;  // Speed, as a share of the largest, that counts as zero in simulated data.
  double largest = 0.0;
  for (const double speed : v) largest = std::max(largest, std::abs(speed));
  for (double& speed : v)
    if (std::abs(speed) < kRounding * largest) speed = 0.0;
  std::vector<MotionSegment> segments;
  for (std::size_t k = 1; k < t.size(); ++k)
    if (t[k] > t[k - 1])
      segments.push_back({.name = fmt::format("sample-{}", k),
                          .duration = t[k] - t[k - 1],
                          .start_speed = v[k - 1],
                          .end_speed = v[k],
                          .external_force = 0.5 * (f[k - 1] + f[k]),
                          .force_of_samples = std::max(std::abs(f[k - 1]), std::abs(f[k]))});
  if (segments.empty())
    fail_at(source, kHistoryFile,
            "got {}, whose samples all have one time; expected a time that runs; check the column", h.file);
  return segments;
}

/// A lever at an instant. SI units.
struct LeverSample {
  double time = 0.0, angle = 0.0, speed = 0.0, torque = 0.0;
};

/// Motion of the axis between two samples of a lever: the torque M and the inertia J give the force
/// (M + J theta'')/g, the mean of both ends.
MotionSegment between(const Requirement& r, std::string name, const LeverSample& a, const LeverSample& b) {
  const PrsLever from = prs_lever(&*r.linkage, a.angle), to = prs_lever(&*r.linkage, b.angle);
  const double duration = b.time - a.time, inertia = r.load.inertia * (b.speed - a.speed) / duration;
  const double start = (a.torque + inertia) / from.ratio, end = (b.torque + inertia) / to.ratio;
  MotionSegment s{.name = std::move(name),
                  .duration = duration,
                  .start_speed = from.ratio * a.speed,
                  .end_speed = to.ratio * b.speed,
                  .external_force = 0.5 * (start + end),
                  .force_of_samples = std::max(std::abs(start), std::abs(end))};
  const double travel = to.length - from.length;
  if (s.start_speed * s.end_speed >= 0.0 && travel * (s.start_speed + s.end_speed) >= 0.0) s.own_travel = travel;
  return s;
}

/// Speed at the middle one of three samples by a parabola; 0 beside a rest.
double middle_speed(double before, double behind, double h0, double h1) {
  return before == 0.0 || behind == 0.0 ? 0.0 : (before * h1 + behind * h0) / (h0 + h1);
}

/// Samples of a file, in runs of equal times; their speeds are those of parabolas through three times.
std::vector<LeverSample> lever_history(const Requirement::History& h, const Source& source) {
  std::vector<double> t, angle, torque;
  std::vector<WantedColumn> columns{{"time", &h.time, &unit::duration, &t},
                                    {"angle", &h.angle, &unit::angle, &angle},
                                    {"torque", &h.torque, &unit::torque, &torque}};
  read_columns(named_file_text(h.file, kHistoryFile, source), name_in_messages(h.file, source), "motion.history",
               columns, source);
  const auto refuse = [&](std::size_t row, std::string_view what) {
    fail_at(source, "motion.history.angle", "got {:.6g} deg in row {} of {}, {}", angle[row] * "deg"_per_si, row + 1,
            h.file, what);
  };
  constexpr double kRounding = 1e-9;
  std::vector<std::size_t> first;  // First row of each time.
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (prs_is_dead_centre(angle[k]))
      refuse(k, "a dead centre; expected angles from 1 to 179 deg; check the column, its unit, base and arm");
    if (k == 0 || t[k] > t[k - 1])
      first.push_back(k);
    else if (std::abs(angle[k] - angle[k - 1]) > kRounding)
      refuse(k, "another angle at the same time; expected one; delete one of the rows");
  }
  if (first.size() < 2)
    fail_at(source, kHistoryFile,
            "got {}, whose samples all have one time; expected a time that runs; check the column", h.file);
  const std::size_t last = first.size() - 1;
  std::vector<double> step, slope, speed(first.size());
  for (std::size_t k = 0; k < last; ++k) {
    const double turned = angle[first[k + 1]] - angle[first[k]];
    step.push_back(t[first[k + 1]] - t[first[k]]);
    slope.push_back(std::abs(turned) > kRounding ? turned / step[k] : 0.0);
  }
  for (std::size_t k = 1; k < last; ++k) speed[k] = middle_speed(slope[k - 1], slope[k], step[k - 1], step[k]);
  speed[0] = slope[0] == 0.0 || last == 1 ? slope[0] : 2.0 * slope[0] - speed[1];
  speed[last] = slope[last - 1] == 0.0 || last == 1 ? slope[last - 1] : 2.0 * slope[last - 1] - speed[last - 1];
  std::vector<LeverSample> all;
  for (std::size_t k = 0, of = 0; k < t.size(); ++k) {
    if (of < last && k == first[of + 1]) ++of;
    all.push_back({t[k], angle[k], speed[of], torque[k]});
  }
  return all;
}

/// The motion along the axis of a lever, and the angles between which it turns.
struct LeverSegments {
  std::vector<MotionSegment> segments;
  std::array<double, 2> angles{HUGE_VAL, 0.0};

  void include(double angle) { angles = {std::min(angles[0], angle), std::max(angles[1], angle)}; }
};

/// Stated segments in steps of at most 0.2 deg, cut where the lever turns back.
LeverSegments stated_lever_segments(const Requirement& r, const Source& source) {
  constexpr double kStep = 0.2 * std::numbers::pi / 180.0, kMostSteps = 2000.0;
  LeverSegments motion;
  LeverSample at{0.0, *r.motion.start_angle, r.motion.start_speed, 0.0};
  for (std::size_t number = 0; number < r.motion.segments->size(); ++number) {
    const Requirement::Segment& s = (*r.motion.segments)[number];
    const std::string name = s.name.value_or(fmt::format("segment-{}", number + 1));
    const LeverSample start = at;
    const double rate = (s.end_speed - start.speed) / s.duration;
    const double turns = start.speed * s.end_speed < 0.0 ? -start.speed / rate : s.duration;
    const auto go_to = [&](double from, double to) {
      const double way = (start.speed + 0.5 * rate * (from + to)) * (to - from);
      const double steps = std::clamp(std::ceil(std::abs(way) / kStep), 1.0, kMostSteps);
      for (double k = 1.0; k <= steps; ++k) {
        const double t = from + (to - from) * k / steps;
        LeverSample next{start.time + t, start.angle + (start.speed + 0.5 * rate * t) * t, start.speed + rate * t,
                         s.torque};
        if (t == turns && turns < s.duration) next.speed = 0.0;
        if (prs_is_dead_centre(at.angle) || prs_is_dead_centre(next.angle))
          fail_at(source, "motion.segments",
                  "turns the lever to {:.6g} deg in {}, a dead centre; expected angles from 1 to 179 deg; change "
                  "start_angle, speeds or durations",
                  next.angle * "deg"_per_si, name);
        at.torque = s.torque;
        motion.segments.push_back(
            between(r, steps == 1.0 ? name : fmt::format("{}-{}", name, motion.segments.size() + 1), at, next));
        motion.include(at.angle), motion.include(next.angle);
        at = next;
      }
    };
    go_to(0.0, turns);
    if (turns < s.duration) go_to(turns, s.duration);
    at.speed = s.end_speed;
  }
  return motion;
}

LeverSegments all_lever_segments(const Requirement& r, const Source& source) {
  if (!r.motion.history) return stated_lever_segments(r, source);
  LeverSegments motion;
  const std::vector<LeverSample> all = lever_history(*r.motion.history, source);
  for (std::size_t k = 0; k < all.size(); ++k) {
    motion.include(all[k].angle);
    if (k > 0 && all[k].time > all[k - 1].time)
      motion.segments.push_back(between(r, fmt::format("sample-{}", k), all[k - 1], all[k]));
  }
  return motion;
}

std::vector<MotionSegment> segments_of(const Requirement::Motion& m, const Source& source) {
  if (m.history) return history_segments(*m.history, source);
  std::vector<MotionSegment> segments;
  const auto named = [&](const std::optional<std::string>& name) {
    return name.value_or(fmt::format("segment-{}", segments.size() + 1));
  };
  double speed = m.start_speed;
  if (m.segments)
    for (const Requirement::Segment& s : *m.segments) {
      segments.push_back({named(s.name), s.duration, speed, s.end_speed, s.force});
      speed = s.end_speed;
    }
  else
    for (const Requirement::ConstantLoad& l : *m.loads)
      segments.push_back({named(l.name), l.share * m.period, l.speed, l.speed, l.force});
  return segments;
}

struct Read {
  SizeInput in;
  Node root;
};

/// Forces of samples well beyond those of the cycle, which are means of two samples.
std::optional<Warning> peaks_between_samples(const MotionCycle& cycle) {
  constexpr double kWellBeyond = 1.05;
  double samples = 0.0, means = 0.0;
  for (const MotionSegment& s : cycle.all) {
    samples = std::max(samples, s.force_of_samples);
    means = std::max(means, std::abs(s.external_force));
  }
  if (!(samples > kWellBeyond * means)) return std::nullopt;
  return Warning{"motion.history", "peaks_between_samples",
                 "a sample has the force {value}, and the largest mean of two neighbours, with which the cycle is "
                 "computed, is {limit}: largest force, static safety, buckling and peak torque miss the peak",
                 "sample the peak more closely, or state it as segments of `motion`"}
      .with(samples, means, "N"_unit);
}

Read read(const Source& source) {
  ErrorList errors(source);
  Read read;
  read.in.source = source;
  read.root = read_document(source, errors);
  if (const Node* mechanism = find(read.root, "mechanism"))
    errors.fail(mechanism->key_place, "mechanism",
                "got a case; expected a requirement, with `motion`; run `prs check`, `solve`, "
                "`slip` or `life` on a case, and see docs/size.md for a requirement");
  Requirement& r = read.in.values;
  read_described(read.root, description(r), errors);
  errors.throw_if_any();
  Checker checker(r, read.root, errors);
  checker.check();
  errors.throw_if_any();
  complete(r);
  read.in.fields = echo_of(read.root, description(r));
  check_blocks(r, read.root, errors);
  errors.throw_if_any();
  if (r.linkage) {
    LeverSegments motion = all_lever_segments(r, source);
    const double ratio = prs_lever(&*r.linkage, 0.5 * (motion.angles[0] + motion.angles[1])).ratio;
    read.in.cycle = cycle_of(std::move(motion.segments), r);
    read.in.cycle.angles = motion.angles;
    read.in.cycle.moved_mass = r.load.inertia / (ratio * ratio);
  } else {
    read.in.cycle = cycle_of(segments_of(r.motion, source), r);
  }
  const MotionCycle& cycle = read.in.cycle;
  checker.check(cycle);
  errors.throw_if_any();
  if (!r.stroke && !r.motion.loads && cycle.way > 0.0) r.stroke = cycle.way;
  if (!cycle.closed)
    read.in.warnings.push_back({"motion", "open_cycle",
                                "the last speed of the cycle is not its first, though the cycle is "
                                "repeated",
                                "end it with the speed that it begins with"});
  if (r.brake_torque && !(cycle.holding_force > 0.0))
    read.in.warnings.push_back({"brake", "no_rest",
                                "no force acts at rest, so that nothing says what the brake has to hold",
                                "add a segment at rest under that force"});
  constexpr double kOpen = 0.01;  // Share of the way that rounded speeds and times leave over.
  if (const double left = std::abs(cycle.left_over); !r.motion.loads && left > kOpen * cycle.way)
    read.in.warnings.push_back(Warning{"motion", "open_way",
                                       "the cycle ends {value} from where it begins, though it is repeated",
                                       "state the way back, too"}
                                   .with(left, {}, "mm"_unit));
  if (!cycle.mean_load)
    read.in.warnings.push_back(
        {"motion", "at_rest",
         "nothing moves under a force; a case that `--write` writes then has a travel of 1 mm at "
         "1 mm/s for its form, whose life and shares of speeds say nothing"});
  if (std::optional<Warning> note = peaks_between_samples(cycle)) read.in.warnings.push_back(std::move(*note));
  return read;
}

}  // namespace
}  // namespace input

std::string name(Requirement::Objective objective) {
  return input::text_of(input::value_of(objective, input::Choice{}));
}

std::string catalogue_file_key(const std::vector<Requirement::Catalogue>& all, std::size_t number) {
  return all.size() == 1 ? std::string(kCatalogueFile) : fmt::format("candidates.catalogue[{}].file", number);
}

SizeInput read_requirement(const input::Source& source) { return input::read(source).in; }

std::vector<std::string> requirement_files(const input::Source& source) {
  const Requirement r = input::read(source).in.values;
  std::vector<std::string> texts;
  if (const auto& history = r.motion.history)
    texts.push_back(input::named_file_text(history->file, kHistoryFile, source));
  if (const auto& all = r.candidates.catalogue)
    for (std::size_t k = 0; k < all->size(); ++k)
      texts.push_back(input::named_file_text((*all)[k].file, catalogue_file_key(*all, k), source));
  return texts;
}

nlohmann::ordered_json requirement_schema() {
  using Pointer = nlohmann::ordered_json::json_pointer;
  Requirement r, of_lever;
  of_lever.linkage.emplace();
  const auto schema = [](Requirement& one) {
    return input::schema_of("Requirement of `prs size`", input::description(one));
  };
  nlohmann::ordered_json along = schema(r), lever = schema(of_lever);
  for (const char* const speed : {"start_speed", "segments/items/properties/end_speed"}) {
    const Pointer place(fmt::format("/properties/motion/properties/{}", speed));
    along[place] = {{"description", along[place]["x-meaning"]}, {"oneOf", {along[place], lever[place]}}};
  }
  return along;
}

nlohmann::ordered_json resolved_requirement(const input::Source& source) {
  input::Read read = input::read(source);
  return input::resolved(read.root, input::description(read.in.values));
}

namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]
constexpr double kEqual = 1e-9;       ///< Largest relative difference of equal numbers, by rounding.
constexpr double kNoForce = 1e-6;     ///< Force, as a share of the largest, that counts as 0.
constexpr std::size_t kMostShown = 60;
constexpr int kForceSteps = 12, kSpeedSteps = 8;

std::vector<MotionSegment> cut(std::vector<MotionSegment> segments) {
  std::vector<MotionSegment> all;
  for (MotionSegment& s : segments) {
    if (!(s.start_speed * s.end_speed < 0.0)) {
      all.push_back(std::move(s));
      continue;
    }
    MotionSegment first = s, second = s;
    first.name += "-a", second.name += "-b";
    first.duration = s.duration * s.start_speed / (s.start_speed - s.end_speed);
    second.duration = s.duration - first.duration;
    first.end_speed = second.start_speed = 0.0;
    first.own_travel = second.own_travel = std::nullopt;
    all.push_back(std::move(first));
    all.push_back(std::move(second));
  }
  return all;
}

void set_forces(std::vector<MotionSegment>& all, const Requirement::Load& load) {
  const double weight = load.moved_mass * kGravity;
  const double friction = load.guide_friction * weight * std::abs(std::cos(load.inclination)) + load.resistance;
  double largest = 0.0;
  for (MotionSegment& s : all) {
    s.force = load.moved_mass * s.acceleration() + weight * std::sin(load.inclination) + s.sense() * friction +
              s.external_force;
    largest = std::max(largest, std::abs(s.force));
  }
  for (MotionSegment& s : all)
    if (std::abs(s.force) < kNoForce * largest) s.force = 0.0;
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// Number of a value's step, from 1; an upper border belongs to its step.
int step(double value, double largest, int steps) {
  if (!(largest > 0.0)) return 0;
  return static_cast<int>(std::ceil(value / largest * steps - kEqual));
}

/// Puts many segments into few classes, each with its cubic mean force by travel, at rest by time, and its mean speed.
void put_into_classes(MotionCycle& c) {
  std::map<int, double> of_force;  // Largest forces by their sense.
  for (const MotionSegment& s : c.all) of_force[sign(s.force)] = std::max(of_force[sign(s.force)], std::abs(s.force));
  std::map<std::tuple<int, int, int, int>, std::size_t> known;
  std::vector<double> cubes;
  for (MotionSegment& s : c.all) {
    const int force = sign(s.force);
    const bool is_largest = force != 0 && std::abs(s.force) >= of_force[force] * (1.0 - kEqual);
    const auto [found, is_new] = known.try_emplace(
        {s.sense(), force, is_largest ? kForceSteps + 1 : step(std::abs(s.force), c.largest_force, kForceSteps),
         is_largest ? 0 : step(s.mean_speed(), c.largest_speed, kSpeedSteps)},
        c.shown.size());
    if (is_new) {
      c.shown.push_back({fmt::format("class-{}", found->second + 1)});
      c.shown.back().own_travel = 0.0;
      cubes.push_back(0.0);
    }
    s.shown_as = found->second;
    MotionSegment& of = c.shown[s.shown_as];
    of.duration += s.duration;
    *of.own_travel += s.travel();
    cubes[s.shown_as] += std::pow(s.force, 3) * (s.sense() == 0 ? s.duration : std::abs(s.travel()));
  }
  for (std::size_t k = 0; k < c.shown.size(); ++k) {
    MotionSegment& of = c.shown[k];
    of.start_speed = of.end_speed = *of.own_travel / of.duration;
    of.force = std::cbrt(cubes[k] / (of.sense() == 0 ? of.duration : std::abs(*of.own_travel)));
  }
}

/// Distance between the extreme positions of segments with forces above `least` [N].
double loaded_way(const std::vector<MotionSegment>& segments, double least) {
  double at = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const MotionSegment& s : segments) {
    const double before = std::exchange(at, at + s.travel());
    if (!(std::abs(s.force) > least)) continue;
    lowest = std::min({lowest, before, at});
    highest = std::max({highest, before, at});
  }
  return std::max(0.0, highest - lowest);
}

void set_totals(MotionCycle& c, const Requirement& r) {
  double cubes = 0.0, square = 0.0, at = 0.0, lowest = 0.0, highest = 0.0;
  std::optional<double> held;
  for (const MotionSegment& s : c.all) {
    const double v0 = s.start_speed, v1 = s.end_speed, way = std::abs(s.travel());
    const double force = std::abs(s.force);
    c.duration += s.duration;
    if (s.sense() != 0) c.moving += s.duration;
    c.travel += way;
    if (s.force != 0.0) c.loaded_travel += way;
    cubes += force * force * force * way;
    square += s.duration * (v0 * v0 + v0 * v1 + v1 * v1) / 3.0;
    c.largest_speed = std::max(c.largest_speed, s.largest_speed());
    if (force > c.largest_force * (1.0 + kEqual)) {
      c.largest_force = force;
      c.largest_sign = s.force > 0.0 ? 1.0 : -1.0;
    }
    if (!r.load.positive_force || direction_of(r, s.force) == Direction::compression)
      c.largest_compression = std::max(c.largest_compression, force);
    if (s.sense() == 0) held = std::max(held.value_or(0.0), force);
    at += s.travel();
    lowest = std::min(lowest, at);
    highest = std::max(highest, at);
  }
  c.way = highest - lowest;
  c.left_over = at;
  c.rms_speed = std::sqrt(square / c.duration);
  if (c.loaded_travel > 0.0) c.mean_load = std::cbrt(cubes / c.travel);
  c.loaded_way = c.mean_load ? loaded_way(c.all, 0.5 * *c.mean_load) : 0.0;
  if (c.moving > 0.0) c.mean_speed = c.travel / c.moving;
  c.holding_force = held.value_or(r.load.moved_mass * kGravity * std::abs(std::sin(r.load.inclination)));
  c.closed = std::abs(c.all.back().end_speed - c.all.front().start_speed) <= kEqual * c.largest_speed;
}

}  // namespace

Direction direction_of(const Requirement& r, double force) {
  const Direction positive = r.load.positive_force.value_or(Direction::compression);
  if (force > 0.0) return positive;
  return positive == Direction::tension ? Direction::compression : Direction::tension;
}

MotionCycle cycle_of(std::vector<MotionSegment> segments, const Requirement& r) {
  MotionCycle c;
  c.all = cut(std::move(segments));
  set_forces(c.all, r.load);
  set_totals(c, r);
  if (r.motion.loads) c.closed = true;
  c.moved_mass = r.load.moved_mass;
  c.in_classes = c.all.size() > kMostShown;
  for (std::size_t k = 0; k < c.all.size(); ++k) c.all[k].shown_as = k;
  c.in_classes ? put_into_classes(c) : void(c.shown = c.all);
  return c;
}

}  // namespace prs
