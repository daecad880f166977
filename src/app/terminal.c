/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/terminal.h"

#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

static const char *variable_of(const char *name) {
    const char *text = getenv(name);
    return text ? text : "";
}

/* A whole number of the environment, or what else counts. */
static int number_of(const char *name, int otherwise) {
    int n = atoi(variable_of(name));
    return n > 0 && n <= 10000 ? n : otherwise;
}

/* no-color.org: whatever it holds, if anything. Terminals of the xterm family have 256 colours since long. */
static int count_colors(bool terminal) {
    static const char *const families[] = {"xterm", "screen", "tmux", "rxvt", "linux", "vte", "konsole"};
    const char *kind = variable_of("TERM"), *more = variable_of("COLORTERM");
    if (!terminal || *variable_of("NO_COLOR") || !*kind || strcmp(kind, "dumb") == 0)
        return 0;
    if (strcmp(more, "truecolor") == 0 || strcmp(more, "24bit") == 0)
        return 1 << 24;
    for (size_t i = 0; i < sizeof families / sizeof *families; i++)
        if (strncmp(kind, families[i], strlen(families[i])) == 0)
            return 256;
    return strstr(kind, "256color") ? 256 : 0;
}

/* The first of these that is set decides, says POSIX. */
static bool is_unicode(void) {
    const char *locale = variable_of("LC_ALL");
    locale = *locale ? locale : variable_of("LC_CTYPE");
    locale = *locale ? locale : variable_of("LANG");
    return strcasestr(locale, "utf-8") || strcasestr(locale, "utf8");
}

interp_terminal terminal_of(FILE *screen) {
    struct winsize size;
    bool terminal = screen && isatty(fileno(screen));
    bool known = terminal && ioctl(fileno(screen), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
    return (interp_terminal){.columns = number_of("COLUMNS", known ? size.ws_col : 80),
                             .rows = number_of("LINES", known ? size.ws_row : 24),
                             .colors = count_colors(terminal),
                             .unicode = is_unicode()};
}
