#pragma once

// The document of `prs solve --json`: `prs::to_json` and `prs::json_text`.
#include "prs/loads/load_json.h"
