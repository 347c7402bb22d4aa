/* Objects that follow curves of others. A camera follows one: where that goes it goes, and when it is gone, so is the camera. A
 * skeleton likewise, but it stays where it is when the curve is gone.
 * A surface is made from several: it is made again when one changes, and when one is gone, it is free. */
#ifndef BATTEN_DOCUMENT_FOLLOW_H
#define BATTEN_DOCUMENT_FOLLOW_H

#include <batten/document.h>

/* *out: the object as it has to be, since the curve that it follows is another; NULL with BAT_OK: it is as it has to be. One
 * that can't follow the curve any longer lets go, and keeps the one it has. Not for one that is left (document.h). */
bat_status bat_document_follower(const bat_document *document, int index, bat_object **out);
/* Brings every follower up to date. BAT_ARGUMENT: one is left. */
bat_status bat_document_follow(bat_document *document);
/* Those that are left keep the curve they have, and follow nothing from then on. */
bat_status bat_document_let_go(bat_document *document);
/* A copy that follows the objects with these ids, one for each that it follows now; an id of 0: what had that
 * place is gone (kind.h). *out NULL with BAT_OK: it follows nothing. */
bat_status bat_object_renumbered(const bat_object *object, const bat_id *ids, bat_object **out);

#endif
