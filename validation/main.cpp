#include "validation/run_validate.h"

int main(int argc, char** argv) { return prs::run_validate(argc, argv); }
