/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statuses of calls, which are the program's exit codes. */
#ifndef SARCINA_STATUS_H
#define SARCINA_STATUS_H

typedef enum sarcina_status {
    SARCINA_OK = 0,
    SARCINA_ERROR = 1,     /* the script or the scene is at fault */
    SARCINA_USAGE = 2,     /* the command line is at fault */
    SARCINA_NUMERICAL = 3, /* the mechanics could not go on */
    SARCINA_EXPECT = 4,    /* an expect of the script failed */
    SARCINA_INTERRUPTED = 130
} sarcina_status;

#endif
