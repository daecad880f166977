/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drives a program in a pseudo-terminal as somebody at the keyboard would, by a dialogue:
 *
 *     $ COMMAND          starts it, by the shell
 *     > TEXT             waits for a prompt, then types TEXT and Enter
 *     : KEYS             waits for a prompt, then types KEYS; <Tab> <Enter> <C-c> <C-d> <Up> <Down> <Esc> are keys
 *     + KEYS             types them at once
 *     < TEXT             waits until TEXT is on the screen, behind what was waited for before
 *     !< TEXT            at the next prompt TEXT has not been on the screen since the last keys
 *     ? CODE             waits until the program has ended, with this exit code
 *     | COMMAND          a shell command that must succeed
 *     size ROWS COLUMNS  the terminal's new size
 *     env NAME=VALUE     for what is started from here on
 *
 * Lines that begin with # and empty lines are for readers. Everything happens in a new empty folder, which is $HOME,
 * with the names given behind the dialogue as NAME=VALUE in the environment. It waits for texts, never for times; what
 * does not come within a minute will not. Usage: drive DIALOGUE [NAME=VALUE...] */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { PATIENCE = 60, SCREEN_MAX = 1 << 20 }; /* s; bytes */

static struct {
    int terminal;
    pid_t process;         /* 0: none */
    char *screen;          /* what was printed, without escape sequences and carriage returns */
    size_t n, seen, typed; /* its length; behind what was waited for; length when keys were typed last */
    int escape;            /* state of the escape sequence that is being read */
    size_t line;           /* of the dialogue */
    struct winsize size;
} s = {.terminal = -1, .size = {.ws_row = 50, .ws_col = 200}};

static const char *dialogue;

static _Noreturn void fail(const char *what, const char *text) {
    size_t from = s.n > 1500 ? s.n - 1500 : 0;
    fprintf(stderr, "%s:%zu: %s%s\n--- the end of the screen:\n%s\n---\n0 passed, 1 failed\n", dialogue, s.line, what,
            text, s.screen + from);
    if (s.process > 0) /* -1 would be every process there is */
        kill(s.process, SIGKILL);
    exit(1);
}

/* ---- the screen -------------------------------------------------------------------------------------------------- */

/* 0: plain text; 1: behind ESC; 2: in ESC [ ... up to a letter; 3: in ESC ] ... up to a bell. */
static void put(char c) {
    if (s.escape == 1) {
        s.escape = c == '[' ? 2 : c == ']' ? 3 : 0;
    } else if (s.escape == 2) {
        s.escape = c >= '@' && c <= '~' ? 0 : 2;
    } else if (s.escape == 3) {
        s.escape = c == '\a' ? 0 : 3;
    } else if (c == '\033') {
        s.escape = 1;
    } else if (c != '\r' && c != '\a' && s.n + 1 < SCREEN_MAX) {
        s.screen[s.n++] = c;
        s.screen[s.n] = '\0';
    }
}

/* Reads what there is, waiting for it at most so long; false: nothing came, or the program has closed its side. */
static bool read_screen(int milliseconds) {
    char bytes[4096];
    struct pollfd p = {.fd = s.terminal, .events = POLLIN};
    if (poll(&p, 1, milliseconds) <= 0)
        return false;
    ssize_t got = read(s.terminal, bytes, sizeof bytes);
    for (ssize_t i = 0; i < got; i++)
        put(bytes[i]);
    return got > 0;
}

/* Whether the program is at its end; it stays to be waited for. */
static bool has_ended(void) {
    siginfo_t info = {0};
    return waitid(P_PID, (id_t)s.process, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
}

/* Where text stands behind what was seen; NULL when it does not come. */
static const char *wait_for(const char *text) {
    time_t end = time(NULL) + PATIENCE;
    const char *found;
    while (!(found = strstr(s.screen + s.seen, text)) && time(NULL) < end)
        if (!read_screen(1000) && has_ended())
            return strstr(s.screen + s.seen, text);
    return found;
}

static void expect(const char *text) {
    const char *found = wait_for(text);
    if (!found)
        fail("waited in vain for: ", text);
    s.seen = (size_t)(found - s.screen) + strlen(text);
}

/* Either prompt; moves behind it. */
static void expect_prompt(void) {
    static const char *const prompts[] = {"sarcina> ", "     ...> "};
    time_t end = time(NULL) + PATIENCE;
    for (;;) {
        const char *first = NULL;
        size_t length = 0;
        for (size_t i = 0; i < 2; i++) {
            const char *found = strstr(s.screen + s.seen, prompts[i]);
            if (found && (!first || found < first)) {
                first = found;
                length = strlen(prompts[i]);
            }
        }
        if (first) {
            s.seen = (size_t)(first - s.screen) + length;
            return;
        }
        if (time(NULL) >= end || (!read_screen(1000) && has_ended()))
            fail("waited in vain for a prompt", "");
    }
}

static void expect_not(const char *text) {
    if (!wait_for("> "))
        fail("waited in vain for a prompt", "");
    if (strstr(s.screen + s.typed, text))
        fail("should not be there: ", text);
}

/* ---- the keyboard ------------------------------------------------------------------------------------------------ */

static void send(const char *bytes, size_t n) {
    while (n > 0) {
        ssize_t sent = write(s.terminal, bytes, n);
        if (sent < 0 && errno != EINTR)
            fail("cannot type: ", strerror(errno));
        n -= sent > 0 ? (size_t)sent : 0;
        bytes += sent > 0 ? sent : 0;
    }
}

static void type(const char *keys) {
    static const struct {
        const char *name, *bytes;
    } named[] = {{"<Tab>", "\t"},    {"<Enter>", "\r"},    {"<C-c>", "\003"}, {"<C-d>", "\004"},
                 {"<Up>", "\033[A"}, {"<Down>", "\033[B"}, {"<Esc>", "\033"}};
    s.typed = s.n;
    while (*keys) {
        size_t i = 0;
        while (i < sizeof named / sizeof *named && strncmp(keys, named[i].name, strlen(named[i].name)) != 0)
            i++;
        if (i < sizeof named / sizeof *named) {
            send(named[i].bytes, strlen(named[i].bytes));
            keys += strlen(named[i].name);
        } else {
            send(keys++, 1);
        }
    }
}

/* ---- the program ------------------------------------------------------------------------------------------------- */

static void start(const char *command) {
    if (s.process)
        fail("still running when this starts: ", command);
    s.n = s.seen = s.typed = 0;
    s.screen[0] = '\0';
    s.process = forkpty(&s.terminal, NULL, NULL, &s.size);
    if (s.process < 0) { /* a chroot without /dev/pts, say */
        printf("no pseudo-terminal here, left out: %s\n0 passed, 0 failed\n", strerror(errno));
        exit(0);
    }
    if (s.process == 0) {
        char *line = NULL;
        if (asprintf(&line, "exec %s", command) > 0)
            execl("/bin/sh", "sh", "-c", line, (char *)NULL);
        _exit(127);
    }
    /* a terminal that answers Ctrl-C drops what is printed and typed at that very moment: what is waited for, perhaps
     */
    struct termios modes;
    if (tcgetattr(s.terminal, &modes) == 0) {
        modes.c_lflag |= NOFLSH;
        tcsetattr(s.terminal, TCSANOW, &modes);
    }
}

static void expect_end(int code) {
    int status;
    time_t end = time(NULL) + PATIENCE;
    while (read_screen(100) || (!has_ended() && time(NULL) < end)) {
    }
    if (!has_ended())
        fail("has not ended", "");
    waitpid(s.process, &status, 0);
    close(s.terminal);
    s.process = 0;
    char text[64];
    snprintf(text, sizeof text, "%d", WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
    if (atoi(text) != code)
        fail("ended with ", text);
}

static void resize(const char *text) {
    unsigned rows, columns;
    if (sscanf(text, "%u %u", &rows, &columns) != 2)
        fail("no size: ", text);
    s.size.ws_row = (unsigned short)rows;
    s.size.ws_col = (unsigned short)columns;
    if (s.process)
        ioctl(s.terminal, TIOCSWINSZ, &s.size);
}

/* ---- the dialogue ------------------------------------------------------------------------------------------------ */

static bool begins(const char *line, const char *with, const char **rest) {
    size_t n = strlen(with);
    *rest = line + n;
    return strncmp(line, with, n) == 0;
}

static void follow(char *line) {
    const char *rest;
    if (begins(line, "$ ", &rest)) {
        start(rest);
    } else if (begins(line, "> ", &rest) || strcmp(line, ">") == 0) {
        expect_prompt();
        type(line[1] ? rest : "");
        type("<Enter>");
    } else if (begins(line, ": ", &rest)) {
        expect_prompt();
        type(rest);
    } else if (begins(line, "+ ", &rest)) {
        type(rest);
    } else if (begins(line, "< ", &rest)) {
        expect(rest);
    } else if (begins(line, "!< ", &rest)) {
        expect_not(rest);
    } else if (begins(line, "? ", &rest)) {
        expect_end(atoi(rest));
    } else if (begins(line, "| ", &rest)) {
        if (system(rest) != 0)
            fail("failed: ", rest);
    } else if (begins(line, "size ", &rest)) {
        resize(rest);
    } else if (begins(line, "env ", &rest)) {
        char *value = strchr(line, '=');
        if (!value)
            fail("no NAME=VALUE: ", rest);
        *value = '\0';
        setenv(rest, value + 1, 1);
    } else if (*line && *line != '#') {
        fail("what is this: ", line);
    }
}

int main(int argc, char **argv) {
    char folder[] = "/tmp/sarcina-repl-XXXXXX", *line = NULL, *remove = NULL;
    size_t room = 0;
    FILE *f = argc > 1 ? fopen(argv[1], "r") : NULL;
    if (!f || !mkdtemp(folder) || chdir(folder) != 0) {
        fputs("usage: drive DIALOGUE [NAME=VALUE...]\n", stderr);
        return 2;
    }
    dialogue = argv[1];
    s.screen = calloc(SCREEN_MAX, 1);
    setenv("HOME", folder, 1);
    setenv("TERM", "xterm", 1);
    unsetenv("XDG_STATE_HOME");
    unsetenv("XDG_CONFIG_HOME");
    unsetenv("INPUTRC");
    for (int i = 2; i < argc; i++)
        putenv(argv[i]);
    while (getline(&line, &room, f) >= 0) {
        line[strcspn(line, "\n")] = '\0';
        s.line++;
        follow(line);
    }
    fclose(f);
    free(line);
    if (s.process)
        fail("still running at the end", "");
    if (asprintf(&remove, "rm -rf %s", folder) > 0 && system(remove) != 0)
        fail("cannot remove ", folder);
    free(remove);
    free(s.screen);
    puts("1 passed, 0 failed");
    return 0;
}
