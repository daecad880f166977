/* SPDX-License-Identifier: GPL-3.0-or-later */
/* units, seed, accuracy, integrator, neighbor, threads, warn. */
#include "command/commands.h"
#include "relax/integrator.h"

#include "base/alloc.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int refuse_after_cells(interp *in, const char *what, diag *d) {
    if (interp_scene(in)->colony->cell.count == 0)
        return SARCINA_OK;
    diag_error(d, "%s cannot change once there are cells", what);
    return diag_help(d, "write it before the first create_cells, or 'clear' first");
}

static int run_units(interp *in, const args *a, diag *d) {
    int status = refuse_after_cells(in, "units", d);
    if (!status)
        interp_set_units(in, (unit_system)args_choice(a, "UNITS"));
    return status;
}

static int run_seed(interp *in, const args *a, diag *d) {
    int status = refuse_after_cells(in, "seed", d);
    if (status)
        return status;
    interp_restart_random(in);
    rng_seed(interp_scene(in)->rng, (uint64_t)args_int(a, "N"));
    return SARCINA_OK;
}

static int run_accuracy(interp *in, const args *a, diag *d) {
    (void)d;
    scene *s = interp_scene(in);
    s->accuracy = args_choice(a, "PRESET");
    s->relax = accuracy_presets[s->accuracy].settings;
    return SARCINA_OK;
}

static int run_integrator(interp *in, const args *a, diag *d) {
    const char *wrong = NULL;
    relax_settings how = {.integrator = (integrator_kind)args_choice(a, "STYLE")};
    if (args_given(a, "step"))
        how.step = args_number(a, "step");
    if (args_given(a, "tol"))
        how.tolerance = args_number(a, "tol");
    if (args_given(a, "inertia"))
        how.inertia = args_number(a, "inertia");
    int status = integrator_check(&how, &wrong, d);
    if (status)
        diag_place(d, args_span(a, wrong));
    else
        interp_scene(in)->relax = how;
    return status;
}

static int run_neighbor(interp *in, const args *a, diag *d) {
    (void)d;
    neighbor_settings *n = &interp_scene(in)->neighbor;
    if (args_given(a, "skin"))
        n->skin = args_number(a, "skin");
    if (args_given(a, "method"))
        n->method = (neighbor_method)args_choice(a, "method");
    return SARCINA_OK;
}

static int run_threads(interp *in, const args *a, diag *d) {
    (void)d;
    interp_scene(in)->threads = (int)args_int(a, "N");
    return SARCINA_OK;
}

static int run_warn(interp *in, const args *a, diag *d) {
    (void)d;
    interp_set_warn(in, (warn_mode)args_choice(a, "HOW"));
    return SARCINA_OK;
}

static const param units_params[] = {{"UNITS:{si|bio}", "si: SI; bio: um, pg, s"}};
static const param seed_params[] = {{"N:int[0,)", "of every random number; the same seed gives the same bits"}};
static const param threads_params[] = {{"N:int[1,1024]", "how many; the results are the same for any number"}};
static const param warn_params[] = {{"HOW:{on|off|error}", "shown, dropped, or treated as errors"}};
static const param neighbor_params[] = {
    {"skin=auto:length[0,)", "how much farther than touching neighbours are listed"},
    {"method=cells:{cells|pairs}", "cell grid with lists, or all pairs (slow, a check of the former)"},
};
static const param accuracy_params[] = {{"PRESET:word", "method and step of the relaxation; never physics"}};
static const param integrator_params[] = {
    {"STYLE:word", "the method"},
    {"step=auto:time(0,)", "its step; without it, from the stiffness of the scene or by error control"},
    {"tol=auto:number(0,1)", "error a step in um and um/s, for those with error control"},
    {"inertia=0:number[0,1)", "verlet, euler without step: masses grow to this part of t k_d, t the time relaxed"},
};

static const command_form forms[] = {
    {"units UNITS:{si|bio}", units_params, TABLE_COUNT(units_params), "Units of bare numbers",
     "A number with a unit (0.75um, 4min) means the same under both. Default: si.",
     "clear\nunits si\nunits bio\nspecies e rod diameter 0.75", COMMAND_DECLARES, run_units, NULL, 0},
    {"seed N:int[0,)", seed_params, TABLE_COUNT(seed_params), "Seed of all random numbers", "Default: 1.",
     "clear\nseed 7", COMMAND_DECLARES, run_seed, NULL, 0},
    {"neighbor", neighbor_params, TABLE_COUNT(neighbor_params), "How neighbours are found",
     "Results do not depend on it, speed does.", "neighbor skin 0.3um method cells", COMMAND_DECLARES, run_neighbor,
     NULL, 0},
    {"threads N:int[1,1024]", threads_params, TABLE_COUNT(threads_params), "Processor cores to compute on",
     "Pays from some thousand cells.", "threads 2", COMMAND_SHADOW, run_threads, NULL, 0},
    {"warn HOW:{on|off|error}", warn_params, TABLE_COUNT(warn_params), "What happens to warnings",
     "A warning that is an error ends the script behind the command that gave it: what that has done is done.",
     "warn error\nwarn off\nwarn on", COMMAND_SHADOW, run_warn, NULL, 0},
};

/* "HEAD:{a|b|c}" from the names of a table; the caller frees. */
static char *head_of(const char *head, const void *records, size_t n, size_t stride) {
    char *text = alloc_format("%s:{", head);
    for (size_t i = 0; i < n; i++) {
        const char *const *name = (const void *)((const char *)records + i * stride);
        char *longer = alloc_format("%s%s%s", text, i ? "|" : "", *name);
        free(text);
        text = longer;
    }
    char *closed = alloc_format("%s}", text);
    free(text);
    return closed;
}

void command_settings(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
    const command_form accuracy = {
        .details = "Default: balanced. Growth step and relaxation time are physics and no part of "
                   "it: 0.5 s of relaxation in place of 1 s makes the radius of gyration of 3,000 "
                   "rods 26.1 um in place of 28.4 um. Nor is the contact law: comparisons with the paper also say "
                   "'force collision contact closest'. What each costs and changes, measured: help trade.",
        .example = "accuracy draft\naccuracy fast\naccuracy balanced\naccuracy reference\naccuracy paper",
        .flags = COMMAND_DECLARES,
        .run = run_accuracy};
    char *head = head_of("accuracy PRESET", accuracy_presets, accuracy_preset_count, sizeof accuracy_presets[0]);
    command_add_style(t, &accuracy, head, "Method and step of the relaxation", accuracy_params, 1, 0);
    for (size_t i = 0; i < accuracy_preset_count; i++) {
        const accuracy_preset *p = &accuracy_presets[i];
        char *text = alloc_format("%s. Validated up to %zu cells: %s", p->summary, p->validated_to, p->validated);
        command_add_choice(t, p->name, text);
        free(text);
    }
    free(head);
    const command_form integrator = {
        .details = "For those who want more than 'accuracy' offers; the last of both counts. What "
                   "each costs and how exact it is, measured, and which were tried and left "
                   "out: help methods.\n\n"
                   "Velocities (vx, speed, energy.kinetic) are those at the end of the relaxation by every method. "
                   "Verlet and euler solve damping exactly: a cell that a steady force F drives through the liquid has "
                   "F/k, k its drag, however long the steps are beside mass/k. Dormand-Prince's tolerance bounds the "
                   "error of a step, in um/s; newton leaves all cells at rest.",
        .example = "integrator verlet step 1ms\nintegrator verlet inertia 0.1\nintegrator "
                   "euler\nintegrator rk4\nintegrator rkf45\nintegrator "
                   "rk8pd\nintegrator bs32\nintegrator dopri5 tol 1e-3\nintegrator newton\nrelax to 1e-19N",
        .flags = COMMAND_DECLARES,
        .run = run_integrator};
    const char *names[INTEGRATOR_COUNT];
    for (int i = 0; i < INTEGRATOR_COUNT; i++)
        names[i] = integrator_styles[i]->name;
    head = head_of("integrator STYLE", names, INTEGRATOR_COUNT, sizeof names[0]);
    command_add_style(t, &integrator, head, "Method of the relaxation in detail", integrator_params,
                      TABLE_COUNT(integrator_params), 0);
    for (int i = 0; i < INTEGRATOR_COUNT; i++)
        command_add_choice(t, integrator_styles[i]->name, integrator_styles[i]->summary);
    free(head);
}
