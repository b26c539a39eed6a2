#pragma once

#include <string>
#include <string_view>

namespace prs {

/// Runs a command on a case: a question in JSON, its answer in JSON. Reads and writes no file.
///
/// The question; all but `command` and `yaml` may be absent:
///
///     {"command": "solve",                        // one of `analyses()` that one case answers
///      "yaml": "mechanism: ..",                   // the case
///      "file": "case.yaml",                       // stands for it in messages and documents
///      "set": [["mechanism.rollers", "9"], ..],   // as `--set mechanism.rollers=9`, in this order
///      "histories": {"flight.csv": "t,F\n0,1"},   // texts of the files that the case names
///      "load_cases": ["lift", ..],                // only these, or all of a range by its name
///      "figures": true}                           // as `--figures`; false
///
/// Only `contact`, `solve`, `compare`, `slip` and `measures` take `load_cases`; the duty cycle,
/// which needs all of them, is left out then.
///
/// The answer:
///
///     {"status": 0,       // exit status of the program: 0, 1 failed, 2 wrong input, 3 not
///     converged
///      "document": {..},  // what `prs solve --json` prints, byte by byte; null after an error
///      "figures": [..],   // what `--figures` adds to it; empty where they are not asked for
///      "messages": [..]}  // what the program says on standard error, line by line
///
/// Further commands serve pages. `write`: the document is {"yaml": ..}, the case with its overrides
/// in it; of a requirement with `"rank": 1` the case of that candidate. `new`: {"yaml": ..}, what
/// `prs new` writes for its options under this key, {"type": "standard", "lead": "10 mm", ..}, and
/// "assumed", what it says of the rest; it needs no `yaml`. `report` asks, under a key of that
/// name, for sections of the report, see `LiveQuestion`:
///
///     {"own": 1,                                  // so many pairs of `set` are the report's
///      "quick": true,                             // only what follows while a value moves
///      "sections": ["loads", ..],                 // all without
///      "thread": {"load_case": 0, "thread": 3}}   // one thread, as the section `thread`
///
/// Its document is {"sections": {"loads": "<figure>.."}}.
///
/// Throws nothing but std::bad_alloc, where there is no memory left for an answer.
std::string answer(std::string_view question);

}  // namespace prs
