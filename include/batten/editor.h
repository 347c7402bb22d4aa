/*
 * Batten: the engine. A headless, deterministic editor: no clock, no randomness, no input or output of its own.
 * The host feeds pointer events, keys, commands by name and property values; the engine answers with one frame:
 * what to paint, what to say, what it wants of the host. Every shell (the browser page, the tests, replay) is
 * such a host, and holds no list of commands of its own.
 */
#ifndef BATTEN_EDITOR_H
#define BATTEN_EDITOR_H

#include <batten/document.h>
#include <batten/format.h>
#include <batten/frame.h>
#include <batten/input.h>
#include <batten/panels.h>

#ifdef __cplusplus
extern "C" {
#endif

/* With an empty document. */
BAT_API bat_status bat_editor_create(bat_editor **out);
BAT_API void bat_editor_free(bat_editor *editor); /* NULL is fine; frees the document, too */
BAT_API const bat_document *bat_editor_document(const bat_editor *editor);
/* A document opened anew: history emptied, view fitted, journal begun with a snapshot. Takes the document over;
 * on failure the editor is as it was. A stroke under way is cancelled. */
BAT_API bat_status bat_editor_open(bat_editor *editor, bat_document *document, const char *name);

/* ---- commands, properties, the host ---- */

/* Commands and properties by name, as the table (commands.def) lists them. BAT_UNSUPPORTED: no such name.
 * BAT_STATE: not now (nothing to undo). */
BAT_API bat_status bat_editor_command(bat_editor *editor, const char *name);
BAT_API bat_status bat_editor_set(bat_editor *editor, const char *property, double value);
BAT_API bat_status bat_editor_get(const bat_editor *editor, const char *property, double *value);
/* Numbers as text, in the unit in force: of what is chosen (the table's numbers), or a property. What is entered may
 * be an expression ("1in + 3mm"); a number of what is chosen is a step of the history. BAT_SYNTAX: no such expression;
 * BAT_STATE: there is nothing it could change now, or a drag is under way; else as bat_editor_set. */
BAT_API bat_status bat_editor_enter(bat_editor *editor, const char *name, const char *text);
/* The number as it is now ("12.5 mm"), "" when there is none; valid until the next call. A property in view pixels is
 * told as the length that it has in the drawing. */
BAT_API const char *bat_editor_number(bat_editor *editor, const char *name);
/* What a pen's pressure (0..1) counts as with the properties as they are: the share of a brush's reach, 0.25..1; it
 * never falls as the pressure rises. 1 when pressure is switched off. */
BAT_API double bat_editor_pressure(const bat_editor *editor, double pressure);
/* The shortcuts of a command, for this editor: keys as the tables write them ("Ctrl+Shift+Z Ctrl+Y"), "" for none,
 * NULL for the default. BAT_UNSUPPORTED: no such command; BAT_ARGUMENT: too long or not well-formed. */
BAT_API bat_status bat_editor_bind(bat_editor *editor, const char *command, const char *keys);
/*
 * The tables as JSON, for menus, panels, the shortcut sheet and the manual, with the present shortcuts:
 * {"commands":[{"name","label","help","keys":[...],"section":key of its word,"hold"}], "properties":[{"name","label","help","type",
 *  "default","low","high","step","unit","choices":[keys of their words, of type choice only]}],
 *  "tools":[{"name","label","help","command","keys":[...]}], "numbers":[names], "strings":{key:text}}. The browser's
 *  module has no helps.
 * Owned by the editor, valid until the next call of it; NULL when out of memory.
 */
BAT_API const char *bat_editor_tables(bat_editor *editor);
/* The words of another language: UTF-8 JSON {key:text}, as the build makes them of the table (words.ko.json). A text
 * that is not there stays English; so does one with more or fewer "%" (places of values) than the English. NULL, 0:
 * English. The words are copied. BAT_SYNTAX, BAT_MEMORY: nothing changed. Never part of document or journal. */
BAT_API bat_status bat_editor_words(bat_editor *editor, const char *text, size_t size);
/* The host has saved the document as it was when it took the frame that asked for it (or, when none did, as it
 * is now): that state is clean from now on. */
BAT_API void bat_editor_saved(bat_editor *editor);
/* What the file that was opened holds and the document does not (bat_svg_report), so that writing over the file would
 * lose it: the host says so after opening, and NULL (nothing) once it has written over the file. Before it does so it
 * asks the user. Kept with the session, and in the journal. */
BAT_API bat_status bat_editor_set_losses(bat_editor *editor, const bat_losses *losses);
BAT_API const bat_losses *bat_editor_losses(const bat_editor *editor); /* never NULL */
/* The document can be looked at and exported, not changed and not saved: a pointer moves the view, and what would
 * change something says why not. Drops what is under way. A host that does not own the document asks for it;
 * opening and replay are the host's own and go on. */
BAT_API void bat_editor_set_read_only(bat_editor *editor, bool read_only);

/* ---- pictures and the clipboard ---- */

/* Places the bytes of a PNG, JPEG or WebP file behind the drawing, in the middle of the view and within it, half
 * transparent and selected: a step of the history. name: may be NULL. When it is refused, a notice says why. */
BAT_API bat_status bat_editor_add_picture(bat_editor *editor, const void *bytes, size_t size,
                                          const char *name);
/* The picture that an item of role IMAGE shows; NULL: there is none of that number. */
BAT_API const bat_picture *bat_editor_picture(const bat_editor *editor, uint32_t picture);

/* The selection as an SVG file with every knot (bat_free), for the clipboard; cut: it is deleted, a step of the
 * history. BAT_STATE: nothing is selected. A notice tells what was done, or why not. */
BAT_API bat_status bat_editor_copy(bat_editor *editor, bool cut, char **text, size_t *size);
/* Puts all that a document holds into the active layer, selected: a step of the history. own: copied by
 * bat_editor_copy (the reader's report says `native`): 10 px off the place it had, 20 when pasted again, or in the
 * middle of the view when it would not be seen; else at the pointer, or in the middle. In place with Shift, or when
 * asked by "paste-in-place". Layers are dropped, what is in them is not. BAT_STATE: there is nothing in it. */
BAT_API bat_status bat_editor_paste(bat_editor *editor, const bat_document *document, bool own);

/* ---- journal ---- */

/* The journal so far: JSON lines (docs/journal.md). A snapshot of the document, then every committed command. */
BAT_API const char *bat_editor_journal(const bat_editor *editor, size_t *size);
/* Makes the journal short, where a long session has made it long: the document as it was 250 steps ago, then these
 * steps as changes. Replayed, it gives the same document with that much to undo. BAT_STATE: a stroke or a drag is
 * under way. On failure the journal stays as it was. Cost: that of writing the document and these steps. */
BAT_API bat_status bat_editor_compact(bat_editor *editor);
/* Runs a journal from its first line (a snapshot, or an empty document). check: compare the digests noted in it
 * and the document's invariants after every entry. */
BAT_API bat_status bat_editor_replay(bat_editor *editor, const char *text, size_t size, bool check,
                                     bat_problem *problem);
/* The editor's own invariants, over the document's: NULL when all hold. */
BAT_API const char *bat_editor_check(const bat_editor *editor);

#ifdef __cplusplus
}
#endif
#endif
