static double sine(double x)
{
    double s, c;
    sine_and_cosine(x, &s, &c);
    return s;
}
