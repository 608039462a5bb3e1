/* The hyperbolic tangent, E/(E + 2) with E = e^(2 |x|) - 1; off by two units in the last place
 * at most. */
static double hyperbolic_tangent(double x)
{
    const double size = fabs(x);
    double n, r, rest, power, low, part, high, e;

    if (22.0 < size) {
        return copysign(1.0, x);
    }
    n = reduced(size + size, &r, &rest);
    power = power_of_two(n);
    low = power - 1.0;
    part = power * r;
    high = low + part;
    e = high + (power * rest + (part - (high - low)));
    return copysign(e / (e + 2.0), x);
}
