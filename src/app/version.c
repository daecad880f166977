/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/version.h"

#include "base/alloc.h"

char *version_text(void) {
    return *version_commit ? alloc_format("%s (%s)", SARCINA_VERSION, version_commit) : alloc_copy(SARCINA_VERSION);
}
