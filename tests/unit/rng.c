/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random numbers: Philox4x64-10 against Random123's known answers and a second implementation, and streams that
 * depend on (seed, purpose, id, step) alone. Seeds are fixed, so bounds of five standard deviations do not flicker. */
#include "check.h"

#include "base/rng.h"

#include <Random123/philox.h>
#include <stdlib.h>
#include <string.h>

/* Philox written from Salmon et al. (2011), section 3.3: multiply, exchange, bump the key by the Weyl constants. */
static void reference_philox(const uint64_t counter[4], const uint64_t key[2], uint64_t out[4]) {
    uint64_t c[4], k[2] = {key[0], key[1]};
    memcpy(c, counter, sizeof c);
    for (int round = 0; round < 10; round++) {
        __extension__ unsigned __int128 p = (unsigned __int128)0xD2E7470EE14C6C93u * c[0];
        __extension__ unsigned __int128 q = (unsigned __int128)0xCA5A826395121157u * c[2];
        uint64_t next[4] = {(uint64_t)(q >> 64) ^ c[1] ^ k[0], (uint64_t)q, (uint64_t)(p >> 64) ^ c[3] ^ k[1],
                            (uint64_t)p};
        memcpy(c, next, sizeof c);
        k[0] += 0x9E3779B97F4A7C15u;
        k[1] += 0xBB67AE8584CAA73Bu;
    }
    memcpy(out, c, sizeof c);
}

/* Random123's tests/kat_vectors, "philox4x64 10". */
static void test_known_answers(void **state) {
    (void)state;
    static const uint64_t ones = UINT64_MAX;
    static const struct {
        uint64_t counter[4], key[2], answer[4];
    } known[] = {
        {{0, 0, 0, 0}, {0, 0}, {0x16554d9eca36314cu, 0xdb20fe9d672d0fdcu, 0xd7e772cee186176bu, 0x7e68b68aec7ba23bu}},
        {{ones, ones, ones, ones},
         {ones, ones},
         {0x87b092c3013fe90bu, 0x438c3c67be8d0224u, 0x9cc7d7c69cd777b6u, 0xa09caebf594f0ba0u}},
        {{0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u, 0x082efa98ec4e6c89u},
         {0x452821e638d01377u, 0xbe5466cf34e90c6cu},
         {0xa528f45403e61d95u, 0x38c72dbd566e9788u, 0xa5a1610e72fd18b5u, 0x57bd43b5e52b7fe6u}},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        uint64_t out[4];
        reference_philox(known[i].counter, known[i].key, out);
        assert_memory_equal(out, known[i].answer, sizeof out);
        philox4x64_ctr_t counter;
        philox4x64_key_t key;
        memcpy(counter.v, known[i].counter, sizeof known[i].counter);
        memcpy(key.v, known[i].key, sizeof known[i].key);
        philox4x64_ctr_t library = philox4x64(counter, key);
        assert_memory_equal(library.v, known[i].answer, sizeof out);
    }
}

/* A stream is the words of Philox(counter {id, step, 0, 1...}, key {seed, purpose}), low half first. Restarts and
 * published results hang on this layout. */
static void test_stream_layout(void **state) {
    (void)state;
    rng *r = rng_create(20140520);
    gsl_rng *stream = rng_stream(r, RNG_JITTER, 77, 13);
    for (uint64_t block = 1; block < 50; block++) {
        uint64_t words[4];
        reference_philox((uint64_t[4]){77, 13, 0, block}, (uint64_t[2]){20140520, RNG_JITTER}, words);
        for (int i = 0; i < 4; i++) {
            assert_true(gsl_rng_get(stream) == (words[i] & 0xffffffffu));
            assert_true(gsl_rng_get(stream) == words[i] >> 32);
        }
    }
    rng_free(r);
}

/* Draws do not depend on what was drawn before, nor on which object drew it. */
static void test_order_of_calls_is_free(void **state) {
    (void)state;
    enum { N = 200 };
    rng *r = rng_create(5), *other = rng_create(99);
    double forward[N];
    for (uint64_t id = 0; id < N; id++)
        forward[id] = gsl_rng_uniform(rng_stream(r, RNG_RATE, id, 3));
    rng_seed(other, 5);
    assert_int_equal(rng_get_seed(other), 5);
    for (uint64_t id = N; id-- > 0;) {
        gsl_rng *stream = rng_stream(other, RNG_RATE, id, 3);
        assert_true(gsl_rng_uniform(stream) == forward[id]);
        for (uint64_t i = 0; i < id % 11; i++)
            gsl_rng_get(stream); /* leftovers of a stream do not reach the next */
    }
    rng_free(r);
    rng_free(other);
}

/* Neighbouring seeds, purposes, ids and steps: no draw in common, no correlation. */
static double correlation(const double *a, const double *b, size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += (a[i] - 0.5) * (b[i] - 0.5);
    return 12 * sum / (double)n;
}

static void test_streams_are_independent(void **state) {
    (void)state;
    enum { N = 40000 };
    static double first[N], next_seed[N], next_purpose[N], next_step[N], second[N], swapped[N];
    rng *r = rng_create(1), *s = rng_create(2);
    for (uint64_t id = 0; id < N; id++) {
        gsl_rng *stream = rng_stream(r, RNG_RATE, id, 1);
        first[id] = gsl_rng_uniform(stream);
        second[id] = gsl_rng_uniform(stream);
        next_purpose[id] = gsl_rng_uniform(rng_stream(r, RNG_DIAMETER, id, 1));
        next_step[id] = gsl_rng_uniform(rng_stream(r, RNG_RATE, id, 2));
        next_seed[id] = gsl_rng_uniform(rng_stream(s, RNG_RATE, id, 1));
        swapped[id] = gsl_rng_uniform(rng_stream(r, RNG_RATE, 1, id));
    }
    const double bound = 5 / sqrt(N);
    assert_near(correlation(first, second, N), 0, bound);
    assert_near(correlation(first, next_purpose, N), 0, bound);
    assert_near(correlation(first, next_step, N), 0, bound);
    assert_near(correlation(first, next_seed, N), 0, bound);
    assert_near(correlation(first, swapped, N), 0, bound);
    assert_near(correlation(first, first + 1, N - 1), 0, bound); /* neighbouring ids */
    rng_free(r);
    rng_free(s);
}

/* First draws of small seeds fill the interval evenly, unlike those of the original's generator (numerics.md section
 * 2): chi-square over 32 classes, 31 degrees of freedom. */
static void test_small_seeds_are_even(void **state) {
    (void)state;
    enum { CLASSES = 32, N = 32000 };
    int count[CLASSES] = {0};
    rng *r = rng_create(0);
    for (uint64_t seed = 1; seed <= N; seed++) {
        rng_seed(r, seed);
        count[(int)(CLASSES * gsl_rng_uniform(rng_stream(r, RNG_CREATE, 1, 0)))]++;
    }
    double chi2 = 0, expected = (double)N / CLASSES;
    for (int i = 0; i < CLASSES; i++)
        chi2 += (count[i] - expected) * (count[i] - expected) / expected;
    assert_near(chi2, 31, 5 * sqrt(2 * 31));
    rng_free(r);
}

/* Contact directions: unit, opposite when the cells are exchanged, uniform on the sphere. */
static void test_directions(void **state) {
    (void)state;
    enum { N = 40000 };
    double sum[3] = {0}, square[3] = {0};
    for (uint64_t i = 0; i < N; i++) {
        double u[3], back[3];
        rng_direction(11, i, i + 1 + i % 7, u);
        rng_direction(11, i + 1 + i % 7, i, back);
        assert_near(u[0] * u[0] + u[1] * u[1] + u[2] * u[2], 1, 1e-14);
        for (int k = 0; k < 3; k++) {
            assert_true(back[k] == -u[k]);
            sum[k] += u[k];
            square[k] += u[k] * u[k];
        }
    }
    for (int k = 0; k < 3; k++) {
        assert_near(sum[k] / N, 0, 5 * sqrt(1.0 / 3 / N));
        assert_near(square[k] / N, 1.0 / 3, 5 * sqrt(4.0 / 45 / N)); /* variance of u_k^2: 1/5 - 1/9 */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_answers),          cmocka_unit_test(test_stream_layout),
        cmocka_unit_test(test_order_of_calls_is_free), cmocka_unit_test(test_streams_are_independent),
        cmocka_unit_test(test_small_seeds_are_even),   cmocka_unit_test(test_directions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
