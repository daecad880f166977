/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The figures of RESULTS.md: data files always, curves where gnuplot is there, pictures where the runs made some. */
#ifndef SARCINA_APP_STUDY_FIGURE_H
#define SARCINA_APP_STUDY_FIGURE_H

#include "app/study_claims.h"

#include <stdbool.h>

/* Writes fig3_time.dat, fig3_cells.dat, claims.dat and the pictures of seed 1 into a folder, and, with gnuplot, the
 * plots of the three. */
int study_figure_all(const study *s, const char *folder, bool gnuplot, diag *d);

#endif
