// Surfaces, meshes, wires, views of them, cameras and motion: what calls.txt cannot describe of them.
import { shown, wrong } from './error.js';
import { converted, isNumbers, listOf, numbersOf, optionsOf } from './given.js';
import { Handle } from './library.js';

/** A tensor-product B-spline surface in space. */
export class Surface extends Handle {
  /** The control points, row by row: rows along u, columns along v, three numbers each. @returns {Float64Array} */
  get points() {
    const { memory } = this.library;
    const [rows, columns] = [this.count('u'), this.count('v')];
    const points = new Float64Array(3 * rows * columns);
    for (let i = 0; i < rows; i++) {
      points.set(memory.doubles(memory.exports.bat_surface_row(this.at_, i), 3 * columns), 3 * columns * i);
    }
    return points;
  }

  /** A finder looks at the surface it is made of, so it keeps one of its own. */
  finder() {
    const own = this.copy();
    return own.finder_().keep_(own);
  }
}

/** Finds the nearest places of a surface, and where rays meet it. */
export class SurfaceFinder extends Handle {}

/** Triangles of a surface, which follow it when a part of it changes. */
export class Tessellation extends Handle {
  /** The triangles as they are: points and normals, u, v, and three vertices for each of triangles. */
  get grid() {
    const { memory, structs, tables } = this.library;
    return memory.during(() => {
      const at = memory.borrow(tables.structs.bat_mesh.size);
      memory.exports.bat_tessellation_mesh(this.at_, at);
      const { rows, columns, triangleCount } = sizes(memory, tables.structs.bat_mesh, at);
      const counts = { points: 3 * rows * columns, normals: 3 * rows * columns, u: rows, v: columns };
      const place = (name) => memory.view.getUint32(at + tables.structs.bat_mesh.fields.find((field) => field.name === name).at, true);
      const arrays = Object.entries(counts).map(([name, count]) => [name, memory.doubles(place(name), count)]);
      return { rows, columns, ...Object.fromEntries(arrays), triangles: structs.many('int', place('triangles'), 3 * triangleCount) };
    });
  }
}

/** The numbers of things in a grid. */
function sizes(memory, { fields }, at) {
  const of = (name) => memory.view.getUint32(at + fields.find((field) => field.name === name).at, true);
  return { rows: of('rows'), columns: of('columns'), triangleCount: of('triangle_count') };
}

/** A surface with levels of detail over a base. */
export class Relief extends Handle {
  /** How many levels there are. @returns {number} */
  get levels_() {
    return this.levels;
  }

  /** How many control points a level has. @param {number} level @returns {number} */
  countOf_(level) {
    const surface = this.surface(level);
    return surface.count('u') * surface.count('v');
  }

  /** A level above: its knots in both directions (left out: those below), and what it adds. */
  addLevel(given) {
    const { uKnots, vKnots, details, source } = optionsOf([given], [], ['uKnots', 'vKnots', 'details', 'source'], 'addLevel');
    const below = this.surface(this.levels);
    const knots = { u: uKnots, v: vKnots };
    if ((details ?? source) !== undefined) {
      const missing = Object.keys(knots).find((name) => !isNumbers(knots[name]));
      if (missing) {
        throw wrong(`${missing}Knots`, 'knots, where details or sources are given', shown(knots[missing]));
      }
      const count = ['u', 'v'].map((name) => knots[name].length - (below.isClosed(name) ? 1 : below.degree(name) + 1)).reduce((a, c) => a * c);
      for (const [name, given, each] of [['details', details, 3], ['source', source, 1]]) {
        const found = given !== undefined && listOf(given).flat().length;
        if (found !== false && found !== each * count) {
          throw wrong(name, `${each * count} numbers for ${count} control points`, `${found}`, 'count');
        }
      }
    }
    return this.addLevel_([uKnots?.length ?? 0, vKnots?.length ?? 0], { uKnots, vKnots, details, source });
  }
}

/** A profile that goes along a path. */
export class Sweep extends Handle {}

/** Polygons in space, or a cloud of points. */
export class Mesh extends Handle {
  /** The vertices of each face. @returns {Int32Array[]} */
  get faces() {
    return Array.from({ length: this.faceCount }, (_, i) => this.face(i));
  }
}

/** What distances are measured to. */
export class Reference extends Handle {}

/** Points that follow wires. */
export class Binding extends Handle {
  /** Where the points are when the wires are these curves. points: what to move instead of what was bound. */
  apply(curves, given) {
    const { points = this.bound_.points } = optionsOf([curves, given], ['curves'], ['points'], 'apply');
    const { wires, count } = this.bound_;
    if (!Array.isArray(curves) || curves.length !== wires) {
      throw wrong('curves', `an array of ${wires} curves`, shown(curves), 'count');
    }
    const numbers = numbersOf(points, 3, 'points');
    if (numbers.length !== 3 * count) {
      throw wrong('points', `${count} points, as were bound`, `${numbers.length / 3}`, 'count');
    }
    return this.apply_(curves, numbers);
  }
}

/** Curves that surfaces have in a view or with each other, as polylines. */
export class Tracks extends Handle {
  /** The points of a track. @param {number} i */
  points(i) {
    const { memory, structs, tables } = this.library;
    return memory.during(() => {
      const cell = memory.borrow(4);
      const count = memory.exports.bat_tracks_points(this.at_, converted(tables, 'size_t', i, 'i'), cell);
      return structs.many('bat_track_point', memory.view.getUint32(cell, true), count);
    });
  }
}

/** What is seen of a scene, as lines. */
export class LineDrawing extends Handle {
  /** A line: what it is, and its points, four for each cubic. @param {number} i */
  at(i) {
    const { memory, structs, tables } = this.library;
    const { size, fields } = tables.structs.bat_seen_line;
    return memory.during(() => {
      const at = memory.borrow(size);
      const which = converted(tables, 'size_t', i, 'i');
      if (which >= this.count) {
        throw wrong('i', `one of ${this.count} lines`, shown(i), 'count');
      }
      memory.exports.bat_line_drawing_at(this.at_, which, at);
      const line = structs.read('bat_seen_line', at);
      const points = memory.view.getUint32(at + fields.find((field) => field.name === 'points').at, true);
      return { ...line, points: memory.doubles(points, points ? 2 * (3 * line.segments + 1) : 0) };
    });
  }
}

/** A camera move. */
export class Camera extends Handle {
  /** How many levels there are. @returns {number} */
  get levels_() {
    return this.levels;
  }
}

/** Motion as it was recorded: a skeleton and its frames. */
export class Take extends Handle {
  /** How many joints there are, ends too. @returns {number} */
  get jointCount() {
    return this.joints.length;
  }
}

/** A take with few knots, in levels. */
export class Motion extends Handle {
  /** The take that its skeleton is of: a copy. */
  take() {
    const { memory } = this.library;
    const own = this.library.make_('Take', memory.exports.bat_motion_take(this.at_));
    try {
      return this.library.take(own.joints, own.values, own.frameTime);
    } finally {
      own.gone(); // it is the motion's
    }
  }

  /** How many joints there are, ends too. @returns {number} */
  get jointCount() {
    return this.take().jointCount;
  }
}

export const space = { Surface, SurfaceFinder, Tessellation, Relief, Sweep, Mesh, Reference, Binding, Tracks, LineDrawing, Camera, Take, Motion };

/** Both of a pair: one value stands for two. */
const pair = (value) => (Array.isArray(value) ? value : [value, value]);

/** What the library has beside its calls, of these classes. */
export const made = {
  /** A surface of rows of points, and knots in both directions. */
  surface(points, uKnots, vKnots, given) {
    const { degree = 3, closed = false } = optionsOf([points, uKnots, vKnots, given], ['points', 'uKnots', 'vKnots'], ['degree', 'closed'], 'surface');
    const rows = Array.isArray(points) ? points.length : 0;
    const columns = points?.[0]?.length;
    if (!rows || !Array.isArray(points[0]) || points.some((row) => row?.length !== columns)) {
      throw wrong('points', 'rows of points, all as long', shown(points));
    }
    return this.surface_(pair(degree), pair(closed), [rows, columns], points.flat(), [uKnots?.length, vKnots?.length], uKnots, vKnots);
  },

  /** A mesh of vertices and faces, each an array of at least three of their numbers; a cloud of points without faces. */
  mesh(vertices, given) {
    const { faces = [] } = optionsOf([vertices, given], ['vertices'], ['faces'], 'mesh');
    if (!Array.isArray(faces)) {
      throw wrong('faces', 'an array of faces', shown(faces));
    }
    faces.forEach((face, i) => {
      if (!isNumbers(face) || face.length < 3) {
        throw wrong(`faces[${i}]`, '3 vertices or more', shown(face), 'count');
      }
    });
    return this.mesh_(vertices, faces.map((face) => face.length), faces.flatMap(listOf));
  },

  /** What distances are measured to, with copies of what it looks at. */
  reference(options = {}) {
    const copies = [];
    const own = Object.fromEntries(Object.entries(options).map(([name, list]) => [name, list?.map?.((one) => {
      copies.push(one?.copy?.() ?? one);
      return copies.at(-1);
    }) ?? list]));
    return this.reference_(own).keep_(...copies);
  },

  /** Binds points to wires. */
  bind(wires, points, options = {}) {
    const binding = this.bind_(wires, points, options);
    Object.defineProperty(binding, 'bound_', { value: { wires: wires.length, points, count: binding.count } });
    return binding;
  },

  /** A take of joints (name, parent, offset, channels, end) and, for each frame, a row with all their channels. */
  take(joints, values, frameTime) {
    const channels = Array.isArray(joints) ? joints.reduce((sum, one) => sum + (one?.channels?.length ?? 0), 0) : 0;
    const numbers = numbersOf(values, channels, 'values');
    if (!channels || numbers.length % channels) {
      throw wrong('values', `rows of ${channels} numbers, one a frame`, `${numbers.length} numbers`, 'count');
    }
    return this.take_(joints, numbers.length / channels, frameTime, numbers);
  },
};

