/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/past.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "command/session.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A line that changed the state. */
typedef struct entry {
    char *text;      /* as the saved script has it */
    bool given;      /* it ran before the prompt: no undo */
    archive *before; /* the state to go back to; NULL: dropped, or given */
    archive *after;  /* the line was broken off, and only this says where; NULL: it ran to its end */
} entry;

struct past {
    archive *now;  /* the state as it is; another object of the same bytes stands in no entry */
    uint64_t step; /* of it */
    entry *list;
    size_t n, capacity;
    size_t dropped; /* entries from the first whose states were dropped */
    char *last, *next;
};

/* ---- states ------------------------------------------------------------------------------------------------------ */

static archive *take_state(interp *in) {
    archive *a = session_pack(in);
    char *settings = interp_settings_save(in);
    archive_put(a, "settings", settings, strlen(settings));
    free(settings);
    return a;
}

/* Lays a state in. Its commands have warned once; they do not again. Settings last: the replay may set some. */
static int lay_in(interp *in, const archive *a, diag *d) {
    interp_set_warn(in, WARN_OFF);
    int status = interp_variables_restore(in, archive_get(a, "variables", NULL), d);
    if (!status)
        status = session_unpack(in, a, d);
    /* the replay and the loading keep what the command line set, loops included */
    if (!status)
        status = interp_variables_restore(in, archive_get(a, "variables", NULL), d);
    interp_settings_load(in, archive_get(a, "settings", NULL));
    return status;
}

static void free_entry(entry *e) {
    free(e->text);
    archive_free(e->before);
    archive_free(e->after);
}

void past_begin(interp *in) {
    session *s = session_of(in);
    if (s->past)
        return;
    s->past = alloc_zeroed(1, sizeof *s->past);
    s->past->now = take_state(in);
    s->past->step = interp_scene(in)->step;
}

void past_free(past *p) {
    if (!p)
        return;
    for (size_t i = 0; i < p->n; i++)
        free_entry(&p->list[i]);
    free(p->list);
    archive_free(p->now);
    free(p->last);
    free(p->next);
    free(p);
}

/* Drops the oldest states until the rest fits; the newest stays. */
static void make_room(interp *in, past *p) {
    size_t used = archive_bytes(p->now), kept = p->n;
    while (kept > p->dropped && p->list[kept - 1].before) {
        used += archive_bytes(p->list[kept - 1].before);
        if (used > interp_undo_bytes(in) && kept < p->n)
            break;
        kept--;
    }
    if (kept == p->dropped || !p->list[kept - 1].before)
        return;
    if (p->dropped == 0)
        interp_screen(in, "from here on undo goes back %zu %s: older states are dropped", p->n - kept,
                      number_noun(p->n - kept, "command", "commands"));
    for (size_t i = p->dropped; i < kept; i++) {
        archive_free(p->list[i].before);
        p->list[i].before = NULL;
    }
    p->dropped = kept;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/* A run that was broken off, as one of the cycles that it did: `run 100 ...` is `run 37 ...`. NULL: the line is
 * something else, or its commands of every may have been broken off with it. */
static char *shorten_run(interp *in, const char *text, uint64_t before) {
    const scene *s = interp_scene(in);
    size_t from = strspn(text, " \t"), word = from + 3 + strspn(text + from + 3, " \t");
    if (strncmp(text + from, "run", 3) != 0 || word == from + 3 || strchr(text, '\n') || strstr(text, " every "))
        return NULL;
    bool upto = strstr(text, " upto") != NULL;
    const char *rest = text + word + strcspn(text + word, " \t");
    return alloc_format("run %" PRIu64 "%s", upto ? s->step : s->step - before, rest);
}

/* The line as a script has it. *whole: the script does what the line did. */
static char *script_line(interp *in, const char *text, int status, uint64_t before, bool *whole) {
    char *line = status ? shorten_run(in, text, before) : NULL;
    *whole = !status || line;
    if (line)
        return line;
    /* an expression that changed the state has drawn random numbers: so does the script */
    return !status && interp_is_expression(in, text) ? alloc_format("print $(%s)", text) : alloc_copy(text);
}

static void add(interp *in, const char *text, int status, bool given) {
    past *p = session_of(in)->past;
    archive *state = take_state(in);
    if (archive_share(state, p->now)) {
        archive_free(state);
        return;
    }
    bool whole;
    entry e = {.text = script_line(in, text, status, p->step, &whole), .given = given};
    if (given)
        archive_free(p->now);
    else
        e.before = p->now;
    if (!whole) {
        e.after = take_state(in);
        archive_share(e.after, state);
    }
    p->list = alloc_grow(p->list, &p->capacity, p->n + 1, sizeof *p->list);
    p->list[p->n++] = e;
    p->now = state;
    p->step = interp_scene(in)->step;
    make_room(in, p);
}

void past_ran(interp *in, const char *text, int status) {
    past *p = session_of(in)->past;
    add(in, text, status, false);
    if (strncmp(text, "edit", 4) == 0)
        return;
    free(p->last);
    p->last = alloc_copy(text);
}

void past_given(interp *in, const char *text, int status) {
    add(in, text, status, true);
}

/* A text as one quoted word of a script; the caller frees. */
static char *quote(const char *text) {
    const char *mark = !strchr(text, '"') ? "\"" : !strchr(text, '\'') ? "'" : "\"\"\"";
    char *doubled = alloc_zeroed(2 * strlen(text) + 1, 1), *to = doubled;
    for (; *text; text++) {
        *to++ = *text;
        if (*text == '$')
            *to++ = '$';
    }
    char *quoted = alloc_format("%s%s%s", mark, doubled, mark);
    free(doubled);
    return quoted;
}

void past_given_file(interp *in, const char *path, int status) {
    char *name = quote(path), *command = alloc_format("include %s", name);
    past_given(in, command, status);
    free(command);
    free(name);
}

void past_given_variable(interp *in, const char *name, const char *text) {
    past *p = session_of(in)->past;
    char *value = quote(text);
    p->list = alloc_grow(p->list, &p->capacity, p->n + 1, sizeof *p->list);
    p->list[p->n++] = (entry){.text = alloc_format("variable %s default %s", name, value), .given = true};
    free(value);
}

const char *past_last(interp *in) {
    return session_of(in)->past->last;
}

void past_set_next(interp *in, const char *text) {
    past *p = session_of(in)->past;
    free(p->next);
    p->next = alloc_copy(text);
}

char *past_take_next(interp *in) {
    past *p = session_of(in)->past;
    char *next = p ? p->next : NULL;
    if (p)
        p->next = NULL;
    return next;
}

/* ---- undo -------------------------------------------------------------------------------------------------------- */

/* A block as its first and last line. */
static void tell_undone(interp *in, const char *text) {
    const char *last = strrchr(text, '\n');
    if (!last)
        interp_screen(in, "undone: %s", text);
    else
        interp_screen(in, "undone: %.*s … %s", (int)strcspn(text, "\n"), text, last + 1 + strspn(last + 1, " \t"));
}

static int check_levels(const past *p, size_t n, diag *d) {
    for (size_t i = 0; i < n; i++) {
        const entry *e = i < p->n ? &p->list[p->n - 1 - i] : NULL;
        if (e && e->before)
            continue;
        if (e && !e->given)
            return diag_error(d, "undo goes back no further than %zu %s: older states have been dropped", i,
                              number_noun(i, "command", "commands"));
        return i ? diag_error(d, "there %s %zu %s to undo", number_noun(i, "is", "are"), i,
                              number_noun(i, "command", "commands"))
                 : diag_error(d, "there is nothing to undo");
    }
    return SARCINA_OK;
}

int past_undo(interp *in, size_t n, diag *d) {
    past *p = session_of(in)->past;
    int status = check_levels(p, n, d);
    if (status)
        return status;
    const entry *first = &p->list[p->n - n];
    status = lay_in(in, first->before, d);
    if (status) { /* not seen to happen: a state that stood can be laid in */
        lay_in(in, p->now, NULL);
        return status;
    }
    archive_free(p->now);
    p->now = p->list[p->n - n].before;
    p->list[p->n - n].before = NULL;
    p->step = interp_scene(in)->step;
    for (size_t i = 0; i < n; i++) {
        entry *e = &p->list[--p->n];
        tell_undone(in, e->text);
        free_entry(e);
    }
    return SARCINA_OK;
}

/* ---- save -------------------------------------------------------------------------------------------------------- */

/* A text behind "# ", line by line. */
static void put_comment(FILE *f, const char *text) {
    for (size_t n; *text; text += n + (text[n] == '\n')) {
        n = strcspn(text, "\n");
        fprintf(f, "# %.*s\n", (int)n, text);
    }
}

/* What was broken off, and the commands before it, as comments; then the file that holds what they did. */
static int save_broken(interp *in, FILE *f, const char *path, size_t last, diag *d) {
    const past *p = session_of(in)->past;
    char *restart = alloc_format("%s.rst", path);
    const char *slash = strrchr(restart, '/');
    fputs("# the last of these did not run to its end; the restart file holds what it and those before it have done\n",
          f);
    for (size_t i = 0; i <= last; i++)
        put_comment(f, p->list[i].text);
    fprintf(f, "read_restart \"${here}/%s\"\n", slash ? slash + 1 : restart);
    int status = archive_write(p->list[last].after, restart, d);
    free(restart);
    return status;
}

int past_save(interp *in, const char *path, size_t *lines, diag *d) {
    const past *p = session_of(in)->past;
    FILE *f = path_open(path, "w", d);
    if (!f)
        return SARCINA_ERROR;
    fprintf(f, "# saved by sarcina %s on %s; replays this session's scene\n", SARCINA_VERSION, interp_date(in));
    size_t first = 0;
    for (size_t i = 0; i < p->n; i++)
        first = p->list[i].after ? i + 1 : first;
    int status = first ? save_broken(in, f, path, first - 1, d) : SARCINA_OK;
    for (size_t i = first; i < p->n; i++)
        fprintf(f, "%s\n", p->list[i].text);
    *lines = p->n - first + (first > 0);
    int closed = path_close(f, path, status ? NULL : d);
    return status ? status : closed;
}
