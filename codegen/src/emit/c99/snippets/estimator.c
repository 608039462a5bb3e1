/* Makes the first columns lower triangular and the others zero, without changing the product of
 * the matrix and its transpose, by a Householder reflection for each row. */
static void triangularize(scene_real_t columns[SCENE_COLUMNS][SCENE_ENTRIES])
{
    size_t row, column, below;

    for (row = 0u; row < SCENE_ENTRIES; ++row) {
        scene_real_t largest = R(0.0);
        scene_real_t square = R(0.0);
        scene_real_t first, end, factor;

        for (column = row; column < SCENE_COLUMNS; ++column) {
            const scene_real_t entry = fabs(columns[column][row]);
            largest = (largest < entry) ? entry : largest;
        }
        if (largest <= R(0.0)) {
            continue;
        }
        /* The row is divided by its largest entry, so that squares neither vanish nor overflow. */
        for (column = row; column < SCENE_COLUMNS; ++column) {
            const scene_real_t entry = columns[column][row] / largest;
            columns[column][row] = entry;
            square = square + entry * entry;
        }
        first = columns[row][row];
        end = (first < R(0.0)) ? sqrt(square) : -sqrt(square);
        columns[row][row] = first - end;
        factor = R(1.0) / (square - first * end);
        for (below = row + 1u; below < SCENE_ENTRIES; ++below) {
            scene_real_t product = R(0.0);
            for (column = row; column < SCENE_COLUMNS; ++column) {
                product = product + columns[column][row] * columns[column][below];
            }
            product = product * factor;
            for (column = row; column < SCENE_COLUMNS; ++column) {
                columns[column][below] = columns[column][below] - product * columns[column][row];
            }
        }
        columns[row][row] = largest * end;
        for (column = row + 1u; column < SCENE_COLUMNS; ++column) {
            columns[column][row] = R(0.0);
        }
    }
}

/* Puts the state back onto the constraints, and sets right modes that contradict their guards. The
 * covariance follows. */
static void restore(scene_estimator_t *estimator)
{
    scene_machine_t *machine = &estimator->machine;
    struct carried carried = { estimator->root, SCENE_ENTRIES, R(0.0), { R(0.0) } };
    struct carried *follow = &carried;

RESTORE
    (void)machine;
    (void)follow;
}

void scene_estimator_begin(scene_estimator_t *estimator)
{
    static const scene_real_t deviations[SCENE_ENTRIES] = {
DEVIATIONS};
    size_t column, entry;

    scene_begin(&estimator->machine);
    for (column = 0u; column < SCENE_COLUMNS; ++column) {
        for (entry = 0u; entry < SCENE_ENTRIES; ++entry) {
            estimator->root[column][entry] = (column == entry) ? deviations[entry] : R(0.0);
        }
    }
    restore(estimator);
}

int scene_estimator_predict(scene_estimator_t *estimator, scene_real_t step)
{
    const scene_real_t root_of_step = sqrt(step);
    struct carried carried
        = { estimator->root, SCENE_COLUMNS, R(1.0) / root_of_step, { R(0.0) } };
    size_t column, entry;
    int given;

    for (column = SCENE_ENTRIES; column < SCENE_COLUMNS; ++column) {
        for (entry = 0u; entry < SCENE_ENTRIES; ++entry) {
            estimator->root[column][entry] = R(0.0);
        }
    }
DIFFUSE
    given = step_followed(&estimator->machine, step, &carried);
    triangularize(estimator->root);
    return given;
}

scene_real_t scene_estimator_correct(scene_estimator_t *estimator,
                                     const scene_measured_t *measured)
{
    static const scene_real_t noise[SCENE_MEASURED] = {
NOISE};
    scene_machine_t *machine = &estimator->machine;
    struct carried carried = { estimator->root, SCENE_ENTRIES, R(0.0), { R(0.0) } };
    scene_outputs_t predicted;
    scene_real_t seen[SCENE_MEASURED][SCENE_ENTRIES];
    scene_real_t innovations[SCENE_MEASURED];
    scene_real_t change[SCENE_ENTRIES];
    scene_real_t dp[SCENE_DIRECTIONS], values[SCENE_MEASURED];
    scene_real_t normalized = R(0.0);
    size_t row, later, column, entry;

    scene_outputs(machine->time, &machine->state, &machine->p, &machine->c, &predicted);
INNOVATIONS
    for (column = 0u; column < SCENE_ENTRIES; ++column) {
        directions_of(&carried, column, dp);
        measured_along(machine->time, &machine->state, &machine->p, estimator->root[column], dp,
                       R(0.0), values);
        for (row = 0u; row < SCENE_MEASURED; ++row) {
            seen[row][column] = values[row];
        }
        change[column] = R(0.0);
    }
    for (row = 0u; row < SCENE_MEASURED; ++row) {
        /* Potter's update, by one measurement after another. */
        scene_real_t variance = noise[row] * noise[row];
        scene_real_t share, shrink;

        if (innovations[row] != innovations[row]) {
            continue; /* not measured */
        }
        for (column = 0u; column < SCENE_ENTRIES; ++column) {
            variance = variance + seen[row][column] * seen[row][column];
        }
        share = innovations[row] / variance;
        shrink = R(1.0) / (variance + sqrt(noise[row] * noise[row] * variance));
        normalized = normalized + innovations[row] * share;
        for (later = row + 1u; later < SCENE_MEASURED; ++later) {
            scene_real_t common = R(0.0);
            for (column = 0u; column < SCENE_ENTRIES; ++column) {
                common = common + seen[later][column] * seen[row][column];
            }
            innovations[later] = innovations[later] - common * share;
            common = shrink * common;
            for (column = 0u; column < SCENE_ENTRIES; ++column) {
                seen[later][column] = seen[later][column] - common * seen[row][column];
            }
        }
        for (entry = 0u; entry < SCENE_ENTRIES; ++entry) {
            scene_real_t product = R(0.0);
            for (column = 0u; column < SCENE_ENTRIES; ++column) {
                product = product + estimator->root[column][entry] * seen[row][column];
            }
            change[entry] = change[entry] + product * share;
            product = shrink * product;
            for (column = 0u; column < SCENE_ENTRIES; ++column) {
                estimator->root[column][entry]
                    = estimator->root[column][entry] - product * seen[row][column];
            }
        }
    }
CHANGE
    restore(estimator);
    return normalized;
}

scene_real_t scene_estimator_covariance(const scene_estimator_t *estimator, unsigned int row,
                                        unsigned int column)
{
    scene_real_t sum = R(0.0);
    size_t k;

    for (k = 0u; k < SCENE_ENTRIES; ++k) {
        sum = sum + estimator->root[k][row] * estimator->root[k][column];
    }
    return sum;
}
