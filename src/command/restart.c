/* SPDX-License-Identifier: GPL-3.0-or-later */
/* write_restart, read_restart, restart: the whole scene in a file, to the bit. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/table.h"

#include <stdlib.h>
#include <unistd.h>

int session_write_checkpoint(interp *in, diag *d) {
    restart_schedule *r = &session_of(in)->restart;
    unsigned which = r->files[1] ? r->turn % 2 : 0;
    char *file = session_file(r->files[which], interp_scene(in)->step);
    r->turn++; /* before it is written: whoever resumes goes on with the other file */
    int status = session_save(in, file, d);
    free(file);
    return status;
}

static int run_write(interp *in, const args *a, diag *d) {
    char *file = session_file(args_text(a, "FILE"), interp_scene(in)->step);
    int status = session_save(in, file, d);
    free(file);
    return status;
}

/* In a check the file may not be there yet (the script itself writes it): then all names are unknown from here on. */
static int run_read(interp *in, const args *a, diag *d) {
    const char *file = args_text(a, "FILE");
    if (interp_checking(in) && access(file, R_OK) != 0) {
        forecast_unknown(in, "what the restart file holds, which is not there yet");
        interp_open_world(in);
        return SARCINA_OK;
    }
    return session_load(in, file, d);
}

static int run_restart(interp *in, const args *a, diag *d) {
    (void)d;
    restart_schedule *r = &session_of(in)->restart;
    for (int i = 0; i < 2; i++)
        free(r->files[i]);
    r->every = args_cycles(a, "N");
    r->files[0] = alloc_copy(args_text(a, "FILE"));
    r->files[1] = args_text(a, "FILE2") ? alloc_copy(args_text(a, "FILE2")) : NULL;
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)a;
    (void)d;
    session_of(in)->restart.every = (args_cycles_value){0};
    return SARCINA_OK;
}

static const param write_params[] = {{"FILE:file", "its name; * is the step"}};
static const param read_params[] = {{"FILE:file", "a file that write_restart or restart made"}};
static const param restart_params[] = {
    {"N:cycles[1,)", "cycles, or a time"},
    {"FILE:file", "the file; * is the step"},
    {"FILE2:file?", "a second file: the two are written in turn"},
};

static const command_form forms[] = {
    {"write_restart FILE:file", write_params, 1, "Writes the whole scene to a file",
     "State to the bit, species, forces, outputs, variables: a run that is read back goes on as if it had never "
     "stopped.",
     "write_restart colony.rst", 0, run_write, NULL, 0},
    {"read_restart FILE:file", read_params, 1, "Goes on from a restart file",
     "Takes the place of the scene. Variables set on the command line keep their value. Tables lose the rows after the "
     "file's step and go on.",
     "read_restart colony.rst", COMMAND_SHADOW, run_read, NULL, 0},
    {"restart N:cycles[1,) FILE:file FILE2:file?", restart_params, TABLE_COUNT(restart_params),
     "Writes restart files while a run goes on", NULL, "restart 10 safe.a.rst safe.b.rst", COMMAND_DECLARES,
     run_restart, NULL, 0},
    {"restart off", NULL, 0, "Writes no more restart files", NULL, "restart off", COMMAND_DECLARES, run_off, NULL, 0},
};

void command_restart(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
