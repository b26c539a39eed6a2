#include "validation/reference_fe/comparison.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/loads/analyze.h"
#include "prs/reference/curve_deviations.h"
#include "prs/validation/validate.h"

namespace prs::reference_fe {
namespace {

using Contacts = ModelOptions::RollerContacts;

/// Words of the file and what they mean.
template <class Value>
using Words = std::array<std::pair<std::string_view, Value>, 2>;

constexpr Words<Direction> kDirections{{{"tension", Direction::tension}, {"compression", Direction::compression}}};
constexpr Words<Guidance::Kind> kGuidances{
    {{"both_end_nodes", Guidance::Kind::both_end_nodes}, {"outer_node", Guidance::Kind::outer_node}}};
constexpr Words<Contacts> kContacts{{{"opposite", Contacts::opposite}, {"half_pitch", Contacts::half_pitch_apart}}};
constexpr int kConfigs = 3;
constexpr std::size_t kSetups = kConfigs * kDirections.size() * kGuidances.size() * kContacts.size();

/// Tolerance for printed digits, which are rounded from a computation of unknown rounding.
constexpr double kSlack = 1.0 + 1e-9;

template <class Value>
std::string word(const Words<Value>& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return std::string(word);
  return {};
}

/// Reads the rows of a table.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : table_(file) {
    for (const Interface i : kInterfaces) {
      std::vector<std::size_t>& columns = rates_[i];
      while (table_.has_column(rate_name(i, columns.size() + 1)))
        columns.push_back(table_.column(rate_name(i, columns.size() + 1)));
      if (columns.empty()) table_.column(rate_name(i, 1));
    }
    if (rates_.screw.size() != rates_.nut.size()) table_.column(rate_name(fewer(), count() + 1));
  }

  Curves curves() const {
    Curves all;
    for (const auto row : up_to(table_.rows())) {
      const Setup setup = setup_at(row);
      const auto known = std::ranges::find(all, setup, &Curve::setup);
      Curve& curve = known == all.end() ? all.emplace_back(Curve{setup, {}}) : *known;
      CurvePoint point = point_at(row);
      if (!curve.points.empty() && point.load <= curve.points.back().load)
        table_.fail(row, load_, "expected loads of a curve in ascending order");
      curve.points.push_back(std::move(point));
    }
    for (const Curve& curve : all)
      if (curve.points.size() != all.front().points.size())
        table_.fail(table_.rows() - 1, load_,
                    fmt::format("the curve {} has {} loads, others {}", name(curve.setup), curve.points.size(),
                                all.front().points.size()));
    if (all.size() != kSetups)
      table_.fail(table_.rows() - 1, config_, fmt::format("the file ends with {} of {} curves", all.size(), kSetups));
    return all;
  }

 private:
  static std::string rate_name(Interface i, std::size_t thread) { return fmt::format("{}_{}_%", prs::name(i), thread); }
  Interface fewer() const { return rates_.screw.size() < rates_.nut.size() ? Interface::screw : Interface::nut; }
  std::size_t count() const { return rates_[fewer()].size(); }

  Setup setup_at(std::size_t row) const {
    const double config = table_.number(row, config_);
    if (config != std::floor(config) || config < 1.0 || config > kConfigs)
      table_.fail(row, config_, fmt::format("expected 1 to {}", kConfigs));
    return {static_cast<int>(config), choice(row, direction_, kDirections), choice(row, guidance_, kGuidances),
            choice(row, contacts_, kContacts)};
  }

  template <class Value>
  Value choice(std::size_t row, std::size_t column, const Words<Value>& words) const {
    const std::string text = table_.text(row, column);
    std::string expected;
    for (const auto& [word, value] : words) {
      if (word == text) return value;
      expected += fmt::format("{}{}", expected.empty() ? "" : " | ", word);
    }
    table_.fail(row, column, fmt::format("got {}; expected {}", input::shown(text), expected));
  }

  double positive(std::size_t row, std::size_t column) const {
    const double value = table_.number(row, column);
    if (value <= 0.0) table_.fail(row, column, "expected a number above 0");
    return value;
  }

  CurvePoint point_at(std::size_t row) const {
    const double load = positive(row, load_), displacement = positive(row, displacement_);
    check_stiffness(row, load, displacement);
    return {load / "kN"_per_si,
            displacement / "µm"_per_si,
            {rates_at(row, Interface::screw), rates_at(row, Interface::nut)}};
  }

  /// Checks a stiffness against kN and um as printed.
  void check_stiffness(std::size_t row, double load, double displacement) const {
    const double stiffness = 1e3 * load / displacement;
    const double rounding =
        table_.half_unit(row, stiffness_) + stiffness * table_.half_unit(row, displacement_) / displacement;
    if (std::abs(positive(row, stiffness_) - stiffness) > rounding * kSlack)
      table_.fail(row, stiffness_, fmt::format("expected {:.6g}, load over displacement", stiffness));
  }

  std::vector<double> rates_at(std::size_t row, Interface i) const {
    std::vector<double> rates;
    double sum = 0.0, rounding = 0.0;
    for (const std::size_t column : rates_[i]) {
      const double percent = table_.number(row, column);
      sum += percent;
      rounding += table_.half_unit(row, column);
      rates.push_back(percent / "%"_per_si);
    }
    if (std::abs(sum - 100.0) > rounding * kSlack)
      table_.fail(row, rates_[i].front(),
                  fmt::format("the {} load rates sum to {:.6f} %; expected 100", prs::name(i), sum));
    return rates;
  }

  CsvTable table_;
  std::size_t config_ = table_.column("config");
  std::size_t direction_ = table_.column("direction");
  std::size_t guidance_ = table_.column("guidance");
  std::size_t contacts_ = table_.column("lever");
  std::size_t load_ = table_.column("load_kN");
  std::size_t displacement_ = table_.column("displacement_um");
  std::size_t stiffness_ = table_.column("stiffness_N_per_um");
  PerInterface<std::vector<std::size_t>> rates_;
};

double position_of(const Case& screw, const Setup& setup) {
  const std::string name = fmt::format("config{}-{}", setup.config, prs::name(setup.direction));
  const auto found = std::ranges::find(screw.load_cases, name, &LoadCase::name);
  if (found == screw.load_cases.end() || !found->position)
    throw CaseError("load_cases", fmt::format("expected a case {} with a position", name));
  return *found->position;
}

/// Adds the loads of a curve as load cases.
void add_load_cases(Case& c, const Curve& curve, const Case& screw) {
  for (const CurvePoint& point : curve.points) {
    LoadCase load_case;
    load_case.name = name(curve.setup);
    load_case.axial_force = point.load;
    load_case.direction = curve.setup.direction;
    load_case.position = position_of(screw, curve.setup);
    c.load_cases.push_back(load_case);
  }
}

void require_threads(const Case& screw, const Curves& reference) {
  const std::size_t threads = reference.front().points.front().load_rate.screw.size();
  if (threads != static_cast<std::size_t>(screw.mechanism.contacts_per_roller))
    throw CaseError("mechanism.contacts_per_roller",
                    fmt::format("expected {}, as many threads as the reference has", threads));
}

/// Indices of curves with the same roller, which one run can solve.
std::vector<std::vector<std::size_t>> grouped(const Curves& curves) {
  std::vector<std::vector<std::size_t>> groups;
  for (const auto k : indices(curves)) {
    const auto group = std::ranges::find_if(groups, [&](const auto& indices) {
      const Setup& first = curves[indices.front()].setup;
      return first.guidance == curves[k].setup.guidance && first.contacts == curves[k].setup.contacts;
    });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(k);
  }
  return groups;
}

CurvePoint point_of(const LoadCaseResult& result) {
  CurvePoint point{result.load_case.axial_force, 0.0, {}};
  if (!result.threads || !result.axial_displacement) return point;
  point.displacement = *result.axial_displacement;
  for (const Interface i : kInterfaces) point.load_rate[i] = (*result.threads)[i].load_rate;
  return point;
}

LoadDiscrepancy load_discrepancy(const std::vector<double>& rates, const std::vector<double>& reference) {
  const CurveDeviations found = curve_deviations(rates, reference).value_or(CurveDeviations{});
  LoadDiscrepancy d{found.mean_magnitude, std::abs(found.largest), 0.0, -HUGE_VAL, HUGE_VAL};
  const double share = 1.0 / static_cast<double>(rates.size());
  for (const auto k : indices(rates)) {
    const double relative = (rates[k] - reference[k]) / reference[k];
    d.relative_mean += share * relative;
    d.relative_highest = std::max(d.relative_highest, relative);
    d.relative_lowest = std::min(d.relative_lowest, relative);
  }
  return d;
}

/// Gathers the discrepancies of points.
class Gathering {
 public:
  void add(const Curve& curve, const CurvePoint& point, const std::optional<Discrepancy>& d) {
    ++s_.points;
    if (!d) {
      ++s_.unsolved;
      return;
    }
    const bool first = s_.points - s_.unsolved == 1;
    const auto keep = [&](Extreme& extreme, double value, bool better) {
      if (first || better) extreme = {value, curve.setup, point.load};
    };
    keep(s_.least_stiff, d->stiffness, d->stiffness < s_.least_stiff.value);
    keep(s_.stiffest, d->stiffness, d->stiffness > s_.stiffest.value);
    const double largest = std::max(d->loads.screw.largest, d->loads.nut.largest);
    keep(s_.best_loads, largest, largest < s_.best_loads.value);
    keep(s_.worst_loads, largest, largest > s_.worst_loads.value);
    s_.mean_stiffness += d->stiffness;
    for (const Interface i : kInterfaces) {
      s_.mean_load[i] += d->loads[i].mean;
      s_.largest_load[i] = std::max(s_.largest_load[i], d->loads[i].largest);
    }
  }

  Summary result() const {
    Summary s = s_;
    const double solved = std::max(1, s.points - s.unsolved);
    s.mean_stiffness /= solved;
    for (const Interface i : kInterfaces) s.mean_load[i] /= solved;
    return s;
  }

 private:
  Summary s_;
};

}  // namespace

std::array<std::string, 4> words(const Setup& setup) {
  return {fmt::to_string(setup.config), std::string(prs::name(setup.direction)), word(kGuidances, setup.guidance),
          word(kContacts, setup.contacts)};
}

std::string name(const Setup& setup) { return fmt::format("{}", fmt::join(words(setup), " ")); }

Curves read_curves(const std::filesystem::path& file) { return Reader(file).curves(); }

Curves computed_curves(const Case& screw, ModelOptions::Bodies bodies, const Curves& reference) {
  require_threads(screw, reference);
  Curves all(reference.size());
  for (const std::vector<std::size_t>& group : grouped(reference)) {
    Case c = screw;
    c.model.bodies = bodies;
    c.model.roller_contacts = reference[group.front()].setup.contacts;
    c.structure->roller.guidance.kind = reference[group.front()].setup.guidance;
    c.load_cases.clear();
    for (const std::size_t k : group) add_load_cases(c, reference[k], screw);
    const std::vector<LoadCaseResult> results = analyze(c).load_cases;
    auto result = results.begin();
    for (const std::size_t k : group) {
      all[k].setup = reference[k].setup;
      while (all[k].points.size() < reference[k].points.size()) all[k].points.push_back(point_of(*result++));
    }
  }
  return all;
}

std::optional<Discrepancy> discrepancy(const CurvePoint& point, const CurvePoint& reference) {
  if (!point.is_solved() || !reference.is_solved()) return std::nullopt;
  return Discrepancy{point.stiffness() / reference.stiffness() - 1.0,
                     {load_discrepancy(point.load_rate.screw, reference.load_rate.screw),
                      load_discrepancy(point.load_rate.nut, reference.load_rate.nut)}};
}

const Extreme& Summary::farthest_stiffness() const {
  return std::abs(least_stiff.value) > std::abs(stiffest.value) ? least_stiff : stiffest;
}

Summary summary(const Curves& curves, const Curves& reference, const Selection& selection) {
  Gathering gathering;
  for (const auto k : indices(curves))
    for (const auto load : indices(curves[k].points)) {
      const CurvePoint& point = curves[k].points[load];
      if (selection(curves[k].setup, point.load))
        gathering.add(curves[k], point, discrepancy(point, reference[k].points[load]));
    }
  return gathering.result();
}

}  // namespace prs::reference_fe
