/* Memory for the host's arguments, and the layout of the structs that the host reads and writes. */
#include "module.h"

#include <stdlib.h>

/* The offset of a field in its struct, in bytes. The list ends with a NULL name. The host finds fields by name, so
 * that a field may move without any change in the host. */
typedef struct module_field {
    const char *name;
    uint32_t offset;
} module_field;

MODULE_EXPORT(memory_alloc) void *memory_alloc(size_t size);
MODULE_EXPORT(memory_free) void memory_free(void *memory);
MODULE_EXPORT(module_layout) const module_field *module_layout(void);
MODULE_EXPORT(module_break) void module_break(void);

void *memory_alloc(size_t size) { return malloc(size ? size : 1); }

void memory_free(void *memory) { bat_free(memory); }

const module_field *module_layout(void) {
    static const module_field fields[] = {
        {"pointer.size", sizeof(bat_pointer)},
        {"pointer.phase", offsetof(bat_pointer, phase)},
        {"pointer.device", offsetof(bat_pointer, device)},
        {"pointer.contact", offsetof(bat_pointer, contact)},
        {"pointer.buttons", offsetof(bat_pointer, buttons)},
        {"pointer.modifiers", offsetof(bat_pointer, modifiers)},
        {"pointer.x", offsetof(bat_pointer, x)},
        {"pointer.y", offsetof(bat_pointer, y)},
        {"pointer.pressure", offsetof(bat_pointer, pressure)},
        {"pointer.tilt_x", offsetof(bat_pointer, tilt_x)},
        {"pointer.tilt_y", offsetof(bat_pointer, tilt_y)},
        {"pointer.twist", offsetof(bat_pointer, twist)},
        {"pointer.width", offsetof(bat_pointer, width)},
        {"pointer.height", offsetof(bat_pointer, height)},
        {"pointer.time", offsetof(bat_pointer, time)},
        {"pointer.predicted", offsetof(bat_pointer, predicted)},
        {"item.size", sizeof(bat_item)},
        {"item.id", offsetof(bat_item, id)},
        {"item.version", offsetof(bat_item, version)},
        {"item.role", offsetof(bat_item, role)},
        {"item.flags", offsetof(bat_item, flags)},
        {"item.stroke", offsetof(bat_item, stroke)},
        {"item.fill", offsetof(bat_item, fill)},
        {"item.width", offsetof(bat_item, width)},
        {"item.opacity", offsetof(bat_item, opacity)},
        {"item.cap", offsetof(bat_item, cap)},
        {"item.join", offsetof(bat_item, join)},
        {"item.miter_limit", offsetof(bat_item, miter_limit)},
        {"item.path_count", offsetof(bat_item, path_count)},
        {"item.bounds", offsetof(bat_item, bounds)},
        {"item.path", offsetof(bat_item, path)},
        {"item.picture", offsetof(bat_item, picture)},
        {"item.paint_count", offsetof(bat_item, paint_count)},
        {"item.paint", offsetof(bat_item, paint)},
        {"frame.view", offsetof(bat_frame, view)},
        {"frame.origin", offsetof(bat_frame, origin)},
        {"frame.still_version", offsetof(bat_frame, still_version)},
        {"frame.still_count", offsetof(bat_frame, still_count)},
        {"frame.still", offsetof(bat_frame, still)},
        {"frame.dirty", offsetof(bat_frame, dirty)},
        {"frame.live_count", offsetof(bat_frame, live_count)},
        {"frame.live", offsetof(bat_frame, live)},
        {"frame.label_count", offsetof(bat_frame, label_count)},
        {"frame.labels", offsetof(bat_frame, labels)},
        {"label.size", sizeof(bat_label)},
        {"label.role", offsetof(bat_label, role)},
        {"label.at", offsetof(bat_label, at)},
        {"label.offset", offsetof(bat_label, offset)},
        {"label.turn", offsetof(bat_label, turn)},
        {"label.text", offsetof(bat_label, text)},
        {"frame.cursor", offsetof(bat_frame, cursor)},
        {"frame.requests", offsetof(bat_frame, requests)},
        {"frame.unsaved", offsetof(bat_frame, unsaved)},
        {"frame.can_undo", offsetof(bat_frame, can_undo)},
        {"frame.can_redo", offsetof(bat_frame, can_redo)},
        {"frame.tool", offsetof(bat_frame, tool)},
        {"frame.knots_before", offsetof(bat_frame, knots_before)},
        {"frame.knots_after", offsetof(bat_frame, knots_after)},
        {"frame.pending", offsetof(bat_frame, pending)},
        {"frame.busy", offsetof(bat_frame, busy)},
        {"frame.error", offsetof(bat_frame, error)},
        {"frame.tolerance", offsetof(bat_frame, tolerance)},
        {"frame.hint", offsetof(bat_frame, hint)},
        {"frame.notice", offsetof(bat_frame, notice)},
        {"frame.notice_version", offsetof(bat_frame, notice_version)},
        {"frame.jumps", offsetof(bat_frame, jumps)},
        {"frame.tilt", offsetof(bat_frame, tilt)},
        {"frame.surfaces", offsetof(bat_frame, surfaces)},
        {"frame.offer", offsetof(bat_frame, offer)},
        {"frame.name", offsetof(bat_frame, name)},
        {"frame.revision", offsetof(bat_frame, revision)},
        {"frame.selection", offsetof(bat_frame, selection)},
        {"frame.selected", offsetof(bat_frame, selected)},
        {"frame.layer", offsetof(bat_frame, layer)},
        {"frame.readings", offsetof(bat_frame, readings)},
        {"frame.levels", offsetof(bat_frame, levels)},
        {"frame.moves", offsetof(bat_frame, moves)},
        {"frame.lost", offsetof(bat_frame, lost)},
        {"frame.first", offsetof(bat_frame, first)},
        {"space.clip", offsetof(bat_space, clip)},
        {"space.eye", offsetof(bat_space, eye)},
        {"space.before", offsetof(bat_space, before)},
        {"space.scale", offsetof(bat_space, scale)},
        {"space.perspective", offsetof(bat_space, perspective)},
        {"space.look", offsetof(bat_space, look)},
        {"space.count", offsetof(bat_space, count)},
        {"space.items", offsetof(bat_space, items)},
        {"space.range", offsetof(bat_space, range)},
        {"space.legend", offsetof(bat_space, legend)},
        {"space.waits", offsetof(bat_space, waits)},
        {"solid.size", sizeof(bat_space_item)},
        {"solid.id", offsetof(bat_space_item, id)},
        {"solid.version", offsetof(bat_space_item, version)},
        {"solid.kind", offsetof(bat_space_item, kind)},
        {"solid.colour", offsetof(bat_space_item, colour)},
        {"solid.width", offsetof(bat_space_item, width)},
        {"solid.opacity", offsetof(bat_space_item, opacity)},
        {"solid.cap", offsetof(bat_space_item, cap)},
        {"solid.rows", offsetof(bat_space_item, rows)},
        {"solid.columns", offsetof(bat_space_item, columns)},
        {"solid.index_count", offsetof(bat_space_item, index_count)},
        {"solid.indices", offsetof(bat_space_item, indices)},
        {"solid.vertices", offsetof(bat_space_item, vertices)},
        {"solid.moved", offsetof(bat_space_item, moved)},
        {"problem.size", sizeof(bat_problem)},
        {"problem.place", offsetof(bat_problem, place)},
        {"problem.message", offsetof(bat_problem, message)},
        {"bytes.data", offsetof(module_bytes, data)},
        {"bytes.size", offsetof(module_bytes, size)},
        {NULL, 0},
    };
    return fields;
}

/* For testing the host's recovery: fails as a broken invariant would. */
void module_break(void) { module_panic(__FILE_NAME__, __LINE__, "asked to break"); }
