#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "prs/sector/influence/flexibility_options.h"
#include "prs/model/load_case.h"
#include "prs/model/materials.h"

namespace prs {

/// All that a matrix depends on, written out exactly. The number that it starts with grows when the
/// same description gives other matrices.
class CacheKey {
 public:
  explicit CacheKey(std::string_view what) { text_ = fmt::format("flexibility 2 {}", what); }

  CacheKey& add(double value) {
    text_ += fmt::format(" {:a}", value);
    return *this;
  }
  CacheKey& add(const Groove& g) {
    return add(g.internal)
        .add(g.pitch)
        .add(g.pitch_radius)
        .add(g.addendum)
        .add(g.dedendum)
        .add(g.backward_angle)
        .add(g.forward_angle);
  }
  CacheKey& add(const Material& m) { return add(m.youngs_modulus).add(m.poisson_ratio); }
  CacheKey& add(const HertzPatch& p) { return add(p.along_profile).add(p.along_circumference); }
  CacheKey& add(Direction d) { return add(sense(d)); }
  CacheKey& add(const MeshDensity& m) {
    return add(m.patch_cells)
        .add(m.growth)
        .add(m.largest_cell)
        .add(m.step_cell)
        .add(m.plain_flank_cells)
        .add(m.split)
        .add(m.ridge_depth);
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace prs
