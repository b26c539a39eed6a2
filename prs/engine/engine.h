#pragma once

#include <string>
#include <string_view>

namespace prs {

/// Runs a command on a case: a question in JSON, its answer in JSON. Reads and writes no file.
///
/// The question; all except `command` and `yaml` are optional:
///
///     {"command": "solve",                        // one of `analyses()` that one case answers
///      "yaml": "mechanism: ..",                   // the case
///      "file": "case.yaml",                       // its name in messages and documents
///      "set": [["mechanism.rollers", "9"], ..],   // as `--set mechanism.rollers=9`, in this order
///      "histories": {"flight.csv": "t,F\n0,1"},   // texts of the files that the case names
///      "load_cases": ["lift", ..],                // only these, or all of a range by its name
///      "figures": true}                           // as `--figures`; default false
///
/// Only `contact`, `solve`, `compare`, `slip` and `measures` take `load_cases`; the duty cycle, which needs all of
/// them, is left out then.
///
/// The answer:
///
///     {"status": 0,       // exit status of the program: 0, 1 failed, 2 wrong input, 3 not converged
///      "document": {..},  // output of `prs solve --json`, byte by byte; null after an error
///      "figures": [..],   // its `figures` with `--figures`; empty if not requested
///      "messages": [..]}  // lines that the program prints on standard error
///
/// Further commands serve pages. `write`: the document is {"yaml": ..}, the case with its overrides written into it;
/// for a requirement with `"rank": 1` the case of that candidate. `new`: {"yaml": ..}, output of `prs new` for the
/// options under this key, {"type": "standard", "lead": "10 mm", ..}, and "assumed", its assumptions for the rest; it
/// needs no `yaml`. `report` requests, under a key of that name, sections of the report, see `LiveQuestion`:
///
///     {"own": 1,                                  // number of pairs of `set` that are the report's
///      "quick": true,                             // only sections that follow a moving value
///      "sections": ["loads", ..],                 // default: all
///      "thread": {"load_case": 0, "thread": 3}}   // one thread, as the section `thread`
///
/// Its document is {"sections": {"loads": "<figure>.."}}.
///
/// Throws only std::bad_alloc, if no memory is left for an answer.
std::string answer(std::string_view question);

}  // namespace prs
