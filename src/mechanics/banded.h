/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric positive definite matrices of one cell, by their lower half: a particle's rows hold its own columns and
 * those of the three particles before it, 12 in space, the diagonal last. Row i holds columns i - 11 ... i; what would
 * stand left of column 0 is never read. Cholesky, Golub & Van Loan, Matrix Computations, 4.3.5. */
#ifndef SARCINA_MECHANICS_BANDED_H
#define SARCINA_MECHANICS_BANDED_H

#include <stddef.h>

enum { BANDED_WIDTH = 12 };

/* The number at (row, column), column at most 11 before row and not after it. */
static inline double *banded_at(double *matrix, size_t row, size_t column) {
    return matrix + row * BANDED_WIDTH + (column + BANDED_WIDTH - 1 - row);
}

/* matrix (n x BANDED_WIDTH) = L L', L in its place. A pivot that rounding has eaten (below 1e-14 of its diagonal) is
 * put back as that, so that L is always one of a positive definite matrix near by. */
void banded_factor(double *matrix, size_t n);

/* out = (L L')^-1 y, both (n); they may be one. */
void banded_solve(const double *matrix, size_t n, const double *y, double *out);

#endif
