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
    {".png", "pngcairo size 1440,1080 font 'Helvetica,30' linewidth 2.5 pointscale 2.5 noenhanced"},
    {".pdf", "pdfcairo size 8cm,6cm font 'Helvetica,9' linewidth 1 noenhanced"},
};

static const char *const colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
enum { COLORS = sizeof colors / sizeof *colors };

/* gnuplot's numbers of filled marks: when the colours begin again, another. */
static const int marks[] = {7, 5, 9, 13};
enum { MARKS = sizeof marks / sizeof *marks };

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

static void put_given_label(FILE *out, const char *axis, const char *text) {
    fprintf(out, "set %s ", axis);
    put_quoted(out, text);
    fputc('\n', out);
}

static bool is_right(const plot_diagram *p, size_t i) {
    return !dim_equal(p->curves[i].d, p->curves[0].d);
}

static bool has_right_side(const plot_diagram *p) {
    for (size_t i = 1; i < p->count; i++)
        if (is_right(p, i))
            return true;
    return false;
}

/* Of the curves on one side: their name where they share it; the legend has them otherwise. */
static void put_side(FILE *out, const char *axis, const plot_diagram *p, bool right) {
    const plot_curve *first = NULL;
    bool same = true;
    for (size_t i = 0; i < p->count; i++)
        if (is_right(p, i) == right) {
            first = first ? first : &p->curves[i];
            same = same && strcmp(first->axis, p->curves[i].axis) == 0;
        }
    if (first)
        put_label(out, axis, same ? first->axis : "", first->d);
}

static void put_labels(FILE *out, const plot_diagram *p) {
    if (p->x_label)
        put_given_label(out, "xlabel", p->x_label);
    else
        put_label(out, "xlabel", p->x_name, p->x_dim);
    if (p->y_label)
        put_given_label(out, "ylabel", p->y_label);
    else
        put_side(out, "ylabel", p, false);
    put_side(out, "y2label", p, true);
}

static void put_number(FILE *out, const double *values, size_t row, double divisor) {
    char digits[FIELD_ROOM];
    if (values)
        fprintf(out, "%s ", field_number(values[row] / divisor, digits));
}

/* A block a curve: x, y, the band, the end of the box. */
static void put_data(FILE *out, const plot_diagram *p) {
    char unit[48];
    double x_divisor = readable_unit(p->x_dim, unit);
    for (size_t i = 0; i < p->count; i++) {
        const plot_curve *c = &p->curves[i];
        double divisor = readable_unit(c->d, unit);
        fprintf(out, "$data%zu << EOD\n", i + 1);
        for (size_t row = 0; row < c->n; row++) {
            put_number(out, c->x, row, x_divisor);
            put_number(out, c->y, row, divisor);
            put_number(out, c->low, row, divisor);
            put_number(out, c->high, row, divisor);
            put_number(out, c->x_end, row, x_divisor);
            fputc('\n', out);
        }
        fputs("EOD\n", out);
    }
}

/* Least and largest of x, or of all that stands on one side. */
static void find_range(const plot_diagram *p, bool of_x, bool right, double range[2]) {
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (size_t i = 0; i < p->count; i++) {
        const plot_curve *c = &p->curves[i];
        const double *all[] = {of_x ? c->x : c->y, of_x ? c->x_end : c->low, of_x ? NULL : c->high};
        for (size_t k = 0; k < 3 && (of_x || is_right(p, i) == right); k++)
            for (size_t row = 0; row < c->n && all[k]; row++) {
                range[0] = fmin(range[0], all[k][row]);
                range[1] = fmax(range[1], all[k][row]);
            }
    }
}

/* Numbers that are all the same have no range of their own. */
static void put_range(FILE *out, const char *axis, const double range[2], dim d) {
    char unit[48];
    double low = range[0] / readable_unit(d, unit), room = low == 0 ? 1 : 0.1 * fabs(low);
    if (range[0] == range[1])
        fprintf(out, "set %s [%g:%g]\n", axis, low - room, low + room);
}

/* Logarithmic, which knows no offsets: room for the marks at both ends. */
static void put_log_range(FILE *out, const double range[2], dim d) {
    static const double room = 1.15;
    char unit[48];
    double divisor = readable_unit(d, unit);
    if (range[0] > 0 && isfinite(range[1]))
        fprintf(out, "set xrange [%g:%g]\n", range[0] / divisor / room, range[1] / divisor * room);
}

/* gnuplot labels the powers of ten alone, of which a short axis has one or none: there, 1, 2 and 5 of each. */
static void put_log_tics(FILE *out, const char *axis, const double range[2], dim d) {
    char unit[48];
    double divisor = readable_unit(d, unit);
    if (!(range[0] > 0) || !isfinite(range[1]) || floor(log10(range[1] / divisor)) > ceil(log10(range[0] / divisor)))
        return;
    int first = (int)floor(log10(range[0] / divisor)), last = (int)ceil(log10(range[1] / divisor));
    fprintf(out, "set %s (", axis);
    for (int power = first; power <= last; power++)
        for (int digit = 1; digit <= 9; digit++) {
            bool named = digit == 1 || digit == 2 || digit == 5;
            fprintf(out, "%s%s%de%d%s", power == first && digit == 1 ? "" : ", ", named ? "" : "'' ", digit, power,
                    named ? "" : " 1");
        }
    fputs(")\n", out);
}

static void put_ranges(FILE *out, const plot_diagram *p) {
    double range[2];
    find_range(p, true, false, range);
    put_range(out, "xrange", range, p->x_dim);
    if (p->log_x)
        put_log_tics(out, "xtics", range, p->x_dim);
    if (p->shape == PLOT_POINTS && p->log_x)
        put_log_range(out, range, p->x_dim);
    find_range(p, false, false, range);
    put_range(out, "yrange", range, p->curves[0].d);
    if (p->log_y)
        put_log_tics(out, "ytics", range, p->curves[0].d);
    find_range(p, false, true, range);
    for (size_t i = 0; i < p->count; i++)
        if (is_right(p, i)) {
            put_range(out, "y2range", range, p->curves[i].d);
            return;
        }
}

/* As many columns as their names leave room for. */
static void put_key(FILE *out, const plot_diagram *p) {
    size_t longest = 0;
    for (size_t i = 0; i < p->count; i++)
        longest = strlen(p->curves[i].name) > longest ? strlen(p->curves[i].name) : longest;
    size_t columns = longest > (has_right_side(p) ? 18 : 32) ? 1 : longest > 14 ? 2 : 3;
    fprintf(out, "set key above left horizontal reverse Left samplen 1.5 width 1 maxcols %zu noautotitle\n", columns);
}

static void put_axes(FILE *out, const plot_diagram *p) {
    if (p->log_x)
        fputs("set logscale x\nset autoscale xfix\n", out);
    if (p->log_y)
        fputs("set logscale y\nset format y '%g'\n", out);
    else
        fprintf(out, "set offsets 0, 0, graph 0.05, %s\n", p->nnotes ? "graph 0.25" : "0");
    if (p->shape == PLOT_BOXES && !p->log_y)
        fputs("set yrange [0:*]\nset offsets graph 0.02, graph 0.02, graph 0.05, 0\n", out);
    if (p->shape == PLOT_POINTS && !p->log_x)
        fputs("set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n", out);
    if (has_right_side(p))
        fputs("set border 11\nset y2tics out scale 0.6\n", out);
}

/* ---- what is drawn of a curve ---- */

/* The title of what stands for the curve in the legend. */
static void put_title(FILE *out, const plot_diagram *p, size_t i) {
    fputs(" title ", out);
    put_quoted(out, p->count > 1 ? p->curves[i].name : "");
}

/* The columns of $data: of bins the middle stands for x. */
static void put_using(FILE *out, const plot_diagram *p, size_t i, const char *behind, bool first) {
    const plot_curve *c = &p->curves[i];
    const char *x = !c->x_end ? "1" : c->low ? "(0.5*($1+$5))" : "(0.5*($1+$3))";
    fprintf(out, "%s $data%zu using %s:%s axes x1y%d", first ? "" : ",", i + 1, x, behind, is_right(p, i) ? 2 : 1);
}

static void put_notes(FILE *out, const plot_diagram *p) {
    char unit[48], digits[FIELD_ROOM];
    double divisor = readable_unit(p->x_dim, unit);
    for (size_t i = 0; i < p->nnotes; i++) {
        fputs("set label ", out);
        put_quoted(out, p->notes[i].text);
        fprintf(out, " at first %s, graph 0.02 rotate textcolor rgb '#777777'\n",
                field_number(p->notes[i].x / divisor, digits));
    }
}

/* Colours begin again behind the last, with other dashes. */
static void put_line(FILE *out, size_t i, double width) {
    fprintf(out, " linewidth %g linecolor rgb '%s' dashtype %zu", width, colors[i % COLORS], i / COLORS + 1);
}

static void put_mark(FILE *out, size_t i) {
    fprintf(out, " pointtype %d pointsize 0.8", marks[i / COLORS % MARKS]);
}

static void put_curve(FILE *out, const plot_diagram *p, size_t i, bool first) {
    const plot_curve *c = &p->curves[i];
    if (c->guide) {
        put_using(out, p, i, "2", first);
        fputs(" with lines linewidth 1 linecolor rgb '#777777' dashtype 2", out);
    } else if (p->shape == PLOT_BOXES) {
        put_using(out, p, i, c->low ? "2:1:5:(0):2" : "2:1:3:(0):2", first);
        fprintf(out, " with boxxyerror fillcolor rgb '%s' fillstyle transparent solid 0.4 border linecolor rgb '%s'",
                colors[i % COLORS], colors[i % COLORS]);
    } else {
        put_using(out, p, i, "2", first);
        fputs(p->shape == PLOT_POINTS ? " with linespoints" : " with lines", out);
        if (p->shape == PLOT_POINTS)
            put_mark(out, i);
        put_line(out, i, p->shape == PLOT_LINE ? 2 : 1);
    }
    put_title(out, p, i);
}

/* Below the line its shade; on boxes and points their bars. */
static void put_band(FILE *out, const plot_diagram *p, size_t i, bool first) {
    if (p->shape == PLOT_LINE) {
        put_using(out, p, i, "3:4", first);
        fprintf(out, " with filledcurves fillstyle transparent solid 0.25 noborder linecolor rgb '%s'",
                colors[i % COLORS]);
        return;
    }
    if (p->shape == PLOT_BOXES) { /* yerrorbars would leave a white gap */
        put_using(out, p, i, "3:(0):($4-$3)", first);
        fputs(" with vectors heads size graph 0.012,90 linewidth 1.2 linecolor rgb '#000000'", out);
        return;
    }
    put_using(out, p, i, "2:3:4", first);
    fputs(" with yerrorbars", out);
    put_mark(out, i);
    fprintf(out, " linewidth 1.2 linecolor rgb '%s'", colors[i % COLORS]);
}

static void put_plot(FILE *out, const plot_diagram *p) {
    bool first = true;
    fputs("plot", out);
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < p->count; i++) {
            bool lower = (p->shape == PLOT_LINE) == (pass == 0); /* shades first, bars last */
            if (lower && !p->curves[i].low)
                continue;
            (lower ? put_band : put_curve)(out, p, i, first);
            first = false;
        }
    fputc('\n', out);
}

char *plot_script(const plot_diagram *p, const char *path) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fprintf(out, "set encoding utf8\nset terminal %s\nset output ", plot_terminal(path));
    put_quoted(out, path);
    fputs("\nset datafile missing 'nan'\nset border 3 linewidth 1\nset tics nomirror out scale 0.6\nset "
          "pointintervalbox 0\n",
          out);
    put_key(out, p);
    put_axes(out, p);
    put_labels(out, p);
    put_ranges(out, p);
    put_notes(out, p);
    put_data(out, p);
    put_plot(out, p);
    fclose(out);
    return text;
}

int plot_draw(const plot_diagram *p, const char *path, diag *d) {
    static const char *const words[] = {"gnuplot", "-", NULL};
    if (path_make_folders(path, d))
        return SARCINA_ERROR;
    char *script = plot_script(p, path);
    int status = process_run(words, script, strlen(script), d);
    free(script);
    return status;
}
