#include "prs/loads/load_case_result.h"

#include "contact/contact_numbers.h"
#include "prs/indices.h"
#include "prs/loads/analyze.h"

namespace prs {

LoadCaseResult::LoadCaseResult() = default;
LoadCaseResult::LoadCaseResult(const LoadCaseResult&) = default;
LoadCaseResult::LoadCaseResult(LoadCaseResult&&) noexcept = default;
LoadCaseResult& LoadCaseResult::operator=(const LoadCaseResult&) = default;
LoadCaseResult& LoadCaseResult::operator=(LoadCaseResult&&) noexcept = default;
LoadCaseResult::~LoadCaseResult() = default;

Result::Result() = default;
Result::Result(const Result&) = default;
Result::Result(Result&&) noexcept = default;
Result& Result::operator=(const Result&) = default;
Result& Result::operator=(Result&&) noexcept = default;
Result::~Result() = default;

namespace {

void add_hertz_contacts(InterfaceLoads& loads, const InterfaceContact& contact, simd::InstructionSet set,
                        const contact::KnownApproach& known) {
  contact::set_ellipses(contact.hertz, loads.normal_load, loads.semi_major, loads.semi_minor, loads.peak_pressure, set,
                        known);
  if (!contact.shear) return;
  for (const double pressure : loads.peak_pressure) {
    loads.max_shear_stress.push_back(contact.shear->shear_over_pressure * pressure);
    loads.max_von_mises_stress.push_back(contact.von_mises->stress_over_pressure * pressure);
  }
  for (const double semi_minor : loads.semi_minor) {
    loads.max_shear_depth.push_back(contact.shear->depth_over_semi_minor * semi_minor);
    loads.max_von_mises_depth.push_back(contact.von_mises->depth_over_semi_minor * semi_minor);
  }
}

/// Sets the numbers of an interface whose normal loads and angle are set.
void set_interface_loads(InterfaceLoads& loads, const LoadCase& load_case, const Contacts& contacts, Interface i,
                         double cosine, simd::InstructionSet set, const LoadDetail& detail = {},
                         const contact::KnownApproach& known = {}) {
  const double roller_force = std::abs(load_case.axial_force) / loaded_rollers(contacts.mechanism);
  const std::size_t threads = loads.normal_load.size();
  loads.axial_load.resize(detail.axial_load ? threads : 0);
  for (const auto k : indices(loads.axial_load)) loads.axial_load[k] = loads.normal_load[k] * cosine;
  loads.load_rate.resize(detail.load_rate ? threads : 0);
  for (const auto k : indices(loads.load_rate)) loads.load_rate[k] = loads.normal_load[k] * cosine / roller_force;
  for (auto* values : {&loads.semi_major, &loads.semi_minor, &loads.peak_pressure, &loads.max_shear_stress,
                       &loads.max_shear_depth, &loads.max_von_mises_stress, &loads.max_von_mises_depth})
    values->clear();
  const InterfaceContact& contact = contacts.interfaces[i];
  if (detail.ellipses && contact.has_hertz()) add_hertz_contacts(loads, contact, set, known);
}

/// Load of each thread if all carry the same by assumption.
double equal_normal_load(const LoadCase& load_case, const Mechanism& m, double psi) {
  const double contacts = static_cast<double>(loaded_rollers(m)) * m.contacts_per_roller;
  return std::abs(load_case.axial_force) / contacts / std::cos(psi);
}

/// Compares the most loaded thread's ellipse with the ends of the flanks.
void warn_of_ellipse_beyond_flank(const InterfaceLoads& loads, const Contacts& contacts, Interface i,
                                  const std::string& path, std::vector<Warning>& warnings) {
  if (loads.semi_major.empty()) return;
  const auto violations =
      contact::ellipse_beyond_flanks(pair_of(contacts.threads, i), contacts.interfaces[i].geometry,
                                     *std::max_element(loads.semi_major.begin(), loads.semi_major.end()),
                                     *std::max_element(loads.semi_minor.begin(), loads.semi_minor.end()));
  constexpr double kUnseen = 1e-7;  // Smallest reported distance: real flanks do not end that sharply [m].
  for (const contact::FlankViolation& v : violations)
    if (v.by > kUnseen)
      warnings.push_back(Warning{
          path,
          fmt::format("{}_ellipse_beyond_{}_of_{}", name(i), contact::name(v.end), v.of_roller ? "roller" : name(i)),
          fmt::format("the largest {} ellipse reaches {{value}} beyond the {} of the {}", label(i),
                      contact::name(v.end), v.of_roller ? "roller" : name(i))}
                             .with(v.by, {}, "mm"_unit));
}

/// Number of contacts of missing rollers.
std::ptrdiff_t missing_contacts(const InterfaceLoads& loads) {
  return loads.rollers ? static_cast<std::ptrdiff_t>(loads.rollers->missing) * loads.threads_per_roller : 0;
}

void warn_of_threads(const PerInterface<InterfaceLoads>& threads, const Contacts& contacts, const std::string& path,
                     std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const auto contacts_of = static_cast<std::ptrdiff_t>(threads[i].normal_load.size());
    const std::ptrdiff_t missing = missing_contacts(threads[i]);
    const auto open = std::count(threads[i].normal_load.begin(), threads[i].normal_load.end(), 0.0) - missing;
    if (open > 0)
      warnings.push_back(Warning{path, fmt::format("{}_contacts_open", name(i)),
                                 fmt::format("{{value}} of {{limit}} {} contacts are open", label(i))}
                             .with(static_cast<double>(open), static_cast<double>(contacts_of - missing)));
    const auto& pressure = threads[i].peak_pressure;
    const auto highest = std::max_element(pressure.begin(), pressure.end());
    if (highest != pressure.end())
      if (auto warning = static_pressure_warning(path, i, *highest, contacts)) warnings.push_back(*std::move(warning));
    warn_of_ellipse_beyond_flank(threads[i], contacts, i, path, warnings);
  }
}

}  // namespace

LoadCaseResult solved_result(const LoadCase& load_case, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                             LoadDistribution d) {
  LoadCaseResult result;
  result.load_case = load_case;
  set_solved_result(result, contacts, {numbers_of(laws.screw), numbers_of(laws.nut)}, d, simd::InstructionSet::scalar);
  return result;
}

void set_solved_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<ContactLawNumbers>& laws,
                       LoadDistribution& d, simd::InstructionSet set, const LoadDetail& detail) {
  if (!result.solve) result.solve.emplace();
  std::swap(*result.solve, d.solve);
  if (!result.solve->converged()) {
    result.axial_displacement = result.axial_stiffness = result.tangent_stiffness = {};
    result.threads.reset();
    result.guides.clear();
    return;
  }
  std::swap(result.guides, d.guides);
  result.tangent_stiffness = d.tangent_stiffness;
  if (d.tangent_stiffness || d.axial_displacement > 0.0) {
    result.axial_displacement = d.axial_displacement;
    result.axial_stiffness = result.load_case.axial_force / d.axial_displacement;
  } else {
    result.axial_displacement = result.axial_stiffness = {};
  }
  if (!result.threads) result.threads.emplace();
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*result.threads)[i];
    std::swap(loads.normal_load, d.normal_load[i]);
    std::swap(loads.approach, d.approach[i]);
    loads.normal_angle = laws[i].normal_angle;
    set_interface_loads(loads, result.load_case, contacts, i, laws[i].cosine, set, detail,
                        {loads.approach, laws[i].cbrt_constant});
    loads.hertz_constant = laws[i].hertz_constant;
  }
}

LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<double>& normal_angle,
                                  const PerInterface<std::optional<double>>& hertz_constant) {
  LoadCaseResult result;
  result.load_case = load_case;
  set_equal_share_result(result, contacts, normal_angle, hertz_constant, simd::InstructionSet::scalar);
  return result;
}

void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<double>& normal_angle,
                            const PerInterface<std::optional<double>>& hertz_constant, simd::InstructionSet set,
                            const LoadDetail& detail) {
  if (!result.threads) result.threads.emplace();
  const auto count = static_cast<std::size_t>(contacts.mechanism.contacts_per_roller);
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*result.threads)[i];
    const double load = equal_normal_load(result.load_case, contacts.mechanism, normal_angle[i]);
    loads.normal_load.assign(count, load);
    loads.normal_angle = normal_angle[i];
    set_interface_loads(loads, result.load_case, contacts, i, std::cos(normal_angle[i]), set, detail);
    loads.hertz_constant = hertz_constant[i];
    if (hertz_constant[i])
      loads.approach.assign(count, std::pow(load / *hertz_constant[i], 2.0 / 3.0));
    else
      loads.approach.clear();
  }
}

LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws) {
  return equal_share_result(load_case, contacts, {laws.screw.normal_angle, laws.nut.normal_angle},
                            {laws.screw.hertz_constant, laws.nut.hertz_constant});
}

LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts) {
  LoadCaseResult result;
  result.load_case = load_case;
  set_equal_share_result(result, contacts, simd::InstructionSet::scalar);
  return result;
}

void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, simd::InstructionSet set,
                            const LoadDetail& detail) {
  PerInterface<double> normal_angle;
  PerInterface<std::optional<double>> hertz_constant;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    normal_angle[i] = contact.normal_angle();
    if (contact.has_hertz()) hertz_constant[i] = contact.hertz.hertz_constant;
  }
  set_equal_share_result(result, contacts, normal_angle, hertz_constant, set, detail);
}

void add_warnings(LoadCaseResult& result, const Contacts& contacts) {
  if (!result.converged() && result.warnings.empty())
    result.warnings.push_back(Warning{"", "not_converged",
                                      fmt::format("not converged: {}, relative residual {:.1e}",
                                                  fe::name(result.solve->status), result.solve->relative_residual)}
                                  .with(result.solve->relative_residual));
  const auto is_open = [&](Interface i) { return std::ranges::max((*result.threads)[i].normal_load) == 0.0; };
  const bool carries = result.threads && !std::ranges::all_of(kInterfaces, is_open);
  if (result.solve && result.converged() && carries && !result.full && !result.tangent_stiffness)
    result.warnings.push_back({"model.refined.poisson", "no_stiffness",
                               "the screw is so much softer than its threads that this effect exceeds all "
                               "deflection, and stiffness is left out",
                               "check `materials.screw.youngs_modulus` or take `poisson: false`"});
  if (result.threads)
    warn_of_threads(*result.threads, contacts, path_in(result.load_case, "axial_force"), result.warnings);
}

std::optional<Warning> static_pressure_warning(std::string path, Interface i, double pressure,
                                               const Contacts& contacts) {
  const std::optional<double>& limit = contacts.interfaces[i].pressure_limit;
  if (!limit || pressure <= *limit) return std::nullopt;
  return Warning{std::move(path), fmt::format("{}_peak_pressure", name(i)),
                 fmt::format("{} peak pressure {{value}} exceeds {{limit}}", label(i))}
      .with(pressure, *limit, "GPa"_unit);
}

std::optional<Warning> running_pressure_warning(std::string path, Interface i, double pressure,
                                                const Contacts& contacts) {
  const std::optional<double>& limit = contacts.interfaces[i].pressure_limit;
  if (!limit || pressure <= kRunningPressureLimit || pressure > *limit) return std::nullopt;
  return Warning{std::move(path), fmt::format("{}_running_pressure", name(i)),
                 fmt::format("{} peak pressure {{value}} is above {{{:g} GPa}}, much for flanks that run "
                             "({{limit}} is the limit at rest)",
                             label(i), kRunningPressureLimit * "GPa"_per_si),
                 "lower the load or take more contacts"}
      .with(pressure, *limit, "GPa"_unit);
}

}  // namespace prs
