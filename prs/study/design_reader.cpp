#include "prs/study/design_reader.h"

#include <map>
#include <unordered_set>

#include "prs/indices.h"
#include "prs/input/varied_input.h"
#include "prs/record/record.h"

namespace prs {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostFrames = 256;

/// Values of an input, before any design is read.
struct Values {
  std::size_t factor = 0;  ///< Index of the factor whose draw sets the value.
  std::string path = {};
  bool number = false;                ///< A drawn number can be set without reading it.
  const input::Unit* unit = nullptr;  ///< None of bare numbers.
  std::vector<double> levels = {};    ///< Levels by `input::slot_value`; NaN where one must be read.
};

Values values_of(const DrawnInput& input, input::CaseFile& file) {
  const Factor& factor = *input.input;
  const input::Slot slot = input::find_slot(file, factor.path);
  Values values{.factor = input.factor, .path = factor.path};
  if (slot.dimension) values.unit = input::find_unit(factor.unit, *slot.dimension);
  values.number =
      slot.kind == input::Slot::Kind::number && (slot.dimension ? values.unit != nullptr : factor.unit.empty());
  const bool numeric = slot.kind == input::Slot::Kind::number || slot.kind == input::Slot::Kind::whole;
  for (const Level& level : factor.levels)
    values.levels.push_back(numeric ? input::slot_value(slot, level.text).value_or(kNoNumber) : kNoNumber);
  return values;
}

/// How an input's value comes into the case: designs that agree in this differ in numbers only.
using FrameShape = std::vector<std::uint32_t>;
constexpr std::uint32_t kAsInFile = 0;
constexpr std::uint32_t kNumber = 1;
constexpr std::uint32_t kFirstLevel = 2;

/// A case file whose numbers are set in place.
struct Frame {
  struct Bound {
    std::size_t input;
    input::Slot slot;
  };

  input::CaseFile file;
  std::vector<Bound> bound;
  std::vector<std::size_t> varied_items;  ///< Items of `load_cases` with a number that is set.
  /// Load cases that stand in checks for all of them: those that vary, and one of each group that is alike in all
  /// checks.
  struct Checked {
    struct Varied {
      std::size_t place;  ///< Here,
      std::size_t index;  ///< among all.
    };
    std::vector<LoadCase> load_cases;
    std::vector<Varied> varied;
  };
  std::optional<Checked> checked;  ///< None: all are looked at.
};

/// Whether checks find the same in both; names must differ from all others.
bool is_checked_alike(const LoadCase& a, const LoadCase& b) {
  const auto sign = [](const LoadCase& load) { return (load.axial_force > 0.0) - (load.axial_force < 0.0); };
  return a.direction == b.direction && a.position == b.position && a.share == b.share && a.speed == b.speed &&
         a.spatial == b.spatial && sign(a) == sign(b);
}

std::optional<Frame::Checked> checked_cases(const std::vector<LoadCase>& all, const std::vector<bool>& varies) {
  std::unordered_set<std::string_view> names;
  for (const LoadCase& load : all)
    if (!names.insert(load.name).second) return std::nullopt;
  Frame::Checked checked;
  for (const auto k : indices(all))
    if (!varies[k] && std::ranges::none_of(checked.load_cases,
                                           [&](const LoadCase& other) { return is_checked_alike(other, all[k]); }))
      checked.load_cases.push_back(all[k]);
  for (const auto k : indices(all)) {
    if (!varies[k]) continue;
    checked.varied.push_back({checked.load_cases.size(), k});
    checked.load_cases.push_back(all[k]);
  }
  return checked;
}

/// 2 of `load_cases[2].axial_force`.
std::optional<std::size_t> load_case_item(std::string_view path) {
  constexpr std::string_view kList = "load_cases";
  if (!path.starts_with(kList)) return std::nullopt;
  path.remove_prefix(kList.size());
  return take_index(path);
}

}  // namespace

struct DesignReader::Parts {
  const input::StudyInput& input;
  std::vector<Values> values = {};  ///< One per drawn input (`drawn_inputs`).
  std::map<FrameShape, std::unique_ptr<Frame>> frames = {};
  FrameShape shape = {};
  Frame* frame = nullptr;  ///< Frame of the last shape.
  FrameShape wanted = {};  ///< FrameShape of the design that is read.
  std::vector<Draw> drawn = {};
  Case read_in_full = {};

  /// The shape of a design; false where a number must be read.
  bool find_shape(const std::vector<Draw>& draws, FrameShape& found) const {
    found.resize(values.size());
    for (const auto i : indices(values)) {
      const Draw& draw = draws[values[i].factor];
      if (draw.kind == Draw::Kind::as_in_file) {
        found[i] = kAsInFile;
      } else if (draw.kind == Draw::Kind::number) {
        if (!values[i].number) return false;
        found[i] = kNumber;
      } else {
        const bool number = !std::isnan(values[i].levels[draw.level]);
        found[i] = number ? kNumber : kFirstLevel + static_cast<std::uint32_t>(draw.level);
      }
    }
    return true;
  }

  /// Null where the design's document cannot be read, or has no number in an input's place.
  std::unique_ptr<Frame> make_frame(const FrameShape& of, const std::vector<Draw>& draws) const {
    auto made = std::make_unique<Frame>();
    try {
      made->file = input::read_design_file(input, overrides(input.study, draws)).file;
    } catch (const input::InputError&) {
      return nullptr;
    }
    const std::vector<input::LoadCaseItem>& items = made->file.load_cases;
    std::vector<LoadCase>& load_cases = made->file.values.load_cases;
    load_cases = input::expand(items);
    for (const auto i : indices(of)) {
      if (of[i] != kNumber) continue;
      const std::string& path = values[i].path;
      if (made->file.speeds_follow_lead && path == "mechanism.lead") return nullptr;
      input::Slot slot = input::find_slot(made->file, path);
      if (slot.kind != input::Slot::Kind::number && slot.kind != input::Slot::Kind::whole) return nullptr;
      made->bound.push_back({i, std::move(slot)});
      if (const std::optional<std::size_t> item = load_case_item(path)) made->varied_items.push_back(*item);
    }
    std::vector<bool> varies(load_cases.size());
    for (const std::size_t item : made->varied_items)
      std::fill(varies.begin() + static_cast<std::ptrdiff_t>(input::first_case(items, item)),
                varies.begin() + static_cast<std::ptrdiff_t>(input::first_case(items, item + 1)), true);
    made->checked = checked_cases(load_cases, varies);
    return made;
  }

  Frame* frame_of(const std::vector<Draw>& draws) {
    FrameShape& of = wanted;
    if (!find_shape(draws, of)) return nullptr;
    if (frame && of == shape) return frame;
    auto known = frames.find(of);
    if (known == frames.end()) {
      std::unique_ptr<Frame> made = make_frame(of, draws);
      if (!made) return nullptr;
      if (frames.size() >= kMostFrames) frames.clear();
      known = frames.emplace(of, std::move(made)).first;
    }
    shape = of;
    frame = known->second.get();
    return frame;
  }

  /// Sets the numbers of the last shape's frame; false where one is out of its bounds.
  bool set_numbers(const std::vector<Draw>& draws) {
    for (const auto& [input_index, slot] : frame->bound) {
      const Values& known = values[input_index];
      const Draw& draw = draws[known.factor];
      const std::optional<double> value =
          draw.kind == Draw::Kind::level ? known.levels[draw.level] : input::slot_value(slot, draw.number, known.unit);
      if (!value) return false;
      set(slot, *value);
    }
    for (const std::size_t item : frame->varied_items)
      input::update_numbers(frame->file.values.load_cases, frame->file.load_cases, item);
    return true;
  }

  /// Problems of the last shape's frame.
  std::vector<Problem> problems() {
    Case& c = frame->file.values;
    const auto of_case = [&] { return input::problems_of(c, input.study.command); };
    if (!frame->checked) return of_case();
    auto& [load_cases, varied] = *frame->checked;
    for (const auto& [place, index] : varied) load_cases[place] = c.load_cases[index];
    std::swap(c.load_cases, load_cases);
    const bool sound = of_case().empty();
    std::swap(c.load_cases, load_cases);
    return sound ? std::vector<Problem>() : of_case();
  }
};

DesignReader::DesignReader(const input::StudyInput& input) : parts_(new Parts{.input = input}) {
  input::CaseFile base = input::read_design_file(input, {}).file;
  for (const DrawnInput& drawn : drawn_inputs(input.study)) parts_->values.push_back(values_of(drawn, base));
}

DesignReader::~DesignReader() = default;
DesignReader::DesignReader(DesignReader&&) noexcept = default;

Case& DesignReader::read(std::size_t k) {
  set_draws(parts_->input.study, k, parts_->drawn);
  return read(parts_->drawn);
}

Case& DesignReader::read(const std::vector<Draw>& draws) {
  Parts& p = *parts_;
  if (&draws != &p.drawn) p.drawn = draws;
  if (p.frame_of(draws) && p.set_numbers(draws)) {
    Case& values = p.frame->file.values;
    const std::vector<Problem> problems = p.problems();
    if (problems.empty()) return values;
    if (problems.size() == 1) {
      input::ErrorList errors(p.input.source);
      errors.add({}, problems[0].path, problems[0].message);
      throw input::InputError(errors.first());
    }
  }
  p.read_in_full = input::read_design(p.input, overrides(p.input.study, draws));
  return p.read_in_full;
}

input::Source DesignReader::source() const {
  input::Source source = parts_->input.source;
  std::ranges::move(overrides(parts_->input.study, parts_->drawn), std::back_inserter(source.overrides));
  return source;
}

}  // namespace prs
