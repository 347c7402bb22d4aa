/// <reference lib="esnext.disposable" />
/** Points: flat (x, y, x, y, ...), or each an array or an object. */
export type Points = ArrayLike<number> | Numbers | readonly (ArrayLike<number> | { x: number; y: number; z?: number } | null)[];
/** Numbers in a row. */
export type NumberList = ArrayLike<number> | Numbers;
/** Samples of a pen: pressure from 0 to 1, time in milliseconds. */
export interface Stroke { points: Points; pressure?: NumberList; time?: NumberList }
/** Points, and a direction at each; null or zeros: none given. tension: two factors for each point. */
export interface Spline { points: Points; tangents?: Points; tension?: NumberList; closed?: boolean }
/** A region: a curve, the curves that bound it, or these with the rule that says what is inside. */
export type Region = Curve | Curve[] | { curves: Curve[]; evenOdd?: boolean };
/** What a model or a scene can be made of. */
export type Solid = Curve | Surface | Mesh;
/** target: the smoothed stroke with its transitions, target[strokeFirst] to target[strokeLast] being the stroke. */
export interface LiveInfo { target: Float64Array; strokeFirst: number; strokeLast: number }
/** Why a call failed, as a word. */
export type Status = 'memory' | 'argument' | 'number' | 'knots' | 'count' | 'degree' | 'dimension' | 'parameter' | 'tolerance'
  | 'dot' | 'far' | 'syntax' | 'singular' | 'unsupported' | 'state';
/** Columns of the frames, three numbers each. */
export interface FrameArrays { point: Float64Array; t: Float64Array; s: Float64Array; r: Float64Array }
/** What a curve can be drawn on: a Path2D, a canvas' context, or an object with these three methods. */
export interface PathLike {
  moveTo(x: number, y: number): void;
  bezierCurveTo(a: number, b: number, c: number, d: number, x: number, y: number): void;
  closePath(): void;
}

/** What the library could not do, and why. */
export class BattenError extends Error {
  /** Why, as a word. */
  status: Status;
  /** Why, as the number of bat_status. */
  code: number;
  /** With 'tolerance': the best result found. */
  best?: unknown;
}

/** Numbers in the module's memory, which calls read and write without a copy. */
export class Numbers {
  private constructor();
  /** How many numbers. */
  readonly length: number;
  /** A view, good until the next call: that may enlarge the memory, which leaves the view empty. */
  readonly values: Float64Array;
  /** Gives the memory back at once; else that happens when nobody holds the numbers any more. */
  free(): void;
  /** As free(): for `using`. */
  [Symbol.dispose](): void;
}

/** What the module holds. It is freed when nobody holds it any more, or at once by free() or `using`. */
declare class Handle {
  protected constructor();
  /** What consoles show: its class, and how large it is. */
  toString(): string;
  /** For JSON.stringify: what the function that reads such an object reads; a BattenError where there is none. */
  toJSON(): object;
  /** Gives the memory back at once. Any use after that throws a BattenError with status 'state'. */
  free(): void;
  /** As free(): for `using`. */
  [Symbol.dispose](): void;
}

/** A Path2D, where there is such a class. */
type Drawn = typeof globalThis extends { Path2D: { prototype: infer P } } ? P : PathLike;

/** A B-spline curve in the plane or in space. */
export class Curve extends Handle {
  /** Frames at n places, or at parameters: arrays of three numbers each. */
  frames(n: number | ArrayLike<number>, options?: FrameOptions): { u: Float64Array } & FrameArrays;
  finder(): Finder;
  /** Draws the curve on a path, such as a canvas' context, as cubics; gives the path back. */
  trace<P extends PathLike>(path: P, options?: { tolerance?: number }): P;
  /** The curve as a path for a canvas. */
  toPath2D(options?: { tolerance?: number }): Drawn;
  /** SVG path data. */
  toSVG(options?: { tolerance?: number; decimals?: number }): string;
  // Curve: the calls of C
}

/** Finds places of a curve that are nearest to points. */
export class Finder extends Handle {
  // Finder: the calls of C
}

/** Rotation-minimising frames along a curve. */
export class Chain extends Handle {
  /** Frames at many parameters. */
  many(u: ArrayLike<number>): FrameArrays;
  // Chain: the calls of C
}

/** A curve with levels of detail. */
export class Shape extends Handle {
  // Shape: the calls of C
}

/** An edit of a shape while the pen is down. */
export class LiveShape extends Handle {
  // LiveShape: the calls of C
}

/** A stroke while the pen is down. */
export class LiveSketch extends Handle {
  /** Adds a sample: its coordinates. */
  add(...place: number[]): this;
  // LiveSketch: the calls of C
}

/** A tensor-product B-spline surface in space. */
export class Surface extends Handle {
  /** The control points, row by row: rows along u, columns along v, three numbers each. */
  readonly points: Float64Array;
  finder(): SurfaceFinder;
  // Surface: the calls of C
}

/** Finds the nearest places of a surface, and where rays meet it. */
export class SurfaceFinder extends Handle {
  // SurfaceFinder: the calls of C
}

/** Triangles of a surface, which follow it when a part of it changes. */
export class Tessellation extends Handle {
  /** The triangles as they are. */
  readonly grid: { rows: number; columns: number; points: Float64Array; normals: Float64Array; u: Float64Array; v: Float64Array; triangles: Int32Array };
  // Tessellation: the calls of C
}

/** A surface with levels of detail over a base. */
export class Relief extends Handle {
  /** A level above: its knots in both directions (left out: those below), and what it adds. */
  addLevel(options?: { uKnots?: NumberList; vKnots?: NumberList; details?: Points; source?: NumberList }): this;
  // Relief: the calls of C
}

/** A profile that goes along a path. */
export class Sweep extends Handle {
  // Sweep: the calls of C
}

/** Polygons in space, or a cloud of points. */
export class Mesh extends Handle {
  /** The vertices of each face. */
  readonly faces: Int32Array[];
  // Mesh: the calls of C
}

/** What distances are measured to. */
export class Reference extends Handle {
  // Reference: the calls of C
}

/** Points that follow wires. */
export class Binding extends Handle {
  /** Where the points are when the wires are these curves. points: what to move instead of what was bound. */
  apply(curves: readonly Curve[], options?: { points?: Points }): { points: Float64Array; report: WireReport };
  // Binding: the calls of C
}

/** Curves that surfaces have in a view or with each other, as polylines. */
export class Tracks extends Handle {
  /** The points of a track. */
  points(i: number): TrackPoint[];
  // Tracks: the calls of C
}

/** What is seen of a scene, as lines. */
export class LineDrawing extends Handle {
  /** A line: what it is, and its points, four for each cubic. */
  at(i: number): SeenLine & { points: Float64Array };
  // LineDrawing: the calls of C
}

/** A camera move. */
export class Camera extends Handle {
  // Camera: the calls of C
}

/** Motion as it was recorded: a skeleton and its frames. */
export class Take extends Handle {
  /** How many joints there are, ends too. */
  readonly jointCount: number;
  // Take: the calls of C
}

/** A take with few knots, in levels. */
export class Motion extends Handle {
  /** The take that its skeleton is of: a copy. */
  take(): Take;
  /** How many joints there are, ends too. */
  readonly jointCount: number;
  // Motion: the calls of C
}

/** The bytes of a PNG, JPEG or WebP file. */
export class Picture extends Handle {
  /** The bytes of the file. */
  readonly bytes: Uint8Array;
  // Picture: the calls of C
}

/** An object of a document: a path, a spline, a group, a picture, a surface and so on. It never changes. */
export class Object extends Handle {
  /** Its curves. */
  readonly curves: Curve[];
  /** The corners of its picture, x and y; null: it has none. */
  readonly corners: Float64Array | null;
  /** Of a guide, its axis and where it is; else null. */
  readonly guide: { axis: number; at: number } | null;
  /** The ids of what it is made from. */
  readonly sources: number[];
  /** The spline that it is, as the calls take it; else null. */
  readonly spline: (Spline & { dimension: number }) | null;
  // Object: the calls of C
}

/** An ordered list of objects, back to front. */
export class Document extends Handle {
  /** All objects, back to front. */
  readonly objects: Object[];
  /** Puts an object in front of all others, under a new id, which is returned. */
  add(object: Object): number;
  // Document: the calls of C
}

/** The library: makes curves and what is made of curves. */
export class Batten {
  private constructor();
  /** The library's version. */
  readonly version: string;
  /** Numbers in the module's memory, for arguments and results (`into`) that are not copied. */
  array(length: number): Numbers;
  /** A surface of rows of points, and knots in both directions. */
  surface(points: readonly Points[], uKnots: NumberList, vKnots: NumberList, options?: { degree?: number | [number, number]; closed?: boolean | [boolean, boolean] }): Surface;
  /** A mesh of vertices and faces, each an array of at least three of their numbers; a cloud of points without faces. */
  mesh(vertices: Points, options?: { faces?: readonly NumberList[] }): Mesh;
  /** A take of joints (name, parent, offset, channels, end) and, for each frame, a row with all their channels. */
  take(joints: readonly BoneGiven[], values: NumberList | readonly NumberList[], frameTime: number): Take;
  /** A stroke of JSON or CSV, as the calls take it. */
  readStroke(text: string | Uint8Array): { points: Float64Array[]; pressure?: Float64Array; time?: Float64Array };
  /** A spline of JSON, as the calls take it. */
  readSpline(text: string | Uint8Array): { points: Float64Array[]; tangents?: Float64Array[]; tension?: Float64Array; closed: boolean };
  /** An SVG file as a document, whose report says what was left out. Nothing is fetched. */
  readSvg(text: string | Uint8Array, options?: SvgOptions): Document & { readonly report: Readonly<SvgReport> };
  // Batten: the calls of C
}

/** A WebAssembly.Module, where there is such a class. */
type Compiled = typeof globalThis extends { WebAssembly: { Module: { prototype: infer M } } } ? M : object;
/** A module: its address, its bytes, or compiled. */
export type Wasm = string | { readonly href: string } | ArrayBuffer | ArrayBufferView | Compiled;

/** Loads the library. wasm: a module in place of the package's own. */
export function load(options?: { wasm?: Wasm }): Promise<Batten>;
