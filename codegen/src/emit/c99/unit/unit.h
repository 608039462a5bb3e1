#ifndef SCENE_UNIT_H
#define SCENE_UNIT_H

#include "scene.h"

#include <stddef.h>

/* Numbers of variables, continuous states and event indicators. */
#define SCENE_VARIABLES VARIABLE_COUNTu
#define SCENE_CONTINUOUS_STATES CONTINUOUS_COUNTu
#define SCENE_INDICATORS INDICATOR_COUNTu

/* Identifier of these sources, as in the model description. */
#define SCENE_TOKEN "TOKEN_TEXT"

/* Length of the longest message, with its end. */
#define SCENE_MESSAGE 160u

/* Status of a call, with the numbers that the standard gives them. */
enum { SCENE_OK = 0, SCENE_WARNING = 1, SCENE_DISCARD = 2, SCENE_ERROR = 3 };

/* Modes of the standard. Sums of them say where a call is allowed. */
enum {
    SCENE_IN_CREATION = 1,
    SCENE_IN_INITIALIZATION = 2,
    SCENE_IN_EVENT_MODE = 4,
    SCENE_IN_CONTINUOUS_TIME = 8,
    SCENE_IN_STEP_MODE = 16,
    SCENE_IN_TERMINATION = 32
};

/* All data of an instance. It has no pointers, so a copy of its bytes is a state of the FMU. */
typedef struct {
    scene_machine_t machine;
    int mode; /* one of the modes of the standard */
    int exchanges; /* 1 in Model Exchange, 0 in Co-Simulation */
    int is_started; /* whether the state is that of the start with the present parameters */
    int is_prepared; /* whether the constants are those of the present parameters */
    unsigned int known; /* which of the results below are those of the present state */
    double span; /* length of the experiment [s] */
    double tolerance; /* relative tolerance of the experiment */
    double step; /* largest step of Co-Simulation [s] */
    signed char is_set[SCENE_VARIABLES]; /* whether the host has set a start value */
    scene_state_t start; /* start values that the host has set */
#ifdef SCENE_DISCONTINUITIES
    double jumps[2]; /* times at which the rate jumps, before and after now [s] */
#endif
#ifdef SCENE_EVENTS
    double slack[SCENE_EVENTS]; /* how far guards are beyond zero after their event, by rounding */
#endif
#ifdef WHOLE
    double whole[SCENE_KINKS]; /* the integer below the argument of floor at the last event */
#endif
    scene_state_t rate;
#ifdef SCENE_OUTPUTS
    scene_outputs_t outputs;
#endif
    char message[SCENE_MESSAGE]; /* why the last call failed */
} scene_unit_t;

/* The functions below give a status. Those that fail say why in the message and change nothing
 * else. */

/* Begins an instance, or resets it. */
void scene_unit_begin(scene_unit_t *unit, int exchanges);

/* Refuses a call outside of some modes. */
int scene_unit_require(scene_unit_t *unit, int modes, const char *call);

/* Gets or sets a variable by its value reference. */
int scene_unit_get(scene_unit_t *unit, unsigned int reference, int is_integer, double *value);
int scene_unit_set(scene_unit_t *unit, unsigned int reference, int is_integer, double value);

/* Enters initialization mode. A tolerance of zero, or an end that is not after the start, stands
 * for that of the scene. */
int scene_unit_enter_initialization(scene_unit_t *unit, double tolerance, double from,
                                    double until);

/* Computes the start and leaves initialization mode. */
int scene_unit_exit_initialization(scene_unit_t *unit);

/* Makes what is due in event mode happen: whether continuous states have moved, and the next time
 * at which the rate jumps, HUGE_VAL for none. */
int scene_unit_update(scene_unit_t *unit, int *has_moved, double *next);

/* Looks at the state after a step of the host: whether event mode is needed. */
int scene_unit_step_is_complete(scene_unit_t *unit, int *asks_for_events);

/* Sets time or continuous states in continuous-time mode. */
int scene_unit_set_time(scene_unit_t *unit, double time);
int scene_unit_set_states(scene_unit_t *unit, const double *values, size_t count);

/* Gets continuous states, their rates, their typical sizes, or the event indicators. */
int scene_unit_states(scene_unit_t *unit, double *values, size_t count);
int scene_unit_derivatives(scene_unit_t *unit, double *values, size_t count);
int scene_unit_nominals(scene_unit_t *unit, double *values, size_t count);
int scene_unit_indicators(scene_unit_t *unit, double *values, size_t count);

/* Takes a communication step, by equal steps of the machine. */
int scene_unit_do_step(scene_unit_t *unit, double from, double size);

#endif /* SCENE_UNIT_H */
