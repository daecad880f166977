/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The study of laws for scripts/laws: contact law, jitter and the time between looks at links, each against the
 * published behaviour, at equal cell number. */
#ifndef SARCINA_APP_STUDY_LAWS_H
#define SARCINA_APP_STUDY_LAWS_H

#include "base/diag.h"

/* The ensembles, one a line, parted by tabs: cells, name, script below examples, options, seeds. */
void study_laws_plan(void);

/* From the runs in FOLDER/CELLS/NAME: RESULTS/laws.txt, as the manual shows it, and RESULTS/laws.csv. What has not been
 * run is left out; an error when nothing has. */
int study_laws_report(const char *folder, const char *results, diag *d);

#endif
