/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/thermo.h"

#include "base/alloc.h"
#include "output/field.h"
#include "output/stream.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { THERMO_WIDTH = 12, THERMO_ROOM = 400 };

typedef struct thermo_cell {
    output_column column;
    double unit;     /* on the screen the number is divided by it */
    char suffix[50]; /* "[m]" or "" */
    char *format;    /* NULL: the default */
    double last;     /* number of the row written last, SI */
    double *history; /* numbers of all rows, SI */
    size_t capacity;
} thermo_cell;

struct thermo {
    thermo_cell *cells;
    size_t count;
    stream *file;
    uint64_t *steps; /* of the rows */
    size_t rows, steps_capacity;
};

thermo *thermo_create(void) {
    return alloc_zeroed(1, sizeof(thermo));
}

static void release_columns(thermo *t) {
    for (size_t i = 0; i < t->count; i++) {
        output_column *c = &t->cells[i].column;
        if (c->release)
            c->release(c->self);
        free(c->name);
        free(t->cells[i].format);
        free(t->cells[i].history);
    }
    free(t->cells);
    free(t->steps);
    t->steps = NULL;
    t->rows = t->steps_capacity = 0;
    t->cells = NULL;
    t->count = 0;
}

void thermo_free(thermo *t) {
    if (!t)
        return;
    release_columns(t);
    stream_free(t->file);
    free(t);
}

static int find_column(const thermo *t, const char *name) {
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->cells[i].column.name, name) == 0)
            return (int)i;
    return -1;
}

/* A new file object of the same name, not yet open. */
static void renew_file(thermo *t, const char *path) {
    char *kept = path ? alloc_copy(path) : NULL;
    int step = find_column(t, "step");
    stream_free(t->file);
    t->file = kept ? stream_create(kept, STREAM_CSV, step < 0 ? 0 : step) : NULL;
    free(kept);
}

void thermo_set_columns(thermo *t, const output_column *columns, size_t n) {
    release_columns(t);
    t->cells = alloc_zeroed(n, sizeof *t->cells);
    t->count = n;
    for (size_t i = 0; i < n; i++)
        t->cells[i] = (thermo_cell){.column = columns[i], .unit = 1, .last = NAN};
    if (t->file)
        renew_file(t, stream_path(t->file));
}

size_t thermo_count(const thermo *t) {
    return t->count;
}

const output_column *thermo_column(const thermo *t, size_t i) {
    return &t->cells[i].column;
}

void thermo_set_unit(thermo *t, size_t i, double unit) {
    t->cells[i].unit = unit;
}

void thermo_set_suffix(thermo *t, size_t i, const char *suffix) {
    if (suffix[0])
        snprintf(t->cells[i].suffix, sizeof t->cells[i].suffix, "[%s]", suffix);
    else
        t->cells[i].suffix[0] = '\0';
}

/* Whether the format is one conversion of a double or a rounded whole number, and nothing else. */
static bool is_number_format(const char *f) {
    if (*f++ != '%')
        return false;
    f += strspn(f, "-+ #0");
    size_t width = strspn(f, "0123456789");
    f += width;
    size_t digits = 0;
    if (*f == '.') {
        digits = strspn(f + 1, "0123456789");
        f += 1 + digits;
    }
    return width <= 2 && digits <= 2 && *f && strchr("dieEfFgG", *f) && f[1] == '\0';
}

int thermo_set_format(thermo *t, const char *column, const char *format, diag *d) {
    int i = find_column(t, column);
    if (i < 0)
        return diag_error(d, "the thermo table has no column '%s'", column);
    if (!is_number_format(format))
        return diag_error(d, "'%s' is not one number format such as %%.3f", format);
    free(t->cells[i].format);
    t->cells[i].format = alloc_copy(format);
    return SARCINA_OK;
}

void thermo_set_file(thermo *t, const char *path) {
    renew_file(t, path);
}

const char *thermo_file(const thermo *t) {
    return t->file ? stream_path(t->file) : NULL;
}

int thermo_open(thermo *t, diag *d) {
    int status = t->file ? stream_open(t->file, d) : SARCINA_OK;
    if (status || !t->file || !stream_is_empty(t->file))
        return status;
    FILE *f = stream_file(t->file);
    bool adds_step = find_column(t, "step") < 0;
    if (adds_step)
        fputs("step", f);
    for (size_t i = 0; i < t->count; i++) {
        if (i || adds_step)
            fputc(',', f);
        field_put_csv(f, t->cells[i].column.name);
        fputs(t->cells[i].suffix, f);
    }
    fputc('\n', f);
    return stream_flush(t->file, d);
}

/* LAMMPS's headings are capitalised, and programs look for a line that begins with "Step": plain words become so. */
static void heading(const thermo_cell *c, char *out, size_t room) {
    snprintf(out, room, "%s%s", c->column.name, c->suffix);
    char *to = out; /* without the blanks of a formula: a heading is one word, as its column is */
    for (const char *from = out; *from; from++)
        if (*from != ' ')
            *to++ = *from;
    *to = '\0';
    if (c->column.name[strspn(c->column.name, "abcdefghijklmnopqrstuvwxyz_")] == '\0')
        out[0] = (char)toupper((unsigned char)out[0]);
}

static int column_width(const thermo_cell *c) {
    char name[THERMO_ROOM];
    heading(c, name, sizeof name);
    size_t n = strlen(name);
    return n > THERMO_WIDTH ? (int)n : THERMO_WIDTH;
}

void thermo_header(const thermo *t, thermo_put *put, void *self) {
    char *text = NULL, name[THERMO_ROOM];
    size_t size;
    FILE *line = open_memstream(&text, &size);
    for (size_t i = 0; i < t->count; i++) {
        heading(&t->cells[i], name, sizeof name);
        fprintf(line, "%s%*s", i ? " " : "", column_width(&t->cells[i]), name);
    }
    fclose(line);
    put(self, text);
    free(text);
}

/* One number on the screen, unpadded. */
static void screen_number(const thermo_cell *c, double si, char *out, size_t room) {
    double x = si / c->unit;
    if (isnan(x)) {
        snprintf(out, room, "nan");
        return;
    }
    if (!c->format) {
        bool whole = dim_is_none(c->column.d) && x == rint(x) && fabs(x) < 1e15;
        snprintf(out, room, whole ? "%.0f" : "%.8g", x);
        return;
    }
    /* the format has been checked by is_number_format */
    size_t n = strlen(c->format);
    if (c->format[n - 1] == 'd' || c->format[n - 1] == 'i') {
        char *wide = alloc_format("%.*slld", (int)(n - 1), c->format);
        snprintf(out, room, wide, llround(x));
        free(wide);
    } else {
        snprintf(out, room, c->format, x);
    }
}

/* Column c of the present row: padded on the screen, with all its digits in the file. */
static int put_cell(thermo_cell *c, FILE *screen, FILE *row, diag *d) {
    char text[THERMO_ROOM], digits[FIELD_ROOM];
    int status;
    if (c->column.is_text) {
        status = c->column.text(c->column.self, 0, text, d);
        if (!status)
            field_put_csv(row, text);
    } else {
        double si = NAN;
        status = c->column.number(c->column.self, 0, &si, d);
        c->last = si;
        screen_number(c, si, text, sizeof text);
        fputs(field_number(si, digits), row);
    }
    if (!status)
        fprintf(screen, "%*s", column_width(c), text);
    return status;
}

static int put_cells(thermo *t, uint64_t step, FILE *screen, FILE *row, diag *d) {
    bool adds_step = find_column(t, "step") < 0;
    if (adds_step)
        fprintf(row, "%" PRIu64, step);
    for (size_t i = 0; i < t->count; i++) {
        if (i)
            fputc(' ', screen);
        if (i || adds_step)
            fputc(',', row);
        if (put_cell(&t->cells[i], screen, row, d))
            return SARCINA_ERROR;
    }
    fputc('\n', row);
    return SARCINA_OK;
}

static int write_row(thermo *t, uint64_t step, const char *row, diag *d) {
    int status = thermo_open(t, d);
    if (status || !t->file || stream_has(t->file, step))
        return status;
    fputs(row, stream_file(t->file));
    return stream_end(t->file, step, d);
}

/* Keeps the row; of a step that is there already, or that the scene has gone back before, what was there goes. */
static void remember(thermo *t, uint64_t step) {
    while (t->rows > 0 && t->steps[t->rows - 1] >= step)
        t->rows--;
    t->steps = alloc_grow(t->steps, &t->steps_capacity, t->rows + 1, sizeof *t->steps);
    t->steps[t->rows] = step;
    for (size_t i = 0; i < t->count; i++) {
        thermo_cell *c = &t->cells[i];
        c->history = alloc_grow(c->history, &c->capacity, t->rows + 1, sizeof *c->history);
        c->history[t->rows] = c->column.is_text ? (double)NAN : c->last;
    }
    t->rows++;
}

size_t thermo_rows(const thermo *t) {
    return t->rows;
}

const double *thermo_history(const thermo *t, size_t i) {
    return t->cells[i].history;
}

char *thermo_save(const thermo *t, size_t *n) {
    const uint64_t head[2] = {t->count, t->rows};
    size_t column = t->rows * sizeof(double);
    *n = sizeof head + t->rows * sizeof *t->steps + t->count * column;
    char *bytes = alloc_zeroed(*n, 1), *at = bytes;
    memcpy(at, head, sizeof head);
    at += sizeof head;
    if (t->rows)
        memcpy(at, t->steps, t->rows * sizeof *t->steps);
    at += t->rows * sizeof *t->steps;
    for (size_t i = 0; i < t->count && t->rows; i++, at += column)
        memcpy(at, t->cells[i].history, column);
    return bytes;
}

bool thermo_load(thermo *t, const char *bytes, size_t n) {
    uint64_t head[2];
    if (n < sizeof head)
        return false;
    memcpy(head, bytes, sizeof head);
    size_t rows = (size_t)head[1], column = rows * sizeof(double);
    if (head[0] != t->count || n != sizeof head + rows * sizeof *t->steps + t->count * column)
        return false;
    const char *at = bytes + sizeof head;
    t->steps = alloc_grow(t->steps, &t->steps_capacity, rows + 1, sizeof *t->steps);
    memcpy(t->steps, at, rows * sizeof *t->steps);
    at += rows * sizeof *t->steps;
    for (size_t i = 0; i < t->count; i++, at += column) {
        thermo_cell *c = &t->cells[i];
        c->history = alloc_grow(c->history, &c->capacity, rows + 1, sizeof *c->history);
        memcpy(c->history, at, column);
    }
    t->rows = rows;
    return true;
}

int thermo_row(thermo *t, uint64_t step, thermo_put *put, void *self, diag *d) {
    char *screen_text = NULL, *row_text = NULL;
    size_t screen_size, row_size;
    FILE *screen = open_memstream(&screen_text, &screen_size), *row = open_memstream(&row_text, &row_size);
    int status = put_cells(t, step, screen, row, d);
    fclose(screen);
    fclose(row);
    if (!status) {
        remember(t, step);
        put(self, screen_text);
        status = write_row(t, step, row_text, d);
    }
    free(screen_text);
    free(row_text);
    return status;
}

int thermo_rewind(thermo *t, uint64_t step, diag *d) {
    return t->file ? stream_rewind(t->file, step, d) : SARCINA_OK;
}

double thermo_last(const thermo *t, size_t i) {
    return t->cells[i].last;
}
