#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Prints title, formula, validity and source of the measure or the path of a result in `options.explain`; of every
/// measure if it is empty.
int explain(const Options& options);
/// Words that `prs list` takes, `commands`, .., each with its meaning.
std::vector<std::string> list_words();
std::string list_help();
/// Prints possible choices: one name per line with its meaning, or one document.
int list(const Options& options);

}  // namespace prs::cli
