/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Space and the plane: states, forces and capsules have 3 numbers a particle, or 2, and no z at all, where all lies in
 * the plane z = 0. What goes through them is compiled for both: functions with a parameter `dimensions`, inlined into
 * callers that give it as a constant. What they leave out is exactly 0, so that both give the same bits. */
#ifndef SARCINA_MECHANICS_DIMENSIONS_H
#define SARCINA_MECHANICS_DIMENSIONS_H

#define DIMENSIONS_INLINE static inline __attribute__((always_inline))

/* |d|^2 */
DIMENSIONS_INLINE double dimensions_square(const double *d, int dimensions) {
    double sum = d[0] * d[0] + d[1] * d[1];
    return dimensions > 2 ? sum + d[2] * d[2] : sum;
}

/* |a - b|^2 */
DIMENSIONS_INLINE double dimensions_apart(const double *a, const double *b, int dimensions) {
    double d[3] = {a[0] - b[0], a[1] - b[1], dimensions > 2 ? a[2] - b[2] : 0};
    return dimensions_square(d, dimensions);
}

#endif
