/* Sine and cosine by arithmetic alone, the same to the last bit on every processor:
 *     x = n pi/2 + r + tail      n whole, |r| <= pi/4
 * with pi/2 in three parts, and polynomials of r. The error is below one unit in the last place.
 * Source: argument reduction and polynomials of fdlibm (Sun Microsystems, 1993).
 * Gives r, -tail, and a number whose last digits are n. */
static inline double reduced_angle(double x, double *r, double *minus_tail)
{
    /* Adding it leaves the digits of a whole number last. */
    const double rounding = 6755399441055744.0;
    const double digits = x * 0.6366197723675814 + rounding;
    const double n = digits - rounding;
    const double near = -n * 1.5707963267341256 + x;

    *r = -n * 6.077100506303966e-11 + near;
    *minus_tail = n * 2.0222662487959506e-21 + (n * 6.077100506303966e-11 + (*r - near));
    return digits;
}

/* sin(r + tail) */
static inline double sine_of_rest(double r, double minus_tail)
{
    const double z = r * r;
    const double w = z * z;
    const double near_one = 1.0 - 0.5 * z;
    const double p = w * (w * (1.58969099521155e-10 * z + -2.5050760253406863e-8)
                          + (2.7557313707070068e-6 * z + -1.984126982985795e-4))
        + (8.33333333332249e-3 * z + -1.6666666666666632e-1);
    return r - (-(z * r) * p + minus_tail * near_one);
}

/* cos(r + tail) */
static inline double cosine_of_rest(double r, double minus_tail)
{
    const double z = r * r;
    const double w = z * z;
    const double below_one = 0.5 * z;
    const double near_one = 1.0 - below_one;
    const double p = w * (w * (-1.1359647557788195e-11 * z + 2.087572321298175e-9)
                          + (-2.7557314351390663e-7 * z + 2.480158728947673e-5))
        + (-1.388888888887411e-3 * z + 4.16666666666666e-2);
    return near_one + (w * p + ((1.0 - near_one) - below_one) + r * minus_tail);
}

/* x, with the opposite sign if n ends in the binary digits 10 or 11. */
static inline double signed_by_turns(double x, uint64_t n)
{
    uint64_t bits;
    (void)memcpy(&bits, &x, sizeof bits);
    bits ^= (n << 62) & (UINT64_C(1) << 63);
    (void)memcpy(&x, &bits, sizeof x);
    return x;
}
