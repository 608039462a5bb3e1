#include "fmi2Functions.h"
#include "scene_unit.h"

#include <math.h>
#include <string.h>

/* Length of the longest name of an instance that is kept for messages, with its end. */
#define NAME_LENGTH 80u

/* An instance: the only memory that is allocated, besides states of the FMU. */
typedef struct {
    scene_unit_t unit;
    fmi2CallbackFunctions host;
    char name[NAME_LENGTH];
    /* Experiment that the host has set up. */
    double tolerance;
    double from;
    double until;
} instance_t;

/* A serialized state begins with the token of its sources. */
#define TOKEN_SIZE (sizeof(SCENE_TOKEN))

/* Tells the host of a call that failed. */
static fmi2Status told(const instance_t *instance, int status)
{
    if ((status != SCENE_OK) && (instance->host.logger != NULL)) {
        const char *category = (status == SCENE_DISCARD) ? "logStatusDiscard" : "logStatusError";
        instance->host.logger(instance->host.componentEnvironment, instance->name,
                              (fmi2Status)status, category, "%s", instance->unit.message);
    }
    return (fmi2Status)status;
}

static fmi2Status refuse(instance_t *instance, const char *message)
{
    if (instance == NULL) {
        return fmi2Error;
    }
    (void)strncpy(instance->unit.message, message, SCENE_MESSAGE - 1u);
    return told(instance, SCENE_ERROR);
}

/* Changes the mode of an instance. */
static fmi2Status enter(void *component, int from, int to, const char *call)
{
    instance_t *instance = (instance_t *)component;
    int status;

    if (instance == NULL) {
        return fmi2Error;
    }
    status = scene_unit_require(&instance->unit, from, call);
    if (status == SCENE_OK) {
        instance->unit.mode = to;
    }
    return told(instance, status);
}

/* Sets up the experiment of the scene. */
static void set_up(instance_t *instance)
{
    instance->tolerance = 0.0;
    instance->from = instance->unit.machine.time;
    instance->until = instance->from;
}

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return "2.0";
}

fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                              fmi2String fmuResourceLocation,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean loggingOn)
{
    instance_t *instance = NULL;

    (void)fmuResourceLocation;
    (void)visible;
    (void)loggingOn;
    if ((functions == NULL) || (functions->allocateMemory == NULL)
        || (functions->freeMemory == NULL)) {
        return NULL;
    }
    if ((fmuGUID != NULL) && (strcmp(fmuGUID, SCENE_TOKEN) == 0)) {
        instance = (instance_t *)functions->allocateMemory(1u, sizeof(*instance));
    }
    if (instance == NULL) {
        if (functions->logger != NULL) {
            functions->logger(functions->componentEnvironment, instanceName, fmi2Error,
                              "logStatusError",
                              "not instantiated: the GUID is of other sources, or there is no "
                              "memory");
        }
        return NULL;
    }
    memset(instance, 0, sizeof(*instance));
    scene_unit_begin(&instance->unit, (fmuType == fmi2ModelExchange) ? 1 : 0);
    instance->host = *functions;
    if (instanceName != NULL) {
        (void)strncpy(instance->name, instanceName, NAME_LENGTH - 1u);
    }
    set_up(instance);
    return instance;
}

void fmi2FreeInstance(fmi2Component c)
{
    if (c != NULL) {
        ((instance_t *)c)->host.freeMemory(c);
    }
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories,
                               const fmi2String categories[])
{
    /* Failures are always told; there is nothing else to tell. */
    (void)loggingOn;
    (void)nCategories;
    (void)categories;
    return (c != NULL) ? fmi2OK : fmi2Error;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                               fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    instance_t *self = (instance_t *)c;
    int status;

    if (self == NULL) {
        return fmi2Error;
    }
    status = scene_unit_require(&self->unit, SCENE_IN_CREATION, "fmi2SetupExperiment");
    if (status == SCENE_OK) {
        self->tolerance = (toleranceDefined != fmi2False) ? tolerance : 0.0;
        self->from = startTime;
        self->until = (stopTimeDefined != fmi2False) ? stopTime : startTime;
    }
    return told(self, status);
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    instance_t *self = (instance_t *)c;

    if (self == NULL) {
        return fmi2Error;
    }
    return told(self, scene_unit_enter_initialization(&self->unit, self->tolerance, self->from,
                                                      self->until));
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    instance_t *self = (instance_t *)c;
    return (self != NULL) ? told(self, scene_unit_exit_initialization(&self->unit)) : fmi2Error;
}

fmi2Status fmi2EnterEventMode(fmi2Component c)
{
    const int modes = SCENE_IN_CONTINUOUS_TIME;
    return enter(c, modes, SCENE_IN_EVENT_MODE, "fmi2EnterEventMode");
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c)
{
    const int modes = SCENE_IN_EVENT_MODE;
    return enter(c, modes, SCENE_IN_CONTINUOUS_TIME, "fmi2EnterContinuousTimeMode");
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    const int modes = SCENE_IN_EVENT_MODE + SCENE_IN_CONTINUOUS_TIME + SCENE_IN_STEP_MODE;
    return enter(c, modes, SCENE_IN_TERMINATION, "fmi2Terminate");
}

fmi2Status fmi2Reset(fmi2Component c)
{
    instance_t *self = (instance_t *)c;

    if (self == NULL) {
        return fmi2Error;
    }
    scene_unit_begin(&self->unit, self->unit.exchanges);
    set_up(self);
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *fmi2eventInfo)
{
    instance_t *self = (instance_t *)c;
    int status, has_moved;
    double next;

    if ((self == NULL) || (fmi2eventInfo == NULL)) {
        return fmi2Error;
    }
    status = scene_unit_update(&self->unit, &has_moved, &next);
    if (status == SCENE_OK) {
        fmi2eventInfo->newDiscreteStatesNeeded = fmi2False;
        fmi2eventInfo->terminateSimulation = fmi2False;
        fmi2eventInfo->nominalsOfContinuousStatesChanged = fmi2False;
        fmi2eventInfo->valuesOfContinuousStatesChanged = (has_moved != 0) ? fmi2True : fmi2False;
        fmi2eventInfo->nextEventTimeDefined = isfinite(next) ? fmi2True : fmi2False;
        fmi2eventInfo->nextEventTime = isfinite(next) ? next : 0.0;
    }
    return told(self, status);
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c,
                                       fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi2Boolean *enterEventMode,
                                       fmi2Boolean *terminateSimulation)
{
    instance_t *self = (instance_t *)c;
    int status, asks;

    (void)noSetFMUStatePriorToCurrentPoint;
    if (self == NULL) {
        return fmi2Error;
    }
    status = scene_unit_step_is_complete(&self->unit, &asks);
    if (status == SCENE_OK) {
        *enterEventMode = (asks != 0) ? fmi2True : fmi2False;
        *terminateSimulation = fmi2False;
    }
    return told(self, status);
}

fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time)
{
    instance_t *self = (instance_t *)c;
    return (self != NULL) ? told(self, scene_unit_set_time(&self->unit, time)) : fmi2Error;
}

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t nx)
{
    instance_t *self = (instance_t *)c;
    return (self != NULL) ? told(self, scene_unit_set_states(&self->unit, x, nx)) : fmi2Error;
}

/* Functions that fill an array of the Model Exchange interface. */
#define FILLS(function, fill)                                                                     \
    fmi2Status function(fmi2Component c, fmi2Real values[], size_t count)                         \
    {                                                                                             \
        instance_t *self = (instance_t *)c;                                                       \
        return (self != NULL) ? told(self, fill(&self->unit, values, count)) : fmi2Error;         \
    }

FILLS(fmi2GetContinuousStates, scene_unit_states)
FILLS(fmi2GetDerivatives, scene_unit_derivatives)
FILLS(fmi2GetNominalsOfContinuousStates, scene_unit_nominals)
FILLS(fmi2GetEventIndicators, scene_unit_indicators)

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real currentCommunicationPoint,
                      fmi2Real communicationStepSize, fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    instance_t *self = (instance_t *)c;
    const double from = currentCommunicationPoint;

    (void)noSetFMUStatePriorToCurrentPoint;
    if (self == NULL) {
        return fmi2Error;
    }
    return told(self, scene_unit_do_step(&self->unit, from, communicationStepSize));
}

fmi2Status fmi2CancelStep(fmi2Component c)
{
    return refuse((instance_t *)c, "steps are never pending");
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind s, fmi2Status *value)
{
    (void)s;
    (void)value;
    return refuse((instance_t *)c, "steps are never pending");
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
{
    instance_t *self = (instance_t *)c;

    if ((self == NULL) || (s != fmi2LastSuccessfulTime)) {
        return refuse(self, "there is no such status");
    }
    *value = self->unit.machine.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value)
{
    (void)s;
    (void)value;
    return refuse((instance_t *)c, "there is no such status");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value)
{
    if ((c == NULL) || (s != fmi2Terminated)) {
        return refuse((instance_t *)c, "there is no such status");
    }
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind s, fmi2String *value)
{
    (void)s;
    (void)value;
    return refuse((instance_t *)c, "steps are never pending");
}

/* Values of variables: all are of type Real, and modes of type Integer. */

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[])
{
    instance_t *self = (instance_t *)c;
    int status = SCENE_OK;
    size_t k;

    if (self == NULL) {
        return fmi2Error;
    }
    for (k = 0u; (status == SCENE_OK) && (k < nvr); ++k) {
        status = scene_unit_get(&self->unit, vr[k], 0, &value[k]);
    }
    return told(self, status);
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                       const fmi2Real value[])
{
    instance_t *self = (instance_t *)c;
    int status = SCENE_OK;
    size_t k;

    if (self == NULL) {
        return fmi2Error;
    }
    for (k = 0u; (status == SCENE_OK) && (k < nvr); ++k) {
        status = scene_unit_set(&self->unit, vr[k], 0, value[k]);
    }
    return told(self, status);
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                          fmi2Integer value[])
{
    instance_t *self = (instance_t *)c;
    int status = SCENE_OK;
    double number = 0.0;
    size_t k;

    if (self == NULL) {
        return fmi2Error;
    }
    for (k = 0u; (status == SCENE_OK) && (k < nvr); ++k) {
        status = scene_unit_get(&self->unit, vr[k], 1, &number);
        value[k] = (fmi2Integer)lround(number);
    }
    return told(self, status);
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                          const fmi2Integer value[])
{
    instance_t *self = (instance_t *)c;
    int status = SCENE_OK;
    size_t k;

    if (self == NULL) {
        return fmi2Error;
    }
    for (k = 0u; (status == SCENE_OK) && (k < nvr); ++k) {
        status = scene_unit_set(&self->unit, vr[k], 1, (double)value[k]);
    }
    return told(self, status);
}

/* States of the FMU: copies of the unit, which has no pointers. */

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    instance_t *self = (instance_t *)c;

    if ((self == NULL) || (FMUstate == NULL)) {
        return fmi2Error;
    }
    if (*FMUstate == NULL) {
        *FMUstate = self->host.allocateMemory(1u, sizeof(self->unit));
    }
    if (*FMUstate == NULL) {
        return refuse(self, "there is no memory for a state");
    }
    memcpy(*FMUstate, &self->unit, sizeof(self->unit));
    return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate)
{
    instance_t *self = (instance_t *)c;

    if ((self == NULL) || (FMUstate == NULL)) {
        return fmi2Error;
    }
    memcpy(&self->unit, FMUstate, sizeof(self->unit));
    return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    instance_t *self = (instance_t *)c;

    if (self == NULL) {
        return fmi2Error;
    }
    if ((FMUstate != NULL) && (*FMUstate != NULL)) {
        self->host.freeMemory(*FMUstate);
        *FMUstate = NULL;
    }
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    (void)FMUstate;
    *size = TOKEN_SIZE + sizeof(scene_unit_t);
    return (c != NULL) ? fmi2OK : fmi2Error;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate FMUstate,
                                 fmi2Byte serializedState[], size_t size)
{
    if ((c == NULL) || (FMUstate == NULL) || (size != TOKEN_SIZE + sizeof(scene_unit_t))) {
        return refuse((instance_t *)c, "the size is not that of a serialized state");
    }
    memcpy(serializedState, SCENE_TOKEN, TOKEN_SIZE);
    memcpy(serializedState + TOKEN_SIZE, FMUstate, sizeof(scene_unit_t));
    return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte serializedState[], size_t size,
                                   fmi2FMUstate *FMUstate)
{
    instance_t *self = (instance_t *)c;
    scene_unit_t *unit;

    if ((self == NULL) || (FMUstate == NULL) || (size != TOKEN_SIZE + sizeof(scene_unit_t))
        || (memcmp(serializedState, SCENE_TOKEN, TOKEN_SIZE) != 0)) {
        return refuse(self, "this is not a state of these sources");
    }
    unit = (scene_unit_t *)self->host.allocateMemory(1u, sizeof(*unit));
    if (unit == NULL) {
        return refuse(self, "there is no memory for a state");
    }
    memcpy(unit, serializedState + TOKEN_SIZE, sizeof(*unit));
    if (unit->exchanges != self->unit.exchanges) {
        self->host.freeMemory(unit);
        return refuse(self, "the state is of the other interface");
    }
    unit->message[SCENE_MESSAGE - 1u] = '\0';
    *FMUstate = unit;
    return fmi2OK;
}

/* Functions that the description does not offer. */

static fmi2Status none(fmi2Component c, size_t count)
{
    if ((c != NULL) && (count == 0u)) {
        return fmi2OK;
    }
    return refuse((instance_t *)c, "there are no such variables");
}

#define NONE_OF(Type)                                                                             \
    fmi2Status fmi2Get##Type(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,          \
                             fmi2##Type value[])                                                  \
    {                                                                                             \
        (void)vr;                                                                                 \
        (void)value;                                                                              \
        return none(c, nvr);                                                                      \
    }                                                                                             \
    fmi2Status fmi2Set##Type(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,          \
                             const fmi2##Type value[])                                            \
    {                                                                                             \
        (void)vr;                                                                                 \
        (void)value;                                                                              \
        return none(c, nvr);                                                                      \
    }

NONE_OF(Boolean)
NONE_OF(String)

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference vUnknown_ref[],
                                        size_t nUnknown, const fmi2ValueReference vKnown_ref[],
                                        size_t nKnown, const fmi2Real dvKnown[],
                                        fmi2Real dvUnknown[])
{
    (void)vUnknown_ref;
    (void)nUnknown;
    (void)vKnown_ref;
    (void)nKnown;
    (void)dvKnown;
    (void)dvUnknown;
    return refuse((instance_t *)c, "there are no derivatives of outputs");
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Integer order[], const fmi2Real value[])
{
    (void)vr;
    (void)nvr;
    (void)order;
    (void)value;
    return refuse((instance_t *)c, "inputs are not interpolated");
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                        const fmi2Integer order[], fmi2Real value[])
{
    (void)vr;
    (void)nvr;
    (void)order;
    (void)value;
    return refuse((instance_t *)c, "there are no derivatives of outputs");
}
