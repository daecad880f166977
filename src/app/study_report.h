/* SPDX-License-Identifier: GPL-3.0-or-later */
/* RESULTS.md and RESULTS.csv. */
#ifndef SARCINA_APP_STUDY_REPORT_H
#define SARCINA_APP_STUDY_REPORT_H

#include "app/study_claims.h"

/* case,quantity,ours,ci95,n,paper,reference: a row for each quantity of each case that has been run. */
int study_report_csv(const study *s, const char *path, diag *d);

/* A text in which a line @NAME stands for one of the tables below: template, with the tables filled in, to path. */
int study_report_text(const study *s, const char *template, const char *path, diag *d);

#endif
