#include "validation/extensions.h"

#include "validation/reference_fe/comparison.h"
#include "validation/reference_fe/figures.h"
#include "validation/reference_fe/statements.h"
#include "validation/reference_fe/tables.h"

namespace prs::reference_fe {
namespace {

Supplement compared(const Case& screw, const std::filesystem::path& folder) {
  using enum ModelOptions::Bodies;
  const std::vector<Curve> reference = read_curves(folder / "data" / "curves.csv");
  const auto curves = [&](ModelOptions::Bodies bodies) {
    return computed_curves(screw, bodies, reference);
  };
  const Fidelities f{reference, curves(bars), curves(refined), curves(influence)};
  const std::vector<Model> models{
      {"bars", f.bars}, {"refined", f.refined}, {"influence", f.influence}};
  Supplement supplement{compare_statements(f), tables(models, reference),
                        load_rate_figures(models, reference, kReferenceError),
                        files(models, reference)};
  for (Figure& figure : displacement_figures(models, reference, kReferenceError))
    supplement.figures.push_back(std::move(figure));
  return supplement;
}

}  // namespace

SourceExtension extension() { return {.folder = "reference_fe", .supplement = compared}; }

}  // namespace prs::reference_fe
