/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scripts and files made wrong in ways that people and disks make them wrong. */
#ifndef SARCINA_TESTS_FUZZ_MUTATE_H
#define SARCINA_TESTS_FUZZ_MUTATE_H

#include <gsl/gsl_rng.h>
#include <stddef.h>

/* Lines of scripts that are right. */
typedef struct corpus {
    char **scripts;
    char **words; /* of all scripts: what is put where it does not belong */
    size_t nscripts, nwords, script_capacity, word_capacity;
} corpus;

void corpus_add(corpus *c, const char *text);
void corpus_free(corpus *c);

/* One of the scripts with a word or line wrong, or some more; long runs are made short. The caller frees. */
char *mutate_script(const corpus *c, gsl_rng *r);

/* n bytes with some flipped, left out, doubled or cut off; the caller frees. *n becomes the new length. */
unsigned char *mutate_bytes(const unsigned char *bytes, size_t *n, gsl_rng *r);

#endif
