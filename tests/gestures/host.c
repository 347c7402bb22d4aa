/*
 * A host of the engine for hand gestures: opens a drawing, sets the view, tells pointer events as the browser's shell
 * does, and prints what became of the document. It uses the public headers alone.
 *
 * Reads a script from standard input, one order a line:
 *   open PATH                        .svg or .batten
 *   size WIDTH HEIGHT RATIO          of the view, pixels
 *   view ZOOM X Y                    the document's (X, Y) in the middle of the view, ZOOM pixels a unit
 *   set PROPERTY VALUE
 *   command NAME
 *   key KEY MODIFIERS                pressed and let go
 *   select NAME | none               an object by its name, alone
 *   add NAME                         ... besides what is selected
 *   state NAME HIDDEN LOCKED
 *   level ACT LEVEL VALUE DONE       as bat_editor_level
 *   stroke                           prints a line: what changed since the last one, or since "before"
 *   before                           the document as it is now is the one to compare with
 *   mark                             the view is noted
 *   p PHASE DEVICE CONTACT BUTTONS MODIFIERS X Y PRESSURE TIME   phase, device as in input.h; TIME in ms
 *   frame                            a frame is taken
 *   report                           prints the JSON; the last order
 * Pointer events are handed over in one call when another order comes.
 */
#include <batten/batten.h>
#include <batten/svg_read.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EVENTS = 64, MARKS = 256 };

static bat_editor *editor;
static bat_document *before;
static bat_pointer events[EVENTS];
static size_t waiting;
static double marks[MARKS][4], size[3] = {1280, 752, 1}, clock_now = 1000;
static int mark_count, refused_count;
static char refused[16][128];

static void fail(const char *what, const char *which) {
    printf("{\"fault\":\"%s %s\"}\n", what, which ? which : "");
    fflush(stdout);
    exit(2);
}

static void refuse(const char *what, bat_status status) {
    if (refused_count < 16)
        snprintf(refused[refused_count++], sizeof refused[0], "%.90s: %s", what, bat_status_message(status));
}

/* ---- opening ---- */

static char *read_file(const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    if (!file) fail("cannot open", path);
    char *text = NULL;
    size_t room = 0;
    *length = 0;
    for (;;) {
        if (*length + 65536 > room) text = realloc(text, room = 2 * room + 131072);
        if (!text) fail("memory", "");
        size_t got = fread(text + *length, 1, 65536, file);
        *length += got;
        if (!got) break;
    }
    fclose(file);
    return text;
}

static void open_drawing(const char *path) {
    size_t length;
    char *text = read_file(path, &length);
    bat_document *document = NULL;
    bat_problem problem;
    const char *dot = strrchr(path, '.');
    bat_status status = dot && !strcmp(dot, ".batten")
                            ? bat_document_read(text, length, &document, &problem)
                            : bat_svg_read(text, length, NULL, &document, NULL, &problem);
    if (status != BAT_OK) fail("not read", problem.message);
    free(text);
    if (bat_editor_open(editor, document, "drawing.svg") != BAT_OK) fail("not opened", path);
}

/* ---- the view, by the wheel, as a hand would ---- */

static const double *view(void) { return bat_editor_frame(editor)->view; }

static void set_view(double zoom, double x, double y) {
    double middle[2] = {size[0] / 2, size[1] / 2}, rate = -1.0 / 200;
    for (int i = 0; i < 40; i++) {
        double is = view()[2], way = log(zoom / is);
        if (fabs(way) < 1e-9) break;
        double turn = fmax(-250, fmin(250, way / rate));
        bat_editor_wheel(editor, middle[0], middle[1], 0, turn, BAT_CTRL, clock_now += 20);
        double now = view()[2];
        if (now != is && fabs(turn) > 1e-6 && fabs(log(now / is) / turn) > 1e-5) rate = log(now / is) / turn;
    }
    double sign = 1;
    for (int i = 0; i < 60; i++) {
        const double *v = view();
        double dx = ((x - v[0]) * v[2] - middle[0]) * sign, dy = ((y - v[1]) * v[2] - middle[1]) * sign;
        double off = fabs(dx) + fabs(dy);
        if (off < 1e-6) break;
        bat_editor_wheel(editor, middle[0], middle[1], fmax(-900, fmin(900, dx)), fmax(-900, fmin(900, dy)),
                         0, clock_now += 20);
        v = view();
        if (fabs((x - v[0]) * v[2] - middle[0]) + fabs((y - v[1]) * v[2] - middle[1]) > off) sign = -sign;
    }
    const double *v = view();
    if (fabs(v[2] / zoom - 1) > 1e-3 || fabs((x - v[0]) * v[2] - middle[0]) > 1 || v[3] != 0)
        fail("view not set", "");
}

/* ---- orders ---- */

static bat_id named(const char *name) {
    const bat_document *document = bat_editor_document(editor);
    for (int i = 0; i < bat_document_count(document); i++)
        if (!strcmp(bat_object_name(bat_document_at(document, i)), name))
            return bat_object_id(bat_document_at(document, i));
    fail("no object named", name);
    return 0;
}

static void hand_over(void) {
    if (waiting) bat_editor_pointer(editor, waiting, events);
    waiting = 0;
}

static void pointer(const char *line) {
    unsigned phase, device, contact, buttons, modifiers;
    double x, y, pressure, time;
    if (sscanf(line, "%u %u %u %u %u %lf %lf %lf %lf", &phase, &device, &contact, &buttons, &modifiers, &x,
               &y, &pressure, &time) != 9)
        fail("bad event", line);
    if (waiting == EVENTS) hand_over();
    bat_pointer event = {.phase = (bat_pointer_phase)phase,
                         .device = (bat_device)device,
                         .contact = contact,
                         .buttons = buttons,
                         .modifiers = modifiers,
                         .x = x,
                         .y = y,
                         .pressure = pressure,
                         .time = time};
    if (device == BAT_DEVICE_PEN) event.tilt_x = 25, event.tilt_y = 10;
    events[waiting++] = event;
    clock_now = fmax(clock_now, time);
}

/* ---- what is said while the pen is down ---- */

static char shown[2][256];  /* what a stroke is taken for, now and before */
static int shifts, returns; /* how often that changes, and how often to what it was before */

static void watch(void) {
    const bat_frame *frame = bat_editor_frame(editor);
    if (!events[0].buttons || !frame->live_count) {
        shown[0][0] = shown[1][0] = '\0';
        return;
    }
    if (!strcmp(shown[0], frame->hint)) return;
    shifts += shown[0][0] != '\0';
    returns += shown[1][0] && !strcmp(shown[1], frame->hint);
    memcpy(shown[1], shown[0], sizeof shown[1]);
    snprintf(shown[0], sizeof shown[0], "%s", frame->hint);
}

/* ---- what came of it ---- */

static void put_text(const char *text) {
    putchar('"');
    for (; text && *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') putchar('\\');
        if (c < 32)
            printf("\\u%04x", c);
        else
            putchar(c);
    }
    putchar('"');
}

static void put_numbers(const double *numbers, int count, int stride, int of) {
    putchar('[');
    for (int i = 0; i < count; i++) {
        if (i) putchar(',');
        if (of == 1)
            printf("%.9g", numbers[i]);
        else
            printf("[%.9g,%.9g]", numbers[stride * i], numbers[stride * i + 1]);
    }
    putchar(']');
}

/* Places on the curve, `each` a span. */
static void put_places(const bat_curve *curve, int each) {
    const double *knots = bat_curve_knots(curve);
    int degree = bat_curve_degree(curve), count = (int)bat_curve_count(curve),
        dimension = bat_curve_dimension(curve);
    int first = bat_curve_is_closed(curve) ? 0 : degree, last = count, spans = 0;
    double at[BAT_DIMENSION_MAX];
    for (int i = first; i < last; i++) spans += knots[i + 1] > knots[i];
    if (spans * each < 64) each = 64 / spans + 1;
    putchar('[');
    bool any = false;
    for (int i = first; i < last; i++) {
        if (!(knots[i + 1] > knots[i])) continue;
        for (int j = 0; j < each; j++) {
            bat_curve_eval(curve, knots[i] + (knots[i + 1] - knots[i]) * j / each, 0, at);
            printf("%s[%.13g,%.13g]", any ? "," : "", at[0], dimension > 1 ? at[1] : 0);
            any = true;
        }
    }
    bat_curve_eval(curve, knots[last], 0, at);
    if (!bat_curve_is_closed(curve)) printf(",[%.13g,%.13g]", at[0], at[1]);
    putchar(']');
}

static void put_object(const bat_object *object, int each) {
    printf("{\"id\":%llu,\"name\":", (unsigned long long)bat_object_id(object));
    put_text(bat_object_name(object));
    printf(",\"kind\":%d,\"curves\":[", (int)bat_object_kind(object));
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        printf("%s{\"degree\":%d,\"closed\":%s,\"levels\":%d,\"knots\":", i ? "," : "",
               bat_curve_degree(curve), bat_curve_is_closed(curve) ? "true" : "false",
               bat_object_shape(object, i) ? bat_shape_levels(bat_object_shape(object, i)) : -1);
        put_numbers(bat_curve_knots(curve), bat_curve_knot_count(curve), 1, 1);
        printf(",\"points\":");
        put_numbers(bat_curve_points(curve), (int)bat_curve_count(curve), bat_curve_dimension(curve), 2);
        printf(",\"places\":");
        put_places(curve, each);
        putchar('}');
    }
    printf("]}");
}

static bool same(const bat_object *a, const bat_object *b) {
    if (bat_object_curve_count(a) != bat_object_curve_count(b)) return false;
    for (int i = 0; i < bat_object_curve_count(a); i++)
        if (!bat_curve_is_equal(bat_object_curve(a, i), bat_object_curve(b, i))) return false;
    return bat_object_is_hidden(a) == bat_object_is_hidden(b);
}

static const bat_object *find(const bat_document *document, bat_id id) {
    int index = bat_document_find(document, id);
    return index < 0 ? NULL : bat_document_at(document, index);
}

/* which: 0 objects of `from` that are other or missing in `to`; 1: the whole of `from` */
static void put_objects(const bat_document *from, const bat_document *to, bool all, int each) {
    bool any = false;
    putchar('[');
    for (int i = 0; i < bat_document_count(from); i++) {
        const bat_object *object = bat_document_at(from, i),
                         *other = to ? find(to, bat_object_id(object)) : NULL;
        if (!bat_object_is_drawn(object) || (!all && other && same(object, other))) continue;
        if (any) printf(",\n");
        any = true;
        put_object(object, each);
    }
    putchar(']');
}

static void put_ids(const bat_document *of, const bat_document *in, bool shared) {
    bool any = false;
    putchar('[');
    for (int i = 0; i < bat_document_count(of); i++) {
        const bat_object *object = bat_document_at(of, i), *other = find(in, bat_object_id(object));
        if (!bat_object_is_drawn(object) || (shared ? !other || same(object, other) : other != NULL))
            continue;
        printf("%s%llu", any ? "," : "", (unsigned long long)bat_object_id(object));
        any = true;
    }
    putchar(']');
}

/* Begins a report: what is not as it was before. */
static void put_changes(const bat_document *after) {
    if (!before) fail("no", "before");
    printf("{\"changed\":");
    put_ids(after, before, true);
    printf(",\"added\":");
    put_ids(after, before, false);
    printf(",\"removed\":");
    put_ids(before, after, false);
}

static void report(void) {
    const bat_document *after = bat_editor_document(editor);
    const bat_frame *frame = bat_editor_frame(editor);
    put_changes(after);
    printf(",\"pending\":%u,\"undo\":%u,\"selected\":%u,\"notice\":", frame->pending, frame->can_undo,
           frame->selected);
    put_text(frame->notice);
    printf(",\"shifts\":%d,\"returns\":%d,\"hint\":", shifts, returns);
    put_text(frame->hint);
    printf(",\"view\":[%.9g,%.9g,%.9g,%.9g],\"marks\":[", frame->view[0], frame->view[1], frame->view[2],
           frame->view[3]);
    for (int i = 0; i < mark_count; i++)
        printf("%s[%.9g,%.9g,%.9g,%.9g]", i ? "," : "", marks[i][0], marks[i][1], marks[i][2], marks[i][3]);
    printf("],\"refused\":[");
    for (int i = 0; i < refused_count; i++) {
        if (i) putchar(',');
        put_text(refused[i]);
    }
    const char *readings = bat_editor_readings(editor);
    printf("],\"readings\":%s,\"said\":", readings && *readings ? readings : "null");
    put_text(bat_editor_said(editor));
    printf(",\"check\":");
    put_text(bat_editor_check(editor));
    printf(",\n\"before\":");
    put_objects(before, NULL, true, 12);
    printf(",\n\"after\":");
    put_objects(after, before, false, 16);
    printf("}\n");
    fflush(stdout);
}

static void remember(void) {
    bat_document_free(before);
    before = NULL;
    if (bat_document_copy(bat_editor_document(editor), &before) != BAT_OK) fail("memory", "");
}

/* What a stroke changed, as one line; the next is compared with what is there now. */
static void stroke_report(void) {
    const bat_document *after = bat_editor_document(editor);
    const char *readings = bat_editor_readings(editor);
    put_changes(after);
    printf(",\"readings\":%s,\"pending\":%u,\"after\":", readings && *readings ? readings : "null",
           bat_editor_frame(editor)->pending);
    bool any = false;
    putchar('[');
    for (int i = 0; i < bat_document_count(after); i++) {
        const bat_object *object = bat_document_at(after, i), *other = find(before, bat_object_id(object));
        if (!bat_object_is_drawn(object) || (other && same(object, other))) continue;
        for (int k = 0; k < bat_object_curve_count(object); k++) {
            printf(any ? "," : "");
            put_places(bat_object_curve(object, k), 12);
            any = true;
        }
    }
    printf("]}\n");
    remember();
}

static void order(char *line) {
    char word[32] = "", name[256] = "";
    double a = 0, b = 0, c = 0;
    int used = 0;
    if (sscanf(line, "%31s %n", word, &used) != 1) return;
    char *rest = line + used;
    if (!strcmp(word, "p")) {
        pointer(rest);
        return;
    }
    hand_over();
    if (!strcmp(word, "frame"))
        watch();
    else if (!strcmp(word, "open"))
        open_drawing(rest);
    else if (!strcmp(word, "size") && sscanf(rest, "%lf %lf %lf", &size[0], &size[1], &size[2]) == 3)
        bat_editor_resize(editor, size[0], size[1], size[2]);
    else if (!strcmp(word, "view") && sscanf(rest, "%lf %lf %lf", &a, &b, &c) == 3)
        set_view(a, b, c);
    else if (!strcmp(word, "set") && sscanf(rest, "%255s %lf", name, &a) == 2) {
        bat_status status = bat_editor_set(editor, name, a);
        if (status != BAT_OK) refuse(line, status);
    } else if (!strcmp(word, "command")) {
        bat_status status = bat_editor_command(editor, rest);
        if (status != BAT_OK) refuse(line, status);
    } else if (!strcmp(word, "key") && sscanf(rest, "%255s %lf", name, &a) == 2) {
        bat_editor_key(editor, name, true, (uint32_t)a, clock_now += 40);
        bat_editor_key(editor, name, false, (uint32_t)a, clock_now += 40);
    } else if (!strcmp(word, "select") || !strcmp(word, "add")) {
        bat_status status = bat_editor_select(editor, !strcmp(rest, "none") ? 0 : named(rest),
                                              word[0] == 'a');
        if (status != BAT_OK) refuse(line, status);
    } else if (!strcmp(word, "state") && sscanf(rest, "%255s %lf %lf", name, &a, &b) == 3) {
        bat_status status = bat_editor_set_state(editor, named(name), a != 0, b != 0);
        if (status != BAT_OK) refuse(line, status);
    } else if (!strcmp(word, "level")) {
        int act, level, done;
        if (sscanf(rest, "%d %d %lf %d", &act, &level, &a, &done) != 4) fail("bad order", line);
        bat_status status = bat_editor_level(editor, (bat_level_act)act, level, a, done != 0);
        if (status != BAT_OK) refuse(line, status);
    } else if (!strcmp(word, "before")) {
        remember();
    } else if (!strcmp(word, "mark")) {
        if (mark_count < MARKS) memcpy(marks[mark_count++], view(), sizeof marks[0]);
    } else if (!strcmp(word, "report"))
        report();
    else if (!strcmp(word, "stroke"))
        stroke_report();
    else
        fail("bad order", line);
}

int main(void) {
    static char line[4096];
    if (bat_editor_create(&editor) != BAT_OK) fail("memory", "");
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = 0;
        order(line);
    }
    bat_document_free(before);
    bat_editor_free(editor);
    return 0;
}
