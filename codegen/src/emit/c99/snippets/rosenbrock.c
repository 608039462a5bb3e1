/* One step of a Rosenbrock method of order 2, L-stable: two rates, one Jacobian, one elimination.
 *     (I - g h J) k1 = f(t, y) + g h f_t                      g = 1 - 1/sqrt 2
 *     (I - g h J) k2 = f(t + h, y + h k1) - 2 k1 - g h f_t
 *     y' = y + 3/2 h k1 + 1/2 h k2
 * Source: Verwer, Spee, Blom, Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456. */
static void advance(scene_real_t time, scene_real_t h, const scene_state_t *state,
                    const scene_parameters_t *p, const scene_constants_t *c, scene_state_t *end)
{
    const scene_real_t scale = GAMMA * h;
    scene_real_t factors[PLACES];
    scene_state_t slope, sum, stage;

JACOBIAN
    scene_time_derivative(time, state, p, c, &sum);
    scene_rate(time, state, p, c, &slope);
    ahead(&slope, &slope, scale, &sum);
    substitute_step(factors, &slope);
    ahead(&stage, state, h, &slope);
    ahead(end, state, R(1.5) * h, &slope);
    second_right_side(&slope, scale, &sum);
    scene_rate(time + h, &stage, p, c, &sum);
    ahead(&sum, &sum, R(1.0), &slope);
    substitute_step(factors, &sum);
    ahead(end, end, R(0.5) * h, &sum);
}
