// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page shows before anybody has touched it.

import { defaultView } from './view.js';

export function defaults({ frame, maps, salient, lines, holes, medial }) {
  return {
    view: defaultView(frame.low, frame.high), pan: [0, 0], zoom: 1,
    theme: 'auto', panel: true,
    scale: 'joint', map: 0.7, threshold: rounded(0.18 * maps.largest), top: rounded(maps.largest), mip: false, palette: 'viridis',
    mesh: 0.08,
    points: Boolean(salient), pointsize: 0.35, pointmin: 0, pointcolour: 'sphericity', pointpalette: 'blue-orange', select: -1,
    lines: Boolean(lines), linesize: 0,
    balls: false, ballsize: 0.15, ballmin: 0,
    holes: Boolean(holes),
    clip: [0, 1, 0, 1, 0, 1],
  };
}

const rounded = (value) => Number(value.toPrecision(3));
