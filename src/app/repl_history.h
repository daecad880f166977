/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What was typed, kept across sessions in $XDG_STATE_HOME/sarcina/history (~/.local/state without it): one entry a
 * line, a block with its line ends as \n, a backslash as \\. Entries are added to the file as they are typed, so
 * sessions side by side lose nothing; a file that has grown long is cut to its newest entries when it is read. */
#ifndef SARCINA_APP_REPL_HISTORY_H
#define SARCINA_APP_REPL_HISTORY_H

/* The file's name in new memory, for whoever asks with the environment as it is; NULL: there is no home for it. */
char *repl_history_path(void);

/* Gives the file's entries to readline. A file that is not there is none. */
void repl_history_load(const char *path);

/* Adds an entry to readline's list and to the file, unless it is the one before again. 0, or errno: the file cannot be
 * written. path NULL: the list alone. */
int repl_history_add(const char *path, const char *entry);

#endif
