/* Columns of a square root of the covariance, which follow a step by its exact derivative. */
struct carried {
    scene_real_t (*columns)[SCENE_ENTRIES];
    size_t count;
    scene_real_t per_intensity; /* step^-1/2, by which noise within a step deviates */
    scene_real_t timing[SCENE_COLUMNS]; /* deviation of the time of events at hand */
};

/* The deviations of parameters along a column. */
static void directions_of(const struct carried *of, size_t column,
                          scene_real_t dp[SCENE_DIRECTIONS])
{
DIRECTIONS_OF
}

/* The deviation of a rate, J x + B dp. */
static void slope_along(const scene_real_t by_state[SCENE_RATE_JACOBIAN_NONZEROS],
BY_PARAMETERS_ARGUMENT
                        const scene_real_t x[SCENE_STATES], scene_real_t slope[SCENE_STATES])
{
    size_t k;

    for (k = 0u; k < SCENE_STATES; ++k) {
        slope[k] = R(0.0);
    }
    for (k = 0u; k < SCENE_RATE_JACOBIAN_NONZEROS; ++k) {
        const size_t row = scene_rate_jacobian_rows[k];
        slope[row] = slope[row] + by_state[k] * x[scene_rate_jacobian_columns[k]];
    }
SLOPE_BY_PARAMETERS
}

/* x = from + h slope. */
static void along(scene_real_t x[SCENE_STATES], const scene_real_t from[SCENE_STATES],
                  scene_real_t h, const scene_real_t slope[SCENE_STATES])
{
    size_t k;

    for (k = 0u; k < SCENE_STATES; ++k) {
        x[k] = from[k] + h * slope[k];
    }
}
PROJECTED
