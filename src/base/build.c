/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/build.h"

#include <string.h>

#ifndef SARCINA_LACKS
#define SARCINA_LACKS ""
#endif

bool build_lacks(const char *part) {
    static const char lacks[] = SARCINA_LACKS; /* names with blanks between */
    size_t n = strlen(part);
    for (const char *at = lacks; (at = strstr(at, part)) != NULL; at += n)
        if ((at == lacks || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0'))
            return true;
    return false;
}

int build_check(const char *part, diag *d) {
    if (!build_lacks(part))
        return SARCINA_OK;
    diag_error(d, "this build of the program leaves out %s", part);
    return diag_help(d, "it was configured with -DSARCINA_WITHOUT=...; configure it without that");
}
