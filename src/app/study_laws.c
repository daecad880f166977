/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_laws.h"

#include "app/study_table.h"
#include "base/alloc.h"
#include "base/inference.h"
#include "base/path.h"
#include "base/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- what is run ---- */

typedef struct law {
    const char *name, *title; /* folder; in the table */
    const char *script, *options;
    bool published; /* what those behind it, up to the next of this kind, are held against */
    const char *heading;
} law;

static const law laws[] = {
    {"published", "closest, 10 nm", "laws/ecoli", "", true, "Contact law and jitter: colonies without links"},
    {"regularised", "regularised, 10 nm", "laws/ecoli", " -var contact regularised", false, NULL},
    {"jitter_1nm", "closest, 1 nm", "laws/ecoli", " -var jitter 1nm", false, NULL},
    {"jitter_0.1nm", "closest, 0.1 nm", "laws/ecoli", " -var jitter 0.1nm", false, NULL},
    {"jitter_0", "closest, none", "laws/ecoli", " -var jitter 0m", false, NULL},
    {"anchored_step", "every step", "laws/anchored", " -var remodel 0s", true, "Looks at links: anchored colonies"},
    {"anchored_1ms", "every 1 ms", "laws/anchored", " -var remodel 1ms", false, NULL},
    {"anchored_5ms", "every 5 ms", "laws/anchored", " -var remodel 5ms", false, NULL},
    {"anchored_20ms", "every 20 ms", "laws/anchored", " -var remodel 20ms", false, NULL},
    {"floc_step", "every step", "laws/floc", " -var remodel 0s", true, "Looks at links: flocs that stick"},
    {"floc_1ms", "every 1 ms", "laws/floc", " -var remodel 1ms", false, NULL},
    {"floc_5ms", "every 5 ms", "laws/floc", " -var remodel 5ms", false, NULL},
    {"floc_20ms", "every 20 ms", "laws/floc", " -var remodel 20ms", false, NULL},
};

/* How far colonies grow, and how many: of rods on a plane, and of flocs. */
typedef struct size {
    int cells;
    long seeds, flocs;
} size;

static const size sizes[] = {{300, 20, 8}, {3000, 5, 0}};

static long seeds_of(const size *s, const law *l) {
    return strcmp(l->script, "laws/floc") == 0 ? s->flocs : s->seeds;
}

void study_laws_plan(void) {
    for (size_t i = 0; i < TABLE_COUNT(sizes); i++)
        for (size_t k = 0; k < TABLE_COUNT(laws); k++)
            if (seeds_of(&sizes[i], &laws[k]))
                printf("%d\t%s\t%s\t-var cycles 200 -var most %d%s\t%ld\n", sizes[i].cells, laws[k].name,
                       laws[k].script, sizes[i].cells, laws[k].options, seeds_of(&sizes[i], &laws[k]));
}

/* ---- what is measured ---- */

typedef struct measure {
    const char *name, *unit;
    const char *column; /* of the last row, or of the scalars */
    double scale;       /* from SI to the unit */
    int digits;
    double margin; /* largest difference that counts as none, in the unit; 0: a tenth of the published mean */
} measure;

static const measure measures[] = {
    {"C", "", "C", 1, 3, 0.05}, /* near 0 in large colonies */
    {"thickness", "um", "thickness", 1e6, 2, 0},
    {"area", "um2", "ellipse.area", 1e12, 0, 0},
    {"gyration", "um", "gyration", 1e6, 2, 0},
    {"cells at stacking", "", "stacked.cells", 1, 0, 0},
    {"links a cell", "", "held", 1, 3, 0},
    {"compactness", "1e-3", "body", 1e3, 2, 0},
    {"clusters", "", "clusters", 1, 2, 0},
};

typedef struct ensemble {
    inference_sample of[TABLE_COUNT(measures)];
    size_t n;
} ensemble;

/* A run's measures, to x[measure][run]. */
static int read_run(const char *folder, double x[][64], size_t run, diag *d) {
    char *results = alloc_format("%s/results.csv", folder), *scalars = alloc_format("%s/scalars.csv", folder);
    study_table series, once;
    int status = study_table_read_results(&series, results, d);
    if (!status && (status = study_table_read_scalars(&once, scalars, d)))
        study_table_free(&series);
    free(results);
    free(scalars);
    if (status)
        return status;
    for (size_t m = 0; m < TABLE_COUNT(measures); m++) {
        double last = study_table_number(&series, series.nrows - 1, measures[m].column);
        x[m][run] = measures[m].scale * (isnan(last) ? study_table_number(&once, 0, measures[m].column) : last);
    }
    study_table_free(&series);
    study_table_free(&once);
    return SARCINA_OK;
}

static int read_ensemble(const char *folder, const size *s, const law *l, ensemble *e, diag *d) {
    double x[TABLE_COUNT(measures)][64];
    int status = SARCINA_OK;
    *e = (ensemble){0};
    for (long seed = 1; seed <= seeds_of(s, l) && !status; seed++) {
        char *run =
            alloc_format("%s/%d/%s/%s.runs/seed=%ld", folder, s->cells, l->name, strchr(l->script, '/') + 1, seed);
        char *done = alloc_format("%s/done", run);
        if (access(done, R_OK) == 0)
            status = read_run(run, x, e->n++, d);
        free(done);
        free(run);
    }
    for (size_t m = 0; m < TABLE_COUNT(measures); m++)
        e->of[m] = inference_sample_of(x[m], e->n);
    return status;
}

/* ---- what it says ---- */

/* One measure under one law, and how it differs from the published behaviour; the published one itself: p NaN. */
typedef struct comparison {
    const size *size;
    const law *law;
    const measure *measure;
    inference_sample of, published;
    inference_difference difference;
    double p_same, p_differs; /* TOST against the margin; of no difference, corrected for all of them by Holm */
} comparison;

typedef struct report {
    comparison *rows;
    size_t n, capacity, runs;
} report;

static const char *verdict(const comparison *c) {
    bool same = c->p_same < 0.05, differs = c->p_differs < 0.05;
    return same && differs ? "equivalent but not equal" : same ? "equivalent" : differs ? "DIFFERS" : "undecided";
}

static void add_row(report *r, comparison c) {
    bool is_published = c.law->published;
    c.difference = inference_compare(c.of, c.published);
    inference_difference d = c.difference;
    d.value = fabs(d.value);
    double margin = c.measure->margin > 0 ? c.measure->margin : 0.1 * fabs(c.published.mean);
    c.p_same = is_published ? (double)NAN : inference_p_equivalent(d, margin);
    c.p_differs = is_published ? (double)NAN : fmin(1, 2 * inference_p_above(d, 0));
    r->rows = alloc_grow(r->rows, &r->capacity, r->n + 1, sizeof *r->rows);
    r->rows[r->n++] = c;
}

/* The laws first ... end - 1, of which the first is the published one, measure by measure. */
static void add_group(report *r, const size *s, const ensemble *of, size_t first, size_t end) {
    for (size_t m = 0; m < TABLE_COUNT(measures); m++)
        for (size_t k = first; k < end && of[first].of[m].n > 1; k++)
            if (of[k].of[m].n > 1)
                add_row(r, (comparison){.size = s,
                                        .law = &laws[k],
                                        .measure = &measures[m],
                                        .of = of[k].of[m],
                                        .published = of[first].of[m]});
}

static int add_size(report *r, const char *folder, const size *s, diag *d) {
    ensemble of[TABLE_COUNT(laws)];
    for (size_t k = 0; k < TABLE_COUNT(laws); k++) {
        if (read_ensemble(folder, s, &laws[k], &of[k], d))
            return SARCINA_ERROR;
        r->runs += of[k].n;
    }
    for (size_t first = 0, end; first < TABLE_COUNT(laws); first = end) {
        for (end = first + 1; end < TABLE_COUNT(laws) && !laws[end].published;)
            end++;
        add_group(r, s, of, first, end);
    }
    return SARCINA_OK;
}

static void correct(report *r) {
    double *p = alloc_zeroed(r->n, sizeof *p), *adjusted = alloc_zeroed(r->n, sizeof *adjusted);
    for (size_t i = 0; i < r->n; i++)
        p[i] = r->rows[i].p_differs;
    inference_holm(p, r->n, adjusted);
    for (size_t i = 0; i < r->n; i++)
        r->rows[i].p_differs = isnan(p[i]) ? p[i] : adjusted[i];
    free(p);
    free(adjusted);
}

static void put_text(FILE *out, const comparison *c) {
    const measure *m = c->measure;
    char mean[32], difference[32];
    snprintf(mean, sizeof mean, "%.*f +- %.*f", m->digits, c->of.mean, m->digits, inference_ci95(c->of));
    if (c->law->published) {
        fprintf(out, " %s%s%s\n  %-19s%-17s%3zu\n", m->name, *m->unit ? ", " : "", m->unit, c->law->title, mean,
                c->of.n);
        return;
    }
    double width = inference_width(c->difference, 0.95), part = 100 / fabs(c->published.mean);
    snprintf(difference, sizeof difference, "%+.*f +- %.*f", m->digits, c->difference.value, m->digits, width);
    fprintf(out, "  %-19s%-17s%3zu  %-17s %+5.1f +- %4.1f %%  %-8.2g%s\n", c->law->title, mean, c->of.n, difference,
            part * c->difference.value, part * width, c->p_same, verdict(c));
}

static void put_table(FILE *out, const comparison *c) {
    const char *unit = c->measure->unit;
    fprintf(out, "%d,%s,%s%s%s%s,%.9g,%.9g,%zu,", c->size->cells, c->law->name, c->measure->name, *unit ? "[" : "",
            unit, *unit ? "]" : "", c->of.mean, inference_ci95(c->of), c->of.n);
    if (c->law->published)
        fputs(",,,,\n", out);
    else
        fprintf(out, "%.9g,%.9g,%.3g,%.3g,%s\n", c->difference.value, inference_width(c->difference, 0.95), c->p_same,
                c->p_differs, verdict(c));
}

static void put(const report *r, FILE *text, FILE *table) {
    const law *group = NULL;
    const size *at = NULL;
    fprintf(text, "%-21s%-17s%3s  %-17s %-16s %s\n", "", "mean +- 95 %", "n", "difference, 95 %", "in % of it",
            "p of TOST");
    fputs("cells,law,quantity,mean,ci95,n,difference,difference_ci95,p_equivalent,p_differs_holm,verdict\n", table);
    for (size_t i = 0; i < r->n; i++) {
        const comparison *c = &r->rows[i];
        if (c->law->published && (c->law != group || c->size != at))
            fprintf(text, "\n%s, %d cells\n", c->law->heading, c->size->cells);
        group = c->law->published ? c->law : group;
        at = c->size;
        put_text(text, c);
        put_table(table, c);
    }
}

int study_laws_report(const char *folder, const char *results, diag *d) {
    report r = {0};
    int status = SARCINA_OK;
    for (size_t i = 0; i < TABLE_COUNT(sizes) && !status; i++)
        status = add_size(&r, folder, &sizes[i], d);
    correct(&r);
    if (!status && !r.runs)
        status = diag_error(d, "no run of the study of laws is done in '%s'", folder);
    char *text = alloc_format("%s/laws.txt", results), *table = alloc_format("%s/laws.csv", results);
    FILE *first = status ? NULL : path_open(text, "w", d), *second = first ? path_open(table, "w", d) : NULL;
    if (second)
        put(&r, first, second);
    else
        status = SARCINA_ERROR;
    if (first && path_close(first, text, d))
        status = SARCINA_ERROR;
    if (second && path_close(second, table, d))
        status = SARCINA_ERROR;
    free(text);
    free(table);
    free(r.rows);
    return status;
}
