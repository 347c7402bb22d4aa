/* Skeletons in drawings: kept bit for bit, their bones as lines, moved on the page, refused when they are not sound; a BVH file
 * is such a drawing, and comes out as it went in; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/edit/affine.h"
#include "format/formats.h"
#include "support/alloc_fail.h"
#include "support/walker.h"

enum { FRAMES = 24, ROOM = 4096 };

static bat_motion *motion_of(int seed, double tolerance) {
    bat_take *take = walker(seed, FRAMES);
    bat_motion *motion = NULL;
    bat_motion_options options = bat_motion_defaults();
    options.tolerance = tolerance;
    assert_non_null(take);
    assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
    bat_take_free(take);
    return motion;
}

static bat_object *object_of(const bat_motion *motion) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_skeleton(7, "walker", &style, motion, NULL, &object), BAT_OK);
    return object;
}

static bat_document *document_of(const bat_motion *motion) {
    bat_document *document = NULL;
    bat_object *object = object_of(motion);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    assert_null(bat_document_check(document));
    return document;
}

/* What is written and read is the same, and so are all frames of it: also with gains, mutes and another path. */
static void is_kept_bit_for_bit(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) {
        bat_motion *motion = motion_of(way + 1, way % 2 ? 0.5 : 0);
        const double points[12] = {0, 90, 0, 20, 90, 30, 60, 90, 40, 90, 90, 120};
        bat_curve *path = NULL;
        if (way > 1) {
            assert_int_equal(bat_motion_set_gain(motion, -1, 2, 0.25), BAT_OK);
            assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &path), BAT_OK);
            assert_int_equal(bat_motion_bend(motion, path), BAT_OK);
            bat_curve_free(path);
        }
        bat_document *document = document_of(motion), *again = NULL;
        char *text = NULL, *back = NULL;
        size_t size = 0, length = 0;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
        assert_null(bat_document_check(again));
        assert_true(bat_document_digest(again) == bat_document_digest(document));
        assert_int_equal(bat_document_write(again, &back, &length), BAT_OK);
        assert_int_equal(length, size);
        assert_memory_equal(back, text, size);
        const bat_motion *kept = bat_object_motion(bat_document_at(again, 0), NULL);
        bat_take *a = NULL, *b = NULL;
        size_t frames, channels;
        assert_int_equal(bat_motion_sample(motion, &a), BAT_OK);
        assert_int_equal(bat_motion_sample(kept, &b), BAT_OK);
        const double *values = bat_take_values(a, &frames, &channels);
        assert_memory_equal(values, bat_take_values(b, NULL, NULL), frames * channels * sizeof *values);
        bat_take_free(a), bat_take_free(b);
        bat_free(text), bat_free(back);
        bat_document_free(document), bat_document_free(again);
        bat_motion_free(motion);
    }
}

/* Neighbouring rotations half a turn apart have no nearer sign: after an angle is redrawn they have the one they had. */
static void signs_are_kept(void **state) {
    (void)state;
    static const char bvh[] =
        "HIERARCHY\nROOT a\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation "
        "Xrotation Yrotation\n JOINT b\n {\n OFFSET 1 -2 0\n CHANNELS 3 Xrotation Yrotation Zrotation\n"
        " End Site\n {\n OFFSET 0 -40 0\n }\n }\n}\nMOTION\nFrames: 5\nFrame Time: .01\n"
        "0 90 0 1 2 3 10 0 0\n0 91 2 1 2.5 3 20 1 0\n0 92 4 1 3 3.5 30 2 0\n0 91 6 1 2.5 3 20 3 90\n"
        "0 90 4 1 2 180 10 4 0\n";
    int turned = 0;
    for (int i = 0; i < 400; i++) {
        const double tolerance = i % 2 ? 0.5 : 0, duration = 0.04;
        const double stroke[6] = {-1, 20 + i, 0.3 * duration, -40 - 3 * i, duration, 5 + 7 * i};
        bat_take *take = NULL;
        bat_motion *motion = NULL;
        bat_motion_options options = bat_motion_defaults();
        options.tolerance = tolerance;
        assert_int_equal(bat_bvh_read(bvh, sizeof bvh - 1, &take, NULL), BAT_OK);
        assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
        turned += bat_motion_redraw(motion, i % 2, i / 2 % 3, 0, 3, stroke) == BAT_OK;
        bat_document *document = document_of(motion), *back = NULL;
        char *text = NULL;
        size_t size = 0;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        bat_free(text);
        bat_document_free(document), bat_document_free(back);
        bat_motion_free(motion);
        bat_take_free(take);
    }
    assert_true(turned > 100);
}

static void has_bones_for_curves(void **state) {
    (void)state;
    bat_motion *motion = motion_of(5, 0);
    bat_object *object = object_of(motion), *moved = NULL;
    double at[3 * WALKER_JOINTS], place[12];
    assert_int_equal(bat_take_positions(bat_motion_take(motion), 0, at), BAT_OK);
    assert_int_equal(bat_object_curve_count(object), 2); /* the leg, and the head */
    const bat_curve *leg = bat_object_curve(object, 0), *head = bat_object_curve(object, 1);
    const int line[4] = {0, 1, 2, 3}, neck[2] = {0, 4};
    assert_int_equal(bat_curve_count(leg), 4);
    assert_int_equal(bat_curve_count(head), 2);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            assert_true(fabs(bat_curve_points(leg)[3 * i + k] - (k ? -1 : 1) * at[3 * line[i] + k]) < 1e-9);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            assert_true(fabs(bat_curve_points(head)[3 * i + k] - (k ? -1 : 1) * at[3 * neck[i] + k]) < 1e-9);
    /* turned, stretched and moved on the page: each of its points is the image */
    const double m[6] = {0, 2, -1, 0, 30, -7};
    assert_int_equal(bat_affine_object(object, m, false, &moved), BAT_OK);
    for (int i = 0; i < 4; i++) {
        const double *p = bat_curve_points(leg) + (ptrdiff_t)3 * i,
                     *q = bat_curve_points(bat_object_curve(moved, 0)) + (ptrdiff_t)3 * i;
        assert_true(fabs(q[0] - (m[0] * p[0] + m[2] * p[1] + m[4])) < 1e-9);
        assert_true(fabs(q[1] - (m[1] * p[0] + m[3] * p[1] + m[5])) < 1e-9);
        assert_true(fabs(q[2] - p[2]) < 1e-9);
    }
    assert_non_null(bat_object_motion(moved, place));
    assert_true(place[3] == 30 && place[7] == -7);
    /* the motion stays what it is */
    bat_take *a = NULL;
    size_t frames, channels;
    assert_int_equal(bat_motion_sample(bat_object_motion(moved, NULL), &a), BAT_OK);
    const double *values = bat_take_values(bat_motion_take(motion), &frames, &channels);
    assert_memory_equal(values, bat_take_values(a, NULL, NULL), frames * channels * sizeof *values);
    bat_take_free(a);
    bat_object_release(object), bat_object_release(moved);
    bat_motion_free(motion);
}

/* Between frames it is between them, and at frames as the take has it; beyond the ends it stays there. */
static void is_placed_at_any_time(void **state) {
    (void)state;
    bat_motion *motion = motion_of(3, 0), *copy = NULL;
    double at[3 * WALKER_JOINTS], was[3 * WALKER_JOINTS];
    assert_int_equal(bat_motion_copy(motion, &copy), BAT_OK);
    assert_true(fabs(bat_motion_duration(copy) - (FRAMES - 1) / 60.0) < 1e-15);
    for (size_t f = 0; f < FRAMES; f++) {
        assert_int_equal(bat_motion_positions(copy, (double)f / 60, at), BAT_OK);
        assert_int_equal(bat_take_positions(bat_motion_take(motion), f, was), BAT_OK);
        for (int k = 0; k < 3 * WALKER_JOINTS; k++) assert_true(fabs(at[k] - was[k]) < 1e-7);
    }
    const double length = sqrt(39.0 * 39 + 9);
    for (double t = -1; t < 2; t += 0.0173) {
        assert_int_equal(bat_motion_positions(copy, t, at), BAT_OK);
        const double d[3] = {at[9] - at[6], at[10] - at[7], at[11] - at[8]};
        assert_true(fabs(sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - length) < 1e-12 * 200);
    }
    assert_int_equal(bat_motion_positions(copy, 9, at), BAT_OK);
    for (int k = 0; k < 3 * WALKER_JOINTS; k++) assert_true(fabs(at[k] - was[k]) < 1e-7);
    assert_int_equal(bat_motion_positions(copy, NAN, at), BAT_NUMBER);
    assert_int_equal(bat_motion_positions(NULL, 0, at), BAT_ARGUMENT);
    assert_int_equal(bat_motion_copy(NULL, &copy), BAT_ARGUMENT);
    bat_motion_free(motion), bat_motion_free(copy);
}

static bat_status read(const char *text, size_t size, bat_document **out, bat_problem *problem) {
    const bat_reading how = {.xml = NULL};
    const bat_format *format = NULL;
    bat_svg_report report;
    return bat_formats_read(&how, text, size, &format, out, &report, problem);
}

static void a_bvh_file_is_a_drawing(void **state) {
    (void)state;
    bat_take *take = walker(9, FRAMES);
    const bat_format *format = bat_format_named("bvh");
    char *bvh = NULL, *out = NULL, *drawing = NULL;
    size_t size = 0, length = 0, all = 0;
    bat_document *document = NULL, *again = NULL;
    bat_problem problem;
    assert_non_null(format);
    assert_int_equal(bat_bvh_write(take, &bvh, &size), BAT_OK);
    assert_int_equal(read(bvh, size, &document, &problem), BAT_OK);
    assert_int_equal(bat_document_count(document), 1);
    assert_int_equal(bat_object_kind(bat_document_at(document, 0)), BAT_KIND_SKELETON);
    assert_int_equal(bat_document_write(document, &drawing, &all), BAT_OK);
    assert_int_equal(read(drawing, all, &again, &problem), BAT_OK);
    assert_int_equal(format->write(again, &out, &length, &problem), BAT_OK);
    assert_int_equal(length, size);
    assert_memory_equal(out, bvh, size);
    bat_free(out);
    /* two, and none, are refused */
    bat_object *second = NULL;
    assert_int_equal(bat_object_with_id(bat_document_at(again, 0), 99, &second), BAT_OK);
    assert_int_equal(bat_document_insert(again, 1, second), BAT_OK);
    bat_object_release(second);
    assert_int_equal(format->write(again, &out, &length, &problem), BAT_COUNT);
    assert_string_equal(problem.message, "a .bvh file holds one skeleton, expected 1, found more");
    assert_int_equal(bat_document_remove(again, 0), BAT_OK);
    assert_int_equal(bat_document_remove(again, 0), BAT_OK);
    assert_int_equal(format->write(again, &out, &length, &problem), BAT_COUNT);
    assert_string_equal(problem.message, "a .bvh file holds a skeleton, expected 1, found none");
    /* a file that stops in the middle says where */
    assert_int_equal(read(bvh, size / 2, &document, &problem), BAT_SYNTAX);
    assert_non_null(strstr(problem.message, "expected"));
    bat_free(bvh), bat_free(drawing);
    bat_document_free(document), bat_document_free(again);
    bat_take_free(take);
}

/* One joint that turns, in two frames; */
static const char SOUND[] =
    "{\"batten\":6,\"page\":[0,0,9,9],\"next\":2,\"objects\":[{\"id\":1,\"kind\":\"skeleton\",\"place\":[1,0,"
    "0,0,0,1,0,0,0,0,"
    "1,0],\"motion\":{\"joints\":[{\"name\":\"a\",\"offset\":[0,0,0],\"channels\":[\"Xrotation\"],"
    "\"orientation\":{\"mode\":"
    "\"free\",\"base\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0,0,1],[0,0,0,1]]}}},{\"name\":\"\","
    "\"parent\":0,"
    "\"offset\":[0,4,0],\"end\":true}],\"levels\":0,\"frame_time\":0.5,\"frames\":2,\"values\":[1,2]}}]}";

static void what_is_not_sound_is_refused(void **state) {
    (void)state;
    const struct {
        const char *from, *to, *message;
    } cases[] = {
        {"\"frames\":2", "\"frames\":3",
         "values: expected a number for each channel of each frame, found a list"},
        {"\"frame_time\":0.5", "\"frame_time\":0",
         "frame_time: expected seconds above 0, up to 1e9, found an object"},
        {"\"levels\":0", "\"levels\":13", "levels: expected 0 to 12, found number 13"},
        {"\"levels\":0", "\"levels\":1.5", "levels: expected a whole number, found number 1.5"},
        {"\"parent\":0", "\"parent\":1", NULL},
        {"\"parent\":0,", "", NULL},
        {"\"Xrotation\"", "\"Xrotation\",\"Xrotation\"", NULL},
        {"\"Xrotation\"", "\"Wrotation\"", NULL},
        {"\"Xrotation\"", "\"Xposition\"", NULL},
        {"\"mode\":\"free\"", "\"mode\":\"along\"", NULL},
        {"\"end\":true", "\"end\":true,\"channels\":[\"Xrotation\"]", NULL},
        {"\"values\":[1,2]", "\"values\":[1,1e99]", NULL},
        {"\"place\":[1,", "\"place\":[", NULL},
        {"\"name\":\"a\"", "\"name\":7", NULL},
        {"\"motion\":", "\"notion\":", NULL},
    };
    bat_document *document = NULL;
    bat_problem problem;
    assert_int_equal(bat_document_read(SOUND, sizeof SOUND - 1, &document, &problem), BAT_OK);
    bat_document_free(document);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[ROOM];
        const char *at = strstr(SOUND, cases[i].from);
        assert_non_null(at);
        const int size = snprintf(text, sizeof text, "%.*s%s%s", (int)(at - SOUND), SOUND, cases[i].to,
                                  at + strlen(cases[i].from));
        const bat_status status = bat_document_read(text, (size_t)size, &document, &problem);
        if (status == BAT_OK) fail_msg("%s is taken", cases[i].to);
        assert_true(problem.message[0]);
        assert_non_null(strstr(problem.place, "line"));
        if (cases[i].message) assert_string_equal(problem.message, cases[i].message);
    }
    bat_motion *motion = motion_of(1, 0);
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    double place[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, NAN, 0};
    assert_int_equal(bat_object_create_skeleton(1, "", &style, NULL, NULL, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_skeleton(1, "", &style, motion, place, &object), BAT_NUMBER);
    assert_int_equal(bat_object_with_motion(NULL, motion, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_at_time(NULL, 0, &object), BAT_ARGUMENT);
    assert_null(object);
    bat_motion_free(motion);
}

/* A copy that stands as it does at a time has its bones where they are then, and is otherwise the same. */
static void stands_at_a_time(void **state) {
    (void)state;
    bat_motion *motion = motion_of(3, 0.5);
    bat_object *object = object_of(motion), *first = NULL, *posed = NULL, *moved = NULL;
    const double end = bat_motion_duration(motion);
    assert_int_equal(bat_object_at_time(object, 0, &first), BAT_OK);
    for (int c = 0; c < bat_object_curve_count(object); c++)
        assert_true(bat_curve_is_equal(bat_object_curve(object, c), bat_object_curve(first, c)));
    for (int i = 0; i <= 6; i++) {
        double at[3 * WALKER_JOINTS];
        const double time = end * (i - 1) / 4; /* beyond both ends, too */
        bat_document *document = NULL;
        assert_int_equal(bat_object_at_time(i % 2 ? object : first, time, &posed), BAT_OK);
        assert_int_equal(bat_motion_positions(motion, time, at), BAT_OK);
        for (int joint = 0; joint < WALKER_JOINTS; joint++) {
            bool met = false;
            for (int c = 0; c < bat_object_curve_count(posed); c++)
                for (size_t k = 0; k < bat_curve_count(bat_object_curve(posed, c)); k++) {
                    const double *p = bat_curve_points(bat_object_curve(posed, c)) + 3 * k;
                    met = met ||
                          (p[0] == at[3 * joint] && p[1] == -at[3 * joint + 1] && p[2] == -at[3 * joint + 2]);
                }
            assert_true(met);
        }
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, posed), BAT_OK);
        assert_null(bat_document_check(document));
        bat_document_free(document);
        bat_object_release(posed);
    }
    assert_int_equal(bat_object_at_time(object, NAN, &moved), BAT_NUMBER);
    assert_int_equal(bat_object_create_group(3, "", false, &moved), BAT_OK);
    assert_int_equal(bat_object_at_time(moved, 0, &posed), BAT_UNSUPPORTED);
    bat_object_release(moved), bat_object_release(first), bat_object_release(object);
    bat_motion_free(motion);
}

static bat_status all(const char *bvh, size_t size) {
    bat_document *document = NULL, *again = NULL;
    bat_object *other = NULL, *posed = NULL;
    char *text = NULL, *out = NULL;
    size_t length = 0, written = 0;
    bat_problem problem;
    bat_status status = read(bvh, size, &document, &problem);
    if (status == BAT_OK) {
        const bat_object *object = bat_document_at(document, 0);
        status = bat_object_with_motion(object, bat_object_motion(object, NULL), &other);
        if (status == BAT_OK) status = bat_object_at_time(object, 0.1, &posed);
    }
    if (status == BAT_OK) status = bat_document_write(document, &text, &length);
    if (status == BAT_OK) status = bat_document_read(text, length, &again, &problem);
    if (status == BAT_OK) status = bat_format_named("bvh")->write(again, &out, &written, &problem);
    bat_object_release(other), bat_object_release(posed);
    bat_document_free(document), bat_document_free(again);
    bat_free(text), bat_free(out);
    return status;
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_take *take = walker(4, 6);
    char *bvh = NULL;
    size_t size;
    assert_int_equal(bat_bvh_write(take, &bvh, &size), BAT_OK);
    bool reached = true;
    for (long n = 1; reached; n += 1 + n / 60) {
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = all(bvh, size);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_int_equal(alloc_live(), before);
    }
    bat_free(bvh);
    bat_take_free(take);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_kept_bit_for_bit),     cmocka_unit_test(signs_are_kept),
        cmocka_unit_test(has_bones_for_curves),    cmocka_unit_test(is_placed_at_any_time),
        cmocka_unit_test(a_bvh_file_is_a_drawing), cmocka_unit_test(what_is_not_sound_is_refused),
        cmocka_unit_test(stands_at_a_time),        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
