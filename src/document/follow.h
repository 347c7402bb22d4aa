/* Objects that follow a curve of another object: where that goes they go, and when it is gone, so are they. */
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

#endif
