#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "prs/input/study_reader.h"
#include "prs/study/row_block.h"
#include "prs/model/study.h"

namespace prs {

/// A response that the base case does not have: which of the study's, and what to do about it.
class UnknownResponse : public std::runtime_error {
 public:
  UnknownResponse(std::size_t index, const std::string& message)
      : std::runtime_error(message), index_(index) {}
  std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// Answers the designs of one study.
class DesignEngine {
 public:
  /// Runs the base case. Throws UnknownResponse. The input must outlive the engine.
  explicit DesignEngine(const input::StudyInput& input);
  ~DesignEngine();

  /// With the responses that are recorded.
  const Study& study() const;

  /// Designs [first, first + count): a pure function of the study, from any thread. Never throws
  /// for what is wrong with a design.
  RowBlock evaluate(std::size_t first, std::size_t count) const;

  /// The same of designs that are given by their values, one draw a factor each: row k of the block
  /// answers the k-th of them.
  RowBlock evaluate(const std::vector<std::vector<Draw>>& designs) const;

  /// Designs that a thread should take at once.
  std::size_t chunk() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs
