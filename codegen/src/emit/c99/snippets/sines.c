/* Sines and cosines of four angles, which compilers compute side by side if all are near. */
static void sines_and_cosines_of_four(const double *restrict angles, double *restrict sines,
                                      double *restrict cosines)
{
    int are_near = 1;
    size_t k;

    for (k = 0u; k < 4u; ++k) {
        are_near = (fabs(angles[k]) <= 1e6) ? are_near : 0;
    }
    if (are_near != 0) {
        for (k = 0u; k < 4u; ++k) {
            near_sine_and_cosine(angles[k], &sines[k], &cosines[k]);
        }
    } else {
        for (k = 0u; k < 4u; ++k) {
            sine_and_cosine(angles[k], &sines[k], &cosines[k]);
        }
    }
}
