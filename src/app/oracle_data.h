/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reference data of the original authors' program: CSV tables read by column name, and scenes made from them. */
#ifndef SARCINA_APP_ORACLE_DATA_H
#define SARCINA_APP_ORACLE_DATA_H

#include "mechanics/mechanics.h"

#include <stdbool.h>
#include <stddef.h>

/* A table of text; empty when the file is missing or not rectangular (a message says so). */
typedef struct oracle_table {
    char *text;        /* the file; fields point into it */
    const char **head; /* (ncolumns) */
    const char **at;   /* (nrows x ncolumns) */
    size_t ncolumns, nrows;
} oracle_table;

/* FOLDER/NAME; false with a message when it cannot be read. */
bool oracle_table_read(oracle_table *t, const char *folder, const char *name);
void oracle_table_free(oracle_table *t);

/* A field as text and as a number (an empty one: 0); a column that is not there ends the program. */
const char *oracle_table_text(const oracle_table *t, size_t row, const char *column);
double oracle_table_number(const oracle_table *t, size_t row, const char *column);

/* The three tables of a folder of states. */
typedef struct oracle_tables {
    oracle_table particles, springs, params;
} oracle_tables;

/* What a program finds of one state: it says so in a line of its own. */
typedef enum { ORACLE_FAILED, ORACLE_PASSED, ORACLE_SKIPPED } oracle_verdict;
typedef oracle_verdict oracle_check(const char *state, const oracle_tables *t);

/* The main of a program whose only argument is a folder of states: judges each and prints "N passed, N failed". Its
 * exit code: 0: at least one passed and none failed; 1: not so; 2: the data cannot be read, which is said. */
int oracle_main(int argc, char **argv, oracle_check *check);

/* A state in the engine's units, with what is needed to bind the mechanics to it. */
typedef struct oracle_scene {
    colony *colony;
    species_table species;
    force_set forces;
    size_t nparticles;
    uint32_t *row; /* particle row of each particle of the file */
} oracle_scene;

/* The state called `state`, from the rows of that state in each table ("" and tables of one state: every row). Contact
 * is the published law; rods' springs go through the internal term where all have one constant. */
bool oracle_scene_make(oracle_scene *s, const char *state, const oracle_table *particles, const oracle_table *springs,
                       const oracle_table *params);
void oracle_scene_free(oracle_scene *s);

/* Largest deviation of the accelerations from the state's own, and the largest of those, m/s2. */
void oracle_scene_compare(const oracle_scene *s, const char *state, const oracle_table *particles, const double *force,
                          const double *mass, double *deviation, double *largest);

int oracle_scene_bind(const oracle_scene *s, mechanics *m, diag *d);

#endif
