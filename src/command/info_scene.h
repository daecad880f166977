/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is in the scene, what acts on it, and what each part of it costs: the lines of `info scene`, which begin the
 * log of a run, too. */
#ifndef SARCINA_COMMAND_INFO_SCENE_H
#define SARCINA_COMMAND_INFO_SCENE_H

#include "script/command.h"

/* Puts a line: interp_print, interp_log. */
typedef void (*info_put)(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3)));

void info_scene_show(interp *in, info_put put);

/* The lines of species, and of forces, alone. */
void info_scene_species(interp *in, info_put put);
void info_scene_forces(interp *in, info_put put);

#endif
