static inline void near_sine_and_cosine(double x, double *sine, double *cosine)
{
    double r, minus_tail, s, c;
    const double digits = reduced_angle(x, &r, &minus_tail);
    uint64_t n;

    (void)memcpy(&n, &digits, sizeof n);
    s = sine_of_rest(r, minus_tail);
    c = cosine_of_rest(r, minus_tail);
    *sine = signed_by_turns(((n & 1u) != 0u) ? c : s, n);
    *cosine = signed_by_turns(((n & 1u) != 0u) ? s : c, n + 1u);
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
