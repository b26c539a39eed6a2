#include "prs/compare/reference_figures.h"

#include "prs/indices.h"
#include "prs/loads/load_record.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Styles of models and references in a figure.
struct Look {
  std::vector<std::size_t> models, points, bars;
  std::vector<std::string> names = {};  ///< Names of references.

  Look(Figure& figure, const ModelComparison& c) {
    for (const ReferenceComparison& r : c.references)
      if (!contains(names, r.reference.name)) names.push_back(r.reference.name);
    for (const auto k : indices(names)) {
      Style style = points_of(k == 0 ? Colour::ink : case_colour(k + c.models.size()), static_cast<Mark>(1 + k % 8));
      style.open = true;
      points.push_back(figure.add(shown_name(names[k]), style));
      bars.push_back(figure.add(line_of(style.colour, Dash::solid, Weight::thin)));
    }
    constexpr Dash kDashes[] = {Dash::dashed, Dash::dash_dotted, Dash::solid};
    for (const auto m : indices(c.models))
      models.push_back(figure.add(std::string(name_of_model(c.models[m].model)),
                                  line_of(case_colour(m + 1), kDashes[m % std::size(kDashes)])));
  }

  std::size_t name(const ReferenceComparison& r) const {
    return static_cast<std::size_t>(std::ranges::find(names, r.reference.name) - names.begin());
  }
};

/// Adds a reference and, unless another has added them, the models to a panel; x and y may be exchanged and mirrored.
template <class Place>
void add_curves(Panel& panel, const Look& look, const ReferenceComparison& r, bool with_models, const Place& place) {
  Series points{look.points[look.name(r)], {{}}}, bars{look.bars[look.name(r)]};
  for (const ReferenceReading& reading : r.reference.readings) {
    points.parts[0].push_back(place(reading.along, reading.value));
    if (const auto d = reading.deviation)
      bars.parts.push_back({place(reading.along, reading.value - *d), place(reading.along, reading.value + *d)});
  }
  for (std::size_t m = 0; with_models && m < r.models.size(); ++m) {
    Series line{look.models[m], {{}}};
    for (const auto k : indices(r.models[m].computed))
      if (const double y = r.models[m].computed[k]; std::isfinite(y))
        line.parts[0].push_back(place(r.reference.readings[k].along, y));
    panel.series.push_back(std::move(line));
  }
  if (!bars.parts.empty()) panel.series.push_back(std::move(bars));
  panel.series.push_back(std::move(points));
}

/// `Roller-screw` where the response is one of an interface's threads.
std::string place_of(const ReferenceCurve& r) {
  for (const Interface i : kInterfaces)
    if (r.response.find(fmt::format("{}.", name(i))) != r.response.npos) return interface_title(i);
  return response_title(r.response).name;
}

std::string_view last_key(const ReferenceCurve& r) {
  return std::string_view(r.response).substr(r.response.rfind('.') + 1);
}

Axis y_axis(const ReferenceCurve& r) {
  std::string words = last_key(r) == "load_rate_percent" ? "share of the load" : words_of(last_key(r));
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return {words, std::string(unit_at(r.response).text)};
}

std::size_t thread_count(const ModelComparison& c) {
  return static_cast<std::size_t>(c.best().contacts.mechanism.contacts_per_roller);
}

Axis x_axis(const ModelComparison& c, const ReferenceCurve& r) {
  if (r.is_over_threads()) return thread_axis(thread_count(c));
  return {r.is_over_force() ? "Axial force" : r.along, r.along_unit};
}

bool is_of_one_panel(const ReferenceCurve& a, const ReferenceCurve& b) {
  return a.load_case == b.load_case && a.response == b.response && a.along == b.along && a.along_unit == b.along_unit;
}

bool is_of_one_figure(const ReferenceCurve& a, const ReferenceCurve& b) {
  return a.unit == b.unit && last_key(a) == last_key(b) && a.along == b.along && a.along_unit == b.along_unit;
}

/// The mean share of a thread.
void add_mean_share(Figure& figure, const ModelComparison& c, const ReferenceCurve& r) {
  if (last_key(r) == "load_rate_percent") add_mean(figure, "%"_per_si / static_cast<double>(thread_count(c)));
}

}  // namespace

Figures reference_figures(const ModelComparison& c, const FigureOptions&) {
  Figures figures;
  std::vector<const ReferenceComparison*> left;
  for (const ReferenceComparison& r : c.references)
    if (!r.reference.along.empty()) left.push_back(&r);
  while (!left.empty()) {
    const ReferenceCurve& first = left.front()->reference;
    Figure figure{figures.empty() ? "references" : fmt::format("references-{}", figures.size() + 1),
                  "Reference and models"};
    figure.x = x_axis(c, first);
    figure.y = y_axis(first);
    const Look look(figure, c);
    std::vector<const ReferenceCurve*> shown;
    for (const ReferenceComparison* r : left) {
      if (!is_of_one_figure(first, r->reference)) continue;
      const auto known = std::ranges::find_if(
          shown, [&](const ReferenceCurve* other) { return is_of_one_panel(*other, r->reference); });
      const auto panel = static_cast<std::size_t>(known - shown.begin());
      const bool is_new = known == shown.end();
      if (is_new) {
        shown.push_back(&r->reference);
        const std::string load_case = shown_name(r->reference.load_case);
        figure.panels.push_back({place_of(r->reference) + (load_case.empty() ? "" : ", " + load_case)});
      }
      add_curves(figure.panels[panel], look, *r, is_new, [](double x, double y) { return std::array{x, y}; });
    }
    std::erase_if(
        left, [&](const ReferenceComparison* r) { return r != left.front() && is_of_one_figure(first, r->reference); });
    left.erase(left.begin());
    figure.columns = std::min<std::size_t>(figure.panels.size(), 2);
    add_mean_share(figure, c, first);
    fit_y_range(figure, true);
    figures.push_back(std::move(figure));
  }
  return figures;
}

Figures reference_butterfly(const ModelComparison& c, bool tension_to_left) {
  const auto stem = [](const std::string& load_case) { return load_case.substr(0, load_case.find_last_of("- _")); };
  const auto direction = [&](const ReferenceCurve& r) {
    const auto load =
        std::ranges::find(c.best().load_cases, r.load_case, [](const LoadCaseResult& l) { return l.load_case.name; });
    return load == c.best().load_cases.end() ? std::nullopt : load->load_case.direction;
  };
  const Direction left = tension_to_left ? Direction::tension : Direction::compression;
  Figure figure{"reference_butterfly", fmt::format("Reference and models, {} to the left, {} to the right",
                                                   prs::name(left), prs::name(opposite(left)))};
  const Look look(figure, c);
  std::vector<std::pair<std::string, std::string>> panels;
  const ReferenceCurve* first = nullptr;
  double largest = 0.0;
  for (const ReferenceComparison& r : c.references) {
    const ReferenceCurve& its = r.reference;
    const bool has_other = std::ranges::any_of(c.references, [&](const ReferenceComparison& other) {
      return other.reference.response == its.response && other.reference.load_case != its.load_case &&
             stem(other.reference.load_case) == stem(its.load_case) && direction(other.reference) != direction(its);
    });
    if (!its.is_over_threads() || !direction(its) || !has_other) continue;
    if (!first) first = &its;
    if (!is_of_one_figure(*first, its)) continue;
    const std::pair key{stem(its.load_case), its.response};
    const auto known = std::ranges::find(panels, key);
    const auto panel = static_cast<std::size_t>(known - panels.begin());
    if (known == panels.end()) {
      panels.push_back(key);
      figure.panels.push_back({fmt::format("{}, {}", place_of(its), shown_name(key.first))});
    }
    const double sense = direction(its) == left ? -1.0 : 1.0;
    add_curves(figure.panels[panel], look, r, true, [sense](double x, double y) { return std::array{sense * y, x}; });
    for (const ReferenceReading& reading : its.readings) largest = std::max(largest, std::abs(reading.value));
  }
  if (!first) return {};
  figure.x = y_axis(*first);
  figure.x.from = -1.15 * largest, figure.x.to = 1.15 * largest;
  figure.y = thread_axis(thread_count(c));
  figure.y.label = "Thread";
  figure.columns = std::min<std::size_t>(figure.panels.size(), 2);
  const std::size_t zero = figure.add(kZeroStyle);
  for (Panel& panel : figure.panels) panel.references.push_back({zero, 0.0, true});
  return {std::move(figure)};
}

}  // namespace prs
