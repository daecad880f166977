/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One case with one preset, in a process of its own: what it came to, and whether that was due. */
#ifndef SARCINA_TESTS_EXTREMES_JUDGE_H
#define SARCINA_TESTS_EXTREMES_JUDGE_H

#include "extremes/table.h"

#include <stdint.h>

enum { WORDS_MAX = 1024 };

typedef struct verdict {
    int good;                              /* what was due came about */
    int refused;                           /* the exit status of the line judged */
    double seconds;                        /* of processor */
    uint64_t steps, rejected, evaluations; /* of relaxations by the line judged, where it holds */
    double least_step;                     /* s */
    char words[WORDS_MAX];                 /* the error's first line; or what went wrong */
} verdict;

/* seconds: processor time after which there is no answer. */
verdict judge(const extreme *e, size_t preset, unsigned seconds);

#endif
