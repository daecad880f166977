/* SPDX-License-Identifier: GPL-3.0-or-later */
/* study: the case studies of Storck et al. (2014) beside the paper, for scripts/reproduce.
 *
 *     study -plan
 *         the ensembles to run: name, script below examples, options, most seeds (0: any), parted by tabs
 *     study -report RUNS SEEDS DATA TEMPLATE RESULTS
 *         from the runs in folder RUNS and the original's data in DATA: RESULTS/RESULTS.md (TEMPLATE filled in),
 *         RESULTS/RESULTS.csv and RESULTS/results/ with the figures; without gnuplot only their data
 *     study -laws-plan
 *         the ensembles of the study of laws: cells, name, script, options, seeds
 *     study -laws RUNS RESULTS
 *         from their runs: RESULTS/laws.txt and RESULTS/laws.csv (scripts/laws) */
#include "app/study_cases.h"
#include "app/study_figure.h"
#include "app/study_laws.h"
#include "app/study_report.h"

#include "base/alloc.h"
#include "base/process.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int put_plan(void) {
    for (size_t i = 0; i < study_case_count; i++) {
        const study_case *c = &study_cases[i];
        printf("%s\t%s\t%s%s%s\t%zu\n", c->name, c->script, study_options, *c->options ? " " : "", c->options,
               c->seeds);
    }
    return SARCINA_OK;
}

static int write_all(const study *s, const char *template, const char *results, diag *d) {
    char *text = alloc_format("%s/RESULTS.md", results), *table = alloc_format("%s/RESULTS.csv", results);
    char *figures = alloc_format("%s/results", results);
    bool gnuplot = process_check("gnuplot", "gnuplot-nox", NULL) == SARCINA_OK;
    if (!gnuplot)
        fputs("no gnuplot (apt-get install gnuplot-nox): the curves' data are written, but not drawn\n", stderr);
    int status = study_report_csv(s, table, d);
    if (!status)
        status = study_report_text(s, template, text, d);
    if (!status)
        status = study_figure_all(s, figures, gnuplot, d);
    free(text);
    free(table);
    free(figures);
    return status;
}

static size_t count_runs(const study *s) {
    size_t n = 0;
    for (size_t i = 0; i < study_case_count; i++)
        n += s->cases[i].n;
    return n;
}

static int report_laws(const char *runs, const char *results) {
    diag d = {0};
    int status = study_laws_report(runs, results, &d);
    if (status)
        fprintf(stderr, "study: %s\n", d.message);
    return status;
}

int main(int argc, char **argv) {
    gsl_set_error_handler_off();
    if (argc == 2 && strcmp(argv[1], "-laws-plan") == 0) {
        study_laws_plan();
        return SARCINA_OK;
    }
    if (argc == 4 && strcmp(argv[1], "-laws") == 0)
        return report_laws(argv[2], argv[3]);
    if (argc == 2 && strcmp(argv[1], "-plan") == 0)
        return put_plan();
    if (argc != 7 || strcmp(argv[1], "-report") != 0) {
        fputs(
            "usage: study -plan | study -report RUNS SEEDS DATA TEMPLATE RESULTS | study -laws-plan | study -laws RUNS "
            "RESULTS\n",
            stderr);
        return SARCINA_USAGE;
    }
    study s;
    diag d = {0};
    int status = study_open(&s, argv[2], argv[4], strtol(argv[3], NULL, 10), &d);
    if (!status && count_runs(&s) == 0)
        status = diag_error(&d, "no run of the study is done in '%s'", argv[2]);
    if (!status)
        status = write_all(&s, argv[5], argv[6], &d);
    if (!status)
        printf("report of %zu runs\n", count_runs(&s));
    if (status)
        fprintf(stderr, "study: %s\n%s%s", d.message, d.help, *d.help ? "\n" : "");
    study_close(&s);
    return status;
}
