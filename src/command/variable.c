/* SPDX-License-Identifier: GPL-3.0-or-later */
/* variable NAME default|equal|string|getenv|list|append|off. */
#include "command/commands.h"

#include "base/table.h"
#include "script/variables.h"

/* What the command line set stays. */
static bool is_fixed(interp *in, const args *a) {
    const variable *v = variables_find(variables_of(in), args_text(a, "NAME"));
    return v && v->command_line;
}

/* Sets a text, which a check may not know. */
static int set_text(interp *in, const args *a, const char *text) {
    variables *all = variables_of(in);
    const char *name = args_text(a, "NAME");
    if (is_fixed(in, a))
        return SARCINA_OK;
    variables_set_text(all, name, text);
    variable *v = variables_find(all, name);
    v->unknown = args_unknown(a, "TEXT", &v->note);
    return SARCINA_OK;
}

static int run_default(interp *in, const args *a, diag *d) {
    (void)d;
    if (variables_find(variables_of(in), args_text(a, "NAME")))
        return SARCINA_OK;
    return set_text(in, a, args_text(a, "TEXT"));
}

static int run_string(interp *in, const args *a, diag *d) {
    (void)d;
    return set_text(in, a, args_text(a, "TEXT"));
}

static int run_equal(interp *in, const args *a, diag *d) {
    (void)d;
    if (!is_fixed(in, a))
        variables_set_formula(variables_of(in), args_text(a, "NAME"), args_expr(a, "EXPR"));
    return SARCINA_OK;
}

static int run_getenv(interp *in, const args *a, diag *d) {
    const char *text = interp_environment(in, args_text(a, "ENV"));
    if (!text) {
        diag_error(d, "the environment has no variable '%s'", args_text(a, "ENV"));
        diag_place(d, args_span(a, "ENV"));
        return SARCINA_ERROR;
    }
    if (!is_fixed(in, a))
        variables_set_text(variables_of(in), args_text(a, "NAME"), text);
    return SARCINA_OK;
}

static int run_list(interp *in, const args *a, diag *d) {
    (void)d;
    variable *v = variables_reset(variables_of(in), args_text(a, "NAME"), VARIABLE_LIST);
    for (size_t i = 0; i < args_count(a, "VALUE"); i++)
        variables_append(v, args_text_at(a, "VALUE", i));
    return SARCINA_OK;
}

static int run_append(interp *in, const args *a, diag *d) {
    const char *name = args_text(a, "NAME");
    variable *v = variables_find(variables_of(in), name);
    if (v && v->kind != VARIABLE_LIST) {
        diag_error(d, "variable '%s' is no list", name);
        diag_place(d, args_span(a, "NAME"));
        return diag_help(d, "variable %s list", name);
    }
    return variables_append_value(in, name, args_expr(a, "VALUE"), d);
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    variables_remove(variables_of(in), args_text(a, "NAME"));
    return SARCINA_OK;
}

static const param default_params[] = {{"NAME:+variable", "letters, digits and _"},
                                       {"TEXT:text", "one word or one quoted text"}};
static const param equal_params[] = {{"NAME:+variable", "letters, digits and _"},
                                     {"EXPR:formula", "the rest of the line; computed whenever it is looked at"}};
static const param getenv_params[] = {{"NAME:+variable", "letters, digits and _"},
                                      {"ENV:word", "name in the environment"}};
static const param list_params[] = {{"NAME:+variable", "letters, digits and _"},
                                    {"VALUE:values?", "its first elements"}};
static const param append_params[] = {{"NAME:variable", "a list"}, {"VALUE:expr", "computed now"}};
static const param off_params[] = {{"NAME:variable", "the variable that goes"}};

static const command_form forms[] = {
    {"variable NAME:+variable default TEXT:text", default_params, TABLE_COUNT(default_params),
     "A text, unless the variable is set already",
     "The first setting wins: -var on the command line, a loop, or a script before its include.",
     "variable seed default 1", COMMAND_DECLARES, run_default, NULL, 0},
    {"variable NAME:+variable equal EXPR:formula", equal_params, TABLE_COUNT(equal_params),
     "A formula, of the scene or per cell",
     "Where one value is due it has one, where cells are asked (columns of dumps, colours, where) one a cell.",
     "variable stacked equal thickness > 0.75um\nvariable tilt equal asin(abs(uz))/1degree\nprint \"$(stacked) "
     "$(max(tilt):%.1f)\"",
     COMMAND_DECLARES, run_equal, NULL, 0},
    {"variable NAME:+variable string TEXT:text", default_params, TABLE_COUNT(default_params), "A text, set anew", NULL,
     "variable s string \"a b\"", COMMAND_DECLARES, run_string, NULL, 0},
    {"variable NAME:+variable getenv ENV:word", getenv_params, TABLE_COUNT(getenv_params),
     "A text from the environment", NULL, "variable home getenv HOME", COMMAND_SHADOW, run_getenv, NULL, 0},
    {"variable NAME:+variable list VALUE:values?", list_params, TABLE_COUNT(list_params), "A list of values",
     "mean(t), sd(t), ci95(t), count(t) take it whole; t[3] is its third.",
     "variable t list 1um 2um 4um\nprint \"$(mean(t)/1um:%.2f) um\"", COMMAND_DECLARES, run_list, NULL, 0},
    {"variable NAME:variable append VALUE:expr", append_params, TABLE_COUNT(append_params), "Adds a value to a list",
     NULL, "variable t list\nfor i in 1..3\n    variable t append $i^2\nend\nprint \"$(mean(t)) $(t[3])\"",
     COMMAND_SHADOW, run_append, NULL, 0},
    {"variable NAME:variable off", off_params, TABLE_COUNT(off_params), "Takes a variable away", NULL,
     "variable h0 equal 2um\nvariable h0 off", COMMAND_DECLARES, run_off, NULL, 0},
};

void command_variable(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
