#pragma once

namespace prs {

/// How a run ended: exit statuses of the programs, statuses of answers.
enum Exit { kDone = 0, kFailed = 1, kWrongInput = 2, kNotConverged = 3 };

}  // namespace prs
