/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of arguments that are numbers. */
#include "script/argument.h"
#include "script/state.h"

#include "base/number.h"
#include "base/table.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *article(const char *noun) {
    return strchr("aeiou", *noun) ? "an" : "a";
}

/* What the slot takes, for errors: "length", "number". */
static const char *due(const slot *s, char buffer[48]) {
    return dim_is_none(s->d) ? s->kind_name : dim_name(s->d, buffer);
}

static bool looks_like_number(const char *text) {
    return isdigit((unsigned char)text[strspn(text, "+-.")]);
}

/* Whoever writes a formula where a number stands learns how: the name of a variable alone is one, too. */
static int help_formula(const args *a, const slot *s, const word *w, int status, diag *d) {
    const char *text = w->text;
    bool begins_name = isalpha((unsigned char)*text), is_name = begins_name && variables_find(&a->in->variables, text);
    if (status && (is_name || strpbrk(text, "(*+") || (begins_name && strchr(text, '/'))))
        diag_help(d, "a formula stands in $( ): %s $(%s)", s->name, text);
    return status;
}

/* Number and unit of a word; s says what was due. */
static int read_value(args *a, const slot *s, const word *w, units_value *v, diag *d) {
    char name[48];
    if (!looks_like_number(w->text)) {
        const char *what = due(s, name);
        diag_error(d, "%s: expected %s %s, not '%s'", s->name, article(what), what, w->text);
        return help_formula(a, s, w, SARCINA_ERROR, d);
    }
    return help_formula(a, s, w, units_read(a->in->host->units, w->text, w->n, v, d), d);
}

static int wrong_dimension(const slot *s, const word *w, dim got, diag *d) {
    char want[48], have[48];
    const char *what = due(s, want);
    diag_error(d, "%s takes %s %s, not '%s' (%s)", s->name, article(what), what, w->text, dim_name(got, have));
    size_t digits = number_length(w->text, w->n, true);
    const char *hint = units_hint(w->text + digits, w->n - digits, &s->d);
    if (hint)
        diag_help(d, "%s", hint);
    else if (dim_equal(got, DIM_TIME) && dim_equal(s->d, DIM_RATE))
        diag_help(d, "of a doubling time: %s $(ln(2)/%s)", s->name, w->text);
    return SARCINA_ERROR;
}

/* "more than 0", "at most 1" as the record writes the bound, so that the text fits its unit. */
static int check_range(const slot *s, const word *w, double si, bool bare, diag *d) {
    const char *bound = NULL, *text = NULL;
    if (s->lo_text && (s->lo_open ? !(si > s->lo) : !(si >= s->lo)))
        bound = s->lo_open ? "more than" : "at least", text = s->lo_text;
    if (s->hi_text && (s->hi_open ? !(si < s->hi) : !(si <= s->hi)))
        bound = s->hi_open ? "less than" : "at most", text = s->hi_text;
    if (!bound)
        return SARCINA_OK;
    diag_error(d, "%s must be %s %s, not '%s'", s->name, bound, text, w->text);
    const char *usual[1];
    if (bare && text == s->hi_text && s->percent && dim_equal(s->d, DIM_MASS))
        diag_help(d, "50%% is of the natural whole (the mass at division)");
    else if (bare && text == s->hi_text && s->percent && dim_is_none(s->d))
        diag_help(d, "percents are written %s%%", w->text);
    else if (bare && text == s->hi_text && (!dim_is_none(s->d) || strcmp(s->kind_name, "angle") == 0) &&
             units_usual(s->d, usual, 1))
        diag_help(d, "a bare number is in the script's units; %s%s?", w->text, usual[0]);
    return SARCINA_ERROR;
}

/* ---- what is hardly meant ---- */

static const struct {
    const char *name, *dimension;
    double lo, hi; /* SI */
    const char *range;
    const char *command; /* NULL: any */
} plausible[] = {
    {"diameter", "length", 1e-7, 1e-4, "0.1um to 100um", NULL},
    {"X", "length", -1e-2, 1e-2, "within 1cm", NULL},
    {"Y", "length", -1e-2, 1e-2, "within 1cm", NULL},
    {"Z", "length", -1e-2, 1e-2, "within 1cm", NULL},
    {"mass", "mass", 1e-17, 1e-11, "1e-17kg to 1e-11kg", NULL},
    {"rate", "rate", 1e-3 / 3600, 10.0 / 3600, "0.001/h to 10/h", "growth"},
    {"rate", "rate", 1e-3 / 3600, 1e4 / 3600, "0.001/h to 10000/h", "attach"},
    {"DT", "time", 1, 3600, "1s to 1h", NULL},
    {"grow", "time", 1, 3600, "1s to 1h", NULL},
    {"T", "time", 1e-2, 100, "10ms to 100s", NULL},
    {"relax", "time", 1e-2, 100, "10ms to 100s", NULL},
    {"k", "stiffness", 1e-15, 1e-6, "1e-15N/m to 1e-6N/m", NULL},
};

void argument_warn(args *a, const slot *s, const word *w, double si) {
    dim d;
    for (size_t i = 0; i < TABLE_COUNT(plausible); i++) {
        if (strcmp(plausible[i].name, s->name) != 0 || !dim_by_name(plausible[i].dimension, &d) || !dim_equal(d, s->d))
            continue;
        if (plausible[i].command && strcmp(plausible[i].command, a->form->head[0].name) != 0)
            continue;
        bool fits = (si >= plausible[i].lo && si <= plausible[i].hi) || si == 0;
        const char *usual[1];
        size_t n = units_usual(d, usual, 1);
        bool bare = number_length(w->text, w->n, true) == w->n;
        if (!fits && !a->in->check.on)
            interp_warn(a->in, "%s %s is unusual (%s)%s%s%s", s->name, w->text, plausible[i].range,
                        bare && n ? "; meant " : "", bare && n ? w->text : "", bare && n ? usual[0] : "");
    }
}

/* ---- unknown in a check ---- */

/* A value for a number a check does not know: the default, else something in range. */
static double plausible_value(const args *a, const slot *s) {
    units_value v;
    if (s->initial && units_read(a->in->host->units, s->initial, strlen(s->initial), &v, NULL) == SARCINA_OK)
        return v.si;
    bool lo = isfinite(s->lo), hi = isfinite(s->hi);
    double usual = strcmp(s->kind_name, "int") == 0 ? 1 : dim_from_engine(1, s->d);
    if (lo && hi)
        return 0.5 * (s->lo + s->hi);
    if (lo && usual <= s->lo)
        return 2 * fabs(s->lo) + usual;
    return usual;
}

/* Takes an unknown word for a number when its dimension fits. */
static int guess(args *a, const slot *s, const word *w, double *si, diag *d) {
    const replacement *u = w->unknown;
    char want[48], have[48];
    if (w->only_unknown && u->number && !u->wild && !dim_equal(u->d, s->d)) {
        const char *what = due(s, want);
        return diag_error(d, "%s takes %s %s, not %s %s", s->name, article(what), what, article(dim_name(u->d, have)),
                          dim_name(u->d, have));
    }
    a->guessed = true;
    *si = plausible_value(a, s);
    return SARCINA_OK;
}

/* ---- numbers ---- */

int argument_read_number(args *a, const slot *s, const word *w, double *engine, bool *percent, diag *d) {
    units_value v = {0};
    *percent = false;
    if (w->unknown) {
        int status = guess(a, s, w, &v.si, d);
        *engine = dim_to_engine(v.si, s->d);
        return status;
    }
    int status = read_value(a, s, w, &v, d);
    if (status)
        return status;
    if (v.percent) {
        char want[48];
        const char *what = due(s, want);
        if (!s->percent)
            return diag_error(d, "%s takes %s %s, not '%s' (percent)", s->name, article(what), what, w->text);
        *percent = true;
        *engine = v.si;
        return dim_is_none(s->d) ? check_range(s, w, v.si, false, d) : SARCINA_OK;
    }
    if (v.has_unit && !dim_equal(v.d, s->d))
        return wrong_dimension(s, w, v.d, d);
    double si = v.has_unit ? v.si : v.si * interp_unit(a->in, s->d);
    status = check_range(s, w, si, !v.has_unit, d);
    if (!status)
        argument_warn(a, s, w, si);
    *engine = dim_to_engine(si, s->d);
    return status;
}

int argument_read_int(args *a, const slot *s, const word *w, double *out, diag *d) {
    units_value v = {0};
    if (w->unknown)
        return guess(a, s, w, out, d);
    if (!looks_like_number(w->text))
        return diag_error(d, "%s: expected a whole number, not '%s'", s->name, w->text);
    int status = units_read(a->in->host->units, w->text, w->n, &v, d);
    if (status)
        return status;
    *out = nearbyint(v.si);
    if (v.has_unit || fabs(v.si - *out) > 1e-9 * fmax(1, fabs(v.si)) || fabs(v.si) > 9e15)
        return diag_error(d, "%s takes a whole number, not '%s'", s->name, w->text);
    return check_range(s, w, *out, false, d);
}

int argument_read_cycles(args *a, const slot *s, const word *w, args_cycles_value *out, diag *d) {
    units_value v = {0};
    *out = (args_cycles_value){.cycles = 1};
    if (w->unknown) {
        a->guessed = true;
        return SARCINA_OK;
    }
    if (!looks_like_number(w->text))
        return diag_error(d, "%s: expected a number of cycles or a time, not '%s'", s->name, w->text);
    int status = units_read(a->in->host->units, w->text, w->n, &v, d);
    if (status)
        return status;
    if (!v.has_unit) {
        double cycles = 0;
        status = argument_read_int(a, s, w, &cycles, d);
        out->cycles = status || cycles < 0 ? 0 : (uint64_t)cycles;
        if (!status && cycles < 0)
            return diag_error(d, "%s must be at least 0, not '%s'", s->name, w->text);
        return status;
    }
    dim time = DIM_TIME;
    if (!dim_equal(v.d, time)) {
        char have[48];
        size_t digits = number_length(w->text, w->n, true);
        const char *hint = units_hint(w->text + digits, w->n - digits, &time);
        return diag_error(d, "%s takes a number of cycles or a time, not %s%s%s", s->name, dim_name(v.d, have),
                          hint ? "; " : "", hint ? hint : "");
    }
    if (!(v.si > 0))
        return diag_error(d, "%s must be a time above 0, not '%s'", s->name, w->text);
    *out = (args_cycles_value){.is_time = true, .time = v.si};
    return SARCINA_OK;
}

int argument_read_quantity(args *a, const slot *s, const word *w, quantity *out, diag *d) {
    units_value v = {0};
    if (w->unknown) {
        a->guessed = true;
        *out = (quantity){1, w->unknown->d, !w->unknown->number};
        return SARCINA_OK;
    }
    if (!looks_like_number(w->text))
        return diag_error(d, "%s: expected a number, not '%s'", s->name, w->text);
    int status = units_read(a->in->host->units, w->text, w->n, &v, d);
    *out = (quantity){v.si, v.d, !v.has_unit};
    return status;
}

/* ---- distributions ---- */

/* The second number behind a law's name, or behind sd. */
static int read_part(args *a, const slot *s, reader *r, double *value, bool *percent, diag *d) {
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    if (!status)
        status = argument_read_number(a, s, &w, value, percent, d);
    if (status)
        diag_place(d, reader_word_span(r, &w));
    else
        reader_take(r, &w);
    return status;
}

/* A standard deviation: a percent is of the mean. */
static int read_deviation(args *a, const slot *s, reader *r, argument *out, diag *d) {
    slot sd = *s;
    bool percent;
    snprintf(sd.name, sizeof sd.name, "sd");
    sd.percent = true;
    sd.lo = 0;
    sd.lo_text = "0";
    sd.lo_open = sd.hi_open = false;
    sd.hi = INFINITY;
    sd.hi_text = NULL;
    int status = read_part(a, &sd, r, &out->range.b, &percent, d);
    if (!status && percent)
        out->range.b *= fabs(out->range.a);
    else if (!status && out->percent)
        status = diag_error(d, "sd of a percent is a percent");
    out->range.law = SPREAD_NORMAL;
    return status;
}

static int read_law(args *a, const slot *s, spread_law law, argument *out, reader *r, diag *d) {
    bool first = false, second = false;
    int status = read_part(a, s, r, &out->range.a, &first, d);
    out->range.law = law;
    out->percent = first;
    if (status)
        return status;
    if (law == SPREAD_NORMAL)
        return read_deviation(a, s, r, out, d);
    slot other = *s;
    if (law == SPREAD_LOGNORMAL) {
        other.d = DIM_NONE;
        other.percent = false;
        other.lo = 1;
        other.lo_text = "1";
        other.hi_text = NULL;
        other.lo_open = false;
        snprintf(other.kind_name, sizeof other.kind_name, "number");
    }
    status = read_part(a, &other, r, &out->range.b, &second, d);
    if (!status && law == SPREAD_UNIFORM && first != second)
        status = diag_error(d, "uniform takes two percents or two of %s, not one of each", s->kind_name);
    else if (!status && law == SPREAD_UNIFORM && out->range.b < out->range.a)
        status = diag_error(d, "uniform takes its lower end first");
    return status;
}

int argument_read_spread(args *a, const slot *s, argument *out, reader *r, diag *d) {
    static const struct {
        const char *name;
        spread_law law;
    } laws[] = {{"uniform", SPREAD_UNIFORM}, {"normal", SPREAD_NORMAL}, {"lognormal", SPREAD_LOGNORMAL}};
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    ptrdiff_t law = w.quote ? -1 : table_find(laws, TABLE_COUNT(laws), sizeof *laws, w.text);
    if (law >= 0) {
        reader_take(r, &w);
        return read_law(a, s, laws[law].law, out, r, d);
    }
    status = read_part(a, s, r, &out->range.a, &out->percent, d);
    out->range.law = SPREAD_FIXED;
    if (!status)
        status = reader_peek(r, &w, d);
    if (!status && w.text && !w.quote && strcmp(w.text, "sd") == 0) {
        reader_take(r, &w);
        status = read_deviation(a, s, r, out, d);
    }
    out->number = out->range.a;
    return status;
}

/* ---- relaxation ---- */

static slot part_of(const slot *s, const char *name, const char *kind, dim d) {
    slot part = {.kind = SLOT_NUMBER, .d = d, .lo_open = true, .lo_text = "0", .lo = 0, .hi = INFINITY};
    snprintf(part.name, sizeof part.name, "%s", name ? name : s->name);
    snprintf(part.kind_name, sizeof part.kind_name, "%s", kind);
    return part;
}

int argument_read_relaxation(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    bool percent;
    int status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    if (strcmp(w.text, "to") != 0) {
        slot time = part_of(s, NULL, "time", DIM_TIME);
        return read_part(a, &time, r, &out->time, &percent, d);
    }
    reader_take(r, &w);
    slot force = part_of(s, "to", "force", DIM_FORCE), within = part_of(s, "within", "time", DIM_TIME);
    out->time = INFINITY;
    status = read_part(a, &force, r, &out->force, &percent, d);
    if (!status)
        status = reader_peek(r, &w, d);
    if (status || !w.text || strcmp(w.text, "within") != 0)
        return status;
    reader_take(r, &w);
    return read_part(a, &within, r, &out->time, &percent, d);
}
