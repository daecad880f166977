/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every spring that acts, as dumps and pictures show it: those inside cells, then those of links. */
#ifndef SARCINA_OUTPUT_SPRING_LIST_H
#define SARCINA_OUTPUT_SPRING_LIST_H

#include "base/vec3.h"
#include "output/dump.h"

#define SPRING_INTERNAL (-1) /* beside link_kind */

typedef struct spring_item {
    uint64_t link, cell_a, cell_b;   /* ids; link 0: internal, cell_b 0: the substratum */
    int kind;                        /* link_kind, or SPRING_INTERNAL */
    uint32_t particle_a, particle_b; /* counted within their cells */
    double k, rest, length;          /* pg/s2, um */
    double strain;                   /* (length - rest) / rest; NaN for a rest length of 0 */
    double age;                      /* of the link, s; NaN for what is internal */
    vec3 from, to;                   /* its ends, um */
    bool anchored, glides;
    const double *anchor; /* the fixed point; NULL: none */
} spring_item;

/* "internal", "filial", "stick", "anchor", "spring". */
const char *spring_list_kind(int kind);

/* Springs inside the frame's cells in the order of ids, then those of links in the order of theirs, all of whose cells
 * are members. The caller frees. */
spring_item *spring_list_make(const dump_frame *f, size_t *n);

#endif
