/* Marks guards that pass zero, or are at zero on their way to the other side. */
static int pass_or_touch(const scene_machine_t *machine, const scene_real_t guards[SCENE_EVENTS],
                         int passed[SCENE_EVENTS])
{
    scene_real_t rates[SCENE_EVENTS];
    int found = pass(machine, guards, passed);
    size_t event;

    scene_guard_rates(machine->time, &machine->state, &machine->p, &machine->c, rates);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        const int side = machine->side[event];
        if ((is_wanted(event, side) != 0) && (sign_of(guards[event]) == 0)
            && (sign_of(rates[event]) == -side)
            && (scene_is_watched((unsigned int)event, &machine->state) != 0)) {
            passed[event] = 1;
            found = 1;
        }
    }
    return found;
}

int scene_is_due(const scene_machine_t *machine, const scene_real_t guards[SCENE_EVENTS])
{
    int passed[SCENE_EVENTS];

    return pass_or_touch(machine, guards, passed);
}

int scene_happen(scene_machine_t *machine, const scene_real_t guards[SCENE_EVENTS], scene_real_t h)
{
    int passed[SCENE_EVENTS];

    if (pass_or_touch(machine, guards, passed) == 0) {
        scene_follow(machine, guards);
        return 0;
    }
    return happen(machine, h, passed#NOBODY);
}

void scene_follow(scene_machine_t *machine, const scene_real_t guards[SCENE_EVENTS])
{
    size_t event;

    for (event = 0u; event < SCENE_EVENTS; ++event) {
        const int side = sign_of(guards[event]);
        if (scene_is_watched((unsigned int)event, &machine->state) == 0) {
            machine->side[event] = 0;
        } else if (side != 0) {
            machine->side[event] = (signed char)side;
        }
    }
}
