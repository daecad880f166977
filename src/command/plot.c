/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot Y... vs X file F: columns of the thermo table, at every row it has had. */
#include "command/commands.h"
#include "command/output_list.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/table.h"
#include "output/plot.h"

#include <stdlib.h>
#include <string.h>

/* Its column in the table; -1. */
static int find_column(const outputs *o, const char *name) {
    for (size_t i = 0; i < thermo_count(o->table); i++)
        if (strcmp(thermo_column(o->table, i)->name, name) == 0)
            return (int)i;
    return -1;
}

static int refuse(const outputs *o, const char *name, span at, diag *d) {
    diag_error(d, "'%s' has not been recorded: it is no column of the thermo table", name);
    diag_place(d, at);
    char list[400] = "";
    for (size_t i = 0; i < thermo_count(o->table); i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), " %s", thermo_column(o->table, i)->name);
    return diag_help(d, "there are:%s; thermo_style custom ... chooses them", list);
}

static int make_series(const outputs *o, expr *e, span at, plot_series *out, diag *d) {
    int i = find_column(o, expr_text(e));
    if (i < 0)
        return refuse(o, expr_text(e), at, d);
    const output_column *column = thermo_column(o->table, (size_t)i);
    if (column->is_text) {
        diag_error(d, "a diagram is of numbers, and '%s' is a text", column->name);
        diag_place(d, at);
        return SARCINA_ERROR;
    }
    *out = (plot_series){.name = column->name, .d = column->d};
    out->values = thermo_history(o->table, (size_t)i);
    return SARCINA_OK;
}

enum { SERIES_MAX = 16 };

static int make_all(const outputs *o, const args *a, plot_series all[SERIES_MAX + 1], diag *d) {
    size_t n = args_count(a, "Y");
    if (n > SERIES_MAX) {
        diag_error(d, "a diagram has at most %d lines", SERIES_MAX);
        diag_place(d, args_span_at(a, "Y", SERIES_MAX));
        return SARCINA_ERROR;
    }
    int status = make_series(o, args_expr(a, "vs"), args_span(a, "vs"), &all[0], d);
    for (size_t i = 0; i < n && !status; i++)
        status = make_series(o, args_expr_at(a, "Y", i), args_span_at(a, "Y", i), &all[1 + i], d);
    return status;
}

static int check_file(const args *a, diag *d) {
    const char *path = args_text(a, "file");
    if (!output_list_knows(a, "file"))
        return SARCINA_OK;
    int status = SARCINA_OK;
    if (!plot_terminal(path))
        status = diag_error(d, "a diagram's file ends in .svg, .png or .pdf, not '%s'", path);
    if (!status)
        status = path_check(path, d);
    if (status)
        diag_place(d, args_span(a, "file"));
    return status;
}

static int run_plot(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    plot_series all[SERIES_MAX + 1];
    diag missing = {0};
    int status = check_file(a, d);
    if (!status)
        status = make_all(o, a, all, d);
    if (status || interp_checking(in))
        return status;
    size_t rows = thermo_rows(o->table);
    if (rows < 2)
        return diag_error(d, "the thermo table has %zu rows: there is nothing to draw", rows);
    if (plot_ready(&missing)) {
        interp_warn(in, "%s (%s); this diagram is left out", missing.message, missing.help);
        return SARCINA_OK;
    }
    return plot_draw(&all[0], all + 1, args_count(a, "Y"), rows, args_text(a, "file"), d);
}

static const param params[] = {
    {"Y:value...", "what is drawn: columns of the thermo table, by their headings"},
    {"vs:value!", "the column it is drawn against"},
    {"file:file!", "a .svg, .png or .pdf file"},
};

static const command_form forms[] = {
    {"plot Y:value...", params, TABLE_COUNT(params),
     "Draws columns of the thermo table against one of them, by gnuplot",
     "All rows the table has had since its columns were chosen, also those before a restart, each step once. Lengths "
     "are "
     "in um, times in h; what has another dimension than the first is drawn against an "
     "axis "
     "on the right. Without the program gnuplot the diagram is left out with a warning.",
     "thermo_style custom step time/1h cells\nthermo 1\nrun 3 grow 4min relax 0.1s\nplot cells vs time/1h file "
     "cells.svg",
     COMMAND_SHADOW, run_plot, NULL, 0},
};

void command_plot(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
