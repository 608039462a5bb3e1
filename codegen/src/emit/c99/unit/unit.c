#include "scene_unit.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* Kinds of variables. */
enum { TIME, STATE, DERIVATIVE, MODE, PARAMETER, OUTPUT, INDICATOR, STEP };

/* In which modes the host may set a variable. */
enum {
    NEVER = 0,
    GUESS = SCENE_IN_CREATION,
    FIXED = SCENE_IN_CREATION + SCENE_IN_INITIALIZATION,
    TUNABLE = FIXED + SCENE_IN_EVENT_MODE + SCENE_IN_STEP_MODE,
    INPUT = TUNABLE + SCENE_IN_CONTINUOUS_TIME
};

struct variable {
    const char *name;
    int kind;
    int settable;
    size_t place; /* within the struct of its kind [bytes]; of an indicator, its number */
};

/* All variables, by value reference. */
static const struct variable variables[SCENE_VARIABLES] = {
VARIABLE_ROWS
};

/* Places of the continuous states within the state, and their typical sizes. */
static const size_t state_places[SCENE_CONTINUOUS_STATES] = {
STATE_ROWS
};
static const double nominals[SCENE_CONTINUOUS_STATES] = {
NOMINAL_ROWS
};

#ifdef WHOLE
/* Which kinks are of floor: they are at every integer. */
static const signed char is_whole[SCENE_KINKS] = {
WHOLE_ROWS
};

#endif
/* Results that are kept until something changes. */
enum { RATE_IS_KNOWN = 1, OUTPUTS_ARE_KNOWN = 2 };

/* Most steps of a communication step. */
static const double most_steps = 1e9;

static double number(const void *record, size_t place)
{
    double value;

    memcpy(&value, (const char *)record + place, sizeof(value));
    return value;
}

static void put(void *record, size_t place, double value)
{
    memcpy((char *)record + place, &value, sizeof(value));
}

static int fail(scene_unit_t *unit, int status, const char *name, const char *what)
{
    (void)snprintf(unit->message, sizeof(unit->message), "%s %s", name, what);
    return status;
}

int scene_unit_require(scene_unit_t *unit, int modes, const char *call)
{
    const int is_allowed = (unit->mode & modes) != 0;
    return is_allowed ? SCENE_OK : fail(unit, SCENE_ERROR, call, "is not allowed in this mode");
}

static int require_count(scene_unit_t *unit, size_t expected, size_t count)
{
    const char *what = "than there are variables";
    return (count == expected) ? SCENE_OK
                               : fail(unit, SCENE_ERROR, "there are more or fewer values", what);
}

void scene_unit_begin(scene_unit_t *unit, int exchanges)
{
    memset(unit, 0, sizeof(*unit));
    scene_begin(&unit->machine);
    unit->mode = SCENE_IN_CREATION;
    unit->exchanges = exchanges;
    unit->is_prepared = 1;
    unit->span = DEFAULT_SPAN;
    unit->tolerance = DEFAULT_TOLERANCE;
    unit->step = DEFAULT_STEP;
}

/* The time moved into the piece between jumps of the rate: at a jump itself, a host wants the rate
 * before it until the jump has been passed in event mode. */
static double time_of(const scene_unit_t *unit)
{
#ifdef SCENE_DISCONTINUITIES
    const double first = unit->jumps[0] + 4.0 * DBL_EPSILON * fabs(unit->jumps[0]);
    const double last = unit->jumps[1] - 4.0 * DBL_EPSILON * fabs(unit->jumps[1]);
    const double before = fmin(last, nextafter(unit->jumps[1], -HUGE_VAL));
    const double time = fmin(unit->machine.time, before);

    return (unit->exchanges != 0) ? fmax(time, first) : unit->machine.time;
#else
    return unit->machine.time;
#endif
}

static void prepare(scene_unit_t *unit)
{
    if (unit->is_prepared == 0) {
        scene_prepare(&unit->machine.p, &unit->machine.c);
        unit->is_prepared = 1;
    }
}

#ifdef SCENE_DISCONTINUITIES
/* Finds the jumps of the rate before and after now. One that is nearer than rounding has passed. */
static void find_jumps(scene_unit_t *unit)
{
    const double now = unit->machine.time + 512.0 * DBL_EPSILON * fabs(unit->machine.time);
    double times[SCENE_DISCONTINUITIES];
    size_t k;

    unit->jumps[0] = -DBL_MAX;
    unit->jumps[1] = DBL_MAX;
    scene_discontinuities(&unit->machine.p, times);
    for (k = 0u; k < SCENE_DISCONTINUITIES; ++k) {
        if (now < times[k]) {
            unit->jumps[1] = fmin(unit->jumps[1], times[k]);
        } else {
            unit->jumps[0] = fmax(unit->jumps[0], times[k]);
        }
    }
}

#endif
#ifdef SCENE_EVENTS
/* Error of the time at which a host finds the zero of a guard [s]. */
static double nearness(const scene_unit_t *unit)
{
    return 1e-9 * (fabs(unit->machine.time) + unit->span);
}

/* Guards as the host sees them. One that is beyond zero by rounding after its event is shifted to
 * the side that it leaves to, so that no short contact is missed. */
static void shifted_guards(const scene_unit_t *unit, double guards[SCENE_EVENTS])
{
    const scene_machine_t *machine = &unit->machine;
    size_t event;

    scene_guards(time_of(unit), &machine->state, &machine->p, &machine->c, guards);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        guards[event] = guards[event] + (double)machine->side[event] * unit->slack[event];
    }
}

/* Changes of guards by rounding of time and state: the change by a small relative shift of each,
 * scaled to 64 roundings. */
static void find_noise(const scene_unit_t *unit, double noise[SCENE_EVENTS])
{
    const double shift = 1.0 / 1048576.0;
    const double scale = 64.0 * DBL_EPSILON / shift;
    const scene_machine_t *machine = &unit->machine;
    double guards[SCENE_EVENTS], shifted[SCENE_EVENTS];
    size_t event, k;

    scene_guards(time_of(unit), &machine->state, &machine->p, &machine->c, guards);
    scene_guards(time_of(unit) * (1.0 + shift), &machine->state, &machine->p, &machine->c, shifted);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        noise[event] = scale * fabs(shifted[event] - guards[event]);
    }
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        scene_state_t state = machine->state;
        put(&state, state_places[k], number(&state, state_places[k]) * (1.0 + shift));
        scene_guards(time_of(unit), &state, &machine->p, &machine->c, shifted);
        for (event = 0u; event < SCENE_EVENTS; ++event) {
            noise[event] = noise[event] + scale * fabs(shifted[event] - guards[event]);
        }
    }
}

/* Sees which guards are at zero or on its wrong side by rounding after events. */
static void find_slack(scene_unit_t *unit)
{
    double guards[SCENE_EVENTS], noise[SCENE_EVENTS];
    size_t event;

    for (event = 0u; event < SCENE_EVENTS; ++event) {
        unit->slack[event] = 0.0;
    }
    shifted_guards(unit, guards);
    find_noise(unit, noise);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        const double inside = (double)unit->machine.side[event] * guards[event];
        if (inside < noise[event]) {
            unit->slack[event] = fmax(noise[event], -2.0 * inside);
        }
    }
}

#endif
#ifdef WHOLE
/* Sees between which integers the arguments of floor are. */
static void find_whole(scene_unit_t *unit)
{
    const scene_machine_t *machine = &unit->machine;
    double guards[SCENE_KINKS];
    size_t kink;

    scene_kink_guards(time_of(unit), &machine->state, &machine->p, &machine->c, guards);
    for (kink = 0u; kink < SCENE_KINKS; ++kink) {
        unit->whole[kink] = (is_whole[kink] != 0) ? floor(guards[kink]) : 0.0;
    }
}

#endif
/* Looks at everything that changes only at events. */
static void look(scene_unit_t *unit)
{
#ifdef SCENE_EVENTS
    find_slack(unit);
#endif
#ifdef WHOLE
    find_whole(unit);
#endif
    unit->known = 0u;
}

/* Puts the state to the start: that of the spec's values, with what the host has set. */
static void start(scene_unit_t *unit)
{
    size_t k;
#ifdef STARTS_ELSEWHERE
    scene_machine_t spec;
    scene_state_t before, after;
#endif

    if (unit->is_started != 0) {
        return;
    }
    prepare(unit);
#ifdef STARTS_ELSEWHERE
    /* The state in which the scene's own run starts, moved by as much as initial values move with
     * the parameters. */
    scene_begin(&spec);
    scene_initial_state(&spec.p, &before);
    scene_initial_state(&unit->machine.p, &after);
    unit->machine.state = spec.state;
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        const double shift = number(&after, state_places[k]) - number(&before, state_places[k]);
        put(&unit->machine.state, state_places[k], number(&spec.state, state_places[k]) + shift);
    }
#else
    scene_initial_state(&unit->machine.p, &unit->machine.state);
#endif
    for (k = 0u; k < SCENE_VARIABLES; ++k) {
        if (((variables[k].kind == STATE) || (variables[k].kind == MODE))
            && (unit->is_set[k] != 0)) {
            put(&unit->machine.state, variables[k].place,
                number(&unit->start, variables[k].place));
        }
    }
#ifdef SCENE_DISCONTINUITIES
    find_jumps(unit);
#endif
#ifdef SCENE_CONSTRAINTS
    scene_project_start(&unit->machine);
#endif
#ifdef SCENE_EVENTS
    scene_settle(&unit->machine);
#endif
    look(unit);
    unit->is_started = 1;
}

static void know_rate(scene_unit_t *unit)
{
    const scene_machine_t *machine = &unit->machine;

    if ((unit->known & RATE_IS_KNOWN) == 0u) {
        scene_rate(time_of(unit), &machine->state, &machine->p, &machine->c, &unit->rate);
        unit->known |= RATE_IS_KNOWN;
    }
}

#ifdef SCENE_OUTPUTS
static void know_outputs(scene_unit_t *unit)
{
    const scene_machine_t *machine = &unit->machine;

    if ((unit->known & OUTPUTS_ARE_KNOWN) == 0u) {
        scene_outputs(time_of(unit), &machine->state, &machine->p, &machine->c, &unit->outputs);
        unit->known |= OUTPUTS_ARE_KNOWN;
    }
}

#endif
/* Computes all event indicators: of events, then of kinks. */
static void indicate(const scene_unit_t *unit, double *values)
{
#ifdef SCENE_EVENTS
    double guards[SCENE_EVENTS];
#endif
#ifdef SCENE_KINKS
    const scene_machine_t *machine = &unit->machine;
    double kinks[SCENE_KINKS];
#endif
#ifdef SOME_INDICATORS
    size_t k;
#endif

#ifdef SCENE_EVENTS
    shifted_guards(unit, guards);
    for (k = 0u; k < SCENE_EVENTS; ++k) {
        const int is_watched = scene_is_watched((unsigned int)k, &unit->machine.state);
        *values = (is_watched != 0) ? guards[k] : 1.0;
        ++values;
    }
#endif
#ifdef SCENE_KINKS
    scene_kink_guards(time_of(unit), &machine->state, &machine->p, &machine->c, kinks);
    for (k = 0u; k < SCENE_KINKS; ++k) {
#ifdef WHOLE
        /* The product of the distances to both integers: positive between them. */
        const double above = kinks[k] - unit->whole[k];
        *values = (is_whole[k] != 0) ? above * (1.0 - above) : kinks[k];
#else
        *values = kinks[k];
#endif
        ++values;
    }
#endif
#ifdef NO_INDICATORS
    (void)unit;
    (void)values;
#endif
}

static const struct variable *find(scene_unit_t *unit, unsigned int reference, int is_integer)
{
    if ((reference < SCENE_VARIABLES)
        && ((variables[reference].kind == MODE) == (is_integer != 0))) {
        return &variables[reference];
    }
    (void)fail(unit, SCENE_ERROR, "a value reference", "stands for no variable of this type");
    return NULL;
}

int scene_unit_get(scene_unit_t *unit, unsigned int reference, int is_integer, double *value)
{
    const struct variable *variable = find(unit, reference, is_integer);
    const int modes = ~SCENE_IN_CREATION;
#ifdef SOME_INDICATORS
    double indicators[SCENE_INDICATORS];
#endif

    if (variable == NULL) {
        return SCENE_ERROR;
    }
    if (scene_unit_require(unit, modes, "reading values") != SCENE_OK) {
        return SCENE_ERROR;
    }
    start(unit);
    prepare(unit);
    switch (variable->kind) {
    case TIME:
        *value = unit->machine.time;
        break;
    case STATE:
    case MODE:
        *value = number(&unit->machine.state, variable->place);
        break;
    case DERIVATIVE:
        know_rate(unit);
        *value = number(&unit->rate, variable->place);
        break;
    case PARAMETER:
        *value = number(&unit->machine.p, variable->place);
        break;
#ifdef SCENE_OUTPUTS
    case OUTPUT:
        know_outputs(unit);
        *value = number(&unit->outputs, variable->place);
        break;
#endif
#ifdef SOME_INDICATORS
    case INDICATOR:
        indicate(unit, indicators);
        *value = indicators[variable->place];
        break;
#endif
    default:
        *value = unit->step;
        break;
    }
    return SCENE_OK;
}

int scene_unit_set(scene_unit_t *unit, unsigned int reference, int is_integer, double value)
{
    const struct variable *variable = find(unit, reference, is_integer);

    if (variable == NULL) {
        return SCENE_ERROR;
    }
    if ((variable->settable & unit->mode) == 0) {
        return fail(unit, SCENE_ERROR, variable->name, "cannot be set in this mode");
    }
    if (!isfinite(value)) {
        return fail(unit, SCENE_ERROR, variable->name, "must be finite");
    }
    switch (variable->kind) {
    case STATE:
    case MODE:
        put(&unit->start, variable->place, value);
        unit->is_set[reference] = 1;
        break;
    case PARAMETER:
        put(&unit->machine.p, variable->place, value);
        unit->is_prepared = 0;
        break;
    default:
        if (!(0.0 < value)) {
            return fail(unit, SCENE_ERROR, variable->name, "must be above zero");
        }
        unit->step = value;
        break;
    }
    if ((unit->mode & FIXED) != 0) {
        unit->is_started = 0;
    }
    unit->known = 0u;
    return SCENE_OK;
}
