/* Columns that are solved for side by side. */
#define LANES 8u

/* One step of a substitution: x_row = scale x_row - sum of factor x_from, over the terms from
 * `first` to before `end`; not scaled where `scale` is 0, else by factor `scale` - 1. */
struct substitution {
    scene_index_t row;
    scene_index_t scale;
    scene_index_t first;
    scene_index_t end;
};

static void substitute(const struct substitution *steps, size_t count,
                       const scene_index_t (*terms)[2], const scene_real_t *factors,
                       scene_real_t (*x)[LANES])
{
    size_t step, term, lane;

    for (step = 0u; step < count; ++step) {
        scene_real_t *sums = x[steps[step].row];
        if (steps[step].scale != 0u) {
            const scene_real_t scale = factors[steps[step].scale - 1u];
            for (lane = 0u; lane < LANES; ++lane) {
                sums[lane] = sums[lane] * scale;
            }
        }
        for (term = steps[step].first; term < steps[step].end; ++term) {
            const scene_real_t factor = factors[terms[term][0]];
            const scene_real_t *from = x[terms[term][1]];
            for (lane = 0u; lane < LANES; ++lane) {
                sums[lane] = sums[lane] - factor * from[lane];
            }
        }
    }
}

/* A matrix some entries of which are solved for, by the results of its tape: `given` entries
 * first, then right sides. */
struct solve {
    size_t rows;
    size_t columns;
    const struct substitution *steps;
    size_t step_count;
    const scene_index_t (*terms)[2];
    const scene_index_t *given;
    size_t given_count;
    const scene_index_t (*right_sides)[2];
    size_t right_side_count;
    const scene_index_t (*solved)[3];
    size_t solved_count;
};

static void solve(const struct solve *of, const scene_real_t *factors, const scene_real_t *inputs,
                  scene_real_t (*x)[LANES], scene_real_t *values)
{
    size_t k, lane, block, side = 0u, entry = 0u;

    for (k = 0u; k < of->given_count; ++k) {
        values[of->given[k]] = inputs[k];
    }
    inputs += of->given_count;
    for (block = 0u; block < of->columns; block += LANES) {
        for (k = 0u; k < of->rows; ++k) {
            for (lane = 0u; lane < LANES; ++lane) {
                x[k][lane] = R(0.0);
            }
        }
        for (; side < of->right_side_count && of->right_sides[side][1] < block + LANES; ++side) {
            x[of->right_sides[side][0]][of->right_sides[side][1] - block] = inputs[side];
        }
        substitute(of->steps, of->step_count, of->terms, factors, x);
        for (; entry < of->solved_count && of->solved[entry][2] < block + LANES; ++entry) {
            values[of->solved[entry][0]] = x[of->solved[entry][1]][of->solved[entry][2] - block];
        }
    }
}
