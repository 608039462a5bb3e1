static double cosine(double x)
{
    double s, c;
    sine_and_cosine(x, &s, &c);
    return c;
}
