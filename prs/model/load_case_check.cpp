#include "prs/model/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <unordered_set>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Under preload the screw also runs without a load.
void check_force(const LoadCase& load, bool preloaded, Problems& problems) {
  const double written = load.axial_force;
  const bool may_be_zero = preloaded && load.share == LoadCase::Share::solved;
  if (load.direction ? written > 0.0 || (may_be_zero && written == 0.0) : written != 0.0) return;
  problems.add(load.input_path + ".axial_force",
               fmt::format("got {} in case `{}`; expected a force {}; {}", newton(written),
                           load.name, load.direction ? "> 0" : "other than 0",
                           load.direction ? "`direction` gives its sense" : "give it a value"));
}

/// Which of the load cases, one after the other, has the name of an earlier one. Up to some hundred
/// names, as designs of a study have them, need no memory.
class RepeatedNames {
 public:
  explicit RepeatedNames(const std::vector<LoadCase>& loads) : loads_(loads) {}

  bool next(std::string_view name) {
    const auto earlier = static_cast<std::ptrdiff_t>(next_++);
    if (loads_.size() > kMany) return !names_.insert(name).second;
    if (loads_.size() > kFew) {
      if (!seen_) seen_.emplace();
      const std::size_t hash = hash_of(name);
      if (!seen_->test(hash)) {
        seen_->set(hash);
        return false;
      }
    }
    const auto same = [&](const LoadCase& load) { return load.name == name; };
    return std::any_of(loads_.begin(), loads_.begin() + earlier, same);
  }

 private:
  static constexpr std::size_t kFew = 8, kMany = 256;
  static constexpr int kHashBits = 12;

  /// Names of a range differ at the end.
  static std::size_t hash_of(std::string_view name) {
    std::uint64_t end = 0;
    const std::size_t size = std::min(name.size(), sizeof end);
    std::memcpy(&end, name.data() + name.size() - size, size);
    return (end * 0x9E3779B97F4A7C15U) >> (64 - kHashBits);
  }

  const std::vector<LoadCase>& loads_;
  std::size_t next_ = 0;
  std::optional<std::bitset<std::size_t{1} << kHashBits>> seen_;
  std::unordered_set<std::string_view> names_;
};

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
    problems.add(
        "mechanism.contacts_per_roller",
        fmt::format("got {}, which span {}; expected contacts within the nut's length, {}; "
                    "take at most {} or lengthen the nut",
                    m.contacts_per_roller, mm(room.span), mm(nut.length),
                    1 + static_cast<int>((nut.length + room.tolerance) / axial_pitch(m))));
  else
    problems.add(fmt::format("{}.position", block),
                 fmt::format("got {}; expected 0 mm to {}, so that all {} contacts lie on the nut; "
                             "move the roller or lengthen the nut",
                             mm(position), mm(std::max(room.last, 0.0)), m.contacts_per_roller));
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
  std::optional<RoomOnNut> room;
  if (c.structure) room.emplace(c.mechanism, c.structure->nut);
  for (const LoadCase& load : c.load_cases) {
    if (repeated.next(load.name))
      problems.add(load.input_path + ".name",
                   fmt::format("got `{}` a second time; expected names that differ, ranges "
                               "expanded; rename this case",
                               load.name));
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
