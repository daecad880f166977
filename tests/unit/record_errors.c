/* SPDX-License-Identifier: GPL-3.0-or-later */
/* For each parameter of each form, wrong arguments made from its record, and the error due: wrong dimension, junk for a
 * number, out of range, a choice or name that is none, a broken expression, a misspelt keyword ("did you mean"), a
 * keyword twice, a value or a required argument that is missing. Afterwards the scene is to the bit as it was. Each
 * word and keyword of a form, and each of its choices, is offered by completion in its place. */
#include "script_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "example_host.h"
#include "script/complete.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <unistd.h>

/* ---- counting ---- */

typedef enum { DIMENSION, JUNK, RANGE, CHOICE, NAME, EXPRESSION, MISSPELT, TWICE, NO_VALUE, REQUIRED, NKINDS } mistake;

static const char *const mistake_names[NKINDS] = {
    "wrong dimension", "junk number", "out of range",  "no such choice", "no such name",
    "no expression",   "misspelt",    "keyword twice", "value missing",  "required missing",
};

static size_t made[NKINDS], wrong;
static script_host host;

/* Runs a wrong line; the errors told must hold both texts (NULL: any). */
static void refuse(interp *in, mistake kind, const char *line, const char *due, const char *also) {
    script_host_clear(&host);
    int status = interp_run_line(in, line);
    made[kind]++;
    if (status != SARCINA_OK && *host.errors && (!due || strstr(host.errors, due)) &&
        (!also || strstr(host.errors, also)))
        return;
    wrong++;
    printf("%s: %s\n  due: %s%s%s\n  got (%d): %s\n", mistake_names[kind], line, due ? due : "an error",
           also ? " and " : "", also ? also : "", status, *host.errors ? host.errors : "no error\n");
}

/* ---- completion ---- */

static size_t offered, not_offered;

/* Whether a word is offered behind this text. */
static void offer(interp *in, const char *text, const char *due) {
    completions c = {0};
    bool found = false;
    complete_line(in, text, strlen(text), &c);
    for (size_t i = 0; i < c.n; i++)
        found = found || strcmp(c.list[i].text, due) == 0;
    if (!found)
        printf("completion of '%s' does not offer '%s' among %zu\n", text, due, c.n);
    offered += found;
    not_offered += !found;
    complete_free(&c);
}

static void offer_choices(interp *in, const slot *s, const char *text) {
    for (size_t i = 0; i < s->nchoices; i++)
        offer(in, text, s->choices[i]);
}

/* ---- a sound line of a form, in words ---- */

enum { WORDS_MAX = 96 };

typedef struct words {
    char *list[WORDS_MAX];
    size_t n;
} words;

/* Words parted by blanks; quotes and parentheses hold together. */
static words split(const char *line) {
    words w = {0};
    while (*(line += strspn(line, " ")) && w.n < WORDS_MAX) {
        size_t n = 0;
        int depth = 0;
        char quote = '\0';
        for (; line[n] && (line[n] != ' ' || depth || quote); n++)
            if (quote)
                quote = line[n] == quote ? '\0' : quote;
            else if (line[n] == '"' || line[n] == '\'')
                quote = line[n];
            else
                depth += (line[n] == '(') - (line[n] == ')');
        w.list[w.n++] = alloc_copy_n(line, n);
        line += n;
    }
    return w;
}

static void free_words(words *w) {
    for (size_t i = 0; i < w->n; i++)
        free(w->list[i]);
    w->n = 0;
}

/* Words from ... to - 1, then `behind`; the caller frees. */
static char *join(const words *w, size_t to, const char *behind) {
    char *text = alloc_copy("");
    for (size_t i = 0; i < to && i < w->n; i++) {
        script_host_append(&text, w->list[i]);
        script_host_append(&text, " ");
    }
    script_host_append(&text, behind);
    return text;
}

/* Words from ... to the end, each behind a blank; the caller frees. */
static char *rest_of(const words *w, size_t from) {
    char *text = alloc_copy("");
    for (size_t i = from; i < w->n; i++) {
        script_host_append(&text, " ");
        script_host_append(&text, w->list[i]);
    }
    return text;
}

/* Whether a line is of this form: its words stand where the head has them. */
static bool is_of(const signature *s, const words *w) {
    for (size_t i = 0; i < s->nhead; i++)
        if (s->head[i].kind == SLOT_LITERAL && (i >= w->n || strcmp(w->list[i], s->head[i].name) != 0))
            return false;
    return s->nhead > 1 || w->n > 0;
}

static bool is_key(const signature *s, const char *word) {
    for (size_t i = 0; i < s->nkey; i++)
        if (strcmp(s->key[i].name, word) == 0)
            return true;
    return false;
}

/* Where the keywords of a line begin. */
static size_t head_end(const signature *s, const words *w) {
    size_t i = s->nhead;
    while (i < w->n && !is_key(s, w->list[i]))
        i++;
    return i < w->n ? i : w->n;
}

/* ---- mistakes by kind of argument ---- */

static const char *other_dimension(const slot *s) {
    return dim_equal(s->d, DIM_TIME) ? "1m" : "1s";
}

/* A number just out of range, in SI; NULL: there is no bound. */
static char *beyond(const slot *s, bool low) {
    double bound = low ? s->lo : s->hi;
    if (!isfinite(bound))
        return NULL;
    bool open = low ? s->lo_open : s->hi_open;
    double step = fmax(fabs(bound), 1e-30) * (s->kind == SLOT_NUMBER ? 0.5 : 1);
    if (s->kind != SLOT_NUMBER && step < 1)
        step = 1;
    return alloc_format("%.15g", open ? bound : low ? bound - step : bound + step);
}

/* Where an argument is tried: all before it, ending in a blank, and all behind it. */
typedef struct place {
    const char *before, *behind;
} place;

static void try_number(interp *in, const slot *s, place at) {
    char *text = alloc_format("%s%s%s", at.before, other_dimension(s), at.behind);
    refuse(in, DIMENSION, text, s->kind == SLOT_NUMBER ? " takes a" : "whole", NULL);
    free(text);
    text = alloc_format("%s0x10%s", at.before, at.behind);
    refuse(in, JUNK, text, "not a number", NULL);
    free(text);
    for (int low = 0; low < 2; low++) {
        char *number = beyond(s, low);
        if (!number)
            continue;
        text = alloc_format("%s%s%s", at.before, number, at.behind);
        bool open = low ? s->lo_open : s->hi_open;
        refuse(in, RANGE, text, low ? (open ? "more than" : "at least") : (open ? "less than" : "at most"), NULL);
        free(text);
        free(number);
    }
}

static void try_choice(interp *in, const slot *s, place at) {
    const char *choice = s->choices[0];
    char *near = alloc_format("%sqx%s", at.before, at.behind), *hint = alloc_format("did you mean '%s'?", choice);
    refuse(in, CHOICE, near, "expected ", NULL);
    free(near);
    if (strlen(choice) > 2) {
        near = alloc_format("%s%s%c%s", at.before, choice, choice[strlen(choice) - 1], at.behind);
        refuse(in, CHOICE, near, hint, NULL);
        free(near);
    }
    free(hint);
}

static void try_name(interp *in, const slot *s, place at) {
    char *text = alloc_format("%snosuchname%s", at.before, at.behind),
         *due = alloc_format("no %s 'nosuchname'", s->kind_name);
    refuse(in, NAME, text, due, NULL);
    free(text);
    free(due);
}

/* What a new name must not be: anything else that expressions know. */
static void try_new(interp *in, const slot *s, place at) {
    if (strcmp(s->kind_name, "dump") == 0)
        return;
    char *text = alloc_format("%stime%s", at.before, at.behind);
    refuse(in, NAME, text, "already", NULL);
    free(text);
}

static void try_text(interp *in, mistake kind, place at, const char *bad, const char *due) {
    char *text = alloc_format("%s%s%s", at.before, bad, at.behind);
    refuse(in, kind, text, due, NULL);
    free(text);
}

/* Wrong values for the argument behind `line`. */
static void try_values(interp *in, const slot *s, place at) {
    switch (s->kind) {
    case SLOT_NUMBER:
    case SLOT_INT:
        try_number(in, s, at);
        break;
    case SLOT_CHOICE:
        try_choice(in, s, at);
        break;
    case SLOT_NAME:
        try_name(in, s, at);
        break;
    case SLOT_NEW:
        try_new(in, s, at);
        break;
    case SLOT_FLAG:
        try_text(in, CHOICE, at, "maybe", "expected yes or no");
        break;
    case SLOT_ANALYSIS:
        try_text(in, NAME, at, "nosuchanalysis", "no analysis 'nosuchanalysis'");
        break;
    case SLOT_CYCLES:
        try_text(in, DIMENSION, at, "1m", "cycles or a time");
        try_text(in, JUNK, at, "1.5", "whole");
        break;
    case SLOT_EVERY:
        try_text(in, DIMENSION, at, "1m \"print a\"", "cycles or a time");
        break;
    case SLOT_RELAXATION:
        try_text(in, DIMENSION, at, "1m", "takes a time");
        try_text(in, DIMENSION, at, "to 1s", "takes a force");
        break;
    case SLOT_BOUND:
        try_text(in, DIMENSION, at, "1s", "takes a length");
        try_text(in, JUNK, at, "0x10", "not a number");
        break;
    case SLOT_LENGTH3:
        try_text(in, DIMENSION, at, "0 1s 0", "takes a length");
        break;
    case SLOT_SIZE:
        try_text(in, JUNK, at, "400 3x", "not a");
        try_text(in, RANGE, at, "4 4", "16 to 16384");
        break;
    case SLOT_RANGE2:
        try_text(in, JUNK, at, "0 0x10", "not a number");
        break;
    case SLOT_ORIENT:
    case SLOT_VIEW:
        try_text(in, CHOICE, at, "upwards", "expected ");
        break;
    case SLOT_COLOR:
        try_text(in, NAME, at, "nosuchcolor", "expected a color");
        break;
    case SLOT_EXPR:
    case SLOT_CELLEXPR:
    case SLOT_VALUE:
    case SLOT_CELL:
    case SLOT_CELLCOLOR:
    case SLOT_FORMULA:
        try_text(in, EXPRESSION, at, "5%", "lacks its right side");
        try_text(in, EXPRESSION, at, "1um+1s", "between length and time");
        break;
    case SLOT_QUANTITY:
        try_text(in, JUNK, at, "0x10", "not a number");
        break;
    default:
        break;
    }
}

/* ---- mistakes of keywords ---- */

static bool takes_nothing(const slot *s) {
    return s->kind == SLOT_NOTHING || s->kind == SLOT_WORDS;
}

static void try_misspelt(interp *in, const slot *s, const char *head) {
    size_t n = strlen(s->name);
    char *slip = alloc_format("%s%s%c 1", head, s->name, s->name[n - 1]), *hint;
    if (n <= 2) /* one letter more makes another word of these */
        slip[strlen(head)] = (char)toupper((unsigned char)s->name[0]), slip[strlen(head) + n] = '\0';
    hint = alloc_format("did you mean '%s'?", s->name);
    refuse(in, MISSPELT, slip, "has no keyword", hint);
    free(hint);
    free(slip);
}

/* The value that the form's example gives the keyword; NULL: none. */
static char *value_in(const signature *s, const words *w, const char *key) {
    for (size_t i = s->nhead; i < w->n; i++) {
        if (strcmp(w->list[i], key) != 0)
            continue;
        char *value = alloc_copy("");
        for (size_t k = i + 1; k < w->n && !is_key(s, w->list[k]); k++) {
            script_host_append(&value, " ");
            script_host_append(&value, w->list[k]);
        }
        return value;
    }
    return NULL;
}

static void try_keyword(interp *in, const signature *s, const slot *key, const words *w) {
    char *head = join(w, head_end(s, w), ""), *line = alloc_format("%s%s ", head, key->name);
    offer(in, head, key->name);
    offer_choices(in, key, line);
    try_misspelt(in, key, head);
    try_values(in, key, (place){line, ""});
    if (!takes_nothing(key))
        refuse(in, NO_VALUE, line, NULL, NULL);
    char *value = value_in(s, w, key->name);
    if (value && key->kind != SLOT_EVERY) {
        char *twice = alloc_format("%s%s%s %s%s", head, key->name, value, key->name, value);
        refuse(in, TWICE, twice, "twice", NULL);
        free(twice);
    }
    free(value);
    free(line);
    free(head);
}

/* ---- a form ---- */

/* Arguments in place: those before the first that may be several words. */
static void try_head(interp *in, const signature *s, const words *w) {
    for (size_t i = 1; i < s->nhead; i++) {
        const slot *one = &s->head[i];
        char *line = join(w, i, ""), *rest = rest_of(w, i + 1);
        if (one->kind == SLOT_LITERAL)
            offer(in, line, one->name);
        offer_choices(in, one, line);
        if (one->kind != SLOT_LITERAL) {
            try_values(in, one, (place){line, rest});
            if (!one->optional)
                refuse(in, NO_VALUE, line, NULL, NULL);
        }
        free(line);
        free(rest);
        if (one->many || one->spread || one->kind == SLOT_EXPR || one->kind == SLOT_REST)
            return;
    }
}

/* Whether two files hold the same bytes. */
static bool same_files(const char *a, const char *b) {
    char *command = alloc_format("cmp %s %s", a, b);
    bool same = system(command) == 0;
    free(command);
    return same;
}

/* Everything that a line of the form may be wrong in, and what completion offers on the way. */
static void try_line(interp *in, const signature *s, const words *w, bool *tried, bool headed) {
    interp_run_line(in, "write_restart before.rst");
    for (size_t k = 0; k < s->nkey; k++) {
        char *value = tried[k] ? NULL : value_in(s, w, s->key[k].name);
        if (value)
            try_keyword(in, s, &s->key[k], w), tried[k] = true;
        free(value);
    }
    if (!headed)
        try_head(in, s, w);
    interp_run_line(in, "write_restart after.rst");
    if (!same_files("before.rst", "after.rst"))
        printf("%s: after its mistakes the scene is another\n", s->form.head), wrong++;
}

/* Every example line of the form, in a scene where the lines before it have run. */
static void try_form(const signature *s) {
    interp *in = example_host_scene(&host);
    const char *line = s->form.example;
    bool tried[PARAM_COUNT_MAX * 4] = {false}, headed = false;
    for (; line && *line; line += strcspn(line, "\n") + (line[strcspn(line, "\n")] == '\n')) {
        char *text = alloc_copy_n(line, strcspn(line, "\n"));
        words w = split(text);
        if (is_of(s, &w)) {
            try_line(in, s, &w, tried, headed);
            headed = true;
        }
        free_words(&w);
        interp_run_line(in, text);
        free(text);
    }
    for (size_t k = 0; k < s->nkey; k++)
        if (!tried[k])
            printf("%s: keyword %s was not tried\n", s->form.head, s->key[k].name), wrong++;
    interp_free(in);
}

static void test_forms(void **state) {
    (void)state;
    const command_table *t = host.commands;
    for (size_t i = 0; i < t->count; i++)
        try_form(&t->list[i]);
    size_t all = 0;
    for (int k = 0; k < NKINDS; k++) {
        printf("%-18s %zu\n", mistake_names[k], made[k]);
        all += made[k];
    }
    printf("%zu forms, %zu wrong lines, %zu answered amiss\n", t->count, all, wrong);
    printf("%zu words offered by completion in their places, %zu not\n", offered, not_offered);
    assert_int_equal(wrong, 0);
    assert_int_equal(not_offered, 0);
}

/* A required keyword left out, in a scene that has nothing of the form yet. */
static void test_required(void **state) {
    (void)state;
    const command_table *t = host.commands;
    for (size_t i = 0; i < t->count; i++) {
        const signature *s = &t->list[i];
        bool required = false;
        for (size_t k = 0; k < s->nkey; k++)
            required = required || s->key[k].required || s->key[k].group;
        const char *line = s->form.example;
        words w = split(line);
        if (required && is_of(s, &w)) {
            interp *in = interp_create(&host.host);
            char *bare = join(&w, head_end(s, &w), "");
            interp_run_line(in, "species cf coccus");
            if (strcmp(s->head[0].name, "species") != 0)
                interp_run_line(in, "species ecoli rod diameter 1um");
            interp_run_line(in, "region box block 0 1um 0 1um 0 1um");
            refuse(in, REQUIRED, bare, "needs ", NULL);
            free(bare);
            interp_free(in);
        }
        free_words(&w);
    }
    printf("%zu forms with required keywords, %zu answered amiss\n", made[REQUIRED], wrong);
    assert_true(made[REQUIRED] > 5);
    assert_int_equal(wrong, 0);
}

static int open_all(void **state) {
    (void)state;
    return example_host_open(&host);
}

static int close_all(void **state) {
    (void)state;
    return example_host_close(&host);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_required), cmocka_unit_test(test_forms)};
    return cmocka_run_group_tests_name("record_errors", tests, open_all, close_all);
}
