#include "prs/preload/preload_sector.h"

#include <cassert>

#include "prs/sector/running_sector.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

using fe::Dof;

fe::SpringElement& spring_of(PreloadSector& s, int k) {
  return s.model.springs[static_cast<std::size_t>(k)];
}

/// How a nut is held: the section, and the sense of the external load that rests on it.
struct Held {
  Direction sense;
  double section;
};

/// The sector whose contacts lie on the flanks of one direction, its nut as it is held.
Sector sector_of(const PreloadParts& p, Structure structure, Direction flanks, const Held& held,
                 double position) {
  const auto built = [&](Direction direction) {
    (direction == Direction::tension ? structure.nut.thrust.tension
                                     : structure.nut.thrust.compression) = held.section;
    return build_sector(p.mechanism, structure, p.materials, p.options, p.laws, direction, position,
                        p.deviations);
  };
  Sector sector = built(held.sense);
  if (flanks == held.sense) return sector;
  Sector other = built(flanks);
  assert(sector.model.nodes == other.model.nodes && sector.screw_nodes == other.screw_nodes &&
         sector.roller_nodes == other.roller_nodes && sector.nut_nodes == other.nut_nodes);
  // The radius that the nut's nodes belong to depends on how it is held.
  for (int k = 0; k < other.contacts(); ++k) {
    const auto spring = static_cast<std::size_t>(other.spring(Interface::nut, k));
    other.model.springs[spring].to = sector.model.springs[spring].to;
  }
  other.model.bars = sector.model.bars;
  other.model.shells = sector.model.shells;
  return other;
}

std::vector<int> screw_nodes(const Sector& s) {
  std::vector<int> nodes = s.screw_nodes;
  nodes.push_back(s.loaded_node);
  return nodes;
}

/// The side of a sector whose springs stand `first_spring` further on in the joint model.
Side side_of(const Sector& s, int first_spring) {
  Side side;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) side.springs[i].push_back(first_spring + s.spring(i, k));
  side.roller_nodes = s.roller_nodes;
  side.roller_nodes.insert(side.roller_nodes.end(), s.roller_end_nodes.begin(),
                           s.roller_end_nodes.end());
  return side;
}

/// A flank whose nodes `number` maps to those of the whole.
template <class Number>
PreloadSector::Flank flank_of(const Sector& s, Number number) {
  PreloadSector::Flank flank{std::make_shared<const Sector>(s), {}};
  for (int node = 0; node < s.model.nodes; ++node) flank.node.push_back(number(node));
  return flank;
}

PreloadSector single_nut(const PreloadParts& p, const Held& held) {
  Sector pulled = sector_of(p, p.structure, Direction::tension, held, p.preload.position);
  const Sector pushed = sector_of(p, p.structure, Direction::compression, held, p.preload.position);

  PreloadSector s;
  s.flanks = {flank_of(pulled, std::identity{}), flank_of(pushed, std::identity{})};
  s.sides.tension = side_of(pulled, 0);
  s.sides.compression = side_of(pushed, static_cast<int>(pulled.model.springs.size()));
  s.screw_nodes = screw_nodes(pulled);
  s.loaded_node = pulled.loaded_node;
  s.model = std::move(pulled.model);
  s.model.springs.insert(s.model.springs.end(), pushed.model.springs.begin(),
                         pushed.model.springs.end());
  return s;
}

/// The node at an end of the nut, reached over its bars or shells from a contact.
int nut_end(const Sector& s, int node, bool far) {
  const auto next = [&](const auto& elements, int from) {
    for (const auto& e : elements)
      if ((far ? e.first : e.second) == from) return far ? e.second : e.first;
    return -1;
  };
  for (int reached = node; reached >= 0;) {
    node = reached;
    reached = std::max(next(s.model.bars, node), next(s.model.shells, node));
  }
  return node;
}

/// Adds a model whose nodes `number` maps to those of the whole.
template <class Number>
void append(fe::Model& whole, const fe::Model& part, Number number) {
  for (const fe::BarElement& e : part.bars)
    whole.bars.push_back({number(e.first), number(e.second), e.bar});
  for (const fe::BeamElement& e : part.beams)
    whole.beams.push_back({number(e.first), number(e.second), e.beam});
  for (const fe::ShellElement& e : part.shells)
    whole.shells.push_back({number(e.first), number(e.second), e.stiffness});
  for (fe::SpringElement e : part.springs) {
    e.from.node = number(e.from.node);
    e.to.node = number(e.to.node);
    whole.springs.push_back(e);
  }
  for (const fe::ElasticSupport& s : part.elastic_supports)
    whole.elastic_supports.push_back({number(s.node), s.dof, s.stiffness});
  for (const fe::FixedSupport& s : part.fixed_supports)
    whole.fixed_supports.push_back({number(s.node), s.dof});
}

/// The second nut, held by nothing, on a screw that starts at the last contact of the first.
Sector free_second_nut(const PreloadParts& p) {
  Structure structure = p.structure;
  structure.screw.free_length = *p.preload.distance;
  structure.nut.flanges.clear();
  structure.nut.shoulder.reset();
  Sector second = sector_of(p, structure, Direction::tension, {Direction::tension, 0.0},
                            second_position(p.mechanism, p.structure.nut, p.preload));
  const int near = nut_end(second, second.nut_nodes.front(), false);
  std::erase_if(second.model.fixed_supports, [&](const fe::FixedSupport& support) {
    return support.node == near && support.dof == Dof::u;
  });
  return second;
}

PreloadSector double_nut(const PreloadParts& p, const Held& held) {
  Sector first = sector_of(p, p.structure, Direction::compression, held, p.preload.position);
  const Sector second = free_second_nut(p);
  const int first_node = first.model.nodes;
  const auto number = [&](int node) {
    return node == second.loaded_node ? first.screw_nodes.back() : first_node + node;
  };
  const auto numbered = [&](std::vector<int> nodes) {
    std::ranges::transform(nodes, nodes.begin(), number);
    return nodes;
  };

  PreloadSector s;
  s.arrangement = Preload::Arrangement::double_nut;
  s.flanks = {flank_of(second, number), flank_of(first, std::identity{})};
  s.sides.compression = side_of(first, 0);
  s.sides.tension = side_of(second, static_cast<int>(first.model.springs.size()));
  s.sides.tension.roller_nodes = numbered(s.sides.tension.roller_nodes);
  s.screw_nodes = screw_nodes(first);
  for (const int node : numbered(second.screw_nodes)) s.screw_nodes.push_back(node);
  s.loaded_node = first.loaded_node;

  const Spacer& spacer = *p.preload.spacer;
  const double rigidity = p.materials.nut.youngs_modulus *
                          ring_area(spacer.outer_diameter, spacer.inner_diameter) /
                          p.mechanism.rollers;
  const int from = nut_end(first, first.nut_nodes.back(), true);
  const int to = number(nut_end(second, second.nut_nodes.front(), false));
  s.model = std::move(first.model);
  s.model.nodes += second.model.nodes;
  append(s.model, second.model, number);
  s.model.bars.push_back({from, to, {rigidity, spacer.length}});
  return s;
}

/// See `build_preload_sector`.
void add_expansion(PreloadSector& s, const PreloadParts& p) {
  const Deviations& d = p.deviations;
  const auto strain = [&](Part part) {
    const double rise = (*d.temperature)[part] - d.reference_temperature;
    return p.materials[part].thermal_expansion.value_or(0.0) * rise;
  };
  const auto growth = [&](Part part) {
    return strain(part) * 0.5 * p.mechanism.pitch_diameter[part].value();
  };
  const double pitch = axial_pitch(p.mechanism);
  const double middle = 0.5 * (p.mechanism.contacts_per_roller - 1) * pitch;
  const bool shared = p.preload.arrangement == Preload::Arrangement::single_nut;
  for (const Direction side : kDirections)
    for (const Interface i : kInterfaces) {
      const bool screw = i == Interface::screw;
      const double ahead = screw ? 1.0 : -1.0, psi = p.laws[i].normal_angle;
      const double stretch = ahead * (strain(body_of(i)) - strain(Part::roller));
      const double closing = growth(Part::roller) + ahead * growth(body_of(i));
      // The second nut of two follows the first one.
      const double first = !shared && side == Direction::tension
                               ? 2.0 * middle + *p.preload.distance - middle
                               : -middle;
      for (std::size_t k = 0; k < s.sides[side].springs[i].size(); ++k)
        spring_of(s, s.sides[side].springs[i][k]).law.gap +=
            -sense(side) * std::cos(psi) * stretch * (first + static_cast<double>(k) * pitch) -
            std::sin(psi) * closing;
      if (shared && side == Direction::tension) s.expansion += closing;
      if (!shared)
        s.expansion += std::tan(psi) * closing + sense(side) * stretch * (first + middle);
    }
}

}  // namespace

PreloadSector build_preload_sector(const PreloadParts& given, Direction sense, double section,
                                   Play play) {
  const Held held{sense, section};
  Deviations cold = given.deviations;
  const bool expands = cold.temperature && play == Play::of_cold_parts;
  if (expands) cold.temperature.reset();
  const PreloadParts parts{given.mechanism, given.structure, given.materials,
                           given.options,   given.laws,      cold,
                           given.preload};
  PreloadSector s = parts.preload.arrangement == Preload::Arrangement::single_nut
                        ? single_nut(parts, held)
                        : double_nut(parts, held);
  if (expands) add_expansion(s, given);
  s.laws = parts.laws;
  s.rollers = parts.mechanism.rollers;
  s.roller_radius = 0.5 * *parts.mechanism.pitch_diameter.roller;
  return s;
}

PreloadSector fitted(PreloadSector s, const Fit& fit) {
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces) {
      const double psi = s.laws[i].normal_angle;
      const bool at_spacer =
          !s.rollers_are_shared() && d == Direction::tension && i == Interface::nut;
      const double overlap = s.rollers_are_shared() ? fit.radial[i] * std::sin(psi)
                             : at_spacer            ? fit.axial * std::cos(psi)
                                                    : 0.0;
      for (const int k : s.sides[d].springs[i]) spring_of(s, k).law.gap -= overlap;
    }
  s.fit = fit;
  return s;
}

std::vector<fe::NodalLoad> push_loads(const PreloadSector& s,
                                      const PerDirection<RollerPush>& push) {
  std::vector<fe::NodalLoad> loads;
  for (const Direction d : kDirections)
    for (fe::NodalLoad load : push_loads(*s.flanks[d].sector, push[d])) {
      load.node = s.flanks[d].node[static_cast<std::size_t>(load.node)];
      loads.push_back(load);
    }
  return loads;
}

PreloadSector one_sided(PreloadSector s, Direction carrying) {
  const Side& open = s.sides[opposite(carrying)];
  for (const Interface i : kInterfaces)
    for (const int k : open.springs[i]) spring_of(s, k).law.stiffness = 0.0;
  if (!s.rollers_are_shared())
    s.model.fixed_supports.push_back({open.roller_nodes.front(), Dof::u});
  return s;
}

}  // namespace prs
