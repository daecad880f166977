/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/expr.h"

#include "base/alloc.h"
#include "script/state.h"

#include <stdlib.h>
#include <string.h>

void expr_free_node(node *n) {
    if (!n)
        return;
    free(n->text);
    free(n->field);
    expr_free_node(n->index);
    for (int i = 0; i < n->nargs; i++)
        expr_free_node(n->args[i]);
    expr_free_node(n->where);
    free(n);
}

expr *expr_of_text(interp *in, const char *text, diag *d) {
    source *s = interp_keep_source(in, source_of_text("", text));
    piece p = piece_of_source(s);
    reader r;
    reader_open(&r, in, &p);
    piece_free(&p);
    expr *e = expr_read(&r, EXPR_OPEN, d);
    if (e && !reader_at_end(&r)) {
        diag_error(d, "unexpected '%s' behind the expression", r.text.chars + r.at);
        expr_free(e);
        e = NULL;
    }
    reader_close(&r);
    return e;
}

expr *expr_keep(expr *e) {
    if (e)
        e->references++;
    return e;
}

void expr_free(expr *e) {
    if (!e || --e->references > 0)
        return;
    expr_free_node(e->root);
    free(e->text);
    free(e);
}

const char *expr_text(const expr *e) {
    return e->text;
}

bool expr_node_can_change(const node *n) {
    if (n->kind == NODE_UNKNOWN || n->kind == NODE_CALL)
        return true;
    if (n->kind == NODE_NAME && strcmp(n->text, "pi") != 0)
        return true;
    for (int i = 0; i < n->nargs; i++)
        if (expr_node_can_change(n->args[i]))
            return true;
    return false;
}

bool expr_can_change(const expr *e) {
    return expr_node_can_change(e->root);
}
