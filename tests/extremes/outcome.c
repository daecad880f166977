/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "extremes/outcome.h"

#include "base/alloc.h"
#include "relax/relax.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct outcome_table {
    char **rows;
    size_t n, capacity;
};

static const char *what_came(int status) {
    return status == 0 ? "holds" : status == SARCINA_NUMERICAL ? "refused" : "declined";
}

char *outcome_row(const extreme *e, size_t preset, const verdict *v) {
    const char *name = accuracy_presets[preset].name, *what = what_came(v->refused);
    if (v->refused == 0)
        return alloc_format("%s\t%s\t%s\t%" PRIu64 "\t%" PRIu64 "\t%" PRIu64 "\t%.3g\t", e->id, name, what, v->steps,
                            v->rejected, v->evaluations, v->steps && isfinite(v->least_step) ? v->least_step : 0);
    return alloc_format("%s\t%s\t%s\t-\t-\t-\t-\t%s", e->id, name, what, v->words);
}

outcome_table *outcome_read(const char *path) {
    FILE *f = fopen(path, "r");
    if (!f)
        return NULL;
    outcome_table *t = alloc_zeroed(1, sizeof *t);
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, f) >= 0) {
        line[strcspn(line, "\n")] = '\0';
        if (*line == '#' || !*line)
            continue;
        t->rows = alloc_grow(t->rows, &t->capacity, t->n + 1, sizeof *t->rows);
        t->rows[t->n++] = alloc_copy(line);
    }
    free(line);
    fclose(f);
    return t;
}

void outcome_free(outcome_table *t) {
    for (size_t i = 0; t && i < t->n; i++)
        free(t->rows[i]);
    if (t)
        free(t->rows);
    free(t);
}

const char *outcome_find(const outcome_table *t, const extreme *e, size_t preset) {
    char *head = alloc_format("%s\t%s\t", e->id, accuracy_presets[preset].name);
    const char *found = NULL;
    for (size_t i = 0; t && i < t->n && !found; i++)
        if (strncmp(t->rows[i], head, strlen(head)) == 0)
            found = t->rows[i];
    free(head);
    return found;
}

/* "holds, 24 evaluations in 12 steps, 3 refused, none below 500 us" or "refused, " and why; the caller frees. */
static char *describe(const char *row) {
    char what[16] = "", steps[32] = "", refused[32] = "", evaluations[32] = "", least[32] = "";
    int words = 0;
    sscanf(row, "%*[^\t]\t%*[^\t]\t%15[^\t]\t%31[^\t]\t%31[^\t]\t%31[^\t]\t%31[^\t]\t%n", what, steps, refused,
           evaluations, least, &words);
    if (strcmp(what, what_came(0)) != 0)
        return alloc_format("%s, %s", what, words ? row + words : "");
    double us = 1e6 * strtod(least, NULL);
    if (strtoull(steps, NULL, 10) == 0)
        return alloc_copy("holds, nothing had to be moved");
    if (!(us > 0)) /* a minimiser's take no time */
        return alloc_format("holds, %s evaluations in %s steps, %s refused", evaluations, steps, refused);
    return alloc_format("holds, %s evaluations in %s steps, %s refused, none below %.3g us", evaluations, steps,
                        refused, us);
}

/* Presets of which the same is said stand together. Returns how many are not recorded. */
static size_t write_case(const outcome_table *t, const extreme *e) {
    char *text[PRESETS_MAX];
    size_t missing = 0;
    for (size_t p = 0; p < accuracy_preset_count; p++) {
        const char *row = outcome_find(t, e, p);
        missing += row == NULL;
        text[p] = row ? describe(row) : alloc_copy("not recorded");
        if (!row)
            fprintf(stderr, "%s with %s is not recorded\n", e->id, accuracy_presets[p].name);
    }
    printf(".It %s\n.Bl -dash -compact\n", e->title);
    for (size_t p = 0, last; p < accuracy_preset_count; p = last + 1) {
        for (last = p; last + 1 < accuracy_preset_count && strcmp(text[last + 1], text[p]) == 0;)
            last++;
        printf(".It\n");
        bool all = last - p + 1 == accuracy_preset_count;
        for (size_t k = p; k <= last && !all; k++)
            printf("%s%s", accuracy_presets[k].name, k < last ? ", " : ": ");
        printf("%s.\n", text[p]);
    }
    for (size_t p = 0; p < accuracy_preset_count; p++) {
        const due *d = &e->due[p];
        if (d->refused)
            continue;
        printf(".It\nasserted where it holds: ");
        for (int k = 0; k < d->nclauses; k++)
            printf("%s%s", d->clause[k], k + 1 < d->nclauses ? "; " : ".\n");
        break;
    }
    puts(".El");
    for (size_t p = 0; p < accuracy_preset_count; p++)
        free(text[p]);
    return missing;
}

size_t outcome_write_page(const outcome_table *t, const extreme_table *cases) {
    size_t missing = 0;
    puts("what comes of scenes at the extremes\n.Sh DESCRIPTION\n"
         "Each of these scenes has been run with every preset of\n.Xr sarcina-accuracy 7\n"
         "by tests/extremes; this page is written from what came of it, and the tests compare it with what comes now.\n"
         "A scene holds when it comes to its end with every number finite and what is named true (energy: no more of\n"
         "it, moving and stored, than before; momentum: none in all); or it is refused, by this message, the scene as\n"
         "after the last whole cycle, and the session able to go on.\n"
         "Refused steps are taken anew, shorter; the value caps of\n.Xr sarcina-script 7\ncounts them by what refused "
         "them.\n"
         ".Sh CASES\n.Bl -tag -width Ds");
    for (size_t i = 0; i < cases->n; i++)
        if (cases->list[i].tier <= TIER_FULL)
            missing += write_case(t, &cases->list[i]);
    puts(".El\n.Sh LONG RUNS\n"
         "By scripts/test long, with seed 1, on one thread of an AMD EPYC:\n"
         ".Bl -dash -compact\n.It\n"
         "a million rods on a plane, on top of each other as they come, two cycles of growth and relaxation\n"
         "(tests/long/million.sh): draft and balanced hold, in 297 s of processor together and 2.7 GB; the deepest\n"
         "overlap of 1,301,801 cells is then 10.5 and 9.7 nm, and a restart between the cycles changes no bit;\n.It\n"
         "a million growth steps of rods that divide and are washed out (tests/long/growth_steps.sh): draft and\n"
         "balanced hold, in 93 s together; the clock is that many steps exactly, two halves joined by a restart are\n"
         "the whole to the bit, and memory grows from 11 to 18 MB, by the mothers of 151,932 cells that are gone.\n"
         ".El");
    return missing;
}
