/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quit, echo, log, shell: what concerns the program around the script. */
#include "command/commands.h"

#include "base/table.h"

static int run_quit(interp *in, const args *a, diag *d) {
    (void)d;
    interp_quit(in, args_given(a, "CODE") ? (int)args_int(a, "CODE") : 0);
    return SARCINA_OK;
}

static int run_echo(interp *in, const args *a, diag *d) {
    (void)d;
    interp_set_echo(in, (echo_mode)args_choice(a, "WHERE"));
    return SARCINA_OK;
}

static int run_log(interp *in, const args *a, diag *d) {
    int status = interp_open_log(in, args_text(a, "FILE"), args_given(a, "append"), d);
    if (status)
        diag_place(d, args_span(a, "FILE"));
    return status;
}

static int run_shell(interp *in, const args *a, diag *d) {
    return interp_shell(in, args_text(a, "COMMAND"), d);
}

static const param quit_params[] = {{"CODE:int[0,255]?", "exit code; 0"}};
static const param echo_params[] = {{"WHERE:{none|screen|log|both}", "where commands are shown as they run"}};
static const param log_params[] = {{"FILE:fileoff", "where everything is logged from here on; off: nowhere"},
                                   {"append:nothing", "behind what the file has"}};
static const param shell_params[] = {{"COMMAND:rest", "for the system's shell"}};

static const command_form forms[] = {
    {"quit CODE:int[0,255]?", quit_params, TABLE_COUNT(quit_params), "Ends the script", NULL, "quit", 0, run_quit, NULL,
     0},
    {"echo WHERE:{none|screen|log|both}", echo_params, TABLE_COUNT(echo_params), "Shows commands as they run",
     "Default: log.", "echo none\necho screen\necho log\necho both", 0, run_echo, NULL, 0},
    {"log FILE:fileoff", log_params, TABLE_COUNT(log_params), "Chooses the log file",
     "Without it and without -log, log.sarcina is written in the working folder once cells begin to move, and an "
     "earlier "
     "log.sarcina becomes log.sarcina.1 (or .2 ...). The log has commands as they run, everything printed, errors, and "
     "the sections of LAMMPS's: programs that read those find a table between 'Per MPI rank memory allocation' and "
     "'Loop "
     "time of' (a step is a cycle, an atom a cell).",
     "log run.log\nlog run.log append\nlog off", 0, run_log, NULL, 0},
    {"shell COMMAND:rest", shell_params, TABLE_COUNT(shell_params), "Runs a command of the system",
     "Refused under -safe.", "shell mkdir -p out", COMMAND_UNSAFE, run_shell, NULL, 0},
};

void command_program(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
