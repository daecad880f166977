/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oracle-force FOLDER: accelerations of frozen states against those the original authors' program computes. Per state:
 * max |a - a_ref| / max |a_ref|, which must not exceed 1e-9. Exit 0: all states do; 1: not; 2: the data cannot be read.
 */
#include "app/oracle_data.h"

#include "base/alloc.h"

#include <stdio.h>
#include <stdlib.h>

static const double bound = 1e-9;

static bool check_state(const char *state, const oracle_table *particles, const oracle_table *springs,
                        const oracle_table *params) {
    oracle_scene s;
    mechanics *m = mechanics_create();
    diag d = {0};
    bool passed = false;
    if (oracle_scene_make(&s, state, particles, springs, params) && oracle_scene_bind(&s, m, &d) == SARCINA_OK) {
        double *force = alloc_zeroed(3 * s.nparticles, sizeof *force), deviation, largest;
        mechanics_force(m, s.colony->particle.x, s.colony->particle.v, force);
        oracle_scene_compare(&s, state, particles, force, mechanics_mass(m), &deviation, &largest);
        passed = deviation <= bound * largest;
        printf("%-55s %3zu particles  %9.2e  %s\n", state, s.nparticles, deviation / largest, passed ? "ok" : "FAILED");
        free(force);
    } else {
        printf("%-55s FAILED %s\n", state, d.message);
    }
    mechanics_free(m);
    oracle_scene_free(&s);
    return passed;
}

int main(int argc, char **argv) {
    oracle_tables t;
    if (!oracle_tables_read(&t, argc, argv))
        return 2;
    int passed = 0, failed = 0;
    for (size_t i = 0; i < t.params.nrows; i++)
        *(check_state(oracle_table_text(&t.params, i, "state"), &t.particles, &t.springs, &t.params) ? &passed
                                                                                                     : &failed) += 1;
    printf("%d passed, %d failed\n", passed, failed);
    oracle_tables_free(&t);
    return failed || !passed;
}
