/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The diagrams of a trade-off: work against precision, and what many cycles differ by. */
#include "command/tradeoff_table.h"

#include "base/alloc.h"
#include "base/dim.h"
#include "output/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A point of work against precision. */
typedef struct point {
    double x, y;
    size_t curve;
} point;

static int compare_points(const void *left, const void *right) {
    const point *a = left, *b = right;
    if (a->curve != b->curve)
        return a->curve < b->curve ? -1 : 1;
    return (a->x > b->x) - (a->x < b->x);
}

/* The curve of this legend, or a new one; names (*n). */
static size_t curve_of(char **names, size_t *n, const char *name, bool chaos) {
    char *legend = alloc_format("%.*s%s", (int)strcspn(name, " "), name, chaos ? " (chaos)" : "");
    for (size_t i = 0; i < *n; i++)
        if (strcmp(names[i], legend) == 0) {
            free(legend);
            return i;
        }
    names[*n] = legend;
    return (*n)++;
}

/* What can be drawn, curve by curve, from few evaluations to many; returns how many. */
static size_t gather_points(const tradeoff_result *r, point *points, char **names, size_t *ncurves) {
    size_t count = 0;
    for (size_t i = 0; i < r->n; i++) {
        const tradeoff_row *row = &r->rows[i];
        if (row->state != TRADEOFF_FAILED && row->error.rms > 0)
            points[count++] = (point){(double)row->cost.evaluations, dim_from_engine(row->error.rms, DIM_LENGTH),
                                      curve_of(names, ncurves, r->methods[i].name, row->state == TRADEOFF_CHAOS)};
    }
    qsort(points, count, sizeof *points, compare_points);
    return count;
}

/* Rows of the Pareto front, from few evaluations to many, with the corners between them: x and y of 2 r->n; how many.
 */
static size_t draw_front(const tradeoff_result *r, double *x, double *y) {
    point *front = alloc_zeroed(r->n, sizeof *front);
    size_t count = 0, n = 0;
    for (size_t i = 0; i < r->n; i++)
        if (r->rows[i].front && r->rows[i].error.rms > 0)
            front[count++] =
                (point){(double)r->rows[i].cost.evaluations, dim_from_engine(r->rows[i].error.rms, DIM_LENGTH), 0};
    qsort(front, count, sizeof *front, compare_points);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) {
            x[n] = front[i].x;
            y[n++] = front[i - 1].y;
        }
        x[n] = front[i].x;
        y[n++] = front[i].y;
    }
    free(front);
    return n;
}

/* A curve a preset or integrator, through its points of several steps or tolerances. */
static int plot_relaxation(const char *path, const tradeoff_result *r, diag *d) {
    point *points = alloc_zeroed(r->n, sizeof *points);
    char **names = alloc_zeroed(r->n, sizeof *names);
    double *x = alloc_zeroed(r->n, 6 * sizeof *x), *y = x + r->n, *front = y + r->n;
    plot_curve *curves = alloc_zeroed(r->n + 1, sizeof *curves);
    size_t ncurves = 0, count = gather_points(r, points, names, &ncurves);
    for (size_t i = count; i-- > 0;) {
        x[i] = points[i].x;
        y[i] = points[i].y;
        plot_curve *c = &curves[points[i].curve];
        /* bars of no length: the marks */
        *c = (plot_curve){.name = names[points[i].curve],
                          .axis = "error (rms)",
                          .d = DIM_LENGTH,
                          .n = c->n + 1,
                          .x = &x[i],
                          .y = &y[i],
                          .low = &y[i],
                          .high = &y[i]};
    }
    curves[ncurves] = (plot_curve){.name = "Pareto front",
                                   .axis = "error (rms)",
                                   .d = DIM_LENGTH,
                                   .n = draw_front(r, front, front + 2 * r->n),
                                   .x = front,
                                   .y = front + 2 * r->n,
                                   .guide = true};
    const plot_diagram p = {.x_name = "force evaluations",
                            .shape = PLOT_POINTS,
                            .log_x = true,
                            .log_y = true,
                            .curves = curves,
                            .count = ncurves + (curves[ncurves].n > 1)};
    int status = count ? plot_draw(&p, path, d) : SARCINA_OK;
    for (size_t i = 0; i < ncurves; i++)
        free(names[i]);
    free(curves);
    free(x);
    free(names);
    free(points);
    return status;
}

static double evaluations_a_run(const tradeoff_result *r, size_t m) {
    return (double)r->runs.cost[m].evaluations / (double)r->runs.seeds;
}

/* Percent of the mean of what is compared with; rows of r->n: x, y, low, high. Quantities stand a little apart, so that
 * no bar covers another. */
static plot_curve difference_curve(const tradeoff_result *r, size_t k, double *room) {
    double *x = room, *y = x + r->n, *low = y + r->n, *high = low + r->n;
    double aside = pow(1.04, (double)k - 0.5 * (double)(r->runs.nobserved - 1));
    for (size_t m = 0; m < r->n; m++) {
        const tradeoff_comparison *c = &r->comparison[m * r->runs.nobserved + k];
        double percent = c->reference.mean == 0 ? (double)NAN : 100 / fabs(c->reference.mean);
        x[m] = evaluations_a_run(r, m) * aside;
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

/* The margins of equivalence as two guides, over all evaluations; their ends are x, and stand in y (4). */
static void margin_curves(const tradeoff_result *r, const char *name, const double x[2], double *y, plot_curve out[2]) {
    for (size_t i = 0; i < 2; i++) {
        y[2 * i] = y[2 * i + 1] = (i ? -100 : 100) * r->margin;
        out[i] = (plot_curve){
            .name = i ? "" : name, .axis = "", .d = DIM_NONE, .n = 2, .x = x, .y = y + 2 * i, .guide = true};
    }
}

static int plot_cycles(const char *path, const tradeoff_result *r, diag *d) {
    size_t n = r->runs.nobserved;
    double *room = alloc_zeroed(n, 4 * r->n * sizeof *room), x[2] = {INFINITY, 0}, y[4];
    plot_curve *curves = alloc_zeroed(n + 2, sizeof *curves);
    plot_note *notes = alloc_zeroed(r->n, sizeof *notes);
    char *margin = alloc_format("margin, %g %%", 100 * r->margin);
    for (size_t k = 0; k < n; k++)
        curves[k] = difference_curve(r, k, room + 4 * r->n * k);
    for (size_t m = 0; m < r->n; m++) {
        notes[m] = (plot_note){r->methods[m].name, evaluations_a_run(r, m)};
        x[0] = fmin(x[0], notes[m].x);
        x[1] = fmax(x[1], notes[m].x);
    }
    margin_curves(r, margin, x, y, curves + n);
    char *label = alloc_format("difference from %s (%%)", r->methods[r->base].name);
    const plot_diagram p = {.x_name = "force evaluations a run",
                            .y_label = label,
                            .shape = PLOT_POINTS,
                            .log_x = true,
                            .curves = curves,
                            .count = n + 2,
                            .notes = notes,
                            .nnotes = r->n};
    char *file = second_file(path);
    int status = plot_draw(&p, file, d);
    free(file);
    free(label);
    free(margin);
    free(notes);
    free(curves);
    free(room);
    return status;
}

int tradeoff_plot_draw(const char *path, const tradeoff_result *r, diag *d) {
    int status = plot_relaxation(path, r, d);
    return status || !r->cycles ? status : plot_cycles(path, r, d);
}
