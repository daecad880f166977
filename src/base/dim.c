/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/dim.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Brace lists, not compound literals: ISO C takes only the former in a static table. */
#define ENTRY(name, l, m, t)                                                                                           \
    {                                                                                                                  \
        name, {                                                                                                        \
            12 * (l), 12 * (m), 12 * (t)                                                                               \
        }                                                                                                              \
    }
static const struct {
    const char *name;
    dim d;
} names[] = {
    ENTRY("pure number", 0, 0, 0),
    ENTRY("length", 1, 0, 0),
    ENTRY("area", 2, 0, 0),
    ENTRY("volume", 3, 0, 0),
    ENTRY("areadensity", -2, 0, 0),
    ENTRY("mass", 0, 1, 0),
    ENTRY("density", -3, 1, 0),
    ENTRY("time", 0, 0, 1),
    ENTRY("rate", 0, 0, -1),
    ENTRY("wavenumber", -1, 0, 0),
    ENTRY("velocity", 1, 0, -1),
    ENTRY("acceleration", 1, 0, -2),
    ENTRY("drag", 0, 1, -1),
    ENTRY("stiffness", 0, 1, -2),
    ENTRY("force", 1, 1, -2),
    ENTRY("energy", 2, 1, -2),
    ENTRY("energylength", 3, 1, -2),
    /* second names; the first of a dimension is the one errors use */
    ENTRY("number", 0, 0, 0),
    ENTRY("fraction", 0, 0, 0),
    ENTRY("angle", 0, 0, 0),
    ENTRY("massrate", 0, 1, -1),
    ENTRY("bending", 2, 1, -2),
};
enum { NAME_COUNT = sizeof names / sizeof names[0] };

bool dim_by_name(const char *name, dim *out) {
    for (int i = 0; i < NAME_COUNT; i++)
        if (strcmp(names[i].name, name) == 0) {
            *out = names[i].d;
            return true;
        }
    return false;
}

const char *dim_listed(size_t i, dim *out) {
    if (i >= NAME_COUNT)
        return NULL;
    *out = names[i].d;
    return names[i].name;
}

/* Writes "m2" style factors of one sign; exponents in twelfths may be fractions. */
static int put_factor(char *out, size_t room, const char *unit, int twelfths, const char *before) {
    if (twelfths == 12)
        return snprintf(out, room, "%s%s", before, unit);
    if (twelfths % 12 == 0)
        return snprintf(out, room, "%s%s%d", before, unit, twelfths / 12);
    return snprintf(out, room, "%s%s^%g", before, unit, twelfths / 12.0);
}

/* As people of the field write them; what has no such name is in base units. */
static const struct {
    const char *text;
    dim d;
} written[] = {
    ENTRY("N", 1, 1, -2), ENTRY("N/m", 0, 1, -2), ENTRY("J", 2, 1, -2), ENTRY("Pa", -1, 1, -2), ENTRY("J.m", 3, 1, -2),
};
enum { WRITTEN_COUNT = sizeof written / sizeof written[0] };

const char *dim_suffix(dim d, char buffer[48]) {
    for (int i = 0; i < WRITTEN_COUNT; i++)
        if (dim_equal(written[i].d, d)) {
            snprintf(buffer, 48, "%s", written[i].text);
            return buffer;
        }
    const int exponents[3] = {d.mass, d.length, d.time};
    const char *const units[3] = {"kg", "m", "s"};
    int n = 0;
    buffer[0] = '\0';
    for (int i = 0; i < 3; i++)
        if (exponents[i] > 0)
            n += put_factor(buffer + n, 48 - (size_t)n, units[i], exponents[i], n ? "." : "");
    for (int i = 0; i < 3; i++)
        if (exponents[i] < 0)
            n += put_factor(buffer + n, 48 - (size_t)n, units[i], -exponents[i], "/");
    return buffer;
}

const char *dim_name(dim d, char buffer[48]) {
    for (int i = 0; i < NAME_COUNT; i++)
        if (dim_equal(names[i].d, d))
            return names[i].name;
    return dim_suffix(d, buffer);
}

/* Powers of ten up to 1e22 are exact in binary64, so scaling by one rounds once. */
static double scale10(double x, int twelfths) {
    if (twelfths % 12)
        return x * pow(10, twelfths / 12.0);
    int e = twelfths / 12;
    static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    for (; e > 22; e -= 22)
        x *= 1e22;
    for (; e < -22; e += 22)
        x /= 1e22;
    return e >= 0 ? x * power[e] : x / power[-e];
}

/* Twelfths of the decimal exponent between SI and the engine: 1 m = 1e6 um, 1 kg = 1e15 pg. */
static int engine_exponent(dim d) {
    return 6 * d.length + 15 * d.mass;
}

double dim_to_engine(double si, dim d) {
    return scale10(si, engine_exponent(d));
}

double dim_from_engine(double engine, dim d) {
    return scale10(engine, -engine_exponent(d));
}
