/* One step of Heun's method, of order 2 and two rates. */
static void advance(scene_real_t time, scene_real_t h, const scene_state_t *state,
                    const scene_parameters_t *p, const scene_constants_t *c, scene_state_t *end)
{
    scene_state_t slope, sum, stage;

    scene_rate(time, state, p, c, &slope);
    sum = slope;
    ahead(&stage, state, h, &slope);
    scene_rate(time + h, &stage, p, c, &slope);
    ahead(&sum, &sum, R(1.0), &slope);
    ahead(end, state, R(0.5) * h, &sum);
}
