/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/tradeoff_method.h"

#include "base/table.h"
#include "relax/integrator.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* What may stand behind an integrator's name, as in `integrator`. */
typedef struct control {
    const char *name;
    const char *takes;
    bool is_time; /* else a pure number */
    double most;  /* and below */
    bool zero;    /* may be 0 */
    size_t offset;
} control;

static const control controls[] = {
    {"step", "a time more than 0", true, INFINITY, false, offsetof(relax_settings, step)},
    {"tol", "a number between 0 and 1", false, 1, false, offsetof(relax_settings, tolerance)},
    {"inertia", "a number from 0, below 1", false, 1, true, offsetof(relax_settings, inertia)},
};

typedef struct word {
    const char *at;
    int n;
} word;

/* The word that begins at *text or behind blanks; *text goes behind it. n 0: none is left. */
static word next_word(const char **text) {
    const char *at = *text + strspn(*text, " \t");
    word w = {at, (int)strcspn(at, " \t")};
    *text = at + w.n;
    return w;
}

static bool is_word(word w, const char *name) {
    return strlen(name) == (size_t)w.n && strncmp(w.at, name, (size_t)w.n) == 0;
}

static int refuse(const char *text, word w, diag *d) {
    char name[32];
    snprintf(name, sizeof name, "%.*s", w.n, w.at);
    const char *near = table_nearest(accuracy_presets, accuracy_preset_count, sizeof *accuracy_presets, name);
    diag_error(d, "'%s' is neither a preset of accuracy nor an integrator", text);
    if (near)
        return diag_help(d, "did you mean '%s'?", near);
    return diag_help(d, "'help presets' and 'help integrators' list them");
}

static int read_control(interp *in, const char **rest, relax_settings *how, diag *d) {
    word name = next_word(rest), number = next_word(rest);
    const control *c = NULL;
    for (size_t i = 0; i < TABLE_COUNT(controls) && !c; i++)
        c = is_word(name, controls[i].name) ? &controls[i] : NULL;
    if (!c) {
        diag_error(d, "an integrator takes step, tol or inertia, not '%.*s'", name.n, name.at);
        return diag_help(d, "one word in quotes: among balanced \"verlet step 1ms\" \"bs32 tol 0.01\"");
    }
    units_value v = {0};
    int status = number.n ? units_read(interp_units(in), number.at, (size_t)number.n, &v, d) : SARCINA_OK;
    if (status)
        return status;
    bool fits = number.n && (!v.has_unit || (dim_equal(v.d, c->is_time ? DIM_TIME : DIM_NONE) && !v.percent));
    if (!fits || !(v.si >= 0) || (v.si == 0 && !c->zero) || v.si >= c->most)
        return diag_error(d, "%s takes %s, not '%.*s'", c->name, c->takes, number.n, number.at);
    *(double *)((char *)how + c->offset) = v.si;
    return SARCINA_OK;
}

int tradeoff_method_read(interp *in, const char *text, tradeoff_method *out, diag *d) {
    const char *rest = text;
    word first = next_word(&rest);
    *out = (tradeoff_method){.name = text};
    for (size_t i = 0; i < accuracy_preset_count; i++)
        if (strcmp(text, accuracy_presets[i].name) == 0) {
            out->how = accuracy_presets[i].settings;
            return SARCINA_OK;
        }
    int integrator = -1;
    for (int i = 0; i < INTEGRATOR_COUNT; i++)
        integrator = is_word(first, integrator_styles[i]->name) ? i : integrator;
    if (integrator < 0)
        return refuse(text, first, d);
    if (integrator_styles[integrator]->caps & INTEGRATOR_MINIMISES)
        return diag_error(d, "integrator %s follows no time: there is no relaxation to compare",
                          integrator_styles[integrator]->name);
    out->how.integrator = (integrator_kind)integrator;
    int status = SARCINA_OK;
    while (!status && rest[strspn(rest, " \t")])
        status = read_control(in, &rest, &out->how, d);
    return status ? status : integrator_check(&out->how, &(const char *){NULL}, d);
}
