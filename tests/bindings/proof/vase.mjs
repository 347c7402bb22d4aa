// A surface through three rings, bent by a wire, as triangles in an STL file. Usage: node vase.mjs vase.stl
import fs from 'node:fs';
import { load } from 'batten-core';

const b = await load();
const CORNERS = [[2, 0], [2, 2], [0, 2], [-2, 2], [-2, 0], [-2, -2], [0, -2], [2, -2]];
const KNOTS = [0, 1, 2, 3, 4, 5, 6, 7, 8];
const ring = (size, height) => b.curve(CORNERS.map(([x, y]) => [size * x, size * y, height]), KNOTS, { degree: 3, closed: true });

const vase = b.loft([ring(5, 0), ring(3, 10), ring(6, 20)]);

const wire = b.clamped([[0, 0, 0], [0, 0, 7], [0, 0, 13], [0, 0, 20]]);
const bent = b.clamped([[0, 0, 0], [0, 0, 7], [4, 0, 13], [8, 0, 20]]);
const { points, report } = b.bind([{ reference: wire, radius: 50 }], vase.points).apply([bent]);

const [rows, columns] = [vase.count('u'), vase.count('v')];
const net = Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (__, k) => {
  const at = 3 * (i * columns + k);
  return points.slice(at, at + 3);
}));
const surface = b.surface(net, vase.knots('u'), vase.knots('v'),
  { degree: [vase.degree('u'), vase.degree('v')], closed: [vase.isClosed('u'), vase.isClosed('v')] });

fs.writeFileSync(process.argv[2], b.writeStl(surface, { tolerance: 0.05 }));
console.log(`${rows} by ${columns} points, ${report.moved} moved`);
