#include "prs/compare/compare_models.h"

#include "modules/module.h"
#include "prs/bodies/body_models.h"
#include "prs/bodies/body_solver.h"
#include "prs/loads/analyze.h"
#include "prs/model/check_case.h"

namespace prs {
namespace {

using Bodies = ModelOptions::Bodies;

/// The case with another model of the bodies, which has the roller's shear anyway.
Case with_bodies(Case c, Bodies bodies) {
  if (c.model.bodies != bodies) c.model.roller_shear = false;
  c.model.bodies = bodies;
  return c;
}

/// One sector in place of all rollers, under the axial force alone: inputs of a full mechanism only are left out.
Case as_sector(Case c) {
  c.model.mechanism = ModelOptions::Mechanism::sector;
  c.model.contact_phase = ModelOptions::ContactPhase::equal;
  c.model.roller_shear = c.model.roller_shear || c.model.shear;
  c.model.shear = false;
  Deviations& d = c.deviations;
  d.roller_diameters.clear();
  d.roller_position = {};
  d.missing_rollers.clear();
  d.index_error = {};
  d.thread_eccentricity = {};
  d.turning = {};
  d.pitch_error.roller.lists.clear();
  c.structure->screw.far_length = 0.0;
  c.structure->screw.bearings.clear();
  c.structure->screw.drive.reset();
  c.structure->masses.clear();
  c.structure->roller.rings = {};
  c.structure->nut.housing = {};
  for (LoadCase& load : c.load_cases) {
    load.spatial = {};
    load.travel.reset();
    load.modes.reset();
  }
  if (c.life) c.life->load_case.reset();
  return c;
}

/// Whether this model takes no longer than the others.
bool is_at_hand(const Case& c) {
  const BodySolver& solver = body_solver(c);
  if (!solver.is_at_hand) return true;
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const PerInterface<ContactLaw> laws = contact_laws(c, contacts);
  std::set<std::pair<Direction, double>> sectors;
  for (const LoadCase& load : c.load_cases) sectors.emplace(*load.direction, *load.position);
  for (const auto& [direction, position] : sectors)
    if (!solver.is_at_hand({{c, contacts, laws}, direction, position})) return false;
  return true;
}

void require_sound(const Case& c) {
  for (const Problem& problem : check_case(c)) throw CaseError(problem);
}

/// Compares all models of the bodies that are at hand.
ModelComparison compare_bodies(const Case& c) {
  ModelComparison comparison;
  for (const auto& row : kBodyModels) {
    const Bodies bodies = &row.model;
    const bool stated = bodies == c.model.bodies;
    const Case variant = with_bodies(c, bodies);
    try {
      if (!stated) require_sound(variant);
      if (!stated && !is_at_hand(variant)) continue;
      comparison.models.push_back(analyze(variant));
      if (stated) comparison.stated = comparison.models.size() - 1;
    } catch (const CaseError& error) {
      if (stated) throw;
      if (!bodies->meshes)
        comparison.warnings.push_back({error.path(), fmt::format("without_{}", bodies->name),
                                       fmt::format("without `bodies: {}`: {}", bodies->name, error.what())});
    } catch (const modules::NotBuilt& error) {
      if (stated) throw;
      comparison.warnings.push_back({"", fmt::format("without_{}", bodies->name), error.what()});
    }
  }
  return comparison;
}

}  // namespace

ModelComparison compare_models(const Case& c) {
  Case solved = c;
  std::erase_if(solved.load_cases, [](const LoadCase& load) { return load.share == LoadCase::Share::equal; });
  ModelComparison comparison;
  if (c.model.all_rollers())
    comparison.models = {analyze(as_sector(solved)), analyze(solved)}, comparison.stated = 1;
  else
    comparison = compare_bodies(solved);
  const std::vector<Warning>& geometry = comparison.best().warnings;
  comparison.warnings.insert(comparison.warnings.begin(), geometry.begin(), geometry.end());
  return comparison;
}

Case case_of(const Case& c, const Result& model) {
  return c.model.mechanism == model.model.mechanism ? with_bodies(c, model.model.bodies) : as_sector(c);
}

}  // namespace prs
