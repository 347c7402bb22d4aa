/* The tilted view in space: the scene, in the guise that a tool gives it. */
#include "editor/scene/space.h"
#include "editor/editor.h"
#include "editor/show/flight.h"
#include "form/shade/shader.h"

const bat_space *bat_editor_space(bat_editor *editor) {
    const bat_context *c = &editor->context;
    const bat_slot *tool = bat_toolbox_tool(c);
    bat_guise guises[BAT_GUISES];
    const int count = tool->is->guises ? tool->is->guises(c, tool->state, guises) : 0;
    bat_viewpoint through;
    const bool flies = c->moves->through && bat_flight_view(c, &through);
    return bat_space_of(c->scene, c->stage, flies ? &through : NULL,
                        (bat_look)c->settings->values[BAT_PROPERTY_LOOK], count, guises);
}

const char *bat_space_constants(void) { return bat_shader_constants(); }
