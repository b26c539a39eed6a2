#include "program.h"

const char* test::program() { return PRS_EXECUTABLE; }
