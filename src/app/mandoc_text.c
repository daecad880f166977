/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text in mdoc(7), the macros of BSD manual pages: \ and - are escaped, a line must not begin with . or ', and each
 * sentence begins a line of its own, so that formatters set the space behind its end. */
#include "app/mandoc.h"

#include "base/alloc.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Pages say when their text was last worked over, not when they were generated. */
static const char date[] = "November 22, 2026";

void mandoc_begin(page *p, const char *name, int section, const char *summary) {
    char title[64];
    size_t n = 0;
    for (; name[n] && n + 1 < sizeof title; n++)
        title[n] = (char)toupper((unsigned char)name[n]);
    title[n] = '\0';
    page_put(p, ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
                ".\\\" Generated from the tables of the program by scripts/manual: do not edit.\n");
    page_put(p, ".Dd %s\n.Dt %s %d\n.Os Sarcina %s\n.Sh NAME\n.Nm %s\n.Nd ", date, title, section, SARCINA_VERSION,
             name);
    /* the one line that whatis shows begins with a small letter */
    page_put(p, "%c", tolower((unsigned char)*summary));
    mandoc_escape(p, summary + 1);
    page_put(p, "\n");
}

static void put_escaped(page *p, const char *text, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (text[i] == '\\')
            page_put(p, "\\e");
        else if (text[i] == '-')
            page_put(p, "\\-");
        else if (text[i] == '^')
            page_put(p, "\\(ha");
        else if (text[i] == '~')
            page_put(p, "\\(ti");
        else if (text[i] == '\'')
            page_put(p, "\\(aq");
        else if (text[i] == '`')
            page_put(p, "\\(ga");
        else if (text[i] == '"')
            page_put(p, "\\(dq");
        else
            page_put_n(p, text + i, 1);
}

void mandoc_escape(page *p, const char *text) {
    put_escaped(p, text, strlen(text));
}

/* A hyphen between letters is one; before a digit or alone it is a minus. */
static bool is_hyphen(const char *text, size_t i) {
    return text[i] == '-' && i > 0 && isalpha((unsigned char)text[i - 1]) && isalpha((unsigned char)text[i + 1]);
}

/* Whether a sentence ends here: a full stop before a blank and a capital. */
static bool ends_sentence(const char *text, size_t i, size_t n) {
    return strchr(".?!", text[i]) && i + 2 < n && text[i + 1] == ' ' &&
           (isupper((unsigned char)text[i + 2]) || text[i + 2] == '\'') && i > 1 && text[i - 1] != '.';
}

static void put_sentences(page *p, const char *text, size_t n) {
    bool begins = true;
    for (size_t i = 0; i < n; i++) {
        if (begins && strchr(".'", text[i]))
            page_put(p, "\\&");
        begins = false;
        if (is_hyphen(text, i))
            page_put(p, "-");
        else
            put_escaped(p, text + i, 1);
        if (ends_sentence(text, i, n)) {
            page_put(p, "\n");
            i++;
            begins = true;
        }
    }
    page_put(p, "\n");
}

void mandoc_text(page *p, const char *text) {
    while (*text) {
        size_t n = strcspn(text, "\n");
        if (n)
            put_sentences(p, text, n);
        else
            page_put(p, ".Pp\n");
        text += n + (text[n] == '\n');
    }
}

void mandoc_literal(page *p, const char *text) {
    page_put(p, ".Bd -literal -offset indent\n");
    while (*text) {
        size_t n = strcspn(text, "\n");
        if (n && strchr(".'", *text))
            page_put(p, "\\&");
        put_escaped(p, text, n);
        page_put(p, "\n");
        text += n + (text[n] == '\n');
    }
    page_put(p, ".Ed\n");
}

static int compare_names(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

void mandoc_see(page *p, const command_table *t, const char *names) {
    const char *list[64] = {"script"};
    size_t n = 1;
    char *copy = alloc_copy(names ? names : ""), *save;
    for (char *name = strtok_r(copy, " ", &save); name && n < 64; name = strtok_r(NULL, " ", &save))
        if (signature_page(t, name))
            list[n++] = name;
    qsort(list, n, sizeof *list, compare_names);
    page_put(p, ".Sh SEE ALSO\n.Xr sarcina 1");
    for (size_t i = 0; i < n; i++)
        page_put(p, " ,\n.Xr sarcina-%s 7", list[i]);
    page_put(p, "\n");
    free(copy);
}

static bool make_folders(char *path) {
    for (char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        bool made = mkdir(path, 0777) == 0 || errno == EEXIST;
        *slash = '/';
        if (!made)
            return false;
    }
    return true;
}

void mandoc_write(mandoc *m, const char *path, const page *p) {
    char *full = alloc_format("%s/%s", m->target, path);
    FILE *f = make_folders(full) ? fopen(full, "w") : NULL;
    bool written = f && fwrite(p->chars, 1, p->n, f) == p->n;
    written = f && fclose(f) == 0 && written;
    if (!written) {
        fprintf(stderr, "cannot write '%s': %s\n", full, strerror(errno));
        m->failed = true;
    }
    free(full);
}
