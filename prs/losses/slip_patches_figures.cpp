#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/losses/slip_parts.h"
#include "prs/losses/slip_record.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

constexpr int kMostArrows = 11;  // Along each axis.

/// Styles of the figure in the order of their legend.
enum PatchStyle : std::size_t { kSliding, kOutline };

/// Cells of the ellipse, those outside without a value.
Map friction_map(const PatchField& field) {
  Map map;
  map.cells = true;
  const auto count = static_cast<std::size_t>(field.points);
  const auto middles = [&](double semi_axis) {
    std::vector<double> at;
    for (std::size_t k = 0; k < count; ++k)
      at.push_back(semi_axis * (2.0 * static_cast<double>(k) + 1.0 - field.points) / field.points *
                   per_si::millimetre);
    return at;
  };
  map.grid = {middles(field.semi_major), middles(field.semi_minor),
              std::vector<double>(count * count, kFree)};
  const auto place = [&](double position, double semi_axis) {
    return static_cast<std::size_t>(
        std::lround((position / semi_axis * field.points + field.points - 1.0) / 2.0));
  };
  for (std::size_t k = 0; k < field.friction_coefficient.size(); ++k)
    map.grid.values[place(field.along_major[k], field.semi_major) * count +
                    place(field.along_minor[k], field.semi_minor)] = field.friction_coefficient[k];
  return map;
}

double largest_speed(const PatchField& field) {
  double largest = 0.0;
  for (std::size_t k = 0; k < field.sliding_major.size(); ++k)
    largest = std::max(largest, std::hypot(field.sliding_major[k], field.sliding_minor[k]));
  return largest;
}

/// Points from one arrow to the next, so that there are not too many.
int arrow_step(const PatchField& field) { return (field.points + kMostArrows - 1) / kMostArrows; }

/// Whether the point in a column or row of the grid is one that has an arrow; the middle one has.
bool has_arrow(double position, double semi_axis, const PatchField& field) {
  const double cell = 2.0 * semi_axis / field.points;
  return std::lround((position + semi_axis) / cell - 0.5) % arrow_step(field) ==
         (field.points / 2) % arrow_step(field);
}

/// Sliding velocities, the middle of each arrow at its point.
Series arrows(const PatchField& field) {
  Series line{kSliding};
  const double largest = largest_speed(field);
  if (!(largest > 0.0)) return line;
  const double spacing = 2.0 * field.semi_minor / field.points * arrow_step(field);
  const double scale = 0.5 * spacing / largest * per_si::millimetre;
  for (std::size_t k = 0; k < field.sliding_major.size(); ++k) {
    if (!has_arrow(field.along_major[k], field.semi_major, field) ||
        !has_arrow(field.along_minor[k], field.semi_minor, field))
      continue;
    const double x = field.along_major[k] * per_si::millimetre;
    const double y = field.along_minor[k] * per_si::millimetre;
    const double dx = scale * field.sliding_major[k], dy = scale * field.sliding_minor[k];
    line.parts.push_back({{x - dx, y - dy}, {x + dx, y + dy}});
  }
  return line;
}

/// Thread and normal load, where the case has loads: of the most loaded thread unless another is
/// meant.
std::string thread_title(const LoadCaseResult& result, Interface i,
                         std::optional<std::size_t> thread) {
  if (!result.threads) return interface_title(i);
  const std::vector<double>& loads = (*result.threads)[i].normal_load;
  if (!thread) thread = index_of_largest(loads);
  if (!thread) return interface_title(i);
  return fmt::format("{}, thread {}: {:.4g} N", interface_title(i), *thread + 1, loads[*thread]);
}

Panel patch_panel(const LoadCaseResult& result, const PatchField& field, Interface i,
                  std::optional<std::size_t> thread) {
  Panel panel;
  panel.title = thread_title(result, i, thread);
  panel.map = friction_map(field);
  panel.series = {{kOutline,
                   {ellipse(0.0, 0.0, field.semi_major * per_si::millimetre,
                            field.semi_minor * per_si::millimetre, 0.0)}},
                  arrows(field)};
  panel.labels.push_back(
      {fmt::format("longest arrow {:.3g} mm/s", largest_speed(field) * per_si::millimetre), 0.03,
       0.05, true});
  return panel;
}

/// From zero, unless friction is so even that its differences would not show.
ColourScale friction_scale(const PerInterface<PatchField>& fields) {
  double least = HUGE_VAL, largest = 0.0;
  for (const Interface i : kInterfaces)
    for (const double value : fields[i].friction_coefficient) {
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  const bool is_even = least > 0.5 * largest && largest - least > 1e-3 * largest;
  return {"Friction coefficient", "", is_even ? least : 0.0, largest > 0.0 ? largest : 1.0};
}

Figure patch_figure(std::string name, const LoadCaseResult& result,
                    const PerInterface<PatchField>& fields, std::optional<std::size_t> thread) {
  Figure figure{std::move(name), "Friction and sliding at the contacts, load case " +
                                     shown_name(result.load_case.name)};
  figure.columns = std::size(kInterfaces);
  figure.aspect = 0.9;
  figure.to_scale = true;
  figure.colours = friction_scale(fields);
  figure.add("sliding velocity", arrows_of(Colour::ink));
  figure.add("contact ellipse", line_of(Colour::reference));
  double half = 0.0;
  for (const Interface i : kInterfaces) {
    figure.panels.push_back(patch_panel(result, fields[i], i, thread));
    half = std::max(half, 1.2 * fields[i].semi_major * per_si::millimetre);
  }
  figure.x = {"along the major axis", "mm", -half, half};
  figure.y = {"along the minor axis", "mm", -half, half};
  return figure;
}

}  // namespace

/// Friction coefficient and sliding velocity over the patch of the most loaded thread at both
/// interfaces, in the frame of the ellipse's axes (Sandu 2018, figs. 2.8, 2.9). The longest arrow
/// of each patch is as long as two of them lie apart.
Figure slip_patch_figure(const LoadCaseResult& result, const SlipPictures& pictures) {
  return patch_figure("slip_patches", result, pictures.most_loaded_thread, std::nullopt);
}

/// The same of one thread of one load case.
Figure thread_friction_figure(const LoadCaseResult& result, const PerInterface<PatchField>& fields,
                              std::size_t thread) {
  return patch_figure("thread_friction", result, fields, thread);
}

}  // namespace prs
