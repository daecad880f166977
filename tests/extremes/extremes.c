/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the table of extreme cases, each with every preset of accuracy, and tells what did not come about.
 *
 *     extremes FOLDER [TIER]          the cases of FOLDER/cases.tbl up to this tier (SARCINA_TEST_TIER, quick)
 *     extremes FOLDER case ID...      these cases
 *     extremes FOLDER record [ID...]  what comes of all of them, for FOLDER/outcomes.tsv
 *     extremes FOLDER map             the manual's page of them, man/src/sarcina-extremes.7, from outcomes.tsv
 *
 * From the full tier on what comes must be what is recorded, too. */
#include "extremes/outcome.h"

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
    bool recording;                /* rows are printed, and nothing else */
    const outcome_table *recorded; /* to compare with; NULL: nothing is */
} tally;

/* Is it what is recorded? If not, the verdict says what is. */
static void compare(const tally *t, const extreme *e, size_t preset, verdict *v) {
    char *row = outcome_row(e, preset, v);
    const char *recorded = outcome_find(t->recorded, e, preset);
    if (t->recorded && v->good && (!recorded || strcmp(row, recorded) != 0)) {
        v->good = 0;
        snprintf(v->words, sizeof v->words, "recorded is '%.400s', now it is '%.400s': extremes FOLDER record",
                 recorded ? recorded : "nothing", row);
    }
    if (t->recording)
        printf("%s\n", row);
    free(row);
}

static void run_case(const extreme *e, tally *t) {
    double seconds = 0;
    if (!t->recording)
        printf("%-28s", e->id);
    char *complaints = alloc_copy("");
    for (size_t p = 0; p < accuracy_preset_count; p++) {
        verdict v = judge(e, p, patience[e->tier]);
        seconds += v.seconds;
        compare(t, e, p, &v);
        if (!t->recording)
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
    if (!t->recording)
        printf(" %6.2f s\n%s", seconds, complaints);
    else
        fputs(complaints, stderr);
    t->seconds += seconds;
    free(complaints);
}

static tier tier_of(const char *name) {
    for (int i = 0; name && i < TIER_COUNT; i++)
        if (strcmp(name, tier_names[i]) == 0)
            return (tier)i;
    return TIER_QUICK;
}

static tier wanted_tier(int argc, char **argv) {
    if (argc > 2 && strcmp(argv[2], "record") == 0)
        return TIER_FULL;
    return tier_of(argc > 2 ? argv[2] : getenv("SARCINA_TEST_TIER"));
}

static bool is_wanted(const extreme *e, int argc, char **argv) {
    bool named = argc > 2 && (strcmp(argv[2], "case") == 0 || (strcmp(argv[2], "record") == 0 && argc > 3));
    if (named) {
        for (int i = 3; i < argc; i++)
            if (strcmp(argv[i], e->id) == 0)
                return true;
        return false;
    }
    return e->tier <= wanted_tier(argc, argv);
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

static bool is_asked(int argc, char **argv, const char *word) {
    return argc > 2 && strcmp(argv[2], word) == 0;
}

/* Runs the cases that are wanted; the exit status. */
static int run_cases(const extreme_table *table, const outcome_table *recorded, int argc, char **argv) {
    tally t = {.recording = is_asked(argc, argv, "record")};
    if (!t.recording && !is_asked(argc, argv, "case") && wanted_tier(argc, argv) >= TIER_FULL)
        t.recorded = recorded;
    char *folder = enter_scratch();
    for (size_t i = 0; folder && i < table->n; i++)
        if (is_wanted(&table->list[i], argc, argv))
            run_case(&table->list[i], &t);
    if (folder)
        leave_scratch(folder);
    fprintf(t.recording ? stderr : stdout, "%.1f s of processor\n%zu passed, %zu failed\n", t.seconds, t.passed,
            t.failed);
    return t.failed || t.passed == 0;
}

int main(int argc, char **argv) {
    extreme_table table;
    if (argc < 2) {
        fputs("usage: extremes FOLDER [TIER | case ID... | record | map]\n", stderr);
        return 2;
    }
    char *path = alloc_format("%s/cases.tbl", argv[1]), *outcomes = alloc_format("%s/outcomes.tsv", argv[1]);
    int status = table_read(path, &table);
    outcome_table *recorded = outcome_read(outcomes);
    if (status)
        puts("0 passed, 1 failed");
    else if (is_asked(argc, argv, "map"))
        status = outcome_write_page(recorded, &table) > 0;
    else
        status = run_cases(&table, recorded, argc, argv);
    outcome_free(recorded);
    table_free(&table);
    free(path);
    free(outcomes);
    return status != 0;
}
