/* e^x = 2^n (1 + p): n whole, p = e^(r + tail) - 1 with |r| <= ln(2)/2, by a polynomial of
 * degree 9 (Remez's exchange). Gives n, r and p - r. */
static inline double reduced(double x, double *r, double *rest)
{
    const double rounding = 6755399441055744.0;
    const double n = (x * 1.4426950408889634 + rounding) - rounding;
    const double near = -n * 6.931471803691238e-1 + x;
    const double s = -n * 1.9082149292705877e-10 + near;
    const double tail = -n * 1.9082149292705877e-10 + (near - s);
    const double z = s * s;
    const double w = z * z;
    const double low = z * (8.333333333494461e-3 * s + 4.1666666666530155e-2) + (1.6666666666666413e-1 * s + 5.000000000000011e-1);
    const double high = z * (2.755758637378518e-6 * s + 2.480149309888739e-5) + (1.9841269506578723e-4 * s + 1.3888888943630134e-3);
    const double q = w * (w * (2.500006162553128e-8 * s + 2.763024838532302e-7) + high) + low;
    *r = s;
    *rest = z * q + tail;
    return n;
}

/* 2^n for a whole number n from -1022 to 1023. */
static inline double power_of_two(double n)
{
    double power = n + (6755399441055744.0 + 1023.0);
    uint64_t bits;
    (void)memcpy(&bits, &power, sizeof bits);
    bits <<= 52;
    (void)memcpy(&power, &bits, sizeof power);
    return power;
}
