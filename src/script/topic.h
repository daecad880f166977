/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is to be known of the language beside its commands, as records: `help expressions`, and the sections of
 * sarcina-script(7). Examples run as tests, after the prelude of all examples. */
#ifndef SARCINA_SCRIPT_TOPIC_H
#define SARCINA_SCRIPT_TOPIC_H

#include "script/page.h"

#include <stdbool.h>
#include <stddef.h>

/* A paragraph, and lines that show what it says. */
typedef struct topic_part {
    const char *text;
    const char *example; /* NULL: none */
    const char *prints;  /* what they print, to the letter; NULL: not said */
} topic_part;

/* A row of a table: a name and what it means. Both pages are empty when it is called; false behind the last row. */
typedef bool topic_row(size_t i, page *name, page *text);

typedef struct topic {
    const char *name;  /* as in `help expressions` */
    const char *title; /* one line, no full stop */
    const topic_part *parts;
    size_t nparts;
    topic_row *rows;          /* a table behind the parts; NULL */
    const char *const *words; /* other words that lead here, ended by NULL; NULL: none */
} topic;

extern const topic topic_list[];
extern const size_t topic_count;

/* The topic called so, or one that the word leads to; NULL. */
const topic *topic_find(const char *name);

/* A command that shows a value, a function or a reduction: print "$(mean(length))". It runs after the prelude. */
struct value_style;
struct function_style;
struct reduction_style;
void topic_example_value(page *p, const struct value_style *s);
void topic_example_function(page *p, const struct function_style *s);
void topic_example_reduction(page *p, const struct reduction_style *s);

/* The tables of topics: topic_table.c. */
topic_row topic_row_dimension, topic_row_value, topic_row_function, topic_row_block, topic_row_color,
    topic_row_accuracy, topic_row_trade, topic_row_integrator, topic_row_method, topic_row_force, topic_row_exit;

#endif
