#include "paint_rsvg.h"

#include <dlfcn.h>
#include <string.h>

static bool find(void *library, const char *name, void *function) {
    void *found = dlsym(library, name);
    memcpy(function, &found, sizeof found); /* ISO C has no cast between the two sorts of pointers */
    return found != NULL;
}

bool rsvg_load(rsvg_library *out) {
    static const char *const names[][2] = {{"librsvg-2.so.2", "libgobject-2.0.so.0"},
                                           {"librsvg-2.2.dylib", "libgobject-2.0.0.dylib"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        void *rsvg = dlopen(names[i][0], RTLD_NOW | RTLD_LOCAL),
             *gobject = rsvg ? dlopen(names[i][1], RTLD_NOW | RTLD_LOCAL) : NULL;
        if (rsvg && gobject && find(rsvg, "rsvg_handle_new_with_flags", &out->create) &&
            find(rsvg, "rsvg_handle_write", &out->write) && find(rsvg, "rsvg_handle_close", &out->close) &&
            find(rsvg, "rsvg_handle_render_document", &out->paint) &&
            find(gobject, "g_object_unref", &out->release))
            return true;
    }
    return false;
}

void *rsvg_read(const rsvg_library *with, const void *data, size_t size, bool large) {
    enum { UNLIMITED = 1 }; /* RSVG_HANDLE_FLAG_UNLIMITED */
    void *error = NULL, *handle = with->create(large ? UNLIMITED : 0);
    if (!handle) return NULL;
    if (with->write(handle, data, size, &error) && with->close(handle, &error)) return handle;
    with->release(handle);
    return NULL;
}
