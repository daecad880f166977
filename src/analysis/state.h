/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of the scene: clock and numbers of things. */
#ifndef SARCINA_ANALYSIS_STATE_H
#define SARCINA_ANALYSIS_STATE_H

#include "analysis/view.h"

/* value.h measures; those that count do so among members. */
int state_step(const view *v, const bool *members, double *out, diag *d);
int state_time(const view *v, const bool *members, double *out, diag *d);
int state_relaxed(const view *v, const bool *members, double *out, diag *d);
int state_cells(const view *v, const bool *members, double *out, diag *d);
int state_particles(const view *v, const bool *members, double *out, diag *d);
int state_links(const view *v, const bool *members, double *out, diag *d);
int state_caps(const view *v, const bool *members, double *out, diag *d);
int state_wall(const view *v, const bool *members, double *out, diag *d);

#endif
