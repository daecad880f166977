/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Syntax files of editors, from the tables: Vim's syntax and file type, VS Code's grammar (a TextMate grammar, which
 * others read too). Both colour the same things: commands at the beginning of a line, words of blocks, styles,
 * keywords, values and functions, numbers with units, quotes, comments and what $ replaces. */
#include "app/mandoc.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/control.h"
#include "script/function.h"
#include "script/help.h"
#include "script/reduction.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- words, each once, in alphabetic order ----------------------------------------------------------------------- */

typedef struct word_list {
    const char **list;
    size_t n, capacity;
} word_list;

static int compare_words(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Only what is a word to an editor: letters, digits, _ and -. */
static bool is_word(const char *text) {
    size_t n = strlen(text);
    for (size_t i = 0; i < n; i++)
        if (!isalnum((unsigned char)text[i]) && text[i] != '_')
            return false;
    return n > 0 && isalpha((unsigned char)*text);
}

static void add(word_list *l, const char *text) {
    for (size_t i = 0; i < l->n; i++)
        if (strcmp(l->list[i], text) == 0)
            return;
    if (!is_word(text))
        return;
    l->list = alloc_grow(l->list, &l->capacity, l->n + 1, sizeof *l->list);
    l->list[l->n++] = text;
    qsort(l->list, l->n, sizeof *l->list, compare_words);
}

static bool has(const word_list *l, const char *text) {
    for (size_t i = 0; i < l->n; i++)
        if (strcmp(l->list[i], text) == 0)
            return true;
    return false;
}

/* The kinds of words that are coloured apart. */
enum { COMMANDS, BLOCKS, STYLES, KEYWORDS, VALUES, FUNCTIONS, KINDS };

typedef struct vocabulary {
    word_list kind[KINDS];
} vocabulary;

static void add_form(vocabulary *v, const signature *s) {
    for (size_t i = 1; i < s->nhead; i++) {
        if (s->head[i].kind == SLOT_LITERAL)
            add(&v->kind[STYLES], s->head[i].name);
        for (size_t k = 0; k < s->head[i].nchoices; k++)
            add(&v->kind[STYLES], s->head[i].choices[k]);
    }
    if (s->off_at)
        add(&v->kind[STYLES], "off");
    for (size_t i = 0; i < s->nkey; i++) {
        add(&v->kind[KEYWORDS], s->key[i].name);
        for (size_t k = 0; k < s->key[i].nchoices; k++)
            add(&v->kind[STYLES], s->key[i].choices[k]);
    }
}

static vocabulary collect(const command_table *t) {
    static const char *const flags[] = {"yes", "no", "all", "INF", "top", "side", "front", "iso", "xy", "random"};
    static const char *const words[] = {"where", "sd", "uniform", "normal", "lognormal",
                                        "in",    "to", "within",  "then",   "approx"};
    vocabulary v = {0};
    for (size_t i = 0; i < t->count; i++) {
        add(&v.kind[COMMANDS], t->list[i].head[0].name);
        add_form(&v, &t->list[i]);
    }
    for (size_t i = 0; i < control_word_count; i++)
        add(&v.kind[BLOCKS], control_words[i].name);
    for (size_t i = 0; i < TABLE_COUNT(flags); i++)
        add(&v.kind[STYLES], flags[i]);
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        add(&v.kind[KEYWORDS], words[i]);
    for (size_t i = 0; i < value_style_count; i++)
        add(&v.kind[VALUES], value_styles[i].name);
    add(&v.kind[VALUES], "pi");
    for (size_t i = 0; i < function_style_count; i++)
        add(&v.kind[FUNCTIONS], function_styles[i].name);
    for (size_t i = 0; i < reduction_style_count; i++)
        add(&v.kind[FUNCTIONS], reduction_styles[i].name);
    return v;
}

/* Words of a kind, `between` them: a word that is a keyword is no value to an editor, one that is either no style.
 * Commands and functions stand in places of their own and are not in the way of others. */
static void put_words(page *p, const vocabulary *v, int kind, const char *between) {
    bool first = true;
    for (size_t i = 0; i < v->kind[kind].n; i++) {
        const char *text = v->kind[kind].list[i];
        bool taken = (kind == STYLES && (has(&v->kind[VALUES], text) || has(&v->kind[KEYWORDS], text))) ||
                     (kind == VALUES && has(&v->kind[KEYWORDS], text));
        if (taken)
            continue;
        page_put(p, "%s%s", first ? "" : between, text);
        first = false;
    }
}

/* ---- Vim --------------------------------------------------------------------------------------------------------- */

/* Vim lets keywords win over matches: words that are commands too, at the beginning of a line, are a match. */
static void put_vim_list(page *p, const vocabulary *v, int kind, const char *group) {
    page words = {0}, also = {0};
    put_words(&words, v, kind, " ");
    char *save;
    size_t column = 0;
    for (char *w = strtok_r(words.chars, " ", &save); w; w = strtok_r(NULL, " ", &save)) {
        if (has(&v->kind[COMMANDS], w) || has(&v->kind[BLOCKS], w)) {
            page_put(&also, "%s%s", also.n ? "\\|" : "", w);
            continue;
        }
        if (column == 0 || column + strlen(w) > 100)
            column = 24, page_put(p, "\nsyntax keyword %s", group);
        page_put(p, " %s", w);
        column += strlen(w) + 1;
    }
    page_put(p, "\n");
    if (also.n)
        page_put(p, "syntax match %s /\\<\\%%(%s\\)\\>/\n", group, also.chars);
    free(words.chars);
    free(also.chars);
}

static void put_vim_begin(page *p, const char *what) {
    page_put(p,
             "\" SPDX-License-Identifier: GPL-3.0-or-later\n"
             "\" Generated from the tables of the program by scripts/manual: do not edit.\n"
             "\" Sarcina: %s\n",
             what);
}

static void write_vim_syntax(mandoc *m, const vocabulary *v) {
    page p = {0};
    put_vim_begin(&p, "scripts of the program that grows colonies of microbes");
    page_put(&p, "\nif exists('b:current_syntax')\n  finish\nendif\nsyntax case match\n");
    put_vim_list(&p, v, VALUES, "sarcinaValue");
    put_vim_list(&p, v, KEYWORDS, "sarcinaKeyword");
    put_vim_list(&p, v, STYLES, "sarcinaStyle");
    page_put(&p, "\nsyntax match sarcinaFunction /\\<\\%%(");
    put_words(&p, v, FUNCTIONS, "\\|");
    page_put(&p, "\\)\\ze(/\nsyntax match sarcinaCommand /^\\s*\\%%(");
    put_words(&p, v, COMMANDS, "\\|");
    page_put(&p, "\\)\\ze\\%%(\\s\\|$\\)/\nsyntax match sarcinaBlock /^\\s*\\%%(");
    put_words(&p, v, BLOCKS, "\\|");
    page_put(&p, "\\)\\ze\\%%(\\s\\|$\\)/\n");
    page_put(&p, "%s",
             "\n\" a number with its unit: 0.75um, 1.23/h, 1e-13N.s/m, 5%\n"
             "syntax match sarcinaNumber "
             "/\\%(\\k\\)\\@<![-+]\\?\\%(\\d\\+\\.\\?\\d*\\|\\.\\d\\+\\)\\%([eE][-+]\\?\\d\\+\\)\\?\\%(%\\|\\/"
             "\\?\\a[A-Za-z0-9./^-]*\\)\\?/\n"
             "syntax match sarcinaDollar /\\$\\$\\|\\$\\a\\>\\|\\${\\w\\+}\\|\\$([^\"']*)/ containedin=sarcinaString\n"
             "syntax region sarcinaString start=/\"/ end=/\"/ oneline\n"
             "syntax region sarcinaString start=/\\k\\@<!'/ end=/'/ oneline\n"
             "syntax region sarcinaString start=/\"\"\"/ end=/\"\"\"/\n"
             "syntax match sarcinaContinue /&\\ze\\s*\\%(#.*\\)\\?$/\n"
             "syntax match sarcinaComment /#.*$/ contains=@Spell\n\n"
             "highlight default link sarcinaCommand Statement\n"
             "highlight default link sarcinaBlock Conditional\n"
             "highlight default link sarcinaStyle Type\n"
             "highlight default link sarcinaKeyword Identifier\n"
             "highlight default link sarcinaValue Constant\n"
             "highlight default link sarcinaFunction Function\n"
             "highlight default link sarcinaNumber Number\n"
             "highlight default link sarcinaDollar PreProc\n"
             "highlight default link sarcinaString String\n"
             "highlight default link sarcinaContinue Special\n"
             "highlight default link sarcinaComment Comment\n\n"
             "let b:current_syntax = 'sarcina'\n");
    mandoc_write(m, "editors/vim/syntax/sarcina.vim", &p);
    free(p.chars);
}

/* *.in is anybody's: those that declare a species or create cells are ours. */
static void write_vim_detect(mandoc *m) {
    page p = {0};
    put_vim_begin(&p, "which files are its scripts");
    page_put(&p, "%s",
             "\nautocmd BufNewFile,BufRead *.sarcina set filetype=sarcina\n"
             "autocmd BufNewFile,BufRead *.in\n"
             "  \\ if search('^\\s*\\%(species\\|create_cells\\|read_restart\\|grow\\|relax\\)\\s', 'cnw') |\n"
             "  \\   set filetype=sarcina |\n"
             "  \\ endif\n");
    mandoc_write(m, "editors/vim/ftdetect/sarcina.vim", &p);
    p.n = 0;
    put_vim_begin(&p, "how its scripts are edited");
    page_put(&p, "%s",
             "\nif exists('b:did_ftplugin')\n  finish\nendif\nlet b:did_ftplugin = 1\n"
             "setlocal comments=:# commentstring=#\\ %s keywordprg=:!man\\ sarcina-\\%s\n"
             "let b:undo_ftplugin = 'setlocal comments< commentstring< keywordprg<'\n");
    mandoc_write(m, "editors/vim/ftplugin/sarcina.vim", &p);
    free(p.chars);
}

/* ---- VS Code ----------------------------------------------------------------------------------------------------- */

static void put_rule(page *p, const char *name, const char *match) {
    page_put(p, "    {");
    help_json_member(p, "name", name);
    help_json_member(p, "match", match);
    page_put(p, "},\n");
}

/* before, the words of a kind as one of them, behind. */
static void put_word_rule(page *p, const vocabulary *v, int kind, const char *name, const char *before,
                          const char *behind) {
    page match = {0};
    page_put(&match, "%s(?:", before);
    put_words(&match, v, kind, "|");
    page_put(&match, ")%s", behind);
    put_rule(p, name, match.chars);
    free(match.chars);
}

static void put_quote(page *p, const char *begin, const char *end, bool last) {
    page_put(p, "    {\"name\": \"string.quoted.sarcina\", ");
    page_put(p, "\"begin\": ");
    help_json_text(p, begin);
    page_put(p, ", \"end\": ");
    help_json_text(p, end);
    page_put(p, ", \"patterns\": [{\"include\": \"#dollar\"}]}%s\n", last ? "" : ",");
}

static void write_grammar(mandoc *m, const vocabulary *v) {
    page p = {0};
    page_put(&p, "{\n  \"comment\": \"Generated from the tables of the program by scripts/manual: do not edit.\",\n"
                 "  \"name\": \"Sarcina\",\n  \"scopeName\": \"source.sarcina\",\n"
                 "  \"fileTypes\": [\"sarcina\", \"in\"],\n  \"patterns\": [\n");
    put_quote(&p, "\"\"\"", "\"\"\"", false);
    put_quote(&p, "\"", "\"|$", false);
    put_quote(&p, "(?<![\\w)\\]}.\"'])'", "'|$", false);
    put_rule(&p, "comment.line.number-sign.sarcina", "#.*$");
    put_rule(&p, "constant.character.escape.continuation.sarcina", "&(?=\\s*(?:#.*)?$)");
    put_word_rule(&p, v, BLOCKS, "keyword.control.sarcina", "^\\s*", "(?=\\s|$)");
    put_word_rule(&p, v, COMMANDS, "keyword.other.command.sarcina", "^\\s*", "(?=\\s|$)");
    put_word_rule(&p, v, FUNCTIONS, "support.function.sarcina", "\\b", "(?=\\()");
    put_word_rule(&p, v, STYLES, "storage.type.style.sarcina", "(?<![\\w.$])", "(?![\\w.])");
    put_word_rule(&p, v, KEYWORDS, "entity.other.attribute-name.keyword.sarcina", "(?<![\\w.$])", "(?![\\w.])");
    put_word_rule(&p, v, VALUES, "support.constant.value.sarcina", "(?<![\\w.$])", "(?!\\w)");
    put_rule(&p, "constant.numeric.sarcina",
             "(?<!\\w)[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?(?:%|/?[A-Za-z][A-Za-z0-9./^-]*)?");
    page_put(&p, "    {\"include\": \"#dollar\"}\n  ],\n  \"repository\": {\n    \"dollar\": {\"name\": "
                 "\"variable.other.sarcina\", \"match\": ");
    help_json_text(&p, "\\$\\$|\\$[A-Za-z]\\b|\\$\\{\\w+\\}|\\$\\([^\"']*?\\)(?![)])");
    page_put(&p, "}\n  }\n}\n");
    mandoc_write(m, "editors/vscode/syntaxes/sarcina.tmLanguage.json", &p);
    free(p.chars);
}

static void write_extension(mandoc *m) {
    page p = {0};
    page_put(&p,
             "{\n  \"name\": \"sarcina\",\n  \"displayName\": \"Sarcina\",\n"
             "  \"description\": \"Scripts of Sarcina, which grows colonies of microbes cell by cell\",\n"
             "  \"version\": \"%s\",\n  \"publisher\": \"sarcina\",\n  \"license\": \"GPL-3.0-or-later\",\n"
             "  \"engines\": {\"vscode\": \"^1.50.0\"},\n  \"categories\": [\"Programming Languages\"],\n"
             "  \"contributes\": {\n"
             "    \"languages\": [{\"id\": \"sarcina\", \"aliases\": [\"Sarcina\"], \"extensions\": [\".sarcina\", "
             "\".in\"],\n      \"configuration\": \"./language-configuration.json\"}],\n"
             "    \"grammars\": [{\"language\": \"sarcina\", \"scopeName\": \"source.sarcina\",\n"
             "      \"path\": \"./syntaxes/sarcina.tmLanguage.json\"}]\n  }\n}\n",
             SARCINA_VERSION);
    mandoc_write(m, "editors/vscode/package.json", &p);
    p.n = 0;
    page_put(&p, "%s",
             "{\n  \"comments\": {\"lineComment\": \"#\"},\n  \"brackets\": [[\"(\", \")\"], [\"{\", \"}\"], [\"[\", "
             "\"]\"]],\n"
             "  \"autoClosingPairs\": [[\"(\", \")\"], [\"{\", \"}\"], [\"[\", \"]\"], [\"\\\"\", \"\\\"\"]],\n"
             "  \"surroundingPairs\": [[\"(\", \")\"], [\"\\\"\", \"\\\"\"], [\"'\", \"'\"]],\n"
             "  \"indentationRules\": {\n"
             "    \"increaseIndentPattern\": \"^\\\\s*(?:if(?!.*\\\\bthen\\\\b)|elif|else|for|while|repeat)\\\\b\",\n"
             "    \"decreaseIndentPattern\": \"^\\\\s*(?:end|elif|else)\\\\b\"\n  }\n}\n");
    mandoc_write(m, "editors/vscode/language-configuration.json", &p);
    free(p.chars);
}

void mandoc_editors(mandoc *m) {
    vocabulary v = collect(m->commands);
    write_vim_syntax(m, &v);
    write_vim_detect(m);
    write_grammar(m, &v);
    write_extension(m);
    for (int i = 0; i < KINDS; i++)
        free(v.kind[i].list);
}
