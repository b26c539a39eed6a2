#pragma once

// Every consistent geometry of a diameter and a lead: `prs::configurations`.
#include "prs/configurations/configurations.h"
