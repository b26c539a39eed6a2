#include "validation/reference_fe/curves.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/model/units.h"
#include "prs/validation/csv_table.h"

namespace prs::reference_fe {
namespace {

using Contacts = ModelOptions::RollerContacts;

/// Words of the file and what they mean.
template <class Value>
using Words = std::array<std::pair<std::string_view, Value>, 2>;

constexpr Words<Direction> kDirections{
    {{"tension", Direction::tension}, {"compression", Direction::compression}}};
constexpr Words<Guidance::Kind> kGuidances{{{"both_end_nodes", Guidance::Kind::both_end_nodes},
                                            {"outer_node", Guidance::Kind::outer_node}}};
constexpr Words<Contacts> kContacts{
    {{"opposite", Contacts::opposite}, {"half_pitch", Contacts::half_pitch_apart}}};
constexpr int kConfigs = 3;
constexpr std::size_t kSetups =
    kConfigs * kDirections.size() * kGuidances.size() * kContacts.size();

/// A printed digit is rounded from a computation of unknown rounding.
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

  std::vector<Curve> curves() const {
    std::vector<Curve> all;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
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
                    fmt::format("the curve {} has {} loads, others {}", name(curve.setup),
                                curve.points.size(), all.front().points.size()));
    if (all.size() != kSetups)
      table_.fail(table_.rows() - 1, config_,
                  fmt::format("the file ends with {} of {} curves", all.size(), kSetups));
    return all;
  }

 private:
  static std::string rate_name(Interface i, std::size_t thread) {
    return fmt::format("{}_{}_%", prs::name(i), thread);
  }
  Interface fewer() const {
    return rates_.screw.size() < rates_.nut.size() ? Interface::screw : Interface::nut;
  }
  std::size_t count() const { return rates_[fewer()].size(); }

  Setup setup_at(std::size_t row) const {
    const double config = table_.number(row, config_);
    if (config != std::floor(config) || config < 1.0 || config > kConfigs)
      table_.fail(row, config_, fmt::format("expected 1 to {}", kConfigs));
    return {static_cast<int>(config), choice(row, direction_, kDirections),
            choice(row, guidance_, kGuidances), choice(row, contacts_, kContacts)};
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
    return {load / per_si::kilonewton,
            displacement / per_si::micrometre,
            {rates_at(row, Interface::screw), rates_at(row, Interface::nut)}};
  }

  /// kN and um as printed.
  void check_stiffness(std::size_t row, double load, double displacement) const {
    const double stiffness = 1e3 * load / displacement;
    const double rounding = table_.half_unit(row, stiffness_) +
                            stiffness * table_.half_unit(row, displacement_) / displacement;
    if (std::abs(positive(row, stiffness_) - stiffness) > rounding * kSlack)
      table_.fail(row, stiffness_,
                  fmt::format("expected {:.6g}, load over displacement", stiffness));
  }

  std::vector<double> rates_at(std::size_t row, Interface i) const {
    std::vector<double> rates;
    double sum = 0.0, rounding = 0.0;
    for (const std::size_t column : rates_[i]) {
      const double percent = table_.number(row, column);
      sum += percent;
      rounding += table_.half_unit(row, column);
      rates.push_back(percent / per_si::percent);
    }
    if (std::abs(sum - 100.0) > rounding * kSlack)
      table_.fail(
          row, rates_[i].front(),
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

}  // namespace

std::array<std::string, 4> words(const Setup& setup) {
  return {fmt::to_string(setup.config), std::string(prs::name(setup.direction)),
          word(kGuidances, setup.guidance), word(kContacts, setup.contacts)};
}

std::string name(const Setup& setup) { return fmt::format("{}", fmt::join(words(setup), " ")); }

std::vector<Curve> read_curves(const std::filesystem::path& file) { return Reader(file).curves(); }

}  // namespace prs::reference_fe
