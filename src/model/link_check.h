/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does the graph of links hold together? For tests, and for builds that look after every growth step and relaxation
 * (SARCINA_CHECK_LINKS). */
#ifndef SARCINA_MODEL_LINK_CHECK_H
#define SARCINA_MODEL_LINK_CHECK_H

#include "model/colony.h"

typedef struct link_fault {
    const char *what; /* NULL: none */
    uint64_t link;    /* id */
} link_fault;

/* The first fault found: every link joins live cells by springs between their own particles, as many as its kind has,
 * with k and rest length above 0; ids ascend and springs follow one another; a cell has one anchoring link at most, and
 * a pair of cells one filial or sticking link, not both. Bare springs (LINK_SPRING) need only their particles. */
link_fault link_check(colony *c);

#endif
