/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of functions: of numbers, element by element. */
#ifndef SARCINA_SCRIPT_FUNCTION_H
#define SARCINA_SCRIPT_FUNCTION_H

#include <stddef.h>

typedef enum {
    FUNCTION_PURE,     /* pure numbers or angles to a pure number */
    FUNCTION_SAME,     /* keeps the dimension; two arguments must have the same */
    FUNCTION_ROOT,     /* halves the dimension */
    FUNCTION_SIGN,     /* any dimension, the same for all arguments, to a pure number */
    FUNCTION_RANDOM,   /* draws */
    FUNCTION_CHOICE,   /* ternary(test, yes, no) */
    FUNCTION_DESCENDS, /* descends(ID): a truth per cell */
    FUNCTION_FILE,     /* is_file("F") */
    FUNCTION_DEFINED   /* defined("NAME") */
} function_rule;

typedef struct function_style {
    const char *name;
    const char *signature, *summary;
    int least, most; /* arguments */
    function_rule rule;
    double (*one)(double);
    double (*two)(double, double); /* folded from the left over more than two */
} function_style;

extern const function_style function_styles[];
extern const size_t function_style_count;

/* The record called name; NULL. */
const function_style *function_find(const char *name);

#endif
