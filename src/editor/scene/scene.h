/*
 * The scene: what is derived from the document and worth keeping between frames: float paths, boxes, finders.
 * One entry an object, in the document's order. An entry lives as long as its object is in the document, so a
 * change costs what it changes, and a pointer compare an object.
 */
#ifndef BATTEN_EDITOR_SCENE_SCENE_H
#define BATTEN_EDITOR_SCENE_SCENE_H

#include "editor/choice/isolation.h"
#include "editor/scene/path.h"
#include "editor/view/stage.h"
#include <batten/nearest.h>

/* What finds a place on a curve. */
typedef struct bat_scene_line {
    bat_finder *finder; /* NULL until asked for */
    bat_curve *picture; /* of a space curve: its x y, which the finder looks at */
} bat_scene_line;

typedef struct bat_scene_entry {
    bat_object *object; /* retained */
    double box[4];      /* of the outline, document units */
    float *path;        /* NULL until made */
    bat_item item;
    bool hidden, locked;   /* itself, or a group it is in; what is not isolated is locked */
    bool pale;             /* it is not isolated */
    bat_scene_line *lines; /* one a curve; NULL until asked for */
} bat_scene_entry;

typedef struct bat_scene {
    bat_scene_entry *entries;
    int count;
    double origin[2];
    bat_item *items; /* the static list: the page's border when there is one, then the objects */
    int item_count;
    double page[4];
    float page_path[13];
    uint32_t versions; /* of items, given so far */
    uint32_t still_version;
    float dirty[4];
    uint64_t revision;              /* of the document that the entries mirror */
    bool outline;                   /* thin lines without fill */
    const bat_isolation *isolation; /* borrowed; NULL: all is within reach */
    uint32_t isolated;              /* its version as shown */
    bool stale;                     /* some path could not be made, or the origin has moved */
} bat_scene;

void bat_scene_init(bat_scene *scene);
void bat_scene_free(bat_scene *scene);
/* How the next sync shows it: in outlines; with all but what is isolated pale. */
void bat_scene_look(bat_scene *scene, bool outline, const bat_isolation *isolation);
/* Mirrors the document. BAT_MEMORY: the scene is as it was, or some paths are missing until the next call. */
bat_status bat_scene_sync(bat_scene *scene, const bat_document *document, uint64_t revision);
/* Moves the origin to the view's middle when floats would show (a quarter of a pixel). */
void bat_scene_rebase(bat_scene *scene, const bat_stage *stage);
/* The finder of a curve of an entry, of a space curve of its picture (x y, at the same parameters); made at first use,
 * NULL when memory is out. */
const bat_finder *bat_scene_finder(bat_scene *scene, int entry, int curve);

#endif
