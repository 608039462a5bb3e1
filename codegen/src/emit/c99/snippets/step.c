int scene_step(scene_machine_t *machine, scene_real_t step)
{
    scene_state_t end;

    advance(machine->time, step, &machine->state, &machine->p, &machine->c, &end);
PROJECT
    machine->state = end;
    pass_time(machine, step);
    return 0;
}
