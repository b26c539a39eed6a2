#pragma once

#include "prs/record/analysis.h"
#include "prs/size/size.h"

namespace prs {

/// `prs size` and the requirements that it reads.
const OtherFile& size_file();

/// A result in all its forms; tables show the first `rows` candidates.
Delivery size_delivery(SizeResult result, std::size_t rows = 10);

std::string size_table(const SizeResult& result, std::size_t rows);
std::vector<OutputFile> size_files(const SizeResult& result, const CsvStyle& style);
Pictures size_pictures(const SizeResult& result);

/// Defaults that decide the verdicts: `limits.static_safety 1.5`.
std::vector<std::string> deciding_defaults(const SizeResult& result);

/// Part of the requirement that no candidate changes.
using RequirementOf = Within<SizeResult, MotionCycle>;

Record<RequirementOf> record_of(Type<RequirementOf>);
Record<MotionSegment> record_of(Type<MotionSegment>);
Record<SizedCandidate> record_of(Type<SizedCandidate>);
Record<SizedCandidate::ByThreads> record_of(Type<SizedCandidate::ByThreads>);
Record<SizeCriterion> record_of(Type<SizeCriterion>);
Record<SizedSegment> record_of(Type<SizedSegment>);
Record<SizeResult> record_of(Type<SizeResult>);

}  // namespace prs
