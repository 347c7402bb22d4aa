/** The options of perfect-freehand. streamline, start, end and last are taken and have no effect. */
export interface StrokeOptions {
  /** Width of the stroke at full pressure: 16. */
  size?: number;
  /** How much less pressure narrows it, -1 to 1: 0.5. */
  thinning?: number;
  /** How far the line may leave the points, 0 to 1: 0.5. */
  smoothing?: number;
  streamline?: number;
  /** Fast strokes press less, whatever the points say: true. */
  simulatePressure?: boolean;
  /** What becomes of a pressure. */
  easing?: (pressure: number) => number;
  start?: object;
  end?: object;
  last?: boolean;
}
/** The outline of a stroke, a closed polygon, as that of perfect-freehand. */
export declare function getStroke(points: readonly (readonly number[] | { x: number; y: number; pressure?: number })[], options?: StrokeOptions): number[][];
/** SVG path data of an outline. */
export declare function getSvgPath(outline: readonly (readonly number[])[], decimals?: number): string;
export default getStroke;
