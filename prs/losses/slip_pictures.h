#pragma once

#include "prs/loads/result.h"
#include "prs/model/case.h"
#include "prs/record/pictures.h"

namespace prs {

/// What `slip` can show, and by their names what `solve` can. Both must outlive the list.
Pictures slip_pictures(const Case& c, const Result& result);

}  // namespace prs
