/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is run, what is measured, and what the paper says about it: Storck, Picioreanu, Virdis & Batstone (2014),
 * Biophys. J. 106:2037. */
#ifndef SARCINA_APP_STUDY_CASES_H
#define SARCINA_APP_STUDY_CASES_H

#include <stddef.h>

typedef enum { STUDY_ECOLI, STUDY_FLOC } study_family;

/* An ensemble: a script with options of its own. */
typedef struct study_case {
    const char *name;  /* on the command line, and its folder */
    const char *title; /* in tables */
    study_family family;
    const char *script;    /* below examples, without .in */
    const char *options;   /* beside those of all (study_options), parted by blanks */
    const char *reference; /* the case in the original's data; NULL: none */
    const char *variant;   /* NULL, or the case of which this is a variant run for one comparison only */
    size_t seeds;          /* at most so many; 0: as many as asked for */
} study_case;

extern const study_case study_cases[];
extern const size_t study_case_count;

/* Options of every run: small pictures, and only of the end. */
extern const char study_options[];

/* NULL when there is none. */
const study_case *study_case_find(const char *name);

/* Where a quantity of a run stands. */
typedef enum {
    STUDY_END,    /* results.csv, last row */
    STUDY_SCALAR, /* scalars.csv */
    STUDY_CELLS   /* results.csv, where the run first has `cells` cells */
} study_place;

typedef struct study_quantity {
    const char *name;
    study_family family;
    const char *definition;
    const char *unit;
    double scale; /* from SI to that unit */
    int digits;   /* behind the point, in tables */
    study_place place;
    const char *column;
    double cells;
    const char *reference; /* stem of the original's columns in that unit; NULL: it has none */
    const char *over;      /* another stem to divide by; NULL */
} study_quantity;

extern const study_quantity study_quantities[];
extern const size_t study_quantity_count;
const study_quantity *study_quantity_find(const char *name);

/* Numbers that the paper prints, in the quantity's unit. */
typedef struct study_printed {
    const char *name, *quantity; /* of the case */
    double value, ci95;          /* of the mean of ten; 0: the paper gives none */
} study_printed;

/* NULL where the paper prints none. */
const study_printed *study_printed_find(const char *name, const char *quantity);

/* What growth alone gives: the mean of n = 20 must lie in mean +- half (model.md 7 of the design: 383 +- 25 and
 * 399 +- 27 cells are the standard deviations of one run). */
typedef struct study_growth {
    const char *name;
    double mean, half, single; /* single: the paper's one run */
} study_growth;

extern const study_growth study_growths[];
extern const size_t study_growth_count;

typedef enum { STUDY_MORE, STUDY_LESS, STUDY_SAME } study_direction;

/* What the paper claims of two cases: a has more, less, or as much of a quantity as b. */
typedef struct study_claim {
    const char *text, *where;
    const char *a, *b, *quantity;
    study_direction direction;
    double margin; /* STUDY_SAME: largest difference that counts as none, as a part of b's mean */
} study_claim;

extern const study_claim study_claims[];
extern const size_t study_claim_count;

#endif
