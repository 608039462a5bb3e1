/* The exponential function; its error is below one unit in the last place. */
static double exponential(double x)
{
    double n, half, r, rest;

    if (fabs(x) <= 700.0) {
        n = reduced(x, &r, &rest);
        return (1.0 + (r + rest)) * power_of_two(n);
    }
    x = (x < -750.0) ? -750.0 : x;
    x = (710.0 < x) ? 710.0 : x;
    n = reduced(x, &r, &rest);
    /* In two steps, because 2^n alone may be too large or too small to be a number. */
    half = (n * 0.5 + 6755399441055744.0) - 6755399441055744.0;
    return ((1.0 + (r + rest)) * power_of_two(half)) * power_of_two(n - half);
}
