// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Colours from 0 to 1. Those of maps become lighter throughout, so that they can be read without seeing colours;
// those of points suit the colour-blind, but for the blue and red of the paper.

const stops = {
  // of maps
  viridis: ['440154', '482878', '3e4a89', '31688e', '26828e', '1f9e89', '35b779', '6ece58', 'b5de2b', 'fde725'],
  cividis: ['00224e', '123570', '3b496c', '575d6d', '707173', '8a8678', 'a59c74', 'c3b369', 'e1cc55', 'fee838'],
  magma: ['000004', '180f3d', '440f76', '721f81', '9e2f7f', 'cd4071', 'f1605d', 'fd9668', 'feca8d', 'fcfdbf'],
  grey: ['101010', 'f8f8f8'],
  // of points
  'blue-orange': ['1f5fa8', '6fa3d4', 'd9d9d9', 'f2a154', 'd9601a'],
  'blue-red': ['1c35d8', 'd81c1c'],
};

export const mapPalettes = ['viridis', 'cividis', 'magma', 'grey'];
export const pointPalettes = ['blue-orange', 'blue-red'];
export const holeColour = [0.16, 0.72, 0.35];

const rgb = (hex) => [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

// The colour at a place of a palette, as three numbers from 0 to 1.
export function colour(palette, place) {
  const list = stops[palette] ?? stops.viridis;
  const at = Math.min(Math.max(place, 0), 1) * (list.length - 1);
  const i = Math.min(Math.floor(at), list.length - 2);
  const [a, b] = [rgb(list[i]), rgb(list[i + 1])];
  return a.map((x, k) => x + (at - i) * (b[k] - x));
}

export function css([r, g, b]) {
  return `rgb(${Math.round(255 * r)} ${Math.round(255 * g)} ${Math.round(255 * b)})`;
}

export function gradient(palette, direction) {
  const list = stops[palette] ?? stops.viridis;
  return `linear-gradient(${direction}, ${list.map((hex) => `#${hex}`).join(', ')})`;
}

// 256 colours as bytes, for a texture.
export function table(palette) {
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    colour(palette, i / 255).forEach((x, k) => { bytes[4 * i + k] = Math.round(255 * x); });
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}
