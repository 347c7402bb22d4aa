#include "serve.h"

#include "clean.h"
#include "document_file.h"
#include "held_folder.h"
#include "guests.h"
#include "peer.h"
#include "rewrite.h"
#include "web_files.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

enum {
    TOKEN_BYTES = 16,
    TOKEN_ROOM = 2 * TOKEN_BYTES + 1,
    HOST_ROOM = 32,
    CONNECTIONS_MAX = 2 * GUESTS_MAX, /* guests that were disconnected may not be gone yet */
    STRANGER_SECONDS = 10,            /* how long a guest that has not shown the token may be silent */
    IDLE_SECONDS = 60,
    LINE_ROOM = PATH_MAX + 256 /* of what is answered in one line */
};

/* Headers of every response. */
static const char *const headers[][2] = {
    {"Content-Security-Policy", web_policy},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Embedder-Policy", "require-corp"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
};

struct http_server {
    struct MHD_Daemon *daemon;
    guest_list guests;
    serve_file file;
    held_folder folder; /* of the file */
    int port;
    char token[TOKEN_ROOM];
    char hosts[2][HOST_ROOM]; /* values allowed for Host */
    char *name;               /* of the file, percent-encoded */
    char *page;               /* the page "/" with the token inserted */
    size_t page_size;
};

/* One request, with its body when it is a PUT or POST that may have one. */
typedef struct http_request {
    size_t address_size; /* of the address in the request line, as received */
    bool begun;          /* the headers have been examined */
    bool saves;          /* it has a body */
    upload *body;        /* NULL: none */
    int failed;          /* errno of what the body failed at; the rest of it is dropped. 0: nothing */
} http_request;

/* ---- responses ---- */

static enum MHD_Result answer(struct MHD_Connection *connection, unsigned status,
                              struct MHD_Response *response, const char *type) {
    if (!response) return MHD_NO;
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; i++) {
        MHD_add_response_header(response, headers[i][0], headers[i][1]);
    }
    if (type) MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, type);
    enum MHD_Result result = MHD_queue_response(connection, status, response);
    MHD_destroy_response(response);
    return result;
}

/* Answers with one line of plain text. name, value: an extra header, or NULL. */
static enum MHD_Result say(struct MHD_Connection *connection, unsigned status, const char *text,
                           const char *name, const char *value) {
    char line[LINE_ROOM];
    size_t size = clean_text(text, line, sizeof line - 1);
    line[size] = '\n';
    struct MHD_Response *response = MHD_create_response_from_buffer(size + 1, line, MHD_RESPMEM_MUST_COPY);
    if (response && name) MHD_add_response_header(response, name, value);
    return answer(connection, status, response, "text/plain; charset=utf-8");
}

/* ---- refusals ---- */

typedef struct header_count {
    const char *name, *value;
    int count;
} header_count;

static enum MHD_Result count_header(void *user, enum MHD_ValueKind kind, const char *name,
                                    const char *value) {
    (void)kind;
    header_count *wanted = user;
    const char *a = name, *b = wanted->name; /* header names are case-insensitive */
    while (*a && *b && (*a | 32) == (*b | 32)) a++, b++;
    if (*a == *b) {
        wanted->value = value ? value : "";
        wanted->count++;
    }
    return MHD_YES;
}

/* The header's value; NULL when it is missing. */
static const char *header(struct MHD_Connection *connection, const char *name, int *count) {
    header_count wanted = {.name = name};
    MHD_get_connection_values(connection, MHD_HEADER_KIND, count_header, &wanted);
    if (count) *count = wanted.count;
    return wanted.value;
}

/* Takes the same time wherever the first difference is, against timing attacks. */
static bool same_token(const char *a, const char *b) {
    size_t size = strlen(b);
    if (strlen(a) != size) return false; /* the length is not secret */
    unsigned difference = 0;
    for (size_t i = 0; i < size; i++) difference |= (unsigned)((unsigned char)a[i] ^ (unsigned char)b[i]);
    return difference == 0;
}

typedef struct http_refusal {
    unsigned status; /* 0: none */
    const char *text;
} http_refusal;

/* Adds the size of a header line: name and value point into the request as received, with the colon and blanks
 * between them. */
static enum MHD_Result add_header_size(void *user, enum MHD_ValueKind kind, const char *name,
                                       const char *value) {
    (void)kind;
    *(size_t *)user += value ? (size_t)((uintptr_t)value - (uintptr_t)name) + strlen(value) + strlen("\r\n")
                             : 0;
    return MHD_YES;
}

/* Whether the parsed headers account for every byte of the head: no NUL hides the rest of a line, and no line
 * is folded. From version 1.0 on libmicrohttpd checks this itself. */
static bool is_plain_head(struct MHD_Connection *connection, const http_request *request, const char *method,
                          const char *version) {
    if (MHD_VERSION >= 0x01000000) return true;
    size_t size = strlen(method) + 1 + request->address_size + 1 + strlen(version) + strlen("\r\n\r\n");
    MHD_get_connection_values(connection, MHD_HEADER_KIND, add_header_size, &size);
    const union MHD_ConnectionInfo *info = MHD_get_connection_info(connection,
                                                                   MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE);
    return info && info->header_size == size;
}

/* Refuses requests that come neither from our own page nor from the user's address bar. */
static http_refusal refuse_stranger(const http_server *server, struct MHD_Connection *connection) {
    static const char *const single[] = {"Host",         "Origin",   "Sec-Fetch-Site", "X-Batten-Token",
                                         "Content-Type", "If-Match", "Content-Length", "Transfer-Encoding"};
    for (size_t i = 0; i < sizeof single / sizeof single[0]; i++) {
        int count;
        header(connection, single[i], &count);
        if (count > 1) return (http_refusal){MHD_HTTP_BAD_REQUEST, "A header was given twice."};
    }
    const char *host = header(connection, "Host", NULL);
    if (!host) return (http_refusal){MHD_HTTP_BAD_REQUEST, "The header Host is missing."};
    if (strcmp(host, server->hosts[0]) != 0 && strcmp(host, server->hosts[1]) != 0) {
        return (http_refusal){MHD_HTTP_MISDIRECTED_REQUEST, "This server does not answer to that host."};
    }
    const char *origin = header(connection, "Origin", NULL);
    if (origin && (strncmp(origin, "http://", 7) != 0 || strcmp(origin + 7, host) != 0)) {
        return (http_refusal){MHD_HTTP_FORBIDDEN, "Requests of other origins are refused."};
    }
    const char *site = header(connection, "Sec-Fetch-Site", NULL);
    if (site && strcmp(site, "same-origin") != 0 && strcmp(site, "none") != 0) {
        return (http_refusal){MHD_HTTP_FORBIDDEN, "Requests from other sites are refused."};
    }
    return (http_refusal){0, NULL};
}

static http_refusal refuse_token(const http_server *server, struct MHD_Connection *connection) {
    const char *token = header(connection, "X-Batten-Token", NULL);
    if (token && same_token(token, server->token)) return (http_refusal){0, NULL};
    return (http_refusal){MHD_HTTP_FORBIDDEN,
                          "The token is missing or wrong: open the address that batten edit printed."};
}

/* Whether a Content-Type is this type; "image/svg+xml; charset=utf-8" is image/svg+xml. */
static bool is_type(const char *value, const char *type) {
    size_t size = strlen(type);
    return strncmp(value, type, size) == 0 &&
           (value[size] == '\0' || value[size] == ';' || value[size] == ' ');
}

/* Refuses a PUT or POST by its headers, before its body is read. *size: length of the body. */
static http_refusal refuse_body(const http_server *server, struct MHD_Connection *connection, bool put,
                                size_t *size) {
    const char *type = header(connection, "Content-Type", NULL);
    if (!type || !is_type(type, server->file.format->media_type)) {
        return (http_refusal){MHD_HTTP_UNSUPPORTED_MEDIA_TYPE, "The media type is not that of the file."};
    }
    if (put && !header(connection, "If-Match", NULL)) {
        return (http_refusal){MHD_HTTP_PRECONDITION_REQUIRED, "The header If-Match is missing."};
    }
    const char *length = header(connection, "Content-Length", NULL);
    if (!length || header(connection, "Transfer-Encoding", NULL)) {
        return (http_refusal){MHD_HTTP_LENGTH_REQUIRED, "The header Content-Length is missing."};
    }
    char *end;
    errno = 0;
    unsigned long long bytes = strtoull(length, &end, 10);
    if (length[0] < '0' || length[0] > '9' || *end) {
        return (http_refusal){MHD_HTTP_BAD_REQUEST, "The header Content-Length is no number."};
    }
    if (errno || bytes > IO_FILE_MAX) {
        return (http_refusal){MHD_HTTP_CONTENT_TOO_LARGE,
                              "The drawing is above 256 MB, more than is read of a file."};
    }
    *size = (size_t)bytes;
    return (http_refusal){0, NULL};
}

/* ---- the document ---- */

static char *percent_encoded(const char *text) {
    static const char hex[] = "0123456789ABCDEF";
    char *out = malloc(3 * strlen(text) + 1), *to = out;
    if (!out) return NULL;
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                     (c && strchr("-._~", c));
        if (plain) {
            *to++ = (char)c;
        } else {
            *to++ = '%';
            *to++ = hex[c >> 4];
            *to++ = hex[c & 15];
        }
    }
    *to = '\0';
    return out;
}

/* Answers that a save broke off, this one or an earlier one, and how the copy from before is called. */
static enum MHD_Result say_copy(const http_server *server, struct MHD_Connection *connection, bool earlier) {
    char line[LINE_ROOM], copy[FILE_NAME_ROOM];
    const char *path = server->file.path;
    io_place place;
    if (!io_place_open(&place, path)) return MHD_NO;
    rewrite_copy_left(place.folder, place.name, copy);
    io_place_close(&place);
    snprintf(line, sizeof line,
             earlier ? "An earlier save of the file broke off. Keep it or the copy from before, which is "
                       "beside it, and move the other away: the copy is %s"
                     : "The file was written in part only. As it was before, it is beside it as %s",
             copy);
    return say(connection, earlier ? MHD_HTTP_CONFLICT : MHD_HTTP_INTERNAL_SERVER_ERROR, line, NULL, NULL);
}

/* Answers that the folder was moved, and where the file may be. */
static enum MHD_Result say_moved(struct MHD_Connection *connection, const char *now) {
    char line[LINE_ROOM];
    snprintf(line, sizeof line, "The folder was moved; nothing is saved here any more.%s%s",
             now[0] ? " The file may now be in " : "", now);
    return say(connection, MHD_HTTP_CONFLICT, line, NULL, NULL);
}

/* Answers why the file could not be saved. */
static enum MHD_Result say_failure(const http_server *server, struct MHD_Connection *connection,
                                   file_result result) {
    switch (result) {
    case FILE_CHANGED:
        return say(connection, MHD_HTTP_PRECONDITION_FAILED, "The file changed on disk. It was not touched.",
                   NULL, NULL);
    case FILE_READ_ONLY: return say(connection, MHD_HTTP_CONFLICT, "The file is read-only.", NULL, NULL);
    case FILE_NOT_REGULAR:
        return say(connection, MHD_HTTP_CONFLICT, "In the file's place stands what is no regular file.", NULL,
                   NULL);
    case FILE_COPY_LEFT:
    case FILE_BROKEN: return say_copy(server, connection, result == FILE_COPY_LEFT);
    default:
        if (errno == EACCES || errno == EPERM || errno == EROFS)
            return say(connection, MHD_HTTP_CONFLICT, "The folder is read-only.", NULL, NULL);
        return say(connection,
                   errno == ENOSPC || errno == EDQUOT || errno == EFBIG ? MHD_HTTP_INSUFFICIENT_STORAGE
                                                                        : MHD_HTTP_INTERNAL_SERVER_ERROR,
                   strerror(errno), NULL, NULL);
    }
}

static enum MHD_Result get_document(const http_server *server, struct MHD_Connection *connection) {
    char *data, tag[TAG_ROOM], now[PATH_ROOM];
    size_t size;
    if (held_folder_moved(&server->folder, now)) return say_moved(connection, now);
    file_result result = document_file_load(server->file.path, server->file.format, &server->file.start,
                                            &data, &size, tag);
    if (result != FILE_DONE) return say_failure(server, connection, result);
    struct MHD_Response *response = MHD_create_response_from_buffer(size, data, MHD_RESPMEM_MUST_FREE);
    if (!response) {
        free(data);
        return MHD_NO;
    }
    MHD_add_response_header(response, MHD_HTTP_HEADER_ETAG, tag);
    MHD_add_response_header(response, "X-Batten-Name", server->name);
    return answer(connection, MHD_HTTP_OK, response, server->file.format->media_type);
}

/* Answers a save: 204 with the new tag, 201 with the name of the new file, or why it failed. */
static enum MHD_Result say_saved(const http_server *server, struct MHD_Connection *connection,
                                 file_result result, const bat_problem *problem, unsigned status,
                                 const char *name, const char *value) {
    char line[sizeof *problem + 64];
    if (result == FILE_MALFORMED) {
        snprintf(line, sizeof line, "Not a drawing: %s%s%s", problem->place, problem->place[0] ? ": " : "",
                 problem->message);
        return say(connection, MHD_HTTP_UNPROCESSABLE_CONTENT, line, NULL, NULL);
    }
    if (result != FILE_DONE) return say_failure(server, connection, result);
    struct MHD_Response *response = MHD_create_response_from_buffer(0, NULL, MHD_RESPMEM_PERSISTENT);
    if (response) MHD_add_response_header(response, name, value);
    return answer(connection, status, response, NULL);
}

/* Nothing of a save is left beside the file when its page hears of it. */
static void end_body(http_request *request) {
    upload_end(request->body);
    request->body = NULL;
}

static enum MHD_Result put_document(const http_server *server, struct MHD_Connection *connection,
                                    http_request *request) {
    const char *wanted = header(connection, "If-Match", NULL);
    char tag[TAG_ROOM] = "";
    bat_problem problem = {.place = ""};
    file_result result = document_file_save(request->body, server->file.format, wanted, tag, &problem);
    end_body(request);
    return say_saved(server, connection, result, &problem, MHD_HTTP_NO_CONTENT, MHD_HTTP_HEADER_ETAG, tag);
}

/* Writes a new file beside the served one. */
static enum MHD_Result post_document(const http_server *server, struct MHD_Connection *connection,
                                     http_request *request) {
    char name[NAME_ROOM] = "", shown[CLEAN_ROOM * NAME_ROOM];
    bat_problem problem = {.place = ""};
    file_result result = document_file_save_beside(request->body, server->file.format, name, &problem);
    end_body(request);
    if (result == FILE_CHANGED)
        return say(connection, MHD_HTTP_CONFLICT, "There are too many copies beside the file.", NULL, NULL);
    clean_text(name, shown, sizeof shown);
    char *value = percent_encoded(shown);
    if (!value) return MHD_NO;
    enum MHD_Result answered = say_saved(server, connection, result, &problem, MHD_HTTP_CREATED,
                                         "X-Batten-Name", value);
    free(value);
    return answered;
}

/* ---- requests ---- */

static const web_file *find_file(const char *path) {
    for (size_t i = 0; i < web_file_count; i++) {
        if (strcmp(web_files[i].path, path) == 0) return &web_files[i];
    }
    return NULL;
}

static enum MHD_Result get_file(const http_server *server, struct MHD_Connection *connection,
                                const web_file *file) {
    bool page = strcmp(file->path, "/") == 0;
    void *data = page ? (void *)server->page : (void *)(uintptr_t)file->data;
    struct MHD_Response *response = MHD_create_response_from_buffer(page ? server->page_size : file->size,
                                                                    data, MHD_RESPMEM_PERSISTENT);
    return answer(connection, MHD_HTTP_OK, response, file->type);
}

/* Notes a request; guests that have shown the token may stay longer. */
static void note_guest(http_server *server, struct MHD_Connection *connection, bool known) {
    const union MHD_ConnectionInfo *info = MHD_get_connection_info(connection,
                                                                   MHD_CONNECTION_INFO_SOCKET_CONTEXT);
    if (info && info->socket_context) guests_hear(&server->guests, info->socket_context, known);
    if (known) {
        MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, (unsigned)IDLE_SECONDS);
    }
}

/* Nothing is written into a folder that stands in the place of one that was moved. */
static void begin_body(const http_server *server, size_t size, http_request *request) {
    char now[PATH_ROOM];
    if (held_folder_moved(&server->folder, now))
        request->failed = ESTALE;
    else if (!upload_begin(server->file.path, size, &request->body))
        request->failed = errno;
}

/* Called when the headers have arrived, but not the body: decides whether to accept it. */
static enum MHD_Result begin(http_server *server, struct MHD_Connection *connection, const char *path,
                             const char *method, http_request *request) {
    request->begun = true;
    http_refusal refusal = refuse_stranger(server, connection);
    if (refusal.status) return say(connection, refusal.status, refusal.text, NULL, NULL);
    bool document = strcmp(path, "/document") == 0;
    const web_file *file = document ? NULL : find_file(path);
    if (!document && !file) return say(connection, MHD_HTTP_NOT_FOUND, "There is no such path.", NULL, NULL);
    bool get = strcmp(method, "GET") == 0 || strcmp(method, "HEAD") == 0;
    bool put = document && strcmp(method, "PUT") == 0, post = document && strcmp(method, "POST") == 0;
    if (!get && !put && !post) {
        return say(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "This method is not known here.", "Allow",
                   document ? "GET, HEAD, PUT, POST" : "GET, HEAD");
    }
    if (document) refusal = refuse_token(server, connection);
    note_guest(server, connection, document && !refusal.status);
    size_t size = 0;
    if (!refusal.status && !get) refusal = refuse_body(server, connection, put, &size);
    if (refusal.status) return say(connection, refusal.status, refusal.text, NULL, NULL);
    request->saves = !get;
    /* A page hears of a failure only when it has sent everything. */
    if (!get) begin_body(server, size, request);
    return MHD_YES;
}

static enum MHD_Result on_request(void *user, struct MHD_Connection *connection, const char *path,
                                  const char *method, const char *version, const char *data, size_t *size,
                                  void **state) {
    http_server *server = user;
    http_request *request = *state;
    if (!request) return MHD_NO;
    if (!request->begun && !is_plain_head(connection, request, method, version)) {
        return say(connection, MHD_HTTP_BAD_REQUEST, "The request is not written plainly.", NULL, NULL);
    }
    if (!request->begun) return begin(server, connection, path, method, request);
    if (*size) { /* the body of a GET is dropped */
        if (request->body && !upload_add(request->body, data, *size)) request->failed = errno;
        *size = 0;
        return MHD_YES;
    }
    if (strcmp(path, "/document") != 0) return get_file(server, connection, find_file(path));
    if (!request->saves) return get_document(server, connection);
    char now[PATH_ROOM];
    const bool moved = held_folder_moved(&server->folder, now);
    if (moved || request->failed) end_body(request);
    if (moved) return say_moved(connection, now);
    errno = request->failed;
    if (request->failed) return say_failure(server, connection, FILE_FAILED);
    return (strcmp(method, "PUT") == 0 ? put_document : post_document)(server, connection, request);
}

/* Called first for each request, with its address before it is parsed. */
static void *on_address(void *user, const char *address, struct MHD_Connection *connection) {
    (void)user;
    (void)connection;
    http_request *request = calloc(1, sizeof *request);
    if (request) request->address_size = strlen(address);
    return request;
}

static void on_guest(void *user, struct MHD_Connection *connection, void **place,
                     enum MHD_ConnectionNotificationCode code) {
    http_server *server = user;
    const union MHD_ConnectionInfo *info = MHD_get_connection_info(connection,
                                                                   MHD_CONNECTION_INFO_CONNECTION_FD);
    if (!info) return;
    if (code == MHD_CONNECTION_NOTIFY_STARTED)
        *place = guests_come(&server->guests, info->connect_fd);
    else if (*place)
        guests_go(*place, info->connect_fd);
}

static enum MHD_Result on_connection(void *user, const struct sockaddr *address, socklen_t size) {
    const http_server *server = user;
    struct sockaddr_in peer;
    if (address->sa_family != AF_INET || size < sizeof peer) return MHD_NO;
    memcpy(&peer, address, sizeof peer);
    return peer_is_ours(&peer, server->port) ? MHD_YES : MHD_NO;
}

/* Leaves percent escapes as they are: none of our paths needs any. */
static size_t keep_escapes(void *user, struct MHD_Connection *connection, char *text) {
    (void)user;
    (void)connection;
    return strlen(text);
}

static void on_completed(void *user, struct MHD_Connection *connection, void **state,
                         enum MHD_RequestTerminationCode reason) {
    (void)user;
    (void)connection;
    (void)reason;
    http_request *request = *state;
    if (request) end_body(request);
    free(request);
    *state = NULL;
}

/* ---- start and end ---- */

static bool make_token(char token[TOKEN_ROOM]) {
    static const char hex[] = "0123456789abcdef";
    unsigned char bytes[TOKEN_BYTES];
    if (getrandom(bytes, sizeof bytes, 0) != (ssize_t)sizeof bytes) return false;
    for (int i = 0; i < TOKEN_BYTES; i++) {
        token[2 * i] = hex[bytes[i] >> 4];
        token[2 * i + 1] = hex[bytes[i] & 15];
    }
    token[2 * TOKEN_BYTES] = '\0';
    return true;
}

/* Makes the page with the token, and whether its address is lasting, in place of their marks; a page without
 * the marks is used unchanged. */
static bool make_page(http_server *server, bool lasting) {
    const web_file *file = find_file("/");
    if (!file) return true;
    const char *const marks[][2] = {{"%TOKEN%", server->token},
                                    {"%ADDRESS%", lasting ? "lasting" : "passing"}};
    const char *from = (const char *)file->data, *end = from + file->size;
    char *to = server->page = malloc(file->size + TOKEN_ROOM);
    if (!to) return false;
    while (from < end) {
        size_t mark = 0, marks_count = sizeof marks / sizeof marks[0];
        while (mark < marks_count && strncmp(from, marks[mark][0], strlen(marks[mark][0])) != 0) mark++;
        if (mark == marks_count) {
            *to++ = *from++;
        } else {
            memcpy(to, marks[mark][1], strlen(marks[mark][1]));
            to += strlen(marks[mark][1]);
            from += strlen(marks[mark][0]);
        }
    }
    server->page_size = (size_t)(to - server->page);
    return true;
}

/* Opens our own socket, so that the port is known before the first request arrives. -1: errno says why. */
static int listen_on(http_server *server, int port) {
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    if (listener < 0) return -1;
    int on = 1; /* the port can be reused right after its last owner has ended */
    socklen_t size = sizeof address;
    if (setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        fcntl(listener, F_SETFD, FD_CLOEXEC) != 0 ||
        bind(listener, (const struct sockaddr *)&address, sizeof address) != 0 ||
        listen(listener, SOMAXCONN) != 0 || getsockname(listener, (struct sockaddr *)&address, &size) != 0) {
        int reason = errno;
        close(listener);
        errno = reason;
        return -1;
    }
    server->port = ntohs(address.sin_port);
    snprintf(server->hosts[0], HOST_ROOM, "127.0.0.1:%d", server->port);
    snprintf(server->hosts[1], HOST_ROOM, "localhost:%d", server->port);
    return listener;
}

static const char *start(http_server *server, int port) {
    int listener = listen_on(server, port);
    if (listener < 0) return strerror(errno);
    server->daemon = MHD_start_daemon(
        MHD_USE_AUTO_INTERNAL_THREAD, 0, on_connection, server, on_request, server, MHD_OPTION_LISTEN_SOCKET,
        listener, MHD_OPTION_CONNECTION_LIMIT, (unsigned)CONNECTIONS_MAX, MHD_OPTION_CONNECTION_TIMEOUT,
        (unsigned)STRANGER_SECONDS, MHD_OPTION_UNESCAPE_CALLBACK, keep_escapes, NULL,
        MHD_OPTION_URI_LOG_CALLBACK, on_address, NULL, MHD_OPTION_NOTIFY_CONNECTION, on_guest, server,
        MHD_OPTION_NOTIFY_COMPLETED, on_completed, NULL, MHD_OPTION_END);
    return server->daemon ? NULL : "the server cannot be started";
}

const char *serve_start(const serve_file *file, int port, bool lasting, http_server **out) {
    http_server *server = calloc(1, sizeof *server);
    if (!server) return "out of memory";
    server->file = *file;
    held_folder_open(&server->folder, file->path);
    const char *path = file->path, *slash = strrchr(path, '/');
    char shown[CLEAN_ROOM * 256];
    clean_text(slash ? slash + 1 : path, shown, sizeof shown);
    server->name = percent_encoded(shown);
    const char *wrong = NULL;
    if (!make_token(server->token)) {
        wrong = "no random numbers";
    } else if (!server->name || !make_page(server, lasting)) {
        wrong = "out of memory";
    } else {
        wrong = start(server, port);
    }
    if (wrong)
        serve_stop(server);
    else
        *out = server;
    return wrong;
}

int serve_port(const http_server *server) { return server->port; }

void serve_stop(http_server *server) {
    if (server->daemon) MHD_stop_daemon(server->daemon);
    held_folder_close(&server->folder);
    free(server->name);
    free(server->page);
    free(server);
}

bool serve_has_shell(void) { return find_file("/") != NULL; }
bool serve_has_module(void) { return web_module != NULL; }
