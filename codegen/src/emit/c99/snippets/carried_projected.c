
/* Puts the columns onto the constraints, first in position, then in velocity. */
static void follow_projected(struct carried *of, scene_real_t time, const scene_state_t *state,
                             const scene_parameters_t *p, const scene_constants_t *c)
{
    scene_real_t off[SCENE_CONSTRAINTS], shift[SADDLE], dp[SCENE_DIRECTIONS];
    size_t column;

    for (column = 0u; column < of->count; ++column) {
        scene_real_t *x = of->columns[column];
        directions_of(of, column, dp);
        constraint_values_along(time, state, p, x, dp, of->timing[column], off);
        shortest(time, state, p, c, off, NULL, shift);
        shift_column_positions(state, shift, x);
        constraint_rates_along(time, state, p, x, dp, of->timing[column], off);
        shortest(time, state, p, c, off, NULL, shift);
        shift_column_velocities(shift, x);
    }
}
