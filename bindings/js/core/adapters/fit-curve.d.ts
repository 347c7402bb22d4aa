/** As fit-curve's: cubics of four points; maxError is a squared distance. */
declare function fitCurve(points: readonly (readonly number[])[], maxError: number): number[][][];
export { fitCurve };
export default fitCurve;
