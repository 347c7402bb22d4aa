// The whole library: curves and hands, surfaces and what is made of them, documents and files.
import { documents, reading } from './documents.js';
import { Batten, install } from './library.js';
import more from './more.js';
import { made, space } from './space.js';

Object.entries({ ...made, ...reading }).forEach(([name, value]) => Object.defineProperty(Batten.prototype, name, { value, configurable: true, writable: true }));

export const tables = install(more, { ...space, ...documents });
