int scene_unit_enter_initialization(scene_unit_t *unit, double tolerance, double from,
                                    double until)
{
    const int status = scene_unit_require(unit, SCENE_IN_CREATION, "initialization mode");

    if (status != SCENE_OK) {
        return status;
    }
    if (!isfinite(from) || (tolerance < 0.0) || (1.0 < tolerance)) {
        return fail(unit, SCENE_ERROR, "start time and tolerance", "are out of range");
    }
    unit->machine.time = from;
    unit->machine.time_rest = 0.0;
    unit->span = (from < until) ? until - from : unit->span;
    unit->tolerance = (0.0 < tolerance) ? tolerance : unit->tolerance;
    unit->mode = SCENE_IN_INITIALIZATION;
    unit->is_started = 0;
    return SCENE_OK;
}

int scene_unit_exit_initialization(scene_unit_t *unit)
{
    const int mode = SCENE_IN_INITIALIZATION;
    const int status = scene_unit_require(unit, mode, "leaving initialization mode");
    size_t k;

    if (status != SCENE_OK) {
        return status;
    }
    start(unit);
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        if (!isfinite(number(&unit->machine.state, state_places[k]))) {
            return fail(unit, SCENE_ERROR, "the state at the start", "is not finite");
        }
    }
    unit->mode = (unit->exchanges != 0) ? SCENE_IN_EVENT_MODE : SCENE_IN_STEP_MODE;
    return SCENE_OK;
}

int scene_unit_update(scene_unit_t *unit, int *has_moved, double *next)
{
    const int status = scene_unit_require(unit, SCENE_IN_EVENT_MODE, "an update");
    const scene_state_t before = unit->machine.state;
    size_t k;
#ifdef SCENE_EVENTS
    double guards[SCENE_EVENTS];
    double now;
#endif
#ifdef FRICTION_JUMPS
    double jumped;
#endif

    if (status != SCENE_OK) {
        return status;
    }
    prepare(unit);
#ifdef FRICTION_JUMPS
    jumped = unit->jumps[0];
#endif
#ifdef SCENE_DISCONTINUITIES
    find_jumps(unit);
#endif
#ifdef FRICTION_JUMPS
    if (jumped < unit->jumps[0]) {
        scene_reopen_frictions(&unit->machine.state);
    }
#endif
#ifdef SCENE_CONSTRAINTS
    scene_project(&unit->machine);
#endif
#ifdef SCENE_EVENTS
    now = unit->machine.time;
    unit->machine.time = time_of(unit);
    shifted_guards(unit, guards);
    (void)scene_happen(&unit->machine, guards, nearness(unit));
    unit->machine.time = now;
#endif
    look(unit);
    *has_moved = 0;
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        const double was = number(&before, state_places[k]);
        *has_moved |= (number(&unit->machine.state, state_places[k]) != was) ? 1 : 0;
    }
#ifdef SCENE_DISCONTINUITIES
    *next = (unit->jumps[1] < DBL_MAX) ? unit->jumps[1] : HUGE_VAL;
#else
    *next = HUGE_VAL;
#endif
    return SCENE_OK;
}

#ifdef SCENE_CONSTRAINTS
/* Distance of the state from the constraints: the shift that puts it back, relative to the typical
 * sizes of states. */
static double off_constraints(const scene_unit_t *unit)
{
    scene_machine_t machine = unit->machine;
    double most = 0.0;
    size_t k;

    scene_project(&machine);
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        const double there = number(&machine.state, state_places[k]);
        const double here = number(&unit->machine.state, state_places[k]);
        most = fmax(most, fabs(there - here) / nominals[k]);
    }
    return most;
}

#endif
int scene_unit_step_is_complete(scene_unit_t *unit, int *asks_for_events)
{
    const int status = scene_unit_require(unit, SCENE_IN_CONTINUOUS_TIME, "a completed step");
#ifdef SCENE_EVENTS
    double guards[SCENE_EVENTS];
#endif

    if (status != SCENE_OK) {
        return status;
    }
    *asks_for_events = 0;
#ifdef SCENE_EVENTS
    prepare(unit);
    shifted_guards(unit, guards);
    if (scene_is_due(&unit->machine, guards) != 0) {
        *asks_for_events = 1;
    } else {
        scene_follow(&unit->machine, guards);
    }
#endif
#ifdef SCENE_CONSTRAINTS
    prepare(unit);
    if (unit->tolerance < off_constraints(unit)) {
        *asks_for_events = 1;
    }
#endif
    return SCENE_OK;
}

int scene_unit_set_time(scene_unit_t *unit, double time)
{
    const int modes = SCENE_IN_CONTINUOUS_TIME + SCENE_IN_EVENT_MODE;
    const int status = scene_unit_require(unit, modes, "setting the time");

    if (status != SCENE_OK) {
        return status;
    }
    if (!isfinite(time)) {
        return fail(unit, SCENE_ERROR, "the time", "must be finite");
    }
    unit->machine.time = time;
    unit->known = 0u;
    return SCENE_OK;
}

int scene_unit_set_states(scene_unit_t *unit, const double *values, size_t count)
{
    const int modes = SCENE_IN_CONTINUOUS_TIME;
    size_t k;

    if ((scene_unit_require(unit, modes, "setting states") != SCENE_OK)
        || (require_count(unit, SCENE_CONTINUOUS_STATES, count) != SCENE_OK)) {
        return SCENE_ERROR;
    }
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        if (!isfinite(values[k])) {
            return fail(unit, SCENE_DISCARD, "a continuous state", "is not finite");
        }
    }
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        put(&unit->machine.state, state_places[k], values[k]);
    }
    unit->known = 0u;
    return SCENE_OK;
}

/* Refuses what only belongs to a run by Model Exchange, and computes the start if it is missing. */
static int exchange(scene_unit_t *unit, size_t expected, size_t count)
{
    const int modes = ~(SCENE_IN_CREATION + SCENE_IN_STEP_MODE);

    if ((scene_unit_require(unit, modes, "Model Exchange") != SCENE_OK)
        || (require_count(unit, expected, count) != SCENE_OK)) {
        return SCENE_ERROR;
    }
    start(unit);
    prepare(unit);
    return SCENE_OK;
}

int scene_unit_states(scene_unit_t *unit, double *values, size_t count)
{
    const int status = exchange(unit, SCENE_CONTINUOUS_STATES, count);
    size_t k;

    for (k = 0u; (status == SCENE_OK) && (k < SCENE_CONTINUOUS_STATES); ++k) {
        values[k] = number(&unit->machine.state, state_places[k]);
    }
    return status;
}

int scene_unit_derivatives(scene_unit_t *unit, double *values, size_t count)
{
    const int status = exchange(unit, SCENE_CONTINUOUS_STATES, count);
    size_t k;

    if (status != SCENE_OK) {
        return status;
    }
    know_rate(unit);
    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        values[k] = number(&unit->rate, state_places[k]);
        if (!isfinite(values[k])) {
            return fail(unit, SCENE_DISCARD, "the rate of a state", "is not finite");
        }
    }
    return SCENE_OK;
}

int scene_unit_nominals(scene_unit_t *unit, double *values, size_t count)
{
    const int status = exchange(unit, SCENE_CONTINUOUS_STATES, count);
    size_t k;

    for (k = 0u; (status == SCENE_OK) && (k < SCENE_CONTINUOUS_STATES); ++k) {
        values[k] = nominals[k];
    }
    return status;
}

int scene_unit_indicators(scene_unit_t *unit, double *values, size_t count)
{
    const int status = exchange(unit, SCENE_INDICATORS, count);

    if (status == SCENE_OK) {
        indicate(unit, values);
    }
    return status;
}

/* Gives whether the state is finite. */
static int is_finite(const scene_state_t *state)
{
    size_t k;
    int finite = 1;

    for (k = 0u; k < SCENE_CONTINUOUS_STATES; ++k) {
        finite = isfinite(number(state, state_places[k])) ? finite : 0;
    }
    return finite;
}

int scene_unit_do_step(scene_unit_t *unit, double from, double size)
{
    const int status = scene_unit_require(unit, SCENE_IN_STEP_MODE, "a communication step");
    const scene_machine_t before = unit->machine;
    const double off = fabs(from - unit->machine.time);
    const double until = from + size;
    /* A step that fits up to rounding is not shortened. */
    const double steps = fmax(1.0, ceil(size / unit->step * (1.0 - 1e-9)));
    unsigned long step;
    int is_crowded = 0;

    if (status != SCENE_OK) {
        return status;
    }
    if (!(0.0 < size) || !isfinite(until) || !(unit->machine.time < until)
        || !(off <= 1e-6 * fmax(size, 1e-9 * fabs(from)))) {
        return fail(unit, SCENE_ERROR, "a communication step", "must go on from the last one");
    }
    if (!(steps <= most_steps)) {
        return fail(unit, SCENE_ERROR, "a communication step", "takes more than 1e9 steps");
    }
    prepare(unit);
    unit->known = 0u;
    for (step = 0u; step < (unsigned long)steps; ++step) {
        is_crowded |= (scene_step(&unit->machine, size / steps) < 0) ? 1 : 0;
        if (is_finite(&unit->machine.state) == 0) {
            unit->machine = before;
            return fail(unit, SCENE_DISCARD, "the state", "is not finite: take smaller steps");
        }
    }
    unit->machine.time = until;
    unit->machine.time_rest = 0.0;
    if (is_crowded != 0) {
        return fail(unit, SCENE_WARNING, "a step", "has more events than it may have");
    }
    return SCENE_OK;
}
