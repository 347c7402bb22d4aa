// A scene to fly through: three tori, and a curve in space that passes through them.
import { execFileSync } from 'node:child_process';
import { PROGRAM } from './server.mjs';

const circle = (place) => ({ degree: 3, closed: true, knots: [0, 1, 2, 3, 4, 5, 6, 7, 8], points: Array.from({ length: 8 }, (_, i) => place((i * Math.PI) / 4)) });
const clamped = (points) => ({ degree: 3, closed: false, knots: [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], points });
const WAY = [[120, 500, -60], [250, 420, -90], [420, 300, -160], [560, 560, -120], [720, 460, -80], [900, 380, -140]];

/** Three tori and a curve in space, face-on on a page. */
function scene() {
  const tori = [[330, 400, -120], [520, 450, -130], [760, 440, -95]].map((at, i) => {
    const sweep = { path: circle((a) => [at[0] + 20 * Math.cos(a), at[1] + 60 * Math.sin(a), at[2] + 60 * Math.cos(a)]), profile: circle((a) => [12 * Math.cos(a), 12 * Math.sin(a)]) };
    const { report, ...surface } = JSON.parse(execFileSync(PROGRAM, ['sweep', '-', '--tolerance', '0.1'], { input: JSON.stringify(sweep) }));
    return { id: i + 2, kind: 'surface', name: `torus ${i + 1}`, style: { stroked: false, filled: true, fill: ['#3f8fdfff', '#60b060ff', '#e08030ff'][i] }, surface };
  });
  const objects = [{ id: 1, kind: 'path', name: 'way', style: { stroke: '#202020ff', width: 3 }, curves: [clamped(WAY)] }, ...tori];
  return Buffer.from(JSON.stringify({ batten: 2, page: [0, 0, 1000, 800], objects }));
}
export const SCENE = scene();
