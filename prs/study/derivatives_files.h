#pragma once

#include "prs/loads/load_json.h"
#include "prs/record/csv_writer.h"
#include "prs/record/record.h"
#include "prs/study/derivatives.h"

namespace prs {

Record<CaseDerivatives> record_of(Type<CaseDerivatives>);

/// The document of `prs study --json` with `plan: derivatives`: under `derivatives` one entry a
/// response, with its value and what each factor does to it.
Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info);

/// `derivatives.csv`: one row per response and factor.
std::string derivatives_csv(const CaseDerivatives& result, const CsvStyle& style = {});

/// One table per response: what 1 % of each factor does to it, the strongest first.
std::string derivatives_table(const CaseDerivatives& result);

/// What the derivatives of a case can show. The result must outlive the list.
Pictures derivatives_pictures(const CaseDerivatives& result);

}  // namespace prs
