/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A colony from a program of one's own: cc colony.c $(pkg-config --cflags --libs sarcina); it prints time, cells and
 * how far they reach. */
#include <sarcina/sarcina.h>

#include <stdio.h>
#include <stdlib.h>

static const char scene[] = "species       ball coccus\n"
                            "growth        ball exponential rate 1/h sd 10%\n"
                            "division      ball random mass 6e-16kg\n"
                            "force         collision\n"
                            "force         damping\n"
                            "create_cells  ball single 0 0 0\n";

/* What to do when a call fails is the program's to say. */
static void must(sarcina *s, int status) {
    if (status == SARCINA_OK)
        return;
    fputs(sarcina_error(s), stderr);
    sarcina_free(s);
    exit(status);
}

/* The distance of the outermost cell from the origin, um. */
static double reach(sarcina *s) {
    size_t n = sarcina_cells(s);
    double *distance = calloc(n, sizeof *distance), most = 0;
    must(s, sarcina_cell_values(s, "sqrt(x^2 + y^2 + z^2)/1um", distance));
    for (size_t i = 0; i < n; i++)
        most = distance[i] > most ? distance[i] : most;
    free(distance);
    return most;
}

int main(void) {
    sarcina *s = sarcina_create(NULL);
    if (!s)
        return EXIT_FAILURE;
    must(s, sarcina_run(s, scene));
    for (int i = 0; i < 5; i++) {
        double hours;
        must(s, sarcina_run(s, "run 20 grow 4min relax 1s"));
        must(s, sarcina_value(s, "time/1h", &hours));
        printf("%.2f h  %4zu cells  %5.2f um\n", hours, sarcina_cells(s), reach(s));
    }
    sarcina_free(s);
    return EXIT_SUCCESS;
}
