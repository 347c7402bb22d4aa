/* The tilted view in space: the scene, in the guise that a tool gives it. */
#include "editor/scene/space.h"
#include "base/real.h"
#include "editor/editor.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "form/shade/shader.h"

#include <math.h>

static int guises_of(const bat_context *c, bat_guise guises[BAT_GUISES]) {
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->guises ? tool->is->guises(c, tool->state, guises) : 0;
}

const bat_space *bat_editor_space(bat_editor *editor) {
    const bat_context *c = &editor->context;
    bat_flight_stand(c);
    bat_guise guises[BAT_GUISES];
    const int count = guises_of(c, guises);
    bat_viewpoint through;
    const bool flies = c->moves->through && bat_flight_view(c, &through);
    return bat_space_of(c->scene, c->stage, flies ? &through : NULL,
                        (bat_look)c->settings->values[BAT_PROPERTY_LOOK], count, guises);
}

/* The view of the drawing, in another window, which shows all that this one shows. */
static bool room_view(const bat_context *c, const double size[2], bat_viewpoint *out) {
    if (bat_stage_viewpoint(c->stage, out) != BAT_OK) return false;
    const double more = fmax(1, out->size[0] * size[1] / (out->size[1] * size[0]));
    const double half = 0.5 * out->fov * BAT_PI / 180;
    out->height *= more;
    if (out->fov > 0) out->fov = 2 * bat_atan2(more * bat_sin(half), bat_cos(half)) * 180 / BAT_PI;
    for (int k = 0; k < 2; k++) out->size[k] = size[k];
    return true;
}

const bat_space *bat_editor_lens(bat_editor *editor, const double size[2]) {
    const bat_context *c = &editor->context;
    bat_guise guises[BAT_GUISES];
    bat_viewpoint view;
    bat_moves_sync(&editor->context);
    bat_flight_stand(c);
    const bool room = c->moves->through;
    for (int k = 0; k < 2; k++)
        if (!size || !(size[k] >= 1 && size[k] <= BAT_PIXELS_MAX)) return NULL;
    if (room ? !bat_flight_camera(c) || !room_view(c, size, &view) : !bat_flight_sees(c, size, &view))
        return NULL;
    const int count = guises_of(c, guises);
    return bat_space_lens(c->scene, c->stage, &view, room, (bat_look)c->settings->values[BAT_PROPERTY_LOOK],
                          count, guises);
}

const char *bat_space_constants(void) { return bat_shader_constants(); }
