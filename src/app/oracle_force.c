/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oracle-force FOLDER: accelerations of frozen states against those the original authors' program computes. Per state:
 * max |a - a_ref| / max |a_ref|, which must not exceed 1e-9. Exit 0: all states do; 1: not; 2: the data cannot be read.
 */
#include "app/oracle_data.h"

#include "base/alloc.h"

#include <stdio.h>
#include <stdlib.h>

static const double bound = 1e-9;

static oracle_verdict check_state(const char *state, const oracle_tables *t) {
    oracle_scene s;
    mechanics *m = mechanics_create();
    diag d = {0};
    bool passed = false;
    if (oracle_scene_make(&s, state, &t->particles, &t->springs, &t->params) &&
        oracle_scene_bind(&s, m, &d) == SARCINA_OK) {
        double *force = alloc_zeroed(3 * s.nparticles, sizeof *force), deviation, largest;
        mechanics_force(m, s.colony->particle.x, s.colony->particle.v, force);
        oracle_scene_compare(&s, state, &t->particles, force, mechanics_mass(m), &deviation, &largest);
        passed = deviation <= bound * largest;
        printf("%-55s %3zu particles  %9.2e  %s\n", state, s.nparticles, deviation / largest, passed ? "ok" : "FAILED");
        free(force);
    } else {
        printf("%-55s FAILED %s\n", state, d.message);
    }
    mechanics_free(m);
    oracle_scene_free(&s);
    return passed ? ORACLE_PASSED : ORACLE_FAILED;
}

int main(int argc, char **argv) {
    return oracle_main(argc, argv, check_state);
}
