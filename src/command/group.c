/* SPDX-License-Identifier: GPL-3.0-or-later */
/* group ID where|dynamic TEST | off; and the names that stand for groups: all, the species, the regions, these. */
#include "command/commands.h"
#include "command/output_list.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>

/* ---- groups that were declared: those of the table by their bits, then the dynamic ones ------------------------- */

static size_t count_static(interp *in) {
    size_t n = 0;
    for (int i = 0; i < GROUP_MAX; i++)
        n += *interp_scene(in)->groups.name[i] != '\0';
    return n;
}

/* Bit of the i-th group of the table. */
static int nth_bit(interp *in, size_t i) {
    int bit = 0;
    for (;; bit++)
        if (*interp_scene(in)->groups.name[bit] && i-- == 0)
            return bit;
}

static size_t count_own(interp *in) {
    return count_static(in) + session_of(in)->ndynamic;
}

static const char *get_own(interp *in, size_t i) {
    size_t n = count_static(in);
    return i < n ? interp_scene(in)->groups.name[nth_bit(in, i)] : session_of(in)->dynamic[i - n].name;
}

/* Groups may be defined by groups, so one may come to depend on itself. */
static int dynamic_members(interp *in, size_t i, bool *flags, diag *d) {
    enum { DEPTH_MAX = 50 };
    session *s = session_of(in);
    if (s->group_depth == DEPTH_MAX)
        return diag_error(d, "group '%s' depends on itself", s->dynamic[i].name);
    expr *test = expr_keep(s->dynamic[i].test); /* it may be redefined meanwhile */
    s->group_depth++;
    int status = interp_flags(in, test, flags, d);
    s->group_depth--;
    expr_free(test);
    return status;
}

static int own_members(interp *in, size_t i, const view *v, bool *flags, diag *d) {
    size_t n = count_static(in);
    if (i >= n)
        return dynamic_members(in, i - n, flags, d);
    int bit = nth_bit(in, i);
    for (uint32_t row = 0; row < v->colony->cell.count; row++)
        flags[row] = group_has(v->colony, row, bit);
    return SARCINA_OK;
}

static const name_class own_class = {"+group", "a group", false, true, count_own, get_own, own_members, NULL};

/* ---- all that stands for a group: their names belong to other classes, so this one is free ---------------------- */

static size_t count_all(interp *in) {
    const scene *s = interp_scene(in);
    return 1 + s->species.count + s->regions.count + count_own(in);
}

static const char *get_any(interp *in, size_t i) {
    const scene *s = interp_scene(in);
    if (i == 0)
        return "all";
    if (i <= s->species.count)
        return s->species.list[i - 1].name;
    i -= 1 + s->species.count;
    return i < s->regions.count ? s->regions.list[i].name : get_own(in, i - s->regions.count);
}

static void mark_region(const region *r, const view *v, bool *flags) {
    for (uint32_t row = 0; row < v->colony->cell.count; row++) {
        double centre[3];
        colony_centre(v->colony, row, centre);
        flags[row] = region_contains(r, centre);
    }
}

int session_group_members(interp *in, size_t i, const view *v, bool *flags, diag *d) {
    const scene *s = interp_scene(in);
    size_t nspecies = s->species.count;
    if (i > nspecies + s->regions.count)
        return own_members(in, i - 1 - nspecies - s->regions.count, v, flags, d);
    if (i > nspecies) {
        mark_region(&s->regions.list[i - 1 - nspecies], v, flags);
        return SARCINA_OK;
    }
    for (size_t row = 0; row < v->colony->cell.count; row++)
        flags[row] = i == 0 || (size_t)v->colony->cell.species[row] == i - 1;
    return SARCINA_OK;
}

int session_find_group(interp *in, const char *name) {
    size_t n = count_all(in);
    for (size_t i = 0; i < n; i++)
        if (strcmp(get_any(in, i), name) == 0)
            return (int)i;
    return -1;
}

static const name_class group_class = {"group", "a group", true, true, count_all, get_any, session_group_members, NULL};

/* ---- defining --------------------------------------------------------------------------------------------------- */

static ptrdiff_t find_dynamic(const session *s, const char *name) {
    for (size_t i = 0; i < s->ndynamic; i++)
        if (strcmp(s->dynamic[i].name, name) == 0)
            return (ptrdiff_t)i;
    return -1;
}

static void drop_dynamic(session *s, size_t i) {
    free(s->dynamic[i].name);
    expr_free(s->dynamic[i].test);
    memmove(&s->dynamic[i], &s->dynamic[i + 1], (--s->ndynamic - i) * sizeof *s->dynamic);
}

void session_drop_groups(session *s) {
    while (s->ndynamic)
        drop_dynamic(s, s->ndynamic - 1);
}

static bool is_group(interp *in, const char *name) {
    return group_find(&interp_scene(in)->groups, name) >= 0 || find_dynamic(session_of(in), name) >= 0;
}

/* Whoever comes from LAMMPS may expect cells to be added. */
static void tell_replaced(interp *in, const char *name) {
    session *s = session_of(in);
    if (s->told_replaced)
        return;
    interp_print(in, "group %s is replaced; to add to it, write 'group %s where %s || ...'", name, name, name);
    s->told_replaced = true;
}

int session_check_group(interp *in, const char *name, diag *d) {
    const group_table *t = &interp_scene(in)->groups;
    if (group_find(t, name) >= 0 || count_static(in) < GROUP_MAX)
        return SARCINA_OK;
    diag_error(d, "there are %d groups already, as many as there may be", GROUP_MAX);
    return diag_help(d, "take one out (group ID off); dynamic groups do not count");
}

int session_define_group(interp *in, const char *name) {
    session *s = session_of(in);
    group_table *t = &interp_scene(in)->groups;
    int bit = group_find(t, name);
    ptrdiff_t old = find_dynamic(s, name);
    if (old >= 0)
        drop_dynamic(s, (size_t)old);
    if (bit < 0)
        bit = group_add(t, name);
    /* a restart file puts its cells in */
    char *text = alloc_format("group %s where 0", name);
    interp_journal_add(in, text);
    free(text);
    return bit;
}

static void report(interp *in, const char *name, const bool *flags) {
    size_t n = interp_scene(in)->colony->cell.count, members = 0;
    for (size_t i = 0; i < n; i++)
        members += flags[i];
    interp_print(in, "group %s: %zu of %zu %s", name, members, n, number_noun(n, "cell", "cells"));
    if (members == 0 && !interp_checking(in))
        interp_warn(in,
                    "group %s is empty, and only daughters of its cells join it; 'group %s dynamic ...' is judged "
                    "anew at every look",
                    name, name);
}

static int run_where(interp *in, const args *a, diag *d) {
    const char *name = args_text(a, "ID");
    colony *c = interp_scene(in)->colony;
    bool *flags = alloc_zeroed(c->cell.count, sizeof *flags);
    int status = interp_checking(in) ? SARCINA_OK : interp_flags(in, args_expr(a, "TEST"), flags, d);
    if (!status)
        status = session_check_group(in, name, d);
    if (!status) {
        if (is_group(in, name))
            tell_replaced(in, name);
        group_assign(session_define_group(in, name), c, flags);
        report(in, name, flags);
    }
    free(flags);
    return status;
}

/* The test must be one that can be made for the scene as it stands. The name must mean this group meanwhile: a group of
 * the table that is to be replaced is hidden. */
static int try_dynamic(interp *in, size_t i, int hidden, diag *d) {
    if (interp_checking(in))
        return SARCINA_OK;
    scene *sc = interp_scene(in);
    char none[] = "", *name = hidden < 0 ? none : sc->groups.name[hidden], first = *name;
    bool *flags = alloc_zeroed(sc->colony->cell.count, sizeof *flags);
    *name = '\0';
    int status = dynamic_members(in, i, flags, d);
    *name = first;
    free(flags);
    return status;
}

/* The entry of this name, with the test; *before: the one it had, or NULL when it is new. */
static size_t put_dynamic(session *s, const char *name, expr *test, expr **before) {
    ptrdiff_t at = find_dynamic(s, name);
    *before = at < 0 ? NULL : s->dynamic[at].test;
    if (at < 0) {
        s->dynamic = alloc_grow(s->dynamic, &s->dynamic_capacity, s->ndynamic + 1, sizeof *s->dynamic);
        at = (ptrdiff_t)s->ndynamic++;
        s->dynamic[at].name = alloc_copy(name);
    }
    s->dynamic[at].test = expr_keep(test);
    return (size_t)at;
}

static int run_dynamic(interp *in, const args *a, diag *d) {
    session *s = session_of(in);
    scene *sc = interp_scene(in);
    const char *name = args_text(a, "ID");
    int bit = group_find(&sc->groups, name);
    if (interp_check_repeatable(in, args_expr(a, "TEST"), d) != SARCINA_OK)
        return SARCINA_ERROR;
    expr *before;
    size_t at = put_dynamic(s, name, args_expr(a, "TEST"), &before);
    int status = try_dynamic(in, at, bit, d);
    if (status && before) {
        expr_free(s->dynamic[at].test);
        s->dynamic[at].test = before;
    } else if (status) {
        drop_dynamic(s, at);
    }
    if (status)
        return status;
    if (before || bit >= 0)
        tell_replaced(in, name);
    expr_free(before);
    if (bit >= 0)
        group_remove(&sc->groups, bit, sc->colony);
    return SARCINA_OK;
}

/* ---- undefining ------------------------------------------------------------------------------------------------- */

int session_check_unused(interp *in, const char *noun, const char *name, diag *d) {
    const outputs *o = session_of(in)->out;
    const char *user = NULL, *id = NULL;
    for (size_t i = 0; i < o->ndumps; i++)
        if (strcmp(o->dumps[i].group, name) == 0)
            user = "dump", id = o->dumps[i].id;
    for (size_t i = 0; i < o->nanalyses; i++)
        if (strcmp(o->analyses[i].group, name) == 0)
            user = "analyze", id = o->analyses[i].id;
    const attachment_table *t = &interp_scene(in)->attachments;
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i].where.name, name) == 0)
            user = "attach", id = interp_scene(in)->species.list[t->list[i].placement.species].name;
    if (!user)
        return SARCINA_OK;
    diag_error(d, "%s %s is used by %s %s", noun, name, user, id);
    return diag_help(d, "'%s %s off' before", user, id);
}

static int run_off(interp *in, const args *a, diag *d) {
    session *s = session_of(in);
    scene *sc = interp_scene(in);
    const char *name = args_text(a, "ID");
    ptrdiff_t dynamic = find_dynamic(s, name);
    int bit = group_find(&sc->groups, name);
    if (dynamic < 0 && bit < 0) {
        diag_error(d, "%s cannot be taken out: it is no group that 'group' made", name);
        return diag_help(d, "species are groups as long as they stand, and regions too: region %s off", name);
    }
    int status = session_check_unused(in, "group", name, d);
    if (!status && dynamic >= 0)
        drop_dynamic(s, (size_t)dynamic);
    if (!status && bit >= 0)
        group_remove(&sc->groups, bit, sc->colony);
    return status;
}

static const param where_params[] = {
    {"ID:+group", "its name"},
    {"TEST:cellexpr", "holds for the cells that are put in"},
};
static const param dynamic_params[] = {
    {"ID:+group", "its name"},
    {"TEST:cellexpr", "holds for the cells that are in it, whenever that is asked"},
};
static const param off_params[] = {{"ID:group", "the group to take out"}};

static const command_form forms[] = {
    {.head = "group ID:+group where TEST:cellexpr",
     .params = where_params,
     .nparams = TABLE_COUNT(where_params),
     .summary = "Puts cells into a group, once",
     .details = "The test is made now; daughters inherit their mother's groups. Every species and region is a group "
                "too. In expressions a group is 1 or 0 per cell: count(old && z > 1um). The same ID again replaces "
                "the group. At most 64.",
     .example = "group old where age > 1h && z > 1um",
     .flags = COMMAND_SHADOW,
     .run = run_where},
    {.head = "group ID:+group dynamic TEST:cellexpr",
     .params = dynamic_params,
     .nparams = TABLE_COUNT(dynamic_params),
     .summary = "A group of the cells for which a test holds at that moment",
     .details = "The test is made at every look: cells come and go. It may name groups, variables, regions.",
     .example = "group upright dynamic abs(uz) > 0.7",
     .flags = COMMAND_DECLARES,
     .run = run_dynamic},
    {.head = "group ID:group off",
     .params = off_params,
     .nparams = TABLE_COUNT(off_params),
     .summary = "Takes a group out; its cells stay",
     .details = "Refused while a dump or an analysis uses it.",
     .example = "group old where age > 1h\ngroup old off",
     .flags = COMMAND_DECLARES,
     .run = run_off},
};

void command_group(command_table *t) {
    command_add_class(t, &own_class);
    command_add_class(t, &group_class);
    command_add(t, forms, TABLE_COUNT(forms));
}
