#include "prs/study/slip_batch.h"

#include <algorithm>

#include "prs/threads/threads.h"

namespace prs {

bool SlipBatch::takes(const Case& c, std::span<const std::size_t> load_cases) const {
  return c.materials && !c.heat && (designs_.empty() || c.model.patch_points == patch_points_) &&
         std::ranges::all_of(load_cases, [&](std::size_t k) {
           return k < c.load_cases.size() && c.load_cases[k].share == LoadCase::Share::equal;
         });
}

void SlipBatch::clear(ContactDetail detail) {
  detail_ = detail;
  contacts_.clear();
  designs_.clear();
  forces_.clear();
}

void SlipBatch::add(std::size_t row, const Case& c, const Mechanism& mechanism,
                    std::span<const std::size_t> load_cases) {
  patch_points_ = c.model.patch_points;
  load_cases_ = load_cases.size();
  designs_.push_back({row, mechanism, threads_of(mechanism)});
  contacts_.add(designs_.back().threads, c.materials);
  const Oils oils = oils_in_operation(c);
  for (const std::size_t k : load_cases) {
    const LoadCase& load = c.load_cases[k];
    if (models_.size() <= forces_.size()) models_.emplace_back();
    set_conditions(models_[forces_.size()], c, mechanism, load, oils);
    forces_.push_back(load.axial_force);
  }
}

void SlipBatch::find() {
  contacts_.find();
  solver_.clear();
  std::size_t tasks = 0;
  for (std::size_t d = 0; d < designs_.size(); ++d) {
    Design& design = designs_[d];
    design.is_sound =
        contacts_.get(d, design.mechanism, design.threads, ContactDetail::laws, found_) &&
        rolls(design.threads);
    const std::span<SlipModel> models(models_.data() + d * load_cases_, load_cases_);
    for (SlipModel& model : models) {
      if (!design.is_sound) break;
      set_geometry(model, found_);
      set_equal_contacts(model, found_);
      design.is_sound = is_admissible(model);
    }
    if (!design.is_sound) continue;
    design.first_task = tasks;
    for (const SlipModel& model : models) solver_.add(model);
    tasks += models.size();
  }
  if (tasks > 0) solver_.solve(*grid_of(patch_points_));
}

bool SlipBatch::set_results(const Design& design, const LoadDetail& loads,
                            const SlipDetail& slips) {
  if (!design.is_sound) return false;
  const auto d = static_cast<std::size_t>(&design - designs_.data());
  contacts_.get(d, design.mechanism, design.threads, detail_, found_);
  results_.resize(load_cases_);
  for (std::size_t i = 0; i < load_cases_; ++i) {
    const std::size_t k = d * load_cases_ + i;
    solver_.get(design.first_task + i, equilibrium_);
    if (!equilibrium_.ok()) return false;
    LoadCaseResult& result = results_[i];
    result.load_case.axial_force = forces_[k];
    result.load_case.share = LoadCase::Share::equal;
    set_equal_share_result(result, found_, set_, loads);
    if (!result.slip) result.slip.emplace();
    set_slip_result(*result.slip, models_[k], equilibrium_, slips);
  }
  return true;
}

}  // namespace prs
