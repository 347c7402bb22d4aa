#define _GNU_SOURCE /* fallocate */ /* NOLINT(bugprone-reserved-identifier) */
#include "upload.h"

#include "aside.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>

struct upload {
    io_place place;
    aside_file aside;
    size_t size;
    int failed;       /* errno of the first call that failed; 0: none */
    const char *view; /* of all of it; NULL: not viewed, or empty */
};

/* Refused at once where the disk has no room; true where the file system cannot tell. */
static bool reserve(int file, size_t size) {
    if (!size || fallocate(file, FALLOC_FL_KEEP_SIZE, 0, (off_t)size) == 0) return true;
    return errno != ENOSPC && errno != EDQUOT && errno != EFBIG && errno != EIO;
}

bool upload_begin(const char *path, size_t size, upload **out) {
    upload *content = calloc(1, sizeof *content);
    if (!content) return false;
    bool begun = io_place_open(&content->place, path);
    if (begun) {
        const mode_t mode = io_place_taken(&content->place) ? 0600 : 0666;
        begun = aside_open(content->place.folder, mode, &content->aside);
        if (!begun) io_place_close(&content->place);
    }
    if (!begun) {
        free(content);
        return false;
    }
    if (!reserve(content->aside.file, size)) {
        upload_end(content);
        return false;
    }
    *out = content;
    return true;
}

bool upload_add(upload *content, const void *data, size_t size) {
    if (!content->failed) {
        const size_t put = io_put(content->aside.file, data, size);
        content->size += put;
        if (put < size) content->failed = errno;
    }
    errno = content->failed;
    return !content->failed;
}

bool upload_view(upload *content, const char **data, size_t *size) {
    errno = content->failed;
    if (content->failed) return false;
    if (content->size && !content->view) {
        void *view = mmap(NULL, content->size, PROT_READ, MAP_SHARED, content->aside.file, 0);
        if (view == MAP_FAILED) return false;
        content->view = view;
    }
    *data = content->view ? content->view : "";
    *size = content->size;
    return true;
}

io_place *upload_place(upload *content) { return &content->place; }

io_result upload_put(upload *content, const io_stamp *expected) {
    return io_replace_by(&content->place, &content->aside, content->view, content->size, expected);
}

void upload_end(upload *content) {
    if (!content) return;
    const int reason = errno;
    if (content->view) munmap((void *)(uintptr_t)content->view, content->size);
    aside_close(content->place.folder, &content->aside);
    io_place_close(&content->place);
    free(content);
    errno = reason;
}
