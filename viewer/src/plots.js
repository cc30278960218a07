// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Histograms as inline SVG. Heights and positions are attributes: the page allows no inline styles.

import { svg } from './dom.js';
import { fixed, significant, ticks } from './format.js';
import { colour, css } from './palettes.js';

const width = 300;

// How many voxels have which value, over the logarithm of their number; what is below the threshold is faint.
export class MapHistogram {
  constructor() {
    this.root = svg('svg', { class: 'plot', viewBox: `0 0 ${width} 112`, role: 'img', 'aria-label': 'Histogram of the map' });
  }

  show({ voxels, largest }, { threshold, top, palette, marks }) {
    const bins = 60, height = 84, left = 4;
    const counts = new Float64Array(bins);
    const binOf = (byte) => Math.min(Math.floor(((byte * largest) / 255 / top) * bins), bins - 1);
    const bin = Uint8Array.from({ length: 256 }, (_, byte) => binOf(byte));
    for (const byte of voxels) if (byte > 0) ++counts[bin[byte]];
    const most = Math.log1p(Math.max(...counts, 1));
    const step = (width - 2 * left) / bins;
    const x = (value) => left + (value / top) * (width - 2 * left);
    const bars = Array.from(counts, (n, i) => {
      const h = (height * Math.log1p(n)) / most;
      const middle = (i + 0.5) / bins;
      return svg('rect', { x: left + i * step, y: height - h, width: step - 0.6, height: h, fill: css(colour(palette, middle)), opacity: middle * top < threshold ? 0.35 : 1 });
    });
    this.root.replaceChildren(...bars,
      svg('path', { class: 'axis', d: `M${left} ${height + 0.5}H${width - left}` }),
      ...ticks(0, top, 5).map((value) => svg('text', { x: x(value), y: height + 13, 'text-anchor': value === 0 ? 'start' : 'middle' }, significant(value, 3))),
      ...marks.filter(([value]) => value < top).map(([value, name], i) => svg('g', { class: 'mark' },
        svg('path', { d: `M${x(value)} ${height}V4` }), svg('text', { x: x(value) + 3, y: i === 0 ? 22 : 10 }, name))),
      svg('text', { class: 'axis-title', x: width - left, y: height + 26, 'text-anchor': 'end' }, 'MAPT'),
      svg('text', { class: 'axis-title', x: left, y: height + 26 }, 'voxels (logarithmic)'));
  }
}

// The histograms of a descriptor, one below the other, each over the same values.
export function descriptorPlot({ values, bins, radii, largest_value: largest }, lengths) {
  const left = 62, rowHeight = 30;
  const most = Math.max(...values);
  const step = (width - left - 4) / bins;
  const rows = radii.map((radius, k) => {
    const base = (k + 1) * rowHeight;
    return svg('g', {},
      svg('text', { x: left - 8, y: base - 4, 'text-anchor': 'end' }, lengths(radius)),
      svg('path', { class: 'axis', d: `M${left} ${base + 0.5}H${width - 4}` }),
      Array.from({ length: bins }, (_, i) => {
        // The root: otherwise the first bins are all that one sees.
        const h = (rowHeight - 5) * Math.sqrt(values[k * bins + i] / most);
        return svg('rect', { class: 'bar', x: left + i * step, y: base - h, width: step - 1, height: h },
          svg('title', {}, `R = ${lengths(radius)}, MAPT ${fixed((i * largest) / bins)} to ${fixed(((i + 1) * largest) / bins)}: ${significant(values[k * bins + i], 3)}`));
      }));
  });
  const height = radii.length * rowHeight;
  const axis = [0, 0.25, 0.5, 0.75, 1].map((part) => svg('text', { x: left + part * step * bins, y: height + 14, 'text-anchor': 'middle' }, significant(part * largest, 3)));
  return svg('svg', { class: 'plot', viewBox: `0 0 ${width + 8} ${height + 32}`, role: 'img', 'aria-label': 'Shape descriptor: histograms at each radius' },
    rows, axis,
    svg('text', { class: 'axis-title', x: left - 8, y: height + 14, 'text-anchor': 'end' }, 'R'),
    svg('text', { class: 'axis-title', x: width - 4, y: height + 28, 'text-anchor': 'end' }, 'MAPT'));
}
