/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/image_color.h"

#include "base/alloc.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Values that tell cells apart but have no amount. */
static bool is_label(const char *name) {
    static const char *const labels[] = {"generation", "founder", "parent", "id", "cluster"};
    for (size_t i = 0; i < sizeof labels / sizeof *labels; i++)
        if (strcmp(name, labels[i]) == 0)
            return true;
    return false;
}

static rgb species_color(const dump_frame *f, uint32_t row) {
    int32_t kind = f->view->colony->cell.species[row];
    rgb c;
    if (!color_parse(f->view->species->list[kind].color, &c))
        c = color_palette((uint64_t)kind);
    return c;
}

static void add_name(image_key *key, const char *name, rgb color) {
    for (size_t i = 0; i < key->names; i++)
        if (strcmp(key->name[i], name) == 0)
            return;
    if (key->names == KEY_NAMES_MAX)
        return;
    snprintf(key->name[key->names], sizeof key->name[0], "%.63s", name);
    key->color[key->names++] = color;
    key->kind = KEY_NAMES;
}

/* Texts take the palette's colours in the order of the alphabet. */
static int color_by_text(const dump_frame *f, const uint32_t *rows, size_t n, rgb *out, image_key *key, diag *d) {
    char(*texts)[64] = alloc_zeroed(n, sizeof *texts), (*distinct)[64] = alloc_zeroed(n, sizeof *distinct);
    size_t count = 0;
    int status = SARCINA_OK;
    for (size_t i = 0; i < n && !status; i++) {
        status = f->columns[0].text(f->columns[0].self, rows[i], texts[i], d);
        size_t at = 0;
        while (at < count && strcmp(distinct[at], texts[i]) < 0)
            at++;
        if (at < count && strcmp(distinct[at], texts[i]) == 0)
            continue;
        memmove(distinct[at + 1], distinct[at], (count++ - at) * sizeof *distinct);
        memcpy(distinct[at], texts[i], sizeof *distinct);
    }
    for (size_t i = 0; i < n && !status; i++) {
        size_t at = 0;
        while (strcmp(distinct[at], texts[i]) != 0)
            at++;
        out[i] = color_palette(at);
    }
    for (size_t i = 0; i < count && !status; i++)
        add_name(key, distinct[i], color_palette(i));
    free(texts);
    free(distinct);
    return status;
}

static int color_by_number(const dump_frame *f, const image_options *o, const uint32_t *rows, size_t n, rgb *out,
                           image_key *key, diag *d) {
    const output_column *column = &f->columns[0];
    double *x = alloc_zeroed(n, sizeof *x), low = INFINITY, high = -INFINITY;
    int status = SARCINA_OK;
    for (size_t i = 0; i < n && !status; i++) {
        status = column->number(column->self, rows[i], &x[i], d);
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    bool labels = is_label(column->name) && isnan(o->low);
    low = isnan(o->low) ? low : o->low;
    high = isnan(o->high) ? high : o->high;
    for (size_t i = 0; i < n && !status; i++) {
        double t = high > low ? (x[i] - low) / (high - low) : isnan(x[i]) ? (double)NAN : 0.5;
        out[i] = labels && x[i] >= 0 ? color_palette((uint64_t)x[i]) : color_of(&color_maps[o->map], t);
    }
    free(x);
    if (!labels && high >= low) {
        key->kind = KEY_MAP;
        key->d = column->d;
        key->low = low;
        key->high = high;
        key->map = o->map;
    }
    return status;
}

/* In the order of the species table, those that are there. */
static void name_species(const dump_frame *f, const uint32_t *rows, size_t n, image_key *key) {
    for (size_t k = 0; k < f->view->species->count; k++)
        for (size_t i = 0; i < n; i++)
            if ((size_t)f->view->colony->cell.species[rows[i]] == k) {
                add_name(key, f->view->species->list[k].name, species_color(f, rows[i]));
                break;
            }
}

int image_color_cells(const dump_frame *f, const image_options *o, const uint32_t *rows, size_t n, rgb *out,
                      image_key *key, diag *d) {
    bool by_species = !o->has_color && f->columns[0].is_text && strcmp(f->columns[0].name, "species") == 0;
    *key = (image_key){.title = o->has_color ? "" : f->columns[0].name};
    if (!o->has_color && !by_species)
        return f->columns[0].is_text ? color_by_text(f, rows, n, out, key, d)
                                     : color_by_number(f, o, rows, n, out, key, d);
    for (size_t i = 0; i < n; i++)
        out[i] = by_species ? species_color(f, rows[i]) : o->color;
    if (by_species)
        name_species(f, rows, n, key);
    return SARCINA_OK;
}
