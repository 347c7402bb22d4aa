/* The colours of the drawing. */
#include "document/document.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "text/text.h"

#include <stdlib.h>

enum { COLOURS = 64 };

typedef struct used {
    uint32_t colour;
    int times, first; /* first: where it came up first */
} used;

static int by_colour(const void *a, const void *b) {
    const used *x = a, *y = b;
    return x->colour != y->colour ? (x->colour > y->colour) - (x->colour < y->colour) : x->first - y->first;
}

static int by_times(const void *a, const void *b) {
    const used *x = a, *y = b;
    return x->times != y->times ? y->times - x->times : x->first - y->first;
}

/* The colours of all objects, each once, with how often it is used; returns how many. */
static int collect(const bat_document *document, used *list) {
    int count = 0, kept = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_style *style = bat_object_style(object);
        if (!bat_object_is_made_of_curves(object)) continue;
        if (style->stroked) list[count] = (used){style->stroke, 1, count}, count++;
        if (style->filled) list[count] = (used){style->fill, 1, count}, count++;
    }
    if (count) qsort(list, (size_t)count, sizeof *list, by_colour); /* no ties */
    for (int i = 0; i < count; i++) {
        if (kept && list[kept - 1].colour == list[i].colour)
            list[kept - 1].times++;
        else
            list[kept++] = list[i];
    }
    if (kept) qsort(list, (size_t)kept, sizeof *list, by_times); /* no ties */
    return kept;
}

const char *bat_panel_colours(bat_context *c) {
    const bat_document *document = c->session->document;
    bat_text text = {0};
    used *list = malloc((2 * (size_t)bat_document_count(document) + 1) * sizeof *list);
    if (!list) return NULL;
    const int count = collect(document, list);
    bat_text_string(&text, "");
    for (int i = 0; i < count && i < COLOURS; i++) {
        if (i) bat_text_string(&text, " ");
        bat_text_integer(&text, list[i].colour);
    }
    free(list);
    return bat_text_keep(&text, &c->panels->colours);
}
