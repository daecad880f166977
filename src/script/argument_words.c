/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of arguments that are several words. */
#include "script/argument.h"

#include "base/alloc.h"
#include "base/table.h"
#include "script/format.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Places an error at the word and fails. */
static int refuse(const reader *r, const word *w, diag *d) {
    diag_place(d, reader_word_span(r, w));
    return SARCINA_ERROR;
}

int argument_read_numbers(args *a, const slot *s, size_t n, argument *out, reader *r, diag *d) {
    for (size_t i = 0; i < n; i++) {
        word w;
        quantity q = {0};
        bool percent;
        int status = argument_next_word(a, s, r, &w, d);
        if (status)
            return status;
        if (s->kind == SLOT_SIZE)
            status = argument_read_int(a, s, &w, &out->vector[i], d);
        else if (s->kind == SLOT_RANGE2 || s->kind == SLOT_VIEW)
            status = argument_read_quantity(a, s, &w, &q, d);
        else
            status = argument_read_number(a, s, &w, &out->vector[i], &percent, d);
        if (status)
            return refuse(r, &w, d);
        if (s->kind == SLOT_RANGE2 || s->kind == SLOT_VIEW)
            out->vector[i] = q.si;
        if (i == 0)
            out->quantity = q;
        reader_take(r, &w);
    }
    return SARCINA_OK;
}

int argument_read_orient(args *a, const slot *s, argument *out, reader *r, diag *d) {
    static const char *const names[] = {"x", "y", "z", "xy", "random"};
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    for (size_t i = 0; !status && i < TABLE_COUNT(names); i++)
        if (strcmp(names[i], w.text) == 0) {
            out->orient = (orient_kind)i;
            reader_take(r, &w);
            return SARCINA_OK;
        }
    if (status)
        return status;
    if (!isdigit((unsigned char)w.text[strspn(w.text, "+-.")]) && !w.unknown) {
        diag_error(d, "%s: expected x, y, z, xy, random or three numbers, not '%s'", s->name, w.text);
        return refuse(r, &w, d);
    }
    out->orient = ORIENT_VECTOR;
    slot number = {.kind = SLOT_NUMBER, .d = DIM_NONE, .lo = -INFINITY, .hi = INFINITY};
    snprintf(number.name, sizeof number.name, "%s", s->name);
    snprintf(number.kind_name, sizeof number.kind_name, "number");
    status = argument_read_numbers(a, &number, 3, out, r, d);
    bool zero = out->vector[0] == 0 && out->vector[1] == 0 && out->vector[2] == 0;
    if (!status && zero) {
        diag_error(d, "%s 0 0 0 is no direction", s->name);
        return refuse(r, &w, d);
    }
    return status;
}

/* A name, or two angles: from above and around. */
int argument_read_view(args *a, const slot *s, argument *out, reader *r, diag *d) {
    static const char *const names[] = {"top", "side", "front", "iso"};
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    for (size_t i = 0; i < TABLE_COUNT(names); i++)
        if (strcmp(names[i], w.text) == 0) {
            out->text = alloc_copy(w.text);
            reader_take(r, &w);
            return SARCINA_OK;
        }
    if (isdigit((unsigned char)w.text[strspn(w.text, "+-.")]) || w.unknown)
        return argument_read_numbers(a, s, 2, out, r, d);
    diag_error(d, "%s: expected top, side, front, iso or two angles, not '%s'", s->name, w.text);
    return refuse(r, &w, d);
}

int argument_read_column_format(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    out->texts = alloc_zeroed(2, sizeof *out->texts);
    out->n = 2;
    for (int i = 0; i < 2; i++) {
        int status = argument_next_word(a, s, r, &w, d);
        if (status)
            return status;
        out->texts[i] = alloc_copy(w.text);
        reader_take(r, &w);
    }
    if (format_is_valid(out->texts[1]))
        return SARCINA_OK;
    diag_error(d, "'%s' is not one number format: %%.3f, %%d, %%e, %%g", out->texts[1]);
    return refuse(r, &w, d);
}

int argument_read_words(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    int status;
    while (!(status = reader_peek(r, &w, d)) && w.text) {
        size_t index;
        if (!w.quote && signature_find(a->form, w.text, &index) && index >= a->form->nhead)
            break;
        out->texts = alloc_grow(out->texts, &out->capacity, out->n + 1, sizeof *out->texts);
        out->spans = alloc_resize(out->spans, out->capacity, sizeof *out->spans);
        out->spans[out->n] = reader_word_span(r, &w);
        out->texts[out->n++] = alloc_copy(w.text);
        reader_take(r, &w);
    }
    if (status || out->n > 0 || s->optional)
        return status;
    status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    diag_error(d, "%s: expected a word, not the keyword '%s'", s->name, w.text);
    return refuse(r, &w, d);
}
