// The element without a page inside: its attribute `page` has to say where the folder `page` of this package is served.
export * from './index.js';
