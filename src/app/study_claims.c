/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_claims.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

static double p_of(const study_claim *c, study_judgement *j) {
    inference_difference turned = j->difference;
    turned.value = -turned.value;
    switch (c->direction) {
    case STUDY_MORE:
        return inference_p_above(j->difference, 0);
    case STUDY_LESS:
        return inference_p_above(turned, 0);
    default:
        return inference_p_equivalent(j->difference, j->margin);
    }
}

static study_verdict verdict_of(const study_claim *c, const study_judgement *j) {
    if (isnan(j->p))
        return VERDICT_NOT_RUN;
    if (j->holm < 0.05)
        return VERDICT_REPRODUCED;
    bool real = fabs(j->difference.value) > inference_width(j->difference, 0.95);
    bool wrong = c->direction == STUDY_SAME || (c->direction == STUDY_MORE) != (j->difference.value > 0);
    return real && wrong ? VERDICT_OPPOSITE : VERDICT_OPEN;
}

study_judgement *study_judge(const study *s) {
    study_judgement *all = alloc_zeroed(study_claim_count, sizeof *all);
    double *p = alloc_zeroed(study_claim_count, sizeof *p), *holm = alloc_zeroed(study_claim_count, sizeof *holm);
    for (size_t i = 0; i < study_claim_count; i++) {
        const study_claim *c = &study_claims[i];
        study_judgement *j = &all[i];
        j->a = study_sample(s, c->a, c->quantity);
        j->b = study_sample(s, c->b, c->quantity);
        j->p = p[i] = NAN;
        if (j->a.n < 2 || j->b.n < 2)
            continue;
        j->difference = inference_compare(j->a, j->b);
        j->g = inference_hedges(j->a, j->b, &j->g_ci95);
        j->margin = c->margin * fabs(j->b.mean);
        j->p = p[i] = p_of(c, j);
    }
    inference_holm(p, study_claim_count, holm);
    for (size_t i = 0; i < study_claim_count; i++) {
        all[i].holm = holm[i];
        all[i].verdict = verdict_of(&study_claims[i], &all[i]);
    }
    free(p);
    free(holm);
    return all;
}

const char *study_verdict_text(study_verdict v, study_direction d) {
    switch (v) {
    case VERDICT_REPRODUCED:
        return "reproduced";
    case VERDICT_OPPOSITE:
        return d == STUDY_SAME ? "not reproduced: they differ" : "not reproduced: the opposite";
    case VERDICT_OPEN:
        return d == STUDY_SAME ? "not reproduced: undecided" : "not reproduced: no such difference shown";
    default:
        return "not run";
    }
}
