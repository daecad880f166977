/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_report.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/table.h"
#include "output/field.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- numbers ---- */

/* "3.66 +- 0.30 h (n 20)" in Markdown's words; "-" of nothing. */
static void put_sample(FILE *out, inference_sample x, const study_quantity *q, bool count) {
    if (!x.n) {
        fputs("–", out);
        return;
    }
    fprintf(out, "%.*f", q->digits, x.mean);
    if (x.n > 1 && !isnan(x.sd))
        fprintf(out, " ± %.*f", q->digits, inference_ci95(x));
    if (count)
        fprintf(out, " (n %zu)", x.n);
}

static void put_printed(FILE *out, const study_printed *p) {
    if (!p)
        fputs("–", out);
    else if (p->ci95 > 0)
        fprintf(out, "%g ± %g", p->value, p->ci95);
    else
        fprintf(out, "%g", p->value);
}

static void put_p(FILE *out, double p) {
    if (p < 1e-4)
        fprintf(out, "%.0e", p);
    else
        fprintf(out, "%.2g", p);
}

static long last_step(const study_ensemble *e) {
    return (long)study_table_number(&e->series[0], e->series[0].nrows - 1, "step");
}

/* ---- RESULTS.csv ---- */

static void put_csv_number(FILE *out, double x) {
    char text[FIELD_ROOM];
    fputc(',', out);
    if (!isnan(x))
        fputs(field_number(x, text), out);
}

static void put_csv_row(FILE *out, const study *s, const study_case *c, const study_quantity *q) {
    inference_sample ours = study_sample(s, c->name, q->name);
    const study_printed *paper = study_printed_find(c->name, q->name);
    long step;
    inference_sample theirs = study_reference(s, c, q, 1, &step);
    bool same_state = c->family == STUDY_ECOLI || step == last_step(study_find(s, c->name));
    fprintf(out, "%s,%s", c->name, q->name);
    if (*q->unit)
        fprintf(out, "[%s]", q->unit);
    put_csv_number(out, ours.mean);
    put_csv_number(out, inference_ci95(ours));
    fprintf(out, ",%zu", ours.n);
    put_csv_number(out, paper ? paper->value : (double)NAN);
    put_csv_number(out, same_state ? theirs.mean : (double)NAN);
    fputc('\n', out);
}

int study_report_csv(const study *s, const char *path, diag *d) {
    FILE *out = path_open(path, "w", d);
    if (!out)
        return SARCINA_ERROR;
    fputs("case,quantity,ours,ci95,n,paper,reference\n", out);
    for (size_t i = 0; i < study_case_count; i++)
        for (size_t k = 0; k < study_quantity_count && s->cases[i].n; k++)
            if (study_quantities[k].family == study_cases[i].family)
                put_csv_row(out, s, &study_cases[i], &study_quantities[k]);
    return path_close(out, path, d);
}

/* ---- tables of RESULTS.md ---- */

static void put_runs(FILE *out, const study *s) {
    fputs("| ensemble | script | options | seeds | growth steps |\n|-|-|-|-|-|\n", out);
    for (size_t i = 0; i < study_case_count; i++) {
        const study_case *c = &study_cases[i];
        const study_ensemble *e = &s->cases[i];
        if (!e->n)
            continue;
        fprintf(out, "| %s | [%s.in](%s.in) | %s%s%s | %ld–%ld (%zu) | %ld |\n", c->name, c->script, c->script,
                *c->options ? "`" : "", c->options, *c->options ? "`" : "", e->seeds[0], e->seeds[e->n - 1], e->n,
                last_step(e));
    }
}

/* Ours, and in how many of the runs. */
static void put_ours(FILE *out, const study *s, const char *name, const study_quantity *q) {
    const study_ensemble *e = study_find(s, name);
    inference_sample x = study_sample(s, name, q->name);
    if (e && !x.n) {
        fprintf(out, "never (of %zu)", e->n);
        return;
    }
    put_sample(out, x, q, false);
    if (e)
        fprintf(out, " (%zu of %zu)", x.n, e->n);
}

/* Stacking: the paper, the original run by us, ours as the examples stand and with the original's rules. */
static void put_stacking(FILE *out, const study *s) {
    static const char *const names[] = {"stack_time", "stack_area", "stack_cells"};
    fputs("| case | | paper (10 runs) | original, run again (10) | ours | ours, links as in the original |\n"
          "|-|-|-|-|-|-|\n",
          out);
    for (size_t i = 0; i < study_case_count; i++) {
        const study_case *c = &study_cases[i];
        if (c->family != STUDY_ECOLI || c->variant || !s->cases[i].n)
            continue;
        char *published = alloc_format("%s_published", c->name);
        for (size_t k = 0; k < TABLE_COUNT(names); k++) {
            const study_quantity *q = study_quantity_find(names[k]);
            long step;
            fprintf(out, "| %s | %s%s%s | ", k == 0 ? c->title : "", q->name, *q->unit ? ", " : "", q->unit);
            put_printed(out, study_printed_find(c->name, q->name));
            fputs(" | ", out);
            put_sample(out, study_reference(s, c, q, 1, &step), q, false);
            fputs(" | ", out);
            put_ours(out, s, c->name, q);
            fputs(" | ", out);
            put_ours(out, s, published, q);
            fputs(" |\n", out);
        }
        free(published);
    }
}

/* A difference of stackings from the original's, judged at 99 %; true when they agree. */
static bool put_against(FILE *out, const study *s, const study_case *c, const char *name) {
    const study_quantity *q = study_quantity_find(name);
    long step;
    inference_difference d = inference_compare(study_sample(s, c->name, name), study_reference(s, c, q, 1, &step));
    bool agrees = study_original_agrees(d, 0.99);
    if (isnan(d.value)) {
        fputs(" | –", out);
        return false;
    }
    fprintf(out, " | %+.*f ± %.*f%s", q->digits, d.value, q->digits, inference_width(d, 0.99),
            agrees ? "" : " **differs**");
    return agrees;
}

/* The rule of study_original.h, case by case: those run with the original's links, or without any. */
static void put_original(FILE *out, const study *s) {
    fputs("| case | C(N): points that agree | thickness(N) | cells at stacking, ours − original | area, µm² | the rule "
          "|\n|-|-|-|-|-|-|\n",
          out);
    for (size_t i = 0; i < study_case_count; i++) {
        const study_case *c = &study_cases[i];
        const study_ensemble *e = &s->cases[i];
        bool comparable = c->family == STUDY_ECOLI && c->reference && (c->variant || strcmp(c->name, "default") == 0);
        study_table series;
        if (!comparable || e->n < 3 || study_read_series(s, c, &series, NULL))
            continue;
        const study_table **ours = alloc_zeroed(e->n, sizeof *ours);
        for (size_t k = 0; k < e->n; k++)
            ours[k] = &e->series[k];
        bool holds = true;
        fprintf(out, "| %s", c->title);
        for (int k = 0; k < ORIGINAL_CURVES; k++) {
            study_original_curve curve = study_original_compare(k, ours, e->n, &series);
            fprintf(out, " | %zu of %zu%s", curve.nagree, curve.npoints,
                    curve.agrees         ? ""
                    : curve.npoints < 10 ? " (too few)"
                                         : " **differs**");
            holds = holds && curve.agrees;
        }
        bool cells = put_against(out, s, c, "stack_cells"), area = put_against(out, s, c, "stack_area");
        fprintf(out, " | %s |\n", holds && cells && area ? "holds" : "**does not hold**");
        free(ours);
        study_table_free(&series);
    }
}

static void put_growth(FILE *out, const study *s) {
    fputs("| case | paper's run | ours, mean ± 95 % | 95 % prediction of one run | holds the paper's | growth alone | "
          "holds our mean |\n|-|-|-|-|-|-|-|\n",
          out);
    for (size_t i = 0; i < study_growth_count; i++) {
        const study_growth *g = &study_growths[i];
        inference_sample x = study_sample(s, g->name, "floc_cells");
        if (x.n < 2)
            continue;
        double half = inference_prediction95(x);
        fprintf(out, "| %s | %g | %.1f ± %.1f (n %zu) | %.0f … %.0f | %s | %g ± %g | %s |\n", g->name, g->single,
                x.mean, inference_ci95(x), x.n, x.mean - half, x.mean + half,
                fabs(g->single - x.mean) <= half ? "yes" : "**no**", g->mean, g->half,
                fabs(x.mean - g->mean) <= g->half ? "yes" : "**no**");
    }
}

/* Every quantity of a family, a column a case. */
static void put_quantities(FILE *out, const study *s, study_family family) {
    fputs("| |", out);
    for (size_t i = 0; i < study_case_count; i++)
        if (study_cases[i].family == family && !study_cases[i].variant && s->cases[i].n)
            fprintf(out, " %s |", study_cases[i].title);
    fputs("\n|-|", out);
    for (size_t i = 0; i < study_case_count; i++)
        if (study_cases[i].family == family && !study_cases[i].variant && s->cases[i].n)
            fputs("-|", out);
    fputc('\n', out);
    for (size_t k = 0; k < study_quantity_count; k++) {
        const study_quantity *q = &study_quantities[k];
        if (q->family != family)
            continue;
        fprintf(out, "| %s%s%s |", q->name, *q->unit ? ", " : "", q->unit);
        for (size_t i = 0; i < study_case_count; i++) {
            if (study_cases[i].family != family || study_cases[i].variant || !s->cases[i].n)
                continue;
            fputc(' ', out);
            put_sample(out, study_sample(s, study_cases[i].name, q->name), q, false);
            fputs(" |", out);
        }
        fputc('\n', out);
    }
}

static void put_ecoli(FILE *out, const study *s) {
    put_quantities(out, s, STUDY_ECOLI);
}

static void put_flocs(FILE *out, const study *s) {
    put_quantities(out, s, STUDY_FLOC);
}

static void put_definitions(FILE *out, const study *s) {
    (void)s;
    for (size_t i = 0; i < study_quantity_count; i++)
        fprintf(out, "- `%s`%s%s: %s\n", study_quantities[i].name, *study_quantities[i].unit ? ", in " : "",
                study_quantities[i].unit, study_quantities[i].definition);
}

/* ---- claims ---- */

static void put_claim(FILE *out, size_t row, const study_claim *c, const study_judgement *j) {
    static const char *const sign[] = {[STUDY_MORE] = ">", [STUDY_LESS] = "<", [STUDY_SAME] = "="};
    const study_quantity *q = study_quantity_find(c->quantity);
    fprintf(out, "| %zu | %s | %s | `%s`: %s %s %s", row, c->text, c->where, c->quantity, c->a, sign[c->direction],
            c->b);
    if (c->direction == STUDY_SAME)
        fprintf(out, ", margin %.*f", q->digits, j->margin);
    fputs(" | ", out);
    put_sample(out, j->a, q, false);
    fputs(" | ", out);
    put_sample(out, j->b, q, false);
    fprintf(out, " | %+.*f ± %.*f | %+.2f ± %.2f | ", q->digits, j->difference.value, q->digits,
            inference_width(j->difference, 0.95), j->g, j->g_ci95);
    put_p(out, j->p);
    fputs(" | ", out);
    put_p(out, j->holm);
    fprintf(out, " | %s |\n", j->verdict == VERDICT_REPRODUCED ? "reproduced" : "**not reproduced**");
}

static void put_claims(FILE *out, const study *s) {
    study_judgement *all = study_judge(s);
    size_t run = 0, good = 0;
    for (size_t i = 0; i < study_claim_count; i++) {
        run += all[i].verdict != VERDICT_NOT_RUN;
        good += all[i].verdict == VERDICT_REPRODUCED;
    }
    fprintf(out, "**%zu of %zu claims are reproduced.**\n\n", good, run);
    fputs("| | the paper says | where | measured: a ? b | a | b | a − b | Hedges' g | p | Holm's p | |\n"
          "|-|-|-|-|-|-|-|-|-|-|-|\n",
          out);
    for (size_t i = 0; i < study_claim_count; i++)
        if (all[i].verdict != VERDICT_NOT_RUN)
            put_claim(out, i + 1, &study_claims[i], &all[i]);
    free(all);
}

/* What the original gives for the two cases of a claim: flocs at the last step that three of its runs reached. */
static void put_claim_reference(FILE *out, const study *s, const study_claim *c) {
    const study_quantity *q = study_quantity_find(c->quantity);
    const study_case *a = study_case_find(c->a), *b = study_case_find(c->b);
    long step_a, step_b;
    inference_sample x = study_reference(s, a, q, 3, &step_a), y = study_reference(s, b, q, 3, &step_b);
    if (!x.n || !y.n) {
        fputs("the reference data do not hold it", out);
        return;
    }
    put_sample(out, x, q, false);
    fputs(" against ", out);
    put_sample(out, y, q, false);
    fprintf(out, " (n %zu and %zu", x.n, y.n);
    if (q->family == STUDY_FLOC && step_a == step_b)
        fprintf(out, ", at step %ld", step_a);
    else if (q->family == STUDY_FLOC)
        fprintf(out, ", at steps %ld and %ld", step_a, step_b);
    fputc(')', out);
}

static void put_failed(FILE *out, const study *s) {
    study_judgement *all = study_judge(s);
    fputs("| | claim | found | the original, run again |\n|-|-|-|-|\n", out);
    for (size_t i = 0; i < study_claim_count; i++) {
        if (all[i].verdict == VERDICT_NOT_RUN || all[i].verdict == VERDICT_REPRODUCED)
            continue;
        const study_claim *c = &study_claims[i];
        fprintf(out, "| %zu | %s (`%s`) | %s | ", i + 1, c->text, c->quantity,
                study_verdict_text(all[i].verdict, c->direction));
        put_claim_reference(out, s, c);
        fputs(" |\n", out);
    }
    free(all);
}

/* ---- accuracy ---- */

/* The standard floc at `accuracy paper` beside `balanced`. */
static void put_accuracy(FILE *out, const study *s) {
    fputs("| | paper | balanced | difference | |\n|-|-|-|-|-|\n", out);
    for (size_t i = 0; i < study_quantity_count; i++) {
        const study_quantity *q = &study_quantities[i];
        inference_sample a = study_sample(s, "standard_paper", q->name), b = study_sample(s, "standard", q->name);
        if (q->family != STUDY_FLOC || a.n < 2 || b.n < 2)
            continue;
        inference_difference d = inference_compare(a, b);
        fprintf(out, "| %s%s%s | ", q->name, *q->unit ? ", " : "", q->unit);
        put_sample(out, a, q, true);
        fputs(" | ", out);
        put_sample(out, b, q, true);
        fprintf(out, " | %+.*f ± %.*f | %s |\n", q->digits, d.value, q->digits, inference_width(d, 0.95),
                study_original_agrees(d, 0.95) ? "agree" : "**differ**");
    }
}

/* ---- the text ---- */

typedef struct block {
    const char *name;
    void (*put)(FILE *out, const study *s);
} block;

static const block blocks[] = {
    {"runs", put_runs},         {"stacking", put_stacking},
    {"original", put_original}, {"growth", put_growth},
    {"ecoli", put_ecoli},       {"flocs", put_flocs},
    {"claims", put_claims},     {"failed", put_failed},
    {"accuracy", put_accuracy}, {"definitions", put_definitions},
};

static int fill(const study *s, FILE *in, const char *template, FILE *out, diag *d) {
    char *line = NULL;
    size_t room = 0;
    int status = SARCINA_OK;
    while (!status && getline(&line, &room, in) > 0) {
        if (*line != '@') {
            fputs(line, out);
            continue;
        }
        line[strcspn(line, "\n")] = '\0';
        ptrdiff_t row = table_find(blocks, TABLE_COUNT(blocks), sizeof *blocks, line + 1);
        if (row < 0)
            status = diag_error(d, "%s: no table '%s'", template, line);
        else
            blocks[row].put(out, s);
    }
    free(line);
    return status;
}

int study_report_text(const study *s, const char *template, const char *path, diag *d) {
    FILE *in = fopen(template, "r");
    if (!in)
        return diag_error(d, "no text '%s': %s", template, strerror(errno));
    FILE *out = path_open(path, "w", d);
    int status = out ? fill(s, in, template, out, d) : SARCINA_ERROR;
    fclose(in);
    if (out && path_close(out, path, status ? NULL : d))
        status = SARCINA_ERROR;
    return status;
}
