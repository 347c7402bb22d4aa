/*
 * Batten: the document. An ordered list of objects (back to front), each an immutable value that is replaced, never
 * changed, so that undo is an exchange of pointers. Objects, curves, shapes, splines and pictures are shared by
 * copies of a document and reference-counted; the counts are atomic, so that each copy can be used on a thread of its
 * own.
 */
#ifndef BATTEN_DOCUMENT_H
#define BATTEN_DOCUMENT_H

#include <batten/relate.h>
#include <batten/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef uint64_t bat_id;                /* 0: none. Ids are given by the document, ascending, never reused. */
#define BAT_ID_MAX ((bat_id)2147483647) /* the greatest id, here and in files: display lists have 32 bits */

typedef struct bat_style {
    bool stroked, filled;
    bool even_odd;         /* fill rule; else non-zero */
    uint32_t stroke, fill; /* 0xRRGGBBAA */
    double width;          /* document units */
    double opacity;        /* 0..1, of the whole object */
    bat_cap cap;
    bat_join join;
    double miter_limit;
} bat_style;

BAT_API bat_style bat_style_defaults(void); /* black stroke of width 2, round cap and join, no fill */
/* BAT_ARGUMENT: a number is out of range; problem (may be NULL) says which. The calls that take a style check it. */
BAT_API bat_status bat_style_check(const bat_style *style, bat_problem *problem);

/* An object is one of these: a path, which is one or more curves of one dimension that share a style (an O has
 * two); a spline of the tangents hand, whose points and directions stay editable and give its one curve; a shape,
 * some of whose curves are taken apart into levels, of which the finest is the curve; a container without curves,
 * which is a group, or a layer (in no group, and in nothing but layers); an image, which is a placed picture and
 * has no curves either; a guide, an endless line that paints nothing; a plane in space to draw on; a surface in space,
 * whose curves are its lines at the knots, which cannot be replaced; a camera move, whose curves only show it; a view that
 * was saved, which paints nothing; curves that are bound to wires; a mesh, whose curves are strips of its edges; a skeleton that moves; a rectangle, an ellipse or
 * a polygon, whose numbers (corners, angles, sides) stay editable and give its one curve; a text, which is letters until a host shapes
 * them, and shows them as a picture. */
typedef enum bat_kind {
    BAT_KIND_PATH = 1,
    BAT_KIND_SPLINE = 2,
    BAT_KIND_GROUP = 3,
    BAT_KIND_LAYER = 4,
    BAT_KIND_SHAPE = 5,
    BAT_KIND_IMAGE = 6,
    BAT_KIND_GUIDE = 7,
    BAT_KIND_PLANE = 8,
    BAT_KIND_SURFACE = 9,
    BAT_KIND_CAMERA = 10,
    BAT_KIND_VIEW = 11,
    BAT_KIND_MESH = 12,
    BAT_KIND_BOUND = 13,
    BAT_KIND_FOREIGN = 14,
    BAT_KIND_SKELETON = 15,
    BAT_KIND_PRIMITIVE = 16,
    BAT_KIND_TEXT = 17
} bat_kind;
typedef struct bat_object bat_object;

/* A picture to trace: the bytes of a PNG, JPEG or WebP file, of which only the header is read. Immutable,
 * reference-counted. */
typedef struct bat_picture bat_picture;
enum { BAT_PICTURE_SIDE = 65535 };           /* pixels of a side, at most */
#define BAT_PICTURE_SIZE ((size_t)16 << 20)  /* bytes of one, at most */
#define BAT_PICTURES_SIZE ((size_t)32 << 20) /* bytes of all in a file or a session, at most */
/* Copies the bytes. BAT_UNSUPPORTED: none of these kinds nor foreign content as bat_object_create_foreign takes it, a broken header, or a side too long; BAT_COUNT: too
 * many bytes. O(size). */
BAT_API bat_status bat_picture_create(const void *bytes, size_t size, bat_picture **out);
/* The same check, without a picture; problem (may be NULL) says what was expected. */
BAT_API bat_status bat_picture_check(const void *bytes, size_t size, bat_problem *problem);
BAT_API bat_picture *bat_picture_retain(const bat_picture *picture); /* counts users */
BAT_API void bat_picture_release(bat_picture *picture);              /* NULL is fine */
BAT_API const void *bat_picture_bytes(const bat_picture *picture, size_t *size);
BAT_API const char *
bat_picture_type(const bat_picture *picture); /* "image/png", "image/jpeg", "image/webp", "image/svg+xml" */
BAT_API uint64_t bat_picture_digest(const bat_picture *picture);             /* of its bytes */
BAT_API void bat_picture_sides(const bat_picture *picture, double sides[2]); /* pixels across and down */

/* What all objects have is checked so by the calls that make one: BAT_ARGUMENT: an id, a name or a style (each may be NULL) as below;
 * problem (may be NULL) says which: "style.opacity". */
BAT_API bat_status bat_object_head_check(bat_id id, const char *name, const bat_style *style,
                                         bat_problem *problem);
/* Takes ownership of the curves, which must all be different (the array itself stays the caller's). name: UTF-8,
 * may be NULL or empty. BAT_ARGUMENT: id 0 or above BAT_ID_MAX, a style out of range, a name that is not UTF-8. */
BAT_API bat_status bat_object_create_path(bat_id id, const char *name, const bat_style *style,
                                          int curve_count, bat_curve *const *curves, bat_object **out);
/* Copies the spline; its curve is what bat_tangents makes of it (options NULL: the defaults), and what
 * bat_tangents refuses is refused. */
BAT_API bat_status bat_object_create_spline(bat_id id, const char *name, const bat_style *style,
                                            const bat_spline *spline, const bat_tangents_options *options,
                                            bat_object **out);
/* An empty container; objects in it name it as their parent. layer: true makes a layer, false a group. Its style's opacity is
 * that of all that it holds, painted as one picture. */
BAT_API bat_status bat_object_create_group(bat_id id, const char *name, bool layer, bat_object **out);
/* A picture placed by {a, b, c, d, e, f}: its pixel (x, y) lies at (a x + c y + e, b x + d y + f). Retains the
 * picture. Of a style only the opacity applies to an image. BAT_NUMBER: the matrix is not finite or is singular;
 * BAT_ARGUMENT: the opacity is out of range. */
BAT_API bat_status bat_object_create_image(bat_id id, const char *name, const bat_picture *picture,
                                           const double matrix[6], double opacity, bat_object **out);
BAT_API bat_status bat_object_with_matrix(const bat_object *object, const double matrix[6], bat_object **out);
/* What is not edited here (texts, filters and the like), as a small SVG file that stands alone: a picture of the type
 * "image/svg+xml", whose pixels are as above. It can be chosen, moved, ordered, hidden and deleted; hosts paint it in
 * isolation: nothing in it is fetched or run. The other statuses as above; BAT_UNSUPPORTED, here and for images: the picture is
 * of the other sort. */
BAT_API bat_status bat_object_create_foreign(bat_id id, const char *name, const bat_picture *picture,
                                             const double matrix[6], double opacity, bat_object **out);
BAT_API bool bat_object_is_foreign(const bat_object *object);
/* A guide: the line x = at (axis 0) or y = at (axis 1). BAT_NUMBER: at lies beyond BAT_COORDINATE_MAX. */
BAT_API bat_status bat_object_create_guide(bat_id id, int axis, double at, bat_object **out);
/* A copy at another place along its axis. BAT_ARGUMENT: the object is not a guide. */
BAT_API bat_status bat_object_with_guide(const bat_object *object, double at, bat_object **out);
/* A plane in space: through the origin, spanned by two axes, x and y, which are made unit vectors at right angles:
 * x keeps its direction, y stays on its side of x. BAT_NUMBER: beyond BAT_COORDINATE_MAX; BAT_SINGULAR: the axes
 * span no plane. */
BAT_API bat_status bat_object_create_plane(bat_id id, const char *name, const double origin[3],
                                           const double axes[6], bat_object **out);
/* A view that was saved. Statuses of bat_viewpoint_check, whose rules it keeps. */
BAT_API bat_status bat_object_create_view(bat_id id, const char *name, const bat_viewpoint *view,
                                          bat_object **out);
/* Copies the surface. Its curves are its lines at u and then at v, at the ends and at inner knots, of which at most 63
 * in each direction have one. */
BAT_API bat_status bat_object_create_surface(bat_id id, const char *name, const bat_style *style,
                                             const bat_surface *surface, bat_object **out);
/* A surface made from the first curve of each of these objects by a recipe (bat_recipe_surface, whose statuses it has). A
 * document keeps it so: when one of the curves changes, it is made again; when one goes, or makes no surface any longer, it
 * is free and keeps the surface it has. BAT_ARGUMENT: an object is not made of curves, is given twice, or has this id. */
BAT_API bat_status bat_object_create_made(bat_id id, const char *name, const bat_style *style,
                                          const bat_recipe *recipe, size_t count,
                                          const bat_object *const *sources, bat_object **out);
/* A copy made by another recipe. BAT_ARGUMENT: the object is not a surface; else as above. */
BAT_API bat_status bat_object_with_recipe(const bat_object *object, const bat_recipe *recipe, size_t count,
                                          const bat_object *const *sources, bat_object **out);
/* A copy with another surface, which is free and has no levels. BAT_ARGUMENT: the object is not a surface. */
BAT_API bat_status bat_object_with_surface(const bat_object *object, const bat_surface *surface,
                                           bat_object **out);
/* Copies the mesh, which is kept bit for bit. Its curves show it: strips of its edges, up to 256 of them. */
BAT_API bat_status bat_object_create_mesh(bat_id id, const char *name, const bat_style *style,
                                          const bat_polymesh *mesh, bat_object **out);
enum { BAT_BOUND_WIRES = 16 }; /* of one object, at most */
/* A copy that is bound to wires (bat_wires_bind, whose statuses it has): the first curve of curves[i] is what wires[i] has
 * become, its domain mapped to the reference's. What is bound: the vertices of a mesh, the control points of a surface or of
 * curves, as they are, or, of an object that is bound already, as they were then. Copies wires. A document keeps it so: when
 * one of the curves changes, the points follow; when one goes, or can't be followed, the object is free and keeps its shape.
 * domains (may be NULL): for each wire NULL, or the object whose first curve bounds its reach, in place of wires[i].domain,
 * and goes on bounding it when it changes; when that object goes, its curve stays as it was. Then everything is bound again.
 * It is free of what it was made from. BAT_ARGUMENT: an object is not made of curves, follows others itself, is given twice
 * or is this one; a curve is closed and its reference is not, or the reverse; BAT_COUNT: none, or too many;
 * BAT_UNSUPPORTED: this kind can't be bound (a spline can as a path). */
BAT_API bat_status bat_object_bind(const bat_object *object, size_t count, const bat_wire *wires,
                                   const bat_object *const *curves, const bat_object *const *domains,
                                   const bat_wire_options *options, bat_object **out);
/* A copy that is free, as it is, or (revert) as it was bound, bit for bit. BAT_ARGUMENT: it is not bound. */
BAT_API bat_status bat_object_unbind(const bat_object *object, bool revert, bat_object **out);
/* What it is bound to: how many wires, 0 when it is free; *wires, *options (may be NULL): owned by the object. The objects
 * that shape them: bat_object_sources, which has those whose curves bound reaches behind them. */
BAT_API int bat_object_wires(const bat_object *object, const bat_wire **wires,
                             const bat_wire_options **options);
/* A copy whose surface is the finest of these levels, which are copied; it is free, and is edited by its levels from then on.
 * BAT_ARGUMENT: the object is not a surface. */
BAT_API bat_status bat_object_with_relief(const bat_object *object, const bat_relief *relief,
                                          bat_object **out);
/* Copies the move. follows: the object whose first curve is the path, which a document keeps so: when that curve changes,
 * the path is the curve as it then is, and when it goes, the camera goes with it; 0: the path is the camera's own. Its
 * curves show where it starts, and its own path. BAT_ARGUMENT: it follows itself. */
BAT_API bat_status bat_object_create_camera(bat_id id, const char *name, const bat_style *style,
                                            const bat_camera *camera, bat_id follows, bat_object **out);
/* A copy with another move, or that follows another object. BAT_ARGUMENT: the object is not a camera. */
BAT_API bat_status bat_object_with_camera(const bat_object *object, const bat_camera *camera, bat_id follows,
                                          bat_object **out);
/* Copies the motion. place: where the motion's axes and its origin lie in the drawing, its point p at {place[0] p.x + place[1] p.y
 * + place[2] p.z + place[3], ...}, 12 numbers; NULL: y up the page, and z towards who looks at it. Its curves are the bones as they
 * are in the first frame. BAT_NUMBER: a number is not finite or too large. */
BAT_API bat_status bat_object_create_skeleton(bat_id id, const char *name, const bat_style *style,
                                              const bat_motion *motion, const double *place,
                                              bat_object **out);
/* A copy with another motion. BAT_ARGUMENT: the object is not a skeleton. */
BAT_API bat_status bat_object_with_motion(const bat_object *object, const bat_motion *motion,
                                          bat_object **out);
/* A copy for pictures, as it stands at a time of its motion in seconds, which is clamped to that: its curves are the bones then.
 * Files and digests know nothing of it. BAT_UNSUPPORTED: the object is not a skeleton; BAT_NUMBER: the time is not finite. */
BAT_API bat_status bat_object_at_time(const bat_object *object, double seconds, bat_object **out);
/* A copy with other curves (ownership is taken), which is a path; all else, including its place in groups, is
 * kept. BAT_ARGUMENT, here and for a single curve or shape: the object is a surface or a camera, or of a kind without curves. */
BAT_API bat_status bat_object_with_curves(const bat_object *object, int count, bat_curve *const *curves,
                                          bat_object **out);
/* A copy in another group (0: in none), under another name (UTF-8), hidden or shown, locked or free. */
BAT_API bat_status bat_object_with_parent(const bat_object *object, bat_id parent, bat_object **out);
BAT_API bat_status bat_object_with_name(const bat_object *object, const char *name, bat_object **out);
BAT_API bat_status bat_object_with_state(const bat_object *object, bool hidden, bool locked,
                                         bat_object **out);
/* A copy with another id: a duplicate. */
BAT_API bat_status bat_object_with_id(const bat_object *object, bat_id id, bat_object **out);
/* A copy with one other curve (ownership is taken), or with another style (of an image, and of a group as a
 * whole, only the opacity; guides and planes have none, and stay as they are). With another curve a spline becomes a path, and the
 * curve no longer has levels. */
BAT_API bat_status bat_object_with_curve(const bat_object *object, int index, bat_curve *curve,
                                         bat_object **out);
BAT_API bat_status bat_object_with_style(const bat_object *object, const bat_style *style, bat_object **out);
/* A copy in which one curve is the finest of a shape (ownership is taken) and is edited by its levels from then
 * on. A spline becomes a shape in this way. */
BAT_API bat_status bat_object_with_shape(const bat_object *object, int index, bat_shape *shape,
                                         bat_object **out);
/* A copy with another spline, or (to_path) a copy that is a path with the curves as they are. BAT_ARGUMENT: the
 * object is not a spline (to_path: neither a spline nor a shape). */
BAT_API bat_status bat_object_with_spline(const bat_object *object, const bat_spline *spline,
                                          bat_object **out);
BAT_API bat_status bat_object_to_path(const bat_object *object, bat_object **out);
BAT_API bat_object *bat_object_retain(const bat_object *object); /* counts users */
BAT_API void bat_object_release(bat_object *object);             /* NULL is fine */

BAT_API bat_id bat_object_id(const bat_object *object);
BAT_API bat_kind bat_object_kind(const bat_object *object);
BAT_API const char *bat_object_name(const bat_object *object); /* never NULL */
BAT_API const bat_style *bat_object_style(const bat_object *object);
BAT_API int bat_object_curve_count(const bat_object *object);
/* Whether it is nothing but its curves, so that others can take their place. Those of a surface or a camera only show it. */
BAT_API bool bat_object_is_made_of_curves(const bat_object *object);
/* NULL: no such curve. */
BAT_API const bat_curve *bat_object_curve(const bat_object *object, int index);
/* The spline and how its curve is made; NULL when the object is not a spline. Its tangents and tension are never
 * NULL. */
BAT_API const bat_spline *bat_object_spline(const bat_object *object);
BAT_API const bat_tangents_options *bat_object_spline_options(const bat_object *object);
/* The levels of a curve; NULL: it has none. */
BAT_API const bat_shape *bat_object_shape(const bat_object *object, int index);
/* NULL when the object is neither an image, nor foreign content, nor a text. */
BAT_API const bat_picture *bat_object_picture(const bat_object *object);
BAT_API const double *bat_object_matrix(const bat_object *object);
/* The corners of an image: of pixels (0, 0), (w, 0), (w, h), (0, h). */
BAT_API void bat_object_corners(const bat_object *object, double corners[8]);
BAT_API bool bat_object_is_group(const bat_object *object); /* a group or a layer */
BAT_API bool
bat_object_is_drawn(const bat_object *object); /* no group, guide or plane: it can be seen and chosen */
BAT_API int bat_object_guide(const bat_object *object, double *at); /* the axis of a guide, -1: is none */
/* Owned by the object; NULL when it is not a surface. */
BAT_API const bat_surface *bat_object_surface(const bat_object *object);
/* Owned by the object; NULL when it is not a mesh. */
BAT_API const bat_polymesh *bat_object_mesh(const bat_object *object);
/* Its levels, owned by the object; NULL when it is not a surface, or has none. */
BAT_API const bat_relief *bat_object_relief(const bat_object *object);
/* How it is made, owned by the object; NULL when it is not a surface, or is free. */
BAT_API const bat_recipe *bat_object_recipe(const bat_object *object);
/* Where it is folded over: stretches in u, ascending, at most BAT_RECIPE_FOLDS of them are written, 2 numbers each; returns how
 * many there are. 0 when it is no sweep that follows its curves. out may be NULL. */
BAT_API size_t bat_object_folds(const bat_object *object, double *out);
/* What it is made from: how many objects; *ids (may be NULL): theirs, owned by the object. 0 when it is free. */
BAT_API int bat_object_sources(const bat_object *object, const bat_id **ids);
/* Owned by the object; NULL when it is not a camera. */
BAT_API const bat_camera *bat_object_camera(const bat_object *object);
/* Owned by the object; NULL when it is not a skeleton. place (may be NULL): 12 numbers, as above. */
BAT_API const bat_motion *bat_object_motion(const bat_object *object, double *place);
/* The object whose first curve is its path; 0: its path is its own, or it is not a camera. */
BAT_API bat_id bat_object_followed(const bat_object *object);
/* Origin, x axis, y axis: nine numbers, owned by the object; NULL when it is not a plane. */
BAT_API const double *bat_object_plane(const bat_object *object);
/* The view that was saved, owned by the object; NULL when it is not one. */
BAT_API const bat_viewpoint *bat_object_view(const bat_object *object);
BAT_API bat_id bat_object_parent(const bat_object *object); /* of the group it is in, 0: in none */
/* The object's own state; objects in a hidden or locked group count as hidden or locked, too. */
BAT_API bool bat_object_is_hidden(const bat_object *object);
BAT_API bool bat_object_is_locked(const bat_object *object);
/* Exact box of the outline, without stroke width: low x, low y, high x, high y. Groups: empty, low > high. */
BAT_API void bat_object_bounds(const bat_object *object, double box[4]);

typedef struct bat_document bat_document;

BAT_API bat_status bat_document_create(bat_document **out);
BAT_API void bat_document_free(bat_document *document); /* NULL is fine */
BAT_API bat_status bat_document_copy(const bat_document *document, bat_document **out);
BAT_API int bat_document_count(const bat_document *document);
BAT_API const bat_object *bat_document_at(const bat_document *document, int index); /* NULL: no such index */
BAT_API int bat_document_find(const bat_document *document, bat_id id);             /* index, or -1 */
BAT_API bat_id bat_document_new_id(bat_document *document);                         /* 0: all are used up */
/* The one way to change a document: insert at index, replace (same id), remove. `after` is retained. Inserting an
 * id above the next id raises the next id. BAT_ARGUMENT when index or id do not fit. */
BAT_API bat_status bat_document_insert(bat_document *document, int index, const bat_object *after);
BAT_API bat_status bat_document_replace(bat_document *document, int index, const bat_object *after);
BAT_API bat_status bat_document_remove(bat_document *document, int index);

/* The list is a tree in order: a group stands before its contents (and so lies behind them), and all its contents
 * follow it immediately. Returns the index after the last object in the group at index; for an object that is not
 * a group, index + 1. An index below 0: 0; one that is too large: the count. */
BAT_API int bat_document_end(const bat_document *document, int index);

/* The page: x, y, width, height in document units (width 0: none; then the drawing's box is shown). */
BAT_API void bat_document_page(const bat_document *document, double page[4]);
BAT_API bat_status bat_document_set_page(bat_document *document, const double page[4]);
BAT_API void bat_document_bounds(const bat_document *document, double box[4]); /* empty: low > high */

/* The physical size: how many millimetres one unit of the document is, and the unit in which its size is said. A document
 * that says none is in px, of which an inch has 96; BAT_UNIT_NONE: its file holds bare numbers, which formats with a size
 * take for millimetres. BAT_NUMBER: the scale is not from 1e-12 to 1e12. */
typedef enum bat_unit {
    BAT_UNIT_PX,
    BAT_UNIT_MM,
    BAT_UNIT_CM,
    BAT_UNIT_IN,
    BAT_UNIT_PT,
    BAT_UNIT_PC,
    BAT_UNIT_NONE
} bat_unit;
BAT_API double bat_document_scale(const bat_document *document); /* millimetres */
BAT_API bat_unit bat_document_unit(const bat_document *document);
BAT_API bat_status bat_document_set_scale(bat_document *document, double millimetres, bat_unit unit);

/* The invariants: ids unique, from 1 to BAT_ID_MAX, below the next id; curves valid; splines and levels give their
 * curves; what is followed is there; styles in range; the contents of groups follow them, and layers are in nothing but layers. Returns NULL
 * when all hold, otherwise which one does not (static storage). */
BAT_API const char *bat_document_check(const bat_document *document);
/* 64-bit digest of the page, the physical size that was said and the objects: equal documents, equal digests, on every platform. The next id is
 * left out, so that undo brings the digest back. */
BAT_API uint64_t bat_document_digest(const bat_document *document);

#ifdef __cplusplus
}
#endif
#endif
