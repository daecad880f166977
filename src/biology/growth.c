/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "biology/growth.h"

#include "base/alloc.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <sleef.h>

static double exponential(double mass, double rate, double dt) {
    return mass * Sleef_cinz_expd1_u10purec(rate * dt);
}

static double linear(double mass, double rate, double dt) {
    return mass + rate * dt;
}

static const param exponential_params[] = {
    {"rate:rate~!(-0.01/s,0.01/s)", "specific growth rate mu of each cell"},
    {"draw=step:{step|birth}", "when a cell draws its rate: anew every growth step, or once in its life"},
};
static const param linear_params[] = {
    {"rate:massrate~!(0,)", "mass gained per time by each cell"},
    {"draw=step:{step|birth}", "when a cell draws its rate: anew every growth step, or once in its life"},
};

const growth_style growth_styles[] = {
    {"exponential", "mass grows by a constant specific rate", "m(t + dt) = m(t) exp(mu dt)",
     "Storck et al. 2014, growth", "growth ecoli exponential rate 1.23/h sd 0.277/h draw step", exponential_params,
     TABLE_COUNT(exponential_params), exponential},
    {"linear", "mass grows by a constant amount per time", "m(t + dt) = m(t) + r dt",
     "Cooper 1988, J. Bacteriol. 170:5001", "growth ecoli linear rate 1e-19kg/s draw birth", linear_params,
     TABLE_COUNT(linear_params), linear},
};
const size_t growth_style_count = TABLE_COUNT(growth_styles);

static double draw_rate(const style_choice *law, rng *r, uint64_t id, uint64_t step) {
    uint64_t when =
        (int)law->values[GROWTH_DRAW].a == DRAW_BIRTH ? 0 : step + 1; /* 0 is the stream of the whole life */
    return spread_draw(&law->values[GROWTH_RATE], rng_stream(r, RNG_RATE, id, when));
}

int growth_step(colony *c, const species_table *t, rng *r, uint64_t step, double dt, diag *d) {
    size_t n = c->cell.count;
    double *mass = alloc_zeroed(n, sizeof *mass), *rate = alloc_zeroed(n, sizeof *rate);
    int status = SARCINA_OK;
    for (size_t i = 0; i < n && status == SARCINA_OK; i++) {
        const style_choice *law = &t->list[c->cell.species[i]].growth;
        mass[i] = c->cell.mass[i];
        rate[i] = c->cell.rate[i];
        if (law->style < 0)
            continue;
        if (!c->cell.own_rate[i])
            rate[i] = draw_rate(law, r, c->cell.id[i], step);
        mass[i] = growth_styles[law->style].mass_after(mass[i], rate[i], dt);
        if (!(mass[i] > 0) || !isfinite(mass[i])) {
            status = diag_fail(d, SARCINA_NUMERICAL,
                               "cell %llu of %s would grow from %.3g kg to %.3g kg in one step of %g s",
                               (unsigned long long)c->cell.id[i], t->list[c->cell.species[i]].name,
                               c->cell.mass[i] * 1e-15, mass[i] * 1e-15, dt);
            diag_help(d, "take a shorter step, or a smaller rate");
        }
    }
    for (size_t i = 0; i < n && status == SARCINA_OK; i++) {
        c->cell.mass[i] = mass[i];
        c->cell.rate[i] = rate[i];
        species_shape_cell(&t->list[c->cell.species[i]], c, (uint32_t)i);
    }
    free(mass);
    free(rate);
    return status;
}
