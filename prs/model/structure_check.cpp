#include "prs/model/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

void check_flanges(const Structure::Nut& nut, const std::optional<double>& pitch_diameter,
                   Problems& problems) {
  const double tolerance = kSamePlace * nut.length;
  for (std::size_t i = 0; i < nut.flanges.size(); ++i) {
    const Structure::Flange& f = nut.flanges[i];
    const auto path = [i](std::string_view key) {
      return fmt::format("structure.nut.flanges[{}].{}", i, key);
    };
    if (!(f.from < f.to))
      problems.add(path("to"), fmt::format("got {}; expected a position beyond `from`, {}; swap "
                                           "the two",
                                           mm(f.to), mm(f.from)));
    if (f.from < -tolerance)
      problems.add(path("from"), fmt::format("got {}; expected a position on the nut, 0 mm to {}; "
                                             "move the flange",
                                             mm(f.from), mm(nut.length)));
    if (f.to > nut.length + tolerance)
      problems.add(path("to"), fmt::format("got {}; expected a position on the nut, 0 mm to {}; "
                                           "move the flange or lengthen the nut",
                                           mm(f.to), mm(nut.length)));
    if (pitch_diameter && f.outer_diameter <= *pitch_diameter)
      problems.add(path("outer_diameter"),
                   fmt::format("got {}; expected more than the nut's pitch diameter, {}; check the "
                               "two diameters",
                               mm(f.outer_diameter), mm(*pitch_diameter)));
  }
  const auto check_neighbours = [&](std::size_t before_index, std::size_t index) {
    const Structure::Flange& before = nut.flanges[before_index];
    const Structure::Flange& f = nut.flanges[index];
    if (f.from < before.to - tolerance)
      problems.add(fmt::format("structure.nut.flanges[{}]", index),
                   fmt::format("got a flange from {} that overlaps the one from {} to {}; expected "
                               "flanges that touch at most; move one of them",
                               mm(f.from), mm(before.from), mm(before.to)));
  };
  if (std::ranges::is_sorted(nut.flanges, {}, &Structure::Flange::from)) {
    for (std::size_t k = 1; k < nut.flanges.size(); ++k) check_neighbours(k - 1, k);
    return;
  }
  std::vector<std::size_t> order(nut.flanges.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nut.flanges[i].from; });
  for (std::size_t k = 1; k < order.size(); ++k) check_neighbours(order[k - 1], order[k]);
}

/// A length that is out of all proportion to the part it belongs to: most often a wrong unit.
struct Proportion {
  std::string_view path;
  double length;
  std::optional<double> diameter;  ///< Diameter of the part [m].
  double least, greatest;          ///< Multiples of it.
};

void check_proportions(const Structure& s, const Mechanism& m, Problems& problems) {
  const auto& d = m.pitch_diameter;
  const Proportion proportions[] = {
      {"mechanism.lead", axial_pitch(m), d.roller, 1e-3, 2.0},
      {"structure.screw.free_length", s.screw.free_length, d.screw, 0.0, 1e4},
      {"structure.roller.end_length", s.roller.end_length, d.roller, 1e-3, 1e3},
      {"structure.roller.end_diameter", s.roller.end_diameter, d.roller, 2e-2, 20.0},
      {"structure.nut.length", s.nut.length, d.nut, 0.0, 1e4},
      {"structure.nut.outer_diameter", s.nut.outer_diameter, d.nut, 1.0001, 100.0},
  };
  for (const auto& [path, length, diameter, least, greatest] : proportions)
    if (diameter && (length < least * *diameter || length > greatest * *diameter))
      problems.add(std::string(path),
                   fmt::format("got {}{}; expected {} to {}, {:g} to {:g} times the part's pitch "
                               "diameter; check the unit",
                               path == "mechanism.lead" ? "an axial pitch of " : "", mm(length),
                               mm(least * *diameter), mm(greatest * *diameter), least, greatest));
}

void check_shoulder(const Structure::Nut& nut, const std::optional<double>& pitch_diameter,
                    Problems& problems) {
  const Structure::Shoulder& s = *nut.shoulder;
  double outer = nut.outer_diameter;
  for (const Structure::Flange& f : nut.flanges) outer = std::max(outer, f.outer_diameter);
  if (!(s.inner_diameter < s.outer_diameter))
    problems.add("structure.nut.shoulder.outer_diameter",
                 fmt::format("got {}; expected more than its inner diameter, {}; swap the two",
                             mm(s.outer_diameter), mm(s.inner_diameter)));
  if (s.inner_diameter >= outer)
    problems.add("structure.nut.shoulder.inner_diameter",
                 fmt::format("got {}; expected less than the largest diameter of the nut, {}, or "
                             "it misses the nut; make it smaller",
                             mm(s.inner_diameter), mm(outer)));
  if (pitch_diameter && s.outer_diameter <= *pitch_diameter)
    problems.add("structure.nut.shoulder.outer_diameter",
                 fmt::format("got {}; expected more than the nut's pitch diameter, {}, or it "
                             "misses the nut; make it larger",
                             mm(s.outer_diameter), mm(*pitch_diameter)));
}

}  // namespace

void check_structure(const Structure& s, const Mechanism& m, Problems& problems) {
  const auto& diameter = m.pitch_diameter;
  if (diameter.screw && s.screw.bore >= *diameter.screw)
    problems.add("structure.screw.bore",
                 fmt::format("got {}; expected less than the screw's pitch diameter, {}; check the "
                             "two diameters",
                             mm(s.screw.bore), mm(*diameter.screw)));
  if (diameter.nut && s.nut.outer_diameter <= *diameter.nut)
    problems.add(
        "structure.nut.outer_diameter",
        fmt::format("got {}; expected more than the nut's pitch diameter, {}; check the two "
                    "diameters",
                    mm(s.nut.outer_diameter), mm(*diameter.nut)));
  const double tolerance = kSamePlace * s.nut.length;
  const std::pair<std::string_view, std::optional<double>> sections[] = {
      {"tension", s.nut.thrust.tension}, {"compression", s.nut.thrust.compression}};
  for (const auto& [direction, section] : sections)
    if (section && (*section < -tolerance || *section > s.nut.length + tolerance))
      problems.add(
          fmt::format("structure.nut.thrust.{}", direction),
          fmt::format("got {}; expected a position on the nut, 0 mm to {}; move the section",
                      mm(*section), mm(s.nut.length)));
  check_flanges(s.nut, diameter.nut, problems);
  if (s.nut.shoulder) check_shoulder(s.nut, diameter.nut, problems);
  check_proportions(s, m, problems);
}

}  // namespace prs
