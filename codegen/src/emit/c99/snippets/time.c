/* Adds a step to the time, with what the sum leaves out kept for the next one. */
static void pass_time(scene_machine_t *machine, scene_real_t step)
{
    const scene_real_t whole = step + machine->time_rest;
    const scene_real_t before = machine->time;

    machine->time = before + whole;
    machine->time_rest = whole - (machine->time - before);
}
