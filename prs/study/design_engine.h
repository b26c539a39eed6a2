#pragma once

#include <memory>

#include "prs/input/study_reader.h"
#include "prs/study/designs.h"
#include "simd/instruction_set.h"

namespace prs {

/// A response that the base case does not have: its index in the study, and how to fix it.
class UnknownResponse : public std::runtime_error {
 public:
  UnknownResponse(std::size_t index, const std::string& message) : std::runtime_error(message), index_(index) {}
  std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// Evaluates the designs of one study.
class DesignEngine {
 public:
  /// Runs the base case. Throws UnknownResponse. The input must outlive the engine. With any
  /// instruction set a design has the same verdict and, to 1e-11, the same answers.
  explicit DesignEngine(const input::StudyInput& input, simd::InstructionSet set = simd::InstructionSet::best);
  ~DesignEngine();

  /// The study with the responses that it records.
  const Study& study() const;

  /// Designs [first, first + count): a pure function of the study, from any thread. Never throws
  /// for what is wrong with a design. `stop` is asked between slow designs, and those that follow
  /// are left out; one at least is answered.
  RowBlock evaluate(std::size_t first, std::size_t count, const std::function<bool()>& stop = {}) const;

  /// Designs that are given by their values, one draw per factor: row k of the block belongs to the
  /// k-th design.
  RowBlock evaluate(const std::vector<std::vector<Draw>>& designs) const;

  /// Designs that a thread should take at once.
  std::size_t chunk() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Reads the cases of a study's designs one after the other, without parsing where only numbers
/// change. One per thread.
class DesignReader {
 public:
  /// The input must outlive the reader.
  explicit DesignReader(const input::StudyInput& input);
  ~DesignReader();
  DesignReader(DesignReader&&) noexcept;

  /// The case of design k, valid until the next one is read: that of `read_design` with the
  /// design's overrides. Who changes it must change it back. Throws InputError.
  Case& read(std::size_t k);

  /// The case of a design that is given by its values, one draw per factor.
  Case& read(const std::vector<Draw>& draws);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs
