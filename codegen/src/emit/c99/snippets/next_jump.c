/* The first of the times at which the rate jumps that is after now and not after `until`; `until`
 * if there is none. Gives whether there is one. */
static int next_jump(const scene_machine_t *machine, scene_real_t until, scene_real_t *jump)
{
    scene_real_t times[SCENE_DISCONTINUITIES];
    size_t k;
    int found = 0;

    *jump = until;
    scene_discontinuities(&machine->p, times);
    for (k = 0u; k < SCENE_DISCONTINUITIES; ++k) {
        if ((machine->time < times[k]) && (times[k] <= *jump)) {
            *jump = times[k];
            found = 1;
        }
    }
    return found;
}

/* How far it is to just before a jump: there the rate has not jumped yet. */
static scene_real_t before_jump(scene_real_t time, scene_real_t left, scene_real_t jump)
{
    const scene_real_t length = (jump - SCENE_EPSILON * (fabs(jump) + left)) - time;
    return (R(0.0) < length) ? length : R(0.0);
}
