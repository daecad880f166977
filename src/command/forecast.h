/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a script will take, told by -check: cells at the end, time, memory; and what in it can never act or is at odds
 * with itself. Commands note what they would do as they are checked; at the end the beginning of the last scene is
 * rehearsed, and the growth laws do the rest. An estimate: right to a factor of about 3. */
#ifndef SARCINA_COMMAND_FORECAST_H
#define SARCINA_COMMAND_FORECAST_H

#include "command/creation.h"
#include "engine/archive.h"
#include "engine/scene.h"
#include "engine/tradeoff.h"
#include "output/image.h"
#include "script/command.h"

enum { FORECAST_SPECIES = 64, FORECAST_BINS = 64 };

/* How a species grows in a run, as its commands stand then. */
typedef struct forecast_law {
    int style;           /* of growth_styles; -1: it does not grow */
    double rate, divide; /* mean; mean mass at division, pg (NaN: it does not divide) */
    double arrive, mass; /* cells that attach, 1/s, and their mass, pg */
} forecast_law;

/* What takes time or room and is named, not counted. */
typedef enum { FORECAST_ENCODING, FORECAST_DIAGRAMS, FORECAST_TEXT, FORECAST_EXTRAS } forecast_extra;

/* A tradeoff: relaxations of `relax` s behind a growth of `grow`, by each method so many, from the scene as it stands.
 */
typedef struct forecast_tradeoff {
    double grow, relax, times;
    tradeoff_method *methods; /* owned */
    size_t n;
    double cells; /* there then, as far as is known */
} forecast_tradeoff;

typedef struct forecast_run {
    double times, cycles; /* how often it is run, of so many cycles */
    double grow, relax;   /* s; relax: infinite where it ends by force alone */
    double force;         /* it may rest before `relax` is over, 1e-21 N; 0: no */
    relax_settings how;   /* by the integrator of then */
    expr *until;          /* owned; NULL: none */
    double ends;          /* cycles after which it held in the rehearsal; infinite: not seen */
    double ended[FORECAST_SPECIES], mass[FORECAST_SPECIES]; /* cells then, and their mass, pg */
    forecast_law law[FORECAST_SPECIES];
    bool upto;
    bool still;                   /* it is one picture, and no cycle */
    double frames, pixels, edges; /* of pictures, a cycle; edges: the roots of their pixels */
} forecast_run;

/* Relaxations by the number of cells, half an octave a bin: in seconds of relaxation, and each times the cells. */
typedef struct forecast_load {
    double relaxed[FORECAST_BINS], cells[FORECAST_BINS];
    double relaxations, cycles;
    double frames, pixels, edges; /* edges: each times the root of the number of cells */
} forecast_load;

typedef struct forecast {
    double cells[FORECAST_SPECIES], mass[FORECAST_SPECIES]; /* created, and their sum, pg */
    bool filament[FORECAST_SPECIES];                        /* some linked filially from the beginning */
    double least_gap;    /* of the lowest cell above the substratum, um; infinite: none is known */
    const char *unknown; /* where cells come from that are not counted; NULL */
    bool extra[FORECAST_EXTRAS];
    char *restart;                 /* a file that the scene goes on from, owned; NULL: none */
    double held[FORECAST_SPECIES]; /* of `cells` those in it */
    double step, time, relaxed;    /* its clock; s */
    creation *creations;
    forecast_run *runs;
    forecast_tradeoff *tradeoffs;
    size_t ncreations, creation_capacity, nruns, run_capacity, ntradeoffs, tradeoff_capacity;
    double most_pixels;  /* of one picture */
    double least_across; /* pixels across one that shows the whole colony; infinite: there is none */
    double scale;        /* how often all this happens: from a clear on in loops */
    forecast_load past;  /* of what went before the last clear, and the largest number of cells there */
    double most;
    bool open; /* a run there may end before what is counted */
} forecast;

void forecast_free(forecast *f); /* NULL is allowed */

/* What a checked command would do; how often: interp_check_passes. */
void forecast_create(interp *in, const creation *c);
void forecast_note_run(interp *in, const forecast_run *r); /* takes a reference of until */
void forecast_note_picture(interp *in, const image_options *o);
void forecast_note_tradeoff(interp *in, const forecast_tradeoff *t); /* takes a copy of the methods */
void forecast_unknown(interp *in, const char *why);                  /* a constant text */
void forecast_note_extra(interp *in, forecast_extra what);
void forecast_clear(interp *in);

/* The scene goes on from this restart file, whose declarations have been read: its cells and its clock count. */
int forecast_note_restart(interp *in, const char *path, const archive *a, diag *d);

/* Behind a check without errors: prints the estimate, and warns. */
void forecast_report(interp *in);

/* The last scene's end: cells of each species, and their sum; what it took; the `until` that may end a run before, and
 * that only the run can tell (NULL: none). */
typedef struct forecast_end {
    double cells, of[FORECAST_SPECIES];
    double step, time, relaxed; /* before the first cycle; then; s */
    forecast_load load;
    const expr *open;
} forecast_end;
forecast_end forecast_project(interp *in, const forecast *f);

/* forecast_until.c: does the test of a run hold, as far as cells, step, time and relaxed tell? *known: they do. */
bool forecast_until(interp *in, const expr *test, double cells, double step, double time, double relaxed, bool *known);

/* forecast_rehearse.c: what a second of relaxation takes by the number of cells (forecast_load's bins), measured on
 * the first cycles of the last scene; and beyond. Sets `ends` of the runs. */
typedef struct forecast_price {
    double relaxed[FORECAST_BINS], cells[FORECAST_BINS], evaluations[FORECAST_BINS], seconds[FORECAST_BINS]; /* sums */
    double bytes_per_cell;
    double pixel, edge; /* of a picture, CPU seconds: width x height x pixel + sqrt(width x height x cells) x edge */
} forecast_price;

int forecast_bin(double cells);
double forecast_clock(void); /* CPU seconds of this process */
int forecast_rehearse(interp *in, forecast *f, const forecast_end *end, forecast_price *out, diag *d);

/* Of a second of relaxation of so many cells: force evaluations, CPU seconds. */
void forecast_cost(const forecast_price *p, double cells, double *evaluations, double *seconds);

/* forecast_tradeoff.c: CPU seconds of all of them, measured on the cells of the rehearsal. */
double forecast_tradeoffs(scene *s, const forecast *f, const forecast_price *p);

/* What the warnings look at. */
typedef struct forecast_subject {
    interp *in;
    const scene *s;
    const forecast *f;
    const forecast_end *end;
} forecast_subject;

/* forecast_warn.c */
void forecast_warn(interp *in, const forecast *f, const forecast_end *end);

/* Mean diameter of a species' cells at division, um; NaN: not known. */
double forecast_diameter(const species *sp);

/* How far from its middle a colony of the end reaches, at a volume (layer: area) fraction of a half, um. */
double forecast_radius(const scene *s, const forecast_end *end, bool layer);

/* forecast_sizes.c */
void forecast_warn_sizes(interp *in, const forecast *f, const forecast_end *end);

#endif
