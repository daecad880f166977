/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench-presets [MOST [ROUNDS]]: processor seconds and force evaluations of one growth step of 4 min and 1 s of
 * relaxation, from the same colony of 300, 3,000 and 10,000 rods (none larger than MOST), by every preset of accuracy
 * in turn, again and again: what else the machine does then falls on all alike. Also how many times as fast as paper
 * each is, and how far its radius of gyration is from paper's. One thread. */
#include "colony.h"

#include "analysis/extent.h"
#include "engine/snapshot.h"

#include <stdio.h>

typedef struct cost {
    double seconds, least; /* of all rounds, and of the fastest */
    uint64_t evaluations;  /* of one round */
    double gyration;       /* after it, um */
} cost;

static void measure(scene *sc, const snapshot *from, const accuracy_preset *preset, cost *c) {
    snapshot_restore(sc, from);
    sc->relax = preset->settings;
    uint64_t before = mechanics_statistics(sc->mechanics).evaluations;
    double begin = colony_now();
    scene_cycle(sc, 240, 1, 0, NULL);
    double seconds = colony_now() - begin;
    c->seconds += seconds;
    c->least = fmin(c->least, seconds);
    c->evaluations = mechanics_statistics(sc->mechanics).evaluations - before;
    const view v = scene_view(sc);
    extent_gyration(&v, NULL, &c->gyration, NULL);
}

static size_t find_preset(const char *name) {
    size_t i = 0;
    while (i + 1 < accuracy_preset_count && strcmp(accuracy_presets[i].name, name) != 0)
        i++;
    return i;
}

static void compare(scene *sc, int rounds) {
    cost costs[16] = {{0}};
    const size_t paper = find_preset("paper");
    size_t cells = sc->colony->cell.count;
    snapshot *from = snapshot_take(sc);
    relax_settings usual = sc->relax;
    for (size_t i = 0; i < accuracy_preset_count; i++)
        costs[i].least = (double)INFINITY;
    for (int round = 0; round < rounds; round++)
        for (size_t i = 0; i < accuracy_preset_count; i++)
            measure(sc, from, &accuracy_presets[i], &costs[i]);
    for (size_t i = accuracy_preset_count; i-- > 0;)
        printf("%8zu %-10s %12llu %10.4f %10.4f %9.2f %9.2f %+11.3f\n", cells, accuracy_presets[i].name,
               (unsigned long long)costs[i].evaluations, costs[i].seconds / rounds, costs[i].least,
               costs[paper].seconds / costs[i].seconds, (double)costs[paper].evaluations / (double)costs[i].evaluations,
               100 * (costs[i].gyration / costs[paper].gyration - 1));
    snapshot_restore(sc, from);
    snapshot_free(from);
    sc->relax = usual;
}

int main(int argc, char **argv) {
    static const size_t sizes[] = {300, 3000, 10000};
    const size_t most = argc > 1 ? (size_t)atol(argv[1]) : 10000;
    const int rounds = argc > 2 ? atoi(argv[2]) : 0;
    scene *sc = colony_start();
    printf("%8s %-10s %12s %10s %10s %9s %9s %11s\n", "rods", "preset", "evaluations", "mean s", "least s", "paper/s",
           "paper/ev", "gyration %");
    for (int i = 0; i < 3 && sizes[i] <= most; i++) {
        colony_grow_to(sc, sizes[i]);
        compare(sc, rounds > 0 ? rounds : sizes[i] < 1000 ? 20 : sizes[i] < 5000 ? 3 : 1);
    }
    scene_free(sc);
    return 0;
}
