#include "prs/study/design_batches.h"

#include "prs/indices.h"

namespace prs {
namespace {

/// Element k of memory that grows.
template <class T>
T& at(std::vector<T>& values, std::size_t k) {
  if (values.size() <= k) values.resize(k + 1);
  return values[k];
}

}  // namespace

std::optional<std::size_t> SharedContacts::add(const Mechanism& mechanism, const std::optional<Materials>& materials) {
  if (mechanism.geometry != Mechanism::Geometry::simulation) return std::nullopt;
  const std::size_t k = found_.size();
  Entry& entry = at(entries_, k);
  entry.mechanism = mechanism;
  entry.threads = threads_of(mechanism);
  found_.add(entry.threads, materials);
  return k;
}

bool SharedContacts::get(std::optional<std::size_t> k, ContactDetail detail, Contacts& contacts) const {
  return k && found_.get(*k, entries_[*k].mechanism, entries_[*k].threads, detail, contacts);
}

bool BarBatch::takes(const Case& c, std::span<const std::size_t> load_cases) {
  using Compliance = ModelOptions::ToothCompliance::Kind;
  const bool plain = c.model.side_by_side() && !c.model.bodies->effects &&
                     c.model.tooth_compliance.kind == Compliance::none && c.structure && c.materials &&
                     c.structure->roller.guidance.clearance == 0.0;
  return plain && std::ranges::all_of(load_cases, [&](std::size_t k) {
           if (k >= c.load_cases.size()) return false;
           const LoadCase& load = c.load_cases[k];
           return load.share == LoadCase::Share::solved && load.direction && load.position;
         });
}

void BarBatch::clear(ContactDetail detail) {
  detail_ = detail;
  used_offsets_ = 0;
  contacts_.clear();
  designs_.clear();
  forces_.clear();
  positions_.clear();
  directions_.clear();
}

void BarBatch::add(std::size_t row, const Case& c, const Mechanism& mechanism,
                   std::span<const std::size_t> load_cases) {
  load_cases_ = load_cases.size();
  const std::size_t first = forces_.size();
  designs_.push_back({row, contacts_.size(), first, mechanism, threads_of(mechanism), c.contact, {}, {}, true});
  contacts_.add(designs_.back().threads, c.materials);
  if (deviates(mechanism, c.deviations)) {
    if (offsets_.size() <= used_offsets_) offsets_.emplace_back();
    offsets_[used_offsets_] = {c.deviations, *c.materials};
    designs_.back().offsets = used_offsets_++;
  }
  if (sectors_.size() < first + load_cases_) sectors_.resize(first + load_cases_);
  for (const auto i : up_to(load_cases_)) {
    const LoadCase& load = c.load_cases[load_cases[i]];
    const auto is_on_same_sector = [&](std::size_t k) {
      const LoadCase& other = c.load_cases[k];
      return other.direction == load.direction && other.position == load.position;
    };
    const std::span<const std::size_t> before = load_cases.first(i);
    const auto same = std::ranges::find_if(before, is_on_same_sector);
    if (same != before.end())
      sectors_[first + i] = sectors_[first + static_cast<std::size_t>(same - before.begin())];
    else
      set_sector_model(sectors_[first + i], mechanism, *c.structure, *c.materials, c.model, {}, *load.direction,
                       *load.position, {});
    forces_.push_back(load.axial_force);
    positions_.push_back(*load.position);
    directions_.push_back(*load.direction);
  }
}

/// Designs without contacts have no sectors any more.
void BarBatch::set_laws() {
  contacts_.find();
  std::size_t next = 0;
  for (Design& design : designs_) {
    design.has_contacts = contacts_.get_laws(design.contacts, found_);
    if (!design.has_contacts) continue;
    design.laws = contacts_.laws(design.contacts);
    for (const Interface i : kInterfaces)
      if (design.overrides.hertz_constant[i] || design.overrides.normal_angle[i])
        design.laws[i] = numbers_of(contact_law(design.overrides, found_.interfaces[i], i));
    for (const auto i : up_to(load_cases_)) {
      const std::size_t from = design.first_sector + i, to = next + i;
      if (from != to) std::swap(sectors_[from], sectors_[to]);
      forces_[to] = forces_[from];
      positions_[to] = positions_[from];
      directions_[to] = directions_[from];
      prs::set_laws(sectors_[to], design.laws);
    }
    design.first_sector = next;
    if (design.offsets) set_gaps(design);
    next += load_cases_;
  }
  forces_.resize(next);
  positions_.resize(next);
  directions_.resize(next);
}

void BarBatch::set_gaps(const Design& design) {
  const auto& [deviations, materials] = offsets_[*design.offsets];
  for (const auto i : up_to(load_cases_))
    sectors_[design.first_sector + i].gaps = initial_gaps(
        design.mechanism, deviations, materials, {design.laws.screw.normal_angle, design.laws.nut.normal_angle},
        directions_[design.first_sector + i]);
}

bool BarBatch::set_results(const Design& design, const LoadDetail& detail) {
  if (!design.has_contacts) return false;
  if (detail_ == ContactDetail::laws) {
    contacts_.get_laws(design.contacts, found_);
    found_.mechanism.type = design.mechanism.type;
    found_.mechanism.rollers = design.mechanism.rollers;
    found_.mechanism.rollers_unloaded = design.mechanism.rollers_unloaded;
  } else if (!contacts_.get(design.contacts, design.mechanism, design.threads, detail_, found_)) {
    return false;
  }
  results_.resize(load_cases_);
  for (const auto i : up_to(load_cases_)) {
    const std::size_t k = design.first_sector + i;
    if (!FallbackSolver::complete(loads_[k], detail.tangent_stiffness)) return false;
    results_[i].load_case.axial_force = forces_[k];
    results_[i].load_case.position = positions_[k];
    set_solved_result(results_[i], found_, design.laws, loads_[k], set_, detail);
  }
  return true;
}

void SectorBatch::add(std::size_t row, Case& c, const std::vector<std::size_t>& load_cases, bool is_measured,
                      Detail detail) {
  Design& design = at(designs_, used_);
  design.row = row;
  if (is_measured) {
    design.conditions = c;
  } else {
    design.conditions.structure = c.structure;
    design.conditions.materials = c.materials;
    design.conditions.deviations = c.deviations;
    design.conditions.contact = c.contact;
    design.conditions.model = c.model;
  }
  const auto missing = [&](std::size_t k) { return k >= c.load_cases.size(); };
  const auto known = std::ranges::find_if(load_cases, missing) - load_cases.begin();
  design.load_cases.resize(static_cast<std::size_t>(known));
  for (const auto i : indices(design.load_cases)) design.load_cases[i].load_case = c.load_cases[load_cases[i]];
  design.shared.reset();
  if (detail == Detail::numbers) design.shared = contacts_.add(c.mechanism, c.materials);
  if (!design.shared) design.contacts = checked_contacts(c, detail);
  ++used_;
}

/// Adds the sectors of a design whose contacts are found. False if one of them has no place
/// among the columns.
bool SectorBatch::add_sectors(std::size_t k) {
  Design& design = designs_[k];
  const Conditions& c = design.conditions;
  design.laws = contact_laws(c, design.contacts);
  const auto first = static_cast<std::ptrdiff_t>(sectors_.size());
  for (const auto i : indices(design.load_cases)) {
    LoadCaseResult& result = design.load_cases[i];
    const LoadCase& load = result.load_case;
    if (load.share == LoadCase::Share::equal) {
      result = equal_share_result(load, design.contacts, design.laws);
      continue;
    }
    const auto is_on_same_sector = [&](const Sector& sector) {
      const LoadCase& other = design.load_cases[sector.load_case].load_case;
      return other.direction == load.direction && other.position == load.position;
    };
    SectorModel& model = at(models_, sectors_.size());
    const auto known = std::find_if(sectors_.begin() + first, sectors_.end(), is_on_same_sector);
    if (known != sectors_.end())
      model = item_at(models_, known - sectors_.begin());
    else
      set_sector_model(model, design.contacts.mechanism, *c.structure, *c.materials, c.model, design.laws,
                       *load.direction, *load.position, c.deviations);
    if (model.has_loose_guides() || (model.is_refined && !RefinedDesignSolver::takes(model))) return false;
    forces_.push_back(load.axial_force);
    sectors_.push_back({k, i});
  }
  return true;
}

void SectorBatch::prepare(std::size_t k, ContactDetail detail) {
  Design& design = designs_[k];
  const std::size_t waiting = sectors_.size();
  design.complete = !design.shared || contacts_.get(design.shared, detail, design.contacts);
  try {
    design.complete = design.complete && add_sectors(k);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // A separate evaluation gives the reason.
    design.complete = false;
  }
  if (design.complete) return;
  sectors_.resize(waiting);
  forces_.resize(waiting);
}

void SectorBatch::solve_sectors(ContactDetail detail, bool tangent_stiffness) {
  contacts_.find();
  sectors_.clear();
  forces_.clear();
  for (const auto k : up_to(used_)) prepare(k, detail);
  const std::size_t count = sectors_.size();
  if (loads_.size() < count) loads_.resize(count);
  const std::span<const SectorModel> models(models_.data(), count);
  const std::span<LoadDistribution> loads(loads_.data(), count);
  bars_.tangent_stiffness = refined_.tangent_stiffness = tangent_stiffness;
  bars_.solve(models, forces_, loads);
  refined_.solve(models, forces_, loads);
  for (const auto k : up_to(count)) {
    Design& design = designs_[sectors_[k].design];
    design.complete = design.complete && FallbackSolver::complete(loads_[k], tangent_stiffness);
    set_solved_result(design.load_cases[sectors_[k].load_case], design.contacts,
                      {numbers_of(design.laws.screw), numbers_of(design.laws.nut)}, loads_[k], set_);
  }
}

bool SlipBatch::takes(const Case& c, std::span<const std::size_t> load_cases) const {
  return c.materials && !c.heat && !contact::is_grooved(c.mechanism.type) &&
         (designs_.empty() || c.model.patch_points == patch_points_) &&
         std::ranges::all_of(load_cases, [&](std::size_t k) {
           return k < c.load_cases.size() && c.load_cases[k].share == LoadCase::Share::equal &&
                  screw_speed(c, c.load_cases[k]) != 0.0;
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
  for (const auto d : indices(designs_)) {
    Design& design = designs_[d];
    design.is_sound =
        contacts_.get(d, design.mechanism, design.threads, ContactDetail::laws, found_) && rolls(design.mechanism);
    const std::span<SlipModel> models(models_.data() + d * load_cases_, load_cases_);
    for (SlipModel& model : models) {
      if (!design.is_sound) break;
      set_geometry(model, found_);
      set_equal_contacts(model, found_);
    }
    if (!design.is_sound) continue;
    design.first_task = tasks;
    for (const SlipModel& model : models) solver_.add(model);
    tasks += models.size();
  }
  if (tasks > 0) solver_.solve(*grid_of(patch_points_));
}

bool SlipBatch::set_results(const Design& design, const LoadDetail& loads, const SlipDetail& slips) {
  if (!design.is_sound) return false;
  const auto d = static_cast<std::size_t>(&design - designs_.data());
  contacts_.get(d, design.mechanism, design.threads, detail_, found_);
  results_.resize(load_cases_);
  for (const auto i : up_to(load_cases_)) {
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
