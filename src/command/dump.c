/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dump ID GROUP STYLE N FILE ..., dump ID off, undump, dump_modify, write_dump: forms made from the table of dump
 * styles. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/output_list.h"

#include "base/alloc.h"
#include "base/table.h"
#include "output/camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what an image's arguments say ------------------------------------------------------------------------------- */

static bool wants(const args *a, const char *name, bool amends) {
    return !amends || args_given(a, name);
}

static void read_view(const args *a, image_options *o) {
    const char *name = args_text(a, "view");
    double angles[2];
    if (!name) {
        args_vector(a, "view", angles, 2);
        o->theta = angles[0];
        o->phi = angles[1];
        return;
    }
    for (int i = 0; i < camera_view_count; i++)
        if (strcmp(camera_views[i].name, name) == 0) {
            o->theta = camera_views[i].theta;
            o->phi = camera_views[i].phi;
        }
}

static int read_size(const args *a, image_options *o, diag *d) {
    double size[2];
    args_vector(a, "size", size, 2);
    if (!(size[0] >= 16 && size[0] <= 16384 && size[1] >= 16 && size[1] <= 16384)) {
        diag_error(d, "size: a picture has 16 to 16384 pixels each way");
        diag_place(d, args_span(a, "size"));
        return SARCINA_ERROR;
    }
    o->width = (int)size[0];
    o->height = (int)size[1];
    return SARCINA_OK;
}

/* Keywords of a picture: those given, or with `amends` false all of them. */
static int read_image(const args *a, bool amends, image_options *o, diag *d) {
    int status = wants(a, "size", amends) ? read_size(a, o, d) : SARCINA_OK;
    if (wants(a, "view", amends))
        read_view(a, o);
    if (wants(a, "zoom", amends))
        o->zoom = isnan(args_number(a, "zoom")) ? 1 : args_number(a, "zoom");
    if (wants(a, "scalebar", amends))
        o->scalebar = isnan(args_number(a, "scalebar")) ? -1 : args_number(a, "scalebar");
    if (wants(a, "axes", amends))
        o->axes = args_flag(a, "axes");
    if (wants(a, "springs", amends))
        o->springs = (image_springs)args_choice(a, "springs");
    if (wants(a, "legend", amends))
        o->legend = args_flag(a, "legend");
    if (wants(a, "map", amends))
        o->map = args_choice(a, "map");
    if (args_given(a, "range")) {
        double range[2];
        args_vector(a, "range", range, 2);
        o->low = range[0];
        o->high = range[1];
    }
    if (wants(a, "background", amends) && args_text(a, "background"))
        color_parse(args_text(a, "background"), &o->background);
    return status;
}

/* The colour, or the value that gives it, of a cellcolor argument. */
static int read_color(interp *in, const args *a, const char *name, output_column **column, image_options *o, diag *d) {
    const char *text = args_text(a, name);
    expr *e = args_expr(a, name);
    *column = NULL;
    o->has_color = text && !e;
    if (o->has_color) {
        color_parse(text, &o->color);
        return SARCINA_OK;
    }
    output_column *made = alloc_zeroed(1, sizeof *made);
    int status = interp_column(in, e, true, made, d);
    if (status)
        free(made);
    else
        *column = made;
    return status;
}

/* ---- declaring --------------------------------------------------------------------------------------------------- */

static int read_columns(interp *in, const args *a, output_column **columns, size_t *made, diag *d) {
    size_t n = args_count(a, "COLUMN");
    int status = SARCINA_OK;
    *columns = alloc_zeroed(n, sizeof **columns);
    for (*made = 0; *made < n && !status; *made += !status)
        status = interp_column(in, args_expr_at(a, "COLUMN", *made), true, &(*columns)[*made], d);
    return status;
}

/* What stands behind FILE, by style. On error nothing is left to free. */
static int read_content(interp *in, const args *a, const dump_style *style, output_column **columns, size_t *n,
                        image_options *image, diag *d) {
    int status = SARCINA_OK;
    *columns = NULL;
    *n = 0;
    *image = image_defaults();
    if (style->takes == DUMP_COLOR || style->takes == DUMP_FILM) {
        status = read_image(a, false, image, d);
        if (style->takes == DUMP_FILM)
            image->fps = (int)args_int(a, "fps");
        if (!status)
            status = read_color(in, a, "COLOR", columns, image, d);
        *n = *columns != NULL;
    } else if (style->takes != DUMP_NOTHING) {
        status = read_columns(in, a, columns, n, d);
    }
    if (status) {
        output_list_release_columns(*columns, *n);
        *columns = NULL;
        *n = 0;
    }
    return status;
}

/* IDs of dumps are no names of the language, whose clashes are found when they are read. */
static int check_id(const outputs *o, const args *a, diag *d) {
    for (size_t i = 0; i < o->ndumps; i++)
        if (strcmp(o->dumps[i].id, args_text(a, "ID")) == 0) {
            diag_error(d, "'%s' is already a dump", o->dumps[i].id);
            diag_place(d, args_span(a, "ID"));
            return diag_help(d, "dump_modify %s ... changes it, undump %s ends it", o->dumps[i].id, o->dumps[i].id);
        }
    return SARCINA_OK;
}

/* A style the build cannot write is told of and left out, so that the script runs all the same. */
static void warn_if_missing(interp *in, const dump_style *style) {
    if (style->missing && !interp_checking(in))
        interp_warn(in, "%s; this one is left out", style->missing);
}

static int run_dump(interp *in, const args *a, diag *d) {
    outputs *o = output_list_of(in);
    const dump_style *style = dump_styles[args_style(a)];
    output_dump p = {.every = args_cycles(a, "N")};
    uint64_t step;
    int status = check_id(o, a, d);
    if (!status)
        status = read_content(in, a, style, &p.columns, &p.ncolumns, &p.image, d);
    if (status)
        return status;
    if (output_list_knows(a, "FILE"))
        status = dump_check(args_style(a), args_text(a, "FILE"), false, d);
    if (status) {
        diag_place(d, args_span(a, "FILE"));
        output_list_release_columns(p.columns, p.ncolumns);
        return status;
    }
    warn_if_missing(in, style);
    p.file = dump_create(args_style(a), args_text(a, "FILE"));
    if (output_list_resumes(o, args_text(a, "FILE"), &step))
        dump_rewind(p.file, step, NULL);
    p.id = alloc_copy(args_text(a, "ID"));
    p.group = alloc_copy(args_text(a, "GROUP"));
    o->dumps = alloc_grow(o->dumps, &o->dump_capacity, o->ndumps + 1, sizeof *o->dumps);
    o->dumps[o->ndumps++] = p;
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    output_list_drop_dump(output_list_of(in), (size_t)args_row(a, "ID"));
    return SARCINA_OK;
}

static bool is_image(const output_dump *p) {
    dump_takes takes = dump_styles[dump_style_of(p->file)]->takes;
    return takes == DUMP_COLOR || takes == DUMP_FILM;
}

/* A keyword of pictures given for a dump that is none. */
static int check_keywords(const args *a, const output_dump *p, diag *d) {
    const dump_style *image = dump_styles[dump_find("image")];
    bool wrong = args_given(a, "color");
    for (size_t i = 0; i < image->nparams && !wrong && !is_image(p); i++) {
        char name[32];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(image->params[i].spec, "=:"), image->params[i].spec);
        wrong = args_given(a, name);
    }
    if (!wrong || is_image(p))
        return SARCINA_OK;
    return diag_error(d, "dump '%s' is no picture: only every and pad can be changed", p->id);
}

static int modify_color(interp *in, const args *a, output_dump *p, diag *d) {
    output_column *column;
    image_options o = p->image;
    int status = read_color(in, a, "color", &column, &o, d);
    if (status)
        return status;
    output_list_release_columns(p->columns, p->ncolumns);
    p->columns = column;
    p->ncolumns = column != NULL;
    p->image = o;
    return SARCINA_OK;
}

static int run_modify(interp *in, const args *a, diag *d) {
    output_dump *p = &output_list_of(in)->dumps[args_row(a, "ID")];
    image_options image = p->image;
    int status = check_keywords(a, p, d);
    if (!status && is_image(p))
        status = read_image(a, true, &image, d);
    if (!status && args_given(a, "color"))
        status = modify_color(in, a, p, d);
    if (status)
        return status;
    image.has_color = p->image.has_color;
    image.color = p->image.color;
    p->image = image;
    if (args_given(a, "every"))
        p->every = args_cycles(a, "every");
    if (args_given(a, "pad"))
        dump_set_pad(p->file, (int)args_int(a, "pad"));
    return SARCINA_OK;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

int output_list_open_dump(output_dump *p, diag *d) {
    return dump_open(p->file, d);
}

/* The present state as a frame; *members is the caller's to free. */
static int make_frame(interp *in, const char *group, const image_options *image, view *v, bool **members, dump_frame *f,
                      diag *d) {
    const scene *s = interp_scene(in);
    int status = output_list_members(in, group, members, d);
    *v = scene_view(interp_scene(in));
    *f = (dump_frame){.view = v, .members = *members, .options = image, .threads = s->threads};
    return status;
}

/* The substratum is seen where there is one. */
static image_options with_floor(const image_options *o, const scene *s) {
    const force_settings *substratum = &s->forces.term[FORCE_SUBSTRATUM];
    image_options image = *o;
    image.has_floor = substratum->on;
    image.floor_z = substratum->p[SUBSTRATUM_Z];
    return image;
}

int output_list_write_dump(outputs *o, output_dump *p, diag *d) {
    view v;
    bool *members;
    dump_frame f;
    image_options image = with_floor(&p->image, interp_scene(o->in));
    int status = make_frame(o->in, p->group, &image, &v, &members, &f, d);
    f.columns = p->columns;
    f.ncolumns = p->ncolumns;
    if (!status)
        status = dump_write(p->file, &f, d);
    free(members);
    return status;
}

static int write_now(interp *in, const args *a, const output_column *columns, size_t n, const image_options *options,
                     diag *d) {
    view v;
    bool *members;
    dump_frame f;
    image_options image = with_floor(options, interp_scene(in));
    int status = make_frame(in, args_text(a, "GROUP"), &image, &v, &members, &f, d);
    f.columns = columns;
    f.ncolumns = n;
    char *path = dump_file_name(args_text(a, "FILE"), v.step, 0);
    if (!status)
        status = dump_write_now(args_style(a), path, &f, d);
    free(path);
    free(members);
    return status;
}

static int run_write(interp *in, const args *a, diag *d) {
    output_column *columns;
    size_t n;
    image_options image;
    const dump_style *style = dump_styles[args_style(a)];
    int status = read_content(in, a, style, &columns, &n, &image, d);
    if (status)
        return status;
    if (output_list_knows(a, "FILE"))
        status = dump_check(args_style(a), args_text(a, "FILE"), true, d);
    if (!status)
        warn_if_missing(in, style);
    if (!status && interp_checking(in) && style->takes == DUMP_COLOR)
        forecast_note_picture(in, &image);
    if (!status && !interp_checking(in) && !style->missing)
        status = write_now(in, a, columns, n, &image, d);
    if (status)
        diag_place(d, args_span(a, "FILE"));
    output_list_release_columns(columns, n);
    return status;
}

/* ---- records ----------------------------------------------------------------------------------------------------- */

static size_t count_dumps(interp *in) {
    return output_list_of(in)->ndumps;
}

static const char *get_dump(interp *in, size_t i) {
    return output_list_of(in)->dumps[i].id;
}

static const name_class dump_class = {"dump", "a dump", true, false, count_dumps, get_dump, NULL, NULL};

#define DUMP_GROUP                                                                                                     \
    { "GROUP:group", "the cells: all, a species, a region, a group" }
#define DUMP_FILE                                                                                                      \
    { "FILE:file", "where to; * is the step" }
#define DUMP_PLACES                                                                                                    \
    {"ID:+dump", "its name"}, DUMP_GROUP, {"N:cycles[1,)", "cycles, or a time, between frames"}, DUMP_FILE
#define DUMP_COLUMN "a value of each cell, or a formula without blanks"
#define DUMP_COLORS {"COLOR:cellcolor", "a colour, or a value of each cell that gives it"}, IMAGE_PARAMS

static const param dump_nothing[] = {DUMP_PLACES}, dump_columns[] = {DUMP_PLACES, {"COLUMN:cell...", DUMP_COLUMN}},
                   dump_any[] = {DUMP_PLACES, {"COLUMN:cell0...", DUMP_COLUMN}},
                   dump_colors[] = {DUMP_PLACES, DUMP_COLORS},
                   film_params[] = {DUMP_PLACES, {"fps=24:int[1,240]", "frames a second"}, DUMP_COLORS},
                   now_nothing[] = {DUMP_GROUP, DUMP_FILE},
                   now_columns[] = {DUMP_GROUP, DUMP_FILE, {"COLUMN:cell...", DUMP_COLUMN}},
                   now_any[] = {DUMP_GROUP, DUMP_FILE, {"COLUMN:cell0...", DUMP_COLUMN}},
                   now_colors[] = {DUMP_GROUP, DUMP_FILE, DUMP_COLORS};

/* What a style puts behind FILE, and its parameters in both commands; by dump_takes. */
static const struct {
    const char *content;
    const param *dump, *now;
    size_t ndump, nnow;
} contents[] = {
    [DUMP_NOTHING] = {"", dump_nothing, now_nothing, TABLE_COUNT(dump_nothing), TABLE_COUNT(now_nothing)},
    [DUMP_COLUMNS] = {" COLUMN:cell...", dump_columns, now_columns, TABLE_COUNT(dump_columns),
                      TABLE_COUNT(now_columns)},
    [DUMP_ANY_COLUMNS] = {" COLUMN:cell0...", dump_any, now_any, TABLE_COUNT(dump_any), TABLE_COUNT(now_any)},
    [DUMP_COLOR] = {" COLOR:cellcolor", dump_colors, now_colors, TABLE_COUNT(dump_colors), TABLE_COUNT(now_colors)},
    [DUMP_FILM] = {" COLOR:cellcolor", film_params, NULL, TABLE_COUNT(film_params), 0}, /* a film wants many frames */
};

static void add_style(command_table *t, int i) {
    const dump_style *s = dump_styles[i];
    const char *content = contents[s->takes].content;
    const command_form along = {
        .details = s->details, .example = s->example, .flags = COMMAND_DECLARES, .run = run_dump};
    const command_form now = {
        .details = s->details, .example = s->now_example, .flags = COMMAND_SHADOW, .run = run_write};
    char *head = alloc_format("dump ID:+dump GROUP:group %s N:cycles[1,) FILE:file%s", s->name, content);
    command_add_style(t, &along, head, s->summary, contents[s->takes].dump, contents[s->takes].ndump, i);
    free(head);
    if (!contents[s->takes].now)
        return;
    head = alloc_format("write_dump GROUP:group %s FILE:file%s", s->name, content);
    command_add_style(t, &now, head, s->summary, contents[s->takes].now, contents[s->takes].nnow, i);
    free(head);
}

static const param off_params[] = {{"ID:dump", "the dump"}};
static const param modify_params[] = {
    {"ID:dump", "the dump"},
    {"every:cycles[1,)", "cycles, or a time, between frames"},
    {"pad:int[0,9]", "the step in the file's name has at least so many digits"},
    {"color:cellcolor", "of a picture: a colour, or a value of each cell that gives it"},
    IMAGE_PARAMS,
};

static const command_form forms[] = {
    {"dump ID:dump off", off_params, 1, "Ends a dump", NULL, "dump cells all csv 5 cells.csv id x y z\ndump cells off",
     COMMAND_DECLARES, run_off, NULL, 0},
    {"undump ID:dump", off_params, 1, "Ends a dump", NULL, "dump cells all csv 5 cells.csv id x y z\nundump cells",
     COMMAND_DECLARES, run_off, NULL, 0},
    {"dump_modify ID:dump", modify_params, TABLE_COUNT(modify_params), "Changes a dump",
     "All but every and pad are for pictures, as in dump image.",
     "dump film all image 5 film.*.png species\n"
     "dump_modify film every 10 pad 4 color generation size 400 300 view side zoom 2 scalebar 5um axes yes "
     "springs yes legend no map magma range 0 8 background white",
     COMMAND_DECLARES, run_modify, NULL, 0},
};

void command_dump(command_table *t) {
    command_add_class(t, &dump_class);
    for (int i = 0; i < (int)dump_style_count; i++)
        add_style(t, i);
    command_add(t, forms, TABLE_COUNT(forms));
}
