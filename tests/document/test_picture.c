/* Pictures to trace: their sizes read from headers of all kinds; images as objects; files that carry the bytes, and
 * refuse bytes that are no picture; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "document/picture.h"
#include "text/base64.h"
#include "support/alloc_fail.h"
#include "support/pictures.h"
#include "support/xml.h"
#include <batten/bezier.h>
#include <math.h>

static void expect(const unsigned char *bytes, size_t size, const char *type, double width, double height) {
    bat_picture *picture = NULL;
    double sides[2];
    /* A block of the very size: reading beyond it is found by the sanitizer. */
    unsigned char *exact = malloc(size + !size);
    memcpy(exact, bytes, size);
    assert_int_equal(bat_picture_create(exact, size, &picture), BAT_OK);
    assert_string_equal(bat_picture_type(picture), type);
    bat_picture_sides(picture, sides);
    assert_true(sides[0] == width && sides[1] == height);
    bat_picture_release(picture);
    free(exact);
}

static void sides_of_every_kind(void **unused) {
    (void)unused;
    unsigned char b[HEAD_ROOM];
    expect(b, head_png(b, 640, 480), "image/png", 640, 480);
    expect(b, head_png(b, 65535, 1), "image/png", 65535, 1);
    expect(b, head_jpeg(b, 4000, 3000, 0, false), "image/jpeg", 4000, 3000);
    for (uint32_t turn = 1; turn <= 8; turn++)
        for (int little = 0; little < 2; little++)
            expect(b, head_jpeg(b, 4000, 3000, turn, little), "image/jpeg", turn < 5 ? 4000 : 3000,
                   turn < 5 ? 3000 : 4000);
    expect(b, head_webp(b, ' ', 320, 200), "image/webp", 320, 200);
    expect(b, head_webp(b, 'L', 16384, 3), "image/webp", 16384, 3);
    expect(b, head_webp(b, 'X', 65535, 2), "image/webp", 65535, 2);
}

/* An SVG file is a picture only as foreign content has it, and no image to trace; a picture to trace is no foreign content. */
static void files_that_stand_alone(void **unused) {
    (void)unused;
    static const char head[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
    static const char *const bad[] = {"",
                                      "0\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "5\" height=\"0\" viewBox=\"0 0 1 1\"/>",
                                      "65536\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "1000000\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "5.5\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "-5\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "\" height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "5\" height=\"\" viewBox=\"0 0 1 1\"/>",
                                      "5\"  height=\"5\" viewBox=\"0 0 1 1\"/>",
                                      "5\" height=\"5\" viewbox=\"0 0 1 1\"/>",
                                      "5",
                                      "5\" height=\"5",
                                      "5\" height=\"5\" viewBox="};
    bat_picture *picture = NULL, *photo = NULL;
    bat_object *object = NULL;
    unsigned char b[HEAD_ROOM];
    const double m[6] = {1, 0, 0, 1, 0, 0}, flat[6] = {1, 1, 1, 1, 0, 0};
    expect((const unsigned char *)ALONE, sizeof ALONE - 1, "image/svg+xml", 300, 200);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[200];
        const int size = snprintf(text, sizeof text, "%s%s", head, bad[i]);
        assert_int_equal(bat_picture_create(text, (size_t)size, &picture), BAT_UNSUPPORTED);
    }
    assert_int_equal(bat_picture_create(ALONE, sizeof ALONE - 1, &picture), BAT_OK);
    assert_int_equal(bat_picture_create(b, head_png(b, 3, 2), &photo), BAT_OK);
    assert_int_equal(bat_object_create_image(1, "", picture, m, 1, &object), BAT_UNSUPPORTED);
    assert_int_equal(bat_object_create_foreign(1, "", photo, m, 1, &object), BAT_UNSUPPORTED);
    assert_int_equal(bat_object_create_foreign(1, "", NULL, m, 1, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_foreign(1, "", picture, m, NAN, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_foreign(1, "", picture, flat, 1, &object), BAT_NUMBER);
    assert_int_equal(bat_object_create_foreign(1, "", picture, m, 1, &object), BAT_OK);
    assert_true(bat_object_is_foreign(object) && bat_object_is_drawn(object) &&
                !bat_object_is_made_of_curves(object));
    bat_object_release(object);
    bat_picture_release(photo);
    bat_picture_release(picture);
}

/* What may stand before the frame of a JPEG file, and what ends the search. */
static void markers_of_jpeg(void **unused) {
    (void)unused;
    static const struct {
        const char *bytes;
        size_t size;
        bool good;
    } before[] = {
        {"\xff\x01", 2, true},         /* alone */
        {"\xff\xd0\xff\xd7", 4, true}, /* likewise */
        {"\xff\xc8\0\x02", 4, true},   /* an extension: no frame */
        {"\xff\xcc\0\x02", 4, true},   /* arithmetic coding: no frame */
        {"\xff\xe1\0\x06"
         "Exif",
         8, true}, /* says nothing */
        {"\xff\xe1\0\x10"
         "Exif\0\0MM\0*\xff\0\0\0",
         18, true}, /* lies beyond its end */
        {"\xff\xe1\0\x12"
         "Exif\0\0MM\0*\0\0\0\x08\0\x09",
         20, true},                   /* with fewer entries than it says */
        {"\xff\xd9", 2, false},       /* the end */
        {"\xff\xda\0\x02", 4, false}, /* pixels */
        {"\xff\xe0\0\x01", 4, false}, /* shorter than its own length */
        {"\0", 1, false},
    };
    for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
        unsigned char plain[HEAD_ROOM], b[2 * HEAD_ROOM];
        const size_t size = head_jpeg(plain, 640, 480, 0, false);
        memcpy(b, plain, 2);
        memcpy(b + 2, before[i].bytes, before[i].size);
        memcpy(b + 2 + before[i].size, plain + 2, size - 2);
        bat_picture *picture = NULL;
        if (before[i].good)
            expect(b, size + before[i].size, "image/jpeg", 640, 480);
        else
            assert_int_equal(bat_picture_create(b, size + before[i].size, &picture), BAT_UNSUPPORTED);
        assert_null(picture);
    }
}

/* Pictures of one digest are one picture, or the second is refused; a reference to none is none. */
static void pictures_of_one_digest(void **unused) {
    (void)unused;
    unsigned char b[HEAD_ROOM];
    bat_picture *one = NULL, *same = NULL;
    bat_pictures set = {0};
    size_t size = head_png(b, 640, 480), told = 0;
    assert_int_equal(bat_picture_create(b, size, &one), BAT_OK);
    assert_int_equal(bat_picture_create(b, size, &same), BAT_OK);
    assert_int_equal(bat_pictures_add(&set, one), BAT_OK);
    assert_int_equal(bat_pictures_add(&set, same), BAT_OK);
    assert_int_equal(set.count, 1);
    unsigned char *bytes = (unsigned char *)bat_picture_bytes(same, NULL);
    bytes[size - 1] ^= 1; /* other bytes of the same digest */
    assert_int_equal(bat_pictures_add(&set, same), BAT_ARGUMENT);
    bytes[size - 1] ^= 1;
    assert_memory_equal(bat_picture_bytes(one, &told), b, size);
    assert_int_equal(told, size);
    assert_null(bat_picture_retain(NULL));
    bat_picture_release(NULL);
    bat_pictures_free(&set);
    bat_picture_release(one);
    bat_picture_release(same);
}

/* Images as objects: what they refuse, and what they are not. */
static void refused_images(void **unused) {
    (void)unused;
    unsigned char b[HEAD_ROOM];
    const double matrix[6] = {1, 0, 0, 1, 0, 0};
    double corners[8] = {7, 7, 7, 7, 7, 7, 7, 7};
    bat_picture *picture = NULL;
    bat_object *made = NULL, *image = NULL, *guide = NULL;
    assert_int_equal(bat_picture_create(b, head_png(b, 640, 480), &picture), BAT_OK);
    assert_int_equal(bat_object_create_image(1, "", NULL, matrix, 1, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(1, "", picture, NULL, 1, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(1, "", picture, matrix, 1.5, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(1, "", picture, matrix, -1, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(1, "", picture, matrix, NAN, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(1, "", picture, matrix, 1, &image), BAT_OK);
    assert_int_equal(bat_object_create_guide(2, 0, 5, &guide), BAT_OK);
    assert_int_equal(bat_object_with_matrix(NULL, matrix, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_matrix(guide, matrix, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_matrix(image, NULL, &made), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_matrix(image, matrix, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_guide(guide, 1, NULL), BAT_ARGUMENT);
    assert_null(made);
    assert_null(bat_object_picture(guide));
    assert_null(bat_object_matrix(guide));
    assert_null(bat_object_plane(guide));
    bat_object_corners(guide, corners);
    for (int i = 0; i < 8; i++) assert_true(corners[i] == 0);
    bat_object_release(image);
    bat_object_release(guide);
    bat_picture_release(picture);
}

/* Every cut of every head, and every byte changed, is a picture of sane sides or is refused; nothing is read
 * beyond its end. */
static void broken_heads(void **unused) {
    (void)unused;
    unsigned char b[HEAD_ROOM];
    bat_picture *picture = NULL;
    for (int kind = 0; kind < 5; kind++) {
        size_t size = kind == 0   ? head_png(b, 640, 480)
                      : kind == 1 ? head_jpeg(b, 640, 480, 6, true)
                                  : head_webp(b, " LX"[kind - 2], 640, 480);
        size_t least = kind == 0 ? 33 : kind == 1 ? 2 + 36 + 7 + 10 : 30, refused = 0;
        for (size_t cut = 0; cut < size; cut++) {
            unsigned char *exact = malloc(cut + 1);
            memcpy(exact, b, cut);
            bat_status status = bat_picture_create(exact, cut, &picture);
            if (status == BAT_OK) bat_picture_release(picture);
            refused += status != BAT_OK;
            free(exact);
        }
        assert_true(refused >= least);
        for (size_t i = 0; i < size; i++)
            for (int bit = 0; bit < 8; bit++) {
                b[i] ^= (unsigned char)(1 << bit);
                double sides[2];
                if (bat_picture_create(b, size, &picture) == BAT_OK) {
                    bat_picture_sides(picture, sides);
                    assert_true(sides[0] >= 1 && sides[0] <= BAT_PICTURE_SIDE && sides[1] >= 1 &&
                                sides[1] <= BAT_PICTURE_SIDE);
                    bat_picture_release(picture);
                }
                b[i] ^= (unsigned char)(1 << bit);
            }
    }
    assert_int_equal(bat_picture_create(b, head_png(b, 0, 5), &picture), BAT_UNSUPPORTED);
    assert_int_equal(bat_picture_create(b, head_png(b, 65536, 5), &picture), BAT_UNSUPPORTED);
    assert_int_equal(bat_picture_create("GIF89a", 6, &picture), BAT_UNSUPPORTED);
    assert_int_equal(bat_picture_create(NULL, 6, &picture), BAT_ARGUMENT);
    assert_int_equal(bat_picture_create(b, BAT_PICTURE_SIZE + 1, &picture), BAT_COUNT);
}

/* RFC 4648, section 10, and what is none. */
static void base_64(void **unused) {
    (void)unused;
    static const char *const vectors[][2] = {{"f", "Zg=="},         {"fo", "Zm8="},
                                             {"foo", "Zm9v"},       {"foob", "Zm9vYg=="},
                                             {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
    for (int i = 0; i < 6; i++) {
        bat_text text = {0};
        bat_base64_write(&text, vectors[i][0], strlen(vectors[i][0]));
        assert_int_equal(text.size, strlen(vectors[i][1]));
        assert_memory_equal(text.data, vectors[i][1], text.size);
        bat_text_free(&text);
    }
    unsigned char b[HEAD_ROOM];
    size_t size = head_png(b, 3, 4);
    for (size_t more = 0; more < 3; more++) { /* all three remainders */
        bat_text text = {0};
        bat_picture *picture = NULL;
        memset(b + size, 0xfb, more);
        bat_base64_write(&text, b, size + more);
        bat_text_add(&text, "", 1);
        assert_int_equal(bat_picture_from_base64(text.data, text.size - 1, &picture), BAT_OK);
        size_t back;
        assert_memory_equal(bat_picture_bytes(picture, &back), b, size + more);
        assert_int_equal(back, size + more);
        bat_picture_release(picture);
        for (size_t cut = 1; cut < 4; cut++)
            assert_int_equal(bat_picture_from_base64(text.data, text.size - 1 - cut, &picture), BAT_SYNTAX);
        text.data[5] = '*';
        assert_int_equal(bat_picture_from_base64(text.data, text.size - 1, &picture), BAT_SYNTAX);
        bat_text_free(&text);
    }
}

static const double SLANTED[6] = {0.5, 0.25, -0.3, 0.75, -12.125, 7};

/* Two images of one picture, the second hidden and half transparent, and one of another. */
static bat_document *drawing(void) {
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_picture *first = make_picture(20, 10, 1), *second = make_picture(3, 5, 2);
    const double plain[6] = {2, 0, 0, 2, 5, -0.0};
    for (int i = 0; i < 3; i++) {
        bat_object *object = NULL, *hidden = NULL;
        assert_int_equal(bat_object_create_image((bat_id)i + 1, i ? "" : "sketch", i == 2 ? second : first,
                                                 i == 1 ? SLANTED : plain, i == 1 ? 0.4 : 1, &object),
                         BAT_OK);
        assert_int_equal(bat_object_with_state(object, i == 1, i == 2, &hidden), BAT_OK);
        assert_int_equal(bat_document_insert(document, i, hidden), BAT_OK);
        bat_object_release(object);
        bat_object_release(hidden);
    }
    bat_picture_release(first);
    bat_picture_release(second);
    assert_null(bat_document_check(document));
    return document;
}

static void images_are_objects(void **unused) {
    (void)unused;
    bat_picture *picture = make_picture(20, 10, 1);
    bat_object *object = NULL, *other = NULL;
    double box[4], corners[8];
    assert_int_equal(bat_object_create_image(7, "a", picture, SLANTED, 0.5, &object), BAT_OK);
    bat_object_corners(object, corners);
    /* By hand: (20, 0), (20, 10), (0, 10). */
    const double by_hand[8] = {-12.125, 7, -2.125, 12, -5.125, 19.5, -15.125, 14.5};
    for (int i = 0; i < 8; i++) assert_true(fabs(corners[i] - by_hand[i]) < 1e-12);
    bat_object_bounds(object, box);
    assert_true(fabs(box[0] + 15.125) < 1e-12 && fabs(box[1] - 7) < 1e-12 && fabs(box[2] + 2.125) < 1e-12 &&
                fabs(box[3] - 19.5) < 1e-12);
    assert_int_equal(bat_object_curve_count(object), 0);
    assert_int_equal(bat_object_kind(object), BAT_KIND_IMAGE);
    /* Of a style only the opacity is taken. */
    bat_style style = bat_style_defaults();
    style.opacity = 0.25;
    assert_int_equal(bat_object_with_style(object, &style, &other), BAT_OK);
    assert_false(bat_object_style(other)->stroked);
    assert_true(bat_object_style(other)->opacity == 0.25 && bat_object_picture(other) == picture);
    bat_object_release(other);
    bat_curve *none = NULL;
    assert_int_equal(bat_object_with_curves(object, 1, &none, &other), BAT_ARGUMENT);
    /* Matrices that flatten, or are no numbers, or lead too far away. */
    static const double bad[][6] = {{1, 2, 2, 4, 0, 0},   {0, 0, 0, 0, 1, 1},        {NAN, 0, 0, 1, 0, 0},
                                    {1, 0, 0, 1, NAN, 0}, {1, 0, 0, 1, 0, INFINITY}, {1e300, 0, 0, 1, 0, 0}};
    for (int i = 0; i < 6; i++) {
        assert_int_equal(bat_object_with_matrix(object, bad[i], &other), BAT_NUMBER);
        assert_int_equal(bat_object_create_image(7, "a", picture, bad[i], 0.5, &other), BAT_NUMBER);
    }
    assert_int_equal(bat_object_create_image(7, "a", picture, SLANTED, NAN, &other), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_image(0, "a", picture, SLANTED, 1, &other), BAT_ARGUMENT);
    bat_picture_release(picture); /* the object has its own use of it */
    assert_int_equal(bat_picture_digest(bat_object_picture(object)),
                     bat_picture_digest(bat_object_picture(object)));
    bat_object_release(object);
}

static void expect_same(const bat_document *a, const bat_document *b) {
    assert_null(bat_document_check(b));
    assert_int_equal(bat_document_digest(a), bat_document_digest(b));
    for (int i = 0; i < bat_document_count(a); i++) {
        size_t size, back;
        const void *bytes = bat_picture_bytes(bat_object_picture(bat_document_at(a, i)), &size);
        const void *read = bat_picture_bytes(bat_object_picture(bat_document_at(b, i)), &back);
        assert_int_equal(size, back);
        assert_memory_equal(bytes, read, size);
    }
}

static int times(const char *text, const char *what) {
    int count = 0;
    for (const char *at = text; (at = strstr(at, what)); at++) count++;
    return count;
}

static void native_files(void **unused) {
    (void)unused;
    bat_document *document = drawing(), *back = NULL;
    bat_problem problem;
    char *text;
    size_t size;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &back, &problem), BAT_OK);
    expect_same(document, back);
    assert_int_equal(times(text, "\"data\""), 2); /* each picture once */
    bat_document_free(back);
    /* What is broken is refused in one line that says what. */
    static const struct {
        const char *what, *by, *says;
    } breaks[] = {{"\"data\":\"iVBO", "\"data\":\"*VBO", "data: expected base 64"},
                  {"\"data\":\"iVBO", "\"data\":\"AVBO", "data: expected a PNG"},
                  {"\"data\":\"", "\"date\":\"", "data: expected a text"},
                  {"\"pictures\":[{\"picture\":\"", "\"pictures\":[{\"picture\":\"z", "picture: expected 16"},
                  {"\"pictures\"", "\"picturez\"", "picture: expected the digest of one"},
                  {"\"matrix\":[2,0,0,2", "\"matrix\":[2,0,0,0", "matrix: expected six numbers"},
                  {"\"matrix\":[2,0,0,2", "\"matrix\":[2,0,0", "matrix: expected six numbers"},
                  {"\"opacity\":0.4", "\"opacity\":1.4", "opacity: expected a number from 0 to 1"}};
    for (size_t i = 0; i < sizeof breaks / sizeof *breaks; i++) {
        char *at = strstr(text, breaks[i].what), broken[4096];
        assert_non_null(at);
        assert_true(snprintf(broken, sizeof broken, "%.*s%s%s", (int)(at - text), text, breaks[i].by,
                             at + strlen(breaks[i].what)) < (int)sizeof broken);
        back = NULL;
        assert_int_not_equal(bat_document_read(broken, strlen(broken), &back, &problem), BAT_OK);
        assert_null(back);
        assert_non_null(strstr(problem.message, breaks[i].says));
    }
    bat_free(text);
    bat_document_free(document);
}

static bat_document *read_svg(const char *text, bat_svg_report *report) {
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    if (xml_read(text, NULL, &document, report, &problem) != BAT_OK) fail_msg("%s", problem.message);
    return document;
}

/* The native document beside the drawing takes the bytes from the drawing; without it the drawing itself holds
 * all but the ids; and what another program moved counts. */
static void svg_files(void **unused) {
    (void)unused;
    bat_document *document = drawing();
    bat_svg_report report;
    char *text;
    size_t size;
    assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
    assert_int_equal(times(text, "base64,"), 3);
    assert_int_equal(times(text, "\"data\""), 0);
    bat_document *back = read_svg(text, &report);
    double page[4];
    assert_true(report.native && bat_losses_total(&report.lost) == 0);
    bat_document_page(document, page);
    bat_document_set_page(back, page);
    expect_same(document, back);
    bat_document_free(back);
    char *moved = strstr(text, "matrix(2 0 0 2 5 0)");
    if (!moved) moved = strstr(text, "matrix(2 0 0 2 5 ");
    assert_non_null(moved);
    moved[15] = '6';
    back = read_svg(text, &report);
    assert_true(report.edited && !report.native);
    assert_true(bat_object_matrix(bat_document_at(back, 0))[4] == 6);
    bat_document_free(back);
    bat_free(text);
    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
    back = read_svg(text, &report);
    assert_int_equal(bat_document_count(back), 3);
    for (int i = 0; i < 3; i++) {
        const bat_object *a = bat_document_at(document, i), *b = bat_document_at(back, i);
        assert_int_equal(bat_object_kind(b), BAT_KIND_IMAGE);
        assert_int_equal(bat_object_is_hidden(a), bat_object_is_hidden(b));
        assert_int_equal(bat_object_is_locked(a), bat_object_is_locked(b));
        assert_memory_equal(bat_object_matrix(a), bat_object_matrix(b), 6 * sizeof(double));
        assert_true(bat_object_style(a)->opacity == bat_object_style(b)->opacity);
        assert_int_equal(bat_picture_digest(bat_object_picture(a)),
                         bat_picture_digest(bat_object_picture(b)));
    }
    bat_document_free(back);
    bat_free(text);
    bat_document_free(document);
}

/* Of other programs: x, y, width, height, kept proportions, a transform, white space in the data; links to other
 * files and what is no picture are counted as left out. */
static void svg_of_others(void **unused) {
    (void)unused;
    unsigned char b[HEAD_ROOM];
    bat_text data = {0};
    bat_base64_write(&data, b, head_png(b, 20, 10));
    bat_text_add(&data, "", 1);
    char text[4096];
    snprintf(
        text, sizeof text,
        "<svg viewBox=\"0 0 100 100\"><g transform=\"translate(1 2)\" opacity=\".5\">"
        "<image x=\"10\" y=\"20\" width=\"40\" height=\"40\" xlink:href=\"data:image/png;base64,%.20s\n  "
        "%s\"/></g>"
        "<image width=\"40\" href=\"data:image/png;base64,%s\"/>"
        "<image href=\"photo.png\"/><image href=\"data:image/png;base64,Zm9v\"/>"
        "<image href=\"data:image/png,Zm9v\"/><image width=\"0\" href=\"data:image/png;base64,%s\"/></svg>",
        data.data, data.data + 20, data.data, data.data);
    bat_svg_report report;
    bat_document *document = read_svg(text, &report);
    assert_int_equal(bat_document_count(document), 2);
    assert_int_equal(report.lost.count[BAT_LOSS_IMAGE], 4);
    double box[4];
    /* 20 x 10 into 40 x 40 at (11, 22): 40 x 20, in the middle. */
    bat_object_bounds(bat_document_at(document, 0), box);
    assert_true(box[0] == 11 && box[1] == 32 && box[2] == 51 && box[3] == 52);
    assert_true(bat_object_style(bat_document_at(document, 0))->opacity == 0.5);
    bat_object_bounds(bat_document_at(document, 1), box);
    assert_true(box[0] == 0 && box[1] == 0 && box[2] == 40 && box[3] == 20);
    bat_document_free(document);
    bat_text_free(&data);
}

static void sets_of_pictures(void **unused) {
    (void)unused;
    bat_pictures set = {0};
    unsigned char *bytes = calloc(1, BAT_PICTURE_SIZE);
    head_png(bytes, 5, 5);
    bat_picture *list[3];
    for (int i = 0; i < 3; i++) {
        bytes[100] = (unsigned char)i;
        assert_int_equal(bat_picture_create(bytes, BAT_PICTURE_SIZE, &list[i]), BAT_OK);
    }
    assert_int_equal(bat_pictures_add(&set, list[0]), BAT_OK);
    assert_int_equal(bat_pictures_add(&set, list[0]), BAT_OK);
    assert_int_equal(set.count, 1);
    assert_int_equal(bat_pictures_add(&set, list[1]), BAT_OK);
    assert_int_equal(bat_pictures_add(&set, list[2]), BAT_COUNT); /* more than all may have */
    bat_pictures_drop(&set);
    assert_int_equal(bat_pictures_add(&set, list[2]), BAT_OK);
    assert_ptr_equal(bat_pictures_find(&set, bat_picture_digest(list[2])), list[2]);
    assert_null(bat_pictures_find(&set, bat_picture_digest(list[1])));
    for (int i = 0; i < 3; i++) bat_picture_release(list[i]);
    bat_pictures_free(&set);
    free(bytes);
}

static void failing_allocations(void **unused) {
    (void)unused;
    bat_document *document = drawing();
    char *native, *svg;
    size_t size, svg_size;
    assert_int_equal(bat_document_write(document, &native, &size), BAT_OK);
    assert_int_equal(bat_svg_write(document, true, &svg, &svg_size), BAT_OK);
    for (int what = 0; what < 4; what++) {
        long live = alloc_live();
        for (int n = 1;; n++) {
            bat_document *back = NULL;
            char *text = NULL;
            bat_status status;
            alloc_fail_at(n);
            if (what == 0)
                status = bat_document_write(document, &text, &size);
            else if (what == 1)
                status = bat_svg_write(document, true, &text, &svg_size);
            else if (what == 2)
                status = bat_document_read(native, size, &back, NULL);
            else {
                bat_svg_reader *reader = NULL;
                alloc_fail_at(0); /* the test's own parser allocates, too */
                assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
                assert_true(xml_feed(reader, svg));
                alloc_fail_at(n);
                status = bat_svg_reader_finish(reader, &back, NULL, NULL);
            }
            bool reached = alloc_fail_reached();
            if (status == BAT_OK) {
                bat_free(text);
                bat_document_free(back);
            } else {
                assert_int_equal(status, BAT_MEMORY);
                assert_null(text);
                assert_null(back);
            }
            assert_int_equal(alloc_live(), live);
            if (!reached) {
                assert_int_equal(status, BAT_OK);
                break;
            }
        }
    }
    bat_free(native);
    bat_free(svg);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_of_every_kind),
        cmocka_unit_test(files_that_stand_alone),
        cmocka_unit_test(markers_of_jpeg),
        cmocka_unit_test(pictures_of_one_digest),
        cmocka_unit_test(refused_images),
        cmocka_unit_test(broken_heads),
        cmocka_unit_test(base_64),
        cmocka_unit_test(images_are_objects),
        cmocka_unit_test(native_files),
        cmocka_unit_test(svg_files),
        cmocka_unit_test(svg_of_others),
        cmocka_unit_test(sets_of_pictures),
        cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests_name("pictures", tests, NULL, NULL);
}
