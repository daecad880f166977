/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Limits on motion, and how often each has been met. What a limit holds back or refuses is no motion by the equations:
 * so each hit is counted, with the state (colony.caps), and reported. Only what came to pass counts: hits of a trial
 * step that was refused, or of a cycle that was taken back, are those of nothing. */
#ifndef SARCINA_MODEL_CAP_H
#define SARCINA_MODEL_CAP_H

#include <stddef.h>
#include <stdint.h>

typedef enum {
    CAP_FAR,      /* steps refused: a particle would have gone too far, or to where there are no numbers */
    CAP_JOLT,     /* steps refused: too long for a force that came to act in them */
    CAP_HELD,     /* flexible cells held back in a step */
    CAP_UNSOLVED, /* flexible cells whose step was taken before its equations were solved to their tolerance */
    CAP_CLAMPED,  /* particles that a relaxation has left nearer to the substratum than the clamp of dlvo */
    CAP_LIFTED,   /* new particles of a division lifted out of the substratum */
    CAP_COUNT
} cap_kind;

typedef struct cap_record {
    const char *name, *summary;
} cap_record;
extern const cap_record cap_records[CAP_COUNT];

/* to += from (CAP_COUNT each). */
void cap_add(uint64_t *to, const uint64_t *from);

/* "far 3, held 12": those that were met between two counts (CAP_COUNT each; from NULL: since the beginning); "none"
 * where there is none. */
void cap_describe(const uint64_t *now, const uint64_t *from, size_t size, char *text);

#endif
