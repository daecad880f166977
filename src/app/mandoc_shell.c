/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion of sarcina's command line by bash, from the tables of options and commands. It needs nothing but bash:
 * not the package bash-completion. */
#include "app/mandoc.h"

#include "app/options.h"

#include <stdlib.h>
#include <string.h>

static void put_commands(page *p, const command_table *t) {
    const char *name;
    for (size_t i = 0; (name = signature_command(t, i)); i++)
        page_put(p, "%s%s", i ? " " : "", name);
}

static void put_options(page *p) {
    option_text o;
    bool first = true;
    for (size_t i = 0; options_list(i, &o); i++)
        if (o.takes) {
            page_put(p, "%s-%s", first ? "" : " ", o.name);
            first = false;
        }
}

/* What completes the first word behind an option; the words of "a|b|FILE" that are not capitals are offered. */
static void put_case(page *p, const option_text *o) {
    page words = {0};
    bool files = strstr(o->takes, "FILE") || strstr(o->takes, "PATH");
    char copy[128], *save;
    strncpy(copy, o->takes, sizeof copy - 1);
    copy[sizeof copy - 1] = '\0';
    for (char *w = strtok_r(copy, "|", &save); w; w = strtok_r(NULL, "|", &save))
        if (*w >= 'a' && *w <= 'z')
            page_put(&words, "%s%s", words.n ? " " : "", w);
    page_put(p, "        %s)", o->name);
    if (strcmp(o->takes, "COMMAND") == 0)
        page_put(p, " _sarcina_words \"$_sarcina_commands\"");
    else if (strncmp(o->takes, "NAME", 4) == 0)
        page_put(p, " _sarcina_words \"$(_sarcina_variables)\"");
    if (words.n)
        page_put(p, " _sarcina_words \"%s\"", words.chars);
    if (strcmp(o->takes, "FILE") == 0)
        page_put(p, " _sarcina_scripts");
    else if (files)
        page_put(p, "%s _sarcina_files", words.n ? ";" : "");
    page_put(p, " ;;\n");
    free(words.chars);
}

static void put_body(page *p) {
    page_put(
        p, "%s",
        "\n_sarcina_words() {\n"
        "    local word\n"
        "    while IFS= read -r word; do COMPREPLY+=(\"$word\"); done < <(compgen -W \"$1\" -- \"$_sarcina_word\")\n"
        "}\n\n"
        "# scripts, and folders on the way to them\n"
        "_sarcina_files() {\n"
        "    local file\n"
        "    while IFS= read -r file; do\n"
        "        if [[ -d $file ]]; then COMPREPLY+=(\"$file/\"); else COMPREPLY+=(\"$file\"); fi\n"
        "    done < <(compgen -f -- \"$_sarcina_word\")\n"
        "    compopt -o filenames 2>/dev/null || true\n"
        "}\n\n"
        "_sarcina_scripts() {\n"
        "    local file\n"
        "    while IFS= read -r file; do\n"
        "        if [[ -d $file ]]; then COMPREPLY+=(\"$file/\"); fi\n"
        "        if [[ $file == *.in || $file == *.sarcina ]]; then COMPREPLY+=(\"$file\"); fi\n"
        "    done < <(compgen -f -- \"$_sarcina_word\")\n"
        "    compopt -o filenames 2>/dev/null || true\n"
        "}\n\n"
        "# what the scripts on the command line let be set: variable NAME default\n"
        "_sarcina_variables() {\n"
        "    local word\n"
        "    for word in \"${COMP_WORDS[@]}\"; do\n"
        "        [[ -f $word ]] && sed -n 's/^[[:space:]]*variable[[:space:]]\\{1,\\}\\([A-Za-z_0-9]*\\)"
        "[[:space:]]\\{1,\\}default[[:space:]].*/\\1/p' \"$word\"\n"
        "    done | sort -u\n"
        "}\n\n"
        "_sarcina() {\n"
        "    local _sarcina_word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
        "    COMPREPLY=()\n"
        "    if [[ $before == -* ]]; then\n"
        "        before=${before#-}\n"
        "        case ${before#-} in\n");
}

static void put_end(page *p) {
    page_put(p, "%s",
             "        *) before= ;;\n"
             "        esac\n"
             "        [[ -z $before ]] || return 0\n"
             "    fi\n"
             "    if [[ $_sarcina_word == -* ]]; then\n"
             "        _sarcina_words \"$_sarcina_options\"\n"
             "    else\n"
             "        _sarcina_scripts\n"
             "    fi\n"
             "}\n"
             "complete -F _sarcina sarcina\n");
}

void mandoc_shells(mandoc *m) {
    page p = {0};
    option_text o;
    page_put(&p, "# SPDX-License-Identifier: GPL-3.0-or-later\n# shellcheck shell=bash\n"
                 "# Generated from the tables of the program by scripts/manual: do not edit.\n"
                 "# Completion of sarcina's command line in bash: source it, or put it where bash-completion looks.\n\n"
                 "_sarcina_options='");
    put_options(&p);
    page_put(&p, "'\n_sarcina_commands='");
    put_commands(&p, m->commands);
    page_put(&p, "'\n");
    put_body(&p);
    for (size_t i = 0; options_list(i, &o); i++)
        if (o.takes && *o.takes)
            put_case(&p, &o);
    put_end(&p);
    mandoc_write(m, "completions/sarcina", &p);
    free(p.chars);
}
