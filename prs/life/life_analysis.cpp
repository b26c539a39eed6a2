#include "prs/life/life_analysis.h"

#include <algorithm>

#include "prs/input/force_history.h"
#include "prs/life/life_record.h"
#include "prs/life/life_table.h"
#include "prs/loads/load_json.h"
#include "prs/model/void_inputs.h"

namespace prs {

Figures load_history(const LifeResult& result);
Figures rainflow(const LifeResult& result);
Figures thread_loads(const LifeResult& result);
Figures thread_lives(const LifeResult& result);

namespace {

std::vector<OutputFile> life_files(const LifeResult& result, const CsvStyle& style) {
  std::vector<OutputFile> files = {{"life_threads.csv", life_threads_csv(result, style)}};
  const bool of_rollers = std::ranges::any_of(kDirections, [&](Direction d) {
    return result.flanks[d] && result.flanks[d]->threads.screw.rollers;
  });
  if (of_rollers) files.push_back({"life_rollers.csv", life_rollers_csv(result, style)});
  if (result.cycles) {
    files.push_back({"cycles.csv", cycles_csv(*result.cycles, style)});
    files.push_back({"cycle_matrix.csv", cycle_matrix_csv(result.cycles->matrix, style)});
  }
  return files;
}

constexpr const char* kLives = "a load history or spectrum under which loads converge";

/// Of a stated capacity, which is of real screws, the catalogue's life is the headline.
PageSection section(const LifeResult& r) {
  const bool solved = r.life.share == LoadCase::Share::solved, stated = !r.lemor;
  const std::vector<std::string> lives =
      r.rated_over_l10() == 1.0
          ? std::vector<std::string>{"l10_revolutions", "l10_hours", "l10_travel_km", "l10_passes"}
          : std::vector<std::string>{"rated_revolutions", "rated_hours", "rated_travel_km",
                                     "rated_passes"};
  PageSection page{.in_document = {{"life",
                                    {"status", "share", "reliability_factor", "modification_factor",
                                     "static_safety", "static_safety_limit"}}},
                   .folded = {"thread_lives"}};
  if (stated) page.in_document.push_back({"life.catalogue", lives});
  page.in_document.push_back({"life.system", lives});
  page.in_document.push_back(
      {"life.weakest_thread",
       {"direction", "interface", "part", "roller", "thread", "equivalent_load_N"}});
  if (solved) page.estimates = {"equal_shares"};
  if (solved && !stated) page.estimates.emplace_back("catalogue");
  if (solved && stated) page.note = kStatedCapacityNote;
  return page;
}

constexpr std::string_view kResponses[] = {
    "life.system.l10_revolutions", "life.catalogue.l10_revolutions",
    "life.weakest_thread.equivalent_load_N", "life.capacity.dynamic_capacity_N",
    "life.static_safety"};

}  // namespace

LifeResult life_of(const input::Source& source, const input::CaseInput& in) {
  std::optional<LoadHistory> history;
  if (in.values.life->history)
    history = input::read_force_history(*in.values.life->history, source);
  return analyze_life(in.values, std::move(history));
}

const Analysis<LifeResult>& life_analysis() {
  static const std::vector<Place> places = with_contacts({{"life", describe<LifeResult>}});
  static const Analysis<LifeResult> analysis{
      .command = Command::life,
      .help = "Life under a load history or spectrum, static safety",
      .file = "life.json",
      .run =
          [](const input::Source& source, const input::CaseInput& in) {
            LifeResult result = life_of(source, in);
            add_heat_note(in.values, result.warnings);
            return result;
          },
      .places = places,
      .put =
          [](nlohmann::ordered_json& document, const LifeResult& r) {
            put_contacts(document, r.contacts);
            document["life"] = object_of(r);
          },
      .table = life_table,
      .full_table = full_life_table,
      .files = life_files,
      .pictures = [](const LifeResult& r, const Case&) -> Pictures {
        return {{"loads", "a load history or spectrum", of_result(r, load_history)},
                {"rainflow", "a load history, not a spectrum, with cycles", of_result(r, rainflow)},
                {"thread_loads", kLives, of_result(r, thread_loads)},
                {"thread_lives", kLives, of_result(r, thread_lives)}};
      },
      .converged = [](const LifeResult& r) { return r.converged(); },
      .place = {"Life", 1},
      .section = section,
      .responses = kResponses};
  return analysis;
}

}  // namespace prs
