#include "prs/losses/slip_figures.h"

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/loads/mechanism_figures.h"
#include "prs/record/table_units.h"
#include "prs/slip/slip_warnings.h"

namespace prs {
namespace {

template <std::vector<double> InterfaceSlip::*values>
const std::vector<double>& slip_of(const LoadCaseResult& result, Interface i) {
  return result.slip->of_nut_that_carries(result.load_case).threads[i].*values;
}

bool has_thread_slip(const LoadCaseResult& result) { return has_slip(result) && has_shares(result); }

std::optional<double> with_equal_shares(const LoadCaseResult& result, Interface i) {
  const std::optional<EqualShareSlip>& equal = result.slip->equal_shares;
  return equal ? std::optional(equal->thread_power[i]) : std::nullopt;
}

bool has_power_of_rollers(const LoadCaseResult& result) { return has_rollers(result) && has_slip(result); }

bool has_slip_of_threads(const LoadCaseResult& result) { return result.threads && has_slip(result); }

Figure thread_power(const Result& result, const FigureOptions& options) {
  FigureOptions one = options;
  if (options.load_case) one.load_cases = {*options.load_case};
  return from_zero(thread_figure({"thread_power", "Power lost at each thread of a roller", "Power", "W",
                                  slip_of<&InterfaceSlip::power>, 1.0, has_thread_slip, with_equal_shares},
                                 result, one));
}

/// Friction coefficient of each thread and sliding speed at the centre of its contact, a panel each.
Figure friction(const Result&, const LoadCaseResult& shown) {
  Figure figure{"friction", "Friction and sliding of each thread, " + shown_name(shown.load_case.name)};
  figure.columns = 2;
  for (const auto k : indices(kInterfaces)) figure.add(interface_title(kInterfaces[k]), marked_line(k));
  const SlipResult& nut = shown.slip->of_nut_that_carries(shown.load_case);
  const auto add = [&](const char* title, const char* unit, auto values, double factor) {
    Panel& panel = figure.panels.emplace_back(Panel{title});
    for (const auto k : indices(kInterfaces))
      panel.series.push_back({k, {over_threads(nut.threads[kInterfaces[k]].*values, factor)}});
    panel.y = fitted({title, unit}, range_of_y(panel.series), true);
  };
  add("Friction coefficient", "", &InterfaceSlip::friction_coefficient, 1.0);
  add("Sliding speed at the centre", "mm/s", &InterfaceSlip::sliding_speed, "mm"_per_si);
  figure.x = thread_axis(shown.threads->screw.axial_load.size());
  return figure;
}

/// Power lost at every thread of every roller, at both interfaces.
Figure roller_power(const Result& result, const FigureOptions& options) {
  return map_of_rollers({"roller_power", "Power lost at all rollers"}, result, options, {"Power lost", "W"},
                        {has_power_of_rollers, slip_of<&InterfaceSlip::power>});
}

/// Friction coefficient at every thread of every roller, at both interfaces.
Figure roller_friction(const Result& result, const FigureOptions& options) {
  return map_of_rollers({"roller_friction", "Friction at all rollers"}, result, options, {"Friction coefficient"},
                        {has_power_of_rollers, slip_of<&InterfaceSlip::friction_coefficient>});
}

/// Friction coefficient and sliding velocity at both contacts of a thread.
Figures thread_friction(const Case& c, const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_slip_of_threads);
  if (!chosen) return {};
  const auto place = static_cast<std::size_t>(chosen->load_case - result.load_cases.data());
  const auto patches = thread_patches(c, result, place, chosen->thread);
  if (!patches) return {};
  return {thread_friction_figure(*chosen->load_case, *patches, chosen->thread)};
}

constexpr int kMostArrows = 11;  // Largest number of arrows along each axis.

/// Styles of the figure in the order of their legend.
enum PatchStyle : std::size_t { kSliding, kOutline };

/// Cells of the ellipse, those outside without a value.
Map friction_map(const PatchField& field) {
  Map map;
  map.cells = true;
  const auto count = static_cast<std::size_t>(field.points);
  const auto middles = [&](double semi_axis) {
    std::vector<double> at;
    for (const auto k : up_to(count))
      at.push_back(semi_axis * (2.0 * static_cast<double>(k) + 1.0 - field.points) / field.points * "mm"_per_si);
    return at;
  };
  map.grid = {middles(field.semi_major), middles(field.semi_minor), std::vector<double>(count * count, kFree)};
  const auto place = [&](double position, double semi_axis) {
    return static_cast<std::size_t>(std::lround((position / semi_axis * field.points + field.points - 1.0) / 2.0));
  };
  for (const auto k : indices(field.friction_coefficient))
    map.grid
        .values[place(field.along_major[k], field.semi_major) * count + place(field.along_minor[k], field.semi_minor)] =
        field.friction_coefficient[k];
  return map;
}

double largest_speed(const PatchField& field) {
  double largest = 0.0;
  for (const auto k : indices(field.sliding_major))
    largest = std::max(largest, std::hypot(field.sliding_major[k], field.sliding_minor[k]));
  return largest;
}

/// Points from one arrow to the next, so that there are not too many.
int arrow_step(const PatchField& field) { return (field.points + kMostArrows - 1) / kMostArrows; }

/// Whether the point in a column or row of the grid is one that has an arrow; the middle one has.
bool has_arrow(double position, double semi_axis, const PatchField& field) {
  const double cell = 2.0 * semi_axis / field.points;
  return std::lround((position + semi_axis) / cell - 0.5) % arrow_step(field) == (field.points / 2) % arrow_step(field);
}

/// Sliding velocities, the middle of each arrow at its point.
Series arrows(const PatchField& field) {
  Series line{kSliding};
  const double largest = largest_speed(field);
  if (!(largest > 0.0)) return line;
  const double spacing = 2.0 * field.semi_minor / field.points * arrow_step(field);
  const double scale = 0.5 * spacing / largest * "mm"_per_si;
  for (const auto k : indices(field.sliding_major)) {
    if (!has_arrow(field.along_major[k], field.semi_major, field) ||
        !has_arrow(field.along_minor[k], field.semi_minor, field))
      continue;
    const double x = field.along_major[k] * "mm"_per_si;
    const double y = field.along_minor[k] * "mm"_per_si;
    const double dx = scale * field.sliding_major[k], dy = scale * field.sliding_minor[k];
    line.parts.push_back({{x - dx, y - dy}, {x + dx, y + dy}});
  }
  return line;
}

/// Thread and normal load, where the case has loads: of the most loaded thread unless another is
/// meant.
std::string thread_title(const LoadCaseResult& result, Interface i, std::optional<std::size_t> thread) {
  if (!result.threads) return interface_title(i);
  const std::vector<double>& loads = (*result.threads)[i].normal_load;
  if (!thread) thread = index_of_largest(loads);
  if (!thread) return interface_title(i);
  return fmt::format("{}, thread {}: {}", interface_title(i), *thread + 1,
                     in_table_unit(fmt::format("{:.4g} N", loads[*thread])));
}

Panel patch_panel(const LoadCaseResult& result, const PatchField& field, Interface i,
                  std::optional<std::size_t> thread) {
  Panel panel{thread_title(result, i, thread)};
  panel.map = friction_map(field);
  panel.series = {{kOutline, {ellipse(0.0, 0.0, field.semi_major * "mm"_per_si, field.semi_minor * "mm"_per_si, 0.0)}},
                  arrows(field)};
  panel.labels.push_back(
      {"longest arrow " + in_table_unit(fmt::format("{:.3g} mm/s", largest_speed(field) * "mm"_per_si)), 0.03, 0.05,
       true});
  return panel;
}

/// Scale from zero, unless friction is so even that its differences would not show.
ColourScale friction_scale(const PerInterface<PatchField>& fields) {
  Range shown;
  for (const Interface i : kInterfaces)
    for (const double value : fields[i].friction_coefficient) shown.include(value);
  const auto [least, largest] = shown;
  const bool is_even = least > 0.5 * largest && largest - least > 1e-3 * largest;
  return {"Friction coefficient", "", is_even ? least : 0.0, largest > 0.0 ? largest : 1.0};
}

Figure patch_figure(std::string name, const LoadCaseResult& result, const PerInterface<PatchField>& fields,
                    std::optional<std::size_t> thread) {
  Figure figure{std::move(name),
                "Friction and sliding at the contacts, load case " + shown_name(result.load_case.name)};
  figure.columns = std::size(kInterfaces);
  figure.aspect = 0.9;
  figure.to_scale = true;
  figure.colours = friction_scale(fields);
  figure.add("sliding velocity", arrows_of(Colour::ink));
  figure.add("contact ellipse", line_of(Colour::reference));
  double half = 0.0;
  for (const Interface i : kInterfaces) {
    figure.panels.push_back(patch_panel(result, fields[i], i, thread));
    half = std::max(half, 1.2 * fields[i].semi_major * "mm"_per_si);
  }
  figure.x = {"Along the major axis", "mm", -half, half};
  figure.y = {"Along the minor axis", "mm", -half, half};
  return figure;
}

/// A curve of the figure, in the order of drawing: the sum lies on top.
struct MomentCurve {
  std::string_view title;
  Style style;
  double (*value)(const RollerMoments&);
};

constexpr MomentCurve kCurves[] = {
    {"carrier", line_of(Colour::orange), [](const RollerMoments& m) { return m.carrier; }},
    {"gears", line_of(Colour::green, Dash::dotted), [](const RollerMoments& m) { return m.gears; }},
    {"spin", line_of(Colour::vermillion, Dash::dashed), [](const RollerMoments& m) { return m.spin; }},
    {"contacts", line_of(Colour::blue, Dash::dash_dotted), [](const RollerMoments& m) { return m.contacts; }},
    {"sum", line_of(Colour::ink, Dash::solid, Weight::strong), [](const RollerMoments& m) { return m.residue(); }},
};
/// Indices of the styles after those of the curves.
constexpr std::size_t kIdeal = std::size(kCurves), kRoot = kIdeal + 1, kZero = kIdeal + 2;

/// Transformation of slip ratios in a panel: (slip ratio - from) * factor.
struct SlipAxis {
  std::string label = "Slip ratio";
  std::string unit = {};
  double from = 0.0;
  double factor = 1.0;

  double operator()(double slip_ratio) const { return (slip_ratio - from) * factor; }
};

/// The distance from the ideal slip ratio, in the power of a thousand that needs few digits.
SlipAxis around_ideal(const ResidueCurve& residue, double ideal) {
  double largest = 0.0;
  for (const double slip_ratio : residue.slip_ratio) largest = std::max(largest, std::abs(slip_ratio - ideal));
  constexpr std::string_view kPowers[] = {"", "10⁻³", "10⁻⁶", "10⁻⁹", "10⁻¹²"};
  const double thousands = largest > 0.0 ? std::ceil(-std::log10(largest) / 3.0) : 0.0;
  const auto power = static_cast<std::size_t>(std::clamp(thousands, 0.0, 4.0));
  return {"Slip ratio less the ideal one", std::string(kPowers[power]), ideal,
          std::pow(1e3, static_cast<double>(power))};
}

Polyline curve(const ResidueCurve& residue, const MomentCurve& of, const SlipAxis& axis) {
  Polyline points;
  for (const auto k : indices(residue.slip_ratio))
    points.push_back({axis(residue.slip_ratio[k]), of.value(residue.moments[k]) * "N mm"_per_si});
  return points;
}

/// Range of the values of all curves and zero, with a margin.
Axis moment_axis(const std::vector<Series>& curves) {
  Range range = range_of_y(curves);
  range.include(0.0);
  return fitted({"Moment on a roller", "N mm"}, range);
}

/// The shown slip ratios from one end to the other, with a share of their range on both sides.
Axis slip_ratio_axis(const ResidueCurve& residue, const SlipAxis& shown, double margin) {
  Axis axis{shown.label, shown.unit};
  if (residue.slip_ratio.empty()) return axis;
  const auto [least, largest] = std::minmax({shown(residue.slip_ratio.front()), shown(residue.slip_ratio.back())});
  axis.from = least;
  axis.to = largest;
  const double widened = axis.to > axis.from ? margin * (axis.to - axis.from) : 1e-3 * shown.factor;
  axis.from -= widened;
  axis.to += widened;
  return axis;
}

Panel residue_panel(std::string title, const ResidueCurve& residue, const SlipResult& slip, const SlipAxis& shown,
                    double margin) {
  Panel panel{std::move(title)};
  for (const auto k : indices(kCurves)) panel.series.push_back({k, {curve(residue, kCurves[k], shown)}});
  panel.references = {
      {kZero, 0.0}, {kIdeal, shown(slip.ideal_slip_ratio), true}, {kRoot, shown(slip.slip_ratio), true}};
  panel.x = slip_ratio_axis(residue, shown, margin);
  panel.y = moment_axis(panel.series);
  return panel;
}

}  // namespace

/// Friction coefficient and sliding velocity over the patch of the most loaded thread at both
/// interfaces, in the frame of the ellipse's axes (Sandu 2018, figs. 2.8, 2.9). The longest arrow
/// of each patch is as long as two of them lie apart.
Figure slip_patch_figure(const LoadCaseResult& result, const SlipPictures& pictures) {
  if (!pictures.most_loaded_thread) return {};
  return patch_figure("slip_patches", result, *pictures.most_loaded_thread, std::nullopt);
}

/// Figure of one thread of one load case.
Figure thread_friction_figure(const LoadCaseResult& result, const PerInterface<PatchField>& fields,
                              std::size_t thread) {
  return patch_figure("thread_friction", result, fields, thread);
}

/// Moment on a roller about its axis against the slip ratio: its contributions and their sum over
/// the whole range and, against the distance from the ideal slip ratio, around the root (Sandu
/// 2018, fig. 3.6).
Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures) {
  const SlipResult& slip = result.slip->of_nut_that_carries(result.load_case);
  Figure figure{"slip_residue", fmt::format("Moment on a roller{} about its axis, load case {}",
                                            result.slip->second_nut ? " of the nut that carries the load" : "",
                                            shown_name(result.load_case.name))};
  figure.columns = 2;
  for (const MomentCurve& c : kCurves) figure.add(std::string(c.title), c.style);
  std::ranges::reverse(figure.legend);
  figure.add(fmt::format("ideal slip ratio {:.6f}", slip.ideal_slip_ratio), line_of(Colour::sky));
  figure.add(fmt::format("{} {:.6f}", slip.status == SlipStatus::imposed ? "imposed slip ratio" : "slip ratio",
                         slip.slip_ratio),
             line_of(Colour::muted));
  figure.add(kZeroStyle);
  const ResidueCurve& near_root = pictures.residue_near_root;
  figure.panels = {
      residue_panel("Whole range", pictures.residue, slip, SlipAxis{}, 0.04),
      residue_panel("Around the slip ratio", near_root, slip, around_ideal(near_root, slip.ideal_slip_ratio), 0.08)};
  return figure;
}

namespace {

using enum Picture::Drawn;

constexpr const char* kConvergedSlip = "a load case whose slip converged";
constexpr const char* kSlipOfRollers = "a load case of `model: {mechanism: full}` whose slip converged";

/// Fields of the load cases, by their index: integrated once for all pictures of them.
using SlipFields = std::map<std::size_t, SlipPictures>;

/// Figures for the load cases whose slip converged, at most four; if there are several, names end in `_1`, `_2`, ..
auto of_slip(const Result& result, std::function<Figure(std::size_t)> make) {
  return [&result, make = std::move(make)](const FigureOptions& options) {
    constexpr std::size_t kMost = 4;
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < result.load_cases.size() && cases.size() < kMost; ++k)
      if (has_slip(result.load_cases[k]) && (!options.load_case || k == *options.load_case)) cases.push_back(k);
    Figures figures;
    for (const auto k : indices(cases)) {
      figures.push_back(make(cases[k]));
      if (cases.size() > 1) figures.back().name += fmt::format("_{}", k + 1);
    }
    return figures;
  };
}

}  // namespace

Pictures slip_pictures(const Case& c, const Result& r) {
  const auto fields = std::make_shared<SlipFields>();
  using OfFields = Figure (*)(const LoadCaseResult&, const SlipPictures&);
  const auto of_fields = [&](OfFields make) {
    return of_slip(r, [&c, &r, fields, make](std::size_t k) {
      if (!fields->contains(k)) fields->emplace(k, slip_pictures(c, r, k));
      return make(r.load_cases[k], fields->at(k));
    });
  };
  const bool mixed = c.friction && c.friction->is(contact::Lubrication::mixed);
  return with(
      {{"power_by_source", kConvergedSlip, of_result(r, power_by_source)},
       {"thread_power", kConvergedSlip, of_result(r, thread_power)},
       {"friction", kConvergedSlip, of_case(r, has_thread_slip, friction)},
       {"roller_power", kSlipOfRollers, of_result(r, roller_power)},
       {"roller_friction", kSlipOfRollers, of_result(r, roller_friction)},
       {"stribeck", kConvergedSlip,
        of_slip(r, [&c, &r](std::size_t k) { return stribeck_figure(r.load_cases[k], stribeck_curve(c, r, k)); }),
        drawn_if(mixed)},
       {"slip_patches", kConvergedSlip, of_fields(slip_patch_figure)},
       {"slip_residue", kConvergedSlip, of_fields(slip_residue_figure)},
       {"thread_friction", kConvergedSlip,
        [&c, &r](const FigureOptions& options) { return thread_friction(c, r, options); }, by_name},
       {"heat_cycle", "a `duty` in `heat` that comes to repeat itself",
        [&r](const FigureOptions&) { return in_shown_units(heat_cycle(r)); }}},
      solve_pictures(r, has_butterflies_of_load(c)));
}

namespace {

constexpr std::size_t kMostFigures = 4;

constexpr Colour kSourceColours[] = {Colour::blue, Colour::vermillion, Colour::green, Colour::sky, Colour::orange};
static_assert(std::size(kSourceColours) == std::size(kPowerSources));

/// A result and where it stands on the axis.
struct SweepPoint {
  double x = 0.0;
  const SlipResult* slip = nullptr;
};

/// Points sorted by ascending x.
std::vector<SweepPoint> sweep(const std::vector<double>& x, const std::vector<SlipResult>& results) {
  std::vector<SweepPoint> points;
  for (std::size_t k = 0; k < std::min(x.size(), results.size()); ++k) points.push_back({x[k], &results[k]});
  std::ranges::stable_sort(points, {}, &SweepPoint::x);
  return points;
}

/// Neighbours that all have an answer.
std::vector<std::vector<SweepPoint>> unbroken(const std::vector<SweepPoint>& points) {
  std::vector<std::vector<SweepPoint>> runs(1);
  for (const SweepPoint& point : points)
    if (point.slip->converged())
      runs.back().push_back(point);
    else if (!runs.back().empty())
      runs.emplace_back();
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

double power_below(const SlipResult& slip, std::size_t source) {
  double sum = 0.0;
  for (const auto k : up_to(source)) sum += slip.power.*kPowerSources[k].value;
  return sum;
}

/// Line of the sums of the sources before this one.
Polyline sums_line(const std::vector<SweepPoint>& run, std::size_t source, double factor) {
  Polyline line;
  for (const SweepPoint& p : run) line.push_back({p.x, factor * power_below(*p.slip, source)});
  return line;
}

/// The polygon between the sums without and with the source.
Polyline area(const std::vector<SweepPoint>& run, std::size_t source, double factor) {
  Polyline polygon = sums_line(run, source, factor);
  const Polyline above = sums_line(run, source + 1, factor);
  polygon.insert(polygon.end(), above.rbegin(), above.rend());
  return polygon;
}

Polyline efficiency_line(const std::vector<SweepPoint>& run) {
  Polyline line;
  for (const SweepPoint& p : run)
    if (p.slip->efficiency) line.push_back({p.x, *p.slip->efficiency * "%"_per_si});
  return line;
}

bool has_power(const std::vector<std::vector<SweepPoint>>& runs, const PowerSource& source) {
  for (const auto& run : runs)
    for (const SweepPoint& p : run)
      if (p.slip->power.*source.value > 0.0) return true;
  return false;
}

/// The points of the options in both panels.
void add_references(Figure& figure, const PowerFigureOptions& options, double factor) {
  for (const auto k : indices(options.references)) {
    const ReferencePoint& point = options.references[k];
    const std::size_t style =
        figure.add(point.title, points_of(palette(1 + k), static_cast<Mark>(1 + k % 8), Weight::strong));
    if (point.power_loss) figure.panels[0].series.push_back({style, {{{point.x, *point.power_loss * factor}}}});
    if (point.efficiency) figure.panels[1].series.push_back({style, {{{point.x, *point.efficiency * "%"_per_si}}}});
  }
}

void add_comparison(Figure& figure, const PowerFigureOptions& options) {
  if (options.comparison.empty()) return;
  Polyline line;
  for (const auto& [x, efficiency] : options.comparison) line.push_back({x, efficiency * "%"_per_si});
  const std::size_t style = figure.add(options.comparison_title, line_of(Colour::reference, Dash::dashed));
  figure.panels[1].series.push_back({style, {std::move(line)}});
}

Series series_of(std::size_t style, const std::vector<std::vector<SweepPoint>>& runs, auto part) {
  Series line{style};
  for (const auto& run : runs) line.parts.push_back(part(run));
  return line;
}

/// A bar for each load case, stacked.
Figure power_bars(std::vector<const LoadCaseResult*> cases) {
  constexpr std::size_t kMostBars = 12;
  Figure figure{"power_by_source", "Power lost by source"};
  keep_first(cases, kMostBars, figure.title);
  figure.y = {"Power lost", "W", 0.0};
  const double middle = 0.5 * static_cast<double>(cases.size() + 1), reach = std::max(middle - 0.4, 1.1);
  figure.x = {"", "", middle - reach, middle + reach};
  Panel& panel = figure.panels.emplace_back();
  for (const auto k : indices(kPowerSources)) {
    Series bars;
    for (const auto c : indices(cases)) {
      const SlipResult& slip = *cases[c]->slip;
      const double at = static_cast<double>(c + 1), power = slip.power.*kPowerSources[k].value;
      const double below = power_below(slip, k);
      if (power > 0.0) bars.parts.push_back(rectangle(at - 0.3, at + 0.3, below, below + power));
    }
    if (bars.parts.empty()) continue;
    bars.style = figure.add(std::string(kPowerSources[k].title), area_of(kSourceColours[k]));
    panel.series.push_back(std::move(bars));
  }
  for (const LoadCaseResult* c : cases)
    figure.x.ticks.push_back({static_cast<double>(figure.x.ticks.size() + 1), shown_name(c->load_case.name)});
  fit_y_range(figure);
  return figure;
}

}  // namespace

Figure power_by_source_figure(const std::vector<double>& x, const Axis& axis, const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options) {
  const auto runs = unbroken(sweep(x, results));
  const double factor = options.relative_to ? "%"_per_si / *options.relative_to : 1.0;
  Figure figure{options.name, options.title};
  figure.columns = 2;
  figure.panels.resize(2);
  Panel& power = figure.panels[0];
  power.title = "Power lost";
  for (const auto k : indices(kPowerSources)) {
    if (!has_power(runs, kPowerSources[k])) continue;
    const std::size_t style = figure.add(std::string(kPowerSources[k].title), area_of(kSourceColours[k]));
    power.series.push_back(series_of(style, runs, [&](const auto& r) { return area(r, k, factor); }));
  }
  power.series.push_back(series_of(figure.add(line_of(Colour::ink, Dash::solid, Weight::thin)), runs,
                                   [&](const auto& r) { return sums_line(r, std::size(kPowerSources), factor); }));
  Panel& efficiency = figure.panels[1];
  efficiency.title = "Efficiency";
  const std::size_t style = figure.add("efficiency", line_of(Colour::ink, Dash::solid, Weight::strong));
  efficiency.series.push_back(series_of(style, runs, efficiency_line));
  add_comparison(figure, options);
  add_references(figure, options, factor);
  figure.x = axis;
  figure.x.from = runs.front().front().x;
  figure.x.to = runs.back().back().x;
  power.y = fitted({"Power lost", options.relative_to ? "% of the file's" : "W"}, range_of_y(power.series), true);
  efficiency.y = fitted({"Efficiency", "%"}, range_of_y(efficiency.series));
  return figure;
}

Figures power_by_source(const Result& result, const FigureOptions& options) {
  Figures figures;
  std::vector<const LoadCaseResult*> cases;
  for (const LoadCaseResult* load_case : chosen(result, options))
    if (has_slip(*load_case)) cases.push_back(load_case);
  if (cases.empty()) return {};
  std::vector<LoadCaseResult> kept;
  for (const LoadCaseResult* load_case : cases) kept.push_back(*load_case);
  const auto sweeps = loaded_configurations(kept, kMinSweepPoints, has_slip);
  for (const LoadedConfiguration& configuration : sweeps)
    for (const CaseGroup& group : configuration.groups) {
      if (figures.size() == kMostFigures) return figures;
      std::vector<double> force;
      std::vector<SlipResult> slips;
      for (const LoadCaseResult* load_case : group.cases) {
        force.push_back(load_case->load_case.axial_force * "kN"_per_si);
        slips.push_back(*load_case->slip);
      }
      PowerFigureOptions shown;
      if (!figures.empty()) shown.name += fmt::format("_{}", figures.size() + 1);
      shown.title += ", " + shown_name(group.name);
      figures.push_back(power_by_source_figure(force, {"Axial load", "kN"}, slips, shown));
    }
  if (figures.empty()) figures.push_back(power_bars(std::move(cases)));
  return figures;
}

namespace {

constexpr double kRpm = "rpm"_per_si;

/// The values over the speed; a line ends where there is none.
template <class Value>
Series over_speed(std::size_t style, const StribeckCurve& curve, const std::vector<Value>& values) {
  Series line{style};
  for (const auto k : indices(values)) line.add(curve.speed[k] * kRpm, values[k]);
  return line;
}

Axis decades(std::string label, std::string unit) {
  Axis axis{std::move(label), std::move(unit)};
  axis.logarithmic = true;
  return axis;
}

}  // namespace

Figure stribeck_figure(const LoadCaseResult& result, const StribeckCurve& curve) {
  Figure figure{"stribeck", "Friction over the speed, load case " + shown_name(result.load_case.name)};
  figure.columns = 2;
  PerInterface<std::size_t> style;
  for (const Interface i : kInterfaces)
    style[i] = figure.add(interface_title(i),
                          line_of(colour_of(body_of(i)), i == Interface::nut ? Dash::dashed : Dash::solid));
  const std::size_t whole = figure.add("whole mechanism", line_of(Colour::ink));
  const std::size_t speed = figure.add("speed of the case", line_of(Colour::muted));

  Panel& friction = figure.panels.emplace_back(Panel{"Friction, most loaded threads"});
  for (const Interface i : kInterfaces) friction.series.push_back(over_speed(style[i], curve, curve.friction[i]));
  friction.y = fitted({"Friction coefficient"}, range_of_y(friction.series), true);

  Panel& efficiency = figure.panels.emplace_back(Panel{"Efficiency"});
  std::vector<std::optional<double>> percent = curve.efficiency;
  for (std::optional<double>& value : percent)
    if (value) *value *= "%"_per_si;
  efficiency.series.push_back(over_speed(whole, curve, percent));
  efficiency.y = fitted({"Efficiency", "%"}, range_of_y(efficiency.series));

  Panel& power = figure.panels.emplace_back(Panel{"Power lost"});
  power.series.push_back(over_speed(whole, curve, curve.power));
  power.y = decades("Power lost", "W");

  if (!curve.film_ratio.screw.empty()) {
    Panel& film = figure.panels.emplace_back(Panel{"Film over roughness"});
    for (const Interface i : kInterfaces) film.series.push_back(over_speed(style[i], curve, curve.film_ratio[i]));
    film.y = decades("Film over roughness", "");
    const std::size_t bounds = figure.add("boundary, mixed, full film", kMeanStyle);
    film.references = {{bounds, kTouchingFlanks}, {bounds, kFullFilm}};
  }
  for (Panel& panel : figure.panels)
    panel.references.push_back({speed, std::abs(result.slip->speed) * "rpm"_per_si, true});
  figure.x = decades("Speed", "rpm");
  return figure;
}

Figures heat_cycle(const Result& result) {
  return result.heat_cycle && result.heat_cycle->converged() ? heat_cycle(*result.heat_cycle) : Figures{};
}

Figures heat_cycle(const HeatCycle& cycle) {
  const PartSeries temperature = celsius_of(cycle.temperature);
  const PartNumbers mean = celsius_of(cycle.mean);
  constexpr double kLong = 2.0 * 3600.0;
  const bool hours = cycle.duration() > kLong;
  const double per_second = hours ? 1.0 / 3600.0 : 1.0;

  Figure figure{"heat_cycle",
                cycle.is_mission() ? "Temperatures over the mission" : "Temperatures over the duty cycle"};
  figure.x = Axis{"Time", hours ? "h" : "s", 0.0, cycle.duration() * per_second};
  figure.y = Axis{"Temperature", "°C"};
  Panel panel;
  const auto add = [&](Part part, std::string name, const std::vector<double>& values, double average) {
    Series line{figure.add(std::move(name), line_of(colour_of(part)))};
    for (const auto k : indices(values)) line.add(cycle.time[k] * per_second, values[k]);
    panel.series.push_back(std::move(line));
    panel.references.push_back({figure.add(line_of(colour_of(part), Dash::dashed, Weight::thin)), average});
  };
  add(Part::screw, "screw", temperature.screw, mean.screw);
  add(Part::roller, "rollers", temperature.rollers, mean.rollers);
  add(Part::nut, "nut", temperature.nut, mean.nut);
  figure.panels.push_back(std::move(panel));
  return {figure};
}

}  // namespace prs
