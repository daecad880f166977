/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What commands keep beside the scene: the schedule of output, and what `run` and `restart` remember. One a scene; the
 * interpreter's client (interp_client). */
#ifndef SARCINA_COMMAND_SESSION_H
#define SARCINA_COMMAND_SESSION_H

#include "command/outputs.h"
#include "command/run_report.h"
#include "engine/archive.h"
#include "script/command.h"

/* Checkpoints written while a run goes on. */
typedef struct restart_schedule {
    args_cycles_value every; /* is_time false and cycles 0: off */
    char *files[2];          /* patterns; with two, taken in turn */
    unsigned turn;
} restart_schedule;

/* A group whose test is made anew at every look. */
typedef struct dynamic_group {
    char *name;
    expr *test;
} dynamic_group;

typedef struct past past;
typedef struct watch watch;

typedef struct session {
    interp *in;
    watch *watch; /* NULL: nothing is watched */
    past *past;   /* what a prompt has run (past.h); NULL: there has been none */
    outputs *out;
    restart_schedule restart;
    run_report report;
    /* of the last run, for those that leave them out; NaN: none yet */
    double grow_time;   /* s */
    double relax_time;  /* s; 0: no relaxation */
    double relax_force; /* 1e-21 N; 0: by time */
    dynamic_group *dynamic;
    size_t ndynamic, dynamic_capacity;
    int group_depth;           /* of dynamic groups that are being looked at within others */
    struct forecast *forecast; /* of a check; NULL */
    bool in_every;             /* a command of `run ... every` is running */
    bool told_replaced;        /* that a group was replaced, not added to */
} session;

session *session_of(interp *in);

/* Flags the cells of a group (row of the class "group"): one a cell row. */
int session_members(interp *in, int group, bool *flags, diag *d);

/* The same on a view that stands already; i: row as in the class. */
int session_group_members(interp *in, size_t i, const view *v, bool *flags, diag *d);

/* Row of a group (all, a species, a region, one of its own) in the class "group"; -1: there is none. */
int session_find_group(interp *in, const char *name);

/* An error when there are so many groups that this one could not be made. */
int session_check_group(interp *in, const char *name, diag *d);

/* The bit of a group that cells can be put into, made where there is none (session_check_group must have passed); a
 * dynamic one of that name goes. */
int session_define_group(interp *in, const char *name);

/* An error when something that stands still uses this region or group. */
int session_check_unused(interp *in, const char *noun, const char *name, diag *d);

/* Takes out the dynamic groups. */
void session_drop_groups(session *s);

/* All that a restart file holds: journal, variables, state, where outputs stand. */
int session_save(interp *in, const char *path, diag *d);
int session_load(interp *in, const char *path, diag *d);

/* The same in memory. Laying it in empties the scene first; a check stops at the names. */
archive *session_pack(interp *in);
int session_unpack(interp *in, const archive *a, diag *d);

/* Writes the file of the restart schedule whose turn it is. */
int session_write_checkpoint(interp *in, diag *d);

/* Takes out the scene and its outputs; variables stay. */
void session_clear(interp *in);

/* `*` in a file's name is the step. The caller frees. */
char *session_file(const char *pattern, uint64_t step);

#endif
