/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dump styles, one a file of this folder. */
#ifndef SARCINA_OUTPUT_DUMP_STYLES_H
#define SARCINA_OUTPUT_DUMP_STYLES_H

#include "output/dump.h"

#define DUMP_STYLES(X)                                                                                                 \
    X(image)                                                                                                           \
    X(movie)                                                                                                           \
    X(povray)                                                                                                          \
    X(custom)                                                                                                          \
    X(csv)                                                                                                             \
    X(vtk)                                                                                                             \
    X(xyz)                                                                                                             \
    X(link)

#define DUMP_DECLARE(name) extern const dump_style dump_##name;
DUMP_STYLES(DUMP_DECLARE)
#undef DUMP_DECLARE

#endif
