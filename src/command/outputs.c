/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/outputs.h"

#include "command/analyze_bins.h"
#include "command/output_list.h"
#include "command/session.h"

#include "base/alloc.h"
#include "script/reader.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

outputs *output_list_of(interp *in) {
    return session_of(in)->out;
}

outputs *outputs_create(interp *in) {
    outputs *o = alloc_zeroed(1, sizeof *o);
    o->in = in;
    o->table = thermo_create();
    output_list_default_thermo(o);
    return o;
}

void output_list_release_columns(output_column *columns, size_t n) {
    for (size_t i = 0; i < n; i++) {
        if (columns[i].release)
            columns[i].release(columns[i].self);
        free(columns[i].name);
    }
    free(columns);
}

static void release_dump(output_dump *p) {
    free(p->id);
    free(p->group);
    dump_free(p->file);
    output_list_release_columns(p->columns, p->ncolumns);
}

static void release_analysis(output_analysis *p) {
    free(p->id);
    free(p->group);
    expr_free(p->test);
    output_list_release_columns(p->kept, p->nkept);
    output_list_release_columns(p->of, p->of != NULL);
    free(p->values);
    analyze_bins_free(p->bins);
    stream_free(p->file);
}

void output_list_drop_dump(outputs *o, size_t i) {
    release_dump(&o->dumps[i]);
    memmove(&o->dumps[i], &o->dumps[i + 1], (--o->ndumps - i) * sizeof *o->dumps);
}

void output_list_drop_analysis(outputs *o, size_t i) {
    release_analysis(&o->analyses[i]);
    memmove(&o->analyses[i], &o->analyses[i + 1], (--o->nanalyses - i) * sizeof *o->analyses);
}

static void forget_resumed(outputs *o) {
    for (size_t i = 0; i < o->nresumed; i++)
        free(o->resumed[i]);
    o->nresumed = 0;
}

void outputs_clear(outputs *o) {
    while (o->ndumps)
        output_list_drop_dump(o, o->ndumps - 1);
    while (o->nanalyses)
        output_list_drop_analysis(o, o->nanalyses - 1);
    thermo_free(o->table);
    o->table = thermo_create();
    output_list_default_thermo(o);
    stream_free(o->results);
    o->results = NULL; /* of the scene that comes now */
    o->resumed_step = 0;
    o->thermo_every = (args_cycles_value){0};
    o->headed = o->has_row = false;
    forget_resumed(o);
}

void outputs_free(outputs *o) {
    if (!o)
        return;
    outputs_clear(o);
    thermo_free(o->table);
    free(o->dumps);
    free(o->analyses);
    free(o->resumed);
    free(o);
}

/* ---- groups ----------------------------------------------------------------------------------------------------- */

int output_list_members(interp *in, const char *group, bool **flags, diag *d) {
    int row = session_find_group(in, group);
    *flags = NULL;
    if (row <= 0) /* all: session_check_unused keeps what output looks at */
        return SARCINA_OK;
    *flags = alloc_zeroed(interp_scene(in)->colony->cell.count, sizeof **flags);
    int status = session_members(in, row, *flags, d);
    if (status) {
        free(*flags);
        *flags = NULL;
    }
    return status;
}

bool output_list_knows(const args *a, const char *name) {
    replacement note;
    return !args_unknown(a, name, &note);
}

/* ---- a run ------------------------------------------------------------------------------------------------------ */

bool outputs_due(args_cycles_value every, uint64_t step, double before, double now) {
    if (!every.is_time)
        return every.cycles > 0 && step % every.cycles == 0;
    if (!(every.time > 0))
        return false;
    /* whole intervals passed; a time that is one but for rounding has passed it */
    return floor(now / every.time + 1e-9) > floor(before / every.time + 1e-9);
}

/* At the beginning of a run nothing has been passed: due is what falls on this very step. */
static bool due_now(args_cycles_value every, const scene *s) {
    if (!every.is_time)
        return outputs_due(every, s->step, 0, 0);
    double intervals = s->time / every.time;
    return fabs(intervals - round(intervals)) <= 1e-9 * fmax(1, intervals);
}

static bool is_due(const outputs *o, args_cycles_value every, bool begins) {
    const scene *s = interp_scene(o->in);
    return begins ? due_now(every, s) : outputs_due(every, s->step, o->before, s->time);
}

static int open_all(outputs *o, diag *d) {
    int status = thermo_open(o->table, d);
    for (size_t i = 0; i < o->ndumps && !status; i++)
        status = output_list_open_dump(&o->dumps[i], d);
    for (size_t i = 0; i < o->nanalyses && !status; i++)
        status = output_list_open_analysis(&o->analyses[i], d);
    return status;
}

/* The row of the present step, once below each heading. */
static int print_row(outputs *o, diag *d) {
    uint64_t step = interp_scene(o->in)->step;
    bool screen = !o->has_row || o->row_step != step, log = !o->has_log_row || o->row_step != step;
    if (!screen && !log)
        return SARCINA_OK;
    o->has_row = o->has_log_row = true;
    o->row_step = step;
    return output_list_print_row(o, screen, log, d);
}

/* Whatever is due at the present step. */
static int write_due(outputs *o, bool begins, bool row, diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < o->nanalyses && !status; i++)
        if (!begins)
            status = output_list_judge(o, &o->analyses[i], d);
    if (!status && (row || is_due(o, o->thermo_every, begins)))
        status = print_row(o, d);
    for (size_t i = 0; i < o->nanalyses && !status; i++)
        if ((o->analyses[i].file || o->analyses[i].bins) && is_due(o, o->analyses[i].every, begins))
            status = output_list_write_analysis(o, &o->analyses[i], d);
    for (size_t i = 0; i < o->ndumps && !status; i++)
        if (is_due(o, o->dumps[i].every, begins))
            status = output_list_write_dump(o, &o->dumps[i], d);
    return status;
}

int outputs_open(outputs *o, diag *d) {
    return open_all(o, d);
}

int outputs_begin(outputs *o, diag *d) {
    o->before = interp_scene(o->in)->time;
    /* runs of a loop go on with one table on the screen */
    bool anew = !o->headed || !interp_in_loop(o->in);
    output_list_print_header(o, anew);
    o->headed = true;
    o->has_row = o->has_row && !anew;
    o->has_log_row = false;
    return write_due(o, true, true, d);
}

int outputs_step(outputs *o, bool last, diag *d) {
    int status = write_due(o, false, last, d);
    o->before = interp_scene(o->in)->time;
    return status;
}

void outputs_end(outputs *o) {
    (void)o; /* files are flushed with every block */
}

/* ---- restart files ---------------------------------------------------------------------------------------------- */

bool output_list_resumes(const outputs *o, const char *path, uint64_t *step) {
    *step = o->resumed_step;
    for (size_t i = 0; i < o->nresumed; i++)
        if (strcmp(o->resumed[i], path) == 0)
            return true;
    return false;
}

/* One line each: what it is, its numbers, then the name that may hold blanks. */
static void save_dump(FILE *out, const output_dump *p) {
    fprintf(out, "dump %" PRIu64 " %s\n", dump_last(p->file), p->id);
    fprintf(out, "file %s\n", dump_pattern(p->file));
}

static void save_analysis(FILE *out, const output_analysis *p) {
    if (p->file)
        fprintf(out, "file %s\n", stream_path(p->file));
    if (!p->happened)
        return;
    fprintf(out, "first %s %a %a %zu", p->id, p->step, p->time, p->nkept);
    for (size_t i = 0; i < p->nkept; i++)
        fprintf(out, " %a", p->values[i]);
    fputc('\n', out);
}

void outputs_save(const outputs *o, archive *a) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (thermo_file(o->table))
        fprintf(out, "file %s\n", thermo_file(o->table));
    for (size_t i = 0; i < o->ndumps; i++)
        save_dump(out, &o->dumps[i]);
    for (size_t i = 0; i < o->nanalyses; i++)
        save_analysis(out, &o->analyses[i]);
    fclose(out);
    archive_put(a, "outputs", text, size);
    free(text);
    char *history = thermo_save(o->table, &size);
    archive_put(a, "thermo", history, size);
    free(history);
}

static void load_file(outputs *o, const char *path) {
    o->resumed = alloc_grow(o->resumed, &o->resumed_capacity, o->nresumed + 1, sizeof *o->resumed);
    o->resumed[o->nresumed++] = alloc_copy(path);
}

static void load_dump(outputs *o, const char *line) {
    uint64_t last;
    int at = 0;
    if (sscanf(line, "%" SCNu64 " %n", &last, &at) != 1)
        return;
    for (size_t i = 0; i < o->ndumps; i++)
        if (strcmp(o->dumps[i].id, line + at) == 0)
            dump_set_last(o->dumps[i].file, last);
}

static void load_first(outputs *o, const char *line) {
    char id[128];
    double step, time;
    size_t n;
    int at = 0;
    if (sscanf(line, "%127s %la %la %zu%n", id, &step, &time, &n, &at) != 4)
        return;
    for (size_t i = 0; i < o->nanalyses; i++) {
        output_analysis *p = &o->analyses[i];
        if (strcmp(p->id, id) != 0 || p->nkept != n)
            continue;
        p->happened = true;
        p->step = step;
        p->time = time;
        char *end = (char *)line + at;
        for (size_t k = 0; k < n; k++)
            p->values[k] = strtod(end, &end);
    }
}

/* The files that stand go back to the step of the restart. */
static int rewind_files(outputs *o, diag *d) {
    uint64_t step;
    int status = SARCINA_OK;
    if (thermo_file(o->table) && output_list_resumes(o, thermo_file(o->table), &step))
        status = thermo_rewind(o->table, step, d);
    for (size_t i = 0; i < o->ndumps && !status; i++)
        if (output_list_resumes(o, dump_pattern(o->dumps[i].file), &step))
            status = dump_rewind(o->dumps[i].file, step, d);
    for (size_t i = 0; i < o->nanalyses && !status; i++)
        if (o->analyses[i].file && output_list_resumes(o, stream_path(o->analyses[i].file), &step))
            status = stream_rewind(o->analyses[i].file, step, d);
    return status;
}

int outputs_load(outputs *o, const archive *a, diag *d) {
    const char *text = archive_get(a, "outputs", NULL);
    forget_resumed(o);
    o->resumed_step = interp_scene(o->in)->step;
    while (text && *text) {
        size_t n = strcspn(text, "\n");
        char *line = alloc_copy_n(text, n);
        if (strncmp(line, "file ", 5) == 0)
            load_file(o, line + 5);
        else if (strncmp(line, "dump ", 5) == 0)
            load_dump(o, line + 5);
        else if (strncmp(line, "first ", 6) == 0)
            load_first(o, line + 6);
        free(line);
        text += n + (text[n] == '\n');
    }
    size_t n = 0;
    const char *history = archive_get(a, "thermo", &n);
    if (history)
        thermo_load(o->table, history, n);
    return rewind_files(o, d);
}
