/* A host for a co-simulation unit: fmi_host LIBRARY GUID RESOURCES STEP INPUTS OUTPUTS, the latter value references
   with commas between them. Reads a row of inputs per step, writes a row of outputs behind it. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "fmi2.h"

enum { kMost = 16 };

static void log_message(fmi2ComponentEnvironment self, fmi2String name, fmi2Status status, fmi2String category,
                        fmi2String message, ...) {
  va_list arguments;
  (void)self, (void)name, (void)status, (void)category;
  va_start(arguments, message);
  vfprintf(stderr, message, arguments);
  va_end(arguments);
}

static size_t references_of(char* text, fmi2ValueReference* references) {
  size_t count = 0;
  for (char* part = strtok(text, ","); part; part = strtok(NULL, ",")) references[count++] = (unsigned)atoi(part);
  return count;
}

#define FUNCTION(result, name, ...)          \
  typedef result (*name##Type)(__VA_ARGS__); \
  const name##Type name = (name##Type)(void*)GetProcAddress(library, "fmi2" #name)

int main(int count, char** argument) {
  const HMODULE library = count == 7 ? LoadLibraryA(argument[1]) : NULL;
  if (!library) return 1;
  FUNCTION(fmi2Component, Instantiate, fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions*, int,
           int);
  FUNCTION(fmi2Status, SetupExperiment, fmi2Component, int, double, double, int, double);
  FUNCTION(fmi2Status, EnterInitializationMode, fmi2Component);
  FUNCTION(fmi2Status, ExitInitializationMode, fmi2Component);
  FUNCTION(fmi2Status, SetReal, fmi2Component, const fmi2ValueReference*, size_t, const double*);
  FUNCTION(fmi2Status, GetReal, fmi2Component, const fmi2ValueReference*, size_t, double*);
  FUNCTION(fmi2Status, DoStep, fmi2Component, double, double, int);
  FUNCTION(void, FreeInstance, fmi2Component);
  const fmi2CallbackFunctions callbacks = {log_message, calloc, free, NULL, NULL};
  const fmi2Component unit = Instantiate("unit", fmi2CoSimulation, argument[2], argument[3], &callbacks, 0, 0);
  const double step = atof(argument[4]);
  fmi2ValueReference in[kMost], out[kMost];
  const size_t inputs = references_of(argument[5], in), outputs = references_of(argument[6], out);
  double values[kMost];
  if (!unit || SetupExperiment(unit, 0, 0.0, 0.0, 0, 0.0) != fmi2OK) return 2;
  for (int k = 0;; ++k) {
    for (size_t i = 0; i < inputs; ++i)
      if (scanf("%lf", &values[i]) != 1) return FreeInstance(unit), 0;
    if (k == 0 && EnterInitializationMode(unit) != fmi2OK) return 3;
    if (SetReal(unit, in, inputs, values) != fmi2OK) return 4;
    if (k == 0 && ExitInitializationMode(unit) != fmi2OK) return 5;
    if (DoStep(unit, k * step, step, 1) != fmi2OK || GetReal(unit, out, outputs, values) != fmi2OK) return 6;
    for (size_t i = 0; i < outputs; ++i) printf("%.17g ", values[i]);
    printf("\n");
  }
}
