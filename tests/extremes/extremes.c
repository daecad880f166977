/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the table of extreme cases, each with every preset of accuracy, and tells what did not come about.
 *
 *     extremes FOLDER [TIER]          the cases of FOLDER/cases.tbl up to this tier (SARCINA_TEST_TIER, quick)
 *     extremes FOLDER case ID...      these cases
 *     extremes FOLDER map [TIER]      the same, and writes the map to standard output */
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
