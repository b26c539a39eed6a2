#include "prs/input/study_reader.h"

#include <algorithm>
#include <cstdlib>

#include "prs/indices.h"
#include "prs/input/field.h"
#include "prs/input/reader.h"
#include "prs/input/study_envelope.h"
#include "prs/input/varied_input.h"

namespace prs::input {
namespace {

constexpr std::string_view kLoadCases = "load_cases[";

/// A level as written in the document.
struct WrittenLevel {
  Node value;
  Level level;
};

std::string with_unit(std::string_view number, std::string_view unit) {
  return fmt::format("{}{}{}", number, unit.empty() ? "" : " ", unit);
}
std::string with_unit(double number, std::string_view unit) { return with_unit(fmt::format("{}", number), unit); }

/// Curvature of a profile [1/mm], convex > 0: `straight`, `{convex: 6 mm}`, `{concave: 60 mm}`.
std::optional<double> profile_curvature(const Node& value) {
  if (value.kind == Node::Kind::scalar && value.text == "straight") return 0.0;
  if (value.kind != Node::Kind::map || value.children.size() != 1) return std::nullopt;
  const Node& radius = value.children[0];
  const std::optional<double> r = number_in(radius.text, "mm");
  if (!r || *r == 0.0 || (radius.key != "convex" && radius.key != "concave")) return std::nullopt;
  return (radius.key == "convex" ? 1.0 : -1.0) / *r;
}

/// Number of a text in another unit as a difference, for which the zero of a temperature does not matter.
std::optional<double> difference_in(std::string_view text, std::string_view unit) {
  const std::optional<double> value = number_in(text, unit);
  if (!value) return std::nullopt;
  const std::string zero = with_unit("0", split_unit(text)->unit);
  return *value - number_in(zero, unit).value_or(0.0);
}

std::string plan_name(Plan plan) { return text_of(value_of(plan, Choice{})); }

/// Keys of a factor of which exactly one gives its values.
std::vector<std::string_view> ways(const FactorItem& item) {
  std::vector<std::string_view> given;
  if (item.values) given.push_back("values");
  if (item.uniform) given.push_back("uniform");
  if (item.log_uniform) given.push_back("log_uniform");
  if (item.normal) given.push_back("normal");
  if (item.within) given.push_back("within");
  return given;
}

/// Number of listed values.
std::size_t count_of(const WrittenValues& values) {
  return values.range ? static_cast<std::size_t>(values.range->steps) : values.list.size();
}

/// Reads the factors of one study into the base document.
class FactorReader : VariedInput {
 public:
  /// `base`: the document without the study.
  FactorReader(const StudyItem& study, const Source& source, const Node& root, Node& base, ErrorList& errors)
      : VariedInput(source, root, base, errors), study_(study) {}

  /// Adds errors in the keys of a factor, whatever their values.
  void check_form(std::size_t index) {
    enter(index);
    const std::vector<std::string_view> given = ways(item());
    const bool sampled = is_sampled(study_.plan);
    const auto refuse = [&](std::string_view key, std::string_view message) {
      refuse_at(key, fmt::format("got {}; {}", shown(flow_text(*written(key))), message));
    };
    check_outside("path", item().path);
    for (const auto k : indices(item().companions))
      check_outside(fmt::format("with[{}].path", k), item().companions[k].path);
    if (!item().companions.empty() && !item().values)
      refuse("with",
             "expected it only with `values`, each of which sets the companions too; write "
             "`values`, or delete it");
    for (const std::string_view key : given) {
      if (study_.plan == Plan::derivatives)
        refuse(key, "expected a path only with `plan: derivatives`, which varies nothing; delete it");
      else if (!sampled && key != "values")
        refuse(key, fmt::format("expected `values` with `plan: {}`, which lists its designs; write "
                                "them, or draw samples with `plan: latin_hypercube`",
                                plan_name(study_.plan)));
      else if (key != given[0])
        refuse(key, fmt::format("expected one way to choose values, `{}` stands already; delete "
                                "one of the two",
                                given[0]));
    }
    if (!given.empty() || study_.plan == Plan::derivatives) return;
    errors_.add(find_path(root_, path_)->place, path_,
                sampled ? "missing what values it takes; expected one of values, uniform, "
                          "log_uniform, normal, within; add for example `within: 3 %`"
                        : "missing what values it takes; expected `values`; add for example "
                          "`values: [20 mm, 30 mm]`");
  }

  /// Adds errors in the ends of a range or of an interval, and in companions.
  void check_ends(std::size_t index) {
    enter(index);
    check_written_ends();
    const FactorItem& factor = study_.factors[index];
    for (const auto k : indices(factor.companions)) {
      enter_companion(index, k);
      check_written_ends();
      const std::size_t expected = count_of(*factor.values), got = count_of(*item().values);
      if (got != expected)
        refuse_at("values", fmt::format("got {} values; expected {}, one for each of {}; write as "
                                        "many, or give both ranges `steps: {}`",
                                        got, expected, shown(factor.path), expected));
    }
  }

  /// Adds to the document the list that a factor draws entry by entry, zeros if the file has none.
  void add_list(std::size_t index, CaseFile& file) {
    enter(index);
    const Slot slot = find_slot(file, item().path);
    if (item().values || slot.kind != Slot::Kind::numbers) return;
    entries_.resize(study_.factors.size());
    entries_[index] = slot.list->size();
    if (!slot.list->empty()) return;
    entries_[index] = static_cast<std::size_t>(file.values.mechanism.contacts_per_roller);
    const Place at = locate(root_, path_ + ".path");
    Node list{.kind = Node::Kind::sequence, .place = at};
    const Node zero = scalar(with_unit("0", unit_of_way().value_or(std::string(slot.dimension->canonical))), at);
    list.children.assign(entries_[index], zero);
    set_value(base_, item().path, std::move(list), at, errors_);
  }

  /// The factor, or one per entry of its list. `file` and `fields` are those of the base document.
  std::vector<Factor> read(std::size_t index, CaseFile& file, const std::vector<EchoEntry>& fields) {
    enter(index);
    if (entries_.empty() || entries_[index] == 0) {
      Factor factor = read_one(item().path, item().label.value_or(item().path), file, fields);
      for (const auto k : indices(study_.factors[index].companions)) {
        enter_companion(index, k);
        factor.companions.push_back(read_one(item().path, item().label.value_or(item().path), file, fields));
      }
      factor.kept = item().kept;
      return {std::move(factor)};
    }
    std::vector<Factor> entries;
    for (const auto k : up_to(entries_[index])) {
      entries.push_back(read_one(fmt::format("{}[{}]", item().path, k),
                                 fmt::format("{}[{}]", item().label.value_or(item().path), k), file, fields));
      entries.back().entry_of_list = true;
      entries.back().with_previous = item().together && k > 0;
      entries.back().kept = item().kept;
      if (!errors_.empty()) break;
    }
    return entries;
  }

 private:
  void enter(std::size_t index) {
    item_ = study_.factors[index];
    one_was_fine_ = false;
    path_ = fmt::format("study.factors[{}]", index);
  }
  void enter_companion(std::size_t index, std::size_t k) {
    item_ = {};
    static_cast<CompanionItem&>(item_) = study_.factors[index].companions[k];
    one_was_fine_ = false;
    path_ = fmt::format("study.factors[{}].with[{}]", index, k);
  }
  const FactorItem& item() const { return item_; }

  const Node* written(std::string_view key) const { return find_path(root_, fmt::format("{}.{}", path_, key)); }
  Place place_of(std::string_view key) const { return locate(root_, fmt::format("{}.{}", path_, key)); }

  void check_written_ends() {
    if (item().values && item().values->range) {
      const WrittenRange& range = *item().values->range;
      check_ends("values", range, false, range.spacing == WrittenRange::Spacing::logarithmic ? "spacing" : "");
    }
    if (item().uniform) check_ends("uniform", *item().uniform, true, "");
    if (item().log_uniform) check_ends("log_uniform", *item().log_uniform, true, "from");
  }

  /// `logarithmic`: the key to name if the ends have no ratio; may be empty.
  void check_ends(std::string_view way, const auto& written, bool ascending, std::string_view logarithmic) {
    const std::optional<Ends> ends = read_ends(fmt::format("{}.", way), written.from, written.to, ascending);
    if (!ends || logarithmic.empty() || ends->from.number * ends->to.number > 0.0) return;
    refuse_at(fmt::format("{}.{}", way, logarithmic),
              fmt::format("got logarithmic from {} to {}; expected ends of one sign, neither of them "
                          "0; write `{}`",
                          shown(written.from), shown(written.to),
                          way == "values" ? "spacing: linear" : "uniform: {from: .., to: ..}"));
  }

  /// Unit in which a distribution is written.
  std::optional<std::string> unit_of_way() const {
    const FactorItem& f = item();
    const std::string text = f.uniform       ? f.uniform->from
                             : f.log_uniform ? f.log_uniform->from
                             : f.normal      ? f.normal->mean.value_or(f.normal->deviation)
                                             : "";
    const std::optional<NumberAndUnit> split = split_unit(text);
    return split ? std::optional(std::string(split->unit)) : std::nullopt;
  }

  Factor read_one(const std::string& path, std::string label, CaseFile& file, const std::vector<EchoEntry>& fields) {
    const Slot slot = find_slot(file, path);
    Factor factor;
    factor.path = path;
    factor.label = std::move(label);
    std::optional<WrittenLevel> base = base_level(path, fields);
    if (item().values)
      read_levels(factor, base, slot);
    else if (is_continuous(path, slot))
      read_distribution(factor, base, slot);
    if (base) factor.base = base->level;
    return factor;
  }

  // Levels --------------------------------------------------------------------------------------

  void read_levels(Factor& factor, std::optional<WrittenLevel>& base, const Slot& slot) {
    const Node& values = *written("values");
    const std::optional<WrittenRange>& range = item().values->range;
    std::vector<WrittenLevel> levels = range ? range_levels(*range, values) : list_levels(values);
    factor.logarithmic = range && range->spacing == WrittenRange::Spacing::logarithmic;
    factor.continuous = slot.kind == Slot::Kind::number;
    place_on_axis(levels, base, factor.unit);
    for (const WrittenLevel& level : levels) factor.levels.push_back(level.level);
    for (const WrittenLevel& level : levels) check_in_place(factor.path, level.value, slot);
  }

  static std::vector<WrittenLevel> list_levels(const Node& values) {
    std::vector<WrittenLevel> levels;
    for (const Node& value : values.children) levels.push_back({value, {flow_text(value), std::nullopt}});
    return levels;
  }

  /// Ends as written, points between them with 15 digits.
  static std::vector<WrittenLevel> range_levels(const WrittenRange& range, const Node& values) {
    const NumberAndUnit from = *split_unit(range.from), to = *split_unit(range.to);
    const bool logarithmic = range.spacing == WrittenRange::Spacing::logarithmic;
    const int last = range.steps - 1;
    const auto text_at = [&](int k) {
      if (k == 0 || k == last) return k == 0 ? range.from : range.to;
      const double share = static_cast<double>(k) / last;
      const double number = logarithmic ? from.number * std::pow(to.number / from.number, share)
                                        : from.number + (to.number - from.number) * share;
      return with_unit(fmt::format("{:.15g}", number), from.unit);
    };
    std::vector<WrittenLevel> levels;
    for (int k = 0; k <= last; ++k) {
      const Place place = k == 0 ? find(values, "from")->place : k == last ? find(values, "to")->place : values.place;
      levels.push_back({scalar(text_at(k), place), {text_at(k), std::nullopt}});
    }
    return levels;
  }

  /// Value of a path in the file, or the default.
  std::optional<WrittenLevel> base_level(const std::string& path, const std::vector<EchoEntry>& fields) const {
    const std::optional<Node> node = base_value(path, fields);
    return node ? std::optional(WrittenLevel{*node, {flow_text(*node), {}}}) : std::nullopt;
  }

  /// Sets numbers in the unit of the first level, or curvatures of profiles.
  static void place_on_axis(std::vector<WrittenLevel>& levels, std::optional<WrittenLevel>& base, std::string& unit) {
    const std::optional<NumberAndUnit> first = split_unit(levels[0].level.text);
    unit = first ? std::string(first->unit) : "1/mm";
    const auto place = [&](WrittenLevel& level) {
      level.level.number = first ? number_in(level.level.text, unit) : profile_curvature(level.value);
    };
    std::ranges::for_each(levels, place);
    if (base) place(*base);
    const auto has_number = [](const WrittenLevel& level) { return level.level.number.has_value(); };
    if (!std::ranges::any_of(levels, has_number)) unit.clear();
  }

  /// Adds errors in a value of a factor at the value's place, and returns whether there are none. After one valid value
  /// another number is valid if its slot takes it.
  bool check_in_place(const std::string& path, const Node& value, const Slot& slot) {
    const bool number = slot.kind == Slot::Kind::number || slot.kind == Slot::Kind::whole;
    if (one_was_fine_ && number && slot_value(slot, flow_text(value))) return true;
    const bool fine = VariedInput::check_in_place(path, value);
    one_was_fine_ = one_was_fine_ || fine;
    return fine;
  }

  // Distributions -------------------------------------------------------------------------------

  /// Whether a path leads to a number that can lie anywhere in an interval; adds the reason if not.
  bool is_continuous(const std::string& path, const Slot& slot) {
    if (slot.kind == Slot::Kind::number) return true;
    if (slot.kind == Slot::Kind::none && !check_in_place(path, scalar("0", place_of("path")), slot)) return false;
    refuse_at("path", fmt::format("got {}; expected the path of a number that may have any value "
                                  "between two; {}",
                                  shown(path),
                                  is_sampled(study_.plan) ? "write the values that it may have, `values: [.., ..]`"
                                                          : "leave this factor out"));
    return false;
  }

  void read_distribution(Factor& factor, std::optional<WrittenLevel>& base, const Slot& slot) {
    const FactorItem& f = item();
    const std::optional<NumberAndUnit> in_file = base ? split_unit(base->level.text) : std::nullopt;
    factor.unit = unit_of_way().value_or("");
    if (in_file && !f.uniform && !f.log_uniform && !(f.normal && f.normal->mean)) factor.unit = in_file->unit;
    std::optional<double> value;
    if (base) value = base->level.number = number_in(base->level.text, factor.unit);

    if (f.uniform || f.log_uniform)
      read_interval(factor, slot);
    else if (f.normal)
      read_normal(factor, value, slot);
    else if (f.within)
      read_tolerance(factor, value, slot);
    else if (!value)
      refuse_at("path", fmt::format("got {}, which the file does not state; expected a value to "
                                    "derive by; add it to the file",
                                    shown(factor.path)));
  }

  void read_interval(Factor& factor, const Slot& slot) {
    const bool uniform = item().uniform.has_value();
    const std::string_view way = uniform ? "uniform" : "log_uniform";
    const WrittenInterval& interval = uniform ? *item().uniform : *item().log_uniform;
    factor.distribution = {uniform ? Distribution::Kind::uniform : Distribution::Kind::log_uniform,
                           split_unit(interval.from)->number, split_unit(interval.to)->number};
    check_in_place(factor.path, *written(fmt::format("{}.from", way)), slot);
    check_in_place(factor.path, *written(fmt::format("{}.to", way)), slot);
  }

  void read_normal(Factor& factor, std::optional<double> value, const Slot& slot) {
    const WrittenNormal& normal = *item().normal;
    const std::optional<NumberAndUnit> mean = normal.mean ? split_unit(*normal.mean) : std::nullopt;
    if (normal.mean && !mean)
      return refuse_at("normal.mean", fmt::format("got {}; expected a number with its unit as in the file; write "
                                                  "for example `mean: 5 mm`",
                                                  shown(*normal.mean)));
    if (!mean && !value)
      return refuse_at("normal", fmt::format("missing `mean`; expected it where the file does not state {}; "
                                             "add for example `mean: {}`",
                                             shown(factor.path), with_unit("0", factor.unit)));
    const std::optional<double> deviation = difference_in(normal.deviation, factor.unit);
    if (!deviation || !(*deviation > 0.0))
      return refuse_at("normal.deviation",
                       fmt::format("got {}; expected a number > 0 that goes with the unit {}; "
                                   "write for example `deviation: {}`",
                                   shown(normal.deviation), factor.unit.empty() ? "none" : shown(factor.unit),
                                   with_unit("0.01", factor.unit)));
    factor.distribution = {Distribution::Kind::normal, mean ? mean->number : *value, *deviation};
    if (mean) check_in_place(factor.path, *written("normal.mean"), slot);
  }

  /// Deviation from the file's value: a share of it, or a difference in the factor's unit.
  struct Deviation {
    double number = 0.0;
    bool is_share = false;
  };
  static std::optional<Deviation> deviation(std::string_view text, std::string_view unit) {
    const std::optional<NumberAndUnit> split = split_unit(text);
    if (!split) return std::nullopt;
    const bool is_share = (split->unit.empty() || split->unit == "%") && split->number != 0.0;
    if (split->unit == "%") return Deviation{split->number / 100.0, is_share};
    if (split->unit.empty()) return Deviation{split->number, is_share};
    const std::optional<double> difference = difference_in(text, unit);
    return difference ? std::optional(Deviation{*difference}) : std::nullopt;
  }

  /// `3 %`, `0.02 mm`, or the lower and the upper deviation, `[-0.01 mm, 0.03 mm]`.
  void read_tolerance(Factor& factor, std::optional<double> value, const Slot& slot) {
    const Node& tolerance = *written("within");
    const bool two = tolerance.kind == Node::Kind::sequence && tolerance.children.size() == 2;
    const auto read = [&](std::size_t k) {
      return deviation(two ? flow_text(tolerance.children[k]) : *item().within, factor.unit);
    };
    const std::optional<Deviation> lower = read(0), upper = read(1);
    const auto is_sound = [](const std::optional<Deviation>& d) {
      return d && (!d->is_share || std::abs(d->number) <= 1.0);
    };
    const auto refuse = [&](std::string_view what, std::string_view fix) {
      refuse_at("within", fmt::format("got {}{}; write {}", shown(*item().within), what, fix));
    };
    const std::string width = with_unit("0.02", factor.unit.empty() ? "mm" : factor.unit);
    if (!is_sound(lower) || !is_sound(upper) || (!two && !(upper->number > 0.0)))
      return refuse(
          "; expected a share > 0 and at most 100 %, a half width with its unit, or lower "
          "and upper deviation",
          fmt::format("`3 %`, `{}` or `[-1 %, 2 %]`", width));
    const bool has_share = lower->is_share || upper->is_share;
    if (has_share && slot.dimension && zero_depends_on_unit(*slot.dimension))
      return refuse(" of a temperature, whose zero is a convention; expected a half width",
                    "for example `within: 5 K`");
    if (!value)
      return refuse(" of no single value in the file; expected a value there",
                    "`uniform: {from: .., to: ..}`, or name one of several as `.screw`");
    if (has_share && *value == 0.0)
      return refuse(" of 0; expected a value other than 0 in the file, or a half width with its unit",
                    fmt::format("for example `within: {}`", width));
    const auto amount = [&](const Deviation& d) { return d.is_share ? d.number * std::abs(*value) : d.number; };
    const double above = amount(*upper), below = two ? amount(*lower) : -above;
    if (!(below < above)) return refuse("; expected the lower deviation, then the upper", "`[-0.01 mm, 0.03 mm]`");
    factor.distribution = {Distribution::Kind::uniform, *value + below, *value + above};
    for (const double end : {factor.distribution.first, factor.distribution.second})
      check_in_place(factor.path, scalar(with_unit(end, factor.unit), place_of("within")), slot);
  }

  const StudyItem& study_;
  FactorItem item_;
  bool one_was_fine_ = false;
  std::vector<std::size_t> entries_;  ///< Number of list entries each factor draws; empty: none.
};

void check_number_of_levels(const StudyItem& item, const Node& root, ErrorList& errors) {
  std::size_t count = 0;
  for (const FactorItem& factor : item.factors) {
    if (factor.values) count += count_of(*factor.values);
    for (const CompanionItem& companion : factor.companions) count += count_of(*companion.values);
  }
  if (count > kMostLevels)
    refuse(root, "study.factors",
           fmt::format("got {} values; expected at most {}; write ranges with fewer steps", count, kMostLevels),
           errors);
}

void check_responses(const std::vector<std::string>& responses, const Node& root, ErrorList& errors) {
  for (const auto k : indices(responses)) {
    if (std::find(responses.begin(), responses.begin() + static_cast<std::ptrdiff_t>(k), responses[k]) ==
        responses.begin() + static_cast<std::ptrdiff_t>(k))
      continue;
    refuse(root, fmt::format("study.responses[{}]", k),
           fmt::format("got {} a second time; expected each path once; delete one of them", shown(responses[k])),
           errors);
  }
}

/// Adds an error where a study has too many designs, or more factors than Sobol's sequence
/// dimensions.
void check_size(const Study& study, const Node& root, ErrorList& errors) {
  const std::size_t factors = study.factors.size();
  double designs = is_sampled(study.plan) ? static_cast<double>(study.samples) : 1.0;
  const std::vector<std::size_t> blocks = blocks_of(study);
  if (study.plan == Plan::sobol_indices) designs *= static_cast<double>(blocks.size() + 2);
  if (study.plan == Plan::tolerances)
    designs *=
        1.0 + static_cast<double>(std::ranges::count_if(blocks, [&](std::size_t f) { return !study.factors[f].kept; }));
  if (study.plan == Plan::grid)
    for (const Factor& factor : study.factors) designs *= static_cast<double>(factor.levels.size());
  if (designs + 1.0 > static_cast<double>(kMostDesigns)) {
    const bool sampled = is_sampled(study.plan);
    refuse(root, sampled ? "study.samples" : "study.factors",
           fmt::format("got {:.6g} designs; expected fewer than {} with the base case; {}", designs, kMostDesigns,
                       sampled ? "take fewer samples"
                               : "take fewer values, or draw samples with "
                                 "`plan: latin_hypercube`"),
           errors);
  }
  const std::size_t dimensions = study.plan == Plan::sobol_indices ? 2 * factors : factors;
  const bool sobol = study.plan == Plan::sobol || study.plan == Plan::sobol_indices;
  if (sobol && dimensions > kMostSobolDimensions)
    refuse(root, "study.factors",
           fmt::format("got {} factors; expected at most {} with `plan: {}`; take `plan: "
                       "latin_hypercube` or `monte_carlo`",
                       factors, kMostSobolDimensions / (dimensions / factors), plan_name(study.plan)),
           errors);
}

StudyItem written_study(const CaseFile& file, const Node& root, ErrorList& errors) {
  if (!file.study && !find(root, "study"))
    errors.add(root.place, "study",
               "missing; expected what to vary; add for example `study: {command: slip, factors: "
               "[{path: mechanism.rollers, values: [8, 9, 10]}]}`");
  errors.throw_if_any();
  StudyItem item = *file.study;
  for (FactorItem& factor : item.factors) {
    take_indices(root, factor.path, factor.label);
    for (CompanionItem& companion : factor.companions) take_indices(root, companion.path, companion.label);
  }
  std::vector<std::string> responses;
  const auto take = [&](std::string& path) { responses.push_back(path = response_path(root, file.load_cases, path)); };
  if (item.responses) std::ranges::for_each(*item.responses, take);
  if (item.envelope) {
    for (Envelope::Measure& measure : item.envelope->measures) take(measure.response);
    for (EnvelopePointItem& point : item.envelope->points)
      if (point.reach)
        for (Envelope::Target& target : *point.reach) take(target.response);
  }
  check_load_cases(responses, set_paths(item.factors, "study.factors"), root, file.load_cases, errors);
  return item;
}

}  // namespace

std::string response_path(const Node& root, const std::vector<LoadCaseItem>& load_cases, const std::string& path) {
  const std::string indexed = with_indices(root, path.substr(0, path.find(']') + 1));
  if (!path.starts_with(kLoadCases) || path.starts_with(indexed)) return path;
  const std::size_t item = std::stoul(indexed.substr(kLoadCases.size()));
  return fmt::format("{}{}{}", kLoadCases, first_case(load_cases, item), path.substr(path.find(']')));
}

void check_load_cases(const std::vector<std::string>& responses, const std::vector<SetPath>& inputs, const Node& root,
                      const std::vector<LoadCaseItem>& load_cases, ErrorList& errors) {
  for (const auto i : indices(load_cases))
    for (const SetPath& input : inputs) {
      const std::string force = fmt::format("{}{}].axial_force", kLoadCases, i);
      const std::size_t next = first_case(load_cases, i + 1);
      if (input.path != force + ".steps" && (input.path != force || next == first_case(load_cases, i) + 1)) continue;
      for (const std::string& response : responses)
        if (response.starts_with(kLoadCases) && std::strtoul(response.c_str() + kLoadCases.size(), nullptr, 10) >= next)
          refuse(root, input.at,
                 fmt::format("got {}, which changes the number of load cases before that of {}; expected responses of "
                             "load cases whose place stays; put the range last",
                             shown(input.path), shown(response)),
                 errors);
    }
}

StudyInput read_study_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  CaseFile file = read_case_file(root, errors);
  const StudyItem item = written_study(file, root, errors);
  checked_case(file, root, item.command, errors);
  check_paths(set_paths(item.factors, "study.factors"), "factor", item.plan == Plan::one_at_a_time, root, errors);
  check_number_of_levels(item, root, errors);
  errors.throw_if_any();

  StudyInput input{source, root, {}};
  std::erase_if(input.base.children, [](const Node& child) { return child.key == "study"; });
  FactorReader reader(item, source, root, input.base, errors);
  for (const auto i : indices(item.factors)) reader.check_form(i);
  errors.throw_if_any();
  for (const auto i : indices(item.factors)) reader.check_ends(i);
  errors.throw_if_any();
  for (const auto i : indices(item.factors)) reader.add_list(i, file);
  file = read_case_file(input.base, errors);
  errors.throw_if_any();

  input.study.command = item.command;
  input.study.plan = item.plan;
  input.study.responses = item.responses.value_or(std::vector<std::string>{});
  check_responses(input.study.responses, root, errors);
  input.study.samples = static_cast<std::size_t>(item.samples.value_or(0));
  input.study.seed = static_cast<std::uint64_t>(item.seed);
  const std::vector<EchoEntry> fields = echo(file, input.base);
  for (const auto i : indices(item.factors))
    for (Factor& factor : reader.read(i, file, fields)) input.study.factors.push_back(std::move(factor));
  for (const auto i : indices(item.factors)) {
    const auto refused = [&](std::string_view key, std::string_view why) {
      refuse(root, fmt::format("study.factors[{}].{}", i, key), fmt::format("got true; expected it {}; delete it", why),
             errors);
    };
    const auto is_list = [&](const Factor& f) { return f.with_previous && f.path.starts_with(item.factors[i].path); };
    if (item.factors[i].kept && item.plan != Plan::tolerances) refused("kept", "only with the plan tolerances");
    if (item.factors[i].together && std::ranges::none_of(input.study.factors, is_list))
      refused("together", "only with the path of a list of two or more numbers");
  }
  if (item.plan == Plan::tolerances)
    for (const auto i : indices(item.factors))
      if (!item.factors[i].kept && item.factors[i].values)
        refuse(root, fmt::format("study.factors[{}].values", i),
               "got values, which cannot be halved; expected within, normal or uniform with `plan: "
               "tolerances`; write one of them, or `kept: true`",
               errors);
  if (item.plan == Plan::tolerances) {
    if (std::ranges::all_of(item.factors, [](const auto& f) { return f.kept; }))
      refuse(root, "study.factors",
             "got factors that are all kept; expected one to halve with `plan: tolerances`; "
             "delete a `kept: true`",
             errors);
    for (const Factor& f : input.study.factors)
      if (!f.kept && !(f.base && f.base->number))
        refuse(root, "study.factors",
               fmt::format("got {}, which the file does not state; expected a value about which "
                           "`plan: tolerances` halves; write it into the file",
                           f.path),
               errors);
  }
  check_size(input.study, root, errors);
  errors.throw_if_any();
  if (item.envelope) read_envelope(*item.envelope, root, input.study, errors);
  errors.throw_if_any();
  return input;
}

DesignFile read_design_file(const StudyInput& input, const std::vector<std::string>& overrides) {
  Source source = input.source;
  append(source.overrides, overrides);
  ErrorList errors(source);
  Node root = input.base;
  for (std::size_t k = input.source.overrides.size(); k < source.overrides.size(); ++k)
    apply_override(root, source, k, errors);
  CaseFile file = read_case_file(root, errors);
  if (!errors.empty()) throw InputError(errors.first());
  return {std::move(root), std::move(file)};
}

Case read_design(const StudyInput& input, const std::vector<std::string>& overrides) {
  const auto [root, file] = read_design_file(input, overrides);
  ErrorList errors(input.source);
  Case values = checked_case(file, root, input.study.command, errors);
  if (!errors.empty()) throw InputError(errors.first());
  return values;
}

}  // namespace prs::input
