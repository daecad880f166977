/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of the library only where SARCINA_TRACE_MESSAGES is on: notes which error messages the tests bring about, for
 * tests/tools/messages. The file is that of the environment's SARCINA_MESSAGES; without it nothing is noted. */
#include "base/diag.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void diag_trace(const char *format); /* called by base/diag.c */

void diag_trace(const char *format) {
    const char *path = getenv("SARCINA_MESSAGES");
    int file = path ? open(path, O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
    if (file < 0)
        return;
    char line[1024];
    size_t n = strlen(format) < sizeof line - 1 ? strlen(format) : sizeof line - 1;
    memcpy(line, format, n);
    for (size_t i = 0; i < n; i++)
        if (line[i] == '\n')
            line[i] = ' ';
    line[n] = '\n';
    if (write(file, line, n + 1) < 0) /* one write a line: tests run side by side */
        abort();
    close(file);
}
