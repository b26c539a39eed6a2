#include "prs/preload/preload_analysis.h"

#include "prs/loads/load_json.h"
#include "prs/preload/preload_record.h"
#include "prs/preload/preload_table.h"

namespace prs {

Figures preload_curves(const PreloadResult& result);

namespace {

std::vector<Headline> lost_motion(const PreloadResult& r) {
  if (!r.curve.lost_motion) return {};
  return {{"Lost motion", "lost_motion_um", *r.curve.lost_motion}};
}

}  // namespace

const Analysis<PreloadResult>& preload_analysis() {
  static const std::vector<Place> places = with_contacts({{"preload", describe<PreloadResult>}});
  static const Analysis<PreloadResult> analysis{
      .command = Command::preload,
      .help = "Preload: curve through zero, lost motion, opening loads",
      .file = "preload.json",
      .run = [](const input::Source&,
                const input::CaseInput& in) { return analyze_preload(in.values); },
      .places = places,
      .put =
          [](nlohmann::ordered_json& document, const PreloadResult& r) {
            put_contacts(document, r.contacts);
            document["preload"] = object_of(r);
          },
      .table = preload_table,
      .files =
          [](const PreloadResult& r, const CsvStyle& style) {
            return std::vector<OutputFile>{{"preload.csv", preload_csv(r, style)}};
          },
      .pictures = [](const PreloadResult& r, const Case&) -> Pictures {
        return {{"preload", "an equilibrium without external load", of_result(r, preload_curves)}};
      },
      .converged = [](const PreloadResult& r) { return r.converged(); },
      .headlines = lost_motion,
      .place = {"Preload", 3}};
  return analysis;
}

}  // namespace prs
