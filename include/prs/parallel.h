#pragma once

// Work on many threads: `prs::run_in_order`.
#include "prs/study/study_run.h"
