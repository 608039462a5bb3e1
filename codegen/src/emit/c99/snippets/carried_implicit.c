
/* Carries the columns along a part of a step, by the exact derivative of its Rosenbrock method. With
 * the deviations dJ and df_t of the derivatives at its start:
 *     W dk1 = J dx + B dp + g h (dJ k1 + df_t)                          W = I - g h J
 *     W dk2 = J' (dx + h dk1) + B' dp - 2 dk1 + g h (dJ k2 - df_t)      J', B': second stage */
static void follow_part(struct carried *of, const scene_machine_t *machine, scene_real_t h,
                        const scene_state_t *start, const scene_state_t *end)
{
    const scene_real_t time = machine->time;
    const scene_real_t scale = GAMMA * h;
    scene_real_t by_state[2][SCENE_RATE_JACOBIAN_NONZEROS];
BY_PARAMETERS
    scene_real_t factors[PLACES], first[SCENE_STATES], second[SCENE_STATES];
    scene_state_t stage, slope_of, sum_of;
    size_t column, k;

    scene_rate_jacobian(time, start, &machine->p, &machine->c, by_state[0]);
PARAMETERS_AT_START
    factor_step(scale, by_state[0], factors);
    scene_time_derivative(time, start, &machine->p, &machine->c, &sum_of);
    scene_rate(time, start, &machine->p, &machine->c, &slope_of);
    ahead(&slope_of, &slope_of, scale, &sum_of);
    substitute_step(factors, &slope_of);
    numbers_of(&slope_of, first);
    ahead(&stage, start, h, &slope_of);
    second_right_side(&slope_of, scale, &sum_of);
    scene_rate(time + h, &stage, &machine->p, &machine->c, &sum_of);
    ahead(&sum_of, &sum_of, R(1.0), &slope_of);
    substitute_step(factors, &sum_of);
    numbers_of(&sum_of, second);
    scene_rate_jacobian(time + h, &stage, &machine->p, &machine->c, by_state[1]);
PARAMETERS_AT_SECOND
    for (column = 0u; column < of->count; ++column) {
        scene_real_t x[SCENE_STATES], slope[SCENE_STATES], sum[SCENE_STATES];
        scene_real_t bend[SCENE_STATES], second_bend[SCENE_STATES];
        scene_real_t by_entry[SCENE_RATE_JACOBIAN_NONZEROS];
        scene_real_t dp[SCENE_DIRECTIONS];
        scene_real_t *own = of->columns[column];

        directions_of(of, column, dp);
        time_derivative_along(time, start, &machine->p, own, dp, R(0.0), bend);
        for (k = 0u; k < SCENE_STATES; ++k) {
            second_bend[k] = -bend[k];
        }
        rate_jacobian_along(time, start, &machine->p, own, dp, R(0.0), by_entry);
        for (k = 0u; k < SCENE_RATE_JACOBIAN_NONZEROS; ++k) {
            const size_t row = scene_rate_jacobian_rows[k];
            const size_t by = scene_rate_jacobian_columns[k];
            bend[row] = bend[row] + by_entry[k] * first[by];
            second_bend[row] = second_bend[row] + by_entry[k] * second[by];
        }
        slope_along(by_state[0], STAGE_0 own, slope);
        along(slope, slope, scale, bend);
        substitute_column(factors, slope);
        along(x, own, h, slope);
        slope_along(by_state[1], STAGE_1 x, sum);
        along(sum, sum, R(-2.0), slope);
        along(sum, sum, scale, second_bend);
        substitute_column(factors, sum);
        along(own, own, R(1.5) * h, slope);
        along(own, own, R(0.5) * h, sum);
UNUSED
    }
AT_END
}
