/* Which commands the selection makes possible: the contents of a row of buttons. */
#include "document/document.h"
#include "editor/commands/blend_edges.h"
#include "editor/edit/arrange.h"
#include "editor/edit/binding.h"
#include "editor/choice/choice.h"
#include "editor/commands/body.h"
#include "editor/commands/surfaces.h"
#include "editor/commands/tuning.h"
#include "editor/commands/wires.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
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

static bool possible_surface(bat_context *c, const facts *f, bat_command_id id) {
    switch (id) {
    case BAT_COMMAND_SURFACE_SWEEP:
    case BAT_COMMAND_SURFACE_RULED:
    case BAT_COMMAND_SURFACE_REVOLVE:
    case BAT_COMMAND_SURFACE_COONS:
    case BAT_COMMAND_SURFACE_CLOSE:
    case BAT_COMMAND_SURFACE_LOFT: return f->roots > 1 && bat_surface_command_fits(c, id);
    case BAT_COMMAND_SURFACE_FREE:
        return bat_document_has_followers(c->session->document) && bat_surface_command_fits(c, id);
    case BAT_COMMAND_SURFACE_CAP:
    case BAT_COMMAND_SURFACE_FLIP: return f->open + f->closed == 0 && bat_surface_command_fits(c, id);
    case BAT_COMMAND_SURFACE_MEET:
    case BAT_COMMAND_WIRE_MEET:
        return f->roots == 2 && f->open + f->closed == 0 && bat_wire_command_fits(c, id);
    case BAT_COMMAND_WIRE_BIND: return f->roots > 1 && bat_wire_command_fits(c, id);
    case BAT_COMMAND_WIRE_DOMAIN:
    case BAT_COMMAND_WIRE_FRAMES:
    case BAT_COMMAND_WIRE_BAKE:
    case BAT_COMMAND_WIRE_REVERT:
        return bat_document_has_followers(c->session->document) && bat_wire_command_fits(c, id);
    default: return false;
    }
}

static bool possible(bat_context *c, const facts *f, bat_command_id id, bool point) {
    switch (id) {
    case BAT_COMMAND_DELETE:
    case BAT_COMMAND_DUPLICATE:
    case BAT_COMMAND_ARRAY:
    case BAT_COMMAND_ORDER_FRONT:
    case BAT_COMMAND_ORDER_FORWARD:
    case BAT_COMMAND_ORDER_BACKWARD:
    case BAT_COMMAND_MIRROR_ACROSS:
    case BAT_COMMAND_MIRROR_DOWN:
    case BAT_COMMAND_ORDER_BACK: return f->roots > 0;
    case BAT_COMMAND_ALIGN_LEFT:
    case BAT_COMMAND_ALIGN_CENTRE:
    case BAT_COMMAND_ALIGN_RIGHT:
    case BAT_COMMAND_ALIGN_TOP:
    case BAT_COMMAND_ALIGN_MIDDLE:
    case BAT_COMMAND_ALIGN_BOTTOM: return f->roots > 1 || (f->roots == 1 && f->page);
    case BAT_COMMAND_DISTRIBUTE_ACROSS:
    case BAT_COMMAND_DISTRIBUTE_DOWN: return f->roots > 2;
    case BAT_COMMAND_GROUP: return f->roots > 1 && !f->layers;
    case BAT_COMMAND_UNGROUP: return f->groups > 0;
    case BAT_COMMAND_CURVE_CLOSE: return f->open > 0;
    case BAT_COMMAND_CURVE_OPEN: return f->closed > 0;
    case BAT_COMMAND_REGION_UNITE:
    case BAT_COMMAND_REGION_SUBTRACT:
    case BAT_COMMAND_REGION_INTERSECT:
    case BAT_COMMAND_REGION_EXCLUDE:
        return f->curved > 1 && f->curved == f->others && f->open + f->space == 0;
    case BAT_COMMAND_COMBINE: return f->curved > 1;
    case BAT_COMMAND_RELEASE: return f->compound > 0;
    case BAT_COMMAND_ARC_PIE: return f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_PIE);
    case BAT_COMMAND_ARC_CHORD: return f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_CHORD);
    case BAT_COMMAND_ARC_OPEN: return f->roots > 0 && bat_primitives_are_arcs(c, BAT_ARC_OPEN);
    case BAT_COMMAND_CURVE_BLEND: return f->open == 1 || f->open == 2 || bat_edge_pair_fits(c, false);
    case BAT_COMMAND_CURVE_MATCH: return f->open == 2 || bat_edge_pair_fits(c, true);
    case BAT_COMMAND_CURVE_JOIN: return f->open == 2;
    case BAT_COMMAND_CAMERA_ALONG: return f->roots == 1 && f->open + f->closed == 1;
    case BAT_COMMAND_BODY_PATH: return f->roots <= 2 && bat_command_body_path_fits(c);
    case BAT_COMMAND_DEVIATION: return f->roots > 1 && f->measured > 1 && (f->formed > 0 || f->measured == 2);
    case BAT_COMMAND_CURVE_OFFSET:
    case BAT_COMMAND_CURVE_OUTLINE: return f->open + f->closed > f->space;
    case BAT_COMMAND_MIRROR_LINE: return f->roots > 1 && f->open > 0;
    case BAT_COMMAND_TO_PAGE: return f->space > 0;
    case BAT_COMMAND_CURVE_EARLIER: return f->others == 1 && bat_tuning_has_earlier(c);
    case BAT_COMMAND_POINTS_EXTREMES:
    case BAT_COMMAND_POINTS_INFLECTIONS: return f->open + f->closed > f->space;
    case BAT_COMMAND_CURVE_SIMPLIFY:
    case BAT_COMMAND_CURVE_REVERSE: return f->open + f->closed > 0;
    case BAT_COMMAND_CURVE_SPLIT: return point && f->open + f->closed > 0;
    default: return possible_surface(c, f, id);
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
        if (!possible(c, &f, (bat_command_id)i, bat_selecting_of(c)->has_point)) continue;
        if (text.size) bat_text_string(&text, " ");
        bat_text_string(&text, bat_command_at((bat_command_id)i)->name);
        if (is_on(c, (bat_command_id)i)) bat_text_string(&text, "*");
    }
    return bat_text_keep(&text, &c->panels->actions);
}
