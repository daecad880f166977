/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pictures of `dump image` as the frames of one film: they go to ffmpeg as bare pixels. ffmpeg is told to leave out
 * what says when and with what it was made, so that the same frames make the same file. */
#include "output/dump/styles.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/process.h"
#include "base/table.h"
#include "output/image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const param params[] = {{"fps=24:int[1,240]", "frames a second"}, IMAGE_PARAMS};

typedef struct film {
    process *ffmpeg;
    int width, height;
} film;

static int ready(diag *d) {
    return process_check("ffmpeg", "ffmpeg", d);
}

static bool ends_with(const char *text, const char *end) {
    size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}

/* Players want sides of even length and the common colour format; a GIF has neither need. */
static film *begin(const char *path, const image_options *o, diag *d) {
    char size[32], fps[16];
    bool gif = ends_with(path, ".gif");
    snprintf(size, sizeof size, "%dx%d", o->width, o->height);
    snprintf(fps, sizeof fps, "%d", o->fps);
    /* a name that begins with - would be an option */
    char *file = alloc_format("%s%s", path[0] == '-' ? "./" : "", path);
    const char *const words[] = {
        "ffmpeg",
        "-nostats",
        "-loglevel",
        "error",
        "-y",
        "-f",
        "rawvideo",
        "-pixel_format",
        "rgb24",
        "-video_size",
        size,
        "-framerate",
        fps,
        "-i",
        "-",
        "-an",
        "-threads",
        "1",
        "-fflags",
        "+bitexact",
        "-flags:v",
        "+bitexact",
        "-vf",
        gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse" : "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p",
        file,
        NULL};
    process *ffmpeg = path_make_folders(path, d) ? NULL : process_open(words, d);
    free(file);
    if (!ffmpeg)
        return NULL;
    film *made = alloc_zeroed(1, sizeof *made);
    *made = (film){ffmpeg, o->width, o->height};
    return made;
}

static int frame(void **self, const char *path, const dump_frame *f, diag *d) {
    const image_options *o = f->options;
    film *m = *self;
    if (!m)
        *self = m = begin(path, o, d);
    if (!m)
        return SARCINA_ERROR;
    if (m->width != o->width || m->height != o->height)
        return diag_error(d, "the frames of '%s' are %d x %d: its size cannot change", path, m->width, m->height);
    canvas *c;
    int status = image_draw(f, o, &c, d);
    if (!status) {
        size_t n;
        unsigned char *bytes = canvas_bytes(c, &n);
        status = process_write(m->ffmpeg, bytes, n, d);
        free(bytes);
    }
    canvas_free(c);
    return status;
}

static int end(void *self, diag *d) {
    film *m = self;
    if (!m)
        return SARCINA_OK;
    int status = process_close(m->ffmpeg, d);
    free(m);
    return status;
}

static const dump_film movie = {ready, frame, end};

const dump_style dump_movie = {
    .name = "movie",
    .summary = "a film of pictures, made by the program ffmpeg",
    .details =
        "Everything of image, a frame each time; the end of FILE's name (.mp4, .mkv, .avi, .webm, .gif) says what "
        "kind of film. It is whole once the dump ends: by undump, clear, or the end of the program. Going on from "
        "a restart file the frames from step S on go to NAME.S.mp4.",
    .example = "dump film all movie 1 film.mp4 generation fps 12 size 400 300 view iso zoom 1.2 scalebar 5um axes yes "
               "springs strain legend yes map plasma range 0 8 background black",
    .takes = DUMP_FILM,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .many = true,
    .film = &movie,
    .missing = IMAGE_MISSING,
};
