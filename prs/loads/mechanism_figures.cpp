#include "prs/loads/mechanism_figures.h"

#include "prs/indices.h"
#include "prs/loads/contact_figures.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/record/table_layout.h"
#include "prs/record/table_units.h"

namespace prs {
namespace {

constexpr double kMm = "mm"_per_si;

/// One external thread, or the air in the nut's, cut through its axis. Lengths in mm.
struct Teeth {
  double pitch = 0.0, radius = 0.0, root = 0.0, crest = 0.0;
  double slope = 0.0;  ///< Slope of the flanks: axial over radial.

  /// Half of a tooth's thickness at a radius.
  double half_thickness(double r) const { return std::clamp(0.25 * pitch - (r - radius) * slope, 0.0, 0.5 * pitch); }
};

Teeth teeth_of(const contact::Thread& thread, double flank_angle) {
  const contact::RadiusLimits limits = contact::flank_limits(thread);
  return {thread.pitch * kMm, contact::ThreadSurface(thread).pitch_radius * kMm, limits.smallest * kMm,
          limits.largest * kMm, std::tan(flank_angle)};
}

/// Outline from `from` to `to` along the axis, with the middle of a tooth at `tooth`: (x, radius).
Polyline tooth_outline(const Teeth& t, double tooth, double from, double to) {
  Polyline line;
  const auto add = [&](double x, double r) { line.push_back({std::clamp(x, from, to), r}); };
  const double first = tooth + std::floor((from - tooth) / t.pitch) * t.pitch;
  for (double x = first; x < to + t.pitch; x += t.pitch) {
    add(x - t.half_thickness(t.root), t.root);
    add(x - t.half_thickness(t.crest), t.crest);
    add(x + t.half_thickness(t.crest), t.crest);
    add(x + t.half_thickness(t.root), t.root);
  }
  return line;
}

/// Places along the nut's axis [mm].
struct SectionPlace {
  double first = 0.0;  ///< Position of the roller's first contact.
  double pitch = 0.0;
  int contacts = 0;
  double nut_length = 0.0;
  double screw_from = 0.0, screw_to = 0.0;

  double last() const { return first + (contacts - 1) * pitch; }
};

SectionPlace place_of(const Case& c, const Result& result, const LoadCaseResult* shown) {
  SectionPlace p;
  p.pitch = axial_pitches(result.contacts.mechanism).roller * kMm;
  p.contacts = c.mechanism.contacts_per_roller;
  const double length = (p.contacts - 1) * p.pitch;
  p.nut_length = c.structure ? c.structure->nut.length * kMm : length + 4.0 * p.pitch;
  p.first = shown && shown->load_case.position ? *shown->load_case.position * kMm : 0.5 * (p.nut_length - length);
  const double end = c.structure ? c.structure->roller.end_length * kMm : 0.0;
  const double margin = 0.04 * p.nut_length;
  const double loaded = c.structure ? p.first - free_length(*c.structure) * kMm : 0.0;
  p.screw_from = std::min({loaded, p.first - p.pitch - end, 0.0}) - margin;
  p.screw_to = std::max(p.last() + p.pitch + end, p.nut_length) + margin;
  return p;
}

Polyline nut_outline(const Case& c, const SectionPlace& p, const Teeth& groove) {
  // The nut's teeth are where the air between them is thin.
  Polyline line = tooth_outline(groove, p.first, 0.0, p.nut_length);
  const double shell = groove.crest + std::max(2.0 * p.pitch, 0.15 * groove.crest);
  const auto outer = [&](double x) {
    return c.structure ? 0.5 * nut_diameter(c.structure->nut, x / kMm) * kMm : shell;
  };
  std::vector<double> faces{0.0, p.nut_length};
  if (c.structure)
    for (const Structure::Flange& flange : c.structure->nut.flanges)
      for (const double x : {flange.from * kMm, flange.to * kMm}) faces.push_back(x);
  std::ranges::sort(faces);
  for (std::size_t k = faces.size() - 1; k > 0; --k) {
    const double r = outer(0.5 * (faces[k - 1] + faces[k]));
    line.push_back({faces[k], r});
    line.push_back({faces[k - 1], r});
  }
  line.push_back(line.front());
  return line;
}

Polyline closed_below(Polyline line, double y) {
  const double from = line.front()[0], to = line.back()[0];
  line.push_back({to, y});
  line.push_back({from, y});
  line.push_back(line.front());
  return line;
}

/// Outline of the roller with its ends, on its axis at y.
Polyline roller_outline(const Case& c, const SectionPlace& p, const Teeth& t, double y) {
  const double from = p.first - 0.5 * p.pitch, to = p.last() + 0.5 * p.pitch;
  Polyline line;
  const auto shaft_end = [&](double x, double out) {
    if (!c.structure) return;
    const double r = 0.5 * c.structure->roller.end_diameter * kMm;
    const double end = x + out * c.structure->roller.end_length * kMm;
    const Polyline points{{x, y - out * r}, {end, y - out * r}, {end, y + out * r}, {x, y + out * r}};
    line.insert(line.end(), points.begin(), points.end());
  };
  const Polyline teeth = tooth_outline(t, p.first, from, to);
  for (const auto& [x, r] : teeth) line.push_back({x, y - r});
  shaft_end(to, 1.0);
  for (auto at = teeth.rbegin(); at != teeth.rend(); ++at) line.push_back({(*at)[0], y + (*at)[1]});
  shaft_end(from, -1.0);
  line.push_back(line.front());
  return line;
}

/// A bar along the flank on which a thread bears. The roller's tooth points to the screw or to the
/// nut; in tension the screw bears on its far flank.
Polyline contact_bar(const Teeth& t, Interface i, Direction direction, double tooth, double axis) {
  const double points = i == Interface::screw ? -1.0 : 1.0;
  const double flank = (i == Interface::screw) == (direction == Direction::tension) ? 1.0 : -1.0;
  const double x = tooth + flank * 0.25 * t.pitch, y = axis + points * t.radius;
  const double norm = std::hypot(1.0, t.slope);
  const double ax = -flank * points * t.slope / norm, ay = 1.0 / norm;  // Components along the flank.
  const double a = 0.38 * t.pitch, b = 0.16 * t.pitch;
  const auto corner = [&](double along, double across) {
    return std::array{x + along * ax - across * ay, y + along * ay + across * ax};
  };
  return {corner(-a, -b), corner(a, -b), corner(a, b), corner(-a, b)};
}

bool is_shown(const LoadCaseResult& r) { return r.threads.has_value(); }

/// Index of the roller with the largest load.
std::size_t shown_roller(const LoadCaseResult& r) {
  return r.full ? static_cast<std::size_t>(r.threads->screw.rollers->largest_roller - 1) : 0;
}

constexpr const char* kRelativeLoad = "Load over the mean of the threads";

ColourScale scale_of(const Range& range) {
  constexpr double kUsual = 1.5;  // Smallest upper end, so that equal loads do not look like a peak.
  return {kRelativeLoad, {}, std::min(0.0, range.from), std::max(kUsual, range.to)};
}

void add_body(Figure& figure, Panel& panel, Part part, std::vector<Polyline> parts) {
  Style style = area_of(colour_of(part));
  style.pale = true;
  panel.series.push_back({figure.add(std::string(title(part)), style), parts});
  panel.series.push_back({figure.add(line_of(colour_of(part), Dash::solid, Weight::thin)), parts});
}

Polyline circle(double y, double z, double r) { return ellipse(y, z, r, r, 0.0); }

/// Number of rollers: `11 rollers`, or `10 of 11 rollers` if some are missing.
std::string rollers_text(const Case& c) {
  const int places = c.mechanism.rollers;
  const int missing = static_cast<int>(c.deviations.missing_rollers.size());
  return missing == 0 ? fmt::format("{} rollers", places) : fmt::format("{} of {} rollers", places - missing, places);
}

/// Adds dimensions: sizes in the bodies, the length of the nut between arrows. `top` is the nut's radius with its
/// flanges.
void add_sizes(Figure& figure, Panel& panel, const Case& c, const SectionPlace& p, double axis,
               const contact::MechanismGeometry& threads, double top) {
  const double middle = 0.5 * p.nut_length;
  const auto add = [&](double x, double y, std::string text) {
    panel.labels.push_back({std::move(text), x, y, false, Label::Anchor::centre});
  };
  const auto diameter = [](const contact::Thread& thread) {
    return 2.0 * contact::ThreadSurface(thread).pitch_radius * kMm;
  };
  const double screw = 0.5 * diameter(threads.screw), roller = 0.5 * diameter(threads.roller);
  add(middle, 0.55 * screw, fmt::format("screw, pitch Ø{:.5g}, lead {:.5g}", 2.0 * screw, threads.screw.lead * kMm));
  const double of_roller = 0.5 * (p.first + p.last());
  add(of_roller, axis + 0.45 * roller, rollers_text(c));
  add(of_roller, axis - 0.45 * roller, fmt::format("pitch Ø{:.5g}, {} threads", 2.0 * roller, p.contacts));
  if (!c.structure) return;
  const double body = 0.5 * c.structure->nut.outer_diameter * kMm;
  add(middle, 0.5 * (axis + roller + body), fmt::format("nut Ø{:.5g}", 2.0 * body));
  for (const Structure::Flange& flange : c.structure->nut.flanges)
    if (const double outer = 0.5 * flange.outer_diameter * kMm; outer > body)
      add(0.5 * (flange.from + flange.to) * kMm, 0.5 * (body + outer), fmt::format("Ø{:.5g}", 2.0 * outer));
  const double above = 1.08 * top;
  panel.series.push_back({figure.add(arrows_of(Colour::ink)),
                          {{{middle, above}, {0.0, above}}, {{middle, above}, {p.nut_length, above}}}});
  add(middle, 1.14 * top, fmt::format("{:.5g}", p.nut_length));
}

/// Adds the supports of the parts under this load. `roller` is the radius at its pitch.
void add_supports(Figure& figure, Panel& panel, const Case& c, const SectionPlace& p, double axis, double roller,
                  const LoadCaseResult* shown) {
  if (!c.structure) return;
  const Structure& s = *c.structure;
  const auto& direction = shown ? shown->load_case.direction : std::nullopt;
  if (direction)
    if (const auto& thrust = *direction == Direction::tension ? s.nut.thrust.tension : s.nut.thrust.compression) {
      const auto [before, behind] = nut_diameters_at(s.nut, *thrust);
      const double x = *thrust * kMm, outer = 0.5 * std::max(before, behind) * kMm;
      const double from = axis + roller;  // Starts outside the roller, so that no line crosses its text.
      panel.series.push_back(
          {figure.add("section where the nut is held", line_of(Colour::ink, Dash::dashed, Weight::strong)),
           {{{x, from}, {x, 1.04 * outer}}}});
    }
  Style guide = points_of(Colour::purple, Mark::diamond);
  panel.series.push_back({figure.add("roller guided", guide),
                          {{{p.first - 0.5 * p.pitch - 0.5 * s.roller.end_length * kMm, axis}},
                           {{p.last() + 0.5 * p.pitch + 0.5 * s.roller.end_length * kMm, axis}}}});
  if (s.screw.bearings.empty() || !(shown && shown->full)) return;
  Series bearings{figure.add("bearing of the screw", points_of(Colour::ink, Mark::triangle))};
  for (const Bearing& b : s.screw.bearings) bearings.parts.push_back({{b.position * kMm, 0.0}});
  panel.series.push_back(std::move(bearings));
}

/// An arrow along x with a head that is visible in a small print. `point` is a pixel of the screen.
Polyline arrow(double from, double to, double y, double point) {
  const double shaft = 1.3 * point, head = 6.0 * point;
  const double base = to + std::copysign(18.0 * point, from - to);
  return {{from, y - shaft}, {base, y - shaft}, {base, y - head}, {to, y},
          {base, y + head},  {base, y + shaft}, {from, y + shaft}};
}

/// Adds the force on the screw, at its loaded end, with room for its text.
void add_load(Figure& figure, Panel& panel, const SectionPlace& p, const LoadCaseResult& shown, double top) {
  const double span = p.screw_to - p.screw_from, height = figure.y.to - figure.y.from;
  const bool is_short = 2.0 * height > 1.17 * span;  // Pages then draw it half as wide.
  const double room = (is_short ? 0.45 : 0.17) * span, near = p.screw_from - 0.1 * room;
  const double far = near - 0.9 * room, point = (span + room) / (is_short ? 350.0 : 790.0);
  const double above = std::max(0.09 * top, 14.0 * point);
  const double y = std::max(0.15 * top, figure.y.from + above + 10.0 * point);
  const bool pulls = shown.load_case.direction == Direction::tension;
  panel.series.push_back(
      {figure.add(area_of(Colour::bad)), {pulls ? arrow(near, far, y, point) : arrow(far, near, y, point)}});
  const double middle = 0.5 * (near + far);
  panel.labels.push_back({in_table_unit(fmt::format("{:.4g} kN", shown.load_case.axial_force * "kN"_per_si)), middle,
                          y + above, false, Label::Anchor::centre});
  panel.labels.push_back(
      {std::string(name(*shown.load_case.direction)), middle, y - above, false, Label::Anchor::centre});
  figure.x.from = far - 0.1 * room;
}

/// Adds a part seen along the axis.
void add_ring(Figure& figure, Panel& panel, Part part, double outer, double inner) {
  if (!(inner > 0.0)) return add_body(figure, panel, part, {circle(0, 0, outer)});
  // Path around the outside, back along a seam, around the inside.
  Polyline ring = circle(0, 0, outer), inside = circle(0, 0, inner);
  ring.insert(ring.end(), inside.rbegin(), inside.rend());
  Style pale = area_of(colour_of(part));
  pale.pale = true;
  panel.series.push_back({figure.add(std::string(title(part)), pale), {ring}});
  panel.series.push_back(
      {figure.add(line_of(colour_of(part), Dash::solid, Weight::thin)), {circle(0, 0, outer), circle(0, 0, inner)}});
}

std::string shown_title(std::string what, const LoadCaseResult* shown) {
  return shown ? fmt::format("{}, {}, {}", what, shown_name(shown->load_case.name), words_of_text(name(shown->loads)))
               : what;
}

const LoadCaseResult* case_shown(const Result& result, const FigureOptions& options) {
  return result.load_cases.empty() ? nullptr : chosen_case(result, options, is_shown);
}

/// Screw, a roller and nut cut along the axis, to scale, with sizes in mm, supports and the load on the screw; the
/// contacts have the colours of their loads. For a full mechanism the roller with the largest load.
Figure mechanism_section(const Case& c, const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = case_shown(result, options);
  const SectionPlace p = place_of(c, result, shown);
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const Mechanism& m = result.contacts.mechanism;
  PerPart<Teeth> teeth;
  teeth.screw = teeth_of(threads.screw, m.flank_angle.screw);
  teeth.roller = teeth_of(threads.roller, m.flank_angle.roller);
  teeth.nut = teeth_of(threads.nut, m.flank_angle.nut);
  const double axis = threads.centre_distance * kMm;

  Figure figure{"section", shown_title("Section through the axis", shown)};
  Panel& panel = figure.panels.emplace_back();
  const double bore = c.structure ? 0.5 * c.structure->screw.bore * kMm : 0.0;
  add_body(figure, panel, Part::screw,
           {closed_below(tooth_outline(teeth.screw, p.first + 0.5 * p.pitch, p.screw_from, p.screw_to), bore)});
  const Polyline nut = nut_outline(c, p, teeth.nut);
  add_body(figure, panel, Part::nut, {nut});
  add_body(figure, panel, Part::roller, {roller_outline(c, p, teeth.roller, axis)});
  const Style centre = line_of(Colour::reference, Dash::dash_dotted, Weight::thin);
  const double overhang = 0.02 * p.nut_length;
  panel.series.push_back({figure.add(centre),
                          {{{p.screw_from - overhang, 0.0}, {p.screw_to + overhang, 0.0}},
                           {{p.first - 3.0 * p.pitch, axis}, {p.last() + 3.0 * p.pitch, axis}}}});
  if (shown && shown->load_case.direction) {
    Series bars{figure.add(area_of(Colour::ink))};
    Range range;
    const auto count = static_cast<std::size_t>(p.contacts);
    for (const Interface i : kInterfaces)
      for (const auto k : up_to(count)) {
        const double load = (*shown->threads)[i].load_rate[shown_roller(*shown) * count + k];
        bars.parts.push_back(contact_bar(teeth.roller, i, *shown->load_case.direction,
                                         p.first + static_cast<double>(k) * p.pitch, axis));
        bars.values.push_back(load * static_cast<double>(count));
        range.include(bars.values.back());
      }
    panel.series.push_back(std::move(bars));
    figure.colours = scale_of(range);
    if (shown->full) panel.title = fmt::format("Roller {}", shown_roller(*shown) + 1);
  }
  Range height;
  for (const auto& point : nut) height.include(point[1]);
  const double top = height.to;
  figure.x = {"From the end of the nut at the loaded end of the screw", "mm", p.screw_from - overhang,
              p.screw_to + overhang};
  figure.y = {"Radius", "mm", -0.06 * top, (c.structure ? 1.22 : 1.05) * top};
  add_sizes(figure, panel, c, p, axis, threads, top);
  add_supports(figure, panel, c, p, axis, teeth.roller.radius, shown);
  if (shown && shown->load_case.direction) add_load(figure, panel, p, *shown, top);
  figure.aspect = (figure.y.to - figure.y.from) / (figure.x.to - figure.x.from);
  figure.to_scale = true;
  return figure;
}

/// Rollers between screw and nut, seen along the axis; those of a full mechanism in the colours of their shares.
Figure mechanism_end(const Case& c, const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = case_shown(result, options);
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const double axis = threads.centre_distance * kMm;
  const auto radius = [](const contact::Thread& thread) { return contact::ThreadSurface(thread).pitch_radius * kMm; };
  const int rollers = c.mechanism.rollers;
  const bool all = shown && shown->full;
  Figure figure{"end_view", shown_title("Seen along the axis", all ? shown : nullptr)};
  Panel& panel = figure.panels.emplace_back();
  const double outer = c.structure ? 0.5 * c.structure->nut.outer_diameter * kMm : 1.15 * radius(threads.nut);
  add_ring(figure, panel, Part::nut, outer, radius(threads.nut));
  add_ring(figure, panel, Part::screw, radius(threads.screw), c.structure ? 0.5 * c.structure->screw.bore * kMm : 0.0);

  std::vector<Polyline> circles;
  std::vector<double> shares;
  Range range;
  for (int j = 0; j < rollers; ++j) {
    if (std::ranges::count(c.deviations.missing_rollers, j + 1) > 0) continue;
    const double azimuth = (all ? shown->full->carrier_angle : 0.0) + 2.0 * std::numbers::pi * j / rollers;
    const double y = axis * std::cos(azimuth), z = axis * std::sin(azimuth);
    circles.push_back(circle(y, z, radius(threads.roller)));
    panel.labels.push_back({fmt::to_string(j + 1), y, z, false, Label::Anchor::centre});
    if (!all) continue;
    shares.push_back(shown->threads->screw.rollers->share[static_cast<std::size_t>(j)] * rollers);
  }
  for (const LoadCaseResult& load_case : result.load_cases)  // All pictures share one scale.
    if (load_case.full && load_case.threads)
      for (const double share : load_case.threads->screw.rollers->share) range.include(share * rollers);
  if (all) {
    panel.series.push_back({figure.add(area_of(colour_of(Part::roller))), circles, shares});
    figure.colours = scale_of(range);
    figure.colours->label = "Load of the roller over the mean of all";
  } else {
    add_body(figure, panel, Part::roller, circles);
  }
  figure.x = {"y", "mm", -1.02 * outer, 1.02 * outer};
  figure.y = {"z", "mm", -1.02 * outer, 1.02 * outer};
  figure.x.hidden = figure.y.hidden = true;
  figure.to_scale = true;
  figure.aspect = 0.7;
  return figure;
}

bool has_threads(const LoadCaseResult& result) { return result.threads.has_value(); }

/// `thread 3` or `roller 2, thread 3`.
std::string words_of_thread(const ChosenThread& chosen) {
  const auto threads = static_cast<std::size_t>(chosen.at(Interface::screw).threads_per_roller);
  return threads == 0 ? fmt::format("thread {}", chosen.thread + 1)
                      : fmt::format("roller {}, thread {}", chosen.thread / threads + 1, chosen.thread % threads + 1);
}

std::string picture_title(const char* what, const ChosenThread& chosen) {
  return shown_title(fmt::format("{}, {}", what, words_of_thread(chosen)), chosen.load_case);
}

}  // namespace

std::optional<ChosenThread> chosen_thread(const Result& result, const FigureOptions& options,
                                          bool (*has)(const LoadCaseResult&)) {
  const LoadCaseResult* load_case = chosen_case(result, options, has);
  if (!load_case || !has(*load_case)) return std::nullopt;
  const std::vector<double>& loads = load_case->threads->screw.normal_load;
  if (loads.empty()) return std::nullopt;
  const std::size_t thread = options.thread.value_or(*index_of_largest(loads));
  if (thread >= loads.size()) throw NoFigure(fmt::format("thread: got {}; expected 0 to {}", thread, loads.size() - 1));
  return ChosenThread{load_case, thread};
}

namespace {

/// Hertz' pressure p_0 sqrt(1 - (x/a)^2 - (y/b)^2) over both ellipses of a thread.
Figure thread_pressure(const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_threads);
  if (!chosen) return {};
  constexpr int kRings = 12;
  Figure figure{"thread_pressure", picture_title("Contact ellipses", *chosen)};
  const std::size_t rings = figure.add(area_of(Colour::ink));
  double half = 0.0, most = 0.0;
  for (const Interface i : kInterfaces) {
    if (!chosen->has_ellipse(i)) continue;
    const InterfaceLoads& loads = chosen->at(i);
    const double a = loads.semi_major[chosen->thread] * "mm"_per_si;
    const double b = loads.semi_minor[chosen->thread] * "mm"_per_si;
    const double peak = loads.peak_pressure[chosen->thread] * "MPa"_per_si;
    Panel& panel = figure.panels.emplace_back();
    panel.title = fmt::format("{}: {}", interface_title(i),
                              in_table_unit(fmt::format("{:.4g} N", loads.normal_load[chosen->thread])));
    Series series{rings};
    for (int k = 0; k < kRings; ++k) {
      // Rings of equal steps of pressure, each in the colour of its middle value.
      const double outside = std::sqrt(1.0 - std::pow(static_cast<double>(k) / kRings, 2));
      series.parts.push_back(ellipse(0.0, 0.0, outside * a, outside * b, 0.0));
      series.values.push_back(peak * (k + 0.5) / kRings);
    }
    panel.series.push_back(std::move(series));
    panel.labels.push_back({semi_axes_text(a, b), 0.03, 0.06, true});
    half = std::max(half, a);
    most = std::max(most, peak);
  }
  if (figure.panels.empty()) return {};
  figure.columns = figure.panels.size();
  figure.x = {"Along the major axis", "mm", -1.15 * half, 1.15 * half};
  figure.y = {"Along the minor axis", "mm", -1.15 * half, 1.15 * half};
  figure.colours = ColourScale{"Pressure", "MPa", 0.0, most};
  figure.aspect = 0.6;
  figure.to_scale = true;
  return figure;
}

/// Principal stresses and largest shear stress below the centre of both ellipses of a thread, of
/// the body with the smaller Poisson's ratio, see `contact::stress_on_axis`.
Figure thread_stress(const Case& c, const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_threads);
  if (!chosen || !c.materials) return {};
  constexpr int kSteps = 60;
  constexpr double kDepth = 3.0;  // Depth over the minor semi-axis.
  Figure figure{"thread_stress", picture_title("Stress below the contacts", *chosen)};
  const std::size_t normal = figure.add("along the normal", line_of(Colour::blue));
  const std::size_t major = figure.add("along the major axis", line_of(Colour::green));
  const std::size_t minor = figure.add("along the minor axis", line_of(Colour::purple));
  const std::size_t shear =
      figure.add("largest shear stress", line_of(Colour::vermillion, Dash::solid, Weight::strong));
  const std::size_t von_mises = figure.add("von Mises stress", line_of(Colour::vermillion, Dash::dashed));
  const std::size_t deepest = figure.add("depth of the largest shear stress", kMeanStyle);
  const std::size_t zero = figure.add(kZeroStyle);
  for (const Interface i : kInterfaces) {
    if (!chosen->has_ellipse(i)) continue;
    const InterfaceLoads& loads = chosen->at(i);
    const double a = loads.semi_major[chosen->thread], b = loads.semi_minor[chosen->thread];
    const double peak = loads.peak_pressure[chosen->thread] * "MPa"_per_si;
    const double nu = std::min((*c.materials)[body_of(i)].poisson_ratio, c.materials->roller.poisson_ratio);
    Series of_normal{normal}, of_major{major}, of_minor{minor}, of_shear{shear}, of_von_mises{von_mises};
    for (int k = 0; k <= kSteps; ++k) {
      const double depth = kDepth * b * k / kSteps;
      const contact::AxisStress s = contact::stress_on_axis(a, b, depth, nu);
      const double x = depth * "µm"_per_si;
      of_normal.add(x, s.along_normal * peak);
      of_major.add(x, s.along_major * peak);
      of_minor.add(x, s.along_minor * peak);
      of_shear.add(x, s.largest_shear() * peak);
      of_von_mises.add(x, s.von_mises() * peak);
    }
    Panel& panel = figure.panels.emplace_back(Panel{interface_title(i)});
    panel.series = {of_normal, of_major, of_minor, of_shear, of_von_mises};
    panel.references.push_back({zero, 0.0});
    if (!loads.max_shear_depth.empty())
      panel.references.push_back({deepest, loads.max_shear_depth[chosen->thread] * "µm"_per_si, true});
  }
  if (figure.panels.empty()) return {};
  figure.columns = figure.panels.size();
  figure.x = {"Depth", "µm"};
  figure.y = {"Stress", "MPa"};
  return figure;
}

}  // namespace

Pictures drawings(const Case& c, const Result& r) {
  using enum Picture::Drawn;
  constexpr const char* kMechanism = "a mechanism";
  constexpr const char* kEllipses = "a load case that converged, and contacts that come from the threads";
  const auto draw = [&c, &r](Figure (*make)(const Case&, const Result&, const FigureOptions&)) {
    return [&c, &r, make](const FigureOptions& options) { return listed(make(c, r, options)); };
  };
  return {{"section", kMechanism, draw(mechanism_section), by_name},
          {"end_view", kMechanism, draw(mechanism_end), by_name},
          {"thread_pressure", kEllipses, of_result(r, thread_pressure), by_name},
          {"thread_stress", kEllipses, draw(thread_stress), by_name}};
}

Pictures with_drawings(Pictures pictures, const Case& c, const Result& r) {
  append(pictures, drawings(c, r));
  return pictures;
}

}  // namespace prs
