/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

typedef struct cached {
    char *text;
    unit value;
} cached;

struct units {
    ut_system *system;
    cached *cache;
    size_t count, capacity;
};

units *units_create(diag *d) {
    ut_set_error_message_handler(ut_ignore);
    ut_system *system = ut_read_xml(NULL);
    if (!system) {
        diag_error(d, "the unit database of UDUNITS-2 cannot be read (package libudunits2-data)");
        return NULL;
    }
    units *u = alloc_zeroed(1, sizeof *u);
    u->system = system;
    return u;
}

void units_free(units *u) {
    if (!u)
        return;
    for (size_t i = 0; i < u->count; i++)
        free(u->cache[i].text);
    free(u->cache);
    ut_free_system(u->system);
    free(u);
}

/* ---- spelling ---- */

static const struct {
    const char *utf8, *ascii;
} spellings[] = {
    {"\xc2\xb5", "u"},     {"\xce\xbc", "u"},     {"\xc2\xb7", "."},     {"\xe2\x81\xbb", "-"}, {"\xc2\xb9", "1"},
    {"\xc2\xb2", "2"},     {"\xc2\xb3", "3"},     {"\xe2\x81\xb0", "0"}, {"\xe2\x81\xb4", "4"}, {"\xe2\x81\xb5", "5"},
    {"\xe2\x81\xb6", "6"}, {"\xe2\x81\xb7", "7"}, {"\xe2\x81\xb8", "8"}, {"\xe2\x81\xb9", "9"}, {"\xc2\xb0", "degree"},
};

/* Copies text to out with those characters in ASCII. */
static void to_ascii(const char *text, size_t n, char *out, size_t room) {
    size_t used = 0;
    for (size_t i = 0; i < n && used + 8 < room;) {
        size_t k = 0;
        while (k < TABLE_COUNT(spellings)) {
            size_t length = strlen(spellings[k].utf8);
            if (n - i >= length && memcmp(text + i, spellings[k].utf8, length) == 0)
                break;
            k++;
        }
        if (k == TABLE_COUNT(spellings)) {
            out[used++] = text[i++];
            continue;
        }
        used += strlen(strcpy(out + used, spellings[k].ascii));
        i += strlen(spellings[k].utf8);
    }
    out[used] = '\0';
}

/* What UDUNITS calls otherwise. */
static const char *factor_name(const char *name) {
    return strcmp(name, "deg") == 0 ? "degree" : name;
}

/* ---- what a unit measures ---- */

typedef struct measured {
    dim d;
    double scale;
    bool ok;
} measured;

static ut_status visit_basic(const ut_unit *basic, void *arg) {
    measured *m = arg;
    const char *symbol = ut_get_symbol(basic, UT_ASCII);
    if (symbol && strcmp(symbol, "m") == 0)
        m->d = DIM_LENGTH;
    else if (symbol && strcmp(symbol, "kg") == 0)
        m->d = DIM_MASS;
    else if (symbol && strcmp(symbol, "s") == 0)
        m->d = DIM_TIME;
    else if (!symbol || strcmp(symbol, "rad") != 0)
        m->ok = false;
    return UT_SUCCESS;
}

static ut_status visit_product(const ut_unit *product, int count, const ut_unit *const *basics, const int *powers,
                               void *arg) {
    (void)product;
    measured *m = arg;
    dim total = DIM_NONE;
    for (int i = 0; i < count; i++) {
        measured one = {DIM_NONE, 1, true};
        visit_basic(basics[i], &one);
        m->ok = m->ok && one.ok && abs(powers[i]) < 100;
        total.length = (int16_t)(total.length + one.d.length * powers[i]);
        total.mass = (int16_t)(total.mass + one.d.mass * powers[i]);
        total.time = (int16_t)(total.time + one.d.time * powers[i]);
    }
    m->d = total;
    return UT_SUCCESS;
}

static ut_status visit_galilean(const ut_unit *galilean, double scale, const ut_unit *underlying, double offset,
                                void *arg);
static ut_status visit_timestamp(const ut_unit *timestamp, const ut_unit *of, double origin, void *arg) {
    (void)timestamp, (void)of, (void)origin;
    ((measured *)arg)->ok = false;
    return UT_SUCCESS;
}

static ut_status visit_logarithmic(const ut_unit *logarithmic, double base, const ut_unit *reference, void *arg) {
    (void)logarithmic, (void)base, (void)reference;
    ((measured *)arg)->ok = false;
    return UT_SUCCESS;
}

static const ut_visitor visitor = {visit_basic, visit_product, visit_galilean, visit_timestamp, visit_logarithmic};

static ut_status visit_galilean(const ut_unit *galilean, double scale, const ut_unit *underlying, double offset,
                                void *arg) {
    (void)galilean;
    measured *m = arg;
    ut_accept_visitor(underlying, &visitor, m);
    m->scale *= scale;
    m->ok = m->ok && offset == 0;
    return UT_SUCCESS;
}

/* How to apply the scale with one rounding where that can be. */
static unit unit_of(const measured *m) {
    unit u = {UNIT_MULTIPLY, 0, m->scale, m->d};
    int power = (int)lround(log10(m->scale));
    double whole = nearbyint(1 / m->scale);
    if (fabs(m->scale / pow(10, power) - 1) < 1e-12) {
        u.how = UNIT_POWER;
        u.power = power;
    } else if (m->scale < 1 && fabs(whole * m->scale - 1) < 1e-12) {
        u.how = UNIT_DIVIDE;
        u.factor = whole;
    }
    return u;
}

static int parse_with_udunits(units *u, const char *text, unit *out) {
    ut_unit *parsed = ut_parse(u->system, text, UT_ASCII);
    if (!parsed)
        return SARCINA_ERROR;
    measured m = {DIM_NONE, 1, true};
    ut_accept_visitor(parsed, &visitor, &m);
    ut_free(parsed);
    if (!m.ok || !(m.scale > 0) || !isfinite(m.scale))
        return SARCINA_ERROR;
    *out = unit_of(&m);
    return SARCINA_OK;
}

/* ---- grammar ---- */

/* Reads one factor at text into the expression for UDUNITS; returns the characters read, 0: no factor. */
static size_t read_factor(units *u, const char *text, char *out, size_t room) {
    size_t letters = 0, i;
    while (isalpha((unsigned char)text[letters]))
        letters++;
    if (letters == 0 || letters > 31)
        return 0;
    char name[32];
    memcpy(name, text, letters);
    name[letters] = '\0';
    unit known;
    if (parse_with_udunits(u, factor_name(name), &known) != SARCINA_OK)
        return 0;
    i = letters;
    size_t mark = i + (text[i] == '^');
    size_t digit = mark + (text[mark] == '-');
    size_t end = digit;
    while (isdigit((unsigned char)text[end]))
        end++;
    if (end == digit && digit != i)
        return 0; /* "^" or "-" without digits */
    if (end - digit > 2 || strlen(factor_name(name)) + (end - mark) + 1 > room)
        return 0;
    strcpy(out, factor_name(name));
    strncat(out, text + mark, end - mark);
    return end;
}

/* Translates a whole unit for UDUNITS; false: not a unit. */
static bool translate(units *u, const char *text, char *out, size_t room) {
    size_t used = 0;
    if (*text == '/')
        used = (size_t)(stpcpy(out, "1/") - out), text++;
    for (;;) {
        size_t n = read_factor(u, text, out + used, room - used - 2);
        if (n == 0)
            return false;
        text += n;
        used += strlen(out + used);
        if (*text == '\0')
            return true;
        if (*text != '.' && *text != '/')
            return false;
        out[used++] = *text++;
        out[used] = '\0';
        if (used + 40 > room)
            return false;
    }
}

static unit *cache_find(units *u, const char *text) {
    ptrdiff_t i = table_find(u->cache, u->count, sizeof *u->cache, text);
    return i < 0 ? NULL : &u->cache[i].value;
}

/* Units people write, for suggestions and completion. */
static const struct {
    const char *name, *dimension;
} usual[] = {
    {"um", "length"},
    {"nm", "length"},
    {"mm", "length"},
    {"m", "length"},
    {"um2", "area"},
    {"um3", "volume"},
    {"s", "time"},
    {"ms", "time"},
    {"min", "time"},
    {"h", "time"},
    {"day", "time"},
    {"pg", "mass"},
    {"fg", "mass"},
    {"kg", "mass"},
    {"g", "mass"},
    {"kg/m3", "density"},
    {"g/l", "density"},
    {"mg/l", "density"},
    {"pg/um3", "density"},
    {"/h", "rate"},
    {"/min", "rate"},
    {"/s", "rate"},
    {"/m", "wavenumber"},
    {"/um", "wavenumber"},
    {"N", "force"},
    {"pN", "force"},
    {"N/m", "stiffness"},
    {"pN/um", "stiffness"},
    {"N.m", "energy"},
    {"J", "energy"},
    {"N.m2", "energylength"},
    {"N.s/m", "drag"},
    {"kg/s", "drag"},
    {"um/s", "velocity"},
    {"m/s2", "acceleration"},
    {"degree", "angle"},
    {"rad", "angle"},
};

static int not_a_unit(const char *text, size_t n, diag *d) {
    diag_error(d, "'%.*s' is not a unit", (int)n, text);
    const char *hint = units_hint(text, n, NULL);
    char typed[64];
    to_ascii(text, n < 48 ? n : 48, typed, sizeof typed);
    const char *nearest = table_nearest(usual, TABLE_COUNT(usual), sizeof *usual, typed);
    if (hint)
        diag_help(d, "%s", hint);
    else if (nearest)
        diag_help(d, "did you mean '%s'?", nearest);
    return SARCINA_ERROR;
}

int units_find(units *u, const char *text, size_t n, unit *out, diag *d) {
    char ascii[64], expression[128];
    if (n == 1 && *text == '%') {
        *out = (unit){UNIT_PERCENT, -2, 0.01, DIM_NONE};
        return SARCINA_OK;
    }
    if (n == 0 || n > 48)
        return not_a_unit(text, n, d);
    to_ascii(text, n, ascii, sizeof ascii);
    unit *known = cache_find(u, ascii);
    if (known) {
        *out = *known;
        return SARCINA_OK;
    }
    if (!translate(u, ascii, expression, sizeof expression) || parse_with_udunits(u, expression, out) != SARCINA_OK)
        return not_a_unit(text, n, d);
    u->cache = alloc_grow(u->cache, &u->capacity, u->count + 1, sizeof *u->cache);
    u->cache[u->count++] = (cached){alloc_copy(ascii), *out};
    return SARCINA_OK;
}

double units_convert(const unit *of, const char *number, size_t n) {
    switch (of->how) {
    case UNIT_POWER:
    case UNIT_PERCENT:
        return number_read(number, n, of->power);
    case UNIT_MULTIPLY:
        return number_read(number, n, 0) * of->factor;
    case UNIT_DIVIDE:
        break;
    }
    return number_read(number, n, 0) / of->factor;
}

/* Whether the mantissa holds a digit other than 0: such a number may not come out as 0. */
static bool is_nonzero(const char *text, size_t n) {
    for (size_t i = 0; i < n && text[i] != 'e' && text[i] != 'E'; i++)
        if (text[i] >= '1' && text[i] <= '9')
            return true;
    return false;
}

int units_read(units *u, const char *text, size_t n, units_value *out, diag *d) {
    size_t digits = number_length(text, n, true);
    if (digits == 0 || (n > digits && *text == '0' && (text[1] == 'x' || text[1] == 'X')))
        return diag_error(d, "'%.*s' is not a number", (int)n, text);
    unit of = {UNIT_POWER, 0, 1, DIM_NONE};
    *out = (units_value){.has_unit = n > digits};
    if (n > digits) {
        if (units_find(u, text + digits, n - digits, &of, d) != SARCINA_OK) {
            if (text[digits] == ',')
                diag_help(d, "the decimal sign is a point");
            return SARCINA_ERROR;
        }
    }
    out->percent = of.how == UNIT_PERCENT;
    out->d = of.d;
    out->si = units_convert(&of, text, digits);
    if (!isfinite(out->si))
        return diag_error(d, "'%.*s' is not finite", (int)n, text);
    if (out->si == 0 && is_nonzero(text, digits))
        return diag_error(d, "'%.*s' is too small for a number", (int)n, text);
    return SARCINA_OK;
}

bool units_is_name(units *u, const char *name) {
    ut_unit *parsed = ut_parse(u->system, name, UT_ASCII);
    ut_free(parsed);
    return parsed != NULL;
}

/* ---- hints ---- */

static const struct {
    const char *typed, *hint;
} hints[] = {
    {"M", "metres are m, minutes are min"},
    {"mins", "minutes are min"},
    {"hrs", "hours are h"},
    {"secs", "seconds are s"},
    {"sec", "seconds are s"},
    {"microns", "micrometres are um"},
    {"°C", "temperatures are not used here"},
};

const char *units_hint(const char *text, size_t n, const dim *expected) {
    char typed[64];
    to_ascii(text, n < 48 ? n : 48, typed, sizeof typed);
    if (expected && dim_equal(*expected, DIM_TIME) && strcmp(typed, "m") == 0)
        return "m is metre; minutes are min";
    if (expected)
        return NULL;
    for (size_t i = 0; i < TABLE_COUNT(hints); i++)
        if (strcmp(hints[i].typed, typed) == 0)
            return hints[i].hint;
    if (strchr(typed, '*'))
        return "a product of units is written with a point: N.s/m";
    return NULL;
}

size_t units_usual(dim d, const char *names[], size_t room) {
    size_t n = 0;
    dim of;
    for (size_t i = 0; i < TABLE_COUNT(usual) && n < room; i++)
        if (dim_by_name(usual[i].dimension, &of) && dim_equal(of, d))
            names[n++] = usual[i].name;
    return n;
}
