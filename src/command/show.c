/* SPDX-License-Identifier: GPL-3.0-or-later */
/* show: the colony drawn in the terminal; watch: it, or values, while a run goes on. */
#include "command/commands.h"
#include "command/session.h"
#include "command/watch.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "output/blocks.h"
#include "output/camera.h"
#include "output/field.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { COLOR_AUTO, COLOR_GENERATION, COLOR_SPECIES } color_choice;

enum { LEGEND_MOST = 10, ROWS_MOST = 40 };

/* ---- the picture ------------------------------------------------------------------------------------------------- */

static rgb color_of_cell(const scene *s, uint32_t row, color_choice by) {
    const colony *c = s->colony;
    return color_palette(by == COLOR_SPECIES ? (uint64_t)c->cell.species[row] : (uint64_t)c->cell.generation[row]);
}

/* A capsule for each segment of each cell, in the order of ids; the caller frees. */
static capsule *list_capsules(const scene *s, color_choice by, size_t *n) {
    colony *c = s->colony;
    const uint32_t *order = colony_by_id(c);
    capsule *list = alloc_zeroed(c->particle.count, sizeof *list);
    *n = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
        size_t last = c->cell.nparticles[row] - 1;
        for (size_t p = 0; p == 0 || p < last; p++)
            list[(*n)++] = (capsule){.a = vec3_load(x + 3 * p),
                                     .b = vec3_load(x + 3 * (last ? p + 1 : p)),
                                     .r = 0.5 * c->cell.diameter[row],
                                     .color = color_to_linear(color_of_cell(s, row, by)),
                                     .owner = (uint32_t)i};
    }
    return list;
}

static blocks_style style_of(const interp_terminal *t) {
    if (!t->unicode)
        return BLOCKS_ASCII;
    return t->colors >= 1 << 24 ? BLOCKS_RGB : t->colors >= 256 ? BLOCKS_256 : BLOCKS_PLAIN;
}

/* ---- the lines below it ------------------------------------------------------------------------------------------ */

/* The colours that are there, named: *shown of at most LEGEND_MOST. */
static void put_legend(FILE *f, const scene *s, color_choice by, blocks_style style) {
    uint64_t most = 0;
    const colony *c = s->colony;
    for (size_t i = 0; by == COLOR_GENERATION && i < c->cell.count; i++)
        most = (uint64_t)c->cell.generation[i] > most ? (uint64_t)c->cell.generation[i] : most;
    uint64_t n = by == COLOR_SPECIES ? s->species.count : most + 1;
    if (by == COLOR_GENERATION)
        fputs("generation", f);
    for (uint64_t i = 0; i < n && i < LEGEND_MOST; i++) {
        char mark[48];
        blocks_mark(style, color_palette(i), mark);
        if (by == COLOR_SPECIES)
            fprintf(f, "%s%s %s", i ? "  " : "", mark, s->species.list[i].name);
        else
            fprintf(f, " %s %" PRIu64, mark, i);
    }
    fputs(n > LEGEND_MOST ? " ...\n" : "\n", f);
}

static void put_caption(FILE *f, const scene *s, int from, double scale, blocks_style style, int columns) {
    static const char *const axes[] = {"x to the right, y up", "x to the right, z up", "y to the right, z up"};
    size_t n = s->colony->cell.count;
    char *bar = scale > 0 ? blocks_scale_bar(style, scale, columns / 4) : alloc_copy("");
    fprintf(f, "%s%s%zu %s, step %" PRIu64 "; %s: %s\n", bar, *bar ? "  " : "", n, number_noun(n, "cell", "cells"),
            s->step, camera_views[from].name, axes[from]);
    free(bar);
}

/* Everything, with colours only where the terminal has them; the caller frees. */
static char *draw(interp *in, int from, color_choice by) {
    interp_terminal t = interp_terminal_of(in);
    const scene *s = interp_scene(in);
    if (by == COLOR_AUTO)
        by = s->species.count > 1 ? COLOR_SPECIES : COLOR_GENERATION;
    int room = t.rows - 4;
    const blocks_options o = {.style = style_of(&t),
                              .columns = t.columns > 1 ? t.columns - 1 : 1,
                              .rows = room < 1           ? 1
                                      : room > ROWS_MOST ? ROWS_MOST
                                                         : room,
                              .theta = camera_views[from].theta,
                              .phi = camera_views[from].phi};
    size_t n, size;
    double scale;
    char *all = NULL;
    capsule *list = list_capsules(s, by, &n);
    char *picture = blocks_draw(list, n, &o, &scale);
    FILE *f = open_memstream(&all, &size);
    fputs(picture, f);
    put_caption(f, s, from, scale, o.style, o.columns);
    if (n && o.style >= BLOCKS_256)
        put_legend(f, s, by, o.style);
    fclose(f);
    free(picture);
    free(list);
    all[strlen(all) - 1] = '\0'; /* the last line's end is the printer's */
    return all;
}

static int run_show(interp *in, const args *a, diag *d) {
    (void)d;
    char *text = draw(in, args_choice(a, "view"), (color_choice)args_choice(a, "color"));
    interp_screen(in, "%s", text);
    free(text);
    return SARCINA_OK;
}

/* ---- watch ------------------------------------------------------------------------------------------------------- */

struct watch {
    bool colony;
    output_column *columns;
    size_t n;
};

void watch_free(watch *w) {
    if (!w)
        return;
    for (size_t i = 0; i < w->n; i++) {
        if (w->columns[i].release)
            w->columns[i].release(w->columns[i].self);
        free(w->columns[i].name);
    }
    free(w->columns);
    free(w);
}

static void put_value(FILE *f, const output_column *c) {
    char text[64] = "?", suffix[48];
    double si;
    if (c->is_text)
        c->text(c->self, 0, text, NULL);
    else if (c->number(c->self, 0, &si, NULL) == SARCINA_OK)
        snprintf(text, sizeof text, "%.6g%s", si, isnan(si) ? "" : dim_suffix(c->d, suffix));
    fprintf(f, "%s %s  ", c->name, text);
}

char *watch_text(interp *in, const char *line) {
    const watch *w = session_of(in)->watch;
    char *all = NULL;
    size_t size;
    FILE *f = open_memstream(&all, &size);
    if (w && w->colony) {
        char *picture = draw(in, 0, COLOR_AUTO);
        fprintf(f, "%s\n", picture);
        free(picture);
    }
    for (size_t i = 0; w && i < w->n; i++)
        put_value(f, &w->columns[i]);
    fputs(line, f);
    fclose(f);
    return all;
}

static void set_watch(interp *in, watch *w) {
    session *s = session_of(in);
    watch_free(s->watch);
    s->watch = w;
    if (w && !interp_has_progress(in))
        interp_screen(in, "runs are not shown as they go on: there is no terminal");
}

static int run_watch(interp *in, const args *a, diag *d) {
    watch *w = alloc_zeroed(1, sizeof *w);
    size_t n = args_count(a, "VALUE");
    int status = SARCINA_OK;
    w->columns = alloc_zeroed(n, sizeof *w->columns);
    for (; w->n < n && !status; w->n += !status)
        status = interp_column(in, args_expr_at(a, "VALUE", w->n), false, &w->columns[w->n], d);
    if (status)
        watch_free(w);
    else
        set_watch(in, w);
    return status;
}

static int run_watch_colony(interp *in, const args *a, diag *d) {
    (void)a, (void)d;
    watch *w = alloc_zeroed(1, sizeof *w);
    w->colony = true;
    set_watch(in, w);
    return SARCINA_OK;
}

static int run_watch_off(interp *in, const args *a, diag *d) {
    (void)a, (void)d;
    set_watch(in, NULL);
    return SARCINA_OK;
}

/* ---- records ----------------------------------------------------------------------------------------------------- */

static const param show_params[] = {
    {"view=top:{top|side|front}", "from above; from the side, against y; from the front, against x"},
    {"color=auto:{auto|generation|species}", "auto: species where there are several, else generation"},
};
static const param watch_params[] = {{"VALUE:value...", "values, analyses, formulas of one value"}};

static const command_form forms[] = {
    {"show", show_params, TABLE_COUNT(show_params), "Draws the colony in the terminal",
     "In half blocks, with 24-bit or 256 colours as the terminal has them (COLORTERM, TERM), without colour under "
     "NO_COLOR, TERM=dumb or when printed to a file, in ASCII where the locale is not UTF-8; as wide as the terminal "
     "or "
     "COLUMNS. At a prompt only; pictures in files are 'write_dump image'.",
     "show\nshow view side color species", COMMAND_PROMPT, run_show, NULL, 0},
    {"watch VALUE:value...", watch_params, TABLE_COUNT(watch_params), "Shows values while a run goes on",
     "In the progress line of a terminal, a few times a second. At a prompt only.", "watch thickness max(overlap)",
     COMMAND_PROMPT, run_watch, NULL, 0},
    {"watch colony", NULL, 0, "Shows the colony while a run goes on",
     "The picture of 'show' above the progress line, a few times a second. At a prompt only.", "watch colony",
     COMMAND_PROMPT, run_watch_colony, NULL, 0},
    {"watch off", NULL, 0, "Shows nothing beside a run's progress", "At a prompt only.", "watch off", COMMAND_PROMPT,
     run_watch_off, NULL, 0},
};

void command_show(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
