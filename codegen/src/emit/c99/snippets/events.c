/* An event that waits: it would only undo one that has just happened. */
#define WAITS (-1)

/* 1 of a number above zero, -1 below, 0 else. */
static int sign_of(scene_real_t x)
{
    return (R(0.0) < x) ? 1 : ((x < R(0.0)) ? -1 : 0);
}

/* Whether an event happens where its guard passes zero from a side. */
static int is_wanted(size_t event, int side)
{
    return (side != 0) && (directions[event] != side);
}

/* Whether a guard is on the far side of zero, on which its event has happened. */
static int is_beyond(size_t event, scene_real_t guard)
{
    return (directions[event] != 0) && (sign_of(guard) == directions[event]);
}

/* Whether a guard is beyond zero by no more than its rate takes back within h: at zero. */
static int comes_back(scene_real_t guard, scene_real_t rate, scene_real_t h)
{
    return (sign_of(guard) * sign_of(rate) < 0) && (fabs(guard) <= h * fabs(rate));
}

/* Share of a step of length h at which a guard passes zero: the root of the cubic through its
 * values and rates at both ends, by as many bisections as a number has digits. */
static scene_real_t passing(int side, scene_real_t h, const scene_real_t guard[2],
                            const scene_real_t rate[2])
{
    const scene_real_t change = guard[1] - guard[0];
    const scene_real_t slope = h * rate[0];
    const scene_real_t cubic = slope + h * rate[1] - R(2.0) * change;
    const scene_real_t square = change - slope - cubic;
    scene_real_t low = R(0.0);
    scene_real_t high = R(1.0);
    unsigned int digit;

    for (digit = 0u; digit < SCENE_DIGITS; ++digit) {
        const scene_real_t s = R(0.5) * (low + high);
        if (sign_of(guard[0] + s * (slope + s * (square + s * cubic))) == side) {
            low = s;
        } else {
            high = s;
        }
    }
    return high;
}

/* Sets right modes that contradict their guards: an event that leaves the modes it is watched for
 * in and whose guard is beyond zero happens at once. `asked` says which; it is cleared of those
 * that happen. Gives their number. */
static int settle(scene_machine_t *machine, scene_real_t h, int asked[SCENE_EVENTS]#DECLARED)
{
    scene_real_t guards[SCENE_EVENTS], rates[SCENE_EVENTS];
    int happened = 0;
    size_t round, event;

    for (round = 0u; round < 2u * SCENE_EVENTS; ++round) {
        int found = 0;
        scene_guards(machine->time, &machine->state, &machine->p, &machine->c, guards);
        scene_guard_rates(machine->time, &machine->state, &machine->p, &machine->c, rates);
        for (event = 0u; (event < SCENE_EVENTS) && (found == 0); ++event) {
            scene_state_t trial = machine->state;
            if ((asked[event] != 1) || (ends_its_mode[event] == 0)
                || (scene_is_watched((unsigned int)event, &trial) == 0)
                || (is_beyond(event, guards[event]) == 0)
                || (comes_back(guards[event], rates[event], h) != 0)) {
                continue;
            }
            scene_apply((unsigned int)event, machine->time, &trial, &machine->p, &machine->c);
            if (scene_is_watched((unsigned int)event, &trial) == 0) {
@                if (follow != NULL) {
@                    follow_reset(follow, machine, event);
@                }
                machine->state = trial;
                asked[event] = 0;
                found = 1;
            }
        }
        if (found == 0) {
            break;
        }
        ++happened;
HOLD
HELD_COLUMNS_8
    }
    return happened;
}

/* Sees on which side of zero every guard is after events: `passed` have just happened, and those
 * that wait count as before zero. */
static void look(scene_machine_t *machine, scene_real_t h, const int passed[SCENE_EVENTS],
                 const int asked[SCENE_EVENTS])
{
    scene_real_t guards[SCENE_EVENTS], rates[SCENE_EVENTS];
    size_t event;

    scene_guards(machine->time, &machine->state, &machine->p, &machine->c, guards);
    scene_guard_rates(machine->time, &machine->state, &machine->p, &machine->c, rates);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        int side = sign_of(guards[event]);
        if (scene_is_watched((unsigned int)event, &machine->state) == 0) {
            side = 0;
        } else if (asked[event] == WAITS) {
            side = -directions[event];
        } else if ((passed[event] != 0) || (side == 0)) {
            side = sign_of(rates[event]);
        } else if ((machine->side[event] == 0) && (is_beyond(event, guards[event]) != 0)
                   && (comes_back(guards[event], rates[event], h) != 0)) {
            side = -side;
        }
        machine->side[event] = (signed char)side;
    }
}

SETTLE_HEAD
{
    int asked[SCENE_EVENTS], passed[SCENE_EVENTS];
    size_t event;

    for (event = 0u; event < SCENE_EVENTS; ++event) {
        asked[event] = 1;
        passed[event] = 0;
        machine->side[event] = 0;
    }
    (void)settle(machine, R(0.0), asked#PASSED);
    look(machine, R(0.0), passed, asked);
}

/* Applies the events whose guards have passed zero. Gives how many happened. */
static int apply_passed(scene_machine_t *machine, const int passed[SCENE_EVENTS]#DECLARED)
{
    int happened = 0;
    size_t event;

    for (event = 0u; event < SCENE_EVENTS; ++event) {
        if ((passed[event] != 0)
            && (scene_is_watched((unsigned int)event, &machine->state) != 0)) {
@            if (follow != NULL) {
@                follow_reset(follow, machine, event);
@            }
            scene_apply((unsigned int)event, machine->time, &machine->state, &machine->p,
                        &machine->c);
            ++happened;
        }
    }
HOLD
HELD_COLUMNS_4
    return happened;
}

/* Whether an event would return to a mode that another has just ended. Both guards are at zero
 * then, and only rounding can have taken this one beyond: the other event would happen again. */
static int undoes(const scene_machine_t *machine, size_t event, const int passed[SCENE_EVENTS])
{
    scene_state_t trial = machine->state;
    size_t ended;

    if ((ends_its_mode[event] == 0) || (scene_is_watched((unsigned int)event, &trial) == 0)) {
        return 0;
    }
    scene_apply((unsigned int)event, machine->time, &trial, &machine->p, &machine->c);
    for (ended = 0u; ended < SCENE_EVENTS; ++ended) {
        if ((passed[ended] != 0) && (ends_its_mode[ended] != 0)
            && (scene_is_watched((unsigned int)ended, &trial) != 0)) {
            return 1;
        }
    }
    return 0;
}

/* Gives new values where guards have passed zero, at the end of a part of a step. */
static int happen(scene_machine_t *machine, scene_real_t h, const int passed[SCENE_EVENTS]#FIRST_DECLARED)
{
    scene_real_t before[SCENE_EVENTS];
    int asked[SCENE_EVENTS];
    int happened;
    size_t event;

@    if (follow != NULL) {
@        follow_before(follow, machine, first);
@    }
    scene_guards(machine->time, &machine->state, &machine->p, &machine->c, before);
    happened = apply_passed(machine, passed#PASSED);
    for (event = 0u; event < SCENE_EVENTS; ++event) {
        asked[event] = (machine->side[event] == 0)
            || ((passed[event] == 0) && (is_beyond(event, before[event]) == 0));
        if ((machine->side[event] == 0) && (undoes(machine, event, passed) != 0)) {
            asked[event] = WAITS;
        }
    }
    happened += settle(machine, h, asked#PASSED);
    look(machine, h, passed, asked);
@    if (follow != NULL) {
@        follow_after(follow, machine);
@    }
    return happened;
}

/* Guards that pass zero until the end of a part of a step, where they have these values: they are
 * marked. One that was at zero, and whose event ends the mode it is watched for in, has passed when
 * it is beyond: a state beyond is none of that mode. Gives whether there are any. */
static int pass(const scene_machine_t *machine, const scene_real_t guards[SCENE_EVENTS],
                int passed[SCENE_EVENTS])
{
    size_t event;
    int found = 0;

    for (event = 0u; event < SCENE_EVENTS; ++event) {
        const int side = machine->side[event];
        const int crosses = (is_wanted(event, side) != 0) && (sign_of(guards[event]) == -side);
        const int leaves = (side == 0) && (ends_its_mode[event] != 0)
            && (is_beyond(event, guards[event]) != 0);
        passed[event] = ((crosses != 0) || (leaves != 0))
            && (scene_is_watched((unsigned int)event, &machine->state) != 0);
        found = (passed[event] != 0) ? 1 : found;
    }
    return found;
}

STEP_HEAD
{
    scene_real_t guards[2][SCENE_EVENTS], rates[2][SCENE_EVENTS];
    scene_real_t shares[SCENE_EVENTS];
    int passed[SCENE_EVENTS];
    const scene_real_t start = machine->time;
    const scene_real_t rest = machine->time_rest;
    scene_real_t left = step;
    scene_state_t end;
    int happened = 0;
    int too_many = 0;
    size_t part, event;

    for (part = 1u; (part <= SCENE_PARTS_A_STEP) && (R(0.0) < left); ++part) {
        const int is_last = (part == SCENE_PARTS_A_STEP);
        scene_real_t length = left;
        scene_real_t first = R(1.0);
@        size_t which = SCENE_EVENTS;
        int found;
NEXT_JUMP
        scene_guards(machine->time, &machine->state, &machine->p, &machine->c, guards[0]);
        scene_guard_rates(machine->time, &machine->state, &machine->p, &machine->c, rates[0]);
        advance(machine->time, length, &machine->state, &machine->p, &machine->c, &end);
PROJECT_END
        scene_guards(machine->time + length, &end, &machine->p, &machine->c, guards[1]);
        scene_guard_rates(machine->time + length, &end, &machine->p, &machine->c, rates[1]);
        found = pass(machine, guards[1], passed);
        if ((found == 0) || is_last) {
            too_many = (found != 0) ? 1 : too_many;
@            if (follow != NULL) {
@                follow_part(follow, machine, length, &machine->state, &end);
@            }
            machine->state = end;
            for (event = 0u; event < SCENE_EVENTS; ++event) {
                const int side = sign_of(guards[1][event]);
                if (scene_is_watched((unsigned int)event, &end) == 0) {
                    machine->side[event] = 0;
                } else if ((passed[event] == 0) && (side != 0)) {
                    machine->side[event] = (signed char)side;
                }
            }
AT_JUMP
            break;
        }
        for (event = 0u; event < SCENE_EVENTS; ++event) {
            if (passed[event] != 0) {
                const scene_real_t guard[2] = { guards[0][event], guards[1][event] };
                const scene_real_t rate[2] = { rates[0][event], rates[1][event] };
                shares[event] = passing(machine->side[event], length, guard, rate);
@                which = ((shares[event] < first) || (which == SCENE_EVENTS)) ? event : which;
                first = (shares[event] < first) ? shares[event] : first;
            }
        }
        if (first < R(1.0)) {
            advance(machine->time, first * length, &machine->state, &machine->p, &machine->c,
                    &end);
PROJECT_FIRST
        }
@        if (follow != NULL) {
@            follow_part(follow, machine, first * length, &machine->state, &end);
@        }
        machine->state = end;
        machine->time = machine->time + first * length;
        left = left - first * length;
        scene_guards(machine->time, &machine->state, &machine->p, &machine->c, guards[1]);
        for (event = 0u; event < SCENE_EVENTS; ++event) {
            passed[event] = (passed[event] != 0)
                && ((shares[event] <= first)
                    || (sign_of(guards[1][event]) == -machine->side[event]));
        }
        happened += happen(machine, left, passed#WHICH);
    }
    machine->time = start;
    machine->time_rest = rest;
    pass_time(machine, step);
    return (too_many != 0) ? -1 : happened;
}
