/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fcntl rather than flock: it holds across machines on NFS, and children do not inherit it. The file says who holds the
 * lock, because the system tells only of processes of this machine. It is never deleted: a process that has opened it
 * and waits would hold the lock of a file that no other can find. */
#include "app/lock.h"

#include "base/alloc.h"
#include "base/path.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HOLDER_ROOM = 200 };

/* "process 4711 on node12", as its holder has written. */
static void read_holder(int file, char text[HOLDER_ROOM]) {
    ssize_t n = pread(file, text, HOLDER_ROOM - 1, 0);
    text[n > 0 ? n : 0] = '\0';
    text[strcspn(text, "\n")] = '\0';
    if (!*text)
        snprintf(text, HOLDER_ROOM, "another process");
}

static int write_holder(int file) {
    char machine[100] = "", text[HOLDER_ROOM];
    gethostname(machine, sizeof machine - 1);
    int n = snprintf(text, sizeof text, "process %ld on %s\n", (long)getpid(), machine);
    return ftruncate(file, 0) == 0 && pwrite(file, text, (size_t)n, 0) == n ? 0 : -1;
}

static int refuse(int file, const char *folder, diag *d) {
    char holder[HOLDER_ROOM];
    read_holder(file, holder);
    diag_error(d, "%s is being worked in by %s", folder, holder);
    return diag_help(d, "wait for it, or run this in another folder");
}

/* What fcntl says of file systems that have no locks. */
static bool has_no_locks(int error) {
    return error == ENOLCK || error == EINVAL || error == ENOSYS || error == EOPNOTSUPP;
}

static int take(lock *l, const char *folder, bool *unlocked, diag *d) {
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    int status = SARCINA_OK;
    if (fcntl(l->file, F_SETLK, &whole) == 0)
        return write_holder(l->file) == 0 ? SARCINA_OK : path_error(folder, d);
    if (has_no_locks(errno))
        *unlocked = true;
    else
        status = refuse(l->file, folder, d);
    close(l->file);
    l->file = -1;
    return status;
}

int lock_take(lock *l, const char *folder, bool *unlocked, diag *d) {
    char *path = alloc_format("%s/.lock", folder);
    *unlocked = false;
    l->file = -1;
    int status = path_make_folders(path, d);
    if (!status) {
        l->file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        status = l->file < 0 ? path_error(path, d) : take(l, folder, unlocked, d);
    }
    free(path);
    return status;
}

void lock_release(lock *l) {
    if (l->file < 0)
        return;
    int emptied = ftruncate(l->file, 0); /* a name that stays says nothing once the lock is gone */
    (void)emptied;
    close(l->file);
    l->file = -1;
}
