/* Coordinates and constraints together. */
#define SADDLE (SCENE_COORDINATES + SCENE_CONSTRAINTS)

/* Solves a x = b in place by elimination with exchange of rows. Unknowns of rows that vanish but
 * for rounding, as of constraints that repeat others, are zero. */
static void eliminate(scene_real_t a[SADDLE][SADDLE], scene_real_t b[SADDLE])
{
    size_t column, row, k;
    scene_real_t largest = R(0.0);

    for (row = 0u; row < SADDLE; ++row) {
        for (column = 0u; column < SADDLE; ++column) {
            const scene_real_t size = fabs(a[row][column]);
            largest = (largest < size) ? size : largest;
        }
    }
    largest = largest * (scene_real_t)SADDLE * SCENE_EPSILON;
    for (column = 0u; column < SADDLE; ++column) {
        size_t pivot = column;
        for (row = column + 1u; row < SADDLE; ++row) {
            if (fabs(a[pivot][column]) < fabs(a[row][column])) {
                pivot = row;
            }
        }
        if (!(largest < fabs(a[pivot][column]))) {
            for (k = 0u; k < SADDLE; ++k) {
                a[column][k] = R(0.0);
            }
            a[column][column] = R(1.0);
            b[column] = R(0.0);
            continue;
        }
        if (pivot != column) {
            scene_real_t kept = b[pivot];
            b[pivot] = b[column];
            b[column] = kept;
            for (k = column; k < SADDLE; ++k) {
                kept = a[pivot][k];
                a[pivot][k] = a[column][k];
                a[column][k] = kept;
            }
        }
        for (row = column + 1u; row < SADDLE; ++row) {
            const scene_real_t factor = a[row][column] / a[column][column];
            if (factor != R(0.0)) {
                for (k = column; k < SADDLE; ++k) {
                    a[row][k] = a[row][k] - factor * a[column][k];
                }
                b[row] = b[row] - factor * b[column];
            }
        }
    }
    for (row = SADDLE; row > 0u; --row) {
        scene_real_t sum = b[row - 1u];
        for (k = row; k < SADDLE; ++k) {
            sum = sum - a[row - 1u][k] * b[k];
        }
        b[row - 1u] = sum / a[row - 1u][row - 1u];
    }
}

/* The shortest shift of coordinates, as the mass matrix measures it, that puts a state back onto
 * constraints that are off by `off`: M d + G^T mu = 0, G d = off. Coordinates that are held, if
 * any, do not move. */
static void shortest(scene_real_t time, const scene_state_t *state, const scene_parameters_t *p,
                     const scene_constants_t *c, const scene_real_t off[SCENE_CONSTRAINTS],
                     const signed char *held, scene_real_t shift[SADDLE])
{
    scene_real_t a[SADDLE][SADDLE];
    scene_real_t mass[SCENE_MASS_MATRIX_NONZEROS];
    scene_real_t matrix[SCENE_CONSTRAINT_MATRIX_NONZEROS];
    int holds[SCENE_CONSTRAINTS];
    size_t row, column, k;

    for (row = 0u; row < SADDLE; ++row) {
        for (column = 0u; column < SADDLE; ++column) {
            a[row][column] = R(0.0);
        }
        shift[row] = R(0.0);
    }
    scene_mass_matrix(time, state, p, c, mass);
    for (k = 0u; k < SCENE_MASS_MATRIX_NONZEROS; ++k) {
        a[scene_mass_matrix_rows[k]][scene_mass_matrix_columns[k]] = mass[k];
    }
    for (k = 0u; k < SCENE_CONSTRAINTS; ++k) {
        holds[k] = 0;
    }
    scene_constraint_matrix(time, state, p, c, matrix);
    for (k = 0u; k < SCENE_CONSTRAINT_MATRIX_NONZEROS; ++k) {
        row = scene_constraint_matrix_rows[k];
        column = scene_constraint_matrix_columns[k];
        a[SCENE_COORDINATES + row][column] = matrix[k];
        a[column][SCENE_COORDINATES + row] = matrix[k];
        holds[row] = (matrix[k] != R(0.0)) ? 1 : holds[row];
    }
    for (k = 0u; k < SCENE_CONSTRAINTS; ++k) {
        if (holds[k] != 0) {
            shift[SCENE_COORDINATES + k] = off[k];
        } else {
            a[SCENE_COORDINATES + k][SCENE_COORDINATES + k] = R(1.0);
        }
    }
    for (row = 0u; (held != NULL) && (row < SCENE_COORDINATES); ++row) {
        if (held[row] != 0) {
            for (column = 0u; column < SADDLE; ++column) {
                a[row][column] = R(0.0);
            }
            a[row][row] = R(1.0);
        }
    }
    eliminate(a, shift);
}

/* Puts a state back onto the constraints, first in position, then in velocity, by one step of
 * Newton's method each: a step of the motion leaves them by its local error, and what is left
 * is of the square of that. */
static void project_holding(scene_real_t time, scene_state_t *state, const scene_parameters_t *p,
                            const scene_constants_t *c, const signed char *positions,
                            const signed char *velocities)
{
    scene_real_t off[SCENE_CONSTRAINTS];
    scene_real_t shift[SADDLE];

    scene_constraint_values(time, state, p, c, off);
    shortest(time, state, p, c, off, positions, shift);
    shift_positions(state, shift);
    scene_constraint_rates(time, state, p, c, off);
    shortest(time, state, p, c, off, velocities, shift);
    shift_velocities(state, shift);
}

static void project(scene_real_t time, scene_state_t *state, const scene_parameters_t *p,
                    const scene_constants_t *c)
{
    project_holding(time, state, p, c, NULL, NULL);
}

void scene_project(scene_machine_t *machine)
{
    project(machine->time, &machine->state, &machine->p, &machine->c);
}

/* Coordinates and velocities whose initial values the spec gives. */
static const signed char given_positions[SCENE_COORDINATES] = {
GIVEN_POSITIONS};
static const signed char given_velocities[SCENE_COORDINATES] = {
GIVEN_VELOCITIES};

void scene_project_start(scene_machine_t *machine)
{
    const scene_real_t time = machine->time;
    unsigned int step;

    /* Newton's method converges quadratically from nearby. */
    for (step = 0u; step < 10u; ++step) {
        project_holding(time, &machine->state, &machine->p, &machine->c, given_positions,
                        given_velocities);
    }
}
