#pragma once

#include <string>

#include "prs/loads/result.h"
#include "prs/record/csv_style.h"

namespace prs {

/// `slip.csv`: one row a load case, failed ones included: slip ratio, efficiency, power lost to
/// each source, torques, the hottest thread and what equal shares would give. Fields as in
/// `load_cases.csv`.
std::string slip_csv(const Result& result, const CsvStyle& style = {});

/// `slip_threads.csv`: one row a thread and interface of every load case with an answer.
std::string slip_threads_csv(const Result& result, const CsvStyle& style = {});

}  // namespace prs
