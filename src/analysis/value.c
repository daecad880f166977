/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/value.h"

#include "analysis/bridging.h"
#include "analysis/cell.h"
#include "analysis/component.h"
#include "analysis/defects.h"
#include "analysis/ellipse.h"
#include "analysis/extent.h"
#include "analysis/linkage.h"
#include "analysis/mechanical.h"
#include "analysis/order.h"
#include "analysis/orientation.h"
#include "analysis/outline.h"
#include "analysis/plane.h"
#include "analysis/segregation.h"
#include "analysis/solid.h"
#include "analysis/state.h"
#include "analysis/texture.h"
#include "analysis/touching.h"
#include "base/table.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

static const char storck[] = "Storck et al. (2014), Biophys. J. 106:2037";

#define CELL_VALUE(id, dimension_, definition)                                                                         \
    {.name = #id, .scope = VALUE_CELL, .dimension = (dimension_), .summary = (definition), .cell = cell_##id},
#define STATE(id, dimension_, fields_, definition)                                                                     \
    {                                                                                                                  \
        .name = #id, .scope = VALUE_STATE, .dimension = (dimension_), .fields = (fields_), .summary = (definition),    \
        .measure = state_##id                                                                                          \
    }
#define ANALYSIS(id, dimension_, fields_, definition, source_, function)                                               \
    {                                                                                                                  \
        .name = #id, .scope = VALUE_ANALYSIS, .dimension = (dimension_), .fields = (fields_), .summary = (definition), \
        .source = (source_), .measure = (function)                                                                     \
    }

#define NEAR_ANALYSIS(id, dimension_, fields_, definition, function)                                                   \
    {                                                                                                                  \
        .name = #id, .scope = VALUE_ANALYSIS, .dimension = (dimension_), .fields = (fields_), .summary = (definition), \
        .near = true, .measure = (function)                                                                            \
    }

const value_style value_styles[] = {
    CELL_VALUES{.name = "species",
                .scope = VALUE_CELL,
                .dimension = "text",
                .summary = "name of its species",
                .text = cell_species},
    STATE(step, "number", NULL, "cycles done"),
    STATE(time, "time", NULL, "sum of the growth steps"),
    STATE(relaxed, "time", NULL, "sum of the relaxation"),
    STATE(cells, "number", NULL, "number of cells"),
    STATE(particles, "number", NULL, "number of particles"),
    STATE(links, "number",
          "internal:number,bend:number,twist:number,filial:number,stick:number,anchor:number,formed:number,"
          "broken:number",
          "number of links between cells and to the substratum; internal: springs inside cells; formed, broken: since "
          "the start"),
    STATE(caps, "number", "far:number,jolt:number,held:number,unsolved:number,clamped:number,lifted:number",
          "how often limits on motion were met since the start: steps refused and taken anew, shorter, because a "
          "particle would have gone too far, or because a force that came to act was too sudden for them; flexible "
          "cells held back in a step, or taken before their step was solved; particles that relaxations left within "
          "the clamp of force dlvo; new particles of divisions lifted out of the substratum"),
    STATE(wall, "time", NULL, "seconds of computing"),
    {.name = "fmax",
     .scope = VALUE_STATE,
     .dimension = "force",
     .summary = "largest net force on a particle, damping left out",
     .measure = mechanical_fmax},
    ANALYSIS(energy, "energy", MECHANICAL_ENERGY_FIELDS, "sum of all terms, each a field; kinetic energy included",
             NULL, mechanical_energy),
    ANALYSIS(thickness, "length", NULL, "height of the highest particle centre", storck, extent_thickness),
    ANALYSIS(orientation, "number", NULL, "mean over pairs of cells of 2 cos^2(theta) - 1, theta between their axes",
             storck, orientation_measure),
    ANALYSIS(ellipse, "area", "area:area,major:length,minor:length,angle:angle",
             "area of the smallest ellipse around the particle centres seen from above; its axes and the angle of the "
             "major one to x",
             storck, ellipse_measure),
    ANALYSIS(hull, "area", NULL, "area of the convex hull of the particle centres seen from above", NULL,
             plane_hull_measure),
    ANALYSIS(gyration, "length", NULL, "root mean square distance of the cells' centres from their mean", NULL,
             extent_gyration),
    ANALYSIS(clusters, "number", "largest:number,mean:number",
             "sets of cells that links join, single cells included; cells in the largest, and on average", NULL,
             component_clusters),
    ANALYSIS(filaments, "number", "longest:number,mean:number,ends:number,length:length,straightness:number",
             "chains of two or more cells that filial links join; cells in the longest, and on average; cells with one "
             "filial link; of those without branches the mean length along the centres, and distance of the ends over "
             "that length",
             NULL, component_filaments),
    ANALYSIS(link_strain, "number", "least:number,largest:number,filial:number,stick:number,anchor:number",
             "mean over the springs of links of (length - rest)/rest; the least, the largest, and the mean by kind",
             NULL, linkage_strain),
    ANALYSIS(link_age, "time", "oldest:time,filial:time,stick:time,anchor:time",
             "mean age of the links, in growth time; that of the oldest, and the mean by kind", NULL, linkage_age),
    ANALYSIS(coordination, "number", "pairs:number,alone:number",
             "mean number of cells that a cell touches, of those measured; pairs that touch; part that touches nobody",
             NULL, touching_coordination),
    ANALYSIS(contact_clusters, "number", "largest:number,mean:number",
             "sets of cells that touch, single cells included; cells in the largest, and on average", NULL,
             touching_clusters),
    NEAR_ANALYSIS(
        nematic, "number", "plane:number,pairs:number,radius:length",
        "mean of (3 cos^2(theta) - 1)/2 over pairs of cells with axes at most a radius apart (one mean length "
        "unless given), theta between their axes: 1 parallel, 0 at random; 2 cos^2 - 1 seen from above; pairs; "
        "the radius",
        order_nematic),
    {.name = "segregation",
     .scope = VALUE_ANALYSIS,
     .dimension = "number",
     .fields = "pairs:number,expected:number",
     .summary =
         "Moran's I of the generation (or of another number of each cell) over pairs of cells that touch (or are "
         "at most a radius apart): 1 when neighbours are alike, -1 when they are opposite; pairs; what it is "
         "when the same numbers are dealt at random, -1/(cells - 1)",
     .source = "Moran (1950), Biometrika 37:17",
     .near = true,
     .of = true,
     .measure = segregation_measure},
    ANALYSIS(mixing, "number", "observed:number,expected:number",
             "part of the cells whose nearest neighbour is of another species, over what it is when the same cells' "
             "species are dealt at random: 0 apart, 1 at random",
             NULL, order_mixing),
    ANALYSIS(layering, "number", "mean:number,first:number",
             "highest layer: a cell is in layer 1 + round(h/D), h from the lowest point of all to its own, D the mean "
             "diameter; mean layer, part in the first",
             NULL, order_layering),
    ANALYSIS(
        compactness, "number", "volume:volume",
        "volume of the cells over that of their convex hull (of the particle centres, grown by the mean radius); that "
        "hull's volume",
        NULL, solid_compactness),
    ANALYSIS(
        outline, "number", "area:area,perimeter:length,circularity:number,roughness:number",
        "of the cells seen from above, each grown by half the mean diameter, holes filled: circularity 4 pi area / "
        "perimeter^2; its area, perimeter, and roughness, the standard deviation over mean of its distance from the "
        "centroid",
        NULL, outline_measure),
    ANALYSIS(
        fractal, "number", NULL,
        "mass-radius dimension around the centre of mass, from two mean diameters to the radius of gyration: 1 for a "
        "filament, 2 for a disc, 3 for a ball",
        NULL, texture_fractal),
    ANALYSIS(verticalised, "number", NULL,
             "part of the cells with an axis that stand at more than 45 degrees to the plane", NULL,
             texture_verticalised),
    ANALYSIS(defects, "number", "plus:number,minus:number,density:areadensity",
             "half-turn disclinations of the axes seen from above, averaged over 1.5 mean cell lengths; those that "
             "turn with "
             "and against the way round, and all per area",
             NULL, defects_measure),
    ANALYSIS(
        bridging, "length", "ends:number,radius:length,reach:length",
        "length of the cells with filial links that lie beyond the floc, the sphere that holds 95 % of the others; "
        "filament ends there, the floc's radius, and how far filaments reach",
        NULL, bridging_measure),
};
const size_t value_style_count = TABLE_COUNT(value_styles);

const value_style *value_find(const char *name) {
    ptrdiff_t row = table_find(value_styles, value_style_count, sizeof *value_styles, name);
    return row < 0 ? NULL : &value_styles[row];
}

size_t value_field_count(const value_style *s) {
    size_t n = s->fields != NULL;
    for (const char *p = s->fields; p && (p = strchr(p, ',')); p++)
        n++;
    return n;
}

/* Beginning of the i-th field's text; NULL when there are fewer. */
static const char *field_text(const value_style *s, size_t i) {
    const char *p = s->fields;
    for (; p && i > 0; i--)
        if ((p = strchr(p, ',')))
            p++;
    return p;
}

int value_field_find(const value_style *s, const char *field) {
    size_t length = strlen(field);
    for (size_t i = 0; i < value_field_count(s); i++) {
        const char *p = field_text(s, i);
        if (strncmp(p, field, length) == 0 && p[length] == ':')
            return (int)i;
    }
    return -1;
}

void value_field(const value_style *s, size_t i, char name[32], dim *d) {
    char dimension[32];
    int read = sscanf(field_text(s, i), "%31[^:]:%31[^,]", name, dimension);
    bool known = read == 2 && dim_by_name(dimension, d);
    assert(known);
    (void)known;
}

dim value_dim(const value_style *s) {
    dim d = DIM_NONE;
    dim_by_name(s->dimension, &d);
    return d;
}
