static double sine(double x)
{
    return (fabs(x) <= 1e6) ? sine_after_turns(x, 0u) : sin(x);
}
