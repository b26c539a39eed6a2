#include "prs/size/size.h"

#include <nlohmann/json.hpp>

#include "prs/configurations/screw_case.h"
#include "prs/input/csv_reader.h"
#include "prs/input/described_file.h"
#include "prs/input/force_history.h"
#include "prs/loads/load_record.h"
#include "prs/model/quantity_text.h"
#include "prs/size/evaluation.h"
#include "prs/study/study_run.h"

namespace prs {
namespace {

constexpr double kAlike = 1e-9;
constexpr std::size_t kChunk = 8;  ///< Number of candidates that a thread takes at once.

/// Objectives of a candidate, to be minimised; absent ones are last.
std::array<double, 5> objectives_of(const SizedCandidate& c) {
  constexpr double kLast = std::numeric_limits<double>::infinity();
  return {c.weight.value_or(kLast), c.nut_diameter, -c.life.travel.value_or(-kLast), c.motor_rms_torque.value_or(kLast),
          c.power_lost.value_or(kLast)};
}

/// -1 if a is smaller, 1 if it is larger, by more than rounding; both may be infinite.
int compared(double a, double b) {
  const double rounding = kAlike * std::max(std::abs(a), std::abs(b));
  if (a == b || (std::isfinite(rounding) && std::abs(a - b) <= rounding)) return 0;
  return a < b ? -1 : 1;
}

bool comes_before(const SizedCandidate& a, const SizedCandidate& b, Requirement::Objective objective) {
  if (a.passes != b.passes) return a.passes;
  if (!a.passes) {
    const std::size_t by_a = a.missed().size(), by_b = b.missed().size();
    if (by_a != by_b) return by_a < by_b;
    if (const int order = compared(b.least_missed_margin(), a.least_missed_margin())) return order < 0;
  }
  const auto measures = [objective](const SizedCandidate& c) {
    return std::array{objectives_of(c)[static_cast<std::size_t>(objective)], c.nut_diameter, c.screw.screw_diameter,
                      c.screw.lead};
  };
  const auto of_a = measures(a), of_b = measures(b);
  for (std::size_t k = 0; k < of_a.size(); ++k)
    if (const int order = compared(of_a[k], of_b[k])) return order < 0;
  return a.order < b.order;
}

/// Marks candidates that no other dominates: `all` are sorted by rank.
void mark_pareto(std::vector<SizedCandidate>& all) {
  std::vector<std::pair<std::array<double, 5>, SizedCandidate*>> passing;
  for (SizedCandidate& c : all)
    if (c.passes) passing.push_back({objectives_of(c), &c});
  const auto beats = [](const std::array<double, 5>& a, const std::array<double, 5>& b) {
    bool better = false;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k] > b[k]) return false;
      better = better || a[k] < b[k];
    }
    return better;
  };
  // In this order a dominated candidate has a dominating member of the front before it.
  std::ranges::stable_sort(passing, {}, [](const auto& p) { return p.first; });
  std::vector<const std::array<double, 5>*> front;
  for (const auto& own : passing) {
    own.second->pareto = std::ranges::none_of(front, [&](const auto* other) { return beats(*other, own.first); });
    if (own.second->pareto) front.push_back(&own.first);
  }
}

/// For the brake the torques [N m], in place of the ratio.
std::optional<Relaxation> relaxation(const std::vector<SizedCandidate>& all, const std::optional<double>& brake) {
  for (const SizedCandidate& c : all)
    if (c.missed().size() == 1)
      for (const SizeCriterion& missed : c.criteria)
        if (!missed.holds() && missed.margin) {
          if (missed.name == "brake")
            return Relaxation{missed.name, "N m", c.rank, *brake, *brake / *missed.value, *missed.margin};
          return Relaxation{missed.name, missed.unit, c.rank, *missed.limit, *missed.value, *missed.margin};
        }
  return std::nullopt;
}

}  // namespace

std::string_view name(CriterionStatus status) {
  constexpr std::string_view kNames[] = {"pass", "fail", "not_computed", "not_applicable"};
  return kNames[static_cast<std::size_t>(status)];
}

std::vector<std::string> SizedCandidate::missed() const {
  std::vector<std::string> names;
  for (const SizeCriterion& c : criteria)
    if (!c.holds()) names.emplace_back(c.name);
  return names;
}

std::string_view SizedCandidate::basis() const {
  if (life_basis == Requirement::Basis::threads) return "threads";
  return dynamic_capacity ? "maker" : "computed";
}

std::vector<std::string> CandidateData::assumed() const {
  std::vector<std::string> names;
  if (!screw.starts) names.emplace_back("starts");
  if (!screw.rollers) names.emplace_back("rollers");
  if (!screw.nut_diameter) names.emplace_back("nut_diameter");
  if (!screw.nut_length) names.emplace_back("nut_length");
  names.emplace_back("profile");
  return names;
}

double SizedCandidate::least_missed_margin() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeCriterion& c : criteria)
    if (!c.holds()) least = std::min(least, c.margin.value_or(0.0));
  return least;
}

std::optional<double> SizedCandidate::hottest_part() const {
  if (!temperature) return std::nullopt;
  const PerPart<double>& hottest = mission ? mission->peak : *temperature;
  return std::max({hottest.screw, hottest.roller, hottest.nut});
}

std::size_t SizeResult::passing() const {
  return static_cast<std::size_t>(std::ranges::count(candidates, true, &SizedCandidate::passes));
}

SizeResult size_screws(const SizeInput& in, const SizeOptions& options) {
  SizeResult result;
  result.input = in;
  result.warnings = in.warnings;
  const std::vector<CandidateData> data = candidates_of(in, result.warnings);
  result.candidates.reserve(data.size());
  const std::size_t threads = options.threads == 0 ? default_threads() : options.threads;
  const std::size_t at_once = data.size() < threads * kChunk ? 1 : kChunk;
  run_in_order((data.size() + at_once - 1) / at_once, threads, [&](std::size_t chunk) -> std::function<void()> {
    const std::size_t first = chunk * at_once, last = std::min(first + at_once, data.size());
    std::vector<SizedCandidate> done;
    std::vector<InvalidCandidate> invalid;
    for (std::size_t k = first; k < last; ++k) try {
        done.push_back(evaluated(result.input, data[k]));
        done.back().order = k;
      } catch (const CaseError& error) {
        invalid.push_back({data[k], error.problem().text()});
      }
    return [&, last, done = std::move(done), invalid = std::move(invalid)]() mutable {
      std::ranges::move(done, std::back_inserter(result.candidates));
      std::ranges::move(invalid, std::back_inserter(result.invalid));
      if (options.progress) options.progress(last, data.size());
    };
  });
  if (result.candidates.empty())
    input::fail_at(in.source, "candidates",
                   "got no screw that can be made, of {}; the first, {}: {}; change diameters, "
                   "leads or starts",
                   data.size(), result.invalid.front().name, result.invalid.front().reason);
  std::ranges::sort(result.candidates, [&](const SizedCandidate& a, const SizedCandidate& b) {
    return comes_before(a, b, in.values.objective);
  });
  int rank = 0;
  for (SizedCandidate& c : result.candidates) c.rank = ++rank;
  mark_pareto(result.candidates);
  if (result.passing() == 0) result.relax = relaxation(result.candidates, in.values.brake_torque);
  for (SizedCandidate& c : result.candidates)
    if (c.mission && c.rank != static_cast<int>(std::max<std::size_t>(options.curve_of, 1)))
      c.mission->time.clear(), c.mission->temperature = {};
  if (options.curve_of >= 1 && options.curve_of <= result.candidates.size())
    result.curve = force_over_speed(result.input, result.candidates[options.curve_of - 1]);
  return result;
}

namespace {

constexpr std::size_t kMostCandidates = 100'000;
constexpr double kNoTravel = 1e-3;  ///< Travel used if nothing moves under load [m].
/// The maker's series, see validation/standard_screws/SOURCE.md.
constexpr std::string_view kStandardScrews = "SRS-C, standard_screws.csv";

constexpr std::string_view kNeededColumns[] = {"screw_diameter_mm", "lead_mm", "starts"};
/// Columns after `type` are shown and not used.
constexpr std::string_view kOtherColumns =
    " rollers nut_diameter_mm nut_length_mm dynamic_capacity_kN static_capacity_kN efficiency "
    "back_driving_efficiency drag_torque_Nm axial_play_mm grease_volume_cm3 name screw maker type nut_and_rollers_kg "
    "screw_kg_per_m "
    "screw_inertia_kg_mm2_per_m nut_inertia_kg_mm2 roller_inertia_seen_by_screw_kg_mm2 "
    "screw_outer_diameter_mm screw_root_diameter_mm ";

bool is_known(const std::string& column) {
  return std::ranges::count(kNeededColumns, column) > 0 ||
         (column.find(' ') == column.npos && kOtherColumns.find(" " + column + " ") != kOtherColumns.npos);
}

class CatalogueReader {
 public:
  CatalogueReader(std::string_view text, std::string name, const input::Source& source,
                  std::string path = std::string(kCatalogueFile), const std::optional<std::string>& list = {})
      : text_(text),
        name_(std::move(name)),
        list_(list.value_or(name_)),
        path_(std::move(path)),
        source_(source),
        reader_(text) {}

  std::vector<CandidateData> read(std::vector<Warning>& warnings) {
    if (!next()) fail("has no heading; expected the names of the columns, then a screw per row");
    heading_.assign(reader_.fields().begin(), reader_.fields().end());
    read_makers_headings(warnings);
    check_heading(warnings);
    std::vector<CandidateData> rows;
    while (next()) {
      rows.push_back(row());
      rows.back().number = rows.size();
      if (rows.size() > kMostCandidates)
        fail(fmt::format("has more than {} rows; expected as many at most", kMostCandidates));
    }
    if (rows.empty()) fail("has no rows; expected a screw per row below the heading");
    warn_of_capacities(rows, warnings);
    return rows;
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    input::fail_at(source_, path_, "got {}, which {}; check the file", name_, what);
  }
  [[noreturn]] void refuse_at(std::size_t offset, std::string_view message) const {
    throw input::InputError(fmt::format("{}: error: {}", input::place_in(name_, text_, offset), message));
  }
  [[noreturn]] void refuse(std::size_t field, std::string_view expected, std::string_view fix) const {
    const auto& fields = reader_.fields();
    refuse_at(
        reader_.field_offset(reader_.row_offset(), field),
        fmt::format("{}: got {}; expected {}; {}", field < heading_.size() ? input::shown(heading_[field]) : "row",
                    field < fields.size() && !fields[field].empty() ? input::shown(fields[field]) : "nothing", expected,
                    fix));
  }
  bool next() {
    try {
      return reader_.next();
    } catch (const input::CsvError& error) {
      refuse_at(error.offset(), error.what());
    }
  }

  /// Reads headings as makers print them.
  void read_makers_headings(std::vector<Warning>& warnings) {
    constexpr std::pair<std::string_view, std::string_view> kHeadings[] = {
        {"d0", "screw_diameter_mm"},     {"Ph", "lead_mm"},
        {"Gangzahl", "starts"},          {"C", "dynamic_capacity_kN"},
        {"C0", "static_capacity_kN"},    {"drag_torque", "drag_torque_Nm"},
        {"axial_play", "axial_play_mm"}, {"grease_volume", "grease_volume_cm3"}};
    std::vector<std::string> read;
    for (const auto& [printed, column] : kHeadings) {
      const auto found = std::ranges::find(heading_, printed);
      if (found == heading_.end() || std::ranges::count(heading_, column) > 0) continue;
      *found = column;
      read.push_back(fmt::format("{} as {}", printed, column));
    }
    if (!read.empty())
      warnings.push_back(
          {path_, "makers_headings",
           fmt::format("columns of {} are read by their usual meaning: {}", name_, fmt::join(read, ", ")),
           "compare a row with the maker's page"});
  }

  void check_heading(std::vector<Warning>& warnings) const {
    for (const std::string_view needed : kNeededColumns)
      if (std::ranges::find(heading_, needed) == heading_.end())
        fail(fmt::format("lacks the column {}; expected at least {}", needed, fmt::join(kNeededColumns, ", ")));
    for (const std::string& column : heading_) {
      if (std::ranges::count(heading_, column) > 1)
        fail(fmt::format("has two columns {}; expected one of that name", input::shown(column)));
      if (!is_known(column))
        warnings.push_back({path_, "unknown_column_" + column,
                            fmt::format("the column {} of {} is not known, and not used", input::shown(column), name_),
                            "see docs/size.md for the columns"});
    }
  }

  /// Warns of static capacities below the dynamic ones: makers' are twice as large, so that columns may be swapped.
  void warn_of_capacities(const std::vector<CandidateData>& rows, std::vector<Warning>& warnings) const {
    const auto is_smaller = [](const CandidateData& c) { return c.static_capacity < c.dynamic_capacity; };
    const auto first = std::ranges::find_if(
        rows, [&](const CandidateData& c) { return c.static_capacity && c.dynamic_capacity && is_smaller(c); });
    if (first == rows.end()) return;
    warnings.push_back(
        Warning{path_, "static_below_dynamic_capacity",
                fmt::format("row {} of {} has a static capacity of {{value}}, below its dynamic one of {{limit}}",
                            first->number, name_),
                "check the columns and their units"}
            .with(*first->static_capacity, *first->dynamic_capacity, "kN"_unit));
  }

  /// Capacity from a number in kN, below the strength of any steel screw; a number in N would be a thousand times as
  /// large.
  std::optional<double> capacity(std::string_view column, double screw_diameter) const {
    constexpr double kMostStress = 2e9;  ///< Stress in the screw's section [Pa].
    const std::optional<double> force = number(column, 1e-3);
    const double most = kMostStress * disc_area(screw_diameter);
    if (force && *force > most)
      refuse(place_of(column),
             fmt::format("at most {:.4g} kN, under which this screw's section has {:g} MPa", most * "kN"_per_si,
                         kMostStress * "MPa"_per_si),
             "write kN in place of N");
    return force;
  }

  std::size_t place_of(std::string_view column) const {
    return static_cast<std::size_t>(std::ranges::find(heading_, column) - heading_.begin());
  }
  /// Text of a cell; empty if absent or not printed.
  std::string_view text(std::string_view column) const {
    const std::size_t place = place_of(column);
    const auto& fields = reader_.fields();
    return place < fields.size() && fields[place] != "-" ? fields[place] : std::string_view();
  }
  /// Number of a cell, above 0; the lead of a left-handed screw is below 0.
  std::optional<double> number(std::string_view column, double per_si = 1.0) const {
    const std::string_view field = text(column);
    const std::size_t place = place_of(column);
    if (field.empty()) {
      if (std::ranges::count(kNeededColumns, column)) refuse(place, "a number", "complete the row");
      return std::nullopt;
    }
    const bool is_lead = column == "lead_mm", is_count = column == "starts" || column == "rollers";
    const std::optional<double> value = input::parse_number(field);
    if (!value || (is_lead ? *value == 0.0 : *value <= 0.0) ||
        (is_count && (*value != std::round(*value) || *value > 1000.0)))
      refuse(place,
             is_count  ? "a whole number > 0"
             : is_lead ? "a number other than 0"
                       : "a number > 0",
             "fix the field, or write `-` for a value that is not printed");
    if (column.ends_with("efficiency") && *value > 1.0) refuse(place, "a fraction up to 1", "write 0.85 for 85 %");
    return *value / per_si;
  }

  CandidateData row() const {
    if (reader_.fields().size() > heading_.size())
      refuse(heading_.size(), fmt::format("{} fields as in the heading", heading_.size()),
             "write decimal marks as points, or quote texts that hold the separator");
    CandidateData c;
    c.is_row = true;
    c.name = text(text("name").empty() ? "screw" : "name");
    c.list = text("maker").empty() ? list_ : fmt::format("{}, {}", text("maker"), list_);
    const std::string_view type = text("type");
    if (!type.empty()) {
      const std::optional<Mechanism::Type> named = contact::type_named(type);
      if (!named) refuse(place_of("type"), "standard, inverted or recirculating", "write one of these");
      c.screw.type = *named;
    }
    c.screw.screw_diameter = *number("screw_diameter_mm", 1e3);
    c.screw.lead = *number("lead_mm", 1e3);
    c.screw.starts = static_cast<int>(*number("starts"));
    if (const auto rollers = number("rollers")) c.screw.rollers = static_cast<int>(*rollers);
    c.screw.nut_diameter = number("nut_diameter_mm", 1e3);
    c.screw.nut_length = number("nut_length_mm", 1e3);
    c.dynamic_capacity = capacity("dynamic_capacity_kN", c.screw.screw_diameter);
    c.static_capacity = capacity("static_capacity_kN", c.screw.screw_diameter);
    c.row_efficiency = number("efficiency");
    c.row_back_driving_efficiency = number("back_driving_efficiency");
    c.row_drag_torque = number("drag_torque_Nm");
    c.axial_play = number("axial_play_mm", 1e3);
    c.grease_volume = number("grease_volume_cm3", 1e6);
    return c;
  }

  std::string_view text_;
  std::string name_, list_, path_;
  const input::Source& source_;
  input::CsvReader reader_;
  std::vector<std::string> heading_;
};

std::string size_name(double diameter, double lead) { return fmt::format("{:.6g}x{:.6g}", 1e3 * diameter, 1e3 * lead); }

/// Makes names unique: the first keeps a common name, others get their numbers.
void name_apart(std::vector<CandidateData>& all) {
  std::set<std::string> taken;
  for (CandidateData& c : all) {
    if (c.name.empty()) c.name = size_name(c.screw.screw_diameter, c.screw.lead);
    while (!taken.insert(c.name).second) c.name += fmt::format(" ({} {})", c.is_row ? "row" : "design", c.number);
  }
}

void add_designs(const Requirement::Designs& d, const input::Source& source, std::vector<CandidateData>& all) {
  const std::vector<double> diameters = d.screw_diameter.values(), leads = d.lead.values();
  const std::vector<double> starts = d.starts ? d.starts->values() : std::vector<double>{0.0};
  double count = static_cast<double>(all.size());
  count += static_cast<double>(d.type.size()) * static_cast<double>(diameters.size()) *
           static_cast<double>(leads.size()) * static_cast<double>(starts.size());
  if (count > static_cast<double>(kMostCandidates))
    input::fail_at(source, "candidates",
                   "got {:.0f} candidates; expected at most {}; take fewer diameters, leads or "
                   "starts",
                   count, kMostCandidates);
  std::size_t number = 0;
  for (const Mechanism::Type type : d.type)
    for (const double diameter : diameters)
      for (const double lead : leads)
        for (const double n : starts) {
          CandidateData& c = all.emplace_back();
          c.list = "rules of prs new";
          c.number = ++number;
          c.name = size_name(diameter, lead);
          if (type != Mechanism::Type::standard && d.type.size() > 1)
            c.name += fmt::format(" {}", contact::facts_of(type).name);
          if (starts.size() > 1) c.name += fmt::format(" {:.0f}-start", n);
          c.screw.type = type;
          c.screw.screw_diameter = diameter;
          c.screw.lead = lead;
          if (n > 0.0) c.screw.starts = static_cast<int>(n);
        }
}

/// Screw of a candidate as in its written case.
CompleteScrew screw_of(const CandidateData& candidate, const std::optional<double>& stroke) {
  CompleteScrew screw = complete_screw(candidate.screw);
  if (carrier_part(candidate.screw.type) == Part::screw && stroke) {
    const double threads = screw.c.mechanism.contacts_per_roller * axial_pitch(screw.c.mechanism);
    const double least = *stroke + threads + 2.0 * screw.c.structure->roller.end_length;
    if (candidate.screw.nut_length) {
      if (*candidate.screw.nut_length < least * (1.0 - 1e-9))
        throw CaseError("nut_length", fmt::format("got {}; expected at least {}, in which the rollers travel {}",
                                                  mm(*candidate.screw.nut_length), mm(least), mm(*stroke)));
    } else {
      ScrewData longer = candidate.screw;
      longer.nut_length = 1e-3 * std::ceil(1e3 * std::max(least, threads / kThreadedShare) - 1e-9);
      screw = complete_screw(longer);
    }
  }
  required_capacity(screw);
  return as_written(std::move(screw));
}

double shaft_length(const Requirement& r, const CompleteScrew& s) {
  if (r.shaft.length) return *r.shaft.length;
  const double d = s.data.screw_diameter, nut = s.c.structure->nut.length;
  if (!r.stroke) return 20.0 * d;
  return (carrier_part(s.data.type) == Part::nut ? *r.stroke : 0.0) + nut + 2.0 * d;
}

/// Value rounded to the digits of a written case.
double rounded(double value) { return input::parse_number(fmt::format("{:.12g}", value)).value_or(value); }

/// `speed` along the axis; a case counts it > 0 in tension if the screw drives.
LoadCase load_case(const SizeInput& in, const CompleteScrew& s, std::string_view name, double force, double speed) {
  const Direction direction = direction_of(in.values, force);
  const bool as_in_case = (force > 0.0) == (direction == Direction::tension);
  return {.name = std::string(name),
          .axial_force = rounded(std::abs(force)),
          .direction = direction,
          .position = s.position,
          .speed = input::rotation(as_in_case ? speed : -speed, s.c.mechanism.lead)};
}

}  // namespace

std::vector<CandidateData> candidates_of(const SizeInput& in, std::vector<Warning>& warnings) {
  const Requirement::Candidates& from = in.values.candidates;
  std::vector<CandidateData> all;
  if (from.catalogue)
    for (std::size_t k = 0; k < from.catalogue->size(); ++k) {
      const auto& [file, list] = (*from.catalogue)[k];
      const std::string path = catalogue_file_key(*from.catalogue, k);
      std::ranges::move(CatalogueReader(input::named_file_text(file, path, in.source),
                                        input::name_in_messages(file, in.source), in.source, path, list.value_or(file))
                            .read(warnings),
                        std::back_inserter(all));
    }
  else if (!from.designs)
    all = CatalogueReader(standard_screws(), std::string(kStandardScrews), in.source).read(warnings);
  if (from.designs) add_designs(*from.designs, in.source, all);
  name_apart(all);
  return all;
}

MotorDuty::Step motor_step(const MotionSegment& s) {
  return {.load_case = {},
          .duration = s.duration,
          .start_speed = s.start_speed,
          .end_speed = s.end_speed,
          .force = s.force};
}

PerPart<double> as_written(const PerPart<double>& temperature) {
  const auto one = [](double kelvin) { return rounded(kelvin - kZeroCelsius) + kZeroCelsius; };
  return {one(temperature.screw), one(temperature.roller), one(temperature.nut)};
}

SizedCase sized_case(const SizeInput& in, const CandidateData& candidate) {
  const Requirement& r = in.values;
  const MotionCycle& cycle = in.cycle;
  SizedCase sized;
  sized.screw = screw_of(candidate, r.stroke);
  const CompleteScrew& s = sized.screw;
  sized.shaft_length = shaft_length(r, s);
  Case& c = sized.c;
  c = s.c;
  c.model.bodies = &kRefined;
  if (r.loads == ModelOptions::Loads::at_rest) c.model.loads = r.loads;
  Life& life = c.life.emplace();
  life.position = s.position;
  life.reliability = r.life.reliability;
  life.modification_factor = r.life.modification_factor;
  if (cycle.mean_load) {
    life.period = cycle.duration;
    life.travel = cycle.travel;
    if (!r.motion.loads && cycle.loaded_way > 0.0) life.stroke = rounded(cycle.loaded_way);
  }
  for (const MotionSegment& segment : cycle.shown) {
    std::optional<std::size_t>& place = sized.load_case_of.emplace_back();
    if (segment.force == 0.0 && !(r.preload && segment.sense() != 0)) continue;
    life.spectrum.push_back({.force = rounded(std::abs(segment.force)),
                             .direction = direction_of(r, segment.force),
                             .distance = cycle.mean_load ? rounded(std::abs(segment.travel())) : kNoTravel,
                             .driven_by = segment.driven_by()});
    if (segment.sense() == 0) continue;
    place = c.load_cases.size();
    c.load_cases.push_back(load_case(in, s, segment.name, segment.force, segment.sense() * segment.mean_speed()));
  }
  c.load_cases.push_back(load_case(in, s, kBackDriving, cycle.largest_sign * cycle.driving_force(),
                                   -cycle.largest_sign * cycle.driving_speed()));
  c.operation = Operation{.speed = input::rotation(cycle.driving_speed(), s.c.mechanism.lead)};
  if (cycle.largest_speed > 0.0)
    c.operation->largest_speed = input::rotation(cycle.largest_speed, std::abs(s.c.mechanism.lead));
  c.friction = r.friction;
  c.lubricant = r.lubricant;
  c.roughness = r.roughness;
  c.carrier = r.carrier;
  c.bearings = r.bearings;
  c.measures = r.measures;
  c.measures->shaft = MeasureOptions::Shaft{sized.shaft_length, r.shaft.ends};
  if (!r.load.positive_force && cycle.largest_sign < 0.0)
    c.measures->shaft->largest_compression = rounded(cycle.largest_compression);
  sized.drag_torque = r.load.drag_torque;
  if (r.preload) {
    Preload& preload = c.preload.emplace();
    preload.force =
        rounded(r.preload->force ? *r.preload->force
                                 : *r.preload->share * candidate.dynamic_capacity.value_or(required_capacity(s)));
    preload.position = s.position;
    preload.load = {-cycle.largest_force, cycle.largest_force};
  } else {
    sized.drag_torque += candidate.row_drag_torque.value_or(0.0);
  }
  return sized;
}

namespace {

/// A time in which segments of one class act.
struct ClassStep {
  std::size_t shown = 0;
  double duration = 0.0, acts = 0.0;  ///< Time, and that in which the mean force does the work of the segments [s].
};

/// The shown segments one after the other. In a mission classes act in the order of their segments: those of a window
/// of time are one step, a short window for few steps.
std::vector<ClassStep> steps_of_cycle(const SizeInput& in) {
  constexpr int kMost = 400, kMostInAll = 8000;
  const MotionCycle& cycle = in.cycle;
  const bool in_order = cycle.in_classes && in.values.has_mission();
  const int most = in_order ? std::min(kMost, kMostInAll / *in.values.heat->cycles) : 1;
  std::vector<ClassStep> steps;
  for (double window = cycle.duration / most;; window *= 2.0) {
    steps.clear();
    double at = 0.0, end = 0.0;
    std::ptrdiff_t first = 0;
    for (const MotionSegment& s : cycle.all) {
      if (at >= end) first = std::ssize(steps), end = at + window;
      auto step = std::ranges::find_if(steps.begin() + first, steps.end(),
                                       [&](const ClassStep& other) { return other.shown == s.shown_as; });
      if (step == steps.end()) step = steps.insert(step, {s.shown_as});
      const MotionSegment& of = cycle.shown[s.shown_as];
      step->duration += s.duration;
      step->acts += cycle.in_classes && of.work() > 0.0 ? of.duration * s.work() / of.work() : s.duration;
      at += s.duration;
    }
    if (std::ssize(steps) <= most || window >= cycle.duration) break;
  }
  // Work beyond the mean force of a step is done in later steps of its class, the remainder in earlier ones.
  std::vector<double> left(cycle.shown.size(), 0.0);
  for (int pass = 0; pass < 2; ++pass, std::ranges::reverse(steps))
    for (ClassStep& step : steps) {
      double& wanted = left[step.shown] += step.acts;
      step.acts = std::min(step.duration, wanted);
      wanted -= step.acts;
    }
  return steps;
}

}  // namespace

Heat heat_of_cycle(const SizeInput& in, const SizedCase& sized, const Heat::Conductance& k) {
  constexpr double kSpecificHeat = 460.0;  // Steel [J/(kg K)].
  const Requirement::Surroundings surroundings = in.values.heat.value_or(Requirement::Surroundings{});
  Heat heat{.ambient = surroundings.ambient, .conductance = k};
  if (in.values.has_mission()) {
    heat.cycles = surroundings.cycles;
    heat.start = surroundings.start;
    heat.specific_heat = kSpecificHeat;
  } else {
    heat.losses = Heat::Losses::stated;
  }
  const auto rest = [&](double time) {
    if (!heat.duty.empty() && heat.duty.back().rest && in.cycle.in_classes)
      *heat.duty.back().rest += time;
    else
      heat.duty.push_back({.load_case = {}, .duration = {}, .rest = time});
  };
  for (const ClassStep& step : steps_of_cycle(in)) {
    const MotionSegment& s = in.cycle.shown[step.shown];
    if (!sized.load_case_of[step.shown]) {
      rest(step.duration);
      continue;
    }
    if (step.acts > 0.0) heat.duty.push_back({.load_case = s.name, .duration = step.acts, .rest = {}});
    if (step.duration - step.acts > kAlike * step.duration) rest(step.duration - step.acts);
  }
  return heat;
}

namespace {

/// The block `motor`: every segment with its own force, and the friction of its load case.
MotorDuty motor_duty(const SizeInput& in, const SizedCase& sized) {
  const Requirement& r = in.values;
  MotorDuty duty{.motor = r.motor,
                 .brake_torque = r.brake_torque,
                 .brake_safety = r.brake_safety,
                 .drag_torque = sized.drag_torque,
                 .holding_force = in.cycle.holding_force,
                 .back_driving = r.limits.back_driving,
                 .driven_back = nlohmann::json(kBackDriving).dump(),
                 .cycle = {}};
  for (const MotionSegment& s : in.cycle.all) {
    duty.cycle.push_back(motor_step(s));
    if (sized.load_case_of[s.shown_as])
      duty.cycle.back().load_case = nlohmann::json(in.cycle.shown[s.shown_as].name).dump();
  }
  return duty;
}

/// Limits of the requirement that a case also has.
Limits limits_of(const SizeInput& in) {
  const Requirement::Life& life = in.values.life;
  Limits limits = in.values.limits;
  if (in.cycle.mean_load && (life.hours || life.distance))
    limits.life = LeastLife{.duration = life.hours, .travel = life.distance};
  return limits;
}

}  // namespace

namespace {

/// Lines of a written case, with remarks on defaults of the requirement.
class WrittenLines {
 public:
  explicit WrittenLines(const SizeInput& in) : fields_(in.fields) {}

  /// Block without values that are also the case's defaults.
  std::string block(std::string_view key, const input::Value& block, const input::Value& by_default) const {
    std::map<std::string, std::string, std::less<>> defaults;
    input::block_text(key, by_default, [&](std::string_view name, const std::string& text) {
      return defaults.emplace(name, text), std::nullopt;
    });
    return input::block_text(key, block,
                             [&](std::string_view name, const std::string& text) -> std::optional<std::string> {
                               const std::string path = fmt::format("{}.{}", key, name);
                               const auto same = defaults.find(name);
                               if (!text.empty() && !is_stated(path) && same != defaults.end() && same->second == text)
                                 return std::nullopt;
                               return remark(path, text);
                             });
  }

  /// Line `KEY: TEXT`.
  std::string line(std::string_view key, const std::string& text, const std::string& path) const {
    const std::string comment = remark(path, text);
    return fmt::format("{}: {}{}{}\n", key, text, comment.empty() ? "" : "  # ", comment);
  }

 private:
  bool has(const std::string& path, bool of_default) const {
    return std::ranges::any_of(fields_, [&](const input::EchoEntry& e) {
      const bool is_at = e.path.starts_with(path) &&
                         (e.path.size() == path.size() || e.path[path.size()] == '.' || e.path[path.size()] == '[');
      return is_at && e.is_default == of_default;
    });
  }
  bool is_stated(const std::string& path) const { return has(path, false); }
  std::string remark(const std::string& path, const std::string& text) const {
    if (path == "life.position") return fmt::format("assumed {}: rollers in the middle of the nut", text);
    if (is_stated(path) || !has(path, true)) return {};
    // The stroke belongs to the motion.
    const std::size_t stroke = path == "measures.shaft" ? text.find(", stroke: ") : text.npos;
    return fmt::format("assumed {}: default of `prs size`", stroke == text.npos ? text : text.substr(0, stroke) + "}");
  }

  const std::vector<input::EchoEntry>& fields_;
};

}  // namespace

std::string written_candidate(const SizeInput& in, const SizedCandidate& candidate) {
  using input::block_text, input::value_of, input::Block, input::format_quantity;
  const WrittenLines lines(in);
  SizedCase sized = sized_case(in, candidate);
  Case& c = sized.c;
  std::string text =
      screw_text(sized.screw, fmt::format("Chosen by `prs size` for {}: {}, {} {}.", in.source.name, candidate.name,
                                          candidate.is_row ? "row of the catalogue" : "design", candidate.number)) +
      fmt::format("\nmodel: {{bodies: refined{}}}  # assumed {{bodies: refined}}: as all candidates are computed\n",
                  c.model.loads ? ", loads: static" : "") +
      "# One load case per segment of the motion, at its mean speed, rollers in the middle of the nut; the load drives "
      "the last,\n# which is no part of the cycle.\n"
      "load_cases:\n";
  for (const LoadCase& load : c.load_cases)
    text += fmt::format("  - {{name: {}, axial_force: {}, direction: {}, position: {}, speed: {}}}\n",
                        nlohmann::json(load.name).dump(), format_quantity(load.axial_force, input::unit::force),
                        name(*load.direction), format_quantity(*load.position, input::unit::length),
                        fmt::format("{:.12g} rpm", *load.speed * "rpm"_per_si));
  const std::string law = text_of(value_of(*c.friction, input::ChoiceUnder{"model"}));
  text += "\n# Mean of the time in motion, and the largest.\n" +
          block_text("operation", value_of(*c.operation, Block{})) +
          lines.line("friction", law.starts_with("{model") ? law : fmt::format("{{model: {}}}", law), "friction");
  const bool has_heat = in.values.heat.has_value(), by_row = in.values.losses == Requirement::Losses::catalogue;
  const PerPart<double>& rough = *c.roughness;
  if (in.values.has_mission()) c.lubricant->temperature.reset();
  Lubricant lubricant_default;
  Carrier carrier_default;
  Life life_default;
  MeasureOptions measures_default;
  Limits limits_default;
  text += lines.block("lubricant", value_of(*c.lubricant, Block{}), value_of(lubricant_default, Block{})) +
          lines.line("roughness",
                     fmt::format("{{screw: {:.15g} um, roller: {:.15g} um, nut: {:.15g} um}}", 1e6 * rough.screw,
                                 1e6 * rough.roller, 1e6 * rough.nut),
                     "roughness") +
          lines.block("carrier", value_of(c.carrier, Block{}), value_of(carrier_default, Block{})) +
          (in.values.has_mission() ? "\n# The mission, whose losses follow the temperatures of the parts.\n"
           : !candidate.is_steady  ? "\n# The losses leave no steady temperatures, and nothing that depends on them.\n"
           : has_heat && by_row    ? "\n# Temperatures are not known, since the efficiency of a catalogue does not say "
                                     "where losses arise. With those "
                                     "of\n# `prs slip` they would be the mean of the cycle:\n"
           : candidate.temperature
               ? "\n# Mean of the cycle. For parts that warm up and oil that follows, write `specific_heat: 460 "
                 "J/(kg K)` in place of\n# `losses: stated`, and delete temperatures of parts.\n"
           : has_heat
               ? "\n# Slip finds no equilibrium, so that temperatures are not known.\n"
               : "\n# Temperatures are not known. With what seat, bearings and air take they would be the mean of the "
                 "cycle; bare parts in\n# still air, by the rules of `prs new`:\n");
  Heat heat = heat_of_cycle(in, sized, candidate.conductance);
  if (!candidate.is_steady) heat = {.ambient = heat.ambient, .conductance = heat.conductance};
  for (Heat::DutyStep& step : heat.duty)
    if (step.load_case) step.load_case = nlohmann::json(*step.load_case).dump();
  std::string of_heat = block_text("heat", value_of(heat, Block{}));
  const bool acts = has_heat && !by_row;
  for (std::size_t at = 0; !acts && at < of_heat.size(); at = of_heat.find('\n', at) + 1) of_heat.insert(at, "# ");
  if (candidate.parts_at && !in.values.has_mission())
    of_heat +=
        fmt::format("deviations: {{temperature: {{screw: {:.12g} degC, roller: {:.12g} degC, nut: {:.12g} degC}}}}\n",
                    candidate.parts_at->screw - kZeroCelsius, candidate.parts_at->roller - kZeroCelsius,
                    candidate.parts_at->nut - kZeroCelsius);
  Life& life = *c.life;
  life.dynamic_capacity = candidate.rated_dynamic_capacity;
  life.static_capacity = candidate.rated_static_capacity;
  const bool travels = carrier_part(sized.screw.data.type) == Part::nut;
  if (travels && in.values.stroke && sized.shaft_length >= *in.values.stroke + c.structure->nut.length)
    c.measures->shaft->stroke = in.values.stroke;
  Limits limits = limits_of(in);
  MotorDuty duty = motor_duty(in, sized);
  const std::string preload = c.preload ? "\n# Oversized rollers; `prs preload` has the curve through zero.\n" +
                                              block_text("preload", value_of(*c.preload, Block{}))
                                        : "";
  return text + of_heat + preload + "\n# Without a capacity, as makers print it, life is that by threads.\n" +
         lines.block("life", value_of(life, Block{}), value_of(life_default, Block{})) + "\n" +
         lines.block("measures", value_of(*c.measures, Block{}), value_of(measures_default, Block{})) + "\n" +
         (c.bearings ? block_text("bearings", value_of(*c.bearings, Block{})) + "\n" : "") +
         lines.block("limits", value_of(limits, Block{}), value_of(limits_default, Block{})) +
         "\n# One cycle of the axis; `prs check` holds motor and brake against their limits.\n" +
         block_text("motor", value_of(duty, Block{}));
}

}  // namespace prs
