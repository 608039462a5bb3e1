/* One step of the classical Runge-Kutta method, of order 4 and four rates. */
static void advance(scene_real_t time, scene_real_t h, const scene_state_t *state,
                    const scene_parameters_t *p, const scene_constants_t *c, scene_state_t *end)
{
    const scene_real_t half = R(0.5) * h;
    scene_state_t slope, sum, stage;

    scene_rate(time, state, p, c, &slope);
    sum = slope;
    ahead(&stage, state, half, &slope);
    scene_rate(time + half, &stage, p, c, &slope);
    ahead(&sum, &sum, R(2.0), &slope);
    ahead(&stage, state, half, &slope);
    scene_rate(time + half, &stage, p, c, &slope);
    ahead(&sum, &sum, R(2.0), &slope);
    ahead(&stage, state, h, &slope);
    scene_rate(time + h, &stage, p, c, &slope);
    ahead(&sum, &sum, R(1.0), &slope);
    ahead(end, state, h / R(6.0), &sum);
}
