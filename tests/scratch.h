/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A folder for the files of one test program: its group's set-up makes it, its teardown drops it. */
#ifndef SARCINA_TESTS_SCRATCH_H
#define SARCINA_TESTS_SCRATCH_H

#include "base/alloc.h"

#include <stdlib.h>

static char folder[] = "scratch.XXXXXX";

static int make_folder(void **state) {
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int drop_folder(void **state) {
    (void)state;
    char *command = alloc_format("rm -r %s", folder);
    int status = system(command);
    free(command);
    return status;
}

#endif
