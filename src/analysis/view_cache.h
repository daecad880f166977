/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What measures of one view share, computed when it is first asked for: per cell, in rows of the cell table. */
#ifndef SARCINA_ANALYSIS_VIEW_CACHE_H
#define SARCINA_ANALYSIS_VIEW_CACHE_H

#include "analysis/view.h"

typedef struct view_cache view_cache;

/* An empty cache; free with view_cache_free, which takes NULL. */
view_cache *view_cache_create(void);
void view_cache_free(view_cache *cache);

/* Forgets everything: the next view shows another state. Memory is kept. */
void view_cache_reset(view_cache *cache);

/* Contacts of each cell at the view's state. */
typedef struct view_contacts {
    const double *overlap;    /* deepest, um (cells) */
    const uint32_t *contacts; /* cells within reach (cells) */
    const double *force;      /* net, without damping, 1e-21 N (cells x 3) */
} view_contacts;
view_contacts view_cache_contacts(const view *v);

/* Links of each cell. */
typedef struct view_links {
    const uint32_t *filial, *stuck, *anchored; /* numbers of links (cells) */
    const double *stretch;                     /* longest excess of a spring over its rest length, um (cells) */
    const double *strain;                      /* largest excess over rest length (cells) */
    const uint32_t *root;                      /* row of the cell of lowest id that links lead to (cells) */
} view_links;
view_links view_cache_links(const view *v);

#endif
