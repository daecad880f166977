/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of reductions: one number from those of many cells, or of a list. */
#ifndef SARCINA_SCRIPT_REDUCTION_H
#define SARCINA_SCRIPT_REDUCTION_H

#include <stddef.h>

typedef enum {
    REDUCTION_VALUE,    /* keeps the dimension; undefined without numbers */
    REDUCTION_SUM,      /* keeps the dimension; 0 without numbers */
    REDUCTION_COUNT,    /* how many hold */
    REDUCTION_FRACTION, /* what part of them holds */
    REDUCTION_QUANTILE  /* its first argument is the probability */
} reduction_rule;

typedef struct reduction_style {
    const char *name;
    const char *signature, *summary;
    reduction_rule rule;
    double (*reduce)(double *v, size_t n, double p); /* n > 0 numbers, which it may reorder */
} reduction_style;

extern const reduction_style reduction_styles[];
extern const size_t reduction_style_count;

/* The record called name; NULL. */
const reduction_style *reduction_find(const char *name);

#endif
