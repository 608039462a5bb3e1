/* sin(x + turns pi/2), by one of the polynomials: angles of motions seldom change their quadrant,
 * so that processors predict which. */
static inline double sine_after_turns(double x, uint64_t turns)
{
    double r, minus_tail;
    const double digits = reduced_angle(x, &r, &minus_tail);
    uint64_t n;

    (void)memcpy(&n, &digits, sizeof n);
    n += turns;
    if ((n & 1u) != 0u) {
        return signed_by_turns(cosine_of_rest(r, minus_tail), n);
    }
    return signed_by_turns(sine_of_rest(r, minus_tail), n);
}
