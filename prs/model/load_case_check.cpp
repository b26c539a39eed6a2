#include "prs/model/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

void check_force(const LoadCase& load, Problems& problems) {
  const double written = load.axial_force;
  if (load.direction ? written > 0.0 : written != 0.0) return;
  problems.add(load.input_path + ".axial_force",
               fmt::format("got {} in case `{}`; expected a force {}; {}", newton(written),
                           load.name, load.direction ? "> 0" : "other than 0",
                           load.direction ? "`direction` gives its sense" : "give it a value"));
}

/// Which of the load cases, one after the other, has the name of an earlier one. Few of them, as
/// designs of a study have, need no memory.
class RepeatedNames {
 public:
  explicit RepeatedNames(const std::vector<LoadCase>& loads) : loads_(loads) {}

  bool next(std::string_view name) {
    const std::size_t k = next_++;
    if (loads_.size() > kFew) return !names_.insert(name).second;
    const auto same = [&](const LoadCase& load) { return load.name == name; };
    return std::any_of(loads_.begin(), loads_.begin() + static_cast<std::ptrdiff_t>(k), same);
  }

 private:
  static constexpr std::size_t kFew = 16;
  const std::vector<LoadCase>& loads_;
  std::size_t next_ = 0;
  std::unordered_set<std::string_view> names_;
};

}  // namespace

void check_position(std::string_view block, double position, const Mechanism& m,
                    const Structure::Nut& nut, Problems& problems) {
  const double span = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double last = nut.length - span;
  const double tolerance = kSamePlace * nut.length;
  if (last < -tolerance)
    problems.add(
        "mechanism.contacts_per_roller",
        fmt::format("got {}, which span {}; expected contacts within the nut's length, {}; "
                    "take at most {} or lengthen the nut",
                    m.contacts_per_roller, mm(span), mm(nut.length),
                    1 + static_cast<int>((nut.length + tolerance) / axial_pitch(m))));
  else if (position < -tolerance || position > last + tolerance)
    problems.add(fmt::format("{}.position", block),
                 fmt::format("got {}; expected 0 mm to {}, so that all {} contacts lie on the nut; "
                             "move the roller or lengthen the nut",
                             mm(position), mm(std::max(last, 0.0)), m.contacts_per_roller));
}

void check_thrust(Direction direction, std::string_view load, const Structure::Nut& nut,
                  Problems& problems) {
  if (direction == Direction::tension ? nut.thrust.tension : nut.thrust.compression) return;
  problems.add(fmt::format("structure.nut.thrust.{}", name(direction)),
               fmt::format("missing; expected the axial position of the section that holds {} in "
                           "case `{}`; add `{}: 10 mm`, for example",
                           name(direction), load, name(direction)));
}

void check_load_cases(const Case& c, Problems& problems) {
  RepeatedNames repeated(c.load_cases);
  for (const LoadCase& load : c.load_cases) {
    if (repeated.next(load.name))
      problems.add(load.input_path + ".name",
                   fmt::format("got `{}` a second time; expected names that differ, ranges "
                               "expanded; rename this case",
                               load.name));
    check_force(load, problems);
    if (load.share == LoadCase::Share::equal || !c.structure || !load.direction || !load.position)
      continue;
    check_position(load.input_path, *load.position, c.mechanism, c.structure->nut, problems);
    check_thrust(*load.direction, load.name, c.structure->nut, problems);
  }
}

}  // namespace prs
