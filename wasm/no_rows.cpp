#include <stdexcept>

#include "modules/fit/fit_evaluation.h"
#include "prs/optimize/optimize_files.h"

/// Study functions used by a fit. Its module is missing here, so that they are never called.
namespace prs {

namespace {

[[noreturn]] void refuse() { throw std::logic_error("this engine computes no rows of a fit"); }

}  // namespace

struct FitEvaluation::Parts {};

FitEvaluation::FitEvaluation(const FitInput&, std::size_t) { refuse(); }
FitEvaluation::~FitEvaluation() = default;
std::vector<modules::fit::Answer> FitEvaluation::operator()(const std::vector<modules::fit::Request>&) { refuse(); }
std::size_t FitEvaluation::rows() const { refuse(); }

std::string case_with(const input::Source&, const std::vector<std::string>&, const std::string&) { refuse(); }

}  // namespace prs
