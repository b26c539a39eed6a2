#include "prs/sector/refined/nut_shell.h"

#include <algorithm>

#include "prs/indices.h"
#include "prs/model/problems.h"

namespace prs {

std::optional<ThrustRing> thrust_ring(const NutLine& line, const Structure::Nut& nut, const NutBore& bore) {
  const auto thrust = static_cast<std::size_t>(line.thrust);
  const bool at_first = thrust == 0, at_last = thrust == line.outer_radius.size();
  const double before = at_first ? bore.root.front() : line.outer_radius[thrust - 1];
  const double behind = at_last ? bore.root.back() : line.outer_radius[thrust];
  if (before == behind) return {};
  ThrustRing ring{std::min(before, behind), std::max(before, behind)};
  if (nut.shoulder) {
    ring.inner_radius = std::max(ring.inner_radius, 0.5 * nut.shoulder->inner_diameter);
    ring.outer_radius = std::min(ring.outer_radius, 0.5 * nut.shoulder->outer_diameter);
    if (ring.inner_radius >= ring.outer_radius)
      throw CaseError(
          "structure.nut.shoulder",
          fmt::format("misses the face of the nut at the thrust section {:g} mm, which "
                      "reaches from a diameter of {:g} mm to {:g} mm; expected one that "
                      "touches it; fix the diameters",
                      1e3 * line.sections[thrust], 2e3 * std::min(before, behind), 2e3 * std::max(before, behind)));
  }
  return ring;
}

void set_alike_segments(const NutLine& line, const NutBore& bore, std::vector<int>& same) {
  same.clear();
  for (const auto i : indices(line.outer_radius)) {
    const auto alike = [&](std::size_t k) {
      return line.outer_radius[k] == line.outer_radius[i] && bore.root[k] == bore.root[i] &&
             std::abs(line.length(k) - line.length(i)) <= 1e-12 * line.length(i);
    };
    std::size_t k = 0;
    while (k < i && !(same[k] == static_cast<int>(k) && alike(k))) ++k;
    same.push_back(static_cast<int>(k));
  }
}

NutShell nut_shell(const NutShape& shape, const NutNumbers<double>& numbers) {
  std::vector<fe::ShellBlocks<double>> shells(shape.same.size());
  const double arm = set_nut_shells(shape, numbers, shells.data());
  NutShell nut{{}, arm, shape.effects.flange && !shape.has_ring, shape.held_radially()};
  for (const int k : shape.same) nut.segments.push_back(fe::to_matrix(item_at(shells, k)));
  return nut;
}

NutShell nut_shell(const NutLine& line, const std::optional<ThrustRing>& ring, const NutBore& bore, const NutLoad& load,
                   const Material& material, int rollers, const RefinedEffects& effects) {
  std::vector<int> same, contacts = line.contacts;
  set_alike_segments(line, bore, same);
  std::ranges::sort(contacts);
  const ThrustRing edges = ring.value_or(ThrustRing{});
  const NutNumbers<double> numbers{line.sections.data(),
                                   line.outer_radius.data(),
                                   bore.root.data(),
                                   bore.pitch,
                                   edges.inner_radius,
                                   edges.outer_radius,
                                   material.youngs_modulus,
                                   material.poisson_ratio,
                                   static_cast<double>(rollers),
                                   load.sense,
                                   std::cos(load.normal_angle),
                                   std::sin(load.normal_angle)};
  return nut_shell({contacts, line.thrust, same, ring.has_value(), effects}, numbers);
}

}  // namespace prs
