#include "prs/losses/preload_analysis.h"

#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/preload/preload_record.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"

namespace prs {
namespace {

enum CurveStyle : std::size_t { kWithout, kWith, kTensionSide, kCompressionSide, kOpening };

constexpr double kKilonewton = "kN"_per_si;

/// Curve (load, value) of the points that converged, interrupted at the others.
Series curve_of(std::size_t style, const PreloadCurve& curve, const auto& value) {
  Series line{style};
  for (const PreloadPoint& point : curve.points)
    line.add(point.axial_force * kKilonewton,
             point.solve.converged() ? std::optional<double>(value(point)) : std::nullopt);
  return line;
}

/// A panel of curves with preload, and without if that is known.
Panel curve_panel(const PreloadResult& r, std::string title, Axis axis, const auto& value) {
  Panel panel{std::move(title)};
  if (r.without_preload) panel.series.push_back(curve_of(kWithout, *r.without_preload, value));
  panel.series.push_back(curve_of(kWith, r.curve, value));
  const Range range = range_of_y(panel.series);
  panel.y = fitted(std::move(axis), range, range.from >= 0.0);
  return panel;
}

Panel side_panel(const PreloadResult& r) {
  Panel panel{"Load of each side"};
  for (const Direction d : kDirections)
    panel.series.push_back(curve_of(d == Direction::tension ? kTensionSide : kCompressionSide, r.curve,
                                    [d](const PreloadPoint& p) { return p.sides[d].axial_load.screw * "kN"_per_si; }));
  panel.y = fitted({"Axial load", "kN"}, range_of_y(panel.series));
  for (const Direction d : kDirections) {
    if (!r.opening_force[d]) continue;
    const double load = sense(d) * -*r.opening_force[d];
    if (load >= r.preload.load.from && load <= r.preload.load.to)
      panel.series.push_back({kOpening, {{{load * "kN"_per_si, 0.0}}}});
  }
  return panel;
}

/// Displacement and tangent stiffness over the external load, with preload and without, and the load of each side.
Figure preload_curves(const PreloadResult& r) {
  if (!r.at_rest.solve.converged()) return {};
  Figure figure{"preload", r.preload.backlash ? "Axial play, at rest" : "Preload, at rest"};
  figure.x = {std::string(kSignedForce), "kN", r.preload.load.from * "kN"_per_si, r.preload.load.to * "kN"_per_si};
  figure.columns = 3;
  figure.aspect = 1.1;
  figure.add(line_of(Colour::grey, Dash::dashed));
  if (r.without_preload) figure.legend.push_back({"without preload", kWithout});
  figure.add(r.preload.backlash ? "with play" : "with preload", line_of(Colour::blue, Dash::solid, Weight::strong));
  const bool single = r.preload.arrangement == Preload::Arrangement::single_nut;
  figure.add(single ? "tension flanks" : "second nut", line_of(Colour::vermillion));
  figure.add(single ? "compression flanks" : "first nut", line_of(Colour::orange, Dash::dashed));
  if (r.opening_force.tension || r.opening_force.compression)
    figure.add("a side opens", points_of(Colour::ink, Mark::circle));
  figure.panels = {
      curve_panel(r, "Displacement", {"Displacement", "µm"},
                  [](const PreloadPoint& p) -> std::optional<double> { return p.axial_displacement * "µm"_per_si; }),
      curve_panel(r, "Stiffness", {"Tangent stiffness", "N/µm"},
                  [](const PreloadPoint& p) -> std::optional<double> {
                    if (!p.tangent_stiffness) return std::nullopt;
                    return *p.tangent_stiffness * "N/µm"_per_si;
                  }),
      side_panel(r)};
  return figure;
}

constexpr std::size_t kMostRows = 24;
constexpr double kSmallLoad = 1.0;  ///< Load below which newtons are shown [N].

std::string preload_line(const std::string& what, const std::string& value) { return hanging("  " + what, 49, value); }

/// One value, or one for each sense of the load.
std::string both(const PerDirection<std::optional<double>>& values, std::string_view unit, int decimals) {
  const std::string tension = fixed_with_unit(values.tension, unit, decimals);
  const std::string compression = fixed_with_unit(values.compression, unit, decimals);
  if (tension == compression) return tension;
  return fmt::format("{} in tension, {} in compression", tension, compression);
}

std::string summary(const PreloadResult& r) {
  const bool single = r.preload.arrangement == Preload::Arrangement::single_nut;
  std::string text = single ? "Single nut, tension and compression flanks of the same threads\n"
                            : "Double nut: the first carries compression, the second tension\n";
  if (r.preload.backlash)
    text += preload_line("axial play", fixed_with_unit(r.preload.backlash, "µm", 3));
  else
    text +=
        preload_line("preload", fixed_with_unit(r.reference_force, "kN", 3)) +
        (r.temperature ? preload_line("at the temperatures of the parts", fixed_with_unit(r.force(), "kN", 3)) : "") +
        preload_line(single ? "oversize of the rollers' pitch diameter" : "oversize of the spacer",
                     fixed_with_unit(r.interference, "µm", 3)) +
        preload_line("a side opens at", !r.opening_force.tension && !r.opening_force.compression
                                            ? "no load of the range"
                                            : both(r.opening_force, "kN", 3)) +
        preload_line("stiffness at zero load", both(r.curve.stiffness_at_zero, "N/µm", 1));
  const std::string load = r.lost_motion_load < kSmallLoad
                               ? fmt::format("{:.3g} {}", shown(r.lost_motion_load, "N"), table_unit("N").text)
                               : fixed_with_unit(r.lost_motion_load, "kN", 3);
  text += preload_line(fmt::format("lost motion between -{} and +{}", load, load),
                       fixed_with_unit(r.curve.lost_motion, "µm", 3) +
                           (r.without_preload ? fmt::format(" (without preload {})",
                                                            fixed_with_unit(r.without_preload->lost_motion, "µm", 3))
                                              : ""));
  return text;
}

constexpr TableRows kCurveRows{0, 14};

/// Cells after the force.
std::vector<std::string> cells(const PreloadPoint& point, const PreloadPoint* loose) {
  const auto side = [&](Direction d) {
    const double load = point.sides[d].axial_load.screw;
    return fixed(load, "kN", force_decimals(load));
  };
  double normal = 0.0;
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces) normal = std::max(normal, point.sides[d].max_normal_load[i]);
  const bool known = loose && loose->solve.converged();
  return {fixed(point.axial_displacement, "µm", 3),
          fixed(point.tangent_stiffness, "N/µm", 1),
          side(Direction::tension),
          side(Direction::compression),
          fixed(normal, "N", 1),
          known ? fixed(loose->axial_displacement, "µm", 3) : std::string(kAbsent)};
}

std::string row(const PreloadResult& r, std::size_t k) {
  const PreloadPoint& point = r.curve.points[k];
  const std::string force = padded(fixed(point.axial_force, "kN", force_decimals(point.axial_force)), 14, false);
  if (!point.solve.converged())
    return fmt::format("{}  NOT CONVERGED ({}), residual {:.1e}\n", force, fe::name(point.solve.status),
                       point.solve.relative_residual);
  return kCurveRows(force, cells(point, r.without_preload ? &r.without_preload->points[k] : nullptr));
}

/// The preload and the curve through zero, within 100 columns. If there are many loads, some evenly spaced ones are
/// shown.
std::string preload_table(const PreloadResult& r) {
  if (!r.at_rest.solve.converged())
    return fmt::format("NOT CONVERGED without external load ({}), residual {:.1e}\n", fe::name(r.at_rest.solve.status),
                       r.at_rest.solve.relative_residual);
  std::string text = summary(r) + '\n';
  text += kCurveRows("", {"force", "displacement", "tangent", "tension side", "compr. side", "max. normal", "without"});
  std::vector<std::string> units;
  for (const char* unit : {"kN", "µm", "N/µm", "kN", "kN", "N", "preload, µm"}) units.push_back(with_table_unit(unit));
  text += kCurveRows("", units);
  const std::size_t count = r.curve.points.size();
  const std::size_t step = (count + kMostRows - 1) / kMostRows;
  for (const auto k : up_to(count))
    if (k % step == 0 || k + 1 == count || !r.curve.points[k].solve.converged()) text += row(r, k);
  if (step > 1) text += fmt::format("  … of {} loads; {}\n", count, all_in("preload.csv"));
  return text + warning_section(r.warnings);
}

}  // namespace

std::string preload_csv(const PreloadResult& result, const CsvStyle& style) {
  CsvRows csv(style);
  using Point = std::optional<PreloadPointOf>;
  const auto add_row = [&](const Point& point, const Point& loose) {
    csv.record("", point, "", "converged");
    csv.record("", point, "status", "iterations");
    csv.record("", point, "axial_displacement_um");
    for (const Direction d : kDirections) {
      const SideLoads side = point ? point->point->sides[d] : SideLoads{};
      const auto field = [&](std::string_view key, double load) {
        csv(fmt::format("{}_side_{}", name(d), key),
            point && point->point->solve.converged() ? std::optional(load) : std::nullopt);
      };
      field("load_N", side.axial_load.screw);
      field("max_normal_load_N", std::max(side.max_normal_load.screw, side.max_normal_load.nut));
    }
    csv.record("without_preload_", loose, "status", "iterations");
    csv("without_preload_displacement_um",
        loose ? quantity<PreloadPointOf>("axial_displacement_um").value.number(*loose) : std::nullopt);
    csv.record("without_preload_", loose, "tangent_stiffness_N_per_um");
    csv.end_row();
  };
  add_row({}, {});
  csv.drop_rows();
  for (const auto k : indices(result.curve.points))
    add_row(PreloadPointOf{&result, &result.curve.points[k]},
            result.without_preload ? Point({&result, &result.without_preload->points[k]}) : std::nullopt);
  return csv.take();
}

namespace {

std::vector<Headline> lost_motion(const PreloadResult& r) {
  if (!r.curve.lost_motion) return {};
  return {{"Lost motion", "lost_motion_um", *r.curve.lost_motion}};
}

}  // namespace

const Analysis<PreloadResult>& preload_analysis() {
  static const std::vector<Place> places = with_contacts({{"preload", describe<PreloadResult>}});
  static const Analysis<PreloadResult> analysis{
      .command = Command::preload,
      .help = "Preload: curve through zero, lost motion, opening loads",
      .file = "preload.json",
      .run = [](const input::Source&, const input::CaseInput& in) { return analyze_warm_preload(in.values); },
      .places = places,
      .put =
          [](Json& document, const PreloadResult& r) {
            put_contacts(document, r.contacts);
            document["preload"] = object_of(r);
          },
      .table = preload_table,
      .files =
          [](const PreloadResult& r, const CsvStyle& style) {
            return std::vector<OutputFile>{{"preload.csv", preload_csv(r, style)}};
          },
      .pictures = [](const PreloadResult& r, const Case&) -> Pictures {
        return {{"preload", "an equilibrium without external load", of_result(r, preload_curves)}};
      },
      .converged = [](const PreloadResult& r) { return r.converged(); },
      .headlines = lost_motion,
      .place = {"Preload", 3}};
  return analysis;
}

}  // namespace prs
