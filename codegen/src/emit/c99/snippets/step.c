STEP_HEAD
{
    scene_state_t end;

    advance(machine->time, step, &machine->state, &machine->p, &machine->c, &end);
PROJECT
@    if (follow != NULL) {
@        follow_part(follow, machine, step, &machine->state, &end);
@    }
    machine->state = end;
    pass_time(machine, step);
    return 0;
}
