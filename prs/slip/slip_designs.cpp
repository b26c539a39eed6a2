#include "prs/slip/slip_designs.h"

#include "simd/dispatch.h"

namespace prs {

void SlipDesignSolver::add(const SlipModel& model) {
  SlipNumbers<double>& screw = screws_.emplace_back();
  screw.roller = model;
  screw.residue_unit = residue_unit(model);
  for (const Interface i : kInterfaces) {
    const LoadedThreads::Contact& c = model.threads[i].contacts.front();
    screw.contacts[i] = {c.axial_load,         model.threads[i].alike,  c.ellipse.semi_major,
                         c.ellipse.semi_minor, c.ellipse.peak_pressure, c.friction};
  }
  tasks_.push_back({SlipSearch(slip_range(model.geometry), model.speed, model.imposed_slip_ratio), {}});
}

void SlipDesignSolver::solve(const contact::PatchGrid& grid) {
  const auto domes = static_cast<std::size_t>(grid.domes().size());
  viscosity_ratio_.assign(2 * domes * screws_.size(), 0.0);
  double* ratio = viscosity_ratio_.data();
  for (const SlipNumbers<double>& screw : screws_)
    for (const Interface i : kInterfaces) {
      const SharedContactNumbers<double>& c = screw.contacts[i];
      if (c.friction.has_film()) contact::set_viscosity_ratios(grid, c.friction.oil.viscosity, c.peak_pressure, ratio);
      ratio += domes;
    }
  memory_.resize(2 * domes * simd::kWidest);
  SharedPoints shared{grid.points(), grid.dome_of_point(), domes, grid.cell_load()};
  shared.points.size = static_cast<std::size_t>(grid.inside());
  simd::run_kernel(set_, SlipKernel{}, shared, std::span<const SlipNumbers<double>>(screws_), viscosity_ratio_.data(),
                   std::span<SlipTask>(tasks_), memory_.data());
}

void SlipDesignSolver::get(std::size_t k, SlipEquilibrium& found) const {
  const SlipTask& task = tasks_[k];
  found.status = task.search.status();
  found.evaluations = task.search.evaluations();
  found.balance.RollerBalance::operator=(task.balance.roller);
  for (const Interface i : kInterfaces) {
    PatchBalance& b = found.balance.patches[i];
    const contact::PatchFriction& friction = task.balance.friction[i];
    const double normal_load = task.balance.normal_load[i];
    b.friction.assign(1, friction);
    b.normal_load.assign(1, normal_load);
    b.power = screws_[k].contacts[i].alike * normal_load * friction.power_per_load;
  }
}

}  // namespace prs
