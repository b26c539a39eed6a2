#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "prs/model/envelope.h"
#include "prs/model/study.h"
#include "prs/study/grid_maps.h"

namespace prs {

/// A measure over the grid.
struct MeasureMap {
  std::size_t response = 0;    ///< Index among the study's responses.
  double weight = 1.0;         ///< w_i
  double rms = 0.0;            ///< Root mean square of all its numbers, in its unit.
  double normalised_by = 1.0;  ///< n_i, in its unit.
  std::size_t without = 0;     ///< Nodes without a number.
};

/// A design read off the envelope, between two nodes by interpolation.
struct EnvelopePoint {
  std::string name;
  std::string reason = {};  ///< Why there is no such design; empty where there is one.
  MapPlace place = {};
  std::optional<std::size_t> design = {};  ///< The node's design, if it has one.
  std::vector<Level> inputs = {};          ///< One per drawn input (`drawn_inputs`).
  std::vector<double> responses = {};      ///< All of the study's; NaN next to designs without.
  std::vector<double> normalised = {};     ///< m_i / n_i, one per measure.
  double envelope = 0.0;
};

/// An envelope over the grid and the designs read off it.
struct EnvelopeResult {
  std::vector<MeasureMap> measures;
  GridMap values;    ///< E; NaN where it is not defined, as for a root of a negative measure.
  double rms = 0.0;  ///< Root mean square of the values.
  std::size_t without = 0;               ///< Nodes without a value.
  std::optional<std::size_t> best = {};  ///< The first node with the largest value.
  std::vector<EnvelopePoint> points;
};

/// The envelope of a study that has one. Each response is bilinear between four nodes, E is that of
/// the responses at the place.
EnvelopeResult evaluate_envelope(const Study& study, const GridMaps& maps);

/// m_i / n_i over the grid.
GridMap normalised(const GridMaps& maps, const MeasureMap& measure);

}  // namespace prs
