/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parsed form of command records: what `param` specifications and the heads of forms say, as data. The notation
 * is that of command.h. From these come the reader of arguments, usage lines, help, completion and suggestions. */
#ifndef SARCINA_SCRIPT_SIGNATURE_H
#define SARCINA_SCRIPT_SIGNATURE_H

#include "base/units.h"
#include "script/command.h"

typedef enum {
    SLOT_LITERAL,
    SLOT_NUMBER,
    SLOT_INT,
    SLOT_FLAG,
    SLOT_NOTHING,
    SLOT_CHOICE,
    SLOT_WORD,
    SLOT_TEXT,
    SLOT_FILE,
    SLOT_FILEOFF,
    SLOT_REST,
    SLOT_NEW,  /* +class */
    SLOT_NAME, /* class */
    SLOT_ANALYSIS,
    SLOT_EXPR,
    SLOT_CELLEXPR,
    SLOT_VALUE,
    SLOT_CELL,
    SLOT_FORMULA,
    SLOT_COMMAND,
    SLOT_EVERY,
    SLOT_CYCLES,
    SLOT_RELAXATION,
    SLOT_ORIENT,
    SLOT_BOUND,
    SLOT_LENGTH3,
    SLOT_SIZE,
    SLOT_VIEW,
    SLOT_RANGE2,
    SLOT_QUANTITY,
    SLOT_COLOR,
    SLOT_CELLCOLOR,
    SLOT_COLUMNFORMAT,
    SLOT_WORDS,
    SLOT_KIND_COUNT
} slot_kind;

typedef struct slot {
    slot_kind kind;
    char name[48];      /* of the argument; a literal: the word */
    char kind_name[32]; /* "length", "species" ...: in usage lines and errors */
    dim d;
    bool required, spread, percent, many, optional, star;
    int group;     /* one of each group > 0 is required */
    char *initial; /* default text; NULL */
    double lo, hi; /* range in SI; infinite: none */
    bool lo_open, hi_open;
    const char *lo_text, *hi_text; /* as the record writes it; NULL: none */
    char **choices;
    size_t nchoices;
    const char *summary;
} slot;

typedef struct choice_text {
    char *choice, *summary;
} choice_text;

typedef struct signature {
    command_form form;
    char *head_text;              /* owned copy of form.head */
    const char *formula, *source; /* of a style; NULL */
    choice_text *choices;         /* what its choices mean, those that need to be told */
    size_t nchoices;
    slot *head; /* head[0] is the command's word */
    size_t nhead;
    slot *key;
    size_t nkey;
    size_t off_at; /* `off` may stand at this place of the head; 0: nowhere */
} signature;

struct command_table {
    units *units;
    signature *list;
    size_t count, capacity;
    const name_class **classes;
    size_t nclasses, class_capacity;
    const command_page *pages;
    size_t npages;
    const char *prelude;
    const command_file *files; /* of the prelude */
    size_t nfiles;
    void (*line_begins)(interp *in);
    void (*line_ended)(interp *in, const char *text, int status);
    void *(*client_create)(interp *in);
    void (*client_free)(void *client);
    void (*client_loop_end)(interp *in);
    void (*client_checked)(interp *in);
};

/* Parses a form; what is wrong with it goes to d. free with signature_free. */
int signature_parse(const command_form *form, units *u, signature *out, diag *d);
void signature_free(signature *s);

/* The argument called name: in the head or a keyword; NULL. *index: its place, head first, then keywords. */
const slot *signature_find(const signature *s, const char *name, size_t *index);

/* What one of its choices means; NULL when there is nothing to say. */
const char *signature_choice(const signature *s, const char *choice);

/* The forms of one command, in the order of the table; returns how many there are (at most room are listed). */
size_t signature_forms(const command_table *t, const char *command, const signature **list, size_t room);

/* The i-th of all commands by name, in the order of the table; NULL when there are fewer. */
const char *signature_command(const command_table *t, size_t i);

/* The first word behind the command's that stands for itself, "image" of dump image; "" when there is none. */
const char *signature_style(const signature *s);

/* The page of a command; NULL. */
const command_page *signature_page(const command_table *t, const char *command);

/* "species NAME rod (diameter LENGTH [sd ...] | aspect ...) [density DENSITY]"; the caller frees. */
char *signature_usage(const signature *s);

#endif
