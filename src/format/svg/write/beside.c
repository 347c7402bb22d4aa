/* What SVG cannot hold of a document is written beside its drawing: the drawing is read as any reader will read it, and each
 * object that does not come back from there bit for bit is listed with what it takes the place of (docs/format.md). */
#include "curve/curve.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/object.h"
#include "document/picture.h"
#include "document/scale.h"
#include "document/unit.h"
#include "format/json/curve.h"
#include "format/native/held.h"
#include "format/native/native.h"
#include "format/svg/held.h"
#include "format/svg/write/patch.h"
#include "kinds/kinds.h"
#include "text/base64.h"

#include <stdlib.h>
#include <string.h>

/* An object and the element that shows it, or shows it first. */
typedef struct pair {
    uint32_t element;
    int object, drawn; /* indices in the document and in what is read again */
} pair;

typedef enum way {
    AS_READ,  /* it comes back from the drawing */
    AS_DRAWN, /* with another group, other curves, or none of these: it has to be known by its picture */
    WHOLE
} way;

typedef struct beside {
    const bat_document *document;
    const bat_svg_again *again;
    pair *pairs; /* of both ascending */
    int count;
    way *ways;          /* of each pair */
    uint32_t *elements; /* of each object of the document, its first one; 0: none */
    uint32_t element_count;
    bat_id *ids;       /* of what is read again: those that it has in the document; 0: none */
    uint64_t *digests; /* of what is read again */
    uint64_t all;
    bat_held held;
} beside;

static void release(beside *b) {
    bat_held_free(&b->held);
    free(b->pairs);
    free(b->ways);
    free(b->elements);
    free(b->ids);
    free(b->digests);
}

/* ---- which object is read from which element ---- */

static int by_element(const void *a, const void *b) {
    const pair *x = a, *y = b;
    if (x->element != y->element) return x->element < y->element ? -1 : 1;
    return (x->object > y->object) - (x->object < y->object);
}

static int by_object(const void *a, const void *b) {
    const pair *x = a, *y = b;
    if (x->object != y->object) return x->object < y->object ? -1 : 1;
    if (x->drawn != y->drawn) return x->drawn < y->drawn ? -1 : 1;
    return (x->element > y->element) - (x->element < y->element);
}

/* The objects with their elements, sorted by these. */
static bat_status list_marks(beside *b, const bat_svg_output *out) {
    bat_svg_tags tags;
    const bat_status status = bat_svg_tags_scan(out->text.data, out->text.size, &tags);
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
    for (int i = 0; i < out->count; i++) {
        const bat_svg_mark *mark = &out->marks[i];
        const uint32_t element = mark->id ? bat_svg_element_at(&tags, mark->at) : 0;
        const int object = element ? bat_document_find(b->document, mark->id) : -1;
        if (object < 0) continue;
        b->pairs[b->count++] = (pair){element, object, -1};
        if (!b->elements[object]) b->elements[object] = element;
    }
    b->element_count = tags.count;
    bat_svg_tags_free(&tags);
    if (b->count > 1) qsort(b->pairs, (size_t)b->count, sizeof *b->pairs, by_element); /* no ties */
    return BAT_OK;
}

/* What each of these elements is read as: of those that `use` draws, one after the other. */
static void match_places(beside *b) {
    const bat_svg_again *again = b->again;
    int k = 0;
    for (int i = 0; i < again->place_count && k < b->count; i++) {
        const bat_sourced *place = &again->places[i];
        const int drawn = place->id ? bat_document_find(again->document, place->id) : -1;
        while (k < b->count && b->pairs[k].element < place->element) k++;
        if (drawn >= 0 && k < b->count && b->pairs[k].element == place->element) b->pairs[k++].drawn = drawn;
    }
}

/* Keeps the pairs that stand in the same order in both. */
static void sort_pairs(beside *b) {
    int count = 0;
    if (b->count > 1) qsort(b->pairs, (size_t)b->count, sizeof *b->pairs, by_object); /* no ties */
    for (int i = 0; i < b->count; i++) {
        const pair *last = count > 0 ? &b->pairs[count - 1] : NULL;
        if (b->pairs[i].drawn < 0) continue;
        if (last && (b->pairs[i].object <= last->object || b->pairs[i].drawn <= last->drawn)) continue;
        b->pairs[count++] = b->pairs[i];
    }
    b->count = count;
    for (int i = 0; i < count; i++)
        b->ids[b->pairs[i].drawn] = bat_object_id(bat_document_at(b->document, b->pairs[i].object));
}

/* ---- what comes back ---- */

static uint64_t digest_of(const bat_object *object) { return bat_digest_object(bat_digest_begin(), object); }

/* Whether the object read again, placed so, has the curves of that object or is like it but for them. */
static bat_status is_like(const bat_object *placed, const bat_object *object, bool *out) {
    const int count = bat_object_curve_count(object);
    *out = digest_of(placed) == digest_of(object);
    if (*out || bat_object_type(placed) != &bat_kind_of_path ||
        bat_object_type(object) != &bat_kind_of_path || bat_object_curve_count(placed) != count)
        return BAT_OK;
    bat_object_part *parts = malloc((size_t)count * sizeof *parts);
    if (!parts) return BAT_MEMORY;
    for (int i = 0; i < count; i++) parts[i] = (bat_object_part){object, i};
    bat_object *made = NULL;
    const bat_status status = bat_path_of_parts(placed, count, parts, &made);
    free(parts);
    *out = status == BAT_OK && digest_of(made) == digest_of(object);
    bat_object_release(made);
    return status == BAT_MEMORY ? status : BAT_OK;
}

/* How that pair comes back; the drawing may have more objects for it. */
static bat_status judge(const beside *b, int index, way *out) {
    const pair *p = &b->pairs[index];
    const bat_object *object = bat_document_at(b->document, p->object),
                     *read = bat_document_at(b->again->document, p->drawn);
    const bat_id id = bat_object_id(object);
    bat_object *placed = NULL;
    bool like = false;
    bat_status status = bat_held_place(read, id, bat_held_parent(b->again->document, b->ids, p->drawn),
                                       &placed);
    *out = WHOLE;
    if (status == BAT_OK && digest_of(placed) == digest_of(object)) *out = AS_READ;
    bat_object_release(placed);
    placed = NULL;
    if (status == BAT_MEMORY || *out == AS_READ) return status;
    status = bat_held_place(read, id, bat_object_parent(object), &placed);
    if (status == BAT_OK) status = is_like(placed, object, &like);
    bat_object_release(placed);
    if (like) *out = AS_DRAWN;
    return status == BAT_MEMORY ? status : BAT_OK;
}

static bat_status judge_all(beside *b) {
    bat_status status = BAT_OK;
    for (int i = 0; i < b->count && status == BAT_OK; i++) status = judge(b, i, &b->ways[i]);
    return status;
}

/* The pair of that object, or -1. */
static int find_pair(const beside *b, bat_id id) {
    const int object = bat_document_find(b->document, id);
    int low = 0, high = b->count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (b->pairs[middle].object < object)
            low = middle + 1;
        else
            high = middle;
    }
    return object >= 0 && low < b->count && b->pairs[low].object == object ? low : -1;
}

/* The objects that others follow or are made from have to be known, whatever becomes of the drawing. */
static void know(beside *b, bat_id id) {
    const int at = id ? find_pair(b, id) : -1;
    if (at >= 0 && b->ways[at] == AS_READ) b->ways[at] = AS_DRAWN;
}

static void know_sources(beside *b) {
    for (int i = 0; i < bat_document_count(b->document); i++) {
        const bat_object *object = bat_document_at(b->document, i);
        const bat_kind_type *type = bat_object_type(object);
        const bat_id *sources;
        const int count = bat_object_sources(object, &sources);
        if (type->followed) know(b, type->followed(object));
        for (int k = 0; k < count; k++) know(b, sources[k]);
    }
}

/* ---- the list ---- */

static bat_substitute *add(beside *b, int at, int count) {
    bat_substitute *made = &b->held.splices[b->held.count++];
    *made = (bat_substitute){.at = at, .count = count};
    if (count > 0) made->digest = bat_svg_held_digest(b->digests + at, count);
    return made;
}

static bat_status set_curves(const beside *b, const pair *p, bat_substitute *out) {
    const bat_object *object = bat_document_at(b->document, p->object),
                     *read = bat_document_at(b->again->document, p->drawn);
    const int count = bat_object_curve_count(object);
    out->redrawn = calloc((size_t)count + 1, sizeof *out->redrawn);
    if (!out->redrawn) return BAT_MEMORY;
    for (int i = 0; i < count; i++)
        if (bat_object_curve_digest(object, i) != bat_object_curve_digest(read, i))
            out->redrawn[out->redrawn_count++].index = i;
    return BAT_OK;
}

/* Pair i, with what else of the drawing there is before the next one. */
static bat_status add_pair(beside *b, int i, int end) {
    const pair *p = &b->pairs[i];
    const bat_object *object = bat_document_at(b->document, p->object);
    int count = 1;
    while (p->drawn + count < end &&
           bat_object_is_drawn(bat_document_at(b->again->document, p->drawn + count)))
        count++;
    if (count == 1 && b->ways[i] == AS_READ) return BAT_OK;
    const bool like = count == 1 && b->ways[i] == AS_DRAWN;
    bat_substitute *made = add(b, p->drawn, count);
    made->object = bat_object_retain(object);
    made->grouped = bat_held_parent(b->again->document, b->ids, p->drawn) != bat_object_parent(object);
    if (!like) return BAT_OK;
    made->like = true;
    made->id = bat_object_id(object);
    made->parent = bat_object_parent(object);
    return set_curves(b, p, made);
}

/* From the end of one pair to the next: objects that no element shows, and elements that show none. */
static void add_between(beside *b, int first, int last, int from, int to) {
    for (int k = first; k < last; k++) {
        bat_substitute *made = add(b, from, 0);
        made->object = bat_object_retain(bat_document_at(b->document, k));
        made->element = b->elements[k];
        if (made->element) b->held.element_count = b->element_count;
    }
    for (int j = from; j < to; j++) (void)add(b, j, 1);
}

static bat_status list_splices(beside *b) {
    const int objects = bat_document_count(b->document), drawn = bat_document_count(b->again->document);
    b->held.splices = calloc((size_t)objects + (size_t)drawn + 1, sizeof *b->held.splices);
    bat_status status = b->held.splices ? BAT_OK : BAT_MEMORY;
    for (int i = -1; i < b->count && status == BAT_OK; i++) {
        const int next = i + 1 < b->count ? b->pairs[i + 1].object : objects,
                  end = i + 1 < b->count ? b->pairs[i + 1].drawn : drawn;
        int from = 0;
        if (i >= 0) {
            const int before = b->held.count;
            status = add_pair(b, i, end);
            from = b->pairs[i].drawn + (b->held.count > before ? b->held.splices[before].count : 1);
        }
        if (status == BAT_OK) add_between(b, i < 0 ? 0 : b->pairs[i].object + 1, next, from, end);
    }
    return status;
}

/* By how much the ids of all others differ. */
static bat_status list_shifts(beside *b) {
    int64_t last = 0;
    b->held.shifts = malloc(((size_t)b->count + 1) * sizeof *b->held.shifts);
    if (!b->held.shifts) return BAT_MEMORY;
    for (int i = 0, k = 0; i < b->count; i++) {
        const int at = b->pairs[i].drawn;
        const bat_object *read = bat_document_at(b->again->document, at);
        const int64_t more = (int64_t)b->ids[at] - (int64_t)bat_object_id(read);
        while (k < b->held.count && b->held.splices[k].at + b->held.splices[k].count <= at) k++;
        if (k < b->held.count && b->held.splices[k].count > 0 && b->held.splices[k].at <= at) continue;
        if (more != last) b->held.shifts[b->held.shift_count++] = (bat_id_shift){at, more};
        last = more;
    }
    return BAT_OK;
}

static void set_whole(beside *b) {
    double seen[4];
    bat_document_page(b->document, b->held.page);
    bat_document_page(b->again->document, seen);
    b->held.paged = memcmp(seen, b->held.page, sizeof seen) != 0;
    b->held.scale = bat_document_scale(b->document);
    b->held.unit = bat_document_unit(b->document);
    b->held.sized = bat_unit_is_kept(b->document) &&
                    (b->held.unit != bat_document_unit(b->again->document) ||
                     b->held.scale != bat_document_scale(b->again->document));
}

/* Whether the list gives the document back, bit for bit. */
static bat_status try_out(beside *b) {
    const int count = b->held.count, drawn = bat_document_count(b->again->document);
    int *placed = malloc(((size_t)count + 1) * sizeof *placed);
    bat_id *ids = malloc(((size_t)drawn + 1) * sizeof *ids);
    bat_document *made = NULL;
    bat_status status = placed && ids ? BAT_OK : BAT_MEMORY;
    for (int k = 0; k < count && status == BAT_OK; k++) placed[k] = b->held.splices[k].at;
    if (status == BAT_OK) status = bat_held_apply(b->again->document, &b->held, placed, true, ids, &made);
    if (status == BAT_OK && bat_document_digest(made) != bat_document_digest(b->document))
        status = BAT_UNSUPPORTED;
    if (status == BAT_OK && bat_document_next(made) < bat_document_next(b->document))
        b->held.next = bat_document_next(b->document);
    bat_document_free(made);
    free(placed);
    free(ids);
    return status == BAT_OK || status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
}

static bat_status prepare(beside *b, const bat_document *document, const bat_svg_output *out,
                          const bat_svg_again *again) {
    const size_t drawn = (size_t)bat_document_count(again->document) + 1;
    *b = (beside){.document = document, .again = again};
    b->pairs = malloc(((size_t)out->count + 1) * sizeof *b->pairs);
    b->ways = malloc(((size_t)out->count + 1) * sizeof *b->ways);
    b->elements = calloc((size_t)bat_document_count(document) + 1, sizeof *b->elements);
    b->ids = calloc(drawn, sizeof *b->ids);
    b->digests = malloc(drawn * sizeof *b->digests);
    if (!b->pairs || !b->ways || !b->elements || !b->ids || !b->digests) return BAT_MEMORY;
    b->all = bat_svg_held_digests(again->document, again->shown, again->shown_count, b->digests);
    bat_status status = list_marks(b, out);
    if (status != BAT_OK) return status;
    match_places(b);
    sort_pairs(b);
    return judge_all(b);
}

/* ---- the text ---- */

static void add_number(bat_text *bytes, double number) {
    uint64_t bits;
    char low_first[8];
    memcpy(&bits, &number, sizeof bits);
    for (int k = 0; k < 8; k++) low_first[k] = (char)(bits >> 8 * k & 0xff);
    bat_text_add(bytes, low_first, sizeof low_first);
}

/* As a list, or as base 64 of their bits, whichever is shorter. */
static void write_numbers(const double *numbers, size_t count, bat_text *json) {
    bat_text bytes = {0}, bits = {0}, list = {0};
    for (size_t i = 0; i < count; i++) add_number(&bytes, numbers[i]);
    bat_text_string(&bits, "\"");
    if (bytes.data) bat_base64_write(&bits, bytes.data, bytes.size);
    bat_text_string(&bits, "\"");
    bat_numbers_to_json(numbers, count, &list);
    const bat_text *shorter = list.size < bits.size ? &list : &bits;
    if (shorter->data) bat_text_add(json, shorter->data, shorter->size);
    json->failed = json->failed || bytes.failed || bits.failed || list.failed;
    bat_text_free(&bytes);
    bat_text_free(&bits);
    bat_text_free(&list);
}

static bool has_same_knots(const bat_curve *a, const bat_curve *b) {
    const int knots = bat_curve_knot_count(a);
    return bat_curve_degree(a) == bat_curve_degree(b) && bat_curve_is_closed(a) == bat_curve_is_closed(b) &&
           bat_curve_dimension(a) == bat_curve_dimension(b) && knots == bat_curve_knot_count(b) &&
           memcmp(bat_curve_knots(a), bat_curve_knots(b), (size_t)knots * sizeof(double)) == 0;
}

/* The points that the drawing gives otherwise, and which they are: place, how many from there on, ... */
static void write_points(const bat_curve *curve, const bat_curve *read, bat_text *json) {
    const size_t d = (size_t)bat_curve_dimension(curve), count = (size_t)bat_point_count(curve);
    const double *points = bat_curve_points(curve), *others = bat_curve_points(read);
    double *moved = malloc(count * d * sizeof *moved);
    bat_text places = {0};
    size_t some = 0;
    for (size_t i = 0, end; moved && i < count; i = end + 1) {
        for (end = i; end < count && memcmp(points + d * end, others + d * end, d * sizeof *points) != 0;
             end++)
            memcpy(moved + d * some++, points + d * end, d * sizeof *points);
        if (end == i) continue;
        bat_text_string(&places, ",");
        bat_text_integer(&places, i);
        bat_text_string(&places, ",");
        bat_text_integer(&places, end - i);
    }
    if (moved) write_numbers(moved, d * some, json);
    if (places.data) bat_text_add(json, places.data, places.size);
    json->failed = json->failed || !moved || places.failed;
    bat_text_free(&places);
    free(moved);
}

static void write_curve(const bat_curve *curve, const bat_curve *read, int index, bat_text *json) {
    const int dimension = bat_curve_dimension(curve);
    bat_text_string(json, ",[");
    bat_text_integer(json, (uint64_t)index);
    bat_text_string(json, ",");
    if (has_same_knots(curve, read)) {
        write_points(curve, read, json);
    } else {
        bat_text_integer(json, (uint64_t)bat_curve_degree(curve));
        bat_text_string(json, bat_curve_is_closed(curve) ? ",true," : ",false,");
        write_numbers(bat_curve_knots(curve), (size_t)bat_curve_knot_count(curve), json);
        bat_text_string(json, ",");
        write_numbers(bat_curve_points(curve), (size_t)bat_point_count(curve) * (size_t)dimension, json);
        if (dimension == 3) bat_text_string(json, ",3");
    }
    bat_text_string(json, "]");
}

static void write_splice(const beside *b, const bat_substitute *s, bat_text *json) {
    const bat_object *read = bat_document_at(b->again->document, s->at);
    char digest[17] = "";
    bat_text_string(json, "[");
    bat_text_integer(json, (uint64_t)s->at);
    bat_text_string(json, ",");
    bat_text_integer(json, (uint64_t)s->count);
    bat_text_string(json, ",\"");
    if (s->count > 0) bat_digest_print(s->digest, digest);
    bat_text_string(json, digest);
    bat_text_string(json, "\",");
    if (s->like) {
        bat_text_string(json, "[");
        bat_text_integer(json, s->id);
        bat_text_string(json, s->grouped ? "," : ",-1");
        if (s->grouped) bat_text_integer(json, s->parent);
        for (int k = 0; k < s->redrawn_count; k++) {
            const int index = s->redrawn[k].index;
            write_curve(bat_object_curve(s->object, index), bat_object_curve(read, index), index, json);
        }
        bat_text_string(json, "]");
    } else if (s->object) {
        bat_object_to_json(s->object, json);
        if (s->count > 0 && s->grouped) bat_text_string(json, ",1");
        if (s->element) bat_text_string(json, ",");
        if (s->element) bat_text_integer(json, s->element);
    } else {
        bat_text_string(json, "null");
    }
    bat_text_string(json, "]");
}

/* The pictures of listed objects that the drawing does not have. */
static bat_status write_pictures(const beside *b, bat_text *json) {
    bat_pictures drawn = {0}, written = {0};
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(b->again->document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(b->again->document, i);
        if (bat_object_picture(object) && !bat_object_is_foreign(object))
            status = bat_pictures_add(&drawn, bat_object_picture(object));
    }
    for (int k = 0; k < BAT_OBJECT_PICTURES * b->held.count && status == BAT_OK; k++) {
        const bat_substitute *s = &b->held.splices[k / BAT_OBJECT_PICTURES];
        const bat_picture *picture = s->object && !s->like
                                         ? bat_object_picture_at(s->object, k % BAT_OBJECT_PICTURES)
                                         : NULL;
        const int before = written.count;
        if (!picture || bat_pictures_find(&drawn, bat_picture_digest(picture))) continue;
        status = bat_pictures_add(&written, picture);
        if (status != BAT_OK || written.count == before) continue;
        bat_text_string(json, before ? "," : ",\"pictures\":[");
        bat_picture_to_json(picture, json);
    }
    if (written.count) bat_text_string(json, "]");
    bat_pictures_free(&drawn);
    bat_pictures_free(&written);
    return status;
}

static bat_status write_json(const beside *b, bat_text *json) {
    const bat_held *held = &b->held;
    bat_text_string(json, "{\"batten\":11");
    if (held->paged) bat_text_numbers(json, ",\"page\":", held->page, 4);
    if (held->sized) {
        bat_text_string(json, ",\"unit\":\"");
        bat_text_string(json, bat_unit_word(held->unit));
        bat_text_string(json, "\",\"scale\":");
        bat_text_number(json, held->scale);
    }
    if (held->element_count) {
        bat_text_string(json, ",\"elements\":");
        bat_text_integer(json, held->element_count);
    }
    if (held->next) {
        bat_text_string(json, ",\"next\":");
        bat_text_integer(json, held->next);
    }
    for (int i = 0; i < held->shift_count; i++) {
        bat_text_string(json, i > 0 ? ",[" : ",\"ids\":[[");
        bat_text_number(json, held->shifts[i].from);
        bat_text_string(json, ",");
        bat_text_number(json, (double)held->shifts[i].more);
        bat_text_string(json, "]");
    }
    if (held->shift_count) bat_text_string(json, "]");
    const bat_status status = write_pictures(b, json);
    for (int k = 0; k < held->count; k++) {
        bat_text_string(json, k > 0 ? ",\n" : ",\"objects\":[\n");
        write_splice(b, &held->splices[k], json);
    }
    bat_text_string(json, held->count ? "]}" : "}");
    return status;
}

/* As content of an element, where quotes can stay. */
static void add_content(bat_text *text, const bat_text *json) {
    for (size_t at = 0; at < json->size;) {
        const char *quote = memchr(json->data + at, '"', json->size - at);
        const size_t end = quote ? (size_t)(quote - json->data) : json->size;
        bat_text_xml(text, json->data + at, end - at, false);
        if (quote) bat_text_string(text, "\"");
        at = end + 1;
    }
}

/* Lists everything, if the document comes back from it. */
static bat_status list(beside *b) {
    know_sources(b);
    bat_status status = list_splices(b);
    if (status == BAT_OK) status = list_shifts(b);
    set_whole(b);
    return status == BAT_OK ? try_out(b) : status;
}

static int count_as_read(const beside *b) {
    int count = 0;
    for (int i = 0; i < b->count; i++) count += b->ways[i] == AS_READ;
    return count;
}

/* Whether an object that nobody has edited does not come back from the drawing. */
static bool has_strangers(const beside *b) {
    const bat_source *source = bat_document_origin(b->document);
    for (int i = 0; i < bat_source_count(source); i++) {
        const bat_sourced *entry = bat_source_at(source, i);
        const int at = entry->id ? find_pair(b, entry->id) : -1;
        const bat_object *object = at < 0 ? NULL : bat_document_at(b->document, b->pairs[at].object);
        if (object && b->ways[at] != AS_READ && bat_object_is(object, BAT_CURVES) &&
            entry->shape == bat_sourced_shape(object))
            return true;
    }
    return false;
}

bat_status bat_svg_held_write(const bat_document *document, const bat_svg_output *out,
                              const bat_svg_again *again, bat_text *text) {
    const bat_svg_options every = bat_svg_defaults();
    bat_svg_again exact = {.like = document};
    beside merged = {0}, other = {0}, *best = &merged;
    bat_text json = {0};
    char noted[17];
    bat_status status = prepare(&merged, document, out, again);
    if (status == BAT_OK && has_strangers(&merged)) {
        status = bat_svg_again_read(&out->text, &every, &exact);
        if (status == BAT_OK) status = prepare(&other, document, out, &exact);
        if (status == BAT_OK && count_as_read(&other) > count_as_read(&merged)) best = &other;
    }
    if (status == BAT_OK) status = list(best);
    if (status == BAT_OK) status = write_json(best, &json);
    if (status == BAT_OK) {
        bat_digest_print(best->all, noted);
        bat_text_string(text, "drawing=\"");
        bat_text_string(text, noted);
        bat_text_string(text, best == &merged ? "\" nodes=\"merged\">" : "\">");
        add_content(text, &json);
        text->failed = text->failed || json.failed;
    }
    bat_text_free(&json);
    release(&merged);
    release(&other);
    bat_svg_again_free(&exact);
    return status == BAT_OK || status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
}
