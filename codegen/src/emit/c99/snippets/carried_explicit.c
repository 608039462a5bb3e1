
/* Carries the columns along a part of a step, by the derivative of its method. */
static void follow_part(struct carried *of, const scene_machine_t *machine, scene_real_t h,
                        const scene_state_t *start, const scene_state_t *end)
{
    const scene_real_t time = machine->time;
    const scene_real_t half = R(0.5) * h;
    scene_real_t by_state[STAGES][SCENE_RATE_JACOBIAN_NONZEROS];
BY_PARAMETERS
    scene_state_t stage = *start;
    scene_state_t slope_of;
    size_t column;

STAGE_JACOBIANS
    for (column = 0u; column < of->count; ++column) {
        scene_real_t x[SCENE_STATES], slope[SCENE_STATES], sum[SCENE_STATES];
        scene_real_t dp[SCENE_DIRECTIONS];
        scene_real_t *own = of->columns[column];

        directions_of(of, column, dp);
        slope_along(by_state[0], STAGE_0 own, slope);
        (void)memcpy(sum, slope, sizeof sum);
STAGE_SLOPES
    }
AT_END
}
