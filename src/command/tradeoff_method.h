/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The methods that `tradeoff` is told to compare. */
#ifndef SARCINA_COMMAND_TRADEOFF_METHOD_H
#define SARCINA_COMMAND_TRADEOFF_METHOD_H

#include "engine/tradeoff.h"
#include "script/interp.h"

/* A preset of accuracy, or an integrator with what `integrator` lets stand behind its name: "verlet step 1ms". The
 * name is the text, which must outlive the method. Errors: neither of both; not a control; a number that is none, of
 * another dimension, or out of range. */
int tradeoff_method_read(interp *in, const char *text, tradeoff_method *out, diag *d);

#endif
