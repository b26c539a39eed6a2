#include "prs/sector/chain/refined_kernel.h"

#include "fe/chain_hertz.h"
#include "prs/sector/chain/nut_condensation.h"
#include "prs/sector/chain/sector_solve.h"
#include "prs/sector/refined_formulas.h"

namespace prs {
namespace {

/// A batch of sectors in the workspace.
template <class Real>
struct RefinedBatch {
  using Station = ShellStation<Real, ChainSector::Kind::shell>;

  std::size_t contacts, nodes;
  fe::ChainRecord<Real, Station>* records;
  NutSegment<Real>* segments;
  NutSupport<Real>* supports;
  fe::ShellBlocks<Real>* shells;
  Real *compliance[2], *gap[2], *sections, *outer_radius, *root;
  SectorNumbers<Real> numbers;
  RefinedNumbers<Real> bodies;

  RefinedBatch(double* memory, std::size_t of_contacts, std::size_t of_nodes) : contacts(of_contacts), nodes(of_nodes) {
    const auto take = [&]<class T>(T*& part, std::size_t count) {
      part = reinterpret_cast<T*>(memory);
      memory += count * (sizeof(T) / sizeof(double));
    };
    take(records, contacts);
    take(segments, contacts);
    take(supports, contacts);
    for (Real** part : {&compliance[0], &compliance[1], &gap[0], &gap[1]}) take(*part, contacts);
    take(shells, nodes);
    for (Real** part : {&sections, &outer_radius, &root}) take(*part, nodes);
  }

  /// Reads one sector per lane.
  void read(const RefinedDesigns& designs, const LaneRange& range) {
    const RefinedSector* lanes[kLanes<Real>];
    for (std::size_t l = 0; l < kLanes<Real>; ++l)
      lanes[l] = &designs.sectors[range.first + l < range.size ? range.first + l : range.size - 1];
    const auto structures = [&]<template <class> class S>(S<Real>& all, auto of) {
      S<double> each[kLanes<Real>];
      for (std::size_t l = 0; l < kLanes<Real>; ++l) each[l] = of(*lanes[l]);
      all = simd::side_by_side<S<Real>>(each, kLanes<Real>);
    };
    const auto column = [&](Real* all, std::size_t count, auto of) {
      for (std::size_t k = 0; k < count; ++k) {
        double each[kLanes<Real>];
        for (std::size_t l = 0; l < kLanes<Real>; ++l) each[l] = of(*lanes[l])[k];
        all[k] = from_lanes<Real>(each);
      }
    };
    structures(
        numbers, [](const RefinedSector& s) -> const auto& { return *s.numbers; });
    structures(
        bodies, [](const RefinedSector& s) -> const auto& { return *s.bodies; });
    column(sections, nodes, [](const RefinedSector& s) { return s.sections; });
    column(outer_radius, nodes - 1, [](const RefinedSector& s) { return s.outer_radius; });
    column(root, nodes - 1, [](const RefinedSector& s) { return s.root; });
    column(gap[0], contacts, [](const RefinedSector& s) { return s.gaps.screw; });
    column(gap[1], contacts, [](const RefinedSector& s) { return s.gaps.nut; });
  }

  void solve(const RefinedDesigns& designs, const LaneRange& range, const fe::NewtonOptions& options,
             ThreadLoads& results) {
    const NutShape& shape = designs.shape;
    const Real arm = set_nut_shells(shape, nut_numbers(numbers, bodies, sections, outer_radius, root), shells);
    const NutHolds holds{shape.thrust, shape.held_radially(), false, shape.effects.flange && !shape.has_ring};
    NutCondensation<Real>(shape, holds, shells, numbers.roller_radius).set(designs.segment_of, segments, supports);
    for (std::size_t k = 0; k < contacts; ++k) {
      compliance[0][k] = numbers.compliance.screw;
      compliance[1][k] = numbers.compliance.nut;
    }
    add_body_compliance(shape, numbers, bodies, outer_radius, compliance[0], compliance[1]);

    const auto count = static_cast<int>(contacts);
    Station station;
    station.stations = count;
    station.set_parts(numbers, Real(numbers.sense * numbers.cosine.nut * arm / numbers.roller_radius));
    station.roller = roller_chain<Real>(numbers);
    station.segments = segments;
    station.segment_of = designs.segment_of.data();
    station.supports = supports;
    const fe::ChainHertzInSeries<Real> law{{numbers.hertz_constant.screw, numbers.hertz_constant.nut},
                                           {compliance[0], compliance[1]}};
    const auto gap_at = [&](int i, int k) { return gap[i][k]; };
    solve_sectors<Real>(numbers, count, station, law, records, range.load<Real>(designs.axial_forces), gap_at, options,
                        range, results);
  }
};

}  // namespace

template <class Arch>
void RefinedKernel::operator()(Arch, const RefinedDesigns& designs, const fe::NewtonOptions& options,
                               ThreadLoads& results, double* workspace) const {
  using Real = xsimd::batch<double, Arch>;
  RefinedBatch<Real> batch(workspace, designs.shape.contacts.size(), designs.shape.nodes());
  for (std::size_t from = 0; from < designs.sectors.size(); from += kLanes<Real>) {
    const LaneRange range{from, designs.sectors.size()};
    batch.read(designs, range);
    batch.solve(designs, range, options, results);
  }
}

template void RefinedKernel::operator()(PRS_SIMD_ARCHITECTURE, const RefinedDesigns&, const fe::NewtonOptions&,
                                        ThreadLoads&, double*) const;

}  // namespace prs
