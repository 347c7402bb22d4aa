/* The browser shell's files, embedded in the program; web_files.c is made at build time by
 * cmake/embed_web.cmake from web/ and build/wasm/batten.wasm. */
#ifndef BATTEN_APPS_WEB_FILES_H
#define BATTEN_APPS_WEB_FILES_H

#include <stddef.h>

typedef struct web_file {
    const char *path; /* as in the address: "/", "/sw.js", "/0123456789abcdef/main.js" (digest of all) */
    const char *type; /* media type */
    const unsigned char *data;
    size_t size;
} web_file;

extern const web_file web_files[];
extern const size_t web_file_count;
extern const char *const web_module; /* the path of batten.wasm; NULL without a WASM compiler at build time */
extern const char web_policy[];      /* what the page may load and run: the content security policy */

#endif
