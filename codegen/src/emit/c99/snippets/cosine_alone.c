static double cosine(double x)
{
    return (fabs(x) <= 1e6) ? sine_after_turns(x, 1u) : cos(x);
}
