#pragma once

#include "prs/report/report.h"

namespace prs {

/// Parts for a requirement: `prs size`.
ReportParts requirement_parts(const input::Source& source, const ReportOptions& options);

}  // namespace prs
