/* SPDX-License-Identifier: GPL-3.0-or-later */
/* expect EXPR [approx EXPR [rel R] [abs A]]; expect_error "text" "command": the language's own tests. */
#include "command/commands.h"

#include "base/number.h"
#include "base/table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double default_rel = 1e-6;

/* "3e-06m" into text. */
static void write_value(double si, dim d, char text[96]) {
    char number[32], suffix[48];
    snprintf(text, 96, "%s%s", number_write(si, number), dim_suffix(d, suffix));
}

/* A plain number takes the dimension of what it meets; false: the two differ. */
static bool adapt(interp *in, quantity *q, dim to) {
    if (dim_equal(q->d, to))
        return true;
    if (!q->plain)
        return false;
    q->si *= interp_unit(in, to);
    q->d = to;
    return true;
}

static int refuse_dims(const quantity *a, const quantity *b, span at, diag *d) {
    char left[48], right[48];
    diag_error(d, "expect compares a %s with a %s", dim_name(a->d, left), dim_name(b->d, right));
    diag_place(d, at);
    return SARCINA_ERROR;
}

/* How far the two may lie apart: the larger of rel of the value due and abs. */
static int read_tolerance(interp *in, const args *a, const quantity *wanted, double *tolerance, diag *d) {
    bool rel = args_given(a, "rel"), abs_given = args_given(a, "abs");
    *tolerance = 0;
    if (rel || !abs_given)
        *tolerance = fabs(wanted->si) * (rel ? args_number(a, "rel") : default_rel);
    if (!abs_given)
        return SARCINA_OK;
    quantity q = args_quantity(a, "abs");
    if (!adapt(in, &q, wanted->d))
        return refuse_dims(wanted, &q, args_span(a, "abs"), d);
    *tolerance = fmax(*tolerance, q.si);
    return SARCINA_OK;
}

static int expect_approx(interp *in, const args *a, diag *d) {
    quantity got, wanted;
    double tolerance = 0;
    int status = interp_number(in, args_expr(a, "TEST"), &got, d);
    if (!status)
        status = interp_number(in, args_expr(a, "approx"), &wanted, d);
    if (!status && !adapt(in, &wanted, got.d) && !adapt(in, &got, wanted.d))
        status = refuse_dims(&got, &wanted, args_span(a, "approx"), d);
    if (!status)
        status = read_tolerance(in, a, &wanted, &tolerance, d);
    if (status)
        return status;
    diag failure = {0};
    bool holds = fabs(got.si - wanted.si) <= tolerance;
    if (!holds) {
        char x[96], y[96], apart[96];
        write_value(got.si, got.d, x);
        write_value(wanted.si, wanted.d, y);
        write_value(got.si - wanted.si, got.d, apart);
        diag_fail(&failure, SARCINA_EXPECT, "expected %s approx %s", expr_text(args_expr(a, "TEST")),
                  expr_text(args_expr(a, "approx")));
        diag_help(&failure, "it is %s, not %s: they differ by %s", x, y, apart);
    }
    status = interp_expect(in, holds, &failure);
    if (status && d)
        *d = failure;
    return status;
}

static int run_expect(interp *in, const args *a, diag *d) {
    if (args_given(a, "approx"))
        return expect_approx(in, a, d);
    bool holds;
    int status = interp_truth(in, args_expr(a, "TEST"), &holds, d);
    if (status)
        return status;
    diag failure = {0};
    if (!holds) {
        diag_fail(&failure, SARCINA_EXPECT, "expected %s", expr_text(args_expr(a, "TEST")));
        expr_explain(in, args_expr(a, "TEST"), &failure);
    }
    status = interp_expect(in, holds, &failure);
    if (status && d)
        *d = failure;
    return status;
}

static int run_expect_error(interp *in, const args *a, diag *d) {
    diag got = {0}, failure = {0};
    const char *wanted = args_text(a, "MESSAGE");
    int status = interp_run_text(in, args_command(a, "COMMAND"), &got);
    bool holds = status && (strstr(got.message, wanted) || strstr(got.help, wanted));
    if (!status)
        diag_fail(&failure, SARCINA_EXPECT, "expected the error '%s', but there was none", wanted);
    else if (!holds)
        diag_fail(&failure, SARCINA_EXPECT, "expected the error '%s', not '%s'", wanted, got.message);
    status = interp_expect(in, holds, &failure);
    if (status && d)
        *d = failure;
    return status;
}

static const param expect_params[] = {
    {"TEST:expr", "must hold, or be near what is behind approx"},
    {"approx:expr", "the value due"},
    {"rel:number%[0,)", "part of it that the two may differ by; 1e-6 when neither is given"},
    {"abs:quantity", "or by this much"},
};
static const param error_params[] = {
    {"MESSAGE:text", "a part of the error's text"},
    {"COMMAND:command", "must fail with it, and change nothing"},
};

static const command_form forms[] = {
    {"expect TEST:expr", expect_params, TABLE_COUNT(expect_params), "Stops (exit 4) unless this holds",
     "Under -test a failure is counted and the script goes on.",
     "expect cells == 2\nexpect thickness approx 0.5um rel 50% abs 1nm", 0, run_expect, NULL, 0},
    {"expect_error MESSAGE:text COMMAND:command", error_params, TABLE_COUNT(error_params),
     "Stops (exit 4) unless the command fails with this error", NULL,
     "expect_error \"unknown command\" \"creat_cells\"", COMMAND_MEANT_TO_FAIL, run_expect_error, NULL, 0},
};

void command_expect(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
