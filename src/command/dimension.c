/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dimension N: cells move in space, or in the plane. */
#include "command/commands.h"

#include "base/table.h"
#include "engine/flat.h"

static int run_dimension(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int n = args_choice(a, "N") == 0 ? 2 : 3;
    if (n == s->dimension)
        return SARCINA_OK;
    if (s->colony->cell.count > 0) {
        diag_error(d, "dimension cannot change once there are cells");
        return diag_help(d, "write it before the first create_cells, or 'clear' first");
    }
    int status = n == 2 ? flat_check_scene(s, d) : SARCINA_OK;
    if (!status)
        s->dimension = n;
    return status;
}

static const param params[] = {{"N:{2|3}", "3: space; 2: the plane z = 0, a strict monolayer"}};

static const command_form forms[] = {
    {"dimension N:{2|3}", params, 1, "Whether cells move in space or in a plane",
     "Default: 3. In two dimensions the centres, axes and velocities of all cells lie in the plane z = 0 and stay "
     "there, "
     "to the bit: relaxations keep no z at all, which saves a seventh to a quarter of their work and a third of their "
     "vectors (man sarcina-cost); random directions (orient random, division random, jitter, "
     "snap) are drawn in the plane, and a region gives places where z is 0. Cells are bodies as ever: mass, volume and "
     "drag are those of spheres and rods. What acts along z is refused: substratum, force dlvo, force gravity, link "
     "anchor; and flexible cells, division planes 3, orient z. To be set before there are cells.",
     "clear\ndimension 2\nspecies s rod diameter 1um\nlink internal s\nforce collision\nforce damping\n"
     "create_cells s single 0 0 0 mass 2e-15kg orient random\nrelax 10ms\nclear\ndimension 3",
     COMMAND_DECLARES, run_dimension, NULL, 0},
};

void command_dimension(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}
