// The formats that a drawing can be exported in.

export const PNG = 'image/png';
/** Of each format: its name in the engine's table, the end of the file's name, its media type; what it is asked for by, where it
 * holds what is in space, and whether it does so as triangles; painted: it is a picture of pixels.
 * @type {{ name: string, of: string, end: string, type: string, space?: string, divided?: boolean, painted?: boolean }[]} */
export const FORMATS = [
  { name: 'SVG', of: 'svg', end: 'svg', type: 'image/svg+xml' },
  { name: '', of: 'plain', end: 'svg', type: 'image/svg+xml' },
  { name: 'PDF', of: 'pdf', end: 'pdf', type: '' },
  { name: 'PNG', of: 'png', end: 'png', type: PNG, painted: true },
  { name: 'WebP', of: 'webp', end: 'webp', type: 'image/webp', painted: true },
  { name: 'DXF', of: 'dxf', end: 'dxf', type: 'image/vnd.dxf' },
  { name: 'G-code', of: 'gcode', end: 'gcode', type: 'text/plain' },
  { name: 'GLIF', of: 'glif', end: 'glif', type: 'application/xml' },
  { name: 'GeoJSON', of: 'geojson', end: 'geojson', type: 'application/geo+json' },
  { name: 'CSV', of: 'csv', end: 'csv', type: 'text/csv' },
  { name: 'BVH', of: 'bvh', end: 'bvh', type: 'text/plain' },
  { name: 'STL', of: 'stl', end: 'stl', type: 'model/stl', space: 'stl', divided: true },
  { name: '3MF', of: '3mf', end: '3mf', type: 'model/3mf', space: '3mf', divided: true },
  { name: 'glTF (GLB)', of: 'glb', end: 'glb', type: 'model/gltf-binary', space: 'glb', divided: true },
  { name: 'STEP', of: 'step', end: 'step', type: 'model/step', space: 'step' },
  { name: 'IGES', of: 'iges', end: 'iges', type: 'model/iges', space: 'iges' },
  { name: 'PLY', of: 'ply', end: 'ply', type: 'model/ply', space: 'ply', divided: true },
  { name: 'USD (USDA)', of: 'usda', end: 'usda', type: 'model/vnd.usda', space: 'usda', divided: true },
  { name: 'OBJ', of: 'mesh', end: 'obj', type: 'model/obj', space: 'obj', divided: true },
  { name: 'OBJ (NURBS)', of: 'obj', end: 'obj', type: 'model/obj' },
  { name: 'Batten', of: 'batten', end: 'batten', type: 'application/json' },
];
