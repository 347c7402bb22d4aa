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

/** The library: makes curves and what is made of curves. */
export class Batten {
  private constructor();
  /** The library's version. */
  readonly version: string;
  /** Numbers in the module's memory, for arguments and results (`into`) that are not copied. */
  array(length: number): Numbers;
  // Batten: the calls of C
}

/** A WebAssembly.Module, where there is such a class. */
type Compiled = typeof globalThis extends { WebAssembly: { Module: { prototype: infer M } } } ? M : object;
/** A module: its address, its bytes, or compiled. */
export type Wasm = string | { readonly href: string } | ArrayBuffer | ArrayBufferView | Compiled;

/** Loads the library. wasm: a module in place of the package's own. */
export function load(options?: { wasm?: Wasm }): Promise<Batten>;
