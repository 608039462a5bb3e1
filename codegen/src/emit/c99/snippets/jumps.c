STEP_HEAD
{
    const scene_real_t start = machine->time;
    const scene_real_t rest = machine->time_rest;
    scene_real_t left = step;
    scene_state_t end;
    size_t part;
    int given = 0;

    for (part = 1u; (part <= SCENE_PARTS_A_STEP) && (R(0.0) < left); ++part) {
        scene_real_t jump;
        int jumps = next_jump(machine, machine->time + left, &jump);
        scene_real_t length = left;
        if ((jumps != 0) && (part == SCENE_PARTS_A_STEP)) {
            given = -1;
            jumps = 0;
        }
        length = (jumps != 0) ? before_jump(machine->time, left, jump) : length;
        if (R(0.0) < length) {
            advance(machine->time, length, &machine->state, &machine->p, &machine->c, &end);
PROJECT
@            if (follow != NULL) {
@                follow_part(follow, machine, length, &machine->state, &end);
@            }
            machine->state = end;
        }
        left = (jumps != 0) ? left - (jump - machine->time) : R(0.0);
        machine->time = jump;
    }
    machine->time = start;
    machine->time_rest = rest;
    pass_time(machine, step);
    return given;
}
