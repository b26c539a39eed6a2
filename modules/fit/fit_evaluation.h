#pragma once

#include "modules/fit/fit.h"

namespace prs {

/// Evaluates all responses of a fit at values of the parameters in their units, on several threads.
class FitEvaluation {
 public:
  /// Runs the case of each curve once. Throws InputError. The input must outlive the object.
  FitEvaluation(const FitInput& input, std::size_t threads);
  ~FitEvaluation();

  std::vector<modules::fit::Answer> operator()(const std::vector<modules::fit::Request>& requests);
  std::size_t rows() const;  ///< Number of rows computed so far.

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs
