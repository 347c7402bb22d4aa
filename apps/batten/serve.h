/*
 * The editor's server: loopback only, one file, one token per start. It serves the embedded shell and the file,
 * and saves the file. Everything that does not come from its own page is refused:
 *
 *   400 a header given twice that must appear once (Host, Origin, ...); NUL or a folded line in the head
 *   403 a foreign or null Origin, a fetch from another site, a missing or wrong token
 *   404 a path that is not in the table (there is no file system behind it)
 *   405 another method
 *   409 the file or its folder is read-only; a pipe, a folder or a device is in its place; all names for a copy
 *       are taken; the folder was moved, or another is in its place; a copy that an earlier save has left is there
 *   411 a body without its length; 413 one larger than any file that is read (IO_FILE_MAX)
 *   412 the file on disk is not the one that If-Match names
 *   415 a media type other than the file's
 *   421 a Host that is not ours (DNS rebinding)
 *   422 a body that is not a drawing in the file's format: nothing is written
 *   428 no If-Match
 *   507 no space on the disk, or the file would exceed its size limit
 *
 * Connections of other users of the machine are closed at once, where the system tells whose they are.
 *
 * GET /document returns the file's bytes with ETag and X-Batten-Name (percent-encoded); PUT /document with If-Match
 * saves. The body goes to the disk as it arrives (upload.h). POST /document makes a new file beside it and returns its X-Batten-Name (201). All of these need the
 * header X-Batten-Token, whose value is in the page in place of %TOKEN%. The page at "/index.html" is the one
 * without a token, which a browser may keep: "/sw.js" keeps it and the files beside it where %ADDRESS% says
 * "lasting", that is, where the port was asked for, and asks "/" for the token of each start.
 */
#ifndef BATTEN_APPS_SERVE_H
#define BATTEN_APPS_SERVE_H

#include "document_file.h"

typedef struct http_server http_server;

/* The file that is served; all borrowed. */
typedef struct serve_file {
    const char *path;
    const bat_format *format;
    document_start start;
} serve_file;

/* Starts a thread that serves the file. port 0: any free one. lasting: the browser
 * may keep the shell of this address. NULL on success, else what went wrong (static storage or strerror's). */
const char *serve_start(const serve_file *file, int port, bool lasting, http_server **out);
int serve_port(const http_server *server);
/* Stops after the current request. */
void serve_stop(http_server *server);
/* Whether the shell is part of this build; the second call: the module, batten.wasm. */
bool serve_has_shell(void);
bool serve_has_module(void);

#endif
