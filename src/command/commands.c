/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/commands.h"

#include "command/forecast.h"
#include "command/past.h"
#include "command/session.h"
#include "command/watch.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

static void *create_session(interp *in) {
    session *s = alloc_zeroed(1, sizeof *s);
    s->in = in;
    s->out = outputs_create(in);
    s->grow_time = NAN;
    s->relax_time = NAN;
    return s;
}

static void free_session(void *client) {
    session *s = client;
    outputs_free(s->out);
    free(s->restart.files[0]);
    free(s->restart.files[1]);
    session_drop_groups(s);
    free(s->dynamic);
    forecast_free(s->forecast);
    past_free(s->past);
    watch_free(s->watch);
    free(s);
}

static void end_loop(interp *in) {
    run_report_end_loop(in, &session_of(in)->report);
}

command_table *commands_create(units *u) {
    command_table *t = command_table_create(u);
    command_set_client(t, create_session, free_session, end_loop);
    command_set_checked(t, forecast_report);
    command_set_line(t, past_begin, past_ran);
#define COMMAND_ADD(name) command_##name(t);
    COMMAND_FILES(COMMAND_ADD)
#undef COMMAND_ADD
    command_pages(t);
    return t;
}
