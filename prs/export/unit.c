/* A roller screw as a co-simulation unit of FMI 2.0: outputs follow the inputs without delay. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "curves.h"
#include "fmi2.h"

/* Value references, as in modelDescription.xml. */
enum { kDeflection, kSpeed, kForce, kStiffness, kTorque, kInputs = 2, kVariables = 5 };

static const char* const kGuidFile = "guid.txt";
static const char* const kCurvesFile = "curves.bin";
static const char* const kWarnings = "logStatusWarning";
static const char* const kErrors = "logStatusError";

typedef struct {
  double input[kInputs];
} State;

typedef struct {
  State state;
  double* data;
  PrsCurves curves;
  double time;
  int warned_of_deflection, warned_of_torque;
  fmi2CallbackFunctions callbacks;
  char name[200];
} Unit;

static void tell(const fmi2CallbackFunctions* callbacks, const char* name, fmi2Status status,
                 const char* message) {
  if (callbacks && callbacks->logger)
    callbacks->logger(callbacks->componentEnvironment, name, status,
                      status == fmi2Warning ? kWarnings : kErrors, "%s", message);
}

static fmi2Status fail(Unit* unit, const char* message) {
  tell(&unit->callbacks, unit->name, fmi2Error, message);
  return fmi2Error;
}

/* The path of a file: URI, with % and two digits for a character: `file:///tmp/a%20b`. */
static int path_of(const char* uri, const char* file, char* path, size_t size) {
  size_t n = 0;
  if (!uri || strncmp(uri, "file:", 5) != 0) return 0;
  uri += 5;
  if (strncmp(uri, "///", 3) == 0)
    uri += 2;
  else if (strncmp(uri, "//localhost/", 12) == 0)
    uri += 11;
#ifdef _WIN32
  if (*uri == '/') ++uri; /* /C:/Temp */
#endif
  for (; *uri; ++uri) {
    unsigned code = 0;
    char digits[3] = {0, 0, 0};
    if (*uri == '%' && uri[1] && uri[2]) {
      char* end;
      memcpy(digits, uri + 1, 2);
      code = (unsigned)strtoul(digits, &end, 16);
      if (*end) return 0;
      uri += 2;
    }
    if (n + 1 >= size) return 0;
    path[n++] = code ? (char)code : *uri;
  }
  if (n + strlen(file) + 2 > size) return 0;
  if (n > 0 && path[n - 1] != '/') path[n++] = '/';
  strcpy(path + n, file);
  return 1;
}

/* The whole file, which the caller frees; NULL where it cannot be read. */
static char* content_of(const char* uri, const char* file, size_t* size) {
  char path[4096];
  FILE* stream;
  char* content = NULL;
  long length;
  if (!path_of(uri, file, path, sizeof path)) return NULL;
  stream = fopen(path, "rb");
  if (!stream) return NULL;
  if (fseek(stream, 0, SEEK_END) == 0 && (length = ftell(stream)) >= 0 &&
      fseek(stream, 0, SEEK_SET) == 0) {
    *size = (size_t)length;
    content = (char*)malloc(*size + 1);
    if (content && fread(content, 1, *size, stream) != *size) {
      free(content);
      content = NULL;
    }
  }
  fclose(stream);
  if (content) content[*size] = '\0';
  return content;
}

/* NULL, or what is wrong. */
static const char* load(Unit* unit, const char* guid, const char* resources) {
  static const union {
    unsigned number;
    unsigned char first;
  } order = {1};
  size_t size = 0;
  int is_own;
  char* const own = content_of(resources, kGuidFile, &size);
  if (!own) return "no resources/guid.txt at fmuResourceLocation; expected a file: URI";
  is_own = guid && strcmp(own, guid) == 0;
  free(own);
  if (!is_own) return "the GUID is not that of this unit; read modelDescription.xml again";
  if (!order.first) return "this unit runs on processors of little-endian numbers alone";
  unit->data = (double*)(void*)content_of(resources, kCurvesFile, &size);
  if (!unit->data || size % sizeof(double) != 0 ||
      !prs_read_curves(unit->data, size / sizeof(double), &unit->curves))
    return "resources/curves.bin is missing or damaged; export the unit again";
  return NULL;
}

static void forget(Unit* unit) {
  memset(&unit->state, 0, sizeof unit->state);
  unit->time = 0.0;
  unit->warned_of_deflection = unit->warned_of_torque = 0;
}

static void warn_once(Unit* unit, int beyond, int* warned, const char* message) {
  if (!beyond || *warned) return;
  *warned = 1;
  tell(&unit->callbacks, unit->name, fmi2Warning, message);
}

static void evaluate(Unit* unit, double value[kVariables]) {
  int beyond;
  value[kDeflection] = unit->state.input[kDeflection];
  value[kSpeed] = unit->state.input[kSpeed];
  value[kForce] = prs_force(&unit->curves, value[kDeflection], &value[kStiffness], &beyond);
  warn_once(unit, beyond, &unit->warned_of_deflection,
            "deflection: beyond the computed range; the force goes on in a straight line");
  value[kTorque] = prs_torque(&unit->curves, value[kForce], value[kSpeed], &beyond);
  warn_once(
      unit, beyond, &unit->warned_of_torque,
      "torque: force or speed is beyond the computed range; friction grows with the force and "
      "stays that of the largest speed");
}

FMI2(const char*, fmi2GetTypesPlatform)(void) { return "default"; }
FMI2(const char*, fmi2GetVersion)(void) { return "2.0"; }

FMI2(fmi2Status, fmi2SetDebugLogging)
(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]) {
  (void)c, (void)on, (void)count, (void)categories;
  return fmi2OK;
}

FMI2(fmi2Component, fmi2Instantiate)
(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
 const fmi2CallbackFunctions* callbacks, fmi2Boolean visible, fmi2Boolean logging) {
  const char* problem;
  Unit* unit;
  (void)visible, (void)logging;
  if (!callbacks || !name || !*name) return NULL;
  if (type != fmi2CoSimulation) {
    tell(callbacks, name, fmi2Error, "this unit is for co-simulation");
    return NULL;
  }
  unit = (Unit*)calloc(1, sizeof(Unit));
  if (!unit) return NULL;
  strncpy(unit->name, name, sizeof unit->name - 1);
  unit->callbacks = *callbacks;
  problem = load(unit, guid, resources);
  if (!problem) return unit;
  tell(callbacks, name, fmi2Error, problem);
  free(unit->data);
  free(unit);
  return NULL;
}

FMI2(void, fmi2FreeInstance)(fmi2Component c) {
  Unit* const unit = (Unit*)c;
  if (!unit) return;
  free(unit->data);
  free(unit);
}

FMI2(fmi2Status, fmi2SetupExperiment)
(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
 fmi2Boolean has_stop, fmi2Real stop) {
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  ((Unit*)c)->time = start;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2EnterInitializationMode)(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2ExitInitializationMode)(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2Terminate)(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2Reset)(fmi2Component c) {
  forget((Unit*)c);
  return fmi2OK;
}

FMI2(fmi2Status, fmi2GetReal)
(fmi2Component c, const fmi2ValueReference references[], size_t count, fmi2Real values[]) {
  Unit* const unit = (Unit*)c;
  double value[kVariables];
  size_t k;
  evaluate(unit, value);
  for (k = 0; k < count; ++k) {
    if (references[k] >= kVariables) return fail(unit, "unknown value reference");
    values[k] = value[references[k]];
  }
  return fmi2OK;
}

FMI2(fmi2Status, fmi2SetReal)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Real values[]) {
  Unit* const unit = (Unit*)c;
  size_t k;
  for (k = 0; k < count; ++k) {
    if (references[k] >= kInputs) return fail(unit, "only deflection and speed can be set");
    if (!isfinite(values[k]))
      return fail(unit, references[k] == kDeflection ? "deflection: not a finite number"
                                                     : "speed: not a finite number");
  }
  for (k = 0; k < count; ++k) unit->state.input[references[k]] = values[k];
  return fmi2OK;
}

/* There are no variables of other types. */
#define NONE_OF(name, type)                                                               \
  FMI2(fmi2Status, name)                                                                  \
  (fmi2Component c, const fmi2ValueReference references[], size_t count, type values[]) { \
    (void)references, (void)values;                                                       \
    return count == 0 ? fmi2OK : fail((Unit*)c, "this unit has real variables alone");    \
  }
NONE_OF(fmi2GetInteger, fmi2Integer)
NONE_OF(fmi2GetBoolean, fmi2Boolean)
NONE_OF(fmi2GetString, fmi2String)
NONE_OF(fmi2SetInteger, const fmi2Integer)
NONE_OF(fmi2SetBoolean, const fmi2Boolean)
NONE_OF(fmi2SetString, const fmi2String)

FMI2(fmi2Status, fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate* state) {
  if (!*state) *state = malloc(sizeof(State));
  if (!*state) return fail((Unit*)c, "no memory");
  *(State*)*state = ((Unit*)c)->state;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate state) {
  ((Unit*)c)->state = *(State*)state;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate* state) {
  (void)c;
  free(*state);
  *state = NULL;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate state, size_t* size) {
  (void)c, (void)state;
  *size = sizeof(State);
  return fmi2OK;
}
FMI2(fmi2Status, fmi2SerializeFMUstate)
(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  if (size < sizeof(State)) return fail((Unit*)c, "the state does not fit");
  memcpy(bytes, state, sizeof(State));
  return fmi2OK;
}
FMI2(fmi2Status, fmi2DeSerializeFMUstate)
(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state) {
  if (size != sizeof(State)) return fail((Unit*)c, "this is no state of this unit");
  if (!*state) *state = malloc(sizeof(State));
  if (!*state) return fail((Unit*)c, "no memory");
  memcpy(*state, bytes, sizeof(State));
  return fmi2OK;
}

/* Not provided, as modelDescription.xml says. */
FMI2(fmi2Status, fmi2GetDirectionalDerivative)
(fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns,
 const fmi2ValueReference known[], size_t knowns, const fmi2Real along[], fmi2Real derivative[]) {
  (void)unknown, (void)unknowns, (void)known, (void)knowns, (void)along, (void)derivative;
  return fail((Unit*)c, "this unit gives no directional derivatives");
}
FMI2(fmi2Status, fmi2SetRealInputDerivatives)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
 const fmi2Real values[]) {
  (void)references, (void)count, (void)orders, (void)values;
  return fail((Unit*)c, "this unit takes no derivatives of inputs");
}
FMI2(fmi2Status, fmi2GetRealOutputDerivatives)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
 fmi2Real values[]) {
  (void)references, (void)count, (void)orders, (void)values;
  return fail((Unit*)c, "this unit gives no derivatives of outputs");
}

FMI2(fmi2Status, fmi2DoStep)
(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean is_no_state_before) {
  (void)is_no_state_before;
  ((Unit*)c)->time = time + step;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2CancelStep)(fmi2Component c) { return fail((Unit*)c, "no step is under way"); }
FMI2(fmi2Status, fmi2GetStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Status* value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}
FMI2(fmi2Status, fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = ((Unit*)c)->time;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2GetIntegerStatus)
(fmi2Component c, const fmi2StatusKind kind, fmi2Integer* value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}
FMI2(fmi2Status, fmi2GetBooleanStatus)
(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  (void)c;
  *value = 0;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2GetStringStatus)
(fmi2Component c, const fmi2StatusKind kind, fmi2String* value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}
