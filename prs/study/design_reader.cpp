#include "prs/study/design_reader.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "prs/input/reader.h"
#include "prs/input/slot.h"
#include "prs/input/units.h"

namespace prs {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostFrames = 256;

/// What is known of an input's values before any design is read.
struct Values {
  std::size_t factor = 0;  ///< Whose draw sets it.
  std::string path = {};
  bool number = false;                ///< A drawn number can be set without reading it.
  const input::Unit* unit = nullptr;  ///< None of bare numbers.
  std::vector<double> levels =
      {};  ///< As `input::slot_value` gives them; NaN where one must be read.
};

Values values_of(const DrawnInput& input, input::CaseFile& file) {
  const Factor& factor = *input.input;
  const input::Slot slot = input::find_slot(file, factor.path);
  Values values{.factor = input.factor, .path = factor.path};
  if (slot.dimension) values.unit = input::find_unit(factor.unit, *slot.dimension);
  values.number = slot.kind == input::Slot::Kind::number &&
                  (slot.dimension ? values.unit != nullptr : factor.unit.empty());
  const bool numeric =
      slot.kind == input::Slot::Kind::number || slot.kind == input::Slot::Kind::whole;
  for (const Level& level : factor.levels)
    values.levels.push_back(numeric ? input::slot_value(slot, level.text).value_or(kNoNumber)
                                    : kNoNumber);
  return values;
}

/// How an input's value comes into the case: designs that agree in this differ in numbers only.
using Shape = std::vector<std::uint32_t>;
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
  bool varies_loads = false;
};

}  // namespace

struct DesignReader::Parts {
  const input::StudyInput& input;
  std::vector<Values> values = {};  ///< One per drawn input (`drawn_inputs`).
  std::map<Shape, std::unique_ptr<Frame>> frames = {};
  Shape shape = {};
  Frame* frame = nullptr;  ///< Frame of the last shape.
  Shape wanted = {};       ///< Shape of the design that is read.
  std::vector<Draw> drawn = {};
  Case read_in_full = {};

  /// The shape of a design; false where a number must be read.
  bool find_shape(const std::vector<Draw>& draws, Shape& found) const;
  Frame* frame_of(const std::vector<Draw>& draws);
  std::unique_ptr<Frame> make_frame(const Shape& of, const std::vector<Draw>& draws) const;
  bool set_numbers(const std::vector<Draw>& draws);
};

bool DesignReader::Parts::find_shape(const std::vector<Draw>& draws, Shape& found) const {
  found.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
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
std::unique_ptr<Frame> DesignReader::Parts::make_frame(const Shape& of,
                                                       const std::vector<Draw>& draws) const {
  auto made = std::make_unique<Frame>();
  try {
    made->file = input::read_design_file(input, overrides(input.study, draws)).file;
  } catch (const input::InputError&) {
    return nullptr;
  }
  made->file.values.load_cases = input::expand(made->file.load_cases);
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] != kNumber) continue;
    const std::string& path = values[i].path;
    input::Slot slot = input::find_slot(made->file, path);
    if (slot.kind != input::Slot::Kind::number && slot.kind != input::Slot::Kind::whole)
      return nullptr;
    made->bound.push_back({i, std::move(slot)});
    made->varies_loads = made->varies_loads || path.starts_with("load_cases");
  }
  return made;
}

Frame* DesignReader::Parts::frame_of(const std::vector<Draw>& draws) {
  Shape& of = wanted;
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
bool DesignReader::Parts::set_numbers(const std::vector<Draw>& draws) {
  for (const auto& [input_index, slot] : frame->bound) {
    const Values& known = values[input_index];
    const Draw& draw = draws[known.factor];
    const std::optional<double> value = draw.kind == Draw::Kind::level
                                            ? known.levels[draw.level]
                                            : input::slot_value(slot, draw.number, known.unit);
    if (!value) return false;
    set(slot, *value);
  }
  if (frame->varies_loads)
    input::update_numbers(frame->file.values.load_cases, frame->file.load_cases);
  return true;
}

DesignReader::DesignReader(const input::StudyInput& input) : parts_(new Parts{.input = input}) {
  input::CaseFile base = input::read_design_file(input, {}).file;
  for (const DrawnInput& drawn : drawn_inputs(input.study))
    parts_->values.push_back(values_of(drawn, base));
}

DesignReader::~DesignReader() = default;
DesignReader::DesignReader(DesignReader&&) noexcept = default;

Case& DesignReader::read(std::size_t k) {
  set_draws(parts_->input.study, k, parts_->drawn);
  return read(parts_->drawn);
}

Case& DesignReader::read(const std::vector<Draw>& draws) {
  Parts& p = *parts_;
  if (p.frame_of(draws) && p.set_numbers(draws)) {
    Case& values = p.frame->file.values;
    const std::vector<Problem> problems = input::problems_of(values, p.input.study.command);
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

}  // namespace prs
