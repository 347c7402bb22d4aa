// Curves, fits, points with directions and levels of detail. Other calls throw a BattenError with status 'unsupported'.
export * from './index.js';
