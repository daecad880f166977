/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot Y... vs X file F: columns of the thermo table, at every row it has had. plot histogram|profile ID file F: the
 * bins of the scene as it stands. plot table Y... vs X from TABLE... file F: ensembles and other tables on disk. */
#include "command/commands.h"
#include "command/analyze_bins.h"
#include "command/forecast.h"
#include "command/output_list.h"
#include "command/plot_table.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "base/table.h"
#include "output/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what all forms share ---- */

enum { CURVES_MAX = PLOT_TABLE_CURVES };

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

/* Not more lines than can be told apart. */
static int check_count(const args *a, diag *d) {
    if (args_count(a, "Y") <= CURVES_MAX)
        return SARCINA_OK;
    diag_error(d, "a diagram has at most %d lines", CURVES_MAX);
    diag_place(d, args_span_at(a, "Y", CURVES_MAX));
    return SARCINA_ERROR;
}

static void set_axes(plot_diagram *p, const args *a) {
    static const struct { bool x, y; } log[] = {{false, false}, {true, false}, {false, true}, {true, true}};
    p->log_x = log[args_choice(a, "log")].x;
    p->log_y = log[args_choice(a, "log")].y;
    p->x_label = args_given(a, "xlabel") ? args_text(a, "xlabel") : NULL;
    p->y_label = args_given(a, "ylabel") ? args_text(a, "ylabel") : NULL;
}

/* Draws, or warns that nothing here can. */
static int draw(interp *in, const args *a, const plot_diagram *p, diag *d) {
    diag missing = {0};
    if (plot_ready(&missing)) {
        interp_warn(in, "%s (%s); this diagram is left out", missing.message, missing.help);
        return SARCINA_OK;
    }
    return plot_draw(p, args_text(a, "file"), d);
}

/* ---- the thermo table ---- */

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

/* Its row in the table, of numbers; -1 with an error. */
static int find_numbers(const outputs *o, expr *e, span at, diag *d) {
    int i = find_column(o, expr_text(e));
    if (i < 0) {
        refuse(o, expr_text(e), at, d);
        return -1;
    }
    const output_column *column = thermo_column(o->table, (size_t)i);
    if (!column->is_text)
        return i;
    diag_error(d, "a diagram is of numbers, and '%s' is a text", column->name);
    diag_place(d, at);
    return -1;
}

static int make_curves(const outputs *o, const args *a, plot_diagram *p, plot_curve curves[CURVES_MAX], diag *d) {
    int x = find_numbers(o, args_expr(a, "vs"), args_span(a, "vs"), d);
    *p = (plot_diagram){.curves = curves, .count = args_count(a, "Y")};
    for (size_t i = 0; i < p->count && x >= 0; i++) {
        int y = find_numbers(o, args_expr_at(a, "Y", i), args_span_at(a, "Y", i), d);
        if (y < 0)
            return SARCINA_ERROR;
        const output_column *column = thermo_column(o->table, (size_t)y);
        curves[i] = (plot_curve){.name = column->name,
                                 .axis = column->name,
                                 .d = column->d,
                                 .n = thermo_rows(o->table),
                                 .x = thermo_history(o->table, (size_t)x),
                                 .y = thermo_history(o->table, (size_t)y)};
    }
    if (x < 0)
        return SARCINA_ERROR;
    p->x_name = thermo_column(o->table, (size_t)x)->name;
    p->x_dim = thermo_column(o->table, (size_t)x)->d;
    return SARCINA_OK;
}

static int run_thermo(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    plot_diagram p;
    plot_curve curves[CURVES_MAX];
    int status = check_file(a, d);
    if (!status)
        status = check_count(a, d);
    if (!status)
        status = make_curves(o, a, &p, curves, d);
    if (interp_checking(in))
        forecast_note_extra(in, FORECAST_DIAGRAMS);
    if (status || interp_checking(in))
        return status;
    size_t rows = thermo_rows(o->table);
    if (rows < 2)
        return diag_error(d, "the thermo table has %zu %s: there is nothing to draw", rows,
                          number_noun(rows, "row", "rows"));
    set_axes(&p, a);
    return draw(in, a, &p, d);
}

/* ---- histograms and profiles ---- */

typedef enum { OF_HISTOGRAM, OF_PROFILE } bins_kind;

/* By `show`. */
static const char *const shown[][4] = {{"count", "fraction"}, {"mean", "density", "fraction", "count"}};

/* Ends, numbers and their interval: fields of the bins. */
typedef struct bin_numbers {
    double *low, *high, *y, *least, *most;
    dim x_dim, y_dim;
} bin_numbers;

static int read_bins(interp *in, const output_analysis *p, const char *field, bin_numbers *b, diag *d) {
    size_t n = analyze_bins_count(p);
    dim ignored;
    double **lists[] = {&b->low, &b->high, &b->y, &b->least, &b->most}, ci95;
    bool mean = strcmp(field, "mean") == 0;
    int status = SARCINA_OK;
    for (size_t i = 0; i < TABLE_COUNT(lists); i++)
        *lists[i] = alloc_zeroed(n, sizeof(double));
    for (size_t i = 0; i < n && !status; i++) {
        double bin = (double)i + 1;
        status = analyze_bins_value(in, p, "low", bin, &b->x_dim, &b->low[i], d);
        if (!status)
            status = analyze_bins_value(in, p, "high", bin, &ignored, &b->high[i], d);
        if (!status)
            status = analyze_bins_value(in, p, field, bin, &b->y_dim, &b->y[i], d);
        if (!status && mean)
            status = analyze_bins_value(in, p, "ci95", bin, &ignored, &ci95, d);
        b->least[i] = mean && !status ? b->y[i] - ci95 : (double)NAN;
        b->most[i] = mean && !status ? b->y[i] + ci95 : (double)NAN;
    }
    return status;
}

static void free_bins(bin_numbers *b) {
    free(b->low);
    free(b->high);
    free(b->y);
    free(b->least);
    free(b->most);
}

static int draw_bins(interp *in, const args *a, const output_analysis *p, const char *field, diag *d) {
    bin_numbers b = {0};
    bool mean = strcmp(field, "mean") == 0;
    int status = read_bins(in, p, field, &b, d);
    char *axis = mean ? alloc_copy(p->id) : alloc_format("%s.%s", p->id, field);
    const plot_curve curve = {.name = axis,
                              .axis = axis,
                              .d = b.y_dim,
                              .n = analyze_bins_count(p),
                              .x = b.low,
                              .x_end = b.high,
                              .y = b.y,
                              .low = mean ? b.least : NULL,
                              .high = mean ? b.most : NULL};
    plot_diagram diagram = {.x_name = analyze_bins_along(p),
                            .x_dim = b.x_dim,
                            .curves = &curve,
                            .count = 1,
                            .shape = analyze_bins_is_profile(p) ? PLOT_LINE : PLOT_BOXES};
    set_axes(&diagram, a);
    if (!status)
        status = draw(in, a, &diagram, d);
    free(axis);
    free_bins(&b);
    return status;
}

static int run_bins(interp *in, const args *a, diag *d) {
    const output_analysis *p = &output_list_of(in)->analyses[args_row(a, "ID")];
    bool profile = args_style(a) == OF_PROFILE;
    int status = check_file(a, d);
    if (!status && (!p->bins || analyze_bins_is_profile(p) != profile)) {
        diag_error(d, "'%s' is no %s", p->id, profile ? "profile" : "histogram");
        diag_place(d, args_span(a, "ID"));
        return SARCINA_ERROR;
    }
    if (interp_checking(in))
        forecast_note_extra(in, FORECAST_DIAGRAMS);
    if (status || interp_checking(in))
        return status;
    return draw_bins(in, a, p, shown[profile][args_choice(a, "show")], d);
}

/* ---- tables on disk ---- */

static int draw_table(interp *in, const args *a, plot_table_request *r, diag *d) {
    plot_table t;
    int status = plot_table_read(r, &t, d);
    if (!status) {
        set_axes(&t.diagram, a);
        status = draw(in, a, &t.diagram, d);
    }
    plot_table_free(&t);
    return status;
}

static int run_table(interp *in, const args *a, diag *d) {
    int status = check_file(a, d);
    if (!status)
        status = check_count(a, d);
    if (interp_checking(in))
        forecast_note_extra(in, FORECAST_DIAGRAMS);
    if (status || interp_checking(in))
        return status;
    plot_table_request r = {.units = interp_units(in),
                            .ny = args_count(a, "Y"),
                            .nfiles = args_count(a, "from"),
                            .x = args_text(a, "vs"),
                            .band = (plot_table_band)args_choice(a, "band"),
                            .step = args_given(a, "at") ? (double)args_int(a, "at") : (double)NAN};
    const char **texts = alloc_zeroed(r.ny + r.nfiles, sizeof *texts);
    for (size_t i = 0; i < r.ny; i++)
        texts[i] = args_text_at(a, "Y", i);
    for (size_t i = 0; i < r.nfiles; i++)
        texts[r.ny + i] = args_text_at(a, "from", i);
    r.y = texts;
    r.files = texts + r.ny;
    status = draw_table(in, a, &r, d);
    free(texts);
    return status;
}

/* ---- records ---- */

#define PLOT_FILE                                                                                                      \
    { "file:file!", "a .svg, .png or .pdf file" }
#define PLOT_AXES                                                                                                      \
    {"log=no:{no|x|y|xy}", "which axes are logarithmic"},                                                              \
        {"xlabel:text", "what is written below the diagram, in place of name and unit"}, {                             \
        "ylabel:text", "what is written at its left"                                                                   \
    }

static const param thermo_params[] = {
    {"Y:value...", "what is drawn: columns of the thermo table, by their headings"},
    {"vs:value!", "the column it is drawn against"},
    PLOT_FILE,
    PLOT_AXES,
};

static const param histogram_params[] = {
    {"ID:analysis", "a histogram"},
    PLOT_FILE,
    {"show=count:{count|fraction}", "the height of a box"},
    PLOT_AXES,
};

static const param profile_params[] = {
    {"ID:analysis", "a profile"},
    PLOT_FILE,
    {"show=mean:{mean|density|fraction|count}", "what is drawn along the direction"},
    PLOT_AXES,
};

static const param table_params[] = {
    {"Y:word...", "what is drawn: quantities or columns of the tables"},
    {"vs:word!", "what against: step, time, a quantity, what was swept, or ID.low of a histogram or profile"},
    {"from:word...!", "the tables: one or more files"},
    PLOT_FILE,
    {"band=ci95:{ci95|sd|range|none}",
     "what is shaded of an ensemble: the 95 % interval of the mean, the standard deviation, least to largest, nothing"},
    {"at:int[0,)", "the step of a histogram or profile; else the last"},
    PLOT_AXES,
};

static const command_form forms[] = {
    {"plot Y:value...", thermo_params, TABLE_COUNT(thermo_params),
     "Draws columns of the thermo table against one of them, by gnuplot",
     "All rows the table has had since its columns were chosen, also those before a restart, each step once. Lengths "
     "are in um, times in h; what has another dimension than the first is drawn against an axis on the right. Without "
     "the program gnuplot the diagram is left out with a warning.",
     "thermo_style custom step time/1h cells\nthermo 1\nrun 3 grow 4min relax 0.1s\nplot cells vs time/1h file "
     "cells.svg\nplot cells vs time/1h file cells.png log y xlabel \"time (h)\" ylabel \"cells in the colony\"",
     COMMAND_SHADOW, run_thermo, NULL, 0},
    {"plot histogram ID:analysis", histogram_params, TABLE_COUNT(histogram_params),
     "Draws a histogram of the cells as they are now",
     "A box a bin. In ensembles histograms are merged too: see plot table.",
     "analyze lengths all histogram length bins 10\nplot histogram lengths file lengths.svg\nplot histogram lengths "
     "show fraction file lengths.png log no xlabel \"length (um)\" ylabel \"part of the cells\"",
     COMMAND_SHADOW, run_bins, NULL, OF_HISTOGRAM},
    {"plot profile ID:analysis", profile_params, TABLE_COUNT(profile_params),
     "Draws a profile of the cells as they are now",
     "A line through the middles of the bins; the 95 % interval of a bin's mean is shaded.",
     "analyze ages all profile age along z bins 5\nplot profile ages file ages.svg\nplot profile ages show density "
     "file "
     "density.png log no xlabel \"height (um)\" ylabel \"cells per um\"",
     COMMAND_SHADOW, run_bins, NULL, OF_PROFILE},
    {"plot table Y:word...", table_params, TABLE_COUNT(table_params),
     "Draws tables on disk: ensembles with shaded intervals, and others",
     "NAME.ensemble.csv: the mean over the replicates at each step, with its interval, one curve for each Y, each "
     "file "
     "and each combination of the values swept. Against a quantity, its mean stands on the axis below. Against ID.low: "
     "the bins of a histogram or profile, ID.count, ID.fraction, ID.mean ..., merged over the replicates.\n\n"
     "NAME.summary.csv: the mean and interval of each scalar against what was swept.\n\n"
     "Other tables, as thermo_modify and analyze write them: columns, by their headings.",
     "plot table cells vs time from ecoli.ensemble.csv file cells.svg\nplot table thickness vs cells from "
     "ecoli.ensemble.csv file thickness.png band range log x xlabel cells ylabel \"thickness (um)\"\nplot table "
     "lengths.fraction vs lengths.low from ecoli.ensemble.csv at 5 file lengths.svg",
     COMMAND_SHADOW, run_table, NULL, 0},
};

void command_plot(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
