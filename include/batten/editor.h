/*
 * Batten: the engine. A headless, deterministic editor: no clock, no randomness, no input or output of its own. The
 * host feeds pointer events, keys, commands by name and property values; the engine answers with one frame: what to
 * paint, what to say, and what it asks of the host. Every shell (the browser page, the tests, replay) is such a host,
 * and holds no list of commands of its own.
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
/* Opens a document: the history is emptied, the view fitted, and a new journal begun with a snapshot. Takes
 * ownership of the document; on failure the editor is as it was. A stroke under way is cancelled. */
BAT_API bat_status bat_editor_open(bat_editor *editor, bat_document *document, const char *name);

/* ---- commands, properties, the host ---- */

/* Commands and properties by name, as the table (commands.def) lists them. BAT_UNSUPPORTED: no such name.
 * BAT_STATE: not possible now (nothing to undo, for example). */
BAT_API bat_status bat_editor_command(bat_editor *editor, const char *name);
BAT_API bat_status bat_editor_set(bat_editor *editor, const char *property, double value);
BAT_API bat_status bat_editor_get(const bat_editor *editor, const char *property, double *value);
/* Enters a number as text, in the unit in force: one of the table's numbers, of what is chosen, a property, or "page-keep",
 * "page-scale" ("210mm × 297mm": what is drawn keeps its size, or is scaled) and "page-unit" ("mm"). It may be an expression
 * ("1in + 3mm"); what is no property makes a step. BAT_SYNTAX: not a valid text; BAT_STATE: there is nothing that it could
 * change now, or a drag is under way; otherwise as bat_editor_set. */
BAT_API bat_status bat_editor_enter(bat_editor *editor, const char *name, const char *text);
/* Why the last of these calls (but bat_editor_get), or of bat_editor_bind, was refused: place names the command, the property or the
 * argument, message what was expected and found. Empty texts: it was not. Owned by the editor, overwritten by the next one. */
BAT_API const bat_problem *bat_editor_problem(const bat_editor *editor);
/* The number as it is now ("12.5 mm"), "" when there is none; valid until the next call. A property in view pixels is given as
 * a length in the drawing. Also "page-width", "page-height", "page-unit"; "page-asks W × H": "yes" if those two would differ;
 * "points": how many control points are chosen together. */
BAT_API const char *bat_editor_number(bat_editor *editor, const char *name);
/* What a pen's pressure (0..1) amounts to under the present properties: the share of a brush's reach, 0.25..1; it
 * never falls as the pressure rises. 1 when pressure is switched off. */
BAT_API double bat_editor_pressure(const bat_editor *editor, double pressure);
/* The shortcuts of a command, for this editor: keys as the tables write them ("Ctrl+Shift+Z Ctrl+Y"), "" for none,
 * NULL for the default. BAT_UNSUPPORTED: no such command; BAT_ARGUMENT: too long or not well-formed. */
BAT_API bat_status bat_editor_bind(bat_editor *editor, const char *command, const char *keys);
/*
 * The tables as JSON, for menus, panels, the shortcut sheet and the manual, with the present shortcuts:
 * {"commands":[{"name","label","help","keys":[...],"section":key of its word,"hold"}],
 *  "properties":[{"name","label","help","type","default","low","high","step","unit",
 *                 "choices":[keys of their words, of type choice only]}],
 *  "tools":[{"name","label","help","command","keys":[...]}], "numbers":[names], "strings":{key:text}}.
 * The browser's module leaves out "help". Owned by the editor, valid until the next call of it; NULL when out of
 * memory.
 */
BAT_API const char *bat_editor_tables(bat_editor *editor);
/* The words of another language: UTF-8 JSON {key:text}, as the build makes them from the table (words.ko.json). A
 * text that is missing stays English; so does one with more or fewer "%" (placeholders for values) than the
 * English text. NULL, 0: English. The words are copied. BAT_SYNTAX, BAT_MEMORY: nothing has changed. The language
 * is never part of a document or journal. problem (may be NULL) says where the text is no JSON. */
BAT_API bat_status bat_editor_words(bat_editor *editor, const char *text, size_t size, bat_problem *problem);
/* The host has saved the document as it was when it took the frame that asked for it (or, when none did, as it is
 * now): that state counts as saved from now on. */
BAT_API void bat_editor_saved(bat_editor *editor);
/* What the file that was opened holds and the document does not (bat_svg_report), so that writing over the file
 * would lose it: the host passes it after opening a file, and NULL (nothing) once it has overwritten the file.
 * Before overwriting, the host asks the user. Kept with the session, and in the journal. */
BAT_API bat_status bat_editor_set_losses(bat_editor *editor, const bat_losses *losses);
BAT_API const bat_losses *bat_editor_losses(const bat_editor *editor); /* never NULL */
/* Read-only: the document can be looked at and exported, but not changed or saved; a pointer moves the view, and
 * an action that would change something tells the user why it cannot. Drops what is under way. It is for a host
 * that does not own the document; opening and replay are the host's own actions and still work. */
BAT_API void bat_editor_set_read_only(bat_editor *editor, bool read_only);

/* ---- pictures and the clipboard ---- */

/* Places the bytes of a PNG, JPEG or WebP file behind the drawing, in the middle of the view and fitted into it,
 * half transparent and selected; this is a step of the history. name may be NULL. When the picture is refused, a
 * notice says why. */
BAT_API bat_status bat_editor_add_picture(bat_editor *editor, const void *bytes, size_t size,
                                          const char *name);
/* The picture that an item of role IMAGE shows; NULL: there is no picture with that number. */
BAT_API const bat_picture *bat_editor_picture(const bat_editor *editor, uint32_t picture);

/* The text that BAT_ASK_TEXT asks for, or that was written last, as JSON: {"id", "text": lines that end with "\n", "family": fonts as
 * CSS lists them, "size", "weight", "italic", "spacing" of letters, "line" in sizes, "align": "start", "middle" or "end", "at": [x, y]
 * of the first base line, "box": what is seen, low x, low y, high x, high y, all in units of its own, "matrix": from these to the
 * document, "fill": "#rrggbbaa", "opacity", "screen": the matrix to view pixels}. One that is yet to be written has "id":0 and an empty
 * text; of foreign content, which may be nothing but a text, there are only "id", "matrix" from the pixels of its "picture"
 * (bat_editor_picture; 0: it is clipped) and "screen", and writing it makes it a text, for which "matrix" must be given. texts: a list of
 * those that are selected. Owned by the editor, valid until the next call of either; NULL: there is none, or out of memory. */
BAT_API const char *bat_editor_writing(bat_editor *editor);
BAT_API const char *bat_editor_texts(bat_editor *editor);
/* Changes a text to what such JSON says, whose missing members stay as they are, and selects it; with "id":0 it is a new one, at the
 * place asked for. Or several, in a list. The box must be measured by whoever shapes the letters. One that is empty is deleted. This
 * is a step of the history. BAT_STATE: a gesture is under way, or the document is read-only; other statuses: there is no such text, a
 * member is missing, or out of its range; problem (may be NULL) says which and where. */
BAT_API bat_status bat_editor_write(bat_editor *editor, const char *json, size_t size, bat_problem *problem);

/* What of the drawing is copied: as it is, with its page; everything, or the selection with all that is in it, without a
 * page, so that files show the box of what is painted. */
typedef enum bat_excerpt { BAT_EXCERPT_PAGE, BAT_EXCERPT_ALL, BAT_EXCERPT_SELECTION } bat_excerpt;
/* That part as a document of its own (bat_document_free); what would follow an object left behind is free of it.
 * BAT_STATE: nothing is selected, or a gesture is under way; BAT_ARGUMENT: no such part. O(objects). */
BAT_API bat_status bat_editor_excerpt(const bat_editor *editor, bat_excerpt part, bat_document **out);
/* The selection as an SVG file with every knot (to be freed by bat_free), for the clipboard; cut: the selection is
 * then deleted, which is a step of the history. BAT_STATE: nothing is selected. A notice says what was done, or
 * why nothing was. */
BAT_API bat_status bat_editor_copy(bat_editor *editor, bool cut, char **text, size_t *size);
/* Puts everything in a document into the active layer and selects it; this is a step of the history. own: the
 * document was copied by bat_editor_copy (the reader's report says `native`), and is placed 10 px from where it
 * was, 20 when pasted again, or in the middle of the view if it would not be visible there. Otherwise it is placed
 * at the pointer, or in the middle. It is pasted in place with Shift, or when asked for by "paste-in-place".
 * Layers are dropped, but not their contents. BAT_STATE: the document is empty. */
BAT_API bat_status bat_editor_paste(bat_editor *editor, const bat_document *document, bool own);

/* ---- journal ---- */

/* The journal so far: JSON lines (docs/journal.md). A snapshot of the document, then every committed command. */
BAT_API const char *bat_editor_journal(const bat_editor *editor, size_t *size);
/* Shortens the journal of a long session: it then holds the document as it was before the first step that can be undone,
 * followed by all steps as changes. When replayed it gives the same document and history. BAT_STATE: a stroke or a
 * drag is under way. On failure the journal stays as it was. Cost: that of writing the document and these steps. */
BAT_API bat_status bat_editor_compact(bat_editor *editor);
/* Runs a journal from its first line (a snapshot, or an empty document). check: compares the digests in it and
 * checks the document's invariants after every entry. */
BAT_API bat_status bat_editor_replay(bat_editor *editor, const char *text, size_t size, bool check,
                                     bat_problem *problem);
/* Runs what can be run of a journal that is damaged, and leaves out each line that cannot be; an undo that would take
 * back a step that was left out does nothing. When the first line is damaged, begins with an empty document.
 * *left_out (may be NULL): the number of lines left out. BAT_UNSUPPORTED: it is of a newer version, and nothing was
 * done; BAT_SYNTAX: it is empty. Cost: that of replaying it. */
BAT_API bat_status bat_editor_salvage(bat_editor *editor, const char *text, size_t size, int *left_out);
/* Runs one more line of a journal, without its line break, after bat_editor_replay has run its first one: for hosts that
 * leave out a step which cannot be run. An object that does not lie where the line says is found by its id. */
BAT_API bat_status bat_editor_replay_line(bat_editor *editor, const char *text, size_t size,
                                          bat_problem *problem);
/* Checks the invariants of the editor and of the document: NULL when all hold. */
BAT_API const char *bat_editor_check(const bat_editor *editor);

#ifdef __cplusplus
}
#endif
#endif
