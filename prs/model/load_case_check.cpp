#include "prs/model/block_checks.h"

#include <algorithm>
#include <unordered_set>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Under preload the screw also runs without a load.
void check_force(const LoadCase& load, bool preloaded, Problems& problems) {
  const double written = load.axial_force;
  const bool may_be_zero = preloaded && load.is_solved();
  if (load.direction ? written > 0.0 || (may_be_zero && written == 0.0) : written != 0.0) return;
  problems.add(load.input_path + ".axial_force", "got {} in case `{}`; expected a force {}; {}",
               newton(written), load.name, load.direction ? "> 0" : "other than 0",
               load.direction ? "`direction` gives its sense" : "give it a value");
}

/// Where the first contact can lie so that all are on the nut [m].
struct RoomOnNut {
  double span, last, tolerance;

  RoomOnNut(const Mechanism& m, const Structure::Nut& nut)
      : span((m.contacts_per_roller - 1) * axial_pitch(m)),
        last(nut.length - span),
        tolerance(kSamePlace * nut.length) {}
  bool none() const { return last < -tolerance; }
  bool holds(double position) const {
    return !none() && !(position < -tolerance || position > last + tolerance);
  }
};

}  // namespace

void check_position(std::string_view block, double position, const Mechanism& m,
                    const Structure::Nut& nut, Problems& problems) {
  const RoomOnNut room(m, nut);
  if (room.holds(position)) return;
  if (room.none())
    problems.add("mechanism.contacts_per_roller",
                 "got {}, which span {}; expected contacts within the nut's length, {}; take at "
                 "most {} or lengthen the nut",
                 m.contacts_per_roller, mm(room.span), mm(nut.length),
                 1 + static_cast<int>((nut.length + room.tolerance) / axial_pitch(m)));
  else
    problems.add(fmt::format("{}.position", block),
                 "got {}; expected 0 mm to {}, so that all {} contacts lie on the nut; move the "
                 "roller or lengthen the nut",
                 mm(position), mm(std::max(room.last, 0.0)), m.contacts_per_roller);
}

void check_thrust(Direction direction, std::string_view load, const Structure::Nut& nut,
                  Problems& problems) {
  if (direction == Direction::tension ? nut.thrust.tension : nut.thrust.compression) return;
  problems.add(fmt::format("structure.nut.thrust.{}", name(direction)),
               "missing; expected the axial position of the section that holds {} in case `{}`; "
               "add `{}: 10 mm`, for example",
               name(direction), load, name(direction));
}

void check_load_cases(const Case& c, Problems& problems) {
  // Few names, as designs of a study have them, are compared one by one, which takes no memory.
  constexpr std::size_t kFew = 64;
  std::unordered_set<std::string_view> names;
  const auto is_repeated = [&](const LoadCase& load) {
    if (c.load_cases.size() > kFew) return !names.insert(load.name).second;
    const LoadCase* first = c.load_cases.data();
    return std::any_of(first, &load, [&](const LoadCase& l) { return l.name == load.name; });
  };
  std::optional<RoomOnNut> room;
  if (c.structure) room.emplace(c.mechanism, c.structure->nut);
  for (const LoadCase& load : c.load_cases) {
    if (is_repeated(load))
      problems.add(
          load.input_path + ".name",
          "got `{}` a second time; expected names that differ, ranges expanded; rename this case",
          load.name);
    check_force(load, c.preload && !c.preload->backlash, problems);
    if (load.share == LoadCase::Share::equal || !c.structure || !load.direction || !load.position)
      continue;
    if (!room->holds(*load.position))
      check_position(load.input_path, *load.position, c.mechanism, c.structure->nut, problems);
    check_thrust(*load.direction, load.name, c.structure->nut, problems);
  }
}

void check_loads(const Case& c, Problems& problems) {
  if (c.model.loads != ModelOptions::Loads::running) return;
  if (!c.friction)
    problems.add_missing("friction", "a law of friction for `model: {loads: running}`",
                         "{model: {coulomb: 0.1}}");
  const auto check_share = [&](LoadCase::Share share, std::string path) {
    if (share == LoadCase::Share::equal)
      problems.add(std::move(path),
                   "got `equal` with `model: {loads: running}`, whose loads are solved; expected "
                   "`solved`; delete it, or write `loads: static`");
  };
  bool has_speed = !c.life || c.operation.has_value();
  for (const LoadCase& load : c.load_cases) {
    check_share(load.share, path_in(load, "share"));
    has_speed = has_speed && (load.speed || c.operation);
  }
  if (c.life) check_share(c.life->share, "life.share");
  if (!has_speed)
    problems.add_missing("operation", "the speed for `model: {loads: running}`",
                         "{speed: 400 rpm}");
}

}  // namespace prs
