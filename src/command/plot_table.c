/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two kinds of tables. Those of ensembles have a row a quantity: the columns before `step` (or `quantity`, in a
 * summary) are the sweep's axes. All others have a column a quantity. Either is read into samples, one a number to be
 * drawn. */
#include "command/plot_table.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/csv.h"
#include "base/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is wanted of a table: the ys, then x, then the upper ends of bins. */
enum { AT_X = PLOT_TABLE_CURVES, AT_END, WANTED };

typedef struct sample {
    size_t point; /* row of points: where in which sweep */
    int wanted;   /* row of y; AT_X, AT_END */
    double step, time, axis;
    size_t bin; /* of ID.count[3]: 3; 0: none */
    double mean, low, high;
} sample;

typedef struct point {
    char *label; /* "d = 0.7 um"; "" */
    size_t file;
} point;

struct plot_table_memory {
    sample *samples;
    size_t nsamples, sample_room;
    point *points;
    size_t npoints, point_room;
    double *numbers[5 * PLOT_TABLE_CURVES]; /* of the curves */
    size_t nnumbers;
    char *names[1 + 2 * PLOT_TABLE_CURVES];
    size_t nnames;
    char *x_end; /* quantity of the upper ends; NULL: no bins */
    dim d[WANTED];
    bool known[WANTED];
    bool summary; /* without steps */
};

typedef struct reading {
    const plot_table_request *r;
    struct plot_table_memory *m;
    size_t file;
    csv t;
    char **axes;       /* names of the sweep's variables, which are the first columns (naxes) */
    int naxes, x_axis; /* x_axis: the one drawn against; -1: none */
    int quantity, unit, step, time, mean, ci95, sd, min, max; /* columns; -1: none */
} reading;

/* ---- words ---- */

static dim dim_of_unit(units *u, const char *text) {
    units_value one;
    char *number = alloc_format("1%s", text);
    int status = units_read(u, number, strlen(number), &one, NULL);
    free(number);
    return status ? DIM_NONE : one.d;
}

/* "0.7um" as people write it: "0.7 um" with a Greek letter. */
static char *readable_text(const char *text) {
    size_t n = number_length(text, strlen(text), true);
    const char *behind = text + n;
    if (n == 0 || !*behind || *behind == '%')
        return alloc_copy(text);
    bool micro = behind[0] == 'u' && behind[1] == 'm';
    return alloc_format("%.*s %s%s", (int)n, text, micro ? "\u00b5" : "", behind + micro);
}

/* Which of the wanted a quantity is, and of which bin; -1: none. */
static int find_wanted(const reading *g, const char *name, size_t *bin) {
    size_t n = strcspn(name, "[");
    *bin = name[n] ? strtoul(name + n + 1, NULL, 10) : 0;
    const plot_table_request *r = g->r;
    bool binned = g->m->x_end && *bin;
    for (size_t i = 0; i <= r->ny; i++) {
        const char *wanted = i < r->ny ? r->y[i] : r->x;
        bool found = binned ? strlen(wanted) == n && strncmp(wanted, name, n) == 0 : strcmp(wanted, name) == 0;
        if (found)
            return i < r->ny ? (int)i : AT_X;
    }
    return binned && strlen(g->m->x_end) == n && strncmp(g->m->x_end, name, n) == 0 ? AT_END : -1;
}

static int find_column(const csv *t, const char *name) {
    for (size_t i = 0; i < t->n; i++)
        if (strcmp(t->fields[i], name) == 0)
            return (int)i;
    return -1;
}

static const char *field(const reading *g, int column) {
    return column >= 0 && (size_t)column < g->t.n ? g->t.fields[column] : "";
}

/* NaN where it is no number: `never`, nothing. */
static double number(const reading *g, int column) {
    const char *text = field(g, column);
    size_t n = strlen(text);
    return n && number_length(text, n, true) == n ? number_read(text, n, 0) : (double)NAN;
}

/* ---- samples ---- */

static void note_dim(struct plot_table_memory *m, int wanted, dim d) {
    if (!m->known[wanted])
        m->d[wanted] = d;
    m->known[wanted] = true;
}

static void add(struct plot_table_memory *m, const sample *s) {
    m->samples = alloc_grow(m->samples, &m->sample_room, m->nsamples + 1, sizeof *m->samples);
    m->samples[m->nsamples++] = *s;
}

/* The point of a row: its texts on all axes but that of x. */
static size_t find_point(reading *g) {
    struct plot_table_memory *m = g->m;
    char *label = alloc_copy("");
    for (int i = 0; i < g->naxes; i++) {
        if (i == g->x_axis)
            continue;
        char *text = readable_text(field(g, i));
        char *longer = alloc_format("%s%s%s = %s", label, *label ? ", " : "", g->axes[i], text);
        free(text);
        free(label);
        label = longer;
    }
    for (size_t i = m->npoints; i-- > 0;)
        if (m->points[i].file == g->file && strcmp(m->points[i].label, label) == 0) {
            free(label);
            return i;
        }
    m->points = alloc_grow(m->points, &m->point_room, m->npoints + 1, sizeof *m->points);
    m->points[m->npoints] = (point){label, g->file};
    return m->npoints++;
}

/* ---- a row a quantity: ensembles ---- */

static void set_band(const reading *g, sample *s) {
    double half = g->r->band == PLOT_TABLE_CI95 ? number(g, g->ci95) : number(g, g->sd);
    bool range = g->r->band == PLOT_TABLE_RANGE;
    s->low = range ? number(g, g->min) : s->mean - half;
    s->high = range ? number(g, g->max) : s->mean + half;
}

static void take_quantity(reading *g) {
    sample s = {.axis = NAN};
    s.wanted = find_wanted(g, field(g, g->quantity), &s.bin);
    if (s.wanted < 0)
        return;
    s.point = find_point(g);
    s.step = g->step < 0 ? 0 : number(g, g->step);
    s.time = number(g, g->time);
    s.mean = number(g, g->mean);
    set_band(g, &s);
    if (g->x_axis >= 0) {
        units_value v;
        const char *text = field(g, g->x_axis);
        if (units_read(g->r->units, text, strlen(text), &v, NULL) == SARCINA_OK) {
            s.axis = v.si;
            note_dim(g->m, AT_X, v.d);
        }
    }
    note_dim(g->m, s.wanted, dim_of_unit(g->r->units, field(g, g->unit)));
    add(g->m, &s);
}

static int read_axes(reading *g, diag *d) {
    g->naxes = g->step < 0 ? g->quantity : g->step;
    g->axes = alloc_zeroed((size_t)g->naxes, sizeof *g->axes);
    for (int i = 0; i < g->naxes; i++) {
        g->axes[i] = alloc_copy(g->t.fields[i]);
        if (strcmp(g->axes[i], g->r->x) == 0)
            g->x_axis = i;
    }
    g->m->summary = g->step < 0;
    if (!g->m->summary || g->x_axis >= 0)
        return SARCINA_OK;
    diag_error(d, "'%s' has no steps: its quantities are drawn against what was swept", g->t.path);
    if (g->naxes)
        diag_help(d, "vs %s", g->axes[0]);
    return SARCINA_ERROR;
}

static int read_quantities(reading *g, diag *d) {
    int status = read_axes(g, d);
    while (!status && csv_next(&g->t))
        take_quantity(g);
    for (int i = 0; i < g->naxes; i++)
        free(g->axes[i]);
    free(g->axes);
    return status;
}

/* ---- a column a quantity: tables of a run ---- */

/* Of `length[m]`, of a value's name, else a pure number. */
static dim dim_of_heading(units *u, const char *heading) {
    const char *bracket = strchr(heading, '['), *dot = strchr(heading, '.');
    char name[64], part[32];
    dim d = DIM_NONE;
    if (bracket) {
        snprintf(name, sizeof name, "%.*s", (int)strcspn(bracket + 1, "]"), bracket + 1);
        return dim_of_unit(u, name);
    }
    snprintf(name, sizeof name, "%.*s", dot ? (int)(dot - heading) : 60, heading);
    const value_style *style = value_find(name);
    int row = style && dot ? value_field_find(style, dot + 1) : -1;
    if (row >= 0)
        value_field(style, (size_t)row, part, &d);
    return !style || dot ? d : value_dim(style);
}

static int refuse_column(const reading *g, const char *name, diag *d) {
    char list[400] = "";
    for (size_t i = 0; i < g->t.n && strlen(list) < 300; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), " %.60s", g->t.fields[i]);
    diag_error(d, "'%s' has no column '%s'", g->t.path, name);
    return diag_help(d, "there are:%s", list);
}

/* The column called so, with or without its unit. */
static int find_heading(const reading *g, const char *name) {
    for (size_t i = 0; i < g->t.n; i++) {
        const char *heading = g->t.fields[i];
        size_t n = strcspn(heading, "[");
        if (strcmp(heading, name) == 0 || (strlen(name) == n && strncmp(heading, name, n) == 0))
            return (int)i;
    }
    return -1;
}

static int read_columns(reading *g, diag *d) {
    int columns[PLOT_TABLE_CURVES + 1];
    const plot_table_request *r = g->r;
    for (size_t i = 0; i <= r->ny; i++) {
        const char *name = i < r->ny ? r->y[i] : r->x;
        columns[i] = find_heading(g, name);
        if (columns[i] < 0)
            return refuse_column(g, name, d);
        note_dim(g->m, i < r->ny ? (int)i : AT_X, dim_of_heading(r->units, g->t.fields[columns[i]]));
    }
    size_t at = find_point(g);
    for (double row = 0; csv_next(&g->t); row++)
        for (size_t i = 0; i < r->ny; i++) {
            sample s = {.point = at, .wanted = (int)i, .step = row, .axis = number(g, columns[r->ny])};
            s.mean = number(g, columns[i]);
            s.low = s.high = NAN;
            add(g->m, &s);
        }
    return SARCINA_OK;
}

static int read_table(const plot_table_request *r, struct plot_table_memory *m, size_t file, diag *d) {
    reading g = {.r = r, .m = m, .file = file, .x_axis = -1};
    int status = csv_open(&g.t, r->files[file], d);
    if (status)
        return status;
    if (!csv_next(&g.t)) {
        csv_close(&g.t);
        return diag_error(d, "'%s' has no header line", r->files[file]);
    }
    struct {
        int *column;
        const char *name;
    } known[] = {{&g.quantity, "quantity"}, {&g.unit, "unit"}, {&g.step, "step"}, {&g.time, "time"}, {&g.mean, "mean"},
                 {&g.ci95, "ci95"},         {&g.sd, "sd"},     {&g.min, "min"},   {&g.max, "max"}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        *known[i].column = find_column(&g.t, known[i].name);
    bool ensemble = g.quantity >= 0 && g.mean >= 0 && g.unit >= 0;
    status = ensemble ? read_quantities(&g, d) : read_columns(&g, d);
    csv_close(&g.t);
    return status;
}

/* ---- curves ---- */

static int compare_samples(const void *a, const void *b) {
    const sample *p = a, *q = b;
    if (p->point != q->point)
        return p->point < q->point ? -1 : 1;
    if (p->wanted != q->wanted)
        return p->wanted - q->wanted;
    if (p->step != q->step)
        return p->step < q->step ? -1 : 1;
    return p->bin == q->bin ? 0 : p->bin < q->bin ? -1 : 1;
}

/* The mean of another quantity at the same place and time. */
static double partner(const struct plot_table_memory *m, const sample *s, int wanted) {
    sample key = *s;
    key.wanted = wanted;
    const sample *found = bsearch(&key, m->samples, m->nsamples, sizeof key, compare_samples);
    return found ? found->mean : (double)NAN;
}

static double *new_numbers(struct plot_table_memory *m, size_t n) {
    double *list = alloc_zeroed(n, sizeof *list);
    m->numbers[m->nnumbers++] = list;
    return list;
}

static double place(const plot_table_request *r, const struct plot_table_memory *m, const sample *s) {
    if (!isnan(s->axis))
        return s->axis;
    if (strcmp(r->x, "step") == 0)
        return s->step;
    return strcmp(r->x, "time") == 0 ? s->time : partner(m, s, AT_X);
}

/* Where nothing else says what the axis is: the steps and times of ensembles. */
static void settle_x(const plot_table_request *r, struct plot_table_memory *m) {
    if (strcmp(r->x, "time") == 0 && !m->known[AT_X])
        m->d[AT_X] = DIM_TIME;
}

/* The samples of one curve: those of the last step (or the step asked for) where they are bins. */
static void make_curve(const plot_table_request *r, struct plot_table_memory *m, const sample *first, size_t n,
                       plot_curve *c) {
    double *x = new_numbers(m, n), *y = new_numbers(m, n), *low = new_numbers(m, n), *high = new_numbers(m, n);
    double *end = m->x_end ? new_numbers(m, n) : NULL, last = first[n - 1].step;
    c->n = 0;
    for (size_t i = 0; i < n; i++) {
        const sample *s = &first[i];
        if (m->x_end && s->step != (isnan(r->step) ? last : r->step))
            continue;
        x[c->n] = place(r, m, s);
        if (end)
            end[c->n] = partner(m, s, AT_END);
        y[c->n] = s->mean;
        low[c->n] = s->low;
        high[c->n++] = s->high;
    }
    c->x = x;
    c->y = y;
    c->x_end = end;
    bool band = false; /* of one run there is none */
    for (size_t i = 0; i < c->n && r->band != PLOT_TABLE_NONE; i++)
        band = band || !isnan(low[i]);
    c->low = band ? low : NULL;
    c->high = band ? high : NULL;
    c->d = m->d[first->wanted];
}

/* "default" of "runs/default.ensemble.csv". */
static char *name_of_file(const char *path) {
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    return alloc_copy_n(base, strcspn(base, "."));
}

/* What tells the curve from the others: y, file, point. */
static const char *name_curve(const plot_table_request *r, struct plot_table_memory *m, const sample *s) {
    const point *at = &m->points[s->point];
    char *file = r->nfiles > 1 ? name_of_file(r->files[at->file]) : alloc_copy("");
    const char *y = r->ny > 1 || (!*file && !*at->label) ? r->y[s->wanted] : "";
    char *name = alloc_format("%s%s%s%s%s", y, *y && *file ? ", " : "", file, (*y || *file) && *at->label ? ", " : "",
                              at->label);
    free(file);
    m->names[m->nnames++] = name;
    return name;
}

/* Of boxes there is one set; several curves are told apart as lines. */
static plot_shape shape_of(const plot_table_request *r, const plot_table *t) {
    const char *dot = strrchr(r->y[0], '.');
    bool counts = dot && (strcmp(dot, ".count") == 0 || strcmp(dot, ".fraction") == 0);
    if (t->memory->summary)
        return PLOT_POINTS;
    return t->memory->x_end && counts && t->diagram.count == 1 ? PLOT_BOXES : PLOT_LINE;
}

static int make_curves(const plot_table_request *r, plot_table *t, diag *d) {
    struct plot_table_memory *m = t->memory;
    size_t n;
    if (m->nsamples)
        qsort(m->samples, m->nsamples, sizeof *m->samples, compare_samples);
    settle_x(r, m);
    for (size_t i = 0; i < m->nsamples; i += n) {
        const sample *s = &m->samples[i];
        for (n = 1; i + n < m->nsamples && s[n].point == s->point && s[n].wanted == s->wanted;)
            n++;
        if (s->wanted >= AT_X)
            continue;
        if (t->diagram.count == PLOT_TABLE_CURVES)
            return diag_error(d, "the tables hold more than %d curves of this", PLOT_TABLE_CURVES);
        plot_curve *c = &t->curves[t->diagram.count++];
        c->name = name_curve(r, m, s);
        c->axis = r->y[s->wanted];
        make_curve(r, m, s, n, c);
    }
    t->diagram.shape = shape_of(r, t);
    t->diagram.x_dim = m->d[AT_X];
    return SARCINA_OK;
}

static bool has(const struct plot_table_memory *m, int wanted) {
    for (size_t i = 0; i < m->nsamples; i++)
        if (m->samples[i].wanted == wanted)
            return true;
    return false;
}

/* The step asked for is that of bins, and they are there then. */
static int check_step(const plot_table_request *r, const struct plot_table_memory *m, diag *d) {
    double near = NAN;
    if (isnan(r->step))
        return SARCINA_OK;
    if (!m->x_end) {
        diag_error(d, "at STEP chooses bins, which are drawn against ID.low, not against %s", r->x);
        return diag_help(d, "plot table lengths.count vs lengths.low from FILE at 8 file F.svg");
    }
    for (size_t i = 0; i < m->nsamples; i++)
        if (isnan(near) || fabs(m->samples[i].step - r->step) < fabs(near - r->step))
            near = m->samples[i].step;
    if (near == r->step)
        return SARCINA_OK;
    diag_error(d, "no table has bins at step %.0f", r->step);
    return diag_help(d, "the nearest is %.0f", near);
}

/* Every quantity asked for is there. */
static int check(const plot_table_request *r, const struct plot_table_memory *m, diag *d) {
    for (size_t i = 0; i < r->ny; i++)
        if (!has(m, (int)i))
            return diag_error(d, "no table says anything of '%s'", r->y[i]);
    bool clock = strcmp(r->x, "step") == 0 || strcmp(r->x, "time") == 0 || !isnan(m->samples[0].axis);
    return clock || has(m, AT_X) ? SARCINA_OK : diag_error(d, "no table says anything of '%s'", r->x);
}

int plot_table_read(const plot_table_request *r, plot_table *out, diag *d) {
    *out = (plot_table){.memory = alloc_zeroed(1, sizeof *out->memory)};
    struct plot_table_memory *m = out->memory;
    out->diagram = (plot_diagram){.x_name = r->x, .curves = out->curves};
    size_t n = strlen(r->x);
    if (n > 4 && strcmp(r->x + n - 4, ".low") == 0)
        m->x_end = alloc_format("%.*s.high", (int)n - 4, r->x);
    if (m->x_end) {
        m->names[m->nnames++] = alloc_format("%.*s", (int)n - 4, r->x);
        out->diagram.x_name = m->names[0];
    }
    int status = SARCINA_OK;
    for (size_t i = 0; i < r->nfiles && !status; i++)
        status = read_table(r, m, i, d);
    if (!status)
        status = check(r, m, d);
    if (!status)
        status = check_step(r, m, d);
    return status ? status : make_curves(r, out, d);
}

void plot_table_free(plot_table *t) {
    struct plot_table_memory *m = t->memory;
    for (size_t i = 0; i < m->npoints; i++)
        free(m->points[i].label);
    for (size_t i = 0; i < m->nnumbers; i++)
        free(m->numbers[i]);
    for (size_t i = 0; i < m->nnames; i++)
        free(m->names[i]);
    free(m->points);
    free(m->samples);
    free(m->x_end);
    free(m);
}
