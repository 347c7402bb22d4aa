// Paints one path at a time, as long as it takes: the page ends this worker when it no longer wants what is being painted.

import { paintShape, shapeOf } from './shape.js';

addEventListener('message', ({ data: { width, height, matrix, path, look } }) => {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  if (context) {
    context.setTransform(new DOMMatrix(matrix));
    paintShape(context, shapeOf(path), look);
    context.getImageData(0, 0, 1, 1); // or else it would be painted by whoever first uses the picture
  }
  const picture = canvas.transferToImageBitmap();
  postMessage(picture, { transfer: [picture] });
});
