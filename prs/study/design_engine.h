#pragma once

#include <memory>

#include "prs/input/study_reader.h"
#include "prs/study/recorded.h"
#include "simd/instruction_set.h"

namespace prs {

/// Evaluates the designs of one study.
class DesignEngine {
 public:
  /// Runs the base case. Throws UnknownResponse. The input must outlive the engine. With any instruction set a design
  /// has the same verdict and, to 1e-11, the same results.
  explicit DesignEngine(const input::StudyInput& input, simd::InstructionSet set = simd::InstructionSet::best,
                        Arrays arrays = Arrays::recorded);
  ~DesignEngine();

  /// The study, its responses the columns that it records.
  const Study& study() const;

  /// Whether a response is of natural modes.
  bool needs_modes() const;

  /// Evaluates designs [first, first + count): a pure function of the study, from any thread. Never throws for an error
  /// of a design. `stop` is called between slow designs, and later ones are left out if it returns true; at least one
  /// is evaluated.
  RowBlock evaluate(std::size_t first, std::size_t count, const std::function<bool()>& stop = {}) const;

  /// Evaluates designs given by their values, one draw per factor: row k of the block belongs to the k-th design.
  RowBlock evaluate(const std::vector<std::vector<Draw>>& designs) const;

  /// Number of designs that a thread should take at once.
  std::size_t chunk() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs
