/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A folder that one process at a time works in: a lock of the file system (fcntl) on FOLDER/.lock, which goes with the
 * process that holds it, however that ends. */
#ifndef SARCINA_APP_LOCK_H
#define SARCINA_APP_LOCK_H

#include "base/diag.h"

#include <stdbool.h>

typedef struct lock {
    int file; /* -1: not held */
} lock;

/* Makes the folder if need be and takes its lock. An error when another process holds it: which, and on what machine.
 * Where the file system has no locks, *unlocked is set, and the folder is used as it is. */
int lock_take(lock *l, const char *folder, bool *unlocked, diag *d);

/* Also of one that is not held. The file stays, empty. */
void lock_release(lock *l);

#endif
