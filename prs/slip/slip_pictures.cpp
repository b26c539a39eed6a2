#include "prs/slip/slip_pictures.h"

#include "prs/indices.h"

namespace prs {
namespace {

ResidueCurve residue_curve(const SlipModel& model, double from, double to) {
  constexpr int kPoints = 121;
  ResidueCurve curve;
  SlipBalance balance;
  for (int k = 0; k < kPoints; ++k) {
    const double slip_ratio = from + (to - from) * k / (kPoints - 1);
    if (!balance_at(model, slip_ratio, balance)) continue;
    curve.slip_ratio.push_back(slip_ratio);
    curve.moments.push_back(balance.moments);
  }
  return curve;
}

std::vector<double> numbers(const Eigen::ArrayXd& values) { return {values.data(), values.data() + values.size()}; }

PatchField patch_field(const contact::PatchGrid& grid, const contact::Patch& patch, const contact::PatchMotion& motion,
                       int points_along_axis) {
  const contact::HertzContact& e = patch.ellipse();
  return {e.semi_major,
          e.semi_minor,
          points_along_axis,
          numbers(e.semi_major * grid.along_major()),
          numbers(e.semi_minor * grid.along_minor()),
          numbers(patch.sliding_major(motion)),
          numbers(patch.sliding_minor(motion)),
          numbers(patch.friction_coefficient(motion))};
}

}  // namespace

std::optional<PerInterface<PatchField>> thread_patches(const Conditions& c, const Result& result, std::size_t load_case,
                                                       std::size_t thread) {
  const LoadCaseResult& loaded = result.load_cases[load_case];
  const SlipModels models(c, result.contacts, oils_of(c, loaded));
  const SlipModel model = models.of_nut_that_carries(loaded);
  SlipBalance balance;
  balance_at(model, loaded.slip->of_nut_that_carries(loaded.load_case).slip_ratio, balance);
  PerInterface<PatchField> fields;
  for (const Interface i : kInterfaces) {
    const std::optional<std::size_t> patch = model.threads[i].patch_of_thread[thread];
    if (!patch) return std::nullopt;
    fields[i] = patch_field(models.grid(), model.threads[i].patches[*patch], balance.sliding[i], c.model.patch_points);
  }
  return fields;
}

SlipPictures slip_pictures(const Conditions& c, const Result& result, std::size_t load_case) {
  const LoadCaseResult& loaded = result.load_cases[load_case];
  const SlipModels models(c, result.contacts, oils_of(c, loaded));
  const SlipModel model = models.of_nut_that_carries(loaded);
  const double found = loaded.slip->of_nut_that_carries(loaded.load_case).slip_ratio;
  const SlipRange range = slip_range(model.geometry);
  // Far enough to both sides of the ideal slip ratio to show where the moment changes sign.
  const double reach = std::min({std::max(2.0 * std::abs(found - range.ideal), 1e-4), range.ideal, 1.0 - range.ideal});
  SlipPictures pictures;
  pictures.residue = residue_curve(model, range.pure_sliding, range.ideal);
  pictures.residue_near_root = residue_curve(model, range.ideal - reach, range.ideal + reach);
  SlipBalance balance;
  balance_at(model, found, balance);
  if (model.threads.screw.patches.empty() || model.threads.nut.patches.empty()) return pictures;
  pictures.most_loaded_thread.emplace();
  for (const Interface i : kInterfaces) {
    const LoadedThreads& threads = model.threads[i];
    const auto most =
        std::ranges::max_element(threads.contacts, {}, &LoadedThreads::Contact::axial_load) - threads.contacts.begin();
    (*pictures.most_loaded_thread)[i] =
        patch_field(models.grid(), item_at(threads.patches, most), balance.sliding[i], c.model.patch_points);
  }
  return pictures;
}

}  // namespace prs
