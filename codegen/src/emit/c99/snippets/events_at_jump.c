            if (jumps != 0) {
                left = left - (after - machine->time);
                machine->time = after;
REOPEN
                scene_guards(machine->time, &machine->state, &machine->p, &machine->c, guards[1]);
                if (pass(machine, guards[1], passed) != 0) {
                    happened += happen(machine, left, passed#KNOWN);
                }
                continue;
            }
