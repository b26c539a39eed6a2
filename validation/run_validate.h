#pragma once

namespace prs {

/// The program behind `prs validate`. Returns its exit status.
int run_validate(int argc, char** argv);

}  // namespace prs
