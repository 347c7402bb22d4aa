// A moving picture as a GIF file (the specification of 1990, 89a): one palette, of each picture the part that has changed, packed by
// Lempel, Ziv and Welch's way.

const COLOURS = 256;
const CODES = 4096; // of at most 12 bits
const SHADES = 5; // bits of each colour that the palette is chosen by

/** @param {Uint8ClampedArray} data @param {number} i */
const binOf = (data, i) => (data[i] >> (8 - SHADES) << (2 * SHADES)) | (data[i + 1] >> (8 - SHADES) << SHADES) | (data[i + 2] >> (8 - SHADES));

/** The colours that pictures have most of, as red, green, blue. @param {ImageData[]} pictures */
function paletteOf(pictures) {
  const bins = new Float64Array(4 << (3 * SHADES)); // count and sums of each
  for (const { data } of pictures) {
    for (let i = 0; i < data.length; i += 4) {
      const bin = 4 * binOf(data, i);
      bins[bin]++;
      for (let c = 0; c < 3; c++) {
        bins[bin + 1 + c] += data[i + c];
      }
    }
  }
  const found = Array.from({ length: bins.length / 4 }, (_, i) => 4 * i).filter((bin) => bins[bin] > 0)
    .sort((a, b) => bins[b] - bins[a]).slice(0, COLOURS);
  const palette = new Uint8Array(3 * COLOURS);
  found.forEach((bin, i) => palette.set([1, 2, 3].map((c) => Math.round(bins[bin + c] / bins[bin])), 3 * i));
  return { palette, count: found.length };
}

/** Bytes that grow. */
class Bytes {
  constructor() {
    this.data = new Uint8Array(1 << 16);
    this.size = 0;
  }

  /** @param {ArrayLike<number>} more */
  add(more) {
    if (this.size + more.length > this.data.length) {
      const larger = new Uint8Array(2 * (this.size + more.length));
      larger.set(this.data.subarray(0, this.size));
      this.data = larger;
    }
    this.data.set(more, this.size);
    this.size += more.length;
  }

  /** @param {...number} values of two bytes each, the lower first */
  shorts(...values) {
    this.add(values.flatMap((value) => [value & 255, value >> 8]));
  }
}

/** The codes of a picture, in blocks of at most 255 bytes. @param {Bytes} out @param {Uint8Array} pixels numbers in the palette */
function pack(out, pixels) {
  const clear = COLOURS;
  const next = new Uint16Array(CODES * COLOURS); // the code of a known run and one pixel more; 0: none
  const block = new Uint8Array(255);
  let [filled, bits, held] = [0, 0, 0]; // of the block; of a byte not yet whole
  let [known, width] = [clear + 2, 9]; // codes so far, and their bits
  const put = (/** @type {number} */ code) => {
    held |= code << bits;
    for (bits += width; bits >= 8; bits -= 8, held >>>= 8) {
      block[filled++] = held & 255;
      if (filled === block.length) {
        out.add([filled]);
        out.add(block);
        filled = 0;
      }
    }
  };
  out.add([8]);
  put(clear);
  let run = pixels[0];
  for (let i = 1; i < pixels.length; i++) {
    const longer = next[run * COLOURS + pixels[i]];
    if (longer) {
      run = longer;
      continue;
    }
    put(run);
    if (known === CODES) {
      put(clear);
      next.fill(0);
      [known, width] = [clear + 2, 9];
    } else {
      next[run * COLOURS + pixels[i]] = known;
      width += Number(known === 1 << width);
      known++;
    }
    run = pixels[i];
  }
  put(run);
  put(clear + 1);
  if (bits > 0) {
    block[filled++] = held & 255;
  }
  if (filled > 0) {
    out.add([filled]);
    out.add(block.subarray(0, filled));
  }
  out.add([0]);
}

export class Gif {
  /** @param {number} width pixels @param {number} height @param {ImageData[]} pictures that have the colours of all */
  constructor(width, height, pictures) {
    this.width = width;
    this.height = height;
    const { palette, count } = paletteOf(pictures);
    this.palette = palette;
    this.count = count;
    /** The number in the palette for each shade, plus 1; 0: not yet sought. */
    this.numbers = new Uint16Array(1 << (3 * SHADES));
    this.last = new Uint8Array(0);
    this.out = new Bytes();
    this.out.add(new TextEncoder().encode('GIF89a'));
    this.out.shorts(width, height);
    this.out.add([0xf7, 0, 0]);
    this.out.add(palette);
    this.out.add([0x21, 0xff, 11, ...new TextEncoder().encode('NETSCAPE2.0'), 3, 1, 0, 0, 0]); // again and again
  }

  /** @param {Uint8ClampedArray} data @param {number} i */
  #number(data, i) {
    const bin = binOf(data, i);
    if (!this.numbers[bin]) {
      let [best, least] = [0, Infinity];
      for (let k = 0; k < this.count; k++) {
        const far = (this.palette[3 * k] - data[i]) ** 2 + (this.palette[3 * k + 1] - data[i + 1]) ** 2 + (this.palette[3 * k + 2] - data[i + 2]) ** 2;
        if (far < least) {
          [best, least] = [k, far];
        }
      }
      this.numbers[bin] = best + 1;
    }
    return this.numbers[bin] - 1;
  }

  /** The part in which two pictures differ; one pixel where they do not. @param {Uint8Array} now @returns {[number, number, number, number]} */
  #changed(now) {
    const { width, height, last } = this;
    if (last.length === 0) {
      return [0, 0, width, height];
    }
    let [left, top, right, bottom] = [width, height, -1, -1];
    for (let y = 0, i = 0; y < height; y++) {
      for (let x = 0; x < width; x++, i++) {
        if (now[i] !== last[i]) {
          [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), y];
        }
      }
    }
    return right < 0 ? [0, 0, 1, 1] : [left, top, right - left + 1, bottom - top + 1];
  }

  /** @param {ImageData} picture @param {number} time milliseconds for which it is shown */
  add({ data }, time) {
    const { width, out } = this;
    const now = new Uint8Array(data.length / 4);
    for (let i = 0; i < now.length; i++) {
      now[i] = this.#number(data, 4 * i);
    }
    const [x, y, wide, high] = this.#changed(now);
    const part = new Uint8Array(wide * high);
    for (let row = 0; row < high; row++) {
      part.set(now.subarray((y + row) * width + x, (y + row) * width + x + wide), row * wide);
    }
    out.add([0x21, 0xf9, 4, 4]); // stays as it is below the next
    out.shorts(Math.round(time / 10));
    out.add([0, 0, 0x2c]);
    out.shorts(x, y, wide, high);
    out.add([0]);
    pack(out, part);
    this.last = now;
  }

  /** @returns {Uint8Array<ArrayBuffer>} the file */
  end() {
    this.out.add([0x3b]);
    return this.out.data.slice(0, this.out.size);
  }
}
