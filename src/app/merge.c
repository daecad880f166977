/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/merge.h"

#include "base/alloc.h"
#include "base/csv.h"
#include "base/path.h"
#include "base/statistics.h"
#include "output/field.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what was read ---- */

typedef struct quantity {
    char *name, *unit; /* "thickness", "m" */
} quantity;

/* One number of one run. */
typedef struct entry {
    size_t point, run;
    uint64_t step;
    double time;
    size_t quantity;
    double value; /* NaN: not defined, or it never happened */
    bool never;
} entry;

typedef struct gathered {
    quantity *quantities; /* in the order in which they are met */
    size_t nquantities, quantity_room;
    entry *entries;
    size_t nentries, entry_room;
} gathered;

static void free_gathered(gathered *g) {
    for (size_t i = 0; i < g->nquantities; i++) {
        free(g->quantities[i].name);
        free(g->quantities[i].unit);
    }
    free(g->quantities);
    free(g->entries);
}

static size_t quantity_row(gathered *g, const char *name, const char *unit) {
    for (size_t i = 0; i < g->nquantities; i++)
        if (strcmp(g->quantities[i].name, name) == 0 && strcmp(g->quantities[i].unit, unit) == 0)
            return i;
    g->quantities = alloc_grow(g->quantities, &g->quantity_room, g->nquantities + 1, sizeof *g->quantities);
    g->quantities[g->nquantities] = (quantity){alloc_copy(name), alloc_copy(unit)};
    return g->nquantities++;
}

static void add_entry(gathered *g, entry e) {
    g->entries = alloc_grow(g->entries, &g->entry_room, g->nentries + 1, sizeof *g->entries);
    g->entries[g->nentries++] = e;
}

/* results.csv of a run: step, time, quantity, unit, value. */
static int read_results(gathered *g, const plan *p, size_t run, diag *d) {
    char *path = alloc_format("%s/results.csv", p->runs[run].folder);
    csv t;
    int status = csv_open(&t, path, d);
    if (!status) {
        csv_next(&t); /* the header */
        while (csv_next(&t))
            if (t.n == 5)
                add_entry(g, (entry){.point = p->runs[run].point,
                                     .run = run,
                                     .step = strtoull(t.fields[0], NULL, 10),
                                     .time = strtod(t.fields[1], NULL),
                                     .quantity = quantity_row(g, t.fields[2], t.fields[3]),
                                     .value = strtod(t.fields[4], NULL)});
        csv_close(&t);
    }
    free(path);
    return status;
}

/* scalars.csv of a run: quantity, unit, value. */
static int read_scalars(gathered *g, const plan *p, size_t run, diag *d) {
    char *path = alloc_format("%s/scalars.csv", p->runs[run].folder);
    csv t;
    int status = csv_open(&t, path, d);
    if (!status) {
        csv_next(&t);
        while (csv_next(&t)) {
            if (t.n != 3)
                continue;
            bool never = strcmp(t.fields[2], "never") == 0;
            add_entry(g, (entry){.point = p->runs[run].point,
                                 .run = run,
                                 .quantity = quantity_row(g, t.fields[0], t.fields[1]),
                                 .value = never ? (double)NAN : strtod(t.fields[2], NULL),
                                 .never = never});
        }
        csv_close(&t);
    }
    free(path);
    return status;
}

/* Which numbers go into one mean: of one point, step and quantity. */
static int compare_cells(const entry *x, const entry *y) {
    if (x->point != y->point)
        return x->point < y->point ? -1 : 1;
    if (x->step != y->step)
        return x->step < y->step ? -1 : 1;
    return (x->quantity > y->quantity) - (x->quantity < y->quantity);
}

static int compare_entries(const void *a, const void *b) {
    const entry *x = a, *y = b;
    int order = compare_cells(x, y);
    return order ? order : (x->run > y->run) - (x->run < y->run);
}

/* Sorts the entries; of those of one run and mean (a quantity written twice at a step) the first counts. */
static void sort_entries(gathered *g) {
    size_t kept = 0;
    if (g->nentries)
        qsort(g->entries, g->nentries, sizeof *g->entries, compare_entries);
    for (size_t i = 0; i < g->nentries; i++)
        if (kept == 0 || compare_entries(&g->entries[kept - 1], &g->entries[i]) != 0)
            g->entries[kept++] = g->entries[i];
    g->nentries = kept;
}

/* ---- writing ---- */

static void put_number(FILE *out, double x) {
    char text[FIELD_ROOM];
    fprintf(out, ",%s", field_number(x, text));
}

static void put_axes(FILE *out, const plan *p) {
    for (size_t i = 0; i < p->naxes; i++) {
        field_put_csv(out, p->axes[i].name);
        fputc(',', out);
    }
}

static void put_point(FILE *out, const plan *p, size_t point) {
    for (size_t i = 0; i < p->naxes; i++) {
        field_put_csv(out, plan_value(p, i, point));
        fputc(',', out);
    }
}

static void put_quantity(FILE *out, const quantity *q) {
    field_put_csv(out, q->name);
    fputc(',', out);
    field_put_csv(out, q->unit);
}

static void put_statistics(FILE *out, const double *x, size_t n) {
    put_number(out, statistics_mean(x, n));
    put_number(out, statistics_ci95(x, n));
    put_number(out, statistics_sd(x, n));
    put_number(out, statistics_min(x, n));
    put_number(out, statistics_max(x, n));
    fputc('\n', out);
}

/* The numbers of entries begin ... end - 1 that are defined; how many. */
static size_t defined_values(const entry *begin, const entry *end, double *x) {
    size_t n = 0;
    for (const entry *e = begin; e < end; e++)
        if (!isnan(e->value))
            x[n++] = e->value;
    return n;
}

typedef void put_group(FILE *out, const plan *p, const gathered *g, const entry *begin, const entry *end, double *x);

static void put_step(FILE *out, const plan *p, const gathered *g, const entry *begin, const entry *end, double *x) {
    size_t n = defined_values(begin, end, x);
    put_point(out, p, begin->point);
    fprintf(out, "%" PRIu64, begin->step);
    put_number(out, begin->time);
    fputc(',', out);
    put_quantity(out, &g->quantities[begin->quantity]);
    fprintf(out, ",%td,%zu", end - begin, n);
    put_statistics(out, x, n);
}

static void put_summary(FILE *out, const plan *p, const gathered *g, const entry *begin, const entry *end, double *x) {
    size_t n = defined_values(begin, end, x), never = 0;
    for (const entry *e = begin; e < end; e++)
        never += e->never;
    put_point(out, p, begin->point);
    put_quantity(out, &g->quantities[begin->quantity]);
    fprintf(out, ",%td,%zu,%zu", end - begin, n, never);
    put_statistics(out, x, n);
}

/* Calls put for each set of entries that belong to one mean, at most one a run; they are sorted. */
static void put_groups(FILE *out, const plan *p, const gathered *g, put_group *put) {
    double *x = alloc_zeroed(p->nruns, sizeof *x);
    const entry *end = g->entries + g->nentries;
    for (const entry *begin = g->entries, *next; begin < end; begin = next) {
        for (next = begin + 1; next < end && compare_cells(begin, next) == 0;)
            next++;
        put(out, p, g, begin, next, x);
    }
    free(x);
}

static int close_table(FILE *out, char *path, diag *d) {
    int status = path_close(out, path, d);
    free(path);
    return status;
}

static int write_groups(const plan *p, gathered *g, const char *suffix, const char *columns, put_group *put, diag *d) {
    char *path = alloc_format("%s.%s.csv", p->name, suffix);
    FILE *out = path_open(path, "w", d);
    if (!out) {
        free(path);
        return SARCINA_ERROR;
    }
    sort_entries(g);
    put_axes(out, p);
    fprintf(out, "%s\n", columns);
    put_groups(out, p, g, put);
    return close_table(out, path, d);
}

/* A row a run; g's entries stand in the order of runs. */
static int write_scalars(const plan *p, const gathered *g, diag *d) {
    char *path = alloc_format("%s.scalars.csv", p->name);
    FILE *out = path_open(path, "w", d);
    if (!out) {
        free(path);
        return SARCINA_ERROR;
    }
    put_axes(out, p);
    fputs(p->first_seed ? "seed" : "run", out);
    for (size_t i = 0; i < g->nquantities; i++) {
        const quantity *q = &g->quantities[i];
        char *heading = *q->unit ? alloc_format("%s[%s]", q->name, q->unit) : alloc_copy(q->name);
        fputc(',', out);
        field_put_csv(out, heading);
        free(heading);
    }
    fputc('\n', out);
    for (const entry *e = g->entries, *end = e + g->nentries; e < end;) {
        size_t run = e->run;
        const entry **columns = alloc_zeroed(g->nquantities, sizeof *columns);
        for (; e < end && e->run == run; e++)
            columns[e->quantity] = e;
        put_point(out, p, p->runs[run].point);
        fprintf(out, "%ld", p->first_seed ? p->runs[run].seed : (long)run + 1);
        for (size_t i = 0; i < g->nquantities; i++) {
            if (columns[i] && columns[i]->never)
                fputs(",never", out);
            else
                put_number(out, columns[i] ? columns[i]->value : (double)NAN);
        }
        fputc('\n', out);
        free(columns);
    }
    return close_table(out, path, d);
}

static int gather(const plan *p, gathered *g, int (*read)(gathered *, const plan *, size_t, diag *), diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < p->nruns && !status; i++)
        if (p->runs[i].state == RUN_DONE)
            status = read(g, p, i, d);
    return status;
}

int merge_tables(const plan *p, diag *d) {
    gathered steps = {0}, scalars = {0};
    int status = gather(p, &steps, read_results, d);
    if (!status)
        status = gather(p, &scalars, read_scalars, d);
    if (!status)
        status =
            write_groups(p, &steps, "ensemble", "step,time,quantity,unit,runs,n,mean,ci95,sd,min,max", put_step, d);
    if (!status)
        status = write_scalars(p, &scalars, d);
    if (!status)
        status =
            write_groups(p, &scalars, "summary", "quantity,unit,runs,n,never,mean,ci95,sd,min,max", put_summary, d);
    free_gathered(&steps);
    free_gathered(&scalars);
    return status;
}
