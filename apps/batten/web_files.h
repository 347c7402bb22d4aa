/* The browser shell's files, embedded in the program; web_files.c is made at build time by
 * cmake/embed_web.cmake from web/ and build/wasm/batten.wasm. */
#ifndef BATTEN_APPS_WEB_FILES_H
#define BATTEN_APPS_WEB_FILES_H

#include <stddef.h>

typedef struct web_file {
    const char *path; /* as in the address: "/", "/main.js", "/batten.wasm" */
    const char *type; /* media type */
    const unsigned char *data;
    size_t size;
} web_file;

/* Without a WASM compiler at build time "/batten.wasm" is not among them. */
extern const web_file web_files[];
extern const size_t web_file_count;

#endif
