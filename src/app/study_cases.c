/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_cases.h"

#include "base/table.h"

#include <string.h>

/* ---- what is run ---- */

#define ECOLI(id, words, script_, options_, reference_, variant_)                                                      \
    {                                                                                                                  \
        .name = (id), .title = (words), .family = STUDY_ECOLI, .script = "ecoli/" script_, .options = (options_),      \
        .reference = (reference_), .variant = (variant_)                                                               \
    }
#define FLOC(id, words, script_, options_, reference_)                                                                 \
    {                                                                                                                  \
        .name = (id), .title = (words), .family = STUDY_FLOC, .script = "floc/" script_,                               \
        .options = "-var accuracy balanced" options_, .reference = (reference_)                                        \
    }
/* As in the original program: links of a dividing cell stay with the mother, links are looked at after every step. */
#define PUBLISHED "-var handover mother -var remodel 0s"

const char study_options[] = "-var film 100000 -var width 480 -var height 360";

const study_case study_cases[] = {
    ECOLI("default", "default", "default", "", "default", NULL),
    ECOLI("anchored", "anchored", "anchored", "", "anchor", NULL),
    ECOLI("anchored_2x", "anchored, break x 2", "anchored_2x", "", "anchor2x", NULL),
    ECOLI("anchored_half", "anchored, break x 1/2", "anchored_half", "", "anchor05x", NULL),
    ECOLI("filial", "filial", "filial", "", "filial", NULL),
    ECOLI("gliding", "gliding anchors", "gliding", "", NULL, NULL),
    ECOLI("anchored_published", "anchored", "anchored", PUBLISHED, "anchor", "anchored"),
    ECOLI("anchored_2x_published", "anchored, break x 2", "anchored_2x", PUBLISHED, "anchor2x", "anchored_2x"),
    ECOLI("anchored_half_published", "anchored, break x 1/2", "anchored_half", PUBLISHED, "anchor05x", "anchored_half"),
    ECOLI("filial_published", "filial", "filial", "-var remodel 0s", "filial", "filial"),
    FLOC("standard", "standard", "standard", "", "standard"),
    FLOC("high_oxygen", "high oxygen", "high_oxygen", "", "high"),
    FLOC("stiff", "stiff filaments", "stiff", "", "stiff"),
    FLOC("flexible", "flexible filaments", "flexible", "", "flexible"),
    FLOC("strong_sticking", "strong sticking", "strong_sticking", "", "strong"),
    FLOC("weak_sticking", "weak sticking", "weak_sticking", "", "weak"),
    FLOC("unbranched", "standard at 19.65 h", "standard", " -var cycles 131", "standard"),
    FLOC("branching", "branching at 19.65 h", "branching", "", "branch"),
    FLOC("spherical", "spherical floc formers at 19.65 h", "spherical", "", "sphere"),
    {.name = "standard_paper",
     .title = "standard, accuracy paper",
     .family = STUDY_FLOC,
     .script = "floc/standard",
     .options = "-var accuracy paper",
     .variant = "standard",
     .seeds = 6},
};
const size_t study_case_count = TABLE_COUNT(study_cases);

const study_case *study_case_find(const char *name) {
    ptrdiff_t row = table_find(study_cases, study_case_count, sizeof *study_cases, name);
    return row < 0 ? NULL : &study_cases[row];
}

/* ---- what is measured ---- */

const study_quantity study_quantities[] = {
    {"stack_time", STUDY_ECOLI, "time of first stacking: a particle centre above 0.75 um at the end of a step", "h",
     1 / 3600.0, 2, STUDY_SCALAR, "stacked.time", 0, "hours", NULL},
    {"stack_area", STUDY_ECOLI, "area of the smallest ellipse around all particle centres then", "um2", 1e12, 0,
     STUDY_SCALAR, "stacked.ellipse.area", 0, "area", NULL},
    {"stack_cells", STUDY_ECOLI, "cells then", "", 1, 0, STUDY_SCALAR, "stacked.cells", 0, "cells", NULL},
    {"C_16", STUDY_ECOLI, "orientation correlation when the colony reaches 16 cells (2 h)", "", 1, 3, STUDY_CELLS, "C",
     16, "C", NULL},
    {"C_100", STUDY_ECOLI, "the same at 100 cells", "", 1, 3, STUDY_CELLS, "C", 100, "C", NULL},
    {"C_end", STUDY_ECOLI, "the same at the end", "", 1, 3, STUDY_END, "C", 0, "C", NULL},
    {"thickness", STUDY_ECOLI, "height of the highest particle centre at the end", "um", 1e6, 2, STUDY_END, "thickness",
     0, "max_z_um", NULL},
    {"circularity", STUDY_ECOLI, "4 pi area / perimeter^2 of the outline at the end", "", 1, 3, STUDY_END,
     "shape.circularity", 0, NULL, NULL},
    {"cells", STUDY_ECOLI, "cells at the end", "", 1, 0, STUDY_END, "cells", 0, "n_cells", NULL},

    {"floc_cells", STUDY_FLOC, "cells at the end", "", 1, 0, STUDY_END, "cells", 0, "n_cells", NULL},
    {"filament_cells", STUDY_FLOC, "filament formers among them", "", 1, 0, STUDY_END, "nff", 0, "n_fil_cells", NULL},
    {"compactness", STUDY_FLOC, "volume of the cells over that of their convex hull, per mille", "1e-3", 1e3, 2,
     STUDY_END, "body", 0, NULL, NULL},
    {"gyration", STUDY_FLOC, "radius of gyration of the cells' centres", "um", 1e6, 2, STUDY_END, "gyration", 0,
     "Rg_um", NULL},
    {"clusters", STUDY_FLOC, "sets of cells that links join", "", 1, 2, STUDY_END, "clusters", 0, "clusters_links",
     NULL},
    {"outside", STUDY_FLOC, "part of the filaments' length beyond the sphere that holds 95 % of the floc formers", "",
     1, 3, STUDY_SCALAR, "outside", 0, "n_fil_beyond_r95", "n_fil_cells"},
    {"reach", STUDY_FLOC, "largest distance of a filament's cell from the centre of the floc formers", "um", 1e6, 1,
     STUDY_END, "beyond.reach", 0, "rmax_fil_um", NULL},
    {"captured", STUDY_FLOC, "part of the filament formers with a sticking link", "", 1, 3, STUDY_SCALAR, "captured", 0,
     NULL, NULL},
    {"piece", STUDY_FLOC, "filament formers per end of a filament", "", 1, 2, STUDY_SCALAR, "piece", 0, NULL, NULL},
};
const size_t study_quantity_count = TABLE_COUNT(study_quantities);

const study_quantity *study_quantity_find(const char *name) {
    ptrdiff_t row = table_find(study_quantities, study_quantity_count, sizeof *study_quantities, name);
    return row < 0 ? NULL : &study_quantities[row];
}

/* ---- what the paper prints ---- */

static const study_printed printed[] = {
    {"default", "stack_time", 3.8, 0},     {"default", "stack_area", 730, 80},
    {"anchored", "stack_time", 2.9, 0},    {"anchored", "stack_area", 210, 30},
    {"anchored_2x", "stack_time", 1.9, 0}, {"anchored_half", "stack_time", 3.08, 0},
    {"filial", "stack_time", 4.02, 0},     {"filial", "stack_area", 1100, 200},
    {"standard", "floc_cells", 369, 0},    {"high_oxygen", "floc_cells", 362, 0},
};

const study_printed *study_printed_find(const char *name, const char *quantity) {
    for (size_t i = 0; i < TABLE_COUNT(printed); i++)
        if (strcmp(printed[i].name, name) == 0 && strcmp(printed[i].quantity, quantity) == 0)
            return &printed[i];
    return NULL;
}

const study_growth study_growths[] = {
    {"standard", 383, 17, 369},
    {"high_oxygen", 399, 18, 362},
};
const size_t study_growth_count = TABLE_COUNT(study_growths);

/* ---- what it claims ---- */

const study_claim study_claims[] = {
    {"Anchored colonies grow thicker", "Effect of anchoring, Fig. 3B", "anchored", "default", "thickness", STUDY_MORE,
     0},
    {"Anchored colonies stack earlier", "Effect of anchoring, Fig. 3B", "anchored", "default", "stack_time", STUDY_LESS,
     0},
    {"... and over a smaller area", "Effect of anchoring", "anchored", "default", "stack_area", STUDY_LESS, 0},
    {"Anchors that stretch twice as far: stacking is earlier", "Effect of anchoring", "anchored_2x", "anchored",
     "stack_time", STUDY_LESS, 0},
    {"Anchors that stretch half as far: stacking is later", "Effect of anchoring", "anchored_half", "anchored",
     "stack_time", STUDY_MORE, 0},
    {"Anchoring disrupts the alignment: C falls quickly", "Effect of anchoring, Fig. 3A", "anchored", "default", "C_16",
     STUDY_LESS, 0},
    {"... eventually the colony loses its alignment", "Effect of anchoring, Fig. 3A", "anchored", "default", "C_end",
     STUDY_LESS, 0},
    {"Gliding anchors prevent stacking", "Effect of anchoring, data not shown there", "gliding", "default", "thickness",
     STUDY_LESS, 0},
    {"Filial colonies are less round", "Effect of filial links, Fig. 2C", "filial", "default", "circularity",
     STUDY_LESS, 0},
    {"Filial links keep the alignment at first", "Effect of filial links, Fig. 3A", "filial", "default", "C_100",
     STUDY_MORE, 0},
    {"Filial colonies cover more when they first stack", "Effect of filial links", "filial", "default", "stack_area",
     STUDY_MORE, 0},
    {"Filial links do not change when cells first stack", "Effect of filial links, Fig. 3B", "filial", "default",
     "stack_time", STUDY_SAME, 0.10},

    {"Strong sticking: a compact floc", "Strength of sticking links, Fig. 4F", "strong_sticking", "standard",
     "compactness", STUDY_MORE, 0},
    {"... with few outreaching filaments", "Strength of sticking links, Fig. 4F", "strong_sticking", "standard",
     "outside", STUDY_LESS, 0},
    {"Weak sticking: a very disperse structure", "Strength of sticking links, Fig. 4G", "weak_sticking", "standard",
     "compactness", STUDY_LESS, 0},
    {"... the floc breaks up", "Strength of sticking links, Fig. 4G", "weak_sticking", "standard", "clusters",
     STUDY_MORE, 0},
    {"High oxygen: a compact floc", "Relative growth rate, Fig. 4C", "high_oxygen", "standard", "compactness",
     STUDY_MORE, 0},
    {"... filaments inside it", "Relative growth rate, Fig. 4C", "high_oxygen", "standard", "outside", STUDY_LESS, 0},
    {"Stiff filaments: a similar floc", "Stiffness of filaments, Fig. 4D", "stiff", "standard", "gyration", STUDY_SAME,
     0.20},
    {"... no more interfloc bridging", "Stiffness of filaments, Fig. 4D", "stiff", "standard", "outside", STUDY_SAME,
     0.20},
    {"Flexible filaments: a similar floc", "Stiffness of filaments, Fig. 4E", "flexible", "standard", "gyration",
     STUDY_SAME, 0.20},
    {"... no less interfloc bridging", "Stiffness of filaments, Fig. 4E", "flexible", "standard", "outside", STUDY_SAME,
     0.20},
    {"Branching: a denser floc", "Branching of filaments, Fig. 5B", "branching", "unbranched", "compactness",
     STUDY_MORE, 0},
    {"... side chains at the expense of filament length", "Branching of filaments, Fig. 5B", "branching", "unbranched",
     "piece", STUDY_LESS, 0},
    {"... filaments do not extend far into the bulk", "Branching of filaments, Fig. 5B", "branching", "unbranched",
     "reach", STUDY_LESS, 0},
    {"Spherical floc formers capture fewer filaments", "Sphere-shaped floc formers, Fig. 5E", "spherical", "unbranched",
     "captured", STUDY_LESS, 0},
    {"... more of them lie outside", "Sphere-shaped floc formers, Fig. 5E", "spherical", "unbranched", "outside",
     STUDY_MORE, 0},
    {"... a more disperse floc", "Sphere-shaped floc formers, Fig. 5E", "spherical", "unbranched", "compactness",
     STUDY_LESS, 0},
};
const size_t study_claim_count = TABLE_COUNT(study_claims);
