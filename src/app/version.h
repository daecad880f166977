/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which program this is, for logs, reports of faults and referees. */
#ifndef SARCINA_APP_VERSION_H
#define SARCINA_APP_VERSION_H

/* The commit it was built from, with a + where its sources had changed since; "": not known. commit.cmake writes it. */
extern const char version_commit[];

/* "0.1.0 (1a2b3c4)"; the caller frees. */
char *version_text(void);

#endif
