/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures: what stands where, how large, in which colour; the same bits for any number of threads. */
#include "check.h"

#include "base/alloc.h"
#include "output/camera.h"
#include "output/image.h"

#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void test_color_names_and_maps(void **state) {
    (void)state;
    rgb c;
    assert_true(color_parse("#12aBff", &c));
    assert_near(c.r, 0x12 / 255.0, 1e-7);
    assert_near(c.b, 1, 0);
    assert_true(color_parse("#1f0", &c));
    assert_near(c.r, 0x11 / 255.0, 1e-7);
    assert_near(c.g, 1, 0);
    assert_near(c.b, 0, 0);
    assert_true(color_parse("white", &c));
    const char *const wrong[] = {"",        "#",    "#1",     "#12",     "#12345", "#1234567",
                                 "#12345g", "whit", "ffffff", "# 12345", "#+12345"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_false(color_parse(wrong[i], &c));
    for (size_t m = 0; m < color_map_count; m++) {
        rgb first = color_of(&color_maps[m], 0), beyond = color_of(&color_maps[m], -3);
        assert_memory_equal(&first, &beyond, sizeof first);
        float jump = 0;
        for (int i = 1; i <= 1000; i++) {
            rgb a = color_of(&color_maps[m], (i - 1) / 1e3), b = color_of(&color_maps[m], i / 1e3);
            jump = fmaxf(jump, fabsf(a.r - b.r) + fabsf(a.g - b.g) + fabsf(a.b - b.b));
        }
        assert_true(jump < 0.01f); /* a mistyped anchor leaps */
    }
    rgb viridis = color_of(&color_maps[color_map_find("viridis")], 0.5);
    assert_near(viridis.g, 0x91 / 255.0, 1e-6);
    for (int i = 0; i <= 255; i++) {
        float x = (float)i / 255;
        assert_near(color_to_srgb(color_to_linear((rgb){x, x, x})).g, x, 1e-6);
    }
}

#if SARCINA_HAVE_IMAGE

typedef struct culture {
    colony *c;
    species_table table;
    view v;
} culture;

static culture make(void) {
    culture k = {.c = colony_create()};
    species_add(&k.table, "rod");
    species_add(&k.table, "ball");
    snprintf(k.table.list[1].color, sizeof k.table.list[1].color, "#ff0000");
    return k;
}

static void discard(culture *k) {
    colony_free(k->c);
    free(k->table.list);
}

static void add_ball(culture *k, double x, double y, double z, double diameter, int generation) {
    const double p[3] = {x, y, z};
    uint32_t row = colony_add_cell(k->c, 1, p);
    k->c->cell.species[row] = 1;
    k->c->cell.diameter[row] = diameter;
    k->c->cell.generation[row] = generation;
}

static void add_rod(culture *k, const double p[6], double diameter) {
    uint32_t row = colony_add_cell(k->c, 2, p);
    k->c->cell.diameter[row] = diameter;
}

/* The colour column: generation, whose numbers the tests set. */
static int give(void *self, uint32_t row, double *si, diag *d) {
    (void)d;
    int32_t x = ((const colony *)self)->cell.generation[row];
    *si = x < 0 ? (double)NAN : x;
    return SARCINA_OK;
}

static int give_species(void *self, uint32_t row, char out[64], diag *d) {
    (void)d;
    snprintf(out, 64, "%s", ((const colony *)self)->cell.species[row] ? "ball" : "rod");
    return SARCINA_OK;
}

static dump_frame frame_of(culture *k, output_column *column, char *name) {
    bool text = strcmp(name, "species") == 0;
    *column = (output_column){
        .name = name, .self = k->c, .is_text = text, .number = text ? NULL : give, .text = text ? give_species : NULL};
    k->v = (view){.colony = k->c, .species = &k->table};
    return (dump_frame){.view = &k->v, .columns = column, .ncolumns = 1, .threads = 1};
}

static image_options plain(int from) {
    image_options o = image_defaults();
    o.width = 300;
    o.height = 200;
    o.theta = camera_views[from].theta;
    o.phi = camera_views[from].phi;
    o.scalebar = 0;
    o.legend = false;
    o.has_color = true;
    color_parse("blue", &o.color);
    return o;
}

static rgb pixel(const canvas *c, int x, int y) {
    return c->pixels[(size_t)y * (size_t)c->width + (size_t)x];
}

static bool is_white(rgb p) {
    return p.r > 0.999f && p.g > 0.999f && p.b > 0.999f;
}

/* Pixels that are not background, and the box around them. */
typedef struct blot {
    double area;
    int left, right, top, bottom; /* inclusive */
} blot;

static blot find_blot(const canvas *c) {
    blot b = {0, c->width, -1, c->height, -1};
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            if (!is_white(pixel(c, x, y))) {
                b.area++;
                b.left = x < b.left ? x : b.left;
                b.right = x > b.right ? x : b.right;
                b.top = y < b.top ? y : b.top;
                b.bottom = y > b.bottom ? y : b.bottom;
            }
    return b;
}

static canvas *draw(const dump_frame *f, const image_options *o) {
    canvas *c;
    diag d = {0};
    if (image_draw(f, o, &c, &d) != SARCINA_OK)
        fail_msg("%s", d.message);
    return c;
}

/* A ball fills 92 % of the height, and its outline is a circle. */
static void test_a_ball_is_a_disc(void **state) {
    (void)state;
    for (int from = 0; from < camera_view_count; from++) {
        culture k = make();
        output_column column;
        add_ball(&k, 40, -7, 3, 1.3, 0);
        dump_frame f = frame_of(&k, &column, "generation");
        image_options o = plain(from);
        canvas *c = draw(&f, &o);
        blot b = find_blot(c);
        double diameter = 0.92 * 200;
        assert_near(b.right - b.left + 1, diameter, 3);
        assert_near(b.bottom - b.top + 1, diameter, 3);
        assert_near(0.5 * (b.left + b.right + 1), 150, 1);
        assert_near(b.area, M_PI / 4 * diameter * diameter, 0.5 * M_PI * diameter * 2); /* half of two pixels around */
        canvas_free(c);
        discard(&k);
    }
}

/* A rod of length 6 and diameter 1 lying along x: seen whole from above and the front, end-on from the side. */
static void test_a_rod_is_a_capsule(void **state) {
    (void)state;
    const double widths[] = {6, 1, 6}, heights[] = {1, 1, 1};
    for (int from = 0; from < 3; from++) {
        culture k = make();
        output_column column;
        add_rod(&k, (double[6]){-2.5, 0, 0, 2.5, 0, 0}, 1);
        dump_frame f = frame_of(&k, &column, "generation");
        image_options o = plain(from);
        canvas *c = draw(&f, &o);
        double scale = 0.92 * fmin(300 / widths[from], 200 / heights[from]);
        blot b = find_blot(c);
        assert_near(b.right - b.left + 1, scale * widths[from], 3);
        assert_near(b.bottom - b.top + 1, scale * heights[from], 3);
        double length = widths[from] - 1, outline = 2 * length + M_PI;
        assert_near(b.area, scale * scale * (length + M_PI / 4), scale * outline);
        canvas_free(c);
        discard(&k);
    }
}

/* Which way is up, and what is in front: red low at the left, blue high at the right and behind in y. */
static void test_views_look_where_they_say(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_ball(&k, -2, -1, 0, 1, 2); /* reddish in the palette */
    add_ball(&k, 2, 1, 3, 1, 0);   /* bluish */
    dump_frame f = frame_of(&k, &column, "generation");
    for (int from = 0; from < camera_view_count; from++) {
        image_options o = plain(from);
        o.has_color = false;
        canvas *c = draw(&f, &o);
        camera eye = camera_look(o.theta, o.phi, o.width, o.height);
        vec3 red = camera_project(&eye, vec3_of(-2, -1, 0)), blue = camera_project(&eye, vec3_of(2, 1, 3));
        vec3 middle = vec3_scale(0.5, vec3_add(red, blue));
        double scale = 0.92 * fmin(300 / (fabs(red.x - blue.x) + 1), 200 / (fabs(red.y - blue.y) + 1));
        rgb at_red = pixel(c, (int)(150 + scale * (red.x - middle.x)), (int)(100 - scale * (red.y - middle.y)));
        rgb at_blue = pixel(c, (int)(150 + scale * (blue.x - middle.x)), (int)(100 - scale * (blue.y - middle.y)));
        assert_true(at_red.r > at_red.b && at_blue.b > at_blue.r);
        canvas_free(c);
    }
    assert_near(camera_look(0, -M_PI / 2, 1, 1).right.x, 1, 1e-15);
    assert_near(camera_look(0, -M_PI / 2, 1, 1).up.y, 1, 1e-15);
    assert_near(camera_look(M_PI / 2, -M_PI / 2, 1, 1).up.z, 1, 1e-15);
    assert_near(camera_look(M_PI / 2, 0, 1, 1).right.y, 1, 1e-15);
    discard(&k);
}

/* The middle of a ball is as bright as its colour is lit, so hues and their order show which colour was chosen. */
static void test_colors(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    rgb low, high, here;
    add_ball(&k, 0, 0, 0, 1, 3);
    add_ball(&k, 2, 0, 0, 1, 9);
    add_ball(&k, 4, 0, 0, 1, -1);
    image_options o = plain(0);
    o.has_color = false;
    dump_frame f = frame_of(&k, &column, "speed"); /* an amount: dark violet for the least, yellow for the largest */
    canvas *c = draw(&f, &o);
    low = pixel(c, 47, 100);
    high = pixel(c, 150, 100);
    here = pixel(c, 253, 100);
    assert_true(low.b > low.r && low.r > low.g);
    assert_true(high.r > high.b && high.g > high.b);
    assert_near(here.r, here.g, 0.01); /* undefined: grey */
    assert_near(here.r, here.b, 0.01);
    canvas_free(c);
    o.low = 9; /* both at or below the low end */
    o.high = 20;
    c = draw(&f, &o);
    rgb other = pixel(c, 150, 100);
    low = pixel(c, 47, 100);
    assert_near(other.r, low.r, 0.02);
    assert_near(other.g, low.g, 0.02);
    canvas_free(c);
    f = frame_of(&k, &column, "species"); /* red, as the species says */
    c = draw(&f, &o);
    here = pixel(c, 150, 100);
    assert_true(here.r > 0.5f && here.g < 0.5f * here.r && here.b < 0.5f * here.r);
    canvas_free(c);
    discard(&k);
}

static void test_scale_bar(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_rod(&k, (double[6]){-45, 0, 0, 45, 0, 0}, 10); /* 100 long: 276 pixels */
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(0);
    o.scalebar = 25;
    canvas *c = draw(&f, &o);
    int dark = 0;
    for (int x = 0; x < 300; x++) { /* the bar lies just above the margin */
        rgb p = pixel(c, x, 200 - 15);
        dark += p.r < 0.3f && p.b < 0.3f;
    }
    assert_near(dark, 25 * 2.76, 1.5);
    canvas_free(c);
    assert_true(canvas_text_width("10 um", 21) > canvas_text_width("1 um", 21));
    discard(&k);
}

/* Cells that touch, lie over each other, and a floor. */
static culture make_heap(void) {
    culture k = make();
    for (int i = 0; i < 40; i++) {
        double x = 0.9 * (i % 8), y = 1.7 * (i / 8), z = 0.4 + 0.5 * (i % 3);
        if (i % 4)
            add_rod(&k, (double[6]){x, y, z, x + 0.6, y + 1.2, z + 0.1 * (i % 5)}, 0.7 + 0.01 * i);
        else
            add_ball(&k, x, y, z, 0.9, 0);
        k.c->cell.generation[i] = i % 7;
    }
    return k;
}

static void test_same_bits_for_any_number_of_threads(void **state) {
    (void)state;
    culture k = make_heap();
    output_column column;
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(3);
    o.has_color = false;
    o.has_floor = true;
    o.scalebar = -1;
    o.axes = true;
    canvas *one = draw(&f, &o);
    for (int threads = 1; threads <= 4; threads++) {
        f.threads = threads;
        canvas *other = draw(&f, &o);
        assert_memory_equal(one->pixels, other->pixels, 300 * 200 * sizeof *one->pixels);
        canvas_free(other);
    }
    canvas_free(one);
    discard(&k);
}

/* Pictures leave the arithmetic of the simulation as it was. */
static void test_rounding_mode_stays(void **state) {
    (void)state;
    culture k = make_heap();
    output_column column;
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(0);
    volatile double tiny = 2.2250738585072014e-308;
    canvas_free(draw(&f, &o));
    volatile double denormal = tiny / 2;
    assert_true(denormal > 0);
    assert_int_equal(fegetround(), FE_TONEAREST);
    discard(&k);
}

static void test_empty_scene(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(0);
    o.has_floor = true;
    canvas *c = draw(&f, &o);
    assert_near(find_blot(c).area, 0, 0);
    canvas_free(c);
    discard(&k);
}

/* Members only, and the selection decides what fits. */
static void test_selection(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_ball(&k, 0, 0, 0, 1, 0);
    add_ball(&k, 50, 0, 0, 1, 0);
    dump_frame f = frame_of(&k, &column, "generation");
    f.members = (const bool[2]){true, false};
    image_options o = plain(0);
    canvas *c = draw(&f, &o);
    assert_near(find_blot(c).bottom - find_blot(c).top + 1, 0.92 * 200, 3);
    canvas_free(c);
    discard(&k);
}

/* The big-endian number in four bytes. */
static unsigned long number_at(const unsigned char *p) {
    return (unsigned long)p[0] << 24 | (unsigned long)p[1] << 16 | (unsigned long)p[2] << 8 | p[3];
}

static void test_png(void **state) {
    (void)state;
    culture k = make_heap();
    output_column column;
    char name[] = "image.XXXXXX";
    int file = mkstemp(name);
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(1);
    f.options = &o;
    assert_int_equal(dump_write_now(dump_find("image"), name, &f, NULL), SARCINA_OK);
    unsigned char head[26];
    assert_int_equal(read(file, head, sizeof head), (int)sizeof head);
    assert_memory_equal(head, "\211PNG\r\n\032\n\0\0\0\rIHDR", 16);
    assert_int_equal(number_at(head + 16), 300);
    assert_int_equal(number_at(head + 20), 200);
    assert_int_equal(head[24], 8);
    assert_int_equal(head[25], 2);
    close(file);
    remove(name);
    diag d = {0};
    assert_int_equal(dump_write_now(dump_find("image"), "/dev/null/x.png", &f, &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "cannot write '/dev/null/x.png'"));
    assert_int_equal(dump_check(dump_find("image"), "film.png", false, &d), SARCINA_ERROR);
    discard(&k);
}

/* A spring between two balls far apart is a line between them, one to an anchor ends there. */
static void test_springs(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_ball(&k, -4, 0, 0, 1, 0);
    add_ball(&k, 4, 0, 0, 1, 0);
    colony *c = k.c;
    for (int i = 0; i < 2; i++) {
        uint32_t link = colony_add_link(c, i ? LINK_ANCHOR : LINK_FILIAL, 1, i ? 0 : 2, 1), s = c->link.first[link];
        c->spring.a[s] = 0;
        c->spring.b[s] = i ? SPRING_ANCHOR : 1;
        c->spring.anchor[3 * s] = c->spring.anchor[3 * s + 1] = -2;
    }
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(0);
    canvas *without = draw(&f, &o);
    o.springs = IMAGE_SPRINGS_KIND;
    canvas *with = draw(&f, &o);
    double scale = 0.92 * 300 / 9;
    assert_true(is_white(pixel(without, 150, 100)));
    assert_true(pixel(with, 150, 100).g < 0.5f);
    int x = (int)(150 - 3 * scale), y = (int)(100 + 1 * scale); /* half-way to the anchor */
    assert_true(is_white(pixel(without, x, y)));
    assert_true(pixel(with, x, y).r > 2 * pixel(with, x, y).b);
    canvas_free(without);
    canvas_free(with);
    discard(&k);
}

/* By strain: one that is stretched is red, one pressed together blue, the strongest of them most. */
static void test_springs_by_strain(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_ball(&k, -4, 0, 0, 1, 0);
    add_ball(&k, 4, 0, 0, 1, 0);
    add_ball(&k, -4, 4, 0, 1, 0);
    add_ball(&k, 4, 4, 0, 1, 0);
    colony *c = k.c;
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t link = colony_add_link(c, LINK_STICK, 1 + 2 * i, 2 + 2 * i, 1), s = c->link.first[link];
        c->spring.a[s] = 2 * i;
        c->spring.b[s] = 2 * i + 1;
        c->spring.rest[s] = i ? 16 : 4; /* strains -0.5 and 1 */
    }
    dump_frame f = frame_of(&k, &column, "generation");
    image_options o = plain(0);
    o.springs = IMAGE_SPRINGS_STRAIN;
    canvas *with = draw(&f, &o);
    double scale = 0.92 * 300 / 9;
    rgb stretched = pixel(with, 150, (int)(100 + 2 * scale)), pressed = pixel(with, 150, (int)(100 - 2 * scale));
    assert_true(stretched.r > 1.5f * stretched.b);
    assert_true(pressed.b > 1.2f * pressed.r);
    assert_true(pressed.r > stretched.b); /* half as strong: nearer the middle */
    canvas_free(with);
    discard(&k);
}

/* A bar in the upper right corner, its map's high end up; none for labels and when it is not wanted. */
static void test_legend(void **state) {
    (void)state;
    culture k = make();
    output_column column;
    add_ball(&k, 0, 0, 0, 1, 3);
    add_ball(&k, 2, 0, 0, 1, 9);
    image_options o = plain(0);
    o.zoom = 0.2;
    o.has_color = false;
    dump_frame f = frame_of(&k, &column, "speed");
    canvas *without = draw(&f, &o);
    o.legend = true;
    canvas *with = draw(&f, &o);
    blot bar = find_blot(with), cells = find_blot(without);
    assert_true(bar.right > 280 && bar.top < 20 && cells.right < 200);
    int low = -1, high = -1; /* rows of the map's ends */
    for (int y = 0; y < 200; y++)
        for (int x = 210; x < 300; x++) {
            rgb p = pixel(with, x, y);
            if (p.r > 0.95f && p.g > 0.85f && p.b < 0.3f && high < 0)
                high = y;
            if (p.r < 0.35f && p.g < 0.1f && p.b > 0.3f)
                low = y;
        }
    assert_true(high > 0 && low > high + 50);
    canvas_free(with);
    f = frame_of(&k, &column, "generation");
    with = draw(&f, &o);
    assert_true(find_blot(with).right < 200);
    canvas_free(with);
    canvas_free(without);
    discard(&k);
}

/* Every letter leaves ink, and "um" has its mu where a word begins with it. */
static void test_letters(void **state) {
    (void)state;
    const char letters[] = "abcdefghijklmnopqrstuvwxyzNJ0123456789.-()[]/*+,_<>=^%";
    for (const char *l = letters; *l; l++) {
        canvas *c = canvas_create(40, 60, (rgb){1, 1, 1});
        canvas_text(c, 10, 40, 21, (const char[]){*l, '\0'}, (rgb){0, 0, 0});
        assert_true(find_blot(c).area > 5);
        assert_true(canvas_text_width((const char[]){*l, '\0'}, 21) >= 8);
        canvas_free(c);
    }
    canvas *c = canvas_create(80, 60, (rgb){1, 1, 1});
    canvas_text(c, 10, 40, 21, "um", (rgb){0, 0, 0});
    assert_true(find_blot(c).bottom > 45); /* its tail */
    canvas_free(c);
    c = canvas_create(80, 60, (rgb){1, 1, 1});
    canvas_text(c, 10, 40, 21, "sum", (rgb){0, 0, 0});
    assert_true(find_blot(c).bottom < 45);
    canvas_free(c);
}

#else

static void test_build_without_pictures_says_so(void **state) {
    (void)state;
    diag d = {0};
    assert_int_equal(dump_write_now(dump_find("image"), "a.png", &(dump_frame){0}, &d), SARCINA_ERROR);
    assert_string_equal(d.message, "this build has no pictures: install libpng-dev and libembree-dev and build again");
}
#endif

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_color_names_and_maps),
#if SARCINA_HAVE_IMAGE
        cmocka_unit_test(test_a_ball_is_a_disc),
        cmocka_unit_test(test_a_rod_is_a_capsule),
        cmocka_unit_test(test_views_look_where_they_say),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_scale_bar),
        cmocka_unit_test(test_same_bits_for_any_number_of_threads),
        cmocka_unit_test(test_rounding_mode_stays),
        cmocka_unit_test(test_empty_scene),
        cmocka_unit_test(test_selection),
        cmocka_unit_test(test_png),
        cmocka_unit_test(test_springs),
        cmocka_unit_test(test_springs_by_strain),
        cmocka_unit_test(test_legend),
        cmocka_unit_test(test_letters),
#else
        cmocka_unit_test(test_build_without_pictures_says_so),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
