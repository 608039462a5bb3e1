/* Adds share times the rate times the deviation of the time of the events at hand. */
static void shift_columns(struct carried *of, const scene_machine_t *machine, scene_real_t share)
{
    scene_state_t slope;
    scene_real_t rate[SCENE_STATES];
    size_t column, k;

    scene_rate(machine->time, &machine->state, &machine->p, &machine->c, &slope);
    numbers_of(&slope, rate);
    for (column = 0u; column < of->count; ++column) {
        const scene_real_t by = share * of->timing[column];
        for (k = 0u; k < SCENE_STATES; ++k) {
            of->columns[column][k] = of->columns[column][k] + by * rate[k];
        }
    }
}

/* The time of events deviates by dt = -dg/g'. Those at a known time (first = SCENE_EVENTS) do not
 * deviate. */
static void follow_before(struct carried *of, const scene_machine_t *machine, size_t first)
{
    scene_real_t rates[SCENE_EVENTS], values[SCENE_EVENTS], dp[SCENE_DIRECTIONS];
    size_t column;

    for (column = 0u; column < SCENE_COLUMNS; ++column) {
        of->timing[column] = R(0.0);
    }
    if (first == SCENE_EVENTS) {
        return;
    }
    scene_guard_rates(machine->time, &machine->state, &machine->p, &machine->c, rates);
    if (!((rates[first] < R(0.0)) || (R(0.0) < rates[first]))) {
        return;
    }
    for (column = 0u; column < of->count; ++column) {
        directions_of(of, column, dp);
        guards_along(machine->time, &machine->state, &machine->p, of->columns[column], dp, R(0.0),
                     values);
        of->timing[column] = -(values[first] / rates[first]);
    }
    shift_columns(of, machine, R(1.0));
}

/* An event resets the columns as it will reset the state. */
static void follow_reset(struct carried *of, const scene_machine_t *machine, size_t event)
{
    scene_real_t values[SCENE_RESETS], dp[SCENE_DIRECTIONS];
    size_t column;

    for (column = 0u; column < of->count; ++column) {
        scene_real_t *x = of->columns[column];
        directions_of(of, column, dp);
        resets_along(machine->time, &machine->state, &machine->p, x, dp, of->timing[column],
                     values);
        switch (event) {
RESET_CASES
        default:
            break;
        }
    }
}

static void follow_after(struct carried *of, const scene_machine_t *machine)
{
    size_t column;

    shift_columns(of, machine, R(-1.0));
    for (column = 0u; column < SCENE_COLUMNS; ++column) {
        of->timing[column] = R(0.0);
    }
}
