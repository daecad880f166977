/* SPDX-License-Identifier: GPL-3.0-or-later */
/* info [TOPIC]: what is in the scene and what acts on it; where the time went. */
#include "command/commands.h"
#include "command/info_lists.h"
#include "command/info_scene.h"

#include "base/table.h"

#include <inttypes.h>
#include <string.h>

static void show_timing(interp *in) {
    const scene *s = interp_scene(in);
    const scene_timing *t = &s->timing;
    const scene_tally *n = &s->tally;
    const struct {
        const char *stage;
        double seconds;
    } rows[] = {{"grow", t->grow},       {"divide", t->divide},
                {"forces", t->force},    {"neighbours", t->build},
                {"remodel", t->remodel}, {"integrate", t->relax - t->force - t->build - t->remodel},
                {"output", t->output}};
    double sum = 0;
    for (size_t i = 0; i < TABLE_COUNT(rows); i++)
        sum += rows[i].seconds;
    interp_print(in, "%-12s %10s %6s", "stage", "seconds", "%");
    for (size_t i = 0; i < TABLE_COUNT(rows); i++)
        interp_print(in, "%-12s %10.4f %6.1f", rows[i].stage, rows[i].seconds,
                     sum > 0 ? 100 * rows[i].seconds / sum : 0);
    interp_print(in, "%" PRIu64 " force evaluations, %" PRIu64 " neighbour lists", n->evaluations, n->builds);
    if (n->cell_evaluations)
        interp_print(in, "%.1f ns a cell and force evaluation", 1e9 * t->force / (double)n->cell_evaluations);
}

static int run_info(interp *in, const args *a, diag *d) {
    const char *topic = args_text(a, "TOPIC");
    if (!topic || strcmp(topic, "scene") == 0) {
        info_scene_show(in, interp_print);
        return SARCINA_OK;
    }
    if (strcmp(topic, "timing") == 0) {
        show_timing(in);
        return SARCINA_OK;
    }
    if (strcmp(topic, "species") == 0) {
        info_scene_species(in, interp_print);
        return SARCINA_OK;
    }
    if (strcmp(topic, "forces") == 0) {
        info_scene_forces(in, interp_print);
        return SARCINA_OK;
    }
    if (info_lists_show(in, topic))
        return SARCINA_OK;
    diag_error(d, "no information on '%s'", topic);
    diag_help(d, "topics: scene, species, forces, timing, %s", info_lists_topics());
    diag_place(d, args_span(a, "TOPIC"));
    return SARCINA_ERROR;
}

static const param params[] = {{"TOPIC:word?", "scene (without it): what is there, what acts, by which means, and what "
                                               "it costs in memory and time; timing: where "
                                               "time went; or species, forces, groups, regions, "
                                               "variables, dumps, analyses"}};

static const command_form forms[] = {
    {"info TOPIC:word?", params, 1, "What is in the scene and what it costs",
     "Only what acts is listed as active: terms that a script names, and those that are on by what the scene holds. "
     "Times are measured while colonies relax, those of single terms at every 64th evaluation; before that they are "
     "'not measured yet'.",
     "info scene\ninfo groups", 0, run_info, NULL, 0},
};

void command_info(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
