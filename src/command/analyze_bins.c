/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/analyze_bins.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "base/table.h"
#include "analysis/bins.h"
#include "output/field.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef enum { ALONG_X, ALONG_Y, ALONG_Z, ALONG_R, ALONG_VALUE } along_kind;

struct output_bins {
    along_kind along; /* ALONG_VALUE: a histogram of the value itself */
    output_column value;
    size_t n;
    double low, high; /* SI; NaN: of the cells */
    char *pattern;    /* of a file a step; NULL: none */
};

void analyze_bins_ends(const output_analysis *p, double *low, double *high) {
    *low = p->bins->low;
    *high = p->bins->high;
}

void analyze_bins_free(output_bins *b) {
    if (!b)
        return;
    if (b->value.release)
        b->value.release(b->value.self);
    free(b->value.name);
    free(b->pattern);
    free(b);
}

/* ---- what a bin holds ------------------------------------------------------------------------------------------- */

typedef enum { LOW, HIGH, COUNT, FRACTION, DENSITY, MEAN, SD, CI95, FIELDS } bin_field;
static const char *const fields[] = {"low", "high", "count", "fraction", "density", "mean", "sd", "ci95"};

static size_t field_count(const output_bins *b) {
    return b->along == ALONG_VALUE ? DENSITY : FIELDS;
}

static dim field_dim(const output_bins *b, bin_field f) {
    switch (f) {
    case LOW:
    case HIGH:
        return b->along == ALONG_VALUE ? b->value.d : DIM_LENGTH;
    case DENSITY:
        return b->along == ALONG_R ? DIM(-2, 0, 0) : DIM(-1, 0, 0);
    case MEAN:
    case SD:
    case CI95:
        return b->value.d;
    default:
        return DIM_NONE;
    }
}

/* Cells a length, or an area of the ring between two radii. */
static double bin_density(const output_bins *b, const bins *k, size_t i) {
    double low = bins_edge(k, i), high = bins_edge(k, i + 1);
    double size = b->along == ALONG_R ? M_PI * (high * high - low * low) : high - low;
    return size > 0 ? k->count[i] / size : (double)NAN;
}

static double field_value(const output_bins *b, const bins *k, bin_field f, size_t i) {
    switch (f) {
    case LOW:
        return bins_edge(k, i);
    case HIGH:
        return bins_edge(k, i + 1);
    case COUNT:
        return k->count[i];
    case FRACTION:
        return k->total > 0 ? k->count[i] / k->total : (double)NAN;
    case DENSITY:
        return bin_density(b, k, i);
    case MEAN:
        return bins_mean(k, i);
    case SD:
        return bins_sd(k, i);
    default:
        return bins_ci95(k, i);
    }
}

/* ---- sorting the cells ------------------------------------------------------------------------------------------ */

/* Where the cells are along the direction, SI; r: in the plane, from their mean centre. In the order of ids. */
static void find_places(colony *c, along_kind along, const uint32_t *rows, size_t n, double *x) {
    double mean[2] = {0, 0}, centre[3];
    for (size_t i = 0; i < n && along == ALONG_R; i++) {
        colony_centre(c, rows[i], centre);
        mean[0] += centre[0] / (double)n;
        mean[1] += centre[1] / (double)n;
    }
    for (size_t i = 0; i < n; i++) {
        colony_centre(c, rows[i], centre);
        double at = along == ALONG_R ? hypot(centre[0] - mean[0], centre[1] - mean[1]) : centre[along];
        x[i] = dim_from_engine(at, DIM_LENGTH);
    }
}

static int fill(interp *in, const output_bins *b, const char *group, bins *out, diag *d) {
    bool *members;
    int status = output_list_members(in, group, &members, d);
    view v = scene_view(interp_scene(in));
    const dump_frame f = {.view = &v, .members = members};
    size_t n = 0;
    uint32_t *rows = status ? NULL : dump_rows(&f, &n);
    double *value = alloc_zeroed(n, sizeof *value), *x = alloc_zeroed(n, sizeof *x);
    for (size_t i = 0; i < n && !status; i++)
        status = b->value.number(b->value.self, rows[i], &value[i], d);
    *out = bins_create(b->n);
    if (!status && b->along == ALONG_VALUE)
        bins_fill(out, value, NULL, n, b->low, b->high);
    if (!status && b->along != ALONG_VALUE) {
        find_places(v.colony, b->along, rows, n, x);
        bins_fill(out, x, value, n, NAN, NAN);
    }
    free(value);
    free(x);
    free(rows);
    free(members);
    if (status)
        bins_free(out);
    return status;
}

static int find_field(const output_bins *b, const char *name) {
    for (size_t i = 0; i < field_count(b); i++)
        if (strcmp(fields[i], name) == 0)
            return (int)i;
    return -1;
}

int analyze_bins_value(interp *in, const output_analysis *p, const char *field, double index, dim *dimension,
                       double *si, diag *d) {
    const output_bins *b = p->bins;
    int f = field ? find_field(b, field) : -1;
    if (field && f < 0)
        return diag_error(d, "%s has no '%s': low[1], high[1], count[1], fraction[1] ...", p->id, field);
    *dimension = field ? field_dim(b, (bin_field)f) : DIM_NONE;
    if (field && !(index >= 1 && index <= (double)b->n && index == floor(index)))
        return diag_error(d, "%s.%s takes the number of a bin: %s.%s[1] to [%zu]", p->id, field, p->id, field, b->n);
    if (!si)
        return SARCINA_OK;
    bins k;
    int status = fill(in, b, p->group, &k, d);
    if (status)
        return status;
    *si = field ? field_value(b, &k, (bin_field)f, (size_t)index - 1) : k.total;
    bins_free(&k);
    return SARCINA_OK;
}

size_t analyze_bins_count(const output_analysis *p) {
    return p->bins->n;
}

bool analyze_bins_is_profile(const output_analysis *p) {
    return p->bins->along != ALONG_VALUE;
}

const char *analyze_bins_along(const output_analysis *p) {
    static const char *const names[] = {"x", "y", "z", "r"};
    return analyze_bins_is_profile(p) ? names[p->bins->along] : p->bins->value.name;
}

int analyze_bins_each(interp *in, const output_analysis *p, analyze_bins_visit *visit, void *self, diag *d) {
    const output_bins *b = p->bins;
    bins k;
    int status = fill(in, b, p->group, &k, d);
    if (status)
        return status;
    for (size_t f = 0; f < field_count(b); f++)
        for (size_t i = 0; i < k.n; i++) {
            char *name = alloc_format("%s.%s[%zu]", p->id, fields[f], i + 1);
            visit(self, name, field_dim(b, (bin_field)f), field_value(b, &k, (bin_field)f, i));
            free(name);
        }
    bins_free(&k);
    return SARCINA_OK;
}

/* ---- files ------------------------------------------------------------------------------------------------------ */

static void put_header(const output_bins *b, bool many, FILE *out) {
    fputs(many ? "step,time" : "", out);
    for (size_t i = 0; i < field_count(b); i++)
        fprintf(out, "%s%s", i || many ? "," : "", fields[i]);
    fputc('\n', out);
}

static void put_rows(const output_bins *b, const bins *k, const scene *s, bool many, FILE *out) {
    char text[FIELD_ROOM];
    for (size_t i = 0; i < k->n; i++) {
        if (many)
            fprintf(out, "%" PRIu64 ",%s", s->step, field_number(s->time, text));
        for (size_t f = 0; f < field_count(b); f++)
            fprintf(out, "%s%s", f || many ? "," : "", field_number(field_value(b, k, (bin_field)f, i), text));
        fputc('\n', out);
    }
}

int analyze_bins_open(output_analysis *p, diag *d) {
    if (!p->file)
        return SARCINA_OK;
    int status = stream_open(p->file, d);
    if (status || !stream_is_empty(p->file))
        return status;
    put_header(p->bins, true, stream_file(p->file));
    return stream_flush(p->file, d);
}

static int write_file(const output_bins *b, const bins *k, const scene *s, diag *d) {
    char *name = dump_file_name(b->pattern, s->step, 0);
    FILE *out = path_open(name, "w", d);
    int status = out ? SARCINA_OK : SARCINA_ERROR;
    if (out) {
        put_header(b, false, out);
        put_rows(b, k, s, false, out);
        status = path_close(out, name, d);
    }
    free(name);
    return status;
}

int analyze_bins_write(outputs *o, output_analysis *p, diag *d) {
    const scene *s = interp_scene(o->in);
    bins k;
    int status = analyze_bins_open(p, d);
    if (status || (!p->file && !p->bins->pattern) || (p->file && stream_has(p->file, s->step)))
        return status;
    status = fill(o->in, p->bins, p->group, &k, d);
    if (status)
        return status;
    if (p->bins->pattern) {
        status = write_file(p->bins, &k, s, d);
    } else {
        put_rows(p->bins, &k, s, true, stream_file(p->file));
        status = stream_end(p->file, s->step, d);
    }
    bins_free(&k);
    return status;
}

/* ---- the commands ----------------------------------------------------------------------------------------------- */

/* An end of a histogram: of the value's dimension; a bare number is in the script's units of it. */
static int read_end(interp *in, const args *a, const char *name, dim d, double *si, diag *diagnostic) {
    char suffix[48], given[48];
    *si = NAN;
    if (!args_given(a, name))
        return SARCINA_OK;
    quantity q = args_quantity(a, name);
    *si = q.plain ? q.si * interp_unit(in, d) : q.si;
    if (q.plain || dim_equal(q.d, d))
        return SARCINA_OK;
    dim_suffix(d, suffix);
    dim_suffix(q.d, given);
    diag_error(diagnostic, "%s is in '%s', the value in '%s'", name, given, suffix);
    diag_place(diagnostic, args_span(a, name));
    return SARCINA_ERROR;
}

static int read_value(interp *in, const args *a, output_column *value, diag *d) {
    int status = interp_column(in, args_expr(a, "VALUE"), true, value, d);
    if (!status && value->is_text) {
        diag_error(d, "bins are of numbers, and '%s' is a text", value->name);
        diag_place(d, args_span(a, "VALUE"));
        return SARCINA_ERROR;
    }
    return status;
}

/* NULL: an error, or an expression that is not known in this check. */
static output_bins *read_bins(interp *in, const args *a, bool profile, int *status, diag *d) {
    output_bins *b = alloc_zeroed(1, sizeof *b);
    b->along = profile ? (along_kind)args_choice(a, "along") : ALONG_VALUE;
    b->n = (size_t)args_int(a, "bins");
    b->low = b->high = NAN;
    *status = read_value(in, a, &b->value, d);
    if (!*status && !profile)
        *status = read_end(in, a, "lo", b->value.d, &b->low, d);
    if (!*status && !profile)
        *status = read_end(in, a, "hi", b->value.d, &b->high, d);
    if (!*status && b->low >= b->high) {
        *status = diag_error(d, "hi must be above lo");
        diag_place(d, args_span(a, "hi"));
    }
    if (!*status)
        return b;
    analyze_bins_free(b);
    return NULL;
}

/* The file: one a step where its name has a *. */
static int read_file(outputs *o, const args *a, output_analysis *p, diag *d) {
    const char *path = args_text(a, "file");
    uint64_t step;
    char *name = dump_file_name(path, 0, 0);
    int status = output_list_knows(a, "file") ? path_check(name, d) : SARCINA_OK;
    free(name);
    if (status) {
        diag_place(d, args_span(a, "file"));
        return status;
    }
    if (strchr(path, '*'))
        p->bins->pattern = alloc_copy(path);
    else
        p->file = stream_create(path, STREAM_CSV, 0);
    return p->file && output_list_resumes(o, path, &step) ? stream_rewind(p->file, step, d) : SARCINA_OK;
}

static int declare(interp *in, const args *a, bool profile, diag *d) {
    outputs *o = output_list_of(in);
    int status;
    output_analysis p = {.every = {.cycles = 1}};
    p.bins = read_bins(in, a, profile, &status, d);
    if (!status && args_given(a, "file"))
        status = read_file(o, a, &p, d);
    if (status) {
        analyze_bins_free(p.bins);
        return status;
    }
    output_list_add_analysis(o, &p, a);
    return SARCINA_OK;
}

static int run_histogram(interp *in, const args *a, diag *d) {
    return declare(in, a, false, d);
}

static int run_profile(interp *in, const args *a, diag *d) {
    return declare(in, a, true, d);
}

/* A bar of at most 40 characters behind each bin. */
static void print_bins(interp *in, const output_bins *b, const bins *k) {
    double most = 1, divisor = interp_unit(in, b->value.d);
    for (size_t i = 0; i < k->n; i++)
        most = fmax(most, k->count[i]);
    for (size_t i = 0; i < k->n; i++) {
        char bar[41] = "";
        memset(bar, '#', (size_t)lround(40 * k->count[i] / most));
        interp_print(in, "%12.5g %12.5g %8.0f%s%s", bins_edge(k, i) / divisor, bins_edge(k, i + 1) / divisor,
                     k->count[i], *bar ? " " : "", bar);
    }
}

static int run_now(interp *in, const args *a, diag *d) {
    int status;
    bins k;
    output_bins *b = read_bins(in, a, false, &status, d);
    if (status || interp_checking(in)) {
        analyze_bins_free(b);
        return status;
    }
    status = fill(in, b, args_text(a, "GROUP"), &k, d);
    if (!status) {
        char suffix[48];
        dim_suffix(b->value.d, suffix);
        interp_print(in, "%s%s%s%s of %.0f %s", b->value.name, *suffix ? " [" : "", suffix, *suffix ? "]" : "", k.total,
                     number_noun((uint64_t)k.total, "cell", "cells"));
        print_bins(in, b, &k);
        bins_free(&k);
    }
    analyze_bins_free(b);
    return status;
}

#define BINS_ID                                                                                                        \
    { "ID:+analysis", "its name: ID is how many cells were counted, ID.count[1] ... what a bin holds" }
#define BINS_GROUP                                                                                                     \
    { "GROUP:group", "the cells: all, a species, a region, a group" }
#define BINS_FILE                                                                                                      \
    {"every:cycles[1,)", "cycles, or a time, between tables of the file; 1"}, {                                        \
        "file:file", "a CSV file for the bins, in SI units; with * one a step, else all steps one after another"       \
    }
#define BINS_ENDS                                                                                                      \
    {"VALUE:cell", "a value of each cell, or a formula without blanks"}, {"bins=20:int[1,)", "how many"},              \
        {"lo:any", "lower end of the first; else the least of the cells"}, {                                           \
        "hi:any", "upper end of the last; else the largest of the cells"                                               \
    }

static const param histogram_params[] = {BINS_ID, BINS_GROUP, BINS_ENDS, BINS_FILE};
static const param now_params[] = {BINS_GROUP, BINS_ENDS};
static const param profile_params[] = {
    BINS_ID,
    BINS_GROUP,
    {"VALUE:cell", "a value of each cell, or a formula without blanks"},
    {"along=z:{x|y|z|r}", "the direction; r: from the cells' mean centre, in the plane"},
    {"bins=20:int[1,)", "how many, from the least to the largest place of the cells"},
    BINS_FILE,
};

const command_form analyze_bins_forms[] = {
    {"analyze ID:+analysis GROUP:group histogram VALUE:cell", histogram_params, TABLE_COUNT(histogram_params),
     "Counts the cells by a value, in bins of equal width",
     "Fields and columns: low and high end, count, fraction. A bin has its lower end, the last also its upper one; "
     "what "
     "lies outside is not counted. Bare ends are in the script's units.",
     "analyze lengths ecoli histogram length bins 10 lo 2um hi 6um every 5 file lengths.*.csv\nprint "
     "\"$(lengths.count[1]) of $(lengths)\"",
     COMMAND_DECLARES, run_histogram, NULL, 0},
    {"analyze ID:+analysis GROUP:group profile VALUE:cell", profile_params, TABLE_COUNT(profile_params),
     "Averages a value of the cells in bins along a direction",
     "Fields and columns: low and high end, count, fraction, density (cells a length of the bin; along r an area of "
     "the "
     "ring), mean, sd (n - 1) and ci95, half the 95 % interval of the mean by Student's t.",
     "analyze heights all profile generation along r bins 5 every 10 file generation.csv\nprint "
     "\"$(heights.mean[1])\"",
     COMMAND_DECLARES, run_profile, NULL, 0},
    {"analyze now GROUP:group histogram VALUE:cell", now_params, TABLE_COUNT(now_params),
     "Counts some cells by a value and prints the bins", NULL, "analyze now all histogram length bins 5 lo 2um hi 6um",
     COMMAND_SHADOW, run_now, NULL, 0},
};
const size_t analyze_bins_form_count = TABLE_COUNT(analyze_bins_forms);
