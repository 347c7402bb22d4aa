/*
 * The scene: what is derived from the document and worth keeping between frames: float paths, boxes, finders. One
 * entry per object, in document order. An entry lives as long as its object is in the document, so an update costs
 * what has changed, plus one pointer comparison per object.
 */
#ifndef BATTEN_EDITOR_SCENE_SCENE_H
#define BATTEN_EDITOR_SCENE_SCENE_H

#include "editor/choice/isolation.h"
#include "editor/scene/clips.h"
#include "editor/scene/marks.h"
#include "editor/scene/path.h"
#include "editor/scene/wide.h"
#include "editor/view/stage.h"
#include <batten/nearest.h>

/* Finds the nearest point of a curve. */
typedef struct bat_scene_line {
    bat_finder *finder; /* NULL until requested */
    bat_curve
        *picture; /* the curve as it is seen, which the finder searches; NULL: a planar curve seen face-on */
} bat_scene_line;

typedef struct bat_scene_entry {
    bat_object *object;   /* retained */
    bat_object *posed;    /* as it stands at the scene's time; NULL: as it is */
    double posed_at;      /* the time */
    bool moved;           /* it stands elsewhere than its path, box and lines say */
    double box[4];        /* of the outline, drawing coordinates (editor/view/stage.h) */
    float *path;          /* NULL until made */
    float *paint;         /* made with the path; NULL: none */
    bat_scene_wide *wide; /* made with the path; NULL: the stroke is as wide everywhere, or seen from aside */
    bat_scene_marks *marks;    /* made with the path; NULL: none, or seen from aside */
    bat_scene_region *regions; /* of its clip; NULL until requested */
    bat_item item;
    bool hidden, locked;   /* the object or a group that contains it; what is not isolated counts as locked */
    bool pale;             /* not isolated */
    float around;          /* bat_nesting_level */
    bat_scene_line *lines; /* one per curve; NULL until requested */
    struct bat_solid *solid; /* scene/solid.h: its buffers in space; NULL until requested */
} bat_scene_entry;

typedef struct bat_scene {
    bat_scene_entry *entries;
    int count;
    double origin[2];
    bool tilted, behind;         /* the view is tilted; so far that the page's back is seen */
    double map[BAT_MAP_NUMBERS]; /* tilted: bat_stage_space_map */
    double tolerance;            /* of curves in perspective, drawing coordinates; 0: parallel */
    bat_item *items;             /* the static list: the page's border if there is a page, then the objects */
    int item_count;
    double page[4];
    float page_path[16];
    uint32_t versions; /* numbers given out so far to versions of items */
    uint32_t still_version;
    float dirty[4];
    uint64_t revision;              /* of the document that the entries mirror */
    bool outline;                   /* outline mode: thin lines without fill */
    const bat_isolation *isolation; /* borrowed; NULL: everything is within reach */
    uint32_t isolated;              /* the isolation's version as shown */
    double time;                    /* seconds, at which what moves by itself stands */
    bool bodies;                    /* something moves by itself */
    bat_id ghost;                   /* is shown by something else as it is now, and painted pale; 0: none */
    bool surfaces;                  /* some are shown */
    bool stale;                     /* some path could not be made, or the origin has moved */
    struct bat_space_kept *space;   /* scene/space.h; NULL until requested */
    struct bat_space_kept *lens;    /* a second picture of the same buffers */
} bat_scene;

void bat_scene_init(bat_scene *scene);
void bat_scene_free(bat_scene *scene);
/* Sets how the next sync shows the document: in outline mode; with everything not isolated pale. */
void bat_scene_look(bat_scene *scene, bool outline, const bat_isolation *isolation);
/* The object that something else shows as it is now, such as a skeleton at the playhead: face-on it is painted pale. 0: none. */
void bat_scene_ghost(bat_scene *scene, bat_id id);
/* What moves by itself, as skeletons do, stands as it does at that time, in seconds; face-on the ghost as in its first frame. */
void bat_scene_stand(bat_scene *scene, double time);
/* An entry's object as it stands at that time, which is made when it is not there; NULL: out of memory. */
const bat_object *bat_scene_standing(bat_scene *scene, bat_scene_entry *entry);
/* The object of that index as the drawing shows it. */
const bat_object *bat_scene_shown(const bat_scene *scene, int index);
/* A surface without a stroke: thin lines show it face-on. */
bool bat_scene_is_bare(const bat_object *object);
/* The item of an entry as it is painted: in outline mode, or pale; but for the ghost's. */
bat_item bat_scene_painted(const bat_scene *scene, const bat_scene_entry *entry);
/* Mirrors the document. BAT_MEMORY: the scene is unchanged, or lacks some paths until the next call. */
bat_status bat_scene_sync(bat_scene *scene, const bat_document *document, uint64_t revision);
/* Sees the drawing as the stage does: when it has turned, paths, boxes and finders are made anew. */
void bat_scene_face(bat_scene *scene, const bat_stage *stage);
/* Moves the origin to the view's middle when float rounding would become visible (a quarter of a pixel). */
void bat_scene_rebase(bat_scene *scene, const bat_stage *stage);
/* The curve of an entry as it is seen: in the plane, in drawing coordinates, at the same parameters. NULL when out of
 * memory or too far away. */
const bat_curve *bat_scene_seen(bat_scene *scene, int entry, int curve);
/* The finder of a curve of an entry as it is seen (drawing coordinates, at the same parameters). Made on
 * first use; NULL when out of memory. */
const bat_finder *bat_scene_finder(bat_scene *scene, int entry, int curve);

#endif
