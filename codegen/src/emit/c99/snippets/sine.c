/* Sine and cosine by arithmetic alone, the same to the last bit on every processor:
 *     x = n pi/2 + r + tail      n whole, |r| <= pi/4
 * with pi/2 in three parts, and polynomials of r. The error is below one unit in the last place.
 * Source: argument reduction and polynomials of fdlibm (Sun Microsystems, 1993). */
static void near_sine_and_cosine(double x, double *sine, double *cosine)
{
    /* Adding it leaves the digits of a whole number last. */
    const double rounding = 6755399441055744.0;
    const uint64_t sign_bit = UINT64_C(1) << 63;
    double digits, n, near, r, minus_tail, z, w, below_one, near_one, s, c, first, second;
    uint64_t quarter, bits;

    digits = x * 0.6366197723675814 + rounding;
    n = digits - rounding;
    near = -n * 1.5707963267341256 + x;
    r = -n * 6.077100506303966e-11 + near;
    minus_tail = n * 2.0222662487959506e-21 + (n * 6.077100506303966e-11 + (r - near));
    z = r * r;
    w = z * z;
    below_one = 0.5 * z;
    near_one = 1.0 - below_one;
    s = w * (w * (1.58969099521155e-10 * z + -2.5050760253406863e-8)
             + (2.7557313707070068e-6 * z + -1.984126982985795e-4))
        + (8.33333333332249e-3 * z + -1.6666666666666632e-1);
    s = r - (-(z * r) * s + minus_tail * near_one);
    c = w * (w * (-1.1359647557788195e-11 * z + 2.087572321298175e-9)
             + (-2.7557314351390663e-7 * z + 2.480158728947673e-5))
        + (-1.388888888887411e-3 * z + 4.16666666666666e-2);
    c = near_one + (w * c + ((1.0 - near_one) - below_one) + r * minus_tail);
    /* n says which is which, and half a turn changes signs. */
    (void)memcpy(&quarter, &digits, sizeof quarter);
    first = ((quarter & 1u) != 0u) ? c : s;
    second = ((quarter & 1u) != 0u) ? s : c;
    (void)memcpy(&bits, &first, sizeof bits);
    bits ^= (quarter << 62) & sign_bit;
    (void)memcpy(sine, &bits, sizeof bits);
    (void)memcpy(&bits, &second, sizeof bits);
    bits ^= ((quarter + 1u) << 62) & sign_bit;
    (void)memcpy(cosine, &bits, sizeof bits);
}

static void sine_and_cosine(double x, double *sine, double *cosine)
{
    if (fabs(x) <= 1e6) {
        near_sine_and_cosine(x, sine, cosine);
    } else {
        /* n would need more digits than are kept for it. */
        *sine = sin(x);
        *cosine = cos(x);
    }
}
