#pragma once

#include "prs/loads/result.h"
#include "prs/model/case.h"
#include "prs/record/pictures.h"

namespace prs {

// What each command can show. The result must outlive the list.
Pictures contact_pictures(const Result& result);
Pictures solve_pictures(const Result& result);
/// Of the mechanism, asked for by their names alone.
Pictures drawings(const Case& c, const Result& result);
Pictures with_drawings(Pictures pictures, const Case& c, const Result& result);

}  // namespace prs
