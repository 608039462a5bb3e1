#include "fmi3Functions.h"
#include "scene_unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An instance: the only memory that is allocated, besides states of the FMU. */
typedef struct {
    scene_unit_t unit;
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
} instance_t;

/* A serialized state begins with the token of its sources. */
#define TOKEN_SIZE (sizeof(SCENE_TOKEN))

/* Tells the host of a call that failed. */
static fmi3Status told(const instance_t *instance, int status)
{
    if ((status != SCENE_OK) && (instance->log != NULL)) {
        const char *category = (status == SCENE_DISCARD) ? "logStatusDiscard" : "logStatusError";
        instance->log(instance->environment, (fmi3Status)status, category, instance->unit.message);
    }
    return (fmi3Status)status;
}

static fmi3Status refuse(instance_t *instance, const char *message)
{
    if (instance == NULL) {
        return fmi3Error;
    }
    (void)strncpy(instance->unit.message, message, SCENE_MESSAGE - 1u);
    return told(instance, SCENE_ERROR);
}

/* Changes the mode of an instance. */
static fmi3Status enter(void *handle, int from, int to, const char *call)
{
    instance_t *instance = (instance_t *)handle;
    int status;

    if (instance == NULL) {
        return fmi3Error;
    }
    status = scene_unit_require(&instance->unit, from, call);
    if (status == SCENE_OK) {
        instance->unit.mode = to;
    }
    return told(instance, status);
}

static fmi3Instance instantiate(fmi3String token, fmi3InstanceEnvironment environment,
                                fmi3LogMessageCallback log, int exchanges)
{
    instance_t *instance = NULL;

    if ((token != NULL) && (strcmp(token, SCENE_TOKEN) == 0)) {
        instance = (instance_t *)calloc(1u, sizeof(*instance));
    }
    if (instance == NULL) {
        if (log != NULL) {
            log(environment, fmi3Error, "logStatusError",
                "not instantiated: the token is of other sources, or there is no memory");
        }
        return NULL;
    }
    scene_unit_begin(&instance->unit, exchanges);
    instance->environment = environment;
    instance->log = log;
    return instance;
}

const char *fmi3GetVersion(void)
{
    return "3.0";
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String instanceName, fmi3String instantiationToken,
                                          fmi3String resourcePath, fmi3Boolean visible,
                                          fmi3Boolean loggingOn,
                                          fmi3InstanceEnvironment instanceEnvironment,
                                          fmi3LogMessageCallback logMessage)
{
    (void)instanceName;
    (void)resourcePath;
    (void)visible;
    (void)loggingOn;
    return instantiate(instantiationToken, instanceEnvironment, logMessage, 1);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String instanceName, fmi3String instantiationToken,
                                         fmi3String resourcePath, fmi3Boolean visible,
                                         fmi3Boolean loggingOn, fmi3Boolean eventModeUsed,
                                         fmi3Boolean earlyReturnAllowed,
                                         const fmi3ValueReference requiredIntermediateVariables[],
                                         size_t nRequiredIntermediateVariables,
                                         fmi3InstanceEnvironment instanceEnvironment,
                                         fmi3LogMessageCallback logMessage,
                                         fmi3IntermediateUpdateCallback intermediateUpdate)
{
    (void)instanceName;
    (void)resourcePath;
    (void)visible;
    (void)loggingOn;
    (void)eventModeUsed;
    (void)earlyReturnAllowed;
    (void)requiredIntermediateVariables;
    (void)nRequiredIntermediateVariables;
    (void)intermediateUpdate;
    return instantiate(instantiationToken, instanceEnvironment, logMessage, 0);
}

fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath,
    fmi3Boolean visible, fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment,
    fmi3LogMessageCallback logMessage, fmi3ClockUpdateCallback clockUpdate,
    fmi3LockPreemptionCallback lockPreemption, fmi3UnlockPreemptionCallback unlockPreemption)
{
    (void)instanceName;
    (void)instantiationToken;
    (void)resourcePath;
    (void)visible;
    (void)loggingOn;
    (void)instanceEnvironment;
    (void)logMessage;
    (void)clockUpdate;
    (void)lockPreemption;
    (void)unlockPreemption;
    return NULL;
}

void fmi3FreeInstance(fmi3Instance instance)
{
    free(instance);
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories,
                               const fmi3String categories[])
{
    /* Failures are always told; there is nothing else to tell. */
    (void)loggingOn;
    (void)nCategories;
    (void)categories;
    return (instance != NULL) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean toleranceDefined,
                                       fmi3Float64 tolerance, fmi3Float64 startTime,
                                       fmi3Boolean stopTimeDefined, fmi3Float64 stopTime)
{
    instance_t *self = (instance_t *)instance;

    if (self == NULL) {
        return fmi3Error;
    }
    tolerance = toleranceDefined ? tolerance : 0.0;
    stopTime = stopTimeDefined ? stopTime : startTime;
    return told(self, scene_unit_enter_initialization(&self->unit, tolerance, startTime, stopTime));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
    instance_t *self = (instance_t *)instance;
    return (self != NULL) ? told(self, scene_unit_exit_initialization(&self->unit)) : fmi3Error;
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance)
{
    const int modes = SCENE_IN_CONTINUOUS_TIME;
    return enter(instance, modes, SCENE_IN_EVENT_MODE, "fmi3EnterEventMode");
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance)
{
    const int modes = SCENE_IN_EVENT_MODE;
    return enter(instance, modes, SCENE_IN_CONTINUOUS_TIME, "fmi3EnterContinuousTimeMode");
}

fmi3Status fmi3EnterStepMode(fmi3Instance instance)
{
    return refuse((instance_t *)instance, "there is no event mode in Co-Simulation to leave");
}

fmi3Status fmi3Terminate(fmi3Instance instance)
{
    const int modes = SCENE_IN_EVENT_MODE + SCENE_IN_CONTINUOUS_TIME + SCENE_IN_STEP_MODE;
    return enter(instance, modes, SCENE_IN_TERMINATION, "fmi3Terminate");
}

fmi3Status fmi3Reset(fmi3Instance instance)
{
    instance_t *self = (instance_t *)instance;

    if (self == NULL) {
        return fmi3Error;
    }
    scene_unit_begin(&self->unit, self->unit.exchanges);
    return fmi3OK;
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate,
                                    fmi3Boolean *terminateSimulation,
                                    fmi3Boolean *nominalsOfContinuousStatesChanged,
                                    fmi3Boolean *valuesOfContinuousStatesChanged,
                                    fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime)
{
    instance_t *self = (instance_t *)instance;
    int status, has_moved;
    double next;

    if (self == NULL) {
        return fmi3Error;
    }
    status = scene_unit_update(&self->unit, &has_moved, &next);
    if (status == SCENE_OK) {
        *discreteStatesNeedUpdate = fmi3False;
        *terminateSimulation = fmi3False;
        *nominalsOfContinuousStatesChanged = fmi3False;
        *valuesOfContinuousStatesChanged = (has_moved != 0);
        *nextEventTimeDefined = isfinite(next) ? fmi3True : fmi3False;
        *nextEventTime = isfinite(next) ? next : 0.0;
    }
    return told(self, status);
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance,
                                       fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi3Boolean *enterEventMode,
                                       fmi3Boolean *terminateSimulation)
{
    instance_t *self = (instance_t *)instance;
    int status, asks;

    (void)noSetFMUStatePriorToCurrentPoint;
    if (self == NULL) {
        return fmi3Error;
    }
    status = scene_unit_step_is_complete(&self->unit, &asks);
    if (status == SCENE_OK) {
        *enterEventMode = (asks != 0);
        *terminateSimulation = fmi3False;
    }
    return told(self, status);
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time)
{
    instance_t *self = (instance_t *)instance;
    return (self != NULL) ? told(self, scene_unit_set_time(&self->unit, time)) : fmi3Error;
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 continuousStates[],
                                   size_t nContinuousStates)
{
    instance_t *self = (instance_t *)instance;

    if (self == NULL) {
        return fmi3Error;
    }
    return told(self, scene_unit_set_states(&self->unit, continuousStates, nContinuousStates));
}

/* Functions that fill an array of the Model Exchange interface. */
#define FILLS(function, fill)                                                                     \
    fmi3Status function(fmi3Instance instance, fmi3Float64 values[], size_t count)                \
    {                                                                                             \
        instance_t *self = (instance_t *)instance;                                                \
        return (self != NULL) ? told(self, fill(&self->unit, values, count)) : fmi3Error;         \
    }

FILLS(fmi3GetContinuousStates, scene_unit_states)
FILLS(fmi3GetContinuousStateDerivatives, scene_unit_derivatives)
FILLS(fmi3GetNominalsOfContinuousStates, scene_unit_nominals)
FILLS(fmi3GetEventIndicators, scene_unit_indicators)

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *nEventIndicators)
{
    *nEventIndicators = SCENE_INDICATORS;
    return (instance != NULL) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *nContinuousStates)
{
    *nContinuousStates = SCENE_CONTINUOUS_STATES;
    return (instance != NULL) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
                      fmi3Float64 communicationStepSize,
                      fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                      fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
                      fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    instance_t *self = (instance_t *)instance;
    int status;

    (void)noSetFMUStatePriorToCurrentPoint;
    if (self == NULL) {
        return fmi3Error;
    }
    status = scene_unit_do_step(&self->unit, currentCommunicationPoint, communicationStepSize);
    *eventHandlingNeeded = fmi3False;
    *terminateSimulation = fmi3False;
    *earlyReturn = fmi3False;
    *lastSuccessfulTime = self->unit.machine.time;
    return told(self, status);
}

/* Values of variables: all are of type Float64, and modes of type Int32. */

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                          size_t nValueReferences, fmi3Float64 values[], size_t nValues)
{
    instance_t *self = (instance_t *)instance;
    int status = (nValues == nValueReferences) ? SCENE_OK : SCENE_ERROR;
    size_t k;

    if ((self == NULL) || (status != SCENE_OK)) {
        return refuse(self, "there are more or fewer values than references");
    }
    for (k = 0u; (status == SCENE_OK) && (k < nValueReferences); ++k) {
        status = scene_unit_get(&self->unit, valueReferences[k], 0, &values[k]);
    }
    return told(self, status);
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                          size_t nValueReferences, const fmi3Float64 values[], size_t nValues)
{
    instance_t *self = (instance_t *)instance;
    int status = (nValues == nValueReferences) ? SCENE_OK : SCENE_ERROR;
    size_t k;

    if ((self == NULL) || (status != SCENE_OK)) {
        return refuse(self, "there are more or fewer values than references");
    }
    for (k = 0u; (status == SCENE_OK) && (k < nValueReferences); ++k) {
        status = scene_unit_set(&self->unit, valueReferences[k], 0, values[k]);
    }
    return told(self, status);
}

fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                        size_t nValueReferences, fmi3Int32 values[], size_t nValues)
{
    instance_t *self = (instance_t *)instance;
    int status = (nValues == nValueReferences) ? SCENE_OK : SCENE_ERROR;
    double value = 0.0;
    size_t k;

    if ((self == NULL) || (status != SCENE_OK)) {
        return refuse(self, "there are more or fewer values than references");
    }
    for (k = 0u; (status == SCENE_OK) && (k < nValueReferences); ++k) {
        status = scene_unit_get(&self->unit, valueReferences[k], 1, &value);
        values[k] = (fmi3Int32)lround(value);
    }
    return told(self, status);
}

fmi3Status fmi3SetInt32(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                        size_t nValueReferences, const fmi3Int32 values[], size_t nValues)
{
    instance_t *self = (instance_t *)instance;
    int status = (nValues == nValueReferences) ? SCENE_OK : SCENE_ERROR;
    size_t k;

    if ((self == NULL) || (status != SCENE_OK)) {
        return refuse(self, "there are more or fewer values than references");
    }
    for (k = 0u; (status == SCENE_OK) && (k < nValueReferences); ++k) {
        status = scene_unit_set(&self->unit, valueReferences[k], 1, (double)values[k]);
    }
    return told(self, status);
}

/* States of the FMU: copies of the unit, which has no pointers. */

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    instance_t *self = (instance_t *)instance;

    if ((self == NULL) || (FMUState == NULL)) {
        return fmi3Error;
    }
    if (*FMUState == NULL) {
        *FMUState = malloc(sizeof(self->unit));
    }
    if (*FMUState == NULL) {
        return refuse(self, "there is no memory for a state");
    }
    memcpy(*FMUState, &self->unit, sizeof(self->unit));
    return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState FMUState)
{
    instance_t *self = (instance_t *)instance;

    if ((self == NULL) || (FMUState == NULL)) {
        return fmi3Error;
    }
    memcpy(&self->unit, FMUState, sizeof(self->unit));
    return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    if (FMUState != NULL) {
        free(*FMUState);
        *FMUState = NULL;
    }
    return (instance != NULL) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState FMUState, size_t *size)
{
    (void)FMUState;
    *size = TOKEN_SIZE + sizeof(scene_unit_t);
    return (instance != NULL) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState FMUState,
                                 fmi3Byte serializedState[], size_t size)
{
    if ((instance == NULL) || (FMUState == NULL) || (size != TOKEN_SIZE + sizeof(scene_unit_t))) {
        return refuse((instance_t *)instance, "the size is not that of a serialized state");
    }
    memcpy(serializedState, SCENE_TOKEN, TOKEN_SIZE);
    memcpy(serializedState + TOKEN_SIZE, FMUState, sizeof(scene_unit_t));
    return fmi3OK;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte serializedState[],
                                   size_t size, fmi3FMUState *FMUState)
{
    instance_t *self = (instance_t *)instance;
    scene_unit_t *unit;

    if ((self == NULL) || (FMUState == NULL) || (size != TOKEN_SIZE + sizeof(scene_unit_t))
        || (memcmp(serializedState, SCENE_TOKEN, TOKEN_SIZE) != 0)) {
        return refuse(self, "this is not a state of these sources");
    }
    unit = (scene_unit_t *)malloc(sizeof(*unit));
    if (unit == NULL) {
        return refuse(self, "there is no memory for a state");
    }
    memcpy(unit, serializedState + TOKEN_SIZE, sizeof(*unit));
    if (unit->exchanges != self->unit.exchanges) {
        free(unit);
        return refuse(self, "the state is of the other interface");
    }
    unit->message[SCENE_MESSAGE - 1u] = '\0';
    *FMUState = unit;
    return fmi3OK;
}
