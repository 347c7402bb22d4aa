// Curves and fits with the sketch hand. Other calls throw a BattenError with status 'unsupported'.
export * from './index.js';
