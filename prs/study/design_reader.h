#pragma once

#include <memory>

#include "prs/input/study_reader.h"
#include "prs/study/designs.h"

namespace prs {

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

  /// The source of the design that was read last: that of the study with the design's overrides.
  input::Source source() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs
