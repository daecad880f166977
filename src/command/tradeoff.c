/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tradeoff T [among PRESET...] [file F]: speed against accuracy, on the scene as it stands. */
#include "command/commands.h"
#include "command/output_list.h"
#include "command/session.h"
#include "command/tradeoff_table.h"

#include "base/path.h"
#include "base/table.h"
#include "relax/integrator.h"

#include <math.h>
#include <string.h>

enum { METHODS_MAX = 32 };

/* ---- what is compared -------------------------------------------------------------------------------------------- */

/* A preset, or an integrator with a step of its own. */
static bool find_method(const char *name, tradeoff_method *out) {
    for (size_t i = 0; i < accuracy_preset_count; i++)
        if (strcmp(name, accuracy_presets[i].name) == 0) {
            *out = (tradeoff_method){accuracy_presets[i].name, accuracy_presets[i].settings};
            return true;
        }
    int integrator = integrator_find(name);
    if (integrator >= 0)
        *out = (tradeoff_method){integrator_styles[integrator]->name, {.integrator = (integrator_kind)integrator}};
    return integrator >= 0;
}

static int refuse_method(const char *name, diag *d) {
    const char *near = table_nearest(accuracy_presets, accuracy_preset_count, sizeof *accuracy_presets, name);
    diag_error(d, "'%s' is neither a preset of accuracy nor an integrator", name);
    if (near)
        return diag_help(d, "did you mean '%s'?", near);
    return diag_help(d, "'help presets' and 'help integrators' list them");
}

static bool is_among(const tradeoff_method *methods, size_t n, const char *name) {
    for (size_t i = 0; i < n; i++)
        if (strcmp(methods[i].name, name) == 0)
            return true;
    return false;
}

/* Those named, or all presets. */
static int read_methods(const args *a, tradeoff_method methods[METHODS_MAX], size_t *n, diag *d) {
    size_t named = args_given(a, "among") && output_list_knows(a, "among") ? args_count(a, "among") : 0;
    for (*n = 0; *n < accuracy_preset_count && !args_given(a, "among"); ++*n)
        find_method(accuracy_presets[*n].name, &methods[*n]);
    for (; *n < named; ++*n) {
        const char *name = args_text_at(a, "among", *n);
        bool twice = is_among(methods, *n, name);
        if (!twice && find_method(name, &methods[*n]))
            continue;
        if (twice)
            diag_error(d, "'%s' is named twice", name);
        else
            refuse_method(name, d);
        diag_place(d, args_span_at(a, "among", *n));
        return SARCINA_ERROR;
    }
    return SARCINA_OK;
}

/* A colony that has just been relaxed is at rest, and any method keeps it so: what a run solves begins with growth. */
static tradeoff_plan read_plan(interp *in, const args *a) {
    double grow = args_given(a, "grow") ? args_number(a, "grow") : session_of(in)->grow_time;
    return (tradeoff_plan){.grow = isnan(grow) ? 0 : grow, .relax = args_number(a, "T")};
}

static int check_file(const args *a, const char *name, diag *d) {
    if (!args_given(a, name) || !output_list_knows(a, name) || path_check(args_text(a, name), d) == SARCINA_OK)
        return SARCINA_OK;
    diag_place(d, args_span(a, name));
    return SARCINA_ERROR;
}

/* ---- the command ------------------------------------------------------------------------------------------------- */

static int write_file(const char *path, const tradeoff_result *r, diag *d) {
    FILE *f = path_open(path, "w", d);
    if (!f)
        return SARCINA_ERROR;
    tradeoff_table_write(f, r);
    return fclose(f) ? path_error(path, d) : SARCINA_OK;
}

static int run_tradeoff(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    tradeoff_method methods[METHODS_MAX] = {{0}};
    tradeoff_row rows[METHODS_MAX];
    tradeoff_result r = {.plan = read_plan(in, a), .methods = methods, .rows = rows};
    int status = read_methods(a, methods, &r.n, d);
    if (!status)
        status = check_file(a, "file", d);
    if (status || interp_checking(in) || interp_skips_runs(in))
        return status;
    if (s->colony->cell.count == 0) {
        diag_error(d, "there are no cells to compare the presets on");
        return diag_help(d, "write it behind create_cells and a run");
    }
    status = tradeoff_relaxation(s, &r.plan, methods, r.n, rows, &r.reference, d);
    if (status)
        return status;
    tradeoff_table_print(in, &r);
    return args_given(a, "file") ? write_file(args_text(a, "file"), &r, d) : SARCINA_OK;
}

static const param params[] = {
    {"T:time(0,)", "relaxation time"},
    {"among:word...", "presets of accuracy, or integrators with steps of their own; without it, all presets"},
    {"grow:time[0,)", "growth before the relaxation; without it, that of the run before, or none"},
    {"file:file", "a CSV file for what was found, in SI units"},
};

static const command_form forms[] = {
    {"tradeoff T:time(0,)", params, TABLE_COUNT(params), "One relaxation by each preset, against a converged one",
     "First the cells grow once, the same for all, as in a cycle of run: a colony at rest stays so by any method. Then "
     "the error is that of the particles' positions at the end, the largest and the root mean square, against "
     "Dormand-Prince at ever tighter tolerances, until two that follow each other end within 1e-4 um, or the next "
     "takes more than 100 times the evaluations of the first, 0.1 um; what they differ by is printed as the "
     "reference's own error. A relaxation "
     "from particles displaced by 1e-9 diameters shows where trajectories diverge: rows whose error is less than twice "
     "what has become of that say chaos.",
     "tradeoff 0.1s among paper balanced draft grow 4min file tradeoff.csv", COMMAND_SHADOW, run_tradeoff, NULL, 0},
};

void command_tradeoff(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
