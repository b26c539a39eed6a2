#pragma once

namespace prs::cli {

/// The program `prs`. Returns its exit status.
int run_prs(int argc, char** argv);

}  // namespace prs::cli
