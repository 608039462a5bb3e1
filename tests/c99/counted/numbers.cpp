// Numbers that count the operations on them. Functions that count as one suspend the count.
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define restrict __restrict

static long counted_operations = 0;
static int depth = 0;

static inline void tick(long by = 1)
{
    if (depth == 0) {
        counted_operations += by;
    }
}

struct once {
    explicit once(long by)
    {
        tick(by);
        ++depth;
    }
    ~once()
    {
        --depth;
    }
};

static void put(double number)
{
    if (fwrite(&number, sizeof number, 1, stdout) != 1) {
        exit(1);
    }
}

#ifdef COUNTED_FLOAT
typedef float plain_t;
#else
typedef double plain_t;
#endif

struct counted {
    plain_t value;
    counted() = default;
    constexpr counted(plain_t number) : value(number) {}
};

#define BINARY(symbol) \
    static inline counted operator symbol(counted a, counted b) \
    { \
        tick(); \
        return counted(a.value symbol b.value); \
    }
BINARY(+)
BINARY(-)
BINARY(*)
BINARY(/)

#define COMPARISON(symbol) \
    static inline bool operator symbol(counted a, counted b) \
    { \
        tick(); \
        return a.value symbol b.value; \
    }
COMPARISON(<)
COMPARISON(<=)
COMPARISON(==)
COMPARISON(!=)

static inline counted operator-(counted a)
{
    tick();
    return counted(-a.value);
}

#define FUNCTION(name) \
    static inline counted name(counted a) \
    { \
        tick(); \
        return counted((plain_t)name((double)a.value)); \
    } \
    static inline counted name##f(counted a) \
    { \
        return name(a); \
    }
FUNCTION(fabs)
FUNCTION(sqrt)
FUNCTION(floor)
FUNCTION(sin)
FUNCTION(cos)
FUNCTION(tan)
FUNCTION(asin)
FUNCTION(acos)
FUNCTION(atan)
FUNCTION(exp)
FUNCTION(log)
FUNCTION(sinh)
FUNCTION(cosh)
FUNCTION(tanh)

static inline counted pow(counted a, counted b)
{
    tick();
    return counted((plain_t)pow((double)a.value, (double)b.value));
}
static inline counted powf(counted a, counted b)
{
    return pow(a, b);
}
static inline counted copysign(counted a, counted b)
{
    tick();
    return counted((plain_t)copysign((double)a.value, (double)b.value));
}
