/* What a co-simulation slave needs of the Functional Mock-up Interface 2.0 (fmi-standard.org):
   types and names are those of the standard. With FMI2_FUNCTION_PREFIX defined, for linking several
   units into one program, each function has that prefix. */
#ifndef PRS_FMI2_H
#define PRS_FMI2_H

#include <stddef.h>

#if defined(FMI2_FUNCTION_PREFIX)
#define PRS_PASTE(a, b) a##b
#define PRS_PREFIXED(prefix, name) PRS_PASTE(prefix, name)
#define FMI2(type, name) type PRS_PREFIXED(FMI2_FUNCTION_PREFIX, name)
#elif defined(_WIN32) || defined(__CYGWIN__)
#define FMI2(type, name) __declspec(dllexport) type name
#elif defined(__GNUC__)
#define FMI2(type, name) __attribute__((visibility("default"))) type name
#else
#define FMI2(type, name) type name
#endif

typedef void* fmi2Component;
typedef void* fmi2ComponentEnvironment;
typedef void* fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char* fmi2String;
typedef char fmi2Byte;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

typedef struct {
  void (*logger)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category, fmi2String message,
                 ...);
  void* (*allocateMemory)(size_t count, size_t size);
  void (*freeMemory)(void*);
  void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

#endif
