/* Which commands the selection makes possible, and why others cannot be done: the contents of a row of buttons and of the
 * sheet of commands. */
#include "document/document.h"
#include "editor/commands/blend_edges.h"
#include "editor/edit/arrange.h"
#include "editor/edit/binding.h"
#include "editor/choice/choice.h"
#include "editor/commands/body.h"
#include "editor/commands/dispatch.h"
#include "editor/commands/surfaces.h"
#include "editor/commands/tuning.h"
#include "editor/commands/wires.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/notice.h"
#include "editor/show/deviate_samples.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "text/text.h"
#include "editor/tools/select.h"
#include "document/kind.h"
#include <stdlib.h>

typedef struct facts {
    int roots, groups, layers; /* number of roots; groups and layers among them */
    int open, closed, space;   /* number of curves; of those in space */
    int curved, compound;      /* number of objects that are made of curves; of several */
    int others;                /* number of objects that are no groups */
    int measured,
        formed; /* number of objects that distances can be measured of; of surfaces and meshes among them */
    bool page;  /* there is a page to align a single root to */
} facts;

static bat_status find(const bat_context *c, facts *f) {
    const bat_document *document = c->session->document;
    int *roots, count;
    double page[4];
    *f = (facts){0};
    bat_document_page(document, page);
    f->page = page[2] > 0 && page[3] > 0;
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status == BAT_STATE ? BAT_OK : status;
    f->roots = count;
    for (int i = 0; i < count; i++) {
        f->groups += bat_object_is_mere_group(bat_document_at(document, roots[i]));
        f->layers += bat_object_is(bat_document_at(document, roots[i]), BAT_LAYER);
        for (int k = roots[i], end = bat_document_end(document, k); k < end; k++) {
            const bat_object *object = bat_document_at(document, k);
            const int curves = bat_object_is_made_of_curves(object) ? bat_object_curve_count(object) : 0;
            f->others += !bat_object_is_group(object);
            f->curved += curves > 0;
            f->compound += curves > 1;
            f->measured += bat_deviating_takes(object);
            f->formed += bat_deviating_takes(object) && !bat_object_is_made_of_curves(object);
            for (int j = 0; j < curves; j++) {
                const bat_curve *curve = bat_object_curve(object, j);
                ++*(bat_curve_is_closed(curve) ? &f->closed : &f->open);
                f->space += bat_curve_dimension(curve) == 3;
            }
        }
    }
    free(roots);
    return BAT_OK;
}

/* Why a command cannot be done now, in words; NOBODY_ASKS: the selection does not decide that. */
#define NOBODY_ASKS ((bat_string)(BAT_STRING_COUNT + 1))

static bat_string unless(bool possible, bat_string why) { return possible ? BAT_STRING_COUNT : why; }

static bat_string why_no_surface(bat_context *c, const facts *f, bat_command_id id) {
    const bool plain = f->open + f->closed == 0, follow = bat_document_has_followers(c->session->document);
    switch (id) {
    case BAT_COMMAND_SURFACE_SWEEP:
    case BAT_COMMAND_SURFACE_RULED:
        return unless(f->roots > 1 && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_SELECT_TWO);
    case BAT_COMMAND_SURFACE_REVOLVE:
        return unless(f->roots > 1 && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_SELECT_REVOLVED);
    case BAT_COMMAND_SURFACE_COONS:
    case BAT_COMMAND_SURFACE_CLOSE:
        return unless(f->roots > 1 && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_SELECT_FOUR);
    case BAT_COMMAND_SURFACE_LOFT:
        return unless(f->roots > 1 && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_SELECT_SECTIONS);
    case BAT_COMMAND_SURFACE_FREE:
        return unless(follow && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_NOTHING_FOLLOWS);
    case BAT_COMMAND_SURFACE_CAP:
    case BAT_COMMAND_SURFACE_FLIP:
        return unless(plain && bat_surface_command_fits(c, id), BAT_STRING_NOTICE_SELECT_SURFACE);
    case BAT_COMMAND_SURFACE_MEET:
    case BAT_COMMAND_WIRE_MEET:
        return unless(f->roots == 2 && plain && bat_wire_command_fits(c, id),
                      BAT_STRING_NOTICE_SELECT_SURFACES);
    case BAT_COMMAND_WIRE_BIND:
        return unless(f->roots > 1 && bat_wire_command_fits(c, id), BAT_STRING_NOTICE_SELECT_WIRE);
    case BAT_COMMAND_WIRE_DOMAIN:
    case BAT_COMMAND_WIRE_FRAMES:
    case BAT_COMMAND_WIRE_BAKE:
    case BAT_COMMAND_WIRE_REVERT:
        return unless(follow && bat_wire_command_fits(c, id), BAT_STRING_NOTICE_NOTHING_BOUND);
    default: return NOBODY_ASKS;
    }
}

static bat_string why_no_arc(bat_context *c, const facts *f, bat_command_id id) {
    const bat_string why = BAT_STRING_NOTICE_NO_ARC;
    switch (id) {
    case BAT_COMMAND_ARC_PIE: return unless(f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_PIE), why);
    case BAT_COMMAND_ARC_CHORD: return unless(f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_CHORD), why);
    case BAT_COMMAND_ARC_OPEN: return unless(f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_OPEN), why);
    default: return why_no_surface(c, f, id);
    }
}

static bat_string why_not(bat_context *c, const facts *f, bat_command_id id, bool point) {
    const int curves = f->open + f->closed;
    switch (id) {
    case BAT_COMMAND_DELETE:
    case BAT_COMMAND_DUPLICATE:
    case BAT_COMMAND_ARRAY:
    case BAT_COMMAND_ORDER_FRONT:
    case BAT_COMMAND_ORDER_FORWARD:
    case BAT_COMMAND_ORDER_BACKWARD:
    case BAT_COMMAND_MIRROR_ACROSS:
    case BAT_COMMAND_MIRROR_DOWN:
    case BAT_COMMAND_ORDER_BACK: return unless(f->roots > 0, BAT_STRING_NOTICE_SELECT_FIRST);
    case BAT_COMMAND_ALIGN_LEFT:
    case BAT_COMMAND_ALIGN_CENTRE:
    case BAT_COMMAND_ALIGN_RIGHT:
    case BAT_COMMAND_ALIGN_TOP:
    case BAT_COMMAND_ALIGN_MIDDLE:
    case BAT_COMMAND_ALIGN_BOTTOM:
        return unless(f->roots > 1 || (f->roots == 1 && f->page), BAT_STRING_NOTICE_SELECT_SEVERAL);
    case BAT_COMMAND_DISTRIBUTE_ACROSS:
    case BAT_COMMAND_DISTRIBUTE_DOWN: return unless(f->roots > 2, BAT_STRING_NOTICE_SELECT_THREE);
    case BAT_COMMAND_GROUP: return unless(f->roots > 1 && !f->layers, BAT_STRING_NOTICE_SELECT_SEVERAL);
    case BAT_COMMAND_UNGROUP: return unless(f->groups > 0, BAT_STRING_NOTICE_SELECT_GROUP);
    case BAT_COMMAND_CURVE_CLOSE: return unless(f->open > 0, BAT_STRING_NOTICE_SELECT_OPEN);
    case BAT_COMMAND_CURVE_OPEN: return unless(f->closed > 0, BAT_STRING_NOTICE_SELECT_CLOSED);
    case BAT_COMMAND_REGION_UNITE:
    case BAT_COMMAND_REGION_SUBTRACT:
    case BAT_COMMAND_REGION_INTERSECT:
    case BAT_COMMAND_REGION_EXCLUDE:
        return unless(f->curved > 1 && f->curved == f->others && f->open + f->space == 0,
                      BAT_STRING_NOTICE_SELECT_REGIONS);
    case BAT_COMMAND_COMBINE: return unless(f->curved > 1, BAT_STRING_NOTICE_SELECT_TWO);
    case BAT_COMMAND_RELEASE: return unless(f->compound > 0, BAT_STRING_NOTICE_SELECT_COMPOUND);
    case BAT_COMMAND_CURVE_BLEND:
        return unless(f->open == 1 || f->open == 2 || bat_edge_pair_fits(c, false),
                      BAT_STRING_NOTICE_SELECT_TWO_OPEN);
    case BAT_COMMAND_CURVE_MATCH:
        return unless(f->open == 2 || bat_edge_pair_fits(c, true), BAT_STRING_NOTICE_SELECT_TWO_OPEN);
    case BAT_COMMAND_CURVE_JOIN: return unless(f->open == 2, BAT_STRING_NOTICE_SELECT_TWO_OPEN);
    case BAT_COMMAND_CAMERA_ALONG: return unless(f->roots == 1 && curves == 1, BAT_STRING_NOTICE_SELECT_PATH);
    case BAT_COMMAND_BODY_PATH:
        return unless(f->roots <= 2 && bat_command_body_path_fits(c), BAT_STRING_NOTICE_SELECT_BODY);
    case BAT_COMMAND_DEVIATION:
        return unless(f->roots > 1 && f->measured > 1 && (f->formed > 0 || f->measured == 2),
                      BAT_STRING_NOTICE_DEVIATION_NONE);
    case BAT_COMMAND_CURVE_OFFSET:
    case BAT_COMMAND_CURVE_OUTLINE:
    case BAT_COMMAND_POINTS_EXTREMES:
    case BAT_COMMAND_POINTS_INFLECTIONS: return unless(curves > f->space, BAT_STRING_NOTICE_SELECT_FLAT);
    case BAT_COMMAND_MIRROR_LINE: return unless(f->roots > 1 && f->open > 0, BAT_STRING_NOTICE_SELECT_MIRROR);
    case BAT_COMMAND_TO_PAGE: return unless(f->space > 0, BAT_STRING_NOTICE_SELECT_SPACE);
    case BAT_COMMAND_CURVE_EARLIER:
        return unless(f->others == 1 && bat_tuning_has_earlier(c), BAT_STRING_NOTICE_NO_EARLIER);
    case BAT_COMMAND_CURVE_SIMPLIFY:
    case BAT_COMMAND_CURVE_REVERSE: return unless(curves > 0, BAT_STRING_NOTICE_SELECT_CURVE);
    case BAT_COMMAND_CURVE_SPLIT: return unless(point && curves > 0, BAT_STRING_NOTICE_SPLIT_WHERE);
    default: return why_no_arc(c, f, id);
    }
}

/* Of commands that stand in no row of the selection, too. */
static bat_string why_refused(bat_context *c, const facts *f, bat_command_id id, bool point) {
    if (!bat_command_faces(c, id)) return BAT_STRING_NOTICE_TILTED;
    switch (id) {
    case BAT_COMMAND_UNDO:
        return unless(bat_history_can_undo(&c->session->history), BAT_STRING_NOTICE_NOTHING_TO_UNDO);
    case BAT_COMMAND_REDO:
        return unless(bat_history_can_redo(&c->session->history), BAT_STRING_NOTICE_NOTHING_TO_REDO);
    case BAT_COMMAND_SELECT_SAME_STROKE:
    case BAT_COMMAND_SELECT_SAME_FILL:
    case BAT_COMMAND_SELECT_SAME_STYLE:
    case BAT_COMMAND_SELECT_SAME_WIDTH:
    case BAT_COMMAND_SELECT_SAME_KIND:
    case BAT_COMMAND_SELECT_SAME_NAME:
        return unless(c->choice->selection.count > 0, BAT_STRING_NOTICE_SELECT_FIRST);
    /* With nothing selected they take what was drawn last. */
    case BAT_COMMAND_SURFACE_SWEEP:
    case BAT_COMMAND_SURFACE_RULED:
    case BAT_COMMAND_SURFACE_REVOLVE:
    case BAT_COMMAND_SURFACE_COONS:
    case BAT_COMMAND_SURFACE_CLOSE:
    case BAT_COMMAND_SURFACE_LOFT:
        return bat_surface_command_fits(c, id) ? BAT_STRING_COUNT : why_not(c, f, id, point);
    /* One open curve is joined with itself, for which the row has another button. */
    case BAT_COMMAND_CURVE_JOIN:
        return unless(f->open == 1 || f->open == 2, BAT_STRING_NOTICE_SELECT_TWO_OPEN);
    default: return why_not(c, f, id, point);
    }
}

static bool is_on(const bat_context *c, bat_command_id id) {
    bool on = false;
    return id == BAT_COMMAND_WIRE_FRAMES && bat_bind_turns(c, &on) && on;
}

const char *bat_panel_actions(bat_context *c) {
    bat_text text = {0};
    facts f;
    if (find(c, &f) != BAT_OK) return NULL;
    for (int i = 0;
         i < BAT_COMMAND_COUNT && bat_tool_at(c->choice->tool)->traits & (BAT_CHOOSES | BAT_OFFERS); i++) {
        if (why_not(c, &f, (bat_command_id)i, bat_selecting_of(c)->has_point) != BAT_STRING_COUNT) continue;
        if (text.size) bat_text_string(&text, " ");
        bat_text_string(&text, bat_command_at((bat_command_id)i)->name);
        if (is_on(c, (bat_command_id)i)) bat_text_string(&text, "*");
    }
    return bat_text_keep(&text, &c->panels->actions);
}

const char *bat_panel_refused(bat_context *c) {
    bat_text text = {0};
    facts f;
    if (find(c, &f) != BAT_OK) return NULL;
    for (int i = 0; i < BAT_COMMAND_COUNT; i++) {
        const bat_string why = why_refused(c, &f, (bat_command_id)i, bat_selecting_of(c)->has_point);
        if (why == BAT_STRING_COUNT || why == NOBODY_ASKS) continue;
        bat_text_string(&text, text.size ? ",\"" : "{\"");
        bat_text_string(&text, bat_command_at((bat_command_id)i)->name);
        bat_text_string(&text, "\":");
        bat_text_json_string(&text, bat_word(c, why));
    }
    bat_text_string(&text, text.size ? "}" : "{}");
    return bat_text_keep(&text, &c->panels->refused);
}
