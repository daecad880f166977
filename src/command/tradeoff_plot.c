/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The diagrams of a trade-off: work against precision, and what many cycles differ by. */
#include "command/tradeoff_table.h"

#include "base/alloc.h"
#include "base/dim.h"
#include "output/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One point a method, in the legend by its name. */
static int plot_relaxation(const char *path, const tradeoff_result *r, diag *d) {
    double *x = alloc_zeroed(r->n, 2 * sizeof *x), *y = x + r->n;
    plot_curve *curves = alloc_zeroed(r->n, sizeof *curves);
    char **names = alloc_zeroed(r->n, sizeof *names);
    size_t count = 0;
    for (size_t i = 0; i < r->n; i++) {
        const tradeoff_row *row = &r->rows[i];
        if (row->state == TRADEOFF_FAILED || row->error.rms == 0)
            continue;
        names[count] = alloc_format("%s%s", r->methods[i].name, row->state == TRADEOFF_CHAOS ? " (chaos)" : "");
        x[count] = (double)row->cost.evaluations;
        y[count] = dim_from_engine(row->error.rms, DIM_LENGTH);
        /* a bar of no length: the mark */
        curves[count] = (plot_curve){.name = names[count],
                                     .axis = "error (rms)",
                                     .d = DIM_LENGTH,
                                     .n = 1,
                                     .x = &x[count],
                                     .y = &y[count],
                                     .low = &y[count],
                                     .high = &y[count]};
        count++;
    }
    const plot_diagram p = {.x_name = "force evaluations",
                            .shape = PLOT_POINTS,
                            .log_x = true,
                            .log_y = true,
                            .curves = curves,
                            .count = count};
    int status = count ? plot_draw(&p, path, d) : SARCINA_OK;
    for (size_t i = 0; i < count; i++)
        free(names[i]);
    free(names);
    free(curves);
    free(x);
    return status;
}

/* Percent of the mean of what is compared with; rows of r->n: x, y, low, high. */
static plot_curve difference_curve(const tradeoff_result *r, size_t k, double *room) {
    double *x = room, *y = x + r->n, *low = y + r->n, *high = low + r->n;
    for (size_t m = 0; m < r->n; m++) {
        const tradeoff_comparison *c = &r->comparison[m * r->runs.nobserved + k];
        double percent = c->reference.mean == 0 ? (double)NAN : 100 / fabs(c->reference.mean);
        x[m] = (double)r->runs.cost[m].evaluations / (double)r->runs.seeds;
        y[m] = percent * c->difference.value;
        low[m] = y[m] - percent * c->width;
        high[m] = y[m] + percent * c->width;
    }
    return (plot_curve){.name = r->observed[k].name,
                        .axis = r->observed[k].name,
                        .d = DIM_NONE,
                        .n = r->n,
                        .x = x,
                        .y = y,
                        .low = low,
                        .high = high};
}

/* tradeoff.svg: tradeoff.cycles.svg; the caller frees. */
static char *second_file(const char *path) {
    size_t stem = strlen(path) - strlen(strrchr(path, '.'));
    return alloc_format("%.*s.cycles%s", (int)stem, path, path + stem);
}

static int plot_cycles(const char *path, const tradeoff_result *r, diag *d) {
    size_t n = r->runs.nobserved;
    double *room = alloc_zeroed(n, 4 * r->n * sizeof *room);
    plot_curve *curves = alloc_zeroed(n, sizeof *curves);
    for (size_t k = 0; k < n; k++)
        curves[k] = difference_curve(r, k, room + 4 * r->n * k);
    char *label = alloc_format("difference from %s (%%)", r->methods[r->base].name);
    const plot_diagram p = {.x_name = "force evaluations a run",
                            .y_label = label,
                            .shape = PLOT_POINTS,
                            .log_x = true,
                            .curves = curves,
                            .count = n};
    char *file = second_file(path);
    int status = plot_draw(&p, file, d);
    free(file);
    free(label);
    free(curves);
    free(room);
    return status;
}

int tradeoff_plot_draw(const char *path, const tradeoff_result *r, diag *d) {
    int status = plot_relaxation(path, r, d);
    return status || !r->cycles ? status : plot_cycles(path, r, d);
}
