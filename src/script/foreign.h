/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands of LAMMPS, and words of other languages, that people will type: what to write here. */
#ifndef SARCINA_SCRIPT_FOREIGN_H
#define SARCINA_SCRIPT_FOREIGN_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct foreign_word {
    const char *name, *instead;
} foreign_word;

/* The i-th command of LAMMPS that is answered, in *out; NULL when there are fewer. */
const foreign_word *foreign_list(size_t i, foreign_word *out);

/* Whether name is one of them; then the error says what there is instead. */
bool foreign_explain(const char *name, diag *d);

/* The same for a form of a command that both have: LAMMPS's `group ID type 1 2`. line: the whole of it, $ replaced. */
bool foreign_explain_form(const char *line, diag *d);

#endif
