/* A roller screw as a co-simulation unit of FMI 2.0: alone, its outputs follow the inputs without
   delay; with its drive (resources/drive.bin) it has states, and integrates them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#endif

#include "dormand_prince.h"
#include "fmi2.h"

/* Value references, as in modelDescription.xml. */
enum { kDeflection, kSpeed, kForce, kStiffness, kTorque, kInputs = 2, kVariables = 5 };

enum {
  kMotorTorque,
  kReference,
  kReferenceSpeed,
  kMotorSpeed,
  kExternalForce,
  kPosition,
  kVelocity,
  kDriveForce,
  kDriveDeflection,
  kMotorAngle,
  kMotorVelocity,
  kScrewAngle,
  kScrewVelocity,
  kCouplingTorque,
  kAcceleration,
  kDriveInputs = kPosition,
  kDriveVariables = kAcceleration + 1
};

static const double kTolerance = 1e-8; /* Of a step */
static const long kMostSteps = 20000000;

static const char* const kDriveFile = "drive.bin";
static const char* const kGuidFile = "guid.txt";
static const char* const kCurvesFile = "curves.bin";
static const char* const kWarnings = "logStatusWarning";
static const char* const kErrors = "logStatusError";

typedef struct {
  double input[kDriveInputs];
  double before; /* Motor speed at the end of the last step */
  double value[kDriveVariables];
  PrsState drive;
  int begun; /* Initialization has ended. */
} State;

typedef struct {
  State state;
  int has_drive;
  double resolution;
  PrsDrive drive;
  PrsRun run;
  PrsDormandPrince method;
  double from, to; /* Of the step */
  double* data;
  PrsCurves curves;
  double time;
  int warned_of_deflection, warned_of_torque;
  fmi2CallbackFunctions callbacks;
  char name[200];
} Unit;

static void tell(const fmi2CallbackFunctions* callbacks, const char* name, fmi2Status status, const char* message) {
  if (callbacks && callbacks->logger)
    callbacks->logger(callbacks->componentEnvironment, name, status, status == fmi2Warning ? kWarnings : kErrors, "%s",
                      message);
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

/* A file by its path in UTF-8. */
static FILE* open_file(const char* path) {
#ifdef _WIN32
  wchar_t wide[4096];
  return MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, 4096) ? _wfopen(wide, L"rb") : NULL;
#else
  return fopen(path, "rb");
#endif
}

/* The whole file, which the caller frees; NULL where it cannot be read. */
static char* content_of(const char* uri, const char* file, size_t* size) {
  char path[4096];
  FILE* stream;
  char* content = NULL;
  long length;
  if (!path_of(uri, file, path, sizeof path)) return NULL;
  stream = open_file(path);
  if (!stream) return NULL;
  if (fseek(stream, 0, SEEK_END) == 0 && (length = ftell(stream)) >= 0 && fseek(stream, 0, SEEK_SET) == 0) {
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

static double at_speed(const Unit* unit, double t, double* slope) {
  const double* const in = unit->state.input;
  const double width = unit->to - unit->from;
  *slope = width > 0.0 ? (in[kMotorSpeed] - unit->state.before) / width : 0.0;
  return width > 0.0 ? unit->state.before + *slope * (t - unit->from) : in[kMotorSpeed];
}

/* Inputs hold over a step; a motor speed goes straight to its new value. */
static void inputs_at(void* self, double t, PrsInputs* inputs) {
  const Unit* const unit = (const Unit*)self;
  const double* const in = unit->state.input;
  inputs->slope = inputs->curve = 0.0;
  inputs->force = in[kExternalForce];
  inputs->motor = in[unit->drive.by == PRS_BY_TORQUE ? kMotorTorque : kReference];
  if (unit->drive.by == PRS_BY_SPEED) inputs->motor = at_speed(unit, t, &inputs->slope);
  if (unit->drive.by == PRS_POSITION_LOOP) inputs->slope = in[kReferenceSpeed];
}
static void bind_inputs(void* self, double t) { (void)self, (void)t; }
static double next_of_inputs(void* self, double t) {
  (void)self, (void)t;
  return HUGE_VAL;
}

static PrsSignals signals_of(Unit* unit) {
  PrsSignals signals;
  signals.self = unit;
  signals.bind = bind_inputs;
  signals.at = inputs_at;
  signals.next = next_of_inputs;
  return signals;
}

static void warn_once(Unit* unit, int beyond, int* warned, const char* message) {
  if (!beyond || *warned) return;
  *warned = 1;
  tell(&unit->callbacks, unit->name, fmi2Warning, message);
}

static void warn_of_curves(Unit* unit, const PrsView* view) {
  const PrsCurves* const c = &unit->curves;
  int beyond;
  double stiffness;
  prs_force(c, view->u, &stiffness, &beyond);
  warn_once(unit, beyond, &unit->warned_of_deflection,
            "force: beyond the computed range; it goes on in a straight line, and friction grows with it");
  warn_once(unit, c->speeds > 0 && fabs(view->omega) > c->speed[c->speeds - 1] * (1.0 + 1e-9), &unit->warned_of_torque,
            "screw_velocity: beyond the computed range; friction stays that of the largest speed");
}

static void take_values(Unit* unit) {
  double* const value = unit->state.value;
  double rate[PRS_STATES];
  PrsView view;
  prs_view(&unit->run, unit->run.state.t, unit->run.state.y, rate, &view);
  warn_of_curves(unit, &view);
  memcpy(value, unit->state.input, sizeof unit->state.input);
  if (unit->drive.by != PRS_BY_TORQUE) value[kMotorTorque] = view.motor_torque;
  value[kPosition] = view.x;
  value[kVelocity] = view.v;
  value[kDriveForce] = view.force;
  value[kDriveDeflection] = view.delta;
  value[kMotorAngle] = view.phi_m;
  value[kMotorVelocity] = view.omega_m;
  value[kScrewAngle] = view.phi;
  value[kScrewVelocity] = view.omega;
  value[kCouplingTorque] = view.coupling_torque;
  value[kAcceleration] = rate[PRS_V];
}

/* The drive at rest on its start, under the inputs as they are. */
static void start_drive(Unit* unit) {
  unit->from = unit->to = unit->time;
  prs_run_start(&unit->run, &unit->drive, signals_of(unit), unit->resolution);
  unit->run.state.t = unit->time;
  prs_dormand_prince_start(&unit->method, &unit->run, kTolerance);
  unit->state.before = unit->state.input[kMotorSpeed];
  take_values(unit);
  unit->state.drive = unit->run.state;
}

static void set_start(Unit* unit) {
  if (!unit->has_drive) return;
  unit->state.input[kMotorSpeed] = unit->drive.start_speed * 6.283185307179586476925287 / unit->drive.curves.lead;
  if (unit->drive.by == PRS_POSITION_LOOP) unit->state.input[kReference] = unit->drive.start_position;
}

/* NULL, or what is wrong. A unit without the file is one without a drive. */
static const char* load_drive(Unit* unit, const char* resources) {
  size_t size = 0;
  double* const numbers = (double*)(void*)content_of(resources, kDriveFile, &size);
  if (!numbers) return NULL;
  if (size != (PRS_DRIVE_NUMBERS + 1) * sizeof(double)) {
    free(numbers);
    return "resources/drive.bin is damaged; export the unit again";
  }
  prs_drive_numbers(&unit->drive, numbers, 0);
  unit->resolution = numbers[PRS_DRIVE_NUMBERS];
  unit->drive.curves = unit->curves;
  unit->has_drive = 1;
  free(numbers);
  set_start(unit);
  return NULL;
}

static fmi2Status step_drive(Unit* unit, double time, double step) {
  const PrsStepper stepper = prs_dormand_prince_stepper(&unit->method);
  int end;
  if (!unit->state.begun) {
    unit->time = time;
    start_drive(unit);
  } else if (!unit->run.drive) { /* The state is that of another unit. */
    const State taken = unit->state;
    start_drive(unit);
    unit->state = taken;
  }
  unit->state.begun = 1;
  unit->from = time;
  unit->to = time + step;
  unit->run.state = unit->state.drive;
  unit->run.steps_left = kMostSteps;
  end = prs_run_to(&unit->run, &stepper, NULL, unit->to);
  if (end == PRS_LEFT_SHAFT) return fail(unit, "the nut has left the shaft, or the lever is at a dead centre");
  if (end != PRS_DONE) return fail(unit, "the integration does not come through this step");
  unit->state.drive = unit->run.state;
  take_values(unit);
  unit->state.before = unit->state.input[kMotorSpeed];
  return fmi2OK;
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
  if (!unit->data || size % sizeof(double) != 0 || !prs_read_curves(unit->data, size / sizeof(double), &unit->curves))
    return "resources/curves.bin is missing or damaged; export the unit again";
  return load_drive(unit, resources);
}

static void forget(Unit* unit) {
  memset(&unit->state, 0, sizeof unit->state);
  set_start(unit);
  unit->time = 0.0;
  unit->warned_of_deflection = unit->warned_of_torque = 0;
}

static void evaluate(Unit* unit, double value[kVariables]) {
  int beyond;
  value[kDeflection] = unit->state.input[kDeflection];
  value[kSpeed] = unit->state.input[kSpeed];
  value[kForce] = prs_force(&unit->curves, value[kDeflection], &value[kStiffness], &beyond);
  warn_once(unit, beyond, &unit->warned_of_deflection,
            "deflection: beyond the computed range; the force goes on in a straight line");
  value[kTorque] = prs_torque(&unit->curves, value[kForce], value[kSpeed], &beyond);
  warn_once(unit, beyond, &unit->warned_of_torque,
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
(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions* callbacks,
 fmi2Boolean visible, fmi2Boolean logging) {
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
(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop, fmi2Real stop) {
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  ((Unit*)c)->time = start;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2EnterInitializationMode)(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2ExitInitializationMode)(fmi2Component c) {
  Unit* const unit = (Unit*)c;
  if (unit->has_drive) start_drive(unit);
  unit->state.begun = 1;
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
  double value[kDriveVariables];
  size_t k;
  if (unit->has_drive) {
    if (!unit->state.begun) start_drive(unit);
    memcpy(value, unit->state.value, sizeof value);
    memcpy(value, unit->state.input, sizeof unit->state.input);
    if (unit->drive.by != PRS_BY_TORQUE) value[kMotorTorque] = unit->state.value[kMotorTorque];
  } else {
    evaluate(unit, value);
  }
  for (k = 0; k < count; ++k) {
    if (references[k] >= (unit->has_drive ? kDriveVariables : kVariables)) return fail(unit, "unknown value reference");
    values[k] = value[references[k]];
  }
  return fmi2OK;
}

FMI2(fmi2Status, fmi2SetReal)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Real values[]) {
  Unit* const unit = (Unit*)c;
  size_t k;
  for (k = 0; k < count; ++k) {
    if (references[k] >= (unit->has_drive ? kDriveInputs : kInputs))
      return fail(unit, unit->has_drive ? "outputs cannot be set" : "only deflection and speed can be set");
    if (!isfinite(values[k]))
      return fail(unit, unit->has_drive                ? "an input is not a finite number"
                        : references[k] == kDeflection ? "deflection: not a finite number"
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
(fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns, const fmi2ValueReference known[], size_t knowns,
 const fmi2Real along[], fmi2Real derivative[]) {
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
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[], fmi2Real values[]) {
  (void)references, (void)count, (void)orders, (void)values;
  return fail((Unit*)c, "this unit gives no derivatives of outputs");
}

FMI2(fmi2Status, fmi2DoStep)
(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean is_no_state_before) {
  Unit* const unit = (Unit*)c;
  (void)is_no_state_before;
  if (!isfinite(time + step) || step < 0.0) return fail(unit, "doStep: expected a finite time and a step >= 0 s");
  if (unit->has_drive && step > 0.0) {
    const fmi2Status status = step_drive(unit, time, step);
    if (status != fmi2OK) return status;
  }
  unit->time = time + step;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2CancelStep)(fmi2Component c) { return fail((Unit*)c, "no step is under way"); }

/* There are no steps under way, whose status these would be. */
#define NO_STATUS(name, type)                                                       \
  FMI2(fmi2Status, name)(fmi2Component c, const fmi2StatusKind kind, type* value) { \
    (void)c, (void)kind, (void)value;                                               \
    return fmi2Discard;                                                             \
  }
NO_STATUS(fmi2GetStatus, fmi2Status)
NO_STATUS(fmi2GetIntegerStatus, fmi2Integer)
NO_STATUS(fmi2GetStringStatus, fmi2String)
FMI2(fmi2Status, fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = ((Unit*)c)->time;
  return fmi2OK;
}
FMI2(fmi2Status, fmi2GetBooleanStatus)
(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  (void)c;
  *value = 0;
  return fmi2OK;
}
