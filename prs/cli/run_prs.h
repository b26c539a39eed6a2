#pragma once

namespace prs::cli {

/// Runs the program `prs`. Returns its exit status.
int run_prs(int argc, char** argv);

/// Runs `prs validate`, with the arguments after `prs`; for the folder validation/.
int run_validate(int argc, char** argv);

}  // namespace prs::cli
