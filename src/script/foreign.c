/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/foreign.h"

#include "base/table.h"

#include <string.h>

static const struct {
    const char *name, *instead;
} lammps[] = {
    {"fix", "there is no fix here: growth, division, force, link, substratum and run say what happens"},
    {"unfix", "there is no fix here: 'force dlvo off', 'growth NAME off' take a model out"},
    {"compute", "there is no compute here: analyze, or a formula: variable NAME equal mean(z)"},
    {"uncompute", "there is no compute here: 'analyze ID off'"},
    {"jump", "there is no jump here: use for/while/repeat ... end"},
    {"label", "there is no label here: use for/while/repeat ... end"},
    {"next", "there is no next here: use for NAME in ... end"},
    {"timestep", "the step is chosen by 'accuracy'; growth steps stand in 'run N grow DT'"},
    {"minimize", "write 'relax to 1e-16N within 60s'"},
    {"create_atoms", "write create_cells"},
    {"create_box", "there is no box: space is open; 'region' names parts of it"},
    {"pair_style", "write 'force collision', 'force dlvo'"},
    {"pair_coeff", "write 'force collision k ...', 'force dlvo ces ...'"},
    {"bond_style", "write 'link internal NAME k ...'"},
    {"mass", "mass is a property of each cell: create_cells ... mass, set GROUP mass"},
    {"velocity", "write 'set GROUP vx 0'"},
    {"displace_atoms", "write 'set GROUP z z+1um'"},
    {"delete_atoms", "write delete_cells"},
    {"reset_timestep", "the step is the number of cycles and is not set"},
    {"newton", "there is nothing to choose here"},
    {"processors", "write 'threads N'"},
};

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
