/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/operand.h"

#include "base/alloc.h"
#include "script/state.h"

#include <stdlib.h>
#include <string.h>

void operand_free(operand *o) {
    free(o->v);
    free(o->text);
    for (size_t i = 0; o->t && i < o->n; i++)
        free(o->t[i]);
    free(o->t);
    *o = (operand){0};
}

operand operand_number(double si, dim d) {
    return (operand){.one = si, .d = d};
}

operand operand_truth(bool b) {
    return (operand){.one = b, .is_truth = true};
}

operand operand_text(const char *text) {
    return (operand){.is_text = true, .text = alloc_copy(text)};
}

operand operand_unknown(operand_extent extent, dim d) {
    return (operand){.extent = extent, .unknown = true, .d = d};
}

operand operand_wild(void) {
    return (operand){.unknown = true, .wild = true};
}

double operand_get(const operand *o, size_t i) {
    return o->extent == OPERAND_ONE ? o->one : o->v[i];
}

void operand_parse(interp *in, operand *o) {
    units_value v;
    if (o->extent != OPERAND_ONE || !o->is_text || o->unknown)
        return;
    if (units_read(in->host->units, o->text, strlen(o->text), &v, NULL) != SARCINA_OK)
        return;
    operand_free(o);
    *o = operand_number(v.si, v.d);
    o->plain = !v.has_unit;
}

static void scale(operand *o, double factor) {
    o->one *= factor;
    for (size_t i = 0; o->v && i < o->n; i++)
        o->v[i] *= factor;
}

bool operand_adapt(interp *in, operand *a, operand *b) {
    if (a->wild || b->wild || dim_equal(a->d, b->d))
        return true;
    operand *plain = a->plain ? a : b->plain ? b : NULL;
    if (!plain)
        return false;
    const operand *other = plain == a ? b : a;
    if (!dim_is_none(plain->d))
        return false;
    scale(plain, interp_unit(in, other->d));
    plain->d = other->d;
    plain->plain = false;
    return true;
}

const char *operand_kind(const operand *o, char buffer[48]) {
    return o->is_text ? "text" : dim_name(o->d, buffer);
}
