/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the writers of the manual share: text in mdoc(7), and where the pages come from. */
#ifndef SARCINA_APP_MANDOC_H
#define SARCINA_APP_MANDOC_H

#include "script/page.h"
#include "script/signature.h"
#include "script/topic.h"

#include <stdbool.h>

/* Where the generated files go, and what they are made from. */
typedef struct mandoc {
    const command_table *commands;
    const char *source; /* folder of the sources: man/src and what its pages quote */
    const char *target; /* folder the files go below */
    bool failed;
} mandoc;

/* Writes target/path, or says why not and notes the failure. */
void mandoc_write(mandoc *m, const char *path, const page *p);

/* The head of a page: sarcina-NAME(section), and its summary. */
void mandoc_begin(page *p, const char *name, int section, const char *summary);

/* Text as the body of paragraphs: one sentence a line, an empty line parts paragraphs. */
void mandoc_text(page *p, const char *text);

/* Text within a line, where macros and escapes mean nothing. */
void mandoc_escape(page *p, const char *text);

/* Lines as they are, indented. */
void mandoc_literal(page *p, const char *text);

/* "SEE ALSO" of command names parted by blanks, behind those every page names. */
void mandoc_see(page *p, const command_table *t, const char *names);

/* A list of terms and what they mean, row by row. */
void mandoc_rows(page *p, topic_row *rows);

/* The sections that topics are, one a topic. */
void mandoc_topics(page *p);

/* The pages of man/src, whose lines @NAME stand for what comes from tables (mandoc_source.c). */
void mandoc_sources(mandoc *m);

/* Syntax files for Vim and VS Code, in editors/; completion by bash, in completions/. */
void mandoc_editors(mandoc *m);
void mandoc_shells(mandoc *m);

/* One page a command: sarcina-COMMAND(7). */
void mandoc_commands(mandoc *m);

#endif
