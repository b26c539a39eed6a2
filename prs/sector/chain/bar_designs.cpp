#include "prs/sector/chain/bar_designs.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "fe/chain_laws.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/dispatch.h"
#include "prs/sector/chain/distribution.h"
#include "prs/sector/chain/sector_kernel.h"
#include "prs/sector/chain/sweep.h"
#include "prs/sector/chain/workspace.h"

namespace prs {
namespace {

/// Sectors of as many contacts, all with compliances or all without, as columns.
class Columns {
 public:
  void clear() {
    for_each_number([](std::vector<double>& column) { column.clear(); }, numbers_);
    force_.clear();
    for (FlangeColumns& f : flanges_)
      for (auto* values : {&f.from, &f.to, &f.rigidity}) values->clear();
    flange_count_ = 0;
    for (const Interface i : kInterfaces) gaps_[i].clear();
    gapped_ = {};
  }

  std::size_t size() const { return numbers_.pitch.size(); }

  void add(const SectorModel& s, std::span<const double> forces) {
    for_each_number(
        [](std::vector<double>& column, const double& number) { column.push_back(number); },
        numbers_, s);
    force_.insert(force_.end(), forces.begin(), forces.end());
    flange_count_ = std::max(flange_count_, s.flanges.size());
    if (flange_count_ > flanges_.size()) flanges_.resize(flange_count_);
    for (std::size_t i = 0; i < flange_count_; ++i) {
      FlangeColumns& column = flanges_[i];
      const SectorModel::Flange flange =
          i < s.flanges.size() ? s.flanges[i] : SectorModel::Flange{};
      for (auto* values : {&column.from, &column.to, &column.rigidity}) values->resize(size());
      column.from.back() = flange.from;
      column.to.back() = flange.to;
      column.rigidity.back() = flange.axial_rigidity;
    }
    for (const Interface i : kInterfaces) {
      gapped_[i] = gapped_[i] || std::ranges::any_of(s.gaps[i], [](double g) { return g != 0.0; });
      gaps_[i].insert(gaps_[i].end(), s.gaps[i].begin(), s.gaps[i].end());
    }
  }

  /// Valid until the next change.
  BarDesigns view(int contacts, bool with_compliance) {
    BarDesigns d;
    d.contacts = contacts;
    d.loads = force_.size() / size();
    d.axial_force = force_;
    for_each_number(
        [](BarDesigns::Values& view, const std::vector<double>& column) { view = column; }, d,
        numbers_);
    if (!with_compliance) d.compliance = {};
    flange_views_.clear();
    for (std::size_t i = 0; i < flange_count_; ++i)
      flange_views_.push_back({flanges_[i].from, flanges_[i].to, flanges_[i].rigidity});
    d.flanges = flange_views_;
    for (const Interface i : kInterfaces)
      if (gapped_[i]) d.gaps[i] = gaps_[i];
    return d;
  }

 private:
  struct FlangeColumns {
    std::vector<double> from, to, rigidity;
  };
  SectorNumbers<std::vector<double>> numbers_;
  std::vector<double> force_;
  std::vector<FlangeColumns> flanges_;  ///< The first `flange_count_` are in use.
  std::size_t flange_count_ = 0;
  std::vector<BarDesigns::Flange> flange_views_;
  PerInterface<std::vector<double>> gaps_;
  PerInterface<bool> gapped_;
};

}  // namespace

struct BarDesignSolver::Implementation {
  /// Columns that are filled before a call of the kernel.
  static constexpr std::size_t kChunk = 256;

  InstructionSet set;
  Workspace workspace;
  Columns columns;
  std::vector<std::size_t> order;
  ThreadLoadBuffer buffer;

  void run(const BarDesigns& designs, const fe::NewtonOptions& options,
           const ThreadLoads& results) {
    using OneSweep = Sweep<double, BarStation<double>, fe::ChainHertz<double>>;
    double* const memory =
        workspace.reserve(OneSweep::kWorkspaceNumbers * static_cast<std::size_t>(designs.contacts) *
                          static_cast<std::size_t>(batch_size(set)));
    run_kernel(set, SectorKernel{}, designs, options, results, memory);
  }

  /// Calls done(from, contacts, to) for every load, its results being those of solve `from` in
  /// `buffer`.
  template <class Done>
  void run(std::span<const SectorModel> sectors, std::span<const double> forces,
           const fe::NewtonOptions& options, Done done) {
    if (sectors.empty()) return;
    assert(forces.size() % sectors.size() == 0);
    const std::size_t loads = forces.size() / sectors.size();
    const auto kind = [&](std::size_t k) {
      return std::pair(sectors[k].contacts(), sectors[k].has_compliance());
    };
    order.resize(sectors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto ahead = [&](std::size_t a, std::size_t b) { return kind(a) < kind(b); };
    if (!std::is_sorted(order.begin(), order.end(), ahead))
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(kind(a), a) < std::pair(kind(b), b);
      });
    for (std::size_t first = 0; first < order.size();) {
      const auto [contacts, with_compliance] = kind(order[first]);
      columns.clear();
      std::size_t end = first;
      for (; end < order.size() && columns.size() < kChunk; ++end) {
        if (kind(order[end]) != kind(order[first])) break;
        columns.add(sectors[order[end]], forces.subspan(order[end] * loads, loads));
      }
      buffer.resize(columns.size() * loads, static_cast<std::size_t>(contacts));
      run(columns.view(contacts, with_compliance), options, buffer.view());
      for (std::size_t k = 0; k < columns.size() * loads; ++k)
        done(k, contacts, order[first + k / loads] * loads + k % loads);
      first = end;
    }
  }
};

BarDesignSolver::BarDesignSolver(InstructionSet set)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->set = set;
}
BarDesignSolver::~BarDesignSolver() = default;
BarDesignSolver::BarDesignSolver(BarDesignSolver&&) noexcept = default;
BarDesignSolver& BarDesignSolver::operator=(BarDesignSolver&&) noexcept = default;

void BarDesignSolver::solve(std::span<const SectorModel> sectors, std::span<const double> forces,
                            std::span<LoadDistribution> results) {
  assert(results.size() == forces.size());
  Implementation& s = *implementation_;
  s.run(sectors, forces, options, [&](std::size_t from, int contacts, std::size_t to) {
    s.buffer.copy(from, contacts, options.residual_tolerance, results[to]);
  });
}

void BarDesignSolver::solve(std::span<const SectorModel> sectors, std::span<const double> forces,
                            const ThreadLoads& results) {
  Implementation& s = *implementation_;
  s.run(sectors, forces, options, [&](std::size_t from, int contacts, std::size_t to) {
    s.buffer.copy(from, contacts, to, results);
  });
}

void BarDesignSolver::solve(const BarDesigns& designs, const ThreadLoads& results) {
  implementation_->run(designs, options, results);
}

}  // namespace prs
