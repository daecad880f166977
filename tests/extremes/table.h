/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of extreme cases, as cases.tbl has it; its head says how it is written. */
#ifndef SARCINA_TESTS_EXTREMES_TABLE_H
#define SARCINA_TESTS_EXTREMES_TABLE_H

#include <stddef.h>

enum { PRESETS_MAX = 8, CLAUSES_MAX = 8, LINES_MAX = 40 };

typedef enum { TIER_QUICK, TIER_FULL, TIER_LONG, TIER_COUNT } tier;
extern const char *const tier_names[TIER_COUNT];

/* What is due with one preset. */
typedef struct due {
    int refused;                     /* 0: the case holds; else the exit status it is refused with */
    int nclauses;                    /* 0: nothing is said of this preset */
    const char *clause[CLAUSES_MAX]; /* holds: invariants; refused: texts that the error has in it */
} due;

typedef struct extreme {
    const char *id, *title;
    tier tier;
    int line; /* in the table */
    size_t nlines, nafter;
    const char *lines[LINES_MAX]; /* those of its scene, its own; the last of them is judged */
    const char *after[LINES_MAX]; /* what goes on after a refusal */
    due due[PRESETS_MAX];         /* in the order of accuracy_presets */
} extreme;

typedef struct extreme_table {
    char *text;
    extreme *list;
    size_t n;
} extreme_table;

/* Reads it; a table that cannot be understood is told on stderr: -1. */
int table_read(const char *path, extreme_table *t);
void table_free(extreme_table *t);

#endif
