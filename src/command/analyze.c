/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analyze ID GROUP STYLE, analyze ID GROUP first_time TEST, analyze now GROUP STYLE, analyze ID off. An ID is a value
 * in expressions; so are the analyses themselves, over all cells, by their own names. */
#include "command/commands.h"
#include "command/analyze_bins.h"
#include "command/output_list.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "base/table.h"
#include "output/field.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- measuring --------------------------------------------------------------------------------------------------- */

/* The number of each cell, by row; the caller frees. */
static int numbers_of(const output_column *of, size_t cells, double **out, diag *d) {
    int status = SARCINA_OK;
    *out = alloc_zeroed(cells, sizeof **out);
    for (uint32_t row = 0; row < cells && !status; row++)
        status = of->number(of->self, row, &(*out)[row], d);
    return status;
}

/* The style's value and fields of its group of the present scene, SI. */
static int measure(interp *in, const output_analysis *p, double si[1 + VALUE_FIELDS_MAX], diag *d) {
    const value_style *style = p->style;
    bool *members;
    double *of = NULL;
    int status = output_list_members(in, p->group, &members, d);
    view v = scene_view(interp_scene(in));
    v.radius = p->radius;
    if (!status && p->of)
        status = numbers_of(p->of, v.colony->cell.count, &of, d);
    v.of = of;
    if (!status)
        status = style->measure(&v, members, si, d);
    free(members);
    free(of);
    if (status)
        return status;
    si[0] = dim_from_engine(si[0], value_dim(style));
    for (size_t i = 0; i < value_field_count(style); i++) {
        char name[32];
        dim dimension;
        value_field(style, i, name, &dimension);
        si[1 + i] = dim_from_engine(si[1 + i], dimension);
    }
    return SARCINA_OK;
}

/* ID or ID.FIELD of a style. */
static int measured_value(interp *in, const output_analysis *p, const char *field, dim *dimension, double *si,
                          diag *d) {
    int i = field ? value_field_find(p->style, field) : -1;
    if (field && i < 0)
        return diag_error(d, "%s has no '%s'", p->id, field);
    *dimension = value_dim(p->style);
    char name[32];
    if (field)
        value_field(p->style, (size_t)i, name, dimension);
    if (!si)
        return SARCINA_OK;
    double all[1 + VALUE_FIELDS_MAX];
    int status = measure(in, p, all, d);
    *si = all[1 + i];
    return status;
}

/* ID.step (also the bare ID), ID.time, ID.kept[n] of a first_time; NaN before it happened. */
static int first_value(const output_analysis *p, const char *field, double index, dim *dimension, double *si, diag *d) {
    double x;
    size_t k = 0;
    if (field && strcmp(field, "kept") == 0) {
        k = isnan(index) ? 0 : (size_t)index - 1;
        if (k >= p->nkept)
            return diag_error(d, "%s keeps %zu %s, not %g", p->id, p->nkept, number_noun(p->nkept, "value", "values"),
                              isnan(index) ? 1 : index);
        *dimension = p->kept[k].d;
        x = p->values[k];
    } else if (!field || strcmp(field, "step") == 0) {
        *dimension = DIM_NONE;
        x = p->step;
    } else if (strcmp(field, "time") == 0) {
        *dimension = DIM_TIME;
        x = p->time;
    } else {
        return diag_error(d, "%s has no '%s': step, time, kept[1] ...", p->id, field);
    }
    if (si)
        *si = p->happened ? x : (double)NAN;
    return SARCINA_OK;
}

static int analysis_value(interp *in, size_t i, const char *field, double index, dim *dimension, double *si, diag *d) {
    const output_analysis *p = &output_list_of(in)->analyses[i];
    if (p->bins)
        return analyze_bins_value(in, p, field, index, dimension, si, d);
    bool keeps = !p->style && field && strcmp(field, "kept") == 0;
    if (!isnan(index) && !keeps)
        return diag_error(d, "%s%s%s is one value: it takes no [ ]", p->id, field ? "." : "", field ? field : "");
    if (!p->style)
        return first_value(p, field, index, dimension, si, d);
    return measured_value(in, p, field, dimension, si, d);
}

int output_list_judge(outputs *o, output_analysis *p, diag *d) {
    bool now = false;
    if (!p->test || p->happened)
        return SARCINA_OK;
    int status = interp_truth(o->in, p->test, &now, d);
    if (status || !now)
        return status;
    for (size_t k = 0; k < p->nkept && !status; k++)
        status = p->kept[k].number(p->kept[k].self, 0, &p->values[k], d);
    const scene *s = interp_scene(o->in);
    p->step = (double)s->step;
    p->time = s->time;
    p->happened = !status;
    return status;
}

/* ---- the file of an analysis: step, time, ID and its fields ------------------------------------------------------ */

static void put_header(const output_analysis *p) {
    FILE *f = stream_file(p->file);
    fprintf(f, "step,time,%s", p->id);
    for (size_t i = 0; i < value_field_count(p->style); i++) {
        char name[32];
        dim d;
        value_field(p->style, i, name, &d);
        fprintf(f, ",%s.%s", p->id, name);
    }
    fputc('\n', f);
}

int output_list_open_analysis(output_analysis *p, diag *d) {
    if (p->bins)
        return analyze_bins_open(p, d);
    int status = p->file ? stream_open(p->file, d) : SARCINA_OK;
    if (status || !p->file || !stream_is_empty(p->file))
        return status;
    put_header(p);
    return stream_flush(p->file, d);
}

int output_list_write_analysis(outputs *o, output_analysis *p, diag *d) {
    const scene *s = interp_scene(o->in);
    double si[1 + VALUE_FIELDS_MAX];
    char text[FIELD_ROOM];
    if (p->bins)
        return analyze_bins_write(o, p, d);
    int status = output_list_open_analysis(p, d);
    if (status || stream_has(p->file, s->step))
        return status;
    status = measure(o->in, p, si, d);
    if (status)
        return status;
    FILE *f = stream_file(p->file);
    fprintf(f, "%" PRIu64 ",%s", s->step, field_number(s->time, text));
    for (size_t i = 0; i <= value_field_count(p->style); i++)
        fprintf(f, ",%s", field_number(si[i], text));
    fputc('\n', f);
    return stream_end(p->file, s->step, d);
}

/* ---- the commands ------------------------------------------------------------------------------------------------ */

void output_list_add_analysis(outputs *o, const output_analysis *p, const args *a) {
    o->analyses = alloc_grow(o->analyses, &o->analysis_capacity, o->nanalyses + 1, sizeof *o->analyses);
    output_analysis *added = &o->analyses[o->nanalyses++];
    *added = *p;
    added->id = alloc_copy(args_text(a, "ID"));
    added->group = alloc_copy(args_text(a, "GROUP"));
    if (args_given(a, "every"))
        added->every = args_cycles(a, "every");
}

/* Measures of the whole colony take no group but all. */
static int check_group(const value_style *style, const args *a, diag *d) {
    double out[1 + VALUE_FIELDS_MAX];
    const bool none = false;
    colony empty = {0};
    const view v = {.colony = &empty};
    if (strcmp(args_text(a, "GROUP"), "all") == 0 || style->measure(&v, &none, out, d) == SARCINA_OK)
        return SARCINA_OK;
    diag_place(d, args_span(a, "GROUP"));
    return SARCINA_ERROR;
}

/* A radius for a measure that has none is a slip. */
static int check_radius(const value_style *style, const args *a, diag *d) {
    if (style->near || !args_given(a, "radius"))
        return SARCINA_OK;
    diag_error(d, "%s takes no radius", style->name);
    diag_place(d, args_span(a, "radius"));
    return SARCINA_ERROR;
}

/* What is looked at, and how far around. */
static int read_style(interp *in, const args *a, output_analysis *p, diag *d) {
    int status = check_group(p->style, a, d);
    if (!status)
        status = check_radius(p->style, a, d);
    p->radius = args_given(a, "radius") ? args_number(a, "radius") : 0;
    if (status || !args_given(a, "of"))
        return status;
    if (!p->style->of) {
        diag_error(d, "%s is not of a value of the cells: it takes no 'of'", p->style->name);
        diag_place(d, args_span(a, "of"));
        return SARCINA_ERROR;
    }
    p->of = alloc_zeroed(1, sizeof *p->of);
    status = interp_column(in, args_expr(a, "of"), true, p->of, d);
    if (status || !p->of->is_text)
        return status;
    diag_error(d, "%s is of numbers, and '%s' is a text", p->style->name, p->of->name);
    diag_help(d, "a truth of each cell is one: %s == '...'", p->of->name);
    diag_place(d, args_span(a, "of"));
    return SARCINA_ERROR;
}

static int read_file(outputs *o, const args *a, output_analysis *p, diag *d) {
    const char *path = args_text(a, "file");
    uint64_t step;
    int status = output_list_knows(a, "file") ? path_check(path, d) : SARCINA_OK;
    if (status) {
        diag_place(d, args_span(a, "file"));
        return status;
    }
    p->file = stream_create(path, STREAM_CSV, 0);
    return output_list_resumes(o, path, &step) ? stream_rewind(p->file, step, d) : SARCINA_OK;
}

static int run_style(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    output_analysis p = {.style = value_find(args_text(a, "STYLE")), .every = {.cycles = 1}};
    if (!p.style)
        return SARCINA_OK; /* not known in this check */
    int status = read_style(in, a, &p, d);
    if (!status && args_given(a, "file"))
        status = read_file(o, a, &p, d);
    if (status) {
        output_list_release_columns(p.of, p.of != NULL);
        return status;
    }
    output_list_add_analysis(o, &p, a);
    return SARCINA_OK;
}

static int read_kept(interp *in, const args *a, output_analysis *p, diag *d) {
    size_t n = args_given(a, "keep") ? args_count(a, "keep") : 0;
    p->kept = alloc_zeroed(n, sizeof *p->kept);
    p->values = alloc_zeroed(n, sizeof *p->values);
    int status = SARCINA_OK;
    for (; p->nkept < n && !status; p->nkept += !status) {
        status = interp_column(in, args_expr_at(a, "keep", p->nkept), false, &p->kept[p->nkept], d);
        if (!status && p->kept[p->nkept].is_text) {
            output_column *text = &p->kept[p->nkept++];
            diag_error(d, "first_time keeps numbers, and '%s' is a text", text->name);
            diag_place(d, args_span_at(a, "keep", p->nkept - 1));
            return SARCINA_ERROR;
        }
    }
    return status;
}

static int run_first_time(interp *in, const args *a, diag *d) {
    output_analysis p = {.step = NAN, .time = NAN};
    if (strcmp(args_text(a, "GROUP"), "all") != 0) {
        diag_error(d, "first_time judges the whole scene: its group is all");
        diag_place(d, args_span(a, "GROUP"));
        return SARCINA_ERROR;
    }
    int status = read_kept(in, a, &p, d);
    if (status) {
        output_list_release_columns(p.kept, p.nkept);
        free(p.values);
        return status;
    }
    p.test = expr_keep(args_expr(a, "TEST"));
    output_list_add_analysis(output_list_of(in), &p, a);
    return SARCINA_OK;
}

/* A number with its unit, in SI or `bio` as the script speaks. */
static void print_value(interp *in, const char *name, const char *field, double si, dim d) {
    char suffix[48], text[FIELD_ROOM];
    interp_print(in, "%s%s%s = %s%s", name, field ? "." : "", field ? field : "", field_number(si, text),
                 isnan(si) ? "" : dim_suffix(d, suffix));
}

static int run_now(interp *in, const args *a, diag *d) {
    const value_style *style = value_find(args_text(a, "STYLE"));
    double si[1 + VALUE_FIELDS_MAX];
    if (!style)
        return SARCINA_OK;
    output_analysis p = {.style = style, .group = alloc_copy(args_text(a, "GROUP"))};
    int status = read_style(in, a, &p, d);
    bool measures = !status && !interp_checking(in);
    if (measures)
        status = measure(in, &p, si, d);
    output_list_release_columns(p.of, p.of != NULL);
    free(p.group);
    if (status || !measures)
        return status;
    print_value(in, style->name, NULL, si[0], value_dim(style));
    for (size_t i = 0; i < value_field_count(style); i++) {
        char name[32];
        dim dimension;
        value_field(style, i, name, &dimension);
        print_value(in, style->name, name, si[1 + i], dimension);
    }
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    output_list_drop_analysis(output_list_of(in), (size_t)args_row(a, "ID"));
    return SARCINA_OK;
}

/* ---- records ----------------------------------------------------------------------------------------------------- */

static size_t count_analyses(interp *in) {
    return output_list_of(in)->nanalyses;
}

static const char *get_analysis(interp *in, size_t i) {
    return output_list_of(in)->analyses[i].id;
}

static const name_class analysis_class = {"analysis",     "an analysis", false, false,
                                          count_analyses, get_analysis,  NULL,  analysis_value};

static const param style_params[] = {
    {"ID:+analysis", "its name, a value from here on"},
    {"GROUP:group", "the cells: all, a species, a region, a group"},
    {"STYLE:analysis0", "what is measured"},
    {"radius:length(0,)",
     "of nematic and segregation: how far neighbours are; else one mean length of the cells, or what "
     "touches"},
    {"of:cell", "of segregation: a value of each cell, or a formula without blanks; else generation"},
    {"every:cycles[1,)", "cycles, or a time, between rows of the file; 1"},
    {"file:file", "a CSV file for step, time, the value and its fields, in SI units"},
};
static const param first_params[] = {
    {"ID:+analysis", "its name: ID.step (or ID), ID.time, ID.kept[1] ...; nan before it happens"},
    {"GROUP:group", "all"},
    {"TEST:expr", "judged at the end of each cycle"},
    {"keep:value...", "values to keep at that moment"},
};
static const param now_params[] = {
    {"GROUP:group", "the cells: all, a species, a region, a group"},
    {"STYLE:analysis0", "what is measured"},
    {"radius:length(0,)",
     "of nematic and segregation: how far neighbours are; else one mean length of the cells, or what "
     "touches"},
    {"of:cell", "of segregation: a value of each cell, or a formula without blanks; else generation"},
};
static const param off_params[] = {{"ID:analysis", "the analysis to forget"}};

static const command_form forms[] = {
    {"analyze ID:+analysis GROUP:group STYLE:analysis0", style_params, TABLE_COUNT(style_params),
     "Names a measure of some cells, and writes it along the way",
     "Every analysis is also a value by its own name, over all cells, without this command.",
     "analyze C ecoli orientation every 5 file C.csv\nprint \"$(C)\"\nanalyze S ecoli nematic radius 5um\nanalyze kin "
     "all segregation\nanalyze "
     "long all segregation of length radius 5um",
     COMMAND_DECLARES, run_style, NULL, 0},
    {"analyze ID:+analysis GROUP:group first_time TEST:expr", first_params, TABLE_COUNT(first_params),
     "Notes when a test first holds, and values at that moment", NULL,
     "analyze stacked all first_time thickness > 0.75um keep cells ellipse\nrun 3 grow 4min relax 0.1s\nprint "
     "\"$(stacked.time/1h) h, $(stacked.kept[1]) cells\"",
     COMMAND_DECLARES, run_first_time, NULL, 0},
    {"analyze now GROUP:group STYLE:analysis0", now_params, TABLE_COUNT(now_params),
     "Measures some cells and prints what was found", NULL,
     "analyze now all thickness\nanalyze now all nematic radius 5um\nanalyze now all segregation of z>1um",
     COMMAND_SHADOW, run_now, NULL, 0},
    {"analyze ID:analysis off", off_params, 1, "Forgets an analysis", NULL, "analyze C all orientation\nanalyze C off",
     COMMAND_DECLARES, run_off, NULL, 0},
};

void command_analyze(command_table *t) {
    command_add_class(t, &analysis_class);
    command_add(t, forms, TABLE_COUNT(forms));
    command_add(t, analyze_bins_forms, analyze_bins_form_count);
}
