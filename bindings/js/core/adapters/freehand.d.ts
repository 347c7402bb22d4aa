export interface StrokeOptions {
  size?: number;
  thinning?: number;
  smoothing?: number;
  streamline?: number;
  simulatePressure?: boolean;
  easing?: (pressure: number) => number;
  start?: object;
  end?: object;
  last?: boolean;
}
/** The outline of a stroke, a closed polygon, as that of perfect-freehand. */
export declare function getStroke(points: readonly (readonly number[] | { x: number; y: number; pressure?: number })[], options?: StrokeOptions): number[][];
export declare function getSvgPath(outline: readonly (readonly number[])[], decimals?: number): string;
export default getStroke;
