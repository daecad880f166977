/* SPDX-License-Identifier: GPL-3.0-or-later */
/* thermo N | thermo_style one | thermo_style custom COLUMN... | thermo_modify: the table a run prints. */
#include "command/commands.h"
#include "command/output_list.h"
#include "command/results.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/table.h"

#include <stdlib.h>

/* ---- the columns of thermo_style one: values of the whole scene -------------------------------------------------- */

typedef struct plain_column {
    interp *in;
    const value_style *style;
    dim d;
    size_t out; /* 0: the bare name's number; else 1 + the field's row */
} plain_column;

static int plain_number(void *self, uint32_t row, double *si, diag *d) {
    (void)row;
    const plain_column *c = self;
    double out[1 + VALUE_FIELDS_MAX];
    view v = scene_view(interp_scene(c->in));
    int status = c->style->measure(&v, NULL, out, d);
    *si = dim_from_engine(out[c->out], c->d);
    return status;
}

output_column output_list_plain_column(interp *in, const char *name, const char *field) {
    plain_column *c = alloc_zeroed(1, sizeof *c);
    *c = (plain_column){.in = in, .style = value_find(name)};
    output_column column = {.d = value_dim(c->style), .self = c, .number = plain_number, .release = free};
    char known[32];
    if (field) {
        c->out = 1 + (size_t)value_field_find(c->style, field);
        value_field(c->style, c->out - 1, known, &column.d);
    }
    c->d = column.d;
    column.name = field ? alloc_format("%s.%s", name, field) : alloc_copy(name);
    return column;
}

void output_list_default_thermo(outputs *o) {
    static const char *const names[] = {"step", "time", "relaxed", "cells", "links", "fmax"};
    output_column columns[TABLE_COUNT(names)];
    for (size_t i = 0; i < TABLE_COUNT(names); i++)
        columns[i] = output_list_plain_column(o->in, names[i], NULL);
    thermo_set_columns(o->table, columns, TABLE_COUNT(names));
}

/* ---- printing ---------------------------------------------------------------------------------------------------- */

/* The screen shows the units of the script's bare numbers; the file is in SI. */
static void prepare_units(outputs *o) {
    for (size_t i = 0; i < thermo_count(o->table); i++)
        thermo_set_unit(o->table, i, interp_unit(o->in, thermo_column(o->table, i)->d));
}

typedef struct printer {
    interp *in;
    bool screen, log;
} printer;

static void print_line(void *self, const char *line) {
    const printer *p = self;
    if (p->screen)
        interp_screen(p->in, "%s", line);
    if (p->log)
        interp_log(p->in, "%s", line);
}

void output_list_print_header(outputs *o, bool screen) {
    printer p = {o->in, screen, true};
    prepare_units(o);
    thermo_header(o->table, print_line, &p);
}

int output_list_print_row(outputs *o, bool screen, bool log, diag *d) {
    printer p = {o->in, screen, log};
    int status = thermo_row(o->table, interp_scene(o->in)->step, print_line, &p, d);
    return status ? status : results_row(o, d);
}

/* ---- the commands ------------------------------------------------------------------------------------------------ */

static int run_thermo(interp *in, const args *a, diag *d) {
    (void)d;
    output_list_of(in)->thermo_every = args_cycles(a, "N");
    return SARCINA_OK;
}

/* After a change of columns or file: the table wants its header again; a file that a restart was writing goes on. */
static int begin_anew(outputs *o, diag *d) {
    uint64_t step;
    o->headed = false;
    const char *path = thermo_file(o->table);
    return path && output_list_resumes(o, path, &step) ? thermo_rewind(o->table, step, d) : SARCINA_OK;
}

static int run_style_one(interp *in, const args *a, diag *d) {
    (void)a;
    outputs *o = output_list_of(in);
    output_list_default_thermo(o);
    return begin_anew(o, d);
}

static int run_style_custom(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    size_t n = args_count(a, "COLUMN"), made = 0;
    output_column *columns = alloc_zeroed(n, sizeof *columns);
    int status = SARCINA_OK;
    for (; made < n && !status; made += !status)
        status = interp_column(in, args_expr_at(a, "COLUMN", made), false, &columns[made], d);
    if (status) {
        output_list_release_columns(columns, made);
        return status;
    }
    thermo_set_columns(o->table, columns, n);
    free(columns);
    return begin_anew(o, d);
}

/* Units of the i-th column as a suffix of its heading; "" takes it away. */
static void set_suffixes(outputs *o, bool on) {
    for (size_t i = 0; i < thermo_count(o->table); i++) {
        char suffix[48];
        thermo_set_suffix(o->table, i, on ? dim_suffix(thermo_column(o->table, i)->d, suffix) : "");
    }
}

static int set_file(outputs *o, const args *a, diag *d) {
    const char *path = args_text(a, "file");
    int status = path && output_list_knows(a, "file") ? path_check(path, d) : SARCINA_OK;
    if (status) {
        diag_place(d, args_span(a, "file"));
        return status;
    }
    thermo_set_file(o->table, path);
    return begin_anew(o, d);
}

static int run_modify(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    int status = SARCINA_OK;
    if (args_given(a, "format")) {
        const char *column, *format;
        args_column_format(a, "format", &column, &format);
        status = thermo_set_format(o->table, column, format, d);
        if (status)
            diag_place(d, args_span(a, "format"));
    }
    if (!status && args_given(a, "file"))
        status = set_file(o, a, d);
    if (!status && args_given(a, "units"))
        set_suffixes(o, args_flag(a, "units"));
    return status;
}

static const param thermo_params[] = {{"N:cycles[0,)", "cycles, or a time, between rows; 0: first and last row only"}};
static const param custom_params[] = {{"COLUMN:value...", "a value of the scene, or a formula without blanks"}};
static const param modify_params[] = {
    {"file:fileoff", "write every row also to this CSV file, in SI units"},
    {"format:columnformat", "a column's heading and its format on the screen"},
    {"units:flag", "units behind the headings"},
};

static const command_form forms[] = {
    {"thermo N:cycles[0,)", thermo_params, TABLE_COUNT(thermo_params), "Sets how often a run prints its table",
     "The first and the last row of a run are always printed.", "thermo 5", COMMAND_DECLARES, run_thermo, NULL, 0},
    {"thermo_style one", NULL, 0, "The table of a run: step time relaxed cells links fmax", NULL, "thermo_style one",
     COMMAND_DECLARES, run_style_one, NULL, 0},
    {"thermo_style custom COLUMN:value...", custom_params, TABLE_COUNT(custom_params),
     "The table of a run: columns of your own", NULL, "thermo_style custom step time/1h cells thickness",
     COMMAND_DECLARES, run_style_custom, NULL, 0},
    {"thermo_modify", modify_params, TABLE_COUNT(modify_params), "Changes how the table is written",
     "The file has a header of names, numbers that read back to the bit, and nan where a value is undefined. A step is "
     "written to it once; going on from a restart file it loses the rows after that step.",
     "thermo_style custom step time cells thickness\nthermo_modify file growth.csv format thickness %.3g units yes",
     COMMAND_DECLARES, run_modify, NULL, 0},
};

void command_thermo(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
