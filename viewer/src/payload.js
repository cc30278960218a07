// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads what mapt has put into the page: a JSON object, and arrays in one block of compressed bytes
// (tool/page_arrays.h has the other half).

export async function readReport() {
  const report = JSON.parse(document.getElementById('report').textContent);
  const element = document.getElementById('arrays');
  const bytes = await inflated(fromBase64(element.textContent));
  element.remove();
  return { report, arrays: new Arrays(bytes, report.lattice) };
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class Arrays {
  constructor(bytes, lattice) {
    this.bytes = bytes;
    this.lattice = lattice;
  }

  floats({ offset, number }) {
    const view = new DataView(this.bytes.buffer, offset, 4 * number);
    return Float32Array.from({ length: number }, (_, i) => view.getFloat32(4 * i, true));
  }

  // Differences to the element `stride` before, in four planes of bytes, the lowest first.
  integers({ offset, number, stride }) {
    const { bytes } = this;
    const values = new Int32Array(number);
    for (let i = 0; i < number; ++i) {
      const folded =
        bytes[offset + i] |
        (bytes[offset + number + i] << 8) |
        (bytes[offset + 2 * number + i] << 16) |
        (bytes[offset + 3 * number + i] << 24);
      const difference = (folded >>> 1) ^ -(folded & 1);
      values[i] = i < stride ? difference : values[i - stride] + difference;
    }
    return values;
  }

  // Coordinates one after the other, as `frame` has them.
  points(entry, frame) {
    const places = this.integers(entry);
    const { origin, step } = this.lattice;
    return Float32Array.from(places, (place, i) =>
      frame.toScene(origin[i % 3] + step * place, i % 3));
  }

  // Differences to the neighbours along x and y, modulo 256.
  voxels({ offset, number, size }) {
    const values = this.bytes.slice(offset, offset + number);
    const row = size[0];
    const layer = row * size[1];
    for (let i = 0; i < number; ++i) if (i % layer >= row) values[i] += values[i - row];
    for (let i = 0; i < number; ++i) if (i % row > 0) values[i] += values[i - 1];
    return values;
  }
}

// Between the units of the mesh and those of the scene, in which a shape fits into a ball of radius 1.
export class Frame {
  constructor({ min, max }) {
    this.centre = min.map((low, i) => (low + max[i]) / 2);
    this.unit = Math.hypot(...min.map((low, i) => max[i] - low)) / 2 || 1;
    this.low = min.map((x, i) => this.toScene(x, i));
    this.high = max.map((x, i) => this.toScene(x, i));
  }

  toScene(coordinate, axis) {
    return (coordinate - this.centre[axis]) / this.unit;
  }

  fromScene(coordinate, axis) {
    return coordinate * this.unit + this.centre[axis];
  }
}
