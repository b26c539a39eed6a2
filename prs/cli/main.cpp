#include "prs/cli/run_prs.h"

int main(int argc, char** argv) { return prs::cli::run_prs(argc, argv); }
