/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_figure.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/process.h"
#include "base/table.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Fig. 3 ---- */

/* A panel a case; those with links run with the original's rules. */
static const struct {
    const char *title, *name;
} panels[] = {{"default", "default"}, {"anchored", "anchored_published"}, {"filial", "filial_published"}};

/* A curve of our tables and of the original's series. */
static const struct {
    const char *name, *mean, *ci95;
    double scale;
} curves[] = {{"C", "C_mean", "C_ci95", 1}, {"thickness", "max_z_um_mean", "max_z_um_ci95", 1e6}};

static void put_point(FILE *out, double x, inference_sample ours, inference_sample theirs) {
    fprintf(out, "%.6g %.6g %.6g %.6g %.6g\n", x, ours.mean, inference_ci95(ours), theirs.mean, inference_ci95(theirs));
}

/* Steps on which all replicates have a value; hours, ours, its interval, the original's, its interval. */
static void put_time_curve(FILE *out, const study_ensemble *e, const study_table *series, size_t curve) {
    double *x = alloc_zeroed(e->n, sizeof *x);
    for (size_t row = 1; row < e->series[0].nrows; row++) {
        for (size_t i = 0; i < e->n; i++)
            x[i] = curves[curve].scale * study_table_number(&e->series[i], row, curves[curve].name);
        inference_sample ours = inference_sample_of(x, e->n);
        if (ours.n < 2)
            continue;
        inference_sample theirs =
            inference_sample_behind(study_table_number(series, row, curves[curve].mean),
                                    study_table_number(series, row, curves[curve].ci95), ORIGINAL_SEEDS);
        put_point(out, study_table_number(&e->series[0], row, "time") / 3600, ours, theirs);
    }
    free(x);
}

static void put_cells_curve(FILE *out, const study_ensemble *e, const study_table *series, size_t curve) {
    const study_table **ours = alloc_zeroed(e->n, sizeof *ours);
    for (size_t i = 0; i < e->n; i++)
        ours[i] = &e->series[i];
    study_original_curve c = study_original_compare((int)curve, ours, e->n, series);
    for (size_t i = 0; i < c.npoints; i++)
        put_point(out, c.points[i].cells, c.points[i].ours, c.points[i].theirs);
    free(ours);
}

typedef void put_curve(FILE *out, const study_ensemble *e, const study_table *series, size_t curve);

/* Blocks for gnuplot's index: the panels' C, then their thickness. An empty block holds one point of no place. */
static int write_curves(const study *s, const char *folder, const char *name, const char *axis, put_curve *put,
                        diag *d) {
    char *path = alloc_format("%s/%s", folder, name);
    FILE *out = path_open(path, "w", d);
    int status = out ? SARCINA_OK : SARCINA_ERROR;
    for (size_t curve = 0; curve < TABLE_COUNT(curves) && out; curve++)
        for (size_t i = 0; i < TABLE_COUNT(panels); i++) {
            const study_ensemble *e = study_find(s, panels[i].name);
            study_table series;
            fprintf(out, "# %s, %s: %s, ours, ci95, original, ci95\nnan nan nan nan nan\n", panels[i].title,
                    curves[curve].name, axis);
            if (e && !study_read_series(s, study_case_find(panels[i].name), &series, NULL)) {
                put(out, e, &series, curve);
                study_table_free(&series);
            }
            fputs("\n\n", out);
        }
    if (out)
        status = path_close(out, path, d);
    free(path);
    return status;
}

/* ---- claims ---- */

static int write_claims(const study *s, const char *folder, diag *d) {
    char *path = alloc_format("%s/claims.dat", folder);
    FILE *out = path_open(path, "w", d);
    int status = out ? SARCINA_OK : SARCINA_ERROR;
    if (out) {
        study_judgement *all = study_judge(s);
        fputs("# row, Hedges' g (positive: as claimed), ci95, reproduced, claim\n", out);
        for (size_t i = 0; i < study_claim_count; i++) {
            const study_claim *c = &study_claims[i];
            if (all[i].verdict != VERDICT_NOT_RUN)
                fprintf(out, "%zu %.4g %.4g %d \"%zu %s: %s %s %s\"\n", i + 1,
                        c->direction == STUDY_LESS ? -all[i].g : all[i].g, all[i].g_ci95,
                        all[i].verdict == VERDICT_REPRODUCED, i + 1, c->quantity, c->a,
                        c->direction == STUDY_MORE   ? ">"
                        : c->direction == STUDY_LESS ? "<"
                                                     : "=",
                        c->b);
        }
        free(all);
        status = path_close(out, path, d);
    }
    free(path);
    return status;
}

/* ---- gnuplot ---- */

static const char style[] = "set border 3 lw 0.8\nset tics nomirror out scale 0.6\n"
                            "set style fill transparent solid 0.3 noborder\n";

/* Two rows of three panels. */
static void put_curves_plot(FILE *out, const char *name, const char *axis, const char *setup) {
    fprintf(out, "set terminal pngcairo noenhanced size 1080,620 font ',10'\nset output '%s.png'\n%s", name, setup);
    fputs("set multiplot layout 2,3\n", out);
    for (size_t curve = 0; curve < TABLE_COUNT(curves); curve++)
        for (size_t i = 0; i < TABLE_COUNT(panels); i++) {
            size_t block = curve * TABLE_COUNT(panels) + i;
            fprintf(out, "set title '%s'\nset xlabel '%s'\nset ylabel '%s'\nset yrange %s\nset key %s\n",
                    panels[i].title, axis, curve ? "thickness (µm)" : "orientation correlation C",
                    curve ? "[0:7]" : "[0.2:1.02]", curve ? "left top" : "left bottom");
            fprintf(out,
                    "plot '%s.dat' index %zu using 1:($4-$5):($4+$5) with filledcurves lc rgb '#777777' notitle, "
                    "'' index %zu using 1:4 with lines lw 2 dt 2 lc rgb '#444444' title 'original (10 seeds)', "
                    "'' index %zu using 1:($2-$3):($2+$3) with filledcurves lc rgb '#1f77b4' notitle, "
                    "'' index %zu using 1:2 with lines lw 2 lc rgb '#1f77b4' title 'ours'\n",
                    name, block, block, block, block);
        }
    fputs("unset multiplot\nunset output\nreset\n", out);
    fputs(style, out);
}

static void put_claims_plot(FILE *out) {
    fputs("set terminal pngcairo noenhanced size 900,640 font ',9'\nset output 'claims.png'\n"
          "set yrange [] reverse\nset xzeroaxis\nset arrow from 0, graph 0 to 0, graph 1 nohead lc rgb '#999999'\n"
          "set xlabel \"Hedges' g, 95 % interval; positive: as claimed (of claims with =: a - b)\"\nset key outside "
          "top center horizontal\nset grid x lc "
          "rgb '#dddddd'\n"
          "set offsets 0,0,1,1\n"
          "plot 'claims.dat' using ($4 > 0 ? $2 : NaN):1:3:ytic(5) with xerrorbars pt 7 lc rgb '#1f77b4' title "
          "'reproduced', '' using ($4 > 0 ? NaN : $2):1:3:ytic(5) with xerrorbars pt 6 lc rgb '#d62728' title 'not "
          "reproduced'\nunset output\n",
          out);
}

static int plot(const char *folder, diag *d) {
    if (process_check("gnuplot", "gnuplot-nox", d))
        return d->status;
    const char *const words[] = {"gnuplot", "-", NULL};
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    fprintf(out, "cd '%s'\n%s", folder, style);
    put_curves_plot(out, "fig3_time", "time (h)", "set xrange [0:4.7]\n");
    put_curves_plot(out, "fig3_cells", "cells", "set logscale x\nset xrange [10:400]\n");
    put_claims_plot(out);
    fclose(out);
    int status = process_run(words, text, length, d);
    free(text);
    return status;
}

/* ---- pictures ---- */

/* Picture of seed 1 of a case, and what it is called here. */
static const struct {
    const char *name, *picture, *copy;
} pictures[] = {
    {"default", "ecoli.out/end.png", "fig2a_default.png"},
    {"default", "ecoli.out/side.png", "fig2a_default_side.png"},
    {"anchored", "ecoli.out/end.png", "fig2b_anchored.png"},
    {"anchored", "ecoli.out/side.png", "fig2b_anchored_side.png"},
    {"filial", "ecoli.out/end.png", "fig2c_filial.png"},
    {"filial", "ecoli.out/side.png", "fig2c_filial_side.png"},
    {"standard", "floc.out/floc.0.png", "fig4a_initial.png"},
    {"standard", "floc.out/end.png", "fig4b_standard.png"},
    {"high_oxygen", "floc.out/end.png", "fig4c_high_oxygen.png"},
    {"stiff", "floc.out/end.png", "fig4d_stiff.png"},
    {"flexible", "floc.out/end.png", "fig4e_flexible.png"},
    {"strong_sticking", "floc.out/end.png", "fig4f_strong_sticking.png"},
    {"weak_sticking", "floc.out/end.png", "fig4g_weak_sticking.png"},
    {"branching", "floc.out/end.png", "fig5b_branching.png"},
    {"unbranched", "floc.out/end.png", "fig5c_unbranched.png"},
    {"spherical", "floc.out/floc.0.png", "fig5d_initial_spheres.png"},
    {"spherical", "floc.out/end.png", "fig5e_spherical.png"},
};

/* A build without pictures leaves none: that is no error. */
static int copy_picture(const char *from, const char *to, diag *d) {
    FILE *in = fopen(from, "rb");
    if (!in)
        return SARCINA_OK;
    FILE *out = path_open(to, "wb", d);
    int status = out ? SARCINA_OK : SARCINA_ERROR;
    char bytes[1 << 14];
    for (size_t n; out && (n = fread(bytes, 1, sizeof bytes, in)) > 0;)
        fwrite(bytes, 1, n, out);
    fclose(in);
    if (out)
        status = path_close(out, to, d);
    return status;
}

static int copy_pictures(const study *s, const char *folder, diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < TABLE_COUNT(pictures) && !status; i++) {
        char *run = study_run_folder(s, study_case_find(pictures[i].name), 1);
        char *from = alloc_format("%s/%s", run, pictures[i].picture);
        char *to = alloc_format("%s/%s", folder, pictures[i].copy);
        status = copy_picture(from, to, d);
        free(run);
        free(from);
        free(to);
    }
    return status;
}

int study_figure_all(const study *s, const char *folder, bool gnuplot, diag *d) {
    int status = write_curves(s, folder, "fig3_time.dat", "hours", put_time_curve, d);
    if (!status)
        status = write_curves(s, folder, "fig3_cells.dat", "cells", put_cells_curve, d);
    if (!status)
        status = write_claims(s, folder, d);
    if (!status)
        status = copy_pictures(s, folder, d);
    return status || !gnuplot ? status : plot(folder, d);
}
