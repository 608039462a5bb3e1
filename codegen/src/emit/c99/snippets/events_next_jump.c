        {
            scene_real_t jump;
            jumps = next_jump(machine, machine->time + left, &jump);
            if ((jumps != 0) && is_last) {
                too_many = 1;
                jumps = 0;
            }
            length = (jumps != 0) ? before_jump(machine->time, left, jump) : length;
            after = jump;
        }
