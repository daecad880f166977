/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the table of extreme cases, each with every preset of accuracy, and tells what did not come about.
 *
 *     extremes FOLDER [TIER]          the cases of FOLDER/cases.tbl up to this tier (SARCINA_TEST_TIER, quick)
 *     extremes FOLDER case ID...      these cases
 *     extremes FOLDER map             the manual's page of them, man/src/sarcina-extremes.7 */
#include "extremes/judge.h"

#include "base/alloc.h"
#include "relax/relax.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const unsigned patience[TIER_COUNT] = {60, 300, 36000};

typedef struct tally {
    size_t passed, failed;
    double seconds;
} tally;

/* What is due of a case, as the run asserts it: presets of which the same is due stand together. */
static void map_case(const extreme *e) {
    printf(".It %s\n", e->title);
    for (size_t p = 0; p < accuracy_preset_count; p++) {
        const due *d = &e->due[p];
        bool told = p > 0 && d->refused == d[-1].refused && strcmp(d->clause[0], d[-1].clause[0]) == 0;
        if (told)
            continue;
        size_t last = p;
        while (last + 1 < accuracy_preset_count && e->due[last + 1].refused == d->refused &&
               strcmp(e->due[last + 1].clause[0], d->clause[0]) == 0)
            last++;
        for (size_t k = p; k <= last && last - p + 1 < accuracy_preset_count; k++)
            printf("%s%s", accuracy_presets[k].name, k < last ? ", " : ": ");
        printf("%s", d->refused ? "refused: " : "holds: ");
        for (int k = 0; k < d->nclauses; k++)
            printf("%s%s", d->clause[k], k + 1 < d->nclauses ? (d->refused ? " ... " : "; ") : ".\n");
    }
}

static void run_case(const extreme *e, tally *t) {
    double seconds = 0;
    printf("%-28s", e->id);
    char *complaints = alloc_copy("");
    for (size_t p = 0; p < accuracy_preset_count; p++) {
        verdict v = judge(e, p, patience[e->tier]);
        seconds += v.seconds;
        printf(" %-7s", !v.good ? "FAILS" : v.refused ? "refused" : "holds");
        if (v.good) {
            t->passed++;
            continue;
        }
        t->failed++;
        char *more = alloc_format("%scases.tbl:%d: %s with %s: %s\n", complaints, e->line, e->id,
                                  accuracy_presets[p].name, v.words);
        free(complaints);
        complaints = more;
    }
    printf(" %6.2f s\n%s", seconds, complaints);
    t->seconds += seconds;
    free(complaints);
}

static tier tier_of(const char *name) {
    for (int i = 0; name && i < TIER_COUNT; i++)
        if (strcmp(name, tier_names[i]) == 0)
            return (tier)i;
    return TIER_QUICK;
}

static bool is_wanted(const extreme *e, int argc, char **argv) {
    if (argc > 2 && strcmp(argv[2], "case") == 0) {
        for (int i = 3; i < argc; i++)
            if (strcmp(argv[i], e->id) == 0)
                return true;
        return false;
    }
    return e->tier <= tier_of(argc > 2 ? argv[2] : getenv("SARCINA_TEST_TIER"));
}

/* A folder for what the cases write, which goes with the program. */
static char *enter_scratch(void) {
    char *folder = alloc_copy("/tmp/sarcina-extremes-XXXXXX");
    if (mkdtemp(folder) && chdir(folder) == 0)
        return folder;
    free(folder);
    return NULL;
}

static void leave_scratch(char *folder) {
    char *command = alloc_format("rm -rf %s", folder);
    if (chdir("/") || system(command))
        fprintf(stderr, "%s is left\n", folder);
    free(command);
    free(folder);
}

/* The map of the manual. What it says has been asserted by the run before it: each case came to what was due. */
static void write_map(const extreme_table *table) {
    puts("what comes of scenes at the extremes\n.Sh DESCRIPTION\n"
         "Each of these scenes is run with every preset of\n.Xr sarcina-accuracy 7\n"
         "by tests/extremes, which asserts what stands here, and from which this page is written.\n"
         "A scene holds when it comes to its end with every number finite and what is named true (energy: no more of\n"
         "it, moving and stored, than before; momentum: none in all); or it is refused, with a message that has these\n"
         "words in it, the scene as after the last whole cycle, and the session able to go on.\n"
         ".Sh CASES\n.Bl -tag -width Ds");
    for (size_t i = 0; i < table->n; i++)
        if (table->list[i].tier <= TIER_FULL)
            map_case(&table->list[i]);
    puts(".El");
}

int main(int argc, char **argv) {
    extreme_table table;
    tally t = {0};
    if (argc < 2) {
        fputs("usage: extremes FOLDER [TIER | case ID...]\n", stderr);
        return 2;
    }
    char *path = alloc_format("%s/cases.tbl", argv[1]);
    int status = table_read(path, &table);
    free(path);
    if (status == 0 && argc > 2 && strcmp(argv[2], "map") == 0) {
        write_map(&table);
        table_free(&table);
        return 0;
    }
    char *folder = status ? NULL : enter_scratch();
    for (size_t i = 0; folder && i < table.n; i++)
        if (is_wanted(&table.list[i], argc, argv))
            run_case(&table.list[i], &t);
    if (folder)
        leave_scratch(folder);
    table_free(&table);
    printf("%.1f s of processor\n%zu passed, %zu failed\n", t.seconds, t.passed, t.failed + (status != 0));
    return status || t.failed || t.passed == 0;
}
