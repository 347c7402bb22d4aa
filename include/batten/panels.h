/* Batten: what panels show and change: layers and objects by their ids, readings of the last stroke, levels. */
#ifndef BATTEN_PANELS_H
#define BATTEN_PANELS_H

#include <batten/document.h>
#include <batten/input.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- layers and objects by id ---- */

/* The layers, back to front, as JSON: {"layers":[{"id","name","hidden","locked","depth","members"}], "active":id,
 * "loose": objects in no layer, "pictures": images, "aids":[{"id","name","kind" in words,"hidden","locked"}]: planes, saved
 * views and cameras, which have names and are in no picture}. Owned by the editor, valid until the next call of it; NULL: out of
 * memory. */
BAT_API const char *bat_editor_layers(bat_editor *editor);
/* The names of the commands that arrange or mend what is selected, as far as this selection makes them possible,
 * separated by spaces, with a star behind the name of a switch that is on. Empty unless the select tool is in force, which shows what is selected. Owned by the
 * editor, valid until the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_actions(bat_editor *editor);
/* The commands that cannot be done now, as far as that is known without trying, and why, in words, as JSON: {"group":"Select two
 * objects or more",...}. Owned by the editor, valid until the next call of it; NULL: out of memory. O(selected). */
BAT_API const char *bat_editor_refused(bat_editor *editor);
/* The names of the properties of the style in which the selected objects differ, separated by spaces; "" when they agree, or
 * nothing is selected. Owned by the editor, valid until the next call of it; NULL: out of memory. O(selected). */
BAT_API const char *bat_editor_mixed(bat_editor *editor);
/* The colours that strokes and fills of the drawing have, at most 64, the most frequent first, as numbers 0xRRGGBBAA separated by
 * spaces. Owned by the editor, valid until the next call of it; NULL: out of memory. O(objects log objects). */
BAT_API const char *bat_editor_colours(bat_editor *editor);
/* The steps that can be undone and redone, oldest first, as JSON: {"done": how many of them are done,"steps":[what each did,
 * in words]}. Owned by the editor, valid until the next call of it; NULL: out of memory. O(steps). */
BAT_API const char *bat_editor_history(bat_editor *editor);
/* Undoes or redoes steps until `done` of them are done. BAT_ARGUMENT: there are not so many; BAT_STATE: a drag is under way, or
 * the document is read-only. */
BAT_API bat_status bat_editor_go(bat_editor *editor, int done);
/* Moves an object to the place of another one: in front of it when it comes from behind, otherwise behind it; from
 * another group, in front of it and into its group. This is a step of the history. BAT_ARGUMENT: the other is in it, or
 * one of the two is a layer and they have different parents. */
BAT_API bat_status bat_editor_place_layer(bat_editor *editor, bat_id id, bat_id target);
/* The layer that new curves go into; 0: none. */
BAT_API bat_status bat_editor_activate_layer(bat_editor *editor, bat_id id);
/* For any object; each call is a step of the history. BAT_STATE: a drag is under way. */
BAT_API bat_status bat_editor_rename(bat_editor *editor, bat_id id, const char *name);
BAT_API bat_status bat_editor_set_state(bat_editor *editor, bat_id id, bool hidden, bool locked);
/* The drawing for those who do not see it, in words. Owned by the editor, valid until the next call of either; NULL:
 * out of memory.
 * outline: objects first, first + 1 ... of the document, back to front, at most `count` and 500, as JSON {"total":
 * objects in all, "at": index of the first selected one or -1, "rows":[{"id","state" (bits: 1 holds others, 2 hidden, 4
 * locked),"name","level" (1: in no group),"points","selected","words"}]}.
 * outline_points: {"at": the chosen point or -1, "points":[words]}, at most 1,000: a spline's points, else the control
 * points of all its curves. */
BAT_API const char *bat_editor_outline(bat_editor *editor, int first, int count);
/* The objects that do not look as they do in the file that the drawing keeps, back to front, at most 500 of "total", as JSON:
 * {"rows":[{"id","words": its name,"lost":[bat_loss_key, ...]}],"total"}. Saving keeps it all the same. Owned by the editor, valid
 * until the next call of it or of the outline; NULL: out of memory. */
BAT_API const char *bat_editor_unshown(bat_editor *editor);
/* What the drawing holds, as JSON: {"kinds":[{"words": the kind's name,"count"}], in the order in which they first occur,
 * "page":[width, height]}, in words with the unit, each "" without a page. O(objects). Owned by the editor, valid until the
 * next call of it or of the outline; NULL: out of memory. */
BAT_API const char *bat_editor_holds(bat_editor *editor);
BAT_API const char *bat_editor_outline_points(bat_editor *editor, bat_id id);
/* Selects the object and chooses a point of it, numbered as outline_points has them, with the tool that moves it.
 * BAT_ARGUMENT: no such point. BAT_STATE: a drag is under way, or it is hidden or locked. */
BAT_API bat_status bat_editor_choose(bat_editor *editor, bat_id id, int point);
/* What has happened since the last call, to be spoken: tool, step, selection, the place of what the keys move; ""
 * when nothing has happened, or a drag is under way. What notices say is left out. Owned by the editor, valid
 * until the next call of it. */
BAT_API const char *bat_editor_said(bat_editor *editor);
/* Selects an object (0: none), alone or (add) in addition to what is selected. */
BAT_API bat_status bat_editor_select(bat_editor *editor, bat_id id, bool add);

/* ---- the last stroke, read as something else ---- */

/* What the last stroke could mean, while it is the last thing done and no other has begun, as JSON: {"at":[x,y],
 * its end in view pixels, "chosen": which it was taken for, "amount": how it is fitted (below; -1: it is settled),
 * "words":["New line","Redraw roof", ...]}; no words: there is nothing else that it could mean. After
 * command "curve-simplify", as long as that is the last thing done: the place of the selection, how the spans of the
 * result can meet (C2, G1), "points":[before,after], "cubics":[before,after], "of":"simplify" and "said", what it came to in words.
 * After "curve-earlier": "of":"earlier", "step", the share of the slider that a shape takes, "said", what made the one that is shown,
 * "around", the box of all shapes in view pixels, x0, y0, x1, y1, "words", what keeps it, "chosen" -1. After "curve-offset": "of":"offset", "step", "typed", the property that the amount stands for,
 * "said", why nothing would be left, "words", the sides and what keeps it; "ways", how many of them are sides. When one object is selected that an earlier stroke changed, and that stretch of it is as the
 * stroke left it: the stroke's end and amount, no words. Owned by the editor, valid until the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_readings(bat_editor *editor);
/* Takes the stroke in that meaning, or simplifies with those joints: the step of the history is replaced. BAT_STATE: that
 * reading no longer exists. */
BAT_API bat_status bat_editor_read_as(bat_editor *editor, int reading);
/* Refits the stroke, from raw (0: a quarter of the tolerance) through the fit as it was made at first (1/2) to
 * fair (1: four times the tolerance). The result is only shown until `done` is true; then the stroke's step of the
 * history is replaced. An earlier stroke that the selection offers is refitted in a step of its own, which is replaced
 * as long as it is the last. After "curve-simplify" the same for the selection, from a sixteenth of the tolerance to sixteen
 * times it; command "cancel" gives the objects back as they were. After "curve-earlier": which of the curve's shapes is shown, from
 * the first (0) to what it is now (1); the drawing stays as it is until command "accept" or the first reading keeps that shape, as a
 * step of its own. BAT_STATE: it is settled. */
BAT_API bat_status bat_editor_refit(bat_editor *editor, double amount, bool done);
/* The same with the second slider, where the readings have "other", its amount: after "curve-blend", how far the blend keeps
 * the direction of its second end. BAT_STATE: there is none. */
BAT_API bat_status bat_editor_refit_other(bat_editor *editor, double amount, bool done);

/* ---- the camera move that is looked at, for the time strip ---- */

/* Of the camera that is selected, else of the one before, else of the first in the drawing, as JSON: {"id" (0: there is no
 * camera),"name","cameras": in the drawing,"at": seconds of the playhead,"duration","length": of its path,"rate": frames a
 * second,"playing","through": the drawing is seen through it,"loop","lens": what it sees is shown beside the drawing; the last four are 0 or 1. "gaze":[{"gain","muted","solo","active"}],
 * its levels, the base first; "path": the same of the curve that it follows, empty when that has no levels; "graph": the share
 * of the distance at 97 even times; empty for a path without length}. "sees": 1 for a camera; 0 for a skeleton, whose motion is looked
 * at likewise: "gaze" are the levels of its chosen joint, "path" those of its root's path, "joints":[{"id","name"}] those that turn,
 * "joint": the chosen one, -1: none; then "angles":["X", ...] of it, "angle": which the graph shows, "degrees": that at the playhead,
 * "range":[low, high] in degrees, of which the graph has shares. Owned by the editor, valid
 * until the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_move(bat_editor *editor);
/* Moves the playhead, which stays within the move; what plays stops. Nothing enters the history or the journal, here and
 * below. BAT_NUMBER: seconds are not finite; BAT_STATE: there is no camera. */
BAT_API bat_status bat_editor_seek(bat_editor *editor, double seconds);
/* While a move plays (command "move-play", or a tap of the space bar) the host says what time it is, in milliseconds, before
 * each frame; the first call only begins. A change of the drawing stops it. */
BAT_API void bat_editor_play(bat_editor *editor, double time);

typedef enum bat_move_act {
    BAT_MOVE_GAIN,     /* of a level, to value */
    BAT_MOVE_MUTE,     /* value 0: it sounds, else silent */
    BAT_MOVE_SOLO,     /* the levels above are silent and the others not; again: all sound */
    BAT_MOVE_DURATION, /* value: seconds */
    BAT_MOVE_EASE_IN,  /* value: seconds within which it begins gently */
    BAT_MOVE_EASE_OUT, /* and ends gently */
    BAT_MOVE_EASE,     /* both */
    BAT_MOVE_CHOOSE,   /* makes the level the active one, which drags change: no edit, as the next two */
    BAT_MOVE_JOINT,    /* of a skeleton: chooses the joint with the number `level` */
    BAT_MOVE_ANGLE     /* and that one of its angles: the graph shows it, and a stroke redraws it */
} bat_move_act;
/* Edits the camera (path: the levels of the curve that it follows instead), or the levels of a skeleton's joint or path. Shown at once, from what the camera was before the first
 * of them; one step of the history when `done` comes, command "cancel" takes it back. What plays stops. BAT_STATE: there
 * is no camera, or something else is under way; BAT_ARGUMENT: no such level; else as camera.h says. */
BAT_API bat_status bat_editor_move_set(bat_editor *editor, bat_move_act act, bool path, int level,
                                       double value, bool done);
/* Redraws a stretch of the graph by a stroke, as bat_camera_retime; of a skeleton as bat_motion_redraw, at the active level, in shares
 * of the graph's range; as bat_editor_move_set. */
BAT_API bat_status bat_editor_retime(bat_editor *editor, size_t count, const double *points, bool done);

typedef enum bat_correction {
    BAT_CORRECT_TURN, /* what is seen at `from` goes to `to` */
    BAT_CORRECT_ROLL, /* by the angle between them about the middle of the picture */
    BAT_CORRECT_ORBIT, /* about the target, or else about what is seen at `from`: half a turn for the picture's height */
    BAT_CORRECT_PAN, /* sideways, so that what is seen at `from` goes with the pen; the gaze keeps to its rule */
    BAT_CORRECT_DOLLY /* towards what is seen at `from`: twice as near for 200 pixels upwards */
} bat_correction;
/*
 * Corrects the move in a picture of that size in pixels that its camera sees: at the playhead the path, or the gaze, or both are
 * changed at their active levels. Shown at once, from what was there before the first of these calls; one step of the history
 * when `done` comes, command "cancel" takes it back. What plays stops. BAT_STATE: there is no camera, something else is under way, or
 * the path is locked or hidden; BAT_ARGUMENT: the level is silent, or the size is not above 0; BAT_UNSUPPORTED: a camera that looks
 * at something is turned at level 0; BAT_NUMBER.
 */
BAT_API bat_status bat_editor_correct(bat_editor *editor, bat_correction kind, const double size[2],
                                      const double from[2], const double to[2], bool done);

/* ---- levels of the chosen curve, for the level strip ---- */

/* As JSON: {"rows":[{"points","gain","muted","solo","active"}], one a level, the base first; "points": of the
 * curve; "apart": the rows are what taking apart would give; "copying": a tap chooses who gets the detail}. In the
 * tool for widths the levels of the width along the chosen curve, with "of":"width"; "points": stops; gains tell from where the faders
 * began, and are 1 again when something else has changed the width. The three words, muted, solo and active are 0 or 1. Where there
 * are rows, "pictures" has one for each: SVG path data in a box of 32 by 20, the base in its shape (of a width: how wide), a detail as a
 * wave along the curve, times its gain. Owned by the editor, valid until the next call of it; NULL: out
 * of memory. */
BAT_API const char *bat_editor_levels(bat_editor *editor);

typedef enum bat_level_act {
    BAT_LEVEL_CHOOSE, /* makes it the active one */
    BAT_LEVEL_GAIN,   /* to value; shown at once, one step of the history when `done` comes, command "cancel"
                       * takes it back */
    BAT_LEVEL_MUTE,   /* value 0: sounds, else silent */
    BAT_LEVEL_SOLO    /* the levels above are silent and the others not; again: all sound */
} bat_level_act;
/* BAT_STATE: no levels, or something else is under way; BAT_ARGUMENT: no such level. */
BAT_API bat_status bat_editor_level(bat_editor *editor, bat_level_act act, int level, double value,
                                    bool done);

#ifdef __cplusplus
}
#endif
#endif
