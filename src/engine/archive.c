/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/archive.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "base/path.h"

#include <errno.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MAGIC "sarcina restart 1\n"
enum { NAME_MAX_BYTES = 64 };

/* Bytes that archives of several moments may have in common. */
typedef struct shared {
    size_t references;
    char bytes[];
} shared;

typedef struct block {
    char name[NAME_MAX_BYTES];
    shared *data;
    size_t n;
} block;

struct archive {
    block *list;
    size_t count, capacity;
};

archive *archive_create(void) {
    return alloc_zeroed(1, sizeof(archive));
}

static void release(shared *s) {
    if (--s->references == 0)
        free(s);
}

void archive_free(archive *a) {
    if (!a)
        return;
    for (size_t i = 0; i < a->count; i++)
        release(a->list[i].data);
    free(a->list);
    free(a);
}

void archive_put(archive *a, const char *name, const void *bytes, size_t n) {
    a->list = alloc_grow(a->list, &a->capacity, a->count + 1, sizeof *a->list);
    block *b = &a->list[a->count++];
    snprintf(b->name, sizeof b->name, "%s", name);
    b->n = n;
    b->data = alloc_zeroed(sizeof(shared) + n + 1, 1);
    b->data->references = 1;
    if (n)
        memcpy(b->data->bytes, bytes, n);
}

const char *archive_get(const archive *a, const char *name, size_t *n) {
    for (size_t i = 0; i < a->count; i++)
        if (strcmp(a->list[i].name, name) == 0) {
            if (n)
                *n = a->list[i].n;
            return a->list[i].data->bytes;
        }
    return NULL;
}

static bool is_same(const block *a, const block *b) {
    return strcmp(a->name, b->name) == 0 && a->n == b->n &&
           (a->data == b->data || memcmp(a->data->bytes, b->data->bytes, a->n) == 0);
}

bool archive_share(archive *a, const archive *b) {
    size_t same = 0;
    for (size_t i = 0; i < a->count && i < b->count; i++) {
        block *mine = &a->list[i];
        const block *other = &b->list[i];
        if (!is_same(mine, other))
            continue;
        same++;
        other->data->references++;
        release(mine->data);
        mine->data = other->data;
    }
    return same == a->count && same == b->count;
}

size_t archive_bytes(const archive *a) {
    size_t n = sizeof *a + a->capacity * sizeof *a->list;
    for (size_t i = 0; i < a->count; i++)
        n += a->list[i].n / a->list[i].data->references;
    return n;
}

static bool write_blocks(const archive *a, FILE *f) {
    bool good = fputs(MAGIC, f) >= 0;
    for (size_t i = 0; i < a->count && good; i++) {
        const block *b = &a->list[i];
        good = fprintf(f, "%s %zu %016" PRIx64 "\n", b->name, b->n, hash_bytes(HASH_BEGIN, b->data->bytes, b->n)) > 0 &&
               fwrite(b->data->bytes, 1, b->n, f) == b->n && fputc('\n', f) != EOF;
    }
    return good && fprintf(f, "end 0 0\n") > 0 && fflush(f) == 0;
}

/* Not a device or a pipe: those are written to, and nothing takes their place. */
static bool can_be_replaced(const char *path) {
    struct stat there;
    return stat(path, &there) != 0 || S_ISREG(there.st_mode);
}

static int write_beside(const archive *a, const char *path, diag *d) {
    char *temporary = alloc_format("%s.part", path);
    FILE *f = fopen(temporary, "wb");
    bool good = f && write_blocks(a, f) && fsync(fileno(f)) == 0;
    if (f)
        good = fclose(f) == 0 && good;
    good = good && rename(temporary, path) == 0;
    int status = good ? SARCINA_OK : path_error(path, d);
    if (!good && f)
        remove(temporary);
    free(temporary);
    return status;
}

int archive_write(const archive *a, const char *path, diag *d) {
    if (path_make_folders(path, d))
        return SARCINA_ERROR;
    if (can_be_replaced(path))
        return write_beside(a, path, d);
    FILE *f = path_open(path, "wb", d);
    if (!f)
        return SARCINA_ERROR;
    write_blocks(a, f);
    return path_close(f, path, d);
}

/* One block from f; *last at the end mark. False: the file is cut short or damaged. */
static bool read_block(archive *a, FILE *f, bool *last) {
    char name[NAME_MAX_BYTES];
    size_t n;
    uint64_t sum;
    if (fscanf(f, "%63s %zu %" SCNx64, name, &n, &sum) != 3 || fgetc(f) != '\n')
        return false;
    *last = strcmp(name, "end") == 0;
    if (*last)
        return true;
    long here = ftell(f);
    if (fseek(f, 0, SEEK_END) || (size_t)(ftell(f) - here) < n || fseek(f, here, SEEK_SET))
        return false;
    char *bytes = alloc_zeroed(n + 1, 1);
    bool good = fread(bytes, 1, n, f) == n && fgetc(f) == '\n' && hash_bytes(HASH_BEGIN, bytes, n) == sum;
    if (good)
        archive_put(a, name, bytes, n);
    free(bytes);
    return good;
}

int archive_read(const char *path, archive **out, diag *d) {
    FILE *f = fopen(path, "rb");
    if (!f)
        return diag_error(d, "cannot read '%s': %s", path, strerror(errno));
    char magic[sizeof MAGIC] = "";
    bool known = fread(magic, 1, strlen(MAGIC), f) == strlen(MAGIC) && strcmp(magic, MAGIC) == 0;
    archive *a = archive_create();
    bool last = false, good = known;
    while (good && !last)
        good = read_block(a, f, &last);
    fclose(f);
    if (good) {
        *out = a;
        return SARCINA_OK;
    }
    archive_free(a);
    if (!known)
        return diag_error(d, "'%s' is no restart file of this version", path);
    return diag_error(d, "restart file '%s' is cut short or damaged", path);
}
