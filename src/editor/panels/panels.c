#include "editor/panels/panels.h"
#include <stdlib.h>

void bat_panels_free(bat_panels *panels) {
    free(panels->actions);
    free(panels->refused);
    free(panels->writing);
    free(panels->layers);
    free(panels->outline);
    free(panels->readings);
    free(panels->tables);
    free(panels->move);
    free(panels->mixed);
    free(panels->colours);
    free(panels->view);
    free(panels->history);
}
