/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/dump/styles.h"

#include "output/image.h"

#include "base/table.h"

static const param params[] = {IMAGE_PARAMS};

static int draw(const dump_frame *f, const char *path, diag *d) {
    canvas *c;
    int status = image_draw(f, f->options, &c, d);
    if (!status)
        status = canvas_write_png(c, path, d);
    canvas_free(c);
    return status;
}

const dump_style dump_image = {
    .name = "image",
    .summary = "a picture (PNG) of the cells as solid capsules and balls",
    .details =
        "COLOR is a colour (a name or \"#rrggbb\") or a value of each cell. Texts, generation, founder, parent, "
        "id and cluster take colours that are easily told apart, species their own; other numbers go through the "
        "map.",
    .example = "dump film all image 5 film.*.png generation size 400 300 view iso zoom 1.2 scalebar 5um "
               "axes yes springs strain legend no map plasma range 0 8 background black",
    .now_example = "write_dump all image colony.png z size 400 300 view 60degree 30degree zoom 1.2 scalebar 0 axes yes "
                   "springs no legend yes map cividis range 0 2um background '#102030'",
    .takes = DUMP_COLOR,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .missing = IMAGE_MISSING,
    .draw = draw,
};
