#pragma once

namespace prs::cli {

/// The program `prs`. Returns its exit status.
int run_prs(int argc, char** argv);

/// `prs validate`, with the arguments behind `prs`, of the folder validation/.
int run_validate(int argc, char** argv);

}  // namespace prs::cli
