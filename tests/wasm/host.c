/* What wasi-libc lacks for the tests, and the exports for tests/wasm/host.mjs. */
#define _POSIX_C_SOURCE 200809L /* fmemopen */
#include "support/alloc_fail.h"
#include "wasm/units.h"
#include "wasm/witness.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* Tells the host why, and does not return: the instance is lost. */
__attribute__((import_module("host"), import_name("stop"), noreturn)) void host_stop(const char *why);
/* The whole file into `bytes`; its size, also where that is more than `room`; -1: there is none. */
__attribute__((import_module("host"), import_name("read"))) long host_read(const char *path, void *bytes,
                                                                           size_t room);

FILE *host_fopen(const char *path, const char *mode);
int host_vsnprintf(char *out, size_t room, const char *format, va_list values);
int host_snprintf(char *out, size_t room, const char *format, ...);

__attribute__((export_name("text"))) char *module_text(void);
__attribute__((export_name("run"))) int module_run(int first);
__attribute__((export_name("at"))) int module_at(void);
__attribute__((export_name("room"))) void *module_room(size_t size);
__attribute__((export_name("read"))) int module_read(const uint8_t *data, size_t size);
__attribute__((export_name("flush"))) void module_flush(void);
__attribute__((export_name("witness"))) const char *module_witness(void);

_Noreturn void unit_stop(const char *why) { host_stop(why); }

FILE *host_fopen(const char *path, const char *mode) {
    static char bytes[1 << 20];
    const long size = mode[0] == 'r' ? host_read(path, bytes, sizeof bytes) : -1;
    return size > 0 && (size_t)size <= sizeof bytes ? fmemopen(bytes, (size_t)size, mode) : NULL;
}

/* Libc's own vsnprintf is hidden by the module's (web/module/print.c); its vfprintf is there. It allocates nothing, as far
 * as a test can see. */
int host_vsnprintf(char *out, size_t room, const char *format, va_list values) {
    static char whole[1 << 16];
    const long countdown = alloc_countdown;
    alloc_countdown = 0;
    FILE *file = fmemopen(whole, sizeof whole, "w");
    if (!file) host_stop("no memory to print");
    const int length = vfprintf(file, format, values);
    fclose(file);
    alloc_countdown = countdown;
    if (length < 0 || (size_t)length >= sizeof whole) host_stop("no room to print");
    const size_t kept = (size_t)length < room ? (size_t)length : room > 0 ? room - 1 : 0;
    for (size_t i = 0; i < kept; i++) out[i] = whole[i];
    if (room > 0) out[kept] = '\0';
    return length;
}

int host_snprintf(char *out, size_t room, const char *format, ...) {
    va_list values;
    va_start(values, format);
    const int length = host_vsnprintf(out, room, format, values);
    va_end(values);
    return length;
}

/* Where the host writes the name of the program or reader that it means. */
char *module_text(void) {
    static char text[256];
    return text;
}

int module_run(int first) { return unit_run(module_text(), first); }

/* The test in hand, from 0; -1: none yet. */
int module_at(void) { return unit_at(); }

/* Room for the next file; NULL: there is none. */
void *module_room(size_t size) {
    static void *room;
    free(room);
    return room = malloc(size);
}

int module_read(const uint8_t *data, size_t size) { return unit_read(module_text(), data, size); }

void module_flush(void) { fflush(stdout); }

const char *module_witness(void) { return witness_take(); }
