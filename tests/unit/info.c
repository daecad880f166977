/* SPDX-License-Identifier: GPL-3.0-or-later */
/* info scene: what does not act is not listed as acting, what is not measured is said to be so, and shares are whole.
 */
#include "script_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>

static script_host host;

SCRIPT_HOST_OF_GROUP(host)

static const char balls[] = "species ball coccus\n"
                            "force collision\n"
                            "create_cells ball single 0 0 0 mass 6e-16kg\n"
                            "create_cells ball single 2um 0 0 mass 6e-16kg\n";
static const char rods[] = "species rod rod diameter 0.75um\n"
                           "species curl flexible diameter 0.4um coil 0.3um pitch 2um particles 7\n"
                           "link internal * k 5e-11N/m\n"
                           "link bend curl k 2e-18N.m\n"
                           "link stick rod rod k 1e-11N/m\n"
                           "substratum plane\n"
                           "force dlvo\n"
                           "force damping\n"
                           "create_cells rod single 0 0 0 orient x gap 0 mass 1.5e-15kg\n"
                           "create_cells rod single 0 1um 0 orient x gap 0 mass 1.5e-15kg\n";

/* What info scene prints behind a script; the caller reads host.printed. */
static interp *show(const char *script) {
    script_host_clear(&host);
    interp *in = interp_create(&host.host);
    assert_int_equal(interp_run_source(in, "test.in", script), SARCINA_OK);
    free(host.printed);
    host.printed = alloc_copy("");
    assert_int_equal(interp_run_source(in, "info.in", "info scene\n"), SARCINA_OK);
    return in;
}

static void shows(const char *text, bool wanted) {
    if (!strstr(host.printed, text) == wanted)
        fail_msg("'%s' should%s be in:\n%s", text, wanted ? "" : " not", host.printed);
}

static void test_nothing(void **state) {
    (void)state;
    interp_free(show("seed 1\n"));
    shows("not active  internal bend twist springs collision substratum dlvo damping gravity\n", true);
    shows("remodelling none: no link can form or break here\n", true);
    shows("contacts    none: no neighbour list, no contact kernel\n", true);
    shows("time        not measured yet\n", true);
    shows("\nforce ", false);
}

/* Cocci have spheres' contacts, no springs inside them and no plane. */
static void test_cocci(void **state) {
    (void)state;
    interp_free(show(balls));
    shows("force       collision k 1e-10N/m reach 1.01 contact regularised epsilon 0.01\n", true);
    shows("not active  internal bend twist springs substratum dlvo damping gravity\n", true);
    shows("contacts    of spheres, kernel ", true);
    shows("steps       not measured yet\n", true);
    shows("\nlink ", false);
}

/* A species without cells turns nothing on; rules that cells follow do. */
static void test_rods(void **state) {
    (void)state;
    interp_free(show(rods));
    shows("force       internal rod k 5e-11N/m\n", true);
    shows("not active  bend twist springs collision gravity\n", true);
    shows("contacts    none", true);
    shows("link        stick rod rod k 1e-11N/m form 5e-07m break 1e-06m handover nearer: 0 links\n", true);
    shows("remodelling every 0.005s of relaxation\n", true);
    shows("relaxation  verlet, accuracy balanced, steps from the stiffness, at most 0.002s at first, inertia 0.1\n",
          true);
}

static void test_methods(void **state) {
    (void)state;
    interp_free(show("accuracy paper\n"));
    shows("relaxation  dopri5, accuracy paper, steps by their error: 1e-07m and 1e-07m/s, begun anew every 0.2s\n",
          true);
    interp_free(show("integrator verlet step 1ms\n"));
    shows("relaxation  verlet, steps of 0.001s\n", true);
    char script[600];
    snprintf(script, sizeof script, "%sintegrator newton\nset all x x/2\nrelax to 1e-20N\n", balls);
    interp_free(show(script));
    shows("relaxation  newton, to rest, by steps that take no time\n", true);
    shows("steps       take no time, ", true);
    shows(" force evaluations a relaxation\n", true);
}

/* Sum of the numbers behind names in a line that begins with `head`. */
static double sum_of(const char *head, char *names, size_t room) {
    const char *line = strstr(host.printed, head);
    assert_non_null(line);
    const char *from = strchr(line, ':') + 1;
    double sum = 0;
    names[0] = '\0';
    for (;;) {
        char name[32];
        double value;
        int used = 0;
        if (sscanf(from, " %31[a-z ]%lf%n", name, &value, &used) != 2)
            break;
        snprintf(names + strlen(names), room - strlen(names), "%s", name);
        sum += value;
        from += used;
        if (*from != ',')
            break;
        from++;
    }
    return sum;
}

/* After a relaxation: stages and terms have shares that make a whole, of those that act alone. */
static void test_measured(void **state) {
    (void)state;
    char script[1500], names[400];
    snprintf(script, sizeof script, "%sforce collision\nrelax 1s\n", rods);
    interp_free(show(script));
    shows("force       springs\n", true); /* they stuck */
    shows("rod rod k 1e-11N/m form 5e-07m break 1e-06m handover nearer: 1 link\n", true);
    shows("force evaluations a relaxation\n", true);
    shows("contacts    of segments, kernel ", true);
    double stages = sum_of("\ntime ", names, sizeof names);
    assert_true(fabs(stages - 100) < 1e-6);
    double terms = sum_of("\nforces ", names, sizeof names);
    assert_true(fabs(terms - 100) < 1e-6);
    assert_string_equal(names, "internal springs collision substratum dlvo capsules ");
    double bytes = sum_of("\nmemory ", names, sizeof names), whole = 0;
    assert_int_equal(sscanf(strstr(host.printed, "\nmemory ") + 8, "%lf", &whole), 1);
    assert_true(fabs(bytes - whole) < 0.02 * whole);
    assert_null(strstr(names, "chains"));
    assert_non_null(strstr(names, "neighbours"));
}

static void test_refused(void **state) {
    (void)state;
    interp_free(show("species rod rod diameter 1um\ncreate_cells rod single 0 0 0 mass 2e-15kg\nforce collision\n"));
    shows("force       collision", true);
    shows("cannot run  species rod is a rod without link internal", true);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing), cmocka_unit_test(test_cocci),    cmocka_unit_test(test_rods),
        cmocka_unit_test(test_methods), cmocka_unit_test(test_measured), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, open_host, close_host);
}
