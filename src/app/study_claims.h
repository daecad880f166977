/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's claims, judged. */
#ifndef SARCINA_APP_STUDY_CLAIMS_H
#define SARCINA_APP_STUDY_CLAIMS_H

#include "app/study_ensemble.h"

typedef enum {
    VERDICT_NOT_RUN,
    VERDICT_REPRODUCED, /* Holm's p is below 5 % */
    VERDICT_OPPOSITE,   /* the difference goes the other way, 95 %; or there is one where none is claimed */
    VERDICT_OPEN        /* neither */
} study_verdict;

typedef struct study_judgement {
    inference_sample a, b; /* in the quantity's unit */
    inference_difference difference;
    double g, g_ci95; /* Hedges' */
    double margin;    /* of claims that there is no difference, in that unit */
    double p, holm;   /* one-sided; corrected over all claims that were run */
    study_verdict verdict;
} study_judgement;

/* Of every claim (study_claim_count, the caller frees). A case with fewer than two replicates counts as not run. */
study_judgement *study_judge(const study *s);

const char *study_verdict_text(study_verdict v, study_direction d);

#endif
