/* SPDX-License-Identifier: GPL-3.0-or-later */
/* info [TOPIC]: what is in the scene and what acts on it; where the time went. */
#include "command/commands.h"
#include "command/info_lists.h"
#include "command/style_values.h"

#include "base/table.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "mechanics/force_style.h"
#include "relax/integrator.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static size_t cells_of(const scene *s, size_t row) {
    size_t n = 0;
    for (size_t i = 0; i < s->colony->cell.count; i++)
        n += (size_t)s->colony->cell.species[i] == row;
    return n;
}

static const char *const shape_names[] = {
    [SHAPE_COCCUS] = "coccus", [SHAPE_ROD] = "rod", [SHAPE_FLEXIBLE] = "flexible"};

static void show_species(interp *in, const scene *s, info_put put) {
    for (size_t i = 0; i < s->species.count; i++) {
        const species *sp = &s->species.list[i];
        put(in, "species     %s: %s, %zu cells, growth %s, division %s", sp->name, shape_names[sp->shape],
            cells_of(s, i), sp->growth.style < 0 ? "off" : growth_styles[sp->growth.style].name,
            sp->division.style < 0 ? "off" : division_styles[sp->division.style]->name);
    }
}

/* "k 1e-10 reach 1.01": the parameters of a term in SI, choices by name. */
static void write_parameters(const force_style *style, const double *p, char *out, size_t room) {
    size_t used = 0;
    out[0] = '\0';
    for (size_t i = 0; i < style->nparams && used < room; i++) {
        char name[64], kind[64];
        style_values_name(&style->params[i], name);
        const char *colon = strchr(style->params[i].spec, ':') + 1;
        snprintf(kind, sizeof kind, "%.*s", (int)strcspn(colon, "[(~%!{"), colon);
        dim d = DIM_NONE;
        if (kind[0] == '\0') { /* a choice: its row counts */
            const char *word = colon + 1;
            for (int k = 0; k < (int)p[i]; k++)
                word = strchr(word, '|') + 1;
            used += (size_t)snprintf(out + used, room - used, " %s %.*s", name, (int)strcspn(word, "|}"), word);
            continue;
        }
        dim_by_name(kind, &d);
        char suffix[48];
        used += (size_t)snprintf(out + used, room - used, " %s %g%s", name, dim_from_engine(p[i], d),
                                 dim_suffix(d, suffix));
    }
}

static bool is_active(const scene *s, int term) {
    if (term == FORCE_SPRINGS)
        return s->colony->spring.count > 0;
    if (term != FORCE_INTERNAL)
        return s->forces.term[term].on;
    for (size_t i = 0; i < s->species.count; i++)
        if (s->species.list[i].internal_k > 0 && cells_of(s, i) > 0)
            return true;
    return false;
}

static void show_forces(interp *in, const scene *s, info_put put) {
    char idle[256] = "";
    for (int i = 0; i < FORCE_COUNT; i++) {
        const force_style *style = force_styles[i];
        if (!is_active(s, i)) {
            strncat(idle, " ", sizeof idle - strlen(idle) - 1);
            strncat(idle, style->name, sizeof idle - strlen(idle) - 1);
            continue;
        }
        char parameters[256];
        write_parameters(style, s->forces.term[i].p, parameters, sizeof parameters);
        put(in, "force       %s%s", style->name, parameters);
    }
    put(in, "not active %s", idle[0] ? idle : " none");
}

/* Field by field: padding between them need not agree. */
static bool is_preset(const relax_settings *r, const accuracy_preset *preset) {
    const relax_settings *p = &preset->settings;
    return r->integrator == p->integrator && r->step == p->step && r->tolerance == p->tolerance &&
           r->segment == p->segment && r->most == p->most;
}

static void show_relaxation(interp *in, const scene *s, info_put put) {
    const relax_settings *r = &s->relax;
    bool preset = is_preset(r, &accuracy_presets[s->accuracy]);
    put(in, "relaxation  %s%s%s", integrator_styles[r->integrator]->name, preset ? ", accuracy " : "",
        preset ? accuracy_presets[s->accuracy].name : "");
    mechanics_stats m = mechanics_statistics(s->mechanics);
    put(in, "neighbours  %zu entries, skin %.3g um, method %s, kernel %s", m.pairs, m.skin,
        s->neighbor.method == NEIGHBOR_CELLS ? "cells" : "pairs", m.kernel ? m.kernel : "none");
    put(in, "memory      %.3g MB of state, %.3g MB of mechanics", 1e-6 * (double)colony_bytes(s->colony),
        1e-6 * (double)m.bytes);
}

void info_show_scene(interp *in, info_put put) {
    scene *s = interp_scene(in);
    diag problem = {0};
    int status = scene_prepare(s, &problem);
    put(in, "scene       %zu cells of %zu particles, %zu links, step %" PRIu64 ", time %g s, relaxed %g s",
        s->colony->cell.count, s->colony->particle.count, s->colony->link.count, s->step, s->time, s->relaxed);
    show_species(in, s, put);
    show_forces(in, s, put);
    show_relaxation(in, s, put);
    put(in, "seed        %" PRIu64 ", %d thread%s", rng_get_seed(s->rng), s->threads, s->threads == 1 ? "" : "s");
    if (status)
        put(in, "cannot run  %s", problem.message);
}

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
        info_show_scene(in, interp_print);
        return SARCINA_OK;
    }
    if (strcmp(topic, "timing") == 0) {
        show_timing(in);
        return SARCINA_OK;
    }
    if (strcmp(topic, "species") == 0) {
        show_species(in, interp_scene(in), interp_print);
        return SARCINA_OK;
    }
    if (strcmp(topic, "forces") == 0) {
        show_forces(in, interp_scene(in), interp_print);
        return SARCINA_OK;
    }
    if (info_lists_show(in, topic))
        return SARCINA_OK;
    diag_error(d, "no information on '%s'", topic);
    diag_help(d, "topics: scene, species, forces, timing, %s", info_lists_topics());
    diag_place(d, args_span(a, "TOPIC"));
    return SARCINA_ERROR;
}

static const param params[] = {
    {"TOPIC:word?",
     "scene (without it): what is there and what acts; timing: where time went; or species, forces, groups, regions, "
     "variables, dumps, analyses"}};

static const command_form forms[] = {
    {"info TOPIC:word?", params, 1, "What is in the scene, or where the time went", NULL, "info scene\ninfo groups", 0,
     run_info, NULL, 0},
};

void command_info(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
