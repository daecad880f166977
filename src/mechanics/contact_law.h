/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The law of contact.h over CONTACT_REAL, a number or a vector of them, included once for each: no guard. Whoever
 * includes it defines CONTACT_(name), what its names begin with, and by such names
 *     set(x)         x in every lane          min(a, b)     a < b ? a : b          max(a, b)   a > b ? a : b
 *     less(a, b)     a < b, a CONTACT_MASK    equal(a, b)   a == b                 sqrt(x)
 *     pick(m, a, b)  m ? a : b
 * All in IEEE arithmetic without contraction: the same bits in every lane of every width. */
#define CONTACT_INLINE static inline __attribute__((always_inline))

typedef struct CONTACT_(pair) {
    CONTACT_REAL r[3]; /* A0 - B0, um */
    CONTACT_REAL d1[3], d2[3];
    CONTACT_REAL radii; /* r_A + r_B */
    CONTACT_REAL rests; /* L_A L_B, um2 */
} CONTACT_(pair);

typedef struct CONTACT_(result) {
    CONTACT_REAL s, t;
    CONTACT_REAL delta[3]; /* p(s) - q(t), um */
    CONTACT_REAL square;   /* |delta|^2 */
    CONTACT_REAL g, reach; /* G and R'^2, um2: they touch where G < R'^2 */
    CONTACT_REAL scale;    /* k (R' / sqrt G - 1), 0 apart: force on A is scale x delta */
} CONTACT_(result);

CONTACT_INLINE CONTACT_REAL CONTACT_(clamp)(CONTACT_REAL x) {
    return CONTACT_(min)(CONTACT_(set)(1), CONTACT_(max)(CONTACT_(set)(0), x));
}

/* a . b in that many dimensions; in the plane the third component is 0 and left out, which changes no bit. */
CONTACT_INLINE CONTACT_REAL CONTACT_(dot)(const CONTACT_REAL a[3], const CONTACT_REAL b[3], int dimensions) {
    CONTACT_REAL sum = a[0] * b[0] + a[1] * b[1];
    if (dimensions > 2)
        sum = sum + a[2] * b[2];
    return sum;
}

/* The points that minimise G: s, t, delta, reach, and in g what w adds to the square of their distance. In 2 dimensions
 * the z components of the pair are not read, and that of delta is not written. */
CONTACT_INLINE void CONTACT_(nearest)(int dimensions, contact_law_values law, const CONTACT_(pair) * p,
                                      CONTACT_(result) * out) {
    const CONTACT_REAL zero = CONTACT_(set)(0), one = CONTACT_(set)(1);
    CONTACT_REAL reach = law.reach * p->radii, square = reach * reach;
    CONTACT_REAL w = law.epsilon * CONTACT_(min)(p->rests, square);

    CONTACT_REAL a = CONTACT_(dot)(p->d1, p->d1, dimensions) + w, e = CONTACT_(dot)(p->d2, p->d2, dimensions) + w;
    CONTACT_REAL b = CONTACT_(dot)(p->d1, p->d2, dimensions);
    CONTACT_REAL c = CONTACT_(dot)(p->d1, p->r, dimensions) - 0.5 * w;
    CONTACT_REAL f = CONTACT_(dot)(p->d2, p->r, dimensions) + 0.5 * w;
    /* a coccus: b, c (or f) are 0 and so is its s (or t) */
    a = CONTACT_(pick)(CONTACT_(less)(zero, a), a, one);
    e = CONTACT_(pick)(CONTACT_(less)(zero, e), e, one);

    CONTACT_REAL det = a * e - b * b;
    CONTACT_MASK skew = CONTACT_(less)(CONTACT_PARALLEL * (a * e), det);
    CONTACT_REAL s = CONTACT_(clamp)((b * f - c * e) / CONTACT_(pick)(skew, det, one));
    s = CONTACT_(pick)(skew, s, zero);
    CONTACT_REAL free_t = (b * s + f) / e, t = CONTACT_(clamp)(free_t);
    CONTACT_REAL s_again = CONTACT_(clamp)((b * t - c) / a);
    s = CONTACT_(pick)(CONTACT_(equal)(free_t, t), s, s_again);

    out->s = s;
    out->t = t;
    for (int k = 0; k < dimensions; k++)
        out->delta[k] = p->r[k] + s * p->d1[k] - t * p->d2[k];
    out->g = w * ((s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5));
    out->reach = square + 0.25 * w;
}

/* What they do to each other there: all the rest. */
CONTACT_INLINE void CONTACT_(push)(int dimensions, contact_law_values law, CONTACT_(result) * c) {
    c->square = CONTACT_(dot)(c->delta, c->delta, dimensions);
    c->g = c->square + c->g;
    CONTACT_REAL g = CONTACT_(pick)(CONTACT_(less)(CONTACT_(set)(0), c->g), c->g, c->reach);
    c->scale = law.k * CONTACT_(max)(CONTACT_(sqrt)(c->reach / g) - 1, CONTACT_(set)(0));
}

CONTACT_INLINE CONTACT_(result) CONTACT_(compute_in)(int dimensions, contact_law_values law, CONTACT_(pair) p) {
    CONTACT_(result) out;
    CONTACT_(nearest)(dimensions, law, &p, &out);
    CONTACT_(push)(dimensions, law, &out);
    return out;
}

#undef CONTACT_INLINE
