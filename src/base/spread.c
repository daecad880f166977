/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/spread.h"

#include <gsl/gsl_randist.h>
#include <math.h>

double spread_draw(const spread *s, gsl_rng *stream) {
    switch (s->law) {
    case SPREAD_NORMAL:
        return s->a + gsl_ran_gaussian_ziggurat(stream, s->b);
    case SPREAD_UNIFORM:
        return gsl_ran_flat(stream, s->a, s->b);
    case SPREAD_LOGNORMAL:
        return gsl_ran_lognormal(stream, log(s->a), log(s->b));
    case SPREAD_FIXED:
        break;
    }
    return s->a;
}

double spread_mean(const spread *s) {
    switch (s->law) {
    case SPREAD_UNIFORM:
        return 0.5 * (s->a + s->b);
    case SPREAD_LOGNORMAL:
        return s->a * exp(0.5 * log(s->b) * log(s->b));
    case SPREAD_NORMAL:
    case SPREAD_FIXED:
        break;
    }
    return s->a;
}
