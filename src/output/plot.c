/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Colours are Okabe and Ito's (2008), which are told apart by everybody. Texts are in gnuplot's single quotes, in which
 * nothing is special but a quote, and `noenhanced`, so that a name with _ or ^ reads as it is. */
#include "output/plot.h"

#include "base/path.h"
#include "base/process.h"
#include "output/field.h"
#include "output/readable.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *end, *terminal;
} kinds[] = {
    {".svg", "svg size 480,360 font 'Helvetica,13' linewidth 1.2 noenhanced background rgb 'white'"},
    {".png", "pngcairo size 1440,1080 font 'Helvetica,30' linewidth 2.5 noenhanced"},
    {".pdf", "pdfcairo size 8cm,6cm font 'Helvetica,9' linewidth 1 noenhanced"},
};

static const char *const colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
enum { COLORS = sizeof colors / sizeof *colors };

int plot_ready(diag *d) {
    return process_check("gnuplot", "gnuplot-nox", d);
}

const char *plot_terminal(const char *path) {
    size_t n = strlen(path);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (n >= 4 && strcmp(path + n - 4, kinds[i].end) == 0)
            return kinds[i].terminal;
    return NULL;
}

static void put_quoted(FILE *out, const char *text) {
    fputc('\'', out);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : *text == '\n' ? " " : (const char[]){*text, '\0'}, out);
    fputc('\'', out);
}

static void put_label(FILE *out, const char *axis, const char *name, dim d) {
    char text[200], unit[48];
    readable_unit(d, unit);
    bool micro = unit[0] == 'u' && unit[1] == 'm';
    snprintf(text, sizeof text, unit[0] ? "%.100s%s(%s%.60s)" : "%.100s", name, name[0] ? " " : "",
             micro ? "\u00b5" : "", unit + micro);
    fprintf(out, "set %s ", axis);
    put_quoted(out, text);
    fputc('\n', out);
}

/* Of the series on one side: its own name where it is alone; the legend has them otherwise. */
static void put_side(FILE *out, const char *axis, const plot_series *y, size_t count, bool right) {
    const plot_series *first = NULL;
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
        if (!dim_equal(y[i].d, y[0].d) == right) {
            first = first ? first : &y[i];
            n++;
        }
    if (first)
        put_label(out, axis, n == 1 ? first->name : "", first->d);
}

static void put_number(FILE *out, const plot_series *s, size_t row) {
    char digits[FIELD_ROOM], unit[48];
    double divisor = readable_unit(s->d, unit);
    fprintf(out, "%s ", field_number(s->values[row] / divisor, digits));
}

static void put_data(FILE *out, const plot_series *x, const plot_series *y, size_t count, size_t rows) {
    fputs("$data << EOD\n", out);
    for (size_t row = 0; row < rows; row++) {
        put_number(out, x, row);
        for (size_t i = 0; i < count; i++)
            put_number(out, &y[i], row);
        fputc('\n', out);
    }
    fputs("EOD\n", out);
}

/* Numbers that are all the same have no range of their own. */
static void put_range(FILE *out, const char *axis, const plot_series *all, size_t count, size_t rows, dim d) {
    double low = INFINITY, high = -INFINITY;
    char unit[48];
    double divisor = readable_unit(d, unit);
    for (size_t i = 0; i < count; i++)
        for (size_t row = 0; row < rows; row++)
            if (dim_equal(all[i].d, d)) {
                low = fmin(low, all[i].values[row] / divisor);
                high = fmax(high, all[i].values[row] / divisor);
            }
    double room = low == 0 ? 1 : 0.1 * fabs(low);
    if (low == high)
        fprintf(out, "set %s [%g:%g]\n", axis, low - room, high + room);
}

static bool has_right_side(const plot_series *y, size_t count) {
    for (size_t i = 1; i < count; i++)
        if (!dim_equal(y[i].d, y[0].d))
            return true;
    return false;
}

char *plot_script(const plot_series *x, const plot_series *y, size_t count, size_t rows, const char *path) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    bool right = has_right_side(y, count);
    fprintf(out, "set encoding utf8\nset terminal %s\nset output ", plot_terminal(path));
    put_quoted(out, path);
    fputs("\nset datafile missing 'nan'\nset border 3 linewidth 1\nset tics nomirror out scale 0.6\n"
          "set key above left horizontal reverse Left samplen 1.5 width 1 noautotitle\nset offsets 0, 0, graph 0.05, "
          "graph 0.02\n",
          out);
    if (right)
        fputs("set border 11\nset y2tics out scale 0.6\n", out);
    put_label(out, "xlabel", x->name, x->d);
    put_range(out, "xrange", x, 1, rows, x->d);
    put_range(out, "yrange", y, count, rows, y[0].d);
    put_side(out, "ylabel", y, count, false);
    put_side(out, "y2label", y, count, true);
    put_data(out, x, y, count, rows);
    fputs("plot", out);
    for (size_t i = 0; i < count; i++) {
        bool on_right = !dim_equal(y[i].d, y[0].d);
        fprintf(out, "%s $data using 1:%zu axes x1y%d with lines linewidth 2 linecolor rgb '%s' title ", i ? "," : "",
                i + 2, on_right ? 2 : 1, colors[i % COLORS]);
        put_quoted(out, count > 1 ? y[i].name : "");
    }
    fputc('\n', out);
    fclose(out);
    return text;
}

int plot_draw(const plot_series *x, const plot_series *y, size_t count, size_t rows, const char *path, diag *d) {
    static const char *const words[] = {"gnuplot", "-", NULL};
    if (path_make_folders(path, d))
        return SARCINA_ERROR;
    process *gnuplot = process_open(words, d);
    if (!gnuplot)
        return SARCINA_ERROR;
    char *script = plot_script(x, y, count, rows, path);
    int status = process_write(gnuplot, script, strlen(script), d);
    free(script);
    return process_close(gnuplot, status ? NULL : d) ? SARCINA_ERROR : status;
}
