/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What two samples say about the means behind them, by Student's t without equal variances (Welch 1947, Biometrika
 * 34:28), and many such questions at once (Holm 1979, Scand. J. Statist. 6:65). */
#ifndef SARCINA_BASE_INFERENCE_H
#define SARCINA_BASE_INFERENCE_H

#include <stddef.h>

/* Mean and standard deviation (n - 1 in the denominator) of n numbers. */
typedef struct inference_sample {
    double mean, sd;
    size_t n;
} inference_sample;

/* Of x (n); those that are NaN are left out. */
inference_sample inference_sample_of(const double *x, size_t n);

/* The sample behind a mean and the half-width of its 95 % interval (Student's t). */
inference_sample inference_sample_behind(double mean, double ci95, size_t n);

/* Half-width of the 95 % interval of the mean; NaN below two. */
double inference_ci95(inference_sample a);

/* Half-width of the 95 % prediction interval of one more draw of the same normal distribution:
 * t sd sqrt(1 + 1/n). NaN below two. */
double inference_prediction95(inference_sample a);

/* Difference of two means, its standard error, and degrees of freedom after Welch and Satterthwaite. */
typedef struct inference_difference {
    double value, error, freedom;
} inference_difference;

inference_difference inference_compare(inference_sample a, inference_sample b);

/* The mean of differences taken pair by pair. */
inference_difference inference_paired(inference_sample differences);

/* Half-width of the interval of the difference; level: 0.95. */
double inference_width(inference_difference d, double level);

/* One-sided p: how likely so large a difference is if the true one were no more than `bound`. */
double inference_p_above(inference_difference d, double bound);

/* p of two one-sided tests (Schuirmann 1987, J. Pharmacokinet. Biopharm. 15:657): how likely so small a difference is
 * if the true one were margin or more, either way. */
double inference_p_equivalent(inference_difference d, double margin);

/* How many pairs find, with a power of 80 %, that two are equivalent within margin (p of the two one-sided tests below
 * 5 %) where in truth they do not differ; and that they differ, by an interval of this level, where in truth they do by
 * `difference`. sd: of the differences. By the central t; infinite beyond a million, NaN where sd is. */
double inference_pairs_equivalent(double sd, double margin);
double inference_pairs_different(double sd, double difference, double level);

/* p (n) corrected for being many, by Holm's steps; in the order given. NaN: a question not asked, and not counted. */
void inference_holm(const double *p, size_t n, double *adjusted);

/* Hedges' g: the difference over the pooled standard deviation, corrected for small samples by 1 - 3 / (4 (n - 2) - 1)
 * (n: of both), and the half-width of its 95 % interval in the large-sample approximation,
 * var g = (na + nb) / (na nb) + g^2 / (2 (na + nb)) (Hedges & Olkin 1985). */
double inference_hedges(inference_sample a, inference_sample b, double *ci95);

#endif
