/** A plugin for builds with Vite or Rollup, which takes the editor's page along. Vite's dev server needs none. */
export default function battenEditor(): { name: string };
