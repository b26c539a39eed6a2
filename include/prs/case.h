#pragma once

// A case: content of a file about a screw. `prs::input::read_case` reads and checks one, `prs::Case` holds it;
// docs/reference/inputs.md names every key.
#include "prs/input/reader.h"
#include "prs/model/case.h"
