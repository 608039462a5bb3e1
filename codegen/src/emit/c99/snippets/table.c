/* A natural cubic spline, constant beyond its ends. On the k-th interval, u = x - knots[k]:
 * c[0] + c[1] u + c[2] u^2 + c[3] u^3. */
struct cubic_table {
    uint32_t intervals;
    const scene_real_t *knots;
    const scene_real_t (*coefficients)[4];
    scene_real_t last_width;
};

static scene_real_t polynomial(const scene_real_t c[4], unsigned int order, scene_real_t u)
{
    switch (order) {
    case 0u:
        return ((c[3] * u + c[2]) * u + c[1]) * u + c[0];
    case 1u:
        return (R(3.0) * c[3] * u + R(2.0) * c[2]) * u + c[1];
    case 2u:
        return R(6.0) * c[3] * u + R(2.0) * c[2];
    case 3u:
        return R(6.0) * c[3];
    default:
        return R(0.0);
    }
}

/* Value (order 0) or derivative of a table: the interval is found by bisection, of which there
 * are no more steps than a 32-bit number has digits. */
static scene_real_t interpolate(const struct cubic_table *table, unsigned int order, scene_real_t x)
{
    uint32_t low = 0u;
    uint32_t high = table->intervals;

    if (!(x < table->knots[high])) {
        return (order == 0u)
            ? polynomial(table->coefficients[high - 1u], 0u, table->last_width) : R(0.0);
    }
    if (x < table->knots[0]) {
        return (order == 0u) ? polynomial(table->coefficients[0], 0u, R(0.0)) : R(0.0);
    }
    while (high - low > 1u) {
        const uint32_t middle = low + (high - low) / 2u;
        if (x < table->knots[middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return polynomial(table->coefficients[low], order, x - table->knots[low]);
}
