/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A restart file holds the commands that declared things (the journal), the variables, the state to the bit, and where
 * outputs stand. Reading it replays the journal into an empty scene and then lays the state in. */
#include "command/session.h"

#include "command/forecast.h"

#include "base/alloc.h"
#include "engine/snapshot.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

session *session_of(interp *in) {
    return interp_client(in);
}

int session_members(interp *in, int group, bool *flags, diag *d) {
    view v = scene_view(interp_scene(in));
    return session_group_members(in, (size_t)group, &v, flags, d);
}

char *session_file(const char *pattern, uint64_t step) {
    const char *star = strchr(pattern, '*');
    if (!star)
        return alloc_copy(pattern);
    return alloc_format("%.*s%" PRIu64 "%s", (int)(star - pattern), pattern, step, star + 1);
}

void session_clear(interp *in) {
    session *s = session_of(in);
    if (interp_checking(in))
        forecast_clear(in);
    run_report_end_loop(in, &s->report);
    scene_clear(interp_scene(in));
    outputs_clear(s->out);
    session_drop_groups(s);
    interp_journal_clear(in);
    for (int i = 0; i < 2; i++) {
        free(s->restart.files[i]);
        s->restart.files[i] = NULL;
    }
    s->restart.every = (args_cycles_value){0};
    s->restart.turn = 0;
    s->grow_time = s->relax_time = NAN;
    s->relax_force = 0;
}

/* The journal's texts, each ended by a zero byte. */
static void put_journal(const interp *in, archive *a) {
    size_t n = 0, used = 0;
    for (size_t i = 0; i < interp_journal_count(in); i++)
        n += strlen(interp_journal(in, i)) + 1;
    char *all = alloc_zeroed(n, 1);
    for (size_t i = 0; i < interp_journal_count(in); i++) {
        size_t length = strlen(interp_journal(in, i)) + 1;
        memcpy(all + used, interp_journal(in, i), length);
        used += length;
    }
    archive_put(a, "journal", all, n);
    free(all);
}

#define SESSION_FORMAT "grow %a relax %a force %a turn %u"

archive *session_pack(interp *in) {
    session *s = session_of(in);
    archive *a = archive_create();
    put_journal(in, a);
    char *variables = interp_variables_save(in);
    archive_put(a, "variables", variables, strlen(variables));
    free(variables);
    char *run = alloc_format(SESSION_FORMAT, s->grow_time, s->relax_time, s->relax_force, s->restart.turn);
    archive_put(a, "run", run, strlen(run));
    free(run);
    snapshot_save(interp_scene(in), a);
    outputs_save(s->out, a);
    return a;
}

int session_save(interp *in, const char *path, diag *d) {
    archive *a = session_pack(in);
    int status = archive_write(a, path, d);
    archive_free(a);
    return status;
}

static int replay_journal(interp *in, const archive *a, diag *d) {
    size_t n = 0, count = 0;
    const char *text = archive_get(a, "journal", &n);
    if (!text)
        return diag_error(d, "the restart file has no journal");
    const char **texts = alloc_zeroed(n, sizeof *texts);
    for (size_t at = 0; at < n; at += strlen(text + at) + 1)
        texts[count++] = text + at;
    int status = interp_journal_replay(in, texts, count, d);
    free(texts);
    return status;
}

/* Lays an archive into an emptied scene; a check stops at the names. */
int session_unpack(interp *in, const archive *a, diag *d) {
    session *s = session_of(in);
    session_clear(in);
    const char *variables = archive_get(a, "variables", NULL), *run = archive_get(a, "run", NULL);
    /* declarations may name variables: all are there before, and have their values after */
    int status = variables ? interp_variables_load(in, variables, d) : SARCINA_OK;
    if (!status)
        status = replay_journal(in, a, d);
    if (!status && variables)
        status = interp_variables_load(in, variables, d);
    if (!status && run)
        sscanf(run, "grow %la relax %la force %la turn %u", &s->grow_time, &s->relax_time, &s->relax_force,
               &s->restart.turn);
    if (!status && !interp_checking(in))
        status = snapshot_load(interp_scene(in), a, d);
    if (!status && !interp_checking(in))
        status = outputs_load(s->out, a, d);
    return status;
}

int session_load(interp *in, const char *path, diag *d) {
    archive *a;
    int status = archive_read(path, &a, d);
    if (status)
        return status;
    /* what stands is kept, to go back to when the file does not fit */
    archive *before = interp_checking(in) ? NULL : session_pack(in);
    status = session_unpack(in, a, d);
    if (status && before)
        session_unpack(in, before, NULL);
    if (!status && interp_checking(in))
        status = forecast_note_restart(in, path, a, d);
    archive_free(before);
    archive_free(a);
    return status;
}
