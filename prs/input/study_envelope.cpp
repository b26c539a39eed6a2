#include "prs/input/study_envelope.h"

#include <algorithm>

#include "prs/indices.h"
#include "prs/input/units.h"

namespace prs::input {
namespace {

class EnvelopeReader {
 public:
  EnvelopeReader(const EnvelopeItem& item, const Node& root, Study& study, ErrorList& errors)
      : item_(item), root_(root), study_(study), errors_(errors) {}

  void read() {
    axes_ = map_axes(study_);
    if (!axes_) return refuse_factors();
    read_measures();
    read_points();
    study_.envelope = std::move(envelope_);
    check_size();
  }

 private:
  void refuse(const std::string& path, const std::string& message) { input::refuse(root_, path, message, errors_); }

  void refuse_factors() {
    const std::size_t count = study_.factors.size();
    if (count != 2)
      return refuse("study.factors", fmt::format("got {} factor{}; expected two with `envelope`, the axes of its "
                                                 "maps; {}",
                                                 count, count == 1 ? "" : "s",
                                                 count < 2 ? "add one"
                                                           : "let the others go `with` one of them, or leave them "
                                                             "out"));
    for (const auto k : up_to(2)) {
      Study alone = study_;
      alone.factors = {study_.factors[k], study_.factors[k]};
      if (!map_axes(alone))
        refuse(fmt::format("study.factors[{}].values", k),
               "expected at least two different numbers with `envelope`, an axis of its maps; "
               "write for example `values: {from: 20 mm, to: 30 mm, steps: 21}`");
    }
  }

  void read_measures() {
    envelope_.combine = item_.combine;
    envelope_.normalise = item_.normalise;
    envelope_.measures = item_.measures;
    for (const auto k : indices(item_.measures)) {
      const std::string& response = item_.measures[k].response;
      const auto same = std::ranges::find(item_.measures, response, &Envelope::Measure::response);
      if (same - item_.measures.begin() < static_cast<std::ptrdiff_t>(k))
        refuse(fmt::format("study.envelope.measures[{}].response", k),
               fmt::format("got {} a second time; expected each measure once; put both weights "
                           "into one",
                           shown(response)));
      need(response);
    }
  }

  void need(const std::string& response) {
    if (!contains(study_.responses, response)) study_.responses.push_back(response);
  }

  void read_points() {
    for (const auto k : indices(item_.points)) {
      const EnvelopePointItem& point = item_.points[k];
      const std::string path = fmt::format("study.envelope.points[{}]", k);
      const auto same = std::ranges::find(item_.points, point.name, &EnvelopePointItem::name);
      if (same - item_.points.begin() < static_cast<std::ptrdiff_t>(k))
        refuse(path + ".name", fmt::format("got {} a second time; expected a name of its own for "
                                           "each point; write another one",
                                           shown(point.name)));
      const int ways = (point.at ? 1 : 0) + (point.wanted ? 1 : 0) + (point.reach ? 1 : 0);
      if (ways != 1) {
        refuse(path, fmt::format("got {} of at, wanted, reach; expected one of them, which says "
                                 "where the point is; write for example `wanted: best`",
                                 ways == 0 ? "none" : "several"));
        continue;
      }
      Envelope::Point read{point.name, std::nullopt, {}};
      if (point.at) read.at = read_place(path, *point.at);
      if (point.reach) read.reach = read_targets(path, *point.reach);
      envelope_.points.push_back(std::move(read));
    }
  }

  std::optional<std::array<double, 2>> read_place(const std::string& path, const std::vector<std::string>& written) {
    std::array<double, 2> at{};
    bool good = true;
    for (const auto a : up_to(2)) {
      const std::optional<double> number = read_number(fmt::format("{}.at[{}]", path, a), written[a], (*axes_)[a]);
      good = good && number;
      at[a] = number.value_or(0.0);
    }
    return good ? std::optional(at) : std::nullopt;
  }

  /// Number of a value of a factor; a level's own number if there are no values between levels.
  std::optional<double> read_number(const std::string& path, const std::string& written, const MapAxis& axis) {
    const Factor& factor = study_.factors[axis.factor];
    const auto level = std::ranges::find(factor.levels, written, &Level::text);
    if (level != factor.levels.end()) return level->number;
    const std::optional<double> number = number_in(written, factor.unit);
    const Level &least = factor.levels[axis.levels.front()], &largest = factor.levels[axis.levels.back()];
    const std::string expected =
        fmt::format("a value of {} from {} to {}", shown(factor.path), least.text, largest.text);
    if (!number || !axis.place(*number))
      refuse(path, fmt::format("got {}; expected {}; write for example `{}`", shown(written), expected, least.text));
    else if (!axis.continuous && !contains(axis.numbers, *number))
      refuse(path, fmt::format("got {}; expected {} that stands in the list, since it or what goes with "
                               "it has no values in between; write for example `{}`",
                               shown(written), expected, nearest(factor, *number)));
    else
      return number;
    return std::nullopt;
  }

  static std::string nearest(const Factor& factor, double number) {
    return std::ranges::min_element(factor.levels, {},
                                    [&](const Level& level) { return std::abs(*level.number - number); })
        ->text;
  }

  std::vector<Envelope::Target> read_targets(const std::string& path, const std::vector<Envelope::Target>& targets) {
    for (const Envelope::Target& target : targets) need(target.response);
    if (targets.size() < 2) return targets;
    if (targets[0].response == targets[1].response)
      refuse(
          path + ".reach[1].response",
          fmt::format("got {} a second time; expected two responses; delete one of them", shown(targets[1].response)));
    for (const MapAxis& axis : *axes_)
      if (!axis.continuous)
        refuse(path + ".reach", fmt::format("got two responses; expected one, since {} or what goes with it has no "
                                            "values between those listed; delete one of them",
                                            shown(study_.factors[axis.factor].path)));
    return targets;
  }

  void check_size() {
    const double values = static_cast<double>(study_.responses.size()) * static_cast<double>((*axes_)[0].nodes()) *
                          static_cast<double>((*axes_)[1].nodes());
    if (values > static_cast<double>(kMostMapValues))
      refuse("study.factors", fmt::format("got {:.6g} numbers in the maps; expected at most {} with `envelope`; "
                                          "write ranges with fewer steps, or fewer responses",
                                          values, kMostMapValues));
  }

  const EnvelopeItem& item_;
  const Node& root_;
  Study& study_;
  ErrorList& errors_;
  std::optional<std::array<MapAxis, 2>> axes_;
  Envelope envelope_;
};

}  // namespace

void read_envelope(const EnvelopeItem& item, const Node& root, Study& study, ErrorList& errors) {
  EnvelopeReader(item, root, study, errors).read();
}

}  // namespace prs::input
