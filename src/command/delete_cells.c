/* SPDX-License-Identifier: GPL-3.0-or-later */
/* delete_cells GROUP [where TEST] [probability P | fraction P]. */
#include "command/commands.h"
#include "command/forecast.h"

#include "command/session.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

typedef struct lot {
    double drawn;
    uint64_t id;
    uint32_t row;
} lot;

static int compare_lots(const void *a, const void *b) {
    const lot *p = a, *q = b;
    if (p->drawn != q->drawn)
        return p->drawn < q->drawn ? -1 : 1;
    return (p->id > q->id) - (p->id < q->id);
}

/* Keeps flagged: each with the probability, or the given fraction of them, whose lots are the lowest. */
static void draw_lots(scene *s, bool *flags, double probability, double fraction) {
    size_t n = s->colony->cell.count, candidates = 0;
    lot *lots = alloc_zeroed(n, sizeof *lots);
    for (uint32_t i = 0; i < n; i++) {
        if (!flags[i])
            continue;
        uint64_t id = s->colony->cell.id[i];
        double drawn = gsl_rng_uniform(rng_stream(s->rng, RNG_DELETE, id, s->deletions));
        flags[i] = drawn < probability;
        lots[candidates++] = (lot){drawn, id, i};
    }
    if (fraction < 1) {
        qsort(lots, candidates, sizeof *lots, compare_lots);
        for (size_t i = (size_t)llround(fraction * (double)candidates); i < candidates; i++)
            flags[lots[i].row] = false;
    }
    free(lots);
    s->deletions++;
}

static int run_delete(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    size_t n = s->colony->cell.count;
    if (args_given(a, "probability") && args_given(a, "fraction"))
        return diag_error(d, "probability or fraction, not both");
    if (interp_checking(in)) {
        forecast_unknown(in, "that cells are deleted");
        return SARCINA_OK;
    }
    bool *flags = alloc_zeroed(n, sizeof *flags), *where = alloc_zeroed(n, sizeof *where);
    int status = session_members(in, args_row(a, "GROUP"), flags, d);
    if (!status && args_given(a, "where"))
        status = interp_flags(in, args_expr(a, "where"), where, d);
    if (!status) {
        size_t deleted = 0;
        for (size_t i = 0; i < n && args_given(a, "where"); i++)
            flags[i] = flags[i] && where[i];
        if (args_given(a, "probability") || args_given(a, "fraction"))
            draw_lots(s, flags, args_number(a, "probability"), args_number(a, "fraction"));
        for (size_t i = 0; i < n; i++)
            deleted += flags[i];
        scene_delete(s, flags);
        interp_print(in, "deleted %zu of %zu %s: %zu left", deleted, n, number_noun(n, "cell", "cells"),
                     s->colony->cell.count);
    }
    free(flags);
    free(where);
    return status;
}

static const param params[] = {
    {"GROUP:group", "of these: all, a species, a region, a group"},
    {"where:cellexpr", "only those for which this holds"},
    {"probability=1:fraction%[0,1]", "each with this probability"},
    {"fraction=1:fraction%[0,1]", "this part of them, to the nearest whole number"},
};

static const command_form forms[] = {
    {"delete_cells GROUP:group", params, TABLE_COUNT(params), "Takes cells out, with their links", NULL,
     "delete_cells cf where z > 1um probability 90%\ndelete_cells all fraction 50%", COMMAND_SHADOW, run_delete, NULL,
     0},
};

void command_delete_cells(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
