/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/foreign.h"

#include "base/alloc.h"
#include "base/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const foreign_word lammps[] = {
    {"fix", "there is no fix here: growth, division, force, link, substratum and run say what happens"},
    {"unfix", "there is no fix here: 'force dlvo off', 'growth NAME off' take a model out"},
    {"fix_modify", "there is no fix here: the same head again amends what it names: force dlvo kappa 4e7/m"},
    {"compute", "there is no compute here: analyze, or a formula: variable NAME equal mean(z)"},
    {"uncompute", "there is no compute here: 'analyze ID off'"},
    {"compute_modify", "there is no compute here: a formula says which cells: mean(z where ff)"},
    {"jump", "there is no jump here: use for/while/repeat ... end"},
    {"label", "there is no label here: use for/while/repeat ... end"},
    {"next", "there is no next here: use for NAME in ... end"},
    {"timestep", "the step is chosen by 'accuracy'; growth steps stand in 'run N grow DT'"},
    {"run_style", "the method is chosen by 'accuracy' or 'integrator'"},
    {"minimize", "write 'relax to 1e-16N within 60s'"},
    {"min_style", "write 'relax to 1e-16N within 60s'; the method is chosen by 'accuracy' or 'integrator'"},
    {"min_modify", "write 'relax to 1e-16N within 60s'; the method is chosen by 'accuracy' or 'integrator'"},
    {"create_atoms", "write create_cells"},
    {"create_bonds", "write 'link ...': links form by themselves, or at division"},
    {"create_box", "there is no box: space is open; 'region' names parts of it"},
    {"change_box", "there is no box: space is open; 'region' names parts of it"},
    {"boundary", "there is no box: space is open, above the substratum where there is one"},
    {"lattice", "there is no lattice: lengths carry their unit: create_cells NAME grid ... 2um 2um 0"},
    {"atom_style", "there is nothing to choose here: 'species NAME coccus' or 'species NAME rod' say what cells are"},
    {"atom_modify", "there is nothing to choose here"},
    {"pair_style", "write 'force collision', 'force dlvo'"},
    {"pair_coeff", "write 'force collision k ...', 'force dlvo ces ...'"},
    {"pair_modify", "write 'force collision k ...', 'force dlvo ces ...'"},
    {"bond_style", "write 'link internal NAME k ...'"},
    {"bond_coeff", "write 'link internal NAME k ...'; here E = k/2 (L - L0)^2, twice LAMMPS's K"},
    {"angle_style", "write 'link bend NAME k ...'"},
    {"angle_coeff", "write 'link bend NAME k ...'"},
    {"delete_bonds", "write 'link ... off'; a cell's links go with it: delete_cells"},
    {"special_bonds", "there is nothing to choose here: cells that are linked touch all the same"},
    {"kspace_style", "there are no long-range forces here: force dlvo acts between cells and substratum"},
    {"mass", "mass is a property of each cell: create_cells ... mass, set GROUP mass"},
    {"velocity", "write 'set GROUP vx 0'"},
    {"displace_atoms", "write 'set GROUP z z+1um'"},
    {"delete_atoms", "write delete_cells"},
    {"reset_timestep", "the step is the number of cycles and is not set"},
    {"neigh_modify", "write 'neighbor skin ...'; lists are rebuilt when they must be"},
    {"comm_style", "there is nothing to choose here"},
    {"comm_modify", "there is nothing to choose here"},
    {"newton", "there is nothing to choose here"},
    {"package", "write 'threads N'"},
    {"suffix", "write 'threads N'; the fastest code for the processor is chosen when the program starts"},
    {"partition", "write 'sarcina -replicates N' or 'sarcina -sweep NAME A,B,...'"},
    {"processors", "write 'threads N'"},
    {"rerun", "write read_restart, or create_cells NAME file FILE"},
    {"replicate", "write create_cells in a loop: for i in 1..3 ... end"},
    {"python", "write 'shell ...', or read the CSV files that thermo_modify and dump write"},
};

const foreign_word *foreign_list(size_t i, foreign_word *out) {
    if (i >= TABLE_COUNT(lammps))
        return NULL;
    *out = lammps[i];
    return out;
}

static const char *const closers[] = {"endif", "endfor", "endwhile", "endrepeat", "fi", "done", "next", "wend"};

bool foreign_explain(const char *name, diag *d) {
    for (size_t i = 0; i < TABLE_COUNT(lammps); i++)
        if (strcmp(lammps[i].name, name) == 0) {
            diag_error(d, "'%s' is LAMMPS's: %s", name, lammps[i].instead);
            return true;
        }
    for (size_t i = 0; i < TABLE_COUNT(closers); i++)
        if (strcmp(closers[i], name) == 0) {
            diag_error(d, "'%s' is not a command here; blocks are closed by end", name);
            return true;
        }
    if (strncmp(name, "if(", 3) == 0 || strncmp(name, "while(", 6) == 0) {
        diag_error(d, "unknown command '%s': a blank stands behind %.*s", name, (int)strcspn(name, "("), name);
        return true;
    }
    return false;
}

/* ---- LAMMPS's styles of group ----------------------------------------------------------------------------------- */

enum { WORDS_MAX = 32, TEST_MAX = 400 };

typedef struct test {
    char text[TEST_MAX];
    size_t n;
} test;

/* Appends a, between, b; before them, unless they are the first, `before`. */
static void put(test *t, const char *before, const char *a, const char *between, const char *b) {
    if (t->n < TEST_MAX)
        t->n += (size_t)snprintf(t->text + t->n, TEST_MAX - t->n, "%s%s%s%s", t->n ? before : "", a, between, b);
}

/* 7, 1:10 or 1:10:3 of `id` and `type`; a species is known by its name here. */
static void put_id(test *t, const char *key, char *word) {
    char *colon = strchr(word, ':');
    if (!colon) {
        bool number = word[strspn(word, "0123456789")] == '\0';
        put(t, " || ", number ? key : word, number ? " == " : "", number ? word : "");
        return;
    }
    *colon = '\0';
    char *to = colon + 1, *range = alloc_format("(%s >= %s && ", key, word);
    to[strcspn(to, ":")] = '\0';
    put(t, " || ", range, key, " <= ");
    put(t, "", to, ")", "");
    free(range);
}

/* type|id LOGICAL N, or a list of them. */
static void put_ids(test *t, const char *key, char **words, size_t n) {
    if (n >= 2 && strchr("<>=!", *words[0])) {
        bool between = strcmp(words[0], "<>") == 0 && n >= 3;
        put(t, "", key, between ? " >= " : words[0], words[1]);
        if (between)
            put(t, " && ", key, " <= ", words[2]);
        return;
    }
    for (size_t i = 0; i < n; i++)
        put_id(t, key, words[i]);
}

static bool translate(const char *style, char **words, size_t n, test *t) {
    static const struct {
        const char *style, *between;
    } joins[] = {{"union", " || "}, {"intersect", " && "}, {"subtract", " && !"}, {"region", " || "}};
    for (size_t k = 0; k < TABLE_COUNT(joins); k++)
        if (strcmp(style, joins[k].style) == 0) {
            for (size_t i = 0; i < n; i++)
                put(t, joins[k].between, words[i], "", "");
            return true;
        }
    bool type = strcmp(style, "type") == 0, id = strcmp(style, "id") == 0;
    if (type || id)
        put_ids(t, type ? "SPECIES" : "id", words, n);
    else if (strcmp(style, "empty") == 0 || strcmp(style, "clear") == 0)
        put(t, "", "0", "", "");
    else if (strcmp(style, "variable") == 0 && n)
        put(t, "", words[0], "", "");
    else
        return false;
    return true;
}

bool foreign_explain_form(const char *line, diag *d) {
    char *copy = alloc_copy(line), *save, *words[WORDS_MAX];
    size_t n = 0;
    for (char *w = strtok_r(copy, " \t", &save); w && n < WORDS_MAX; w = strtok_r(NULL, " \t", &save))
        words[n++] = w;
    test t = {.n = 0};
    bool is_group = n >= 3 && strcmp(words[0], "group") == 0;
    bool known = is_group && translate(words[2], words + 3, n - 3, &t);
    if (known) {
        diag_error(d, "'group ID %s' is LAMMPS's: here a group is a test of cells", words[2]);
        diag_help(d, "group %s where %s", words[1], t.n ? t.text : "TEST");
        if (strcmp(words[2], "type") == 0)
            diag_help(d, "a species is a group of its cells already; its name stands for it in a test");
        if (strcmp(words[2], "variable") == 0)
            diag_help(d, "'group ID dynamic TEST' is judged anew at every look");
    } else if (n == 3 && strcmp(words[2], "delete") == 0 && (is_group || strcmp(words[0], "region") == 0)) {
        diag_error(d, "'%s ID delete' is LAMMPS's: write '%s %s off'", words[0], words[0], words[1]);
        known = true;
    }
    free(copy);
    return known;
}
