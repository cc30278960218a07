// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is under the pointer: a salient point, a medial ball, a centreline, or else the largest value of the map along
// the ray. Computed here rather than drawn, since there are few things and rays are cheap.

import { Vector3 } from 'three';

// The nearest ball of `balls` that a ray meets, with a margin in units of the scene.
export function pickBall(balls, ray, margin = 0) {
  let best = null;
  const centre = new Vector3();
  for (let i = 0; i < balls.number; ++i) {
    if (balls.isShown.array[i] < 0.5) continue;
    centre.fromArray(balls.centres, 3 * i).sub(ray.origin);
    const along = centre.dot(ray.direction);
    const radius = balls.shownRadius(i) + margin;
    const missed = centre.lengthSq() - along * along;
    if (missed > radius * radius) continue;
    const depth = along - Math.sqrt(radius * radius - missed);
    if (!best || depth < best.depth) best = { index: i, depth };
  }
  return best;
}

// The nearest vertex of polylines that are no farther than `reach` from a ray.
export function pickLine(polylines, ray, reach) {
  let best = null;
  const offset = new Vector3();
  polylines.forEach(({ points, radii }, branch) => points.forEach((point, vertex) => {
    offset.copy(point).sub(ray.origin);
    const along = offset.dot(ray.direction);
    const missed = offset.lengthSq() - along * along;
    if (missed < reach * reach && (!best || missed < best.missed))
      best = { branch, vertex, depth: along, missed, radius: radii[vertex] };
  }));
  return best;
}

// Values of a map between its voxels.
export class Field {
  constructor({ size, stride, voxels, largest }) {
    Object.assign(this, { size, stride, voxels, largest });
  }

  // At a place in voxels of the grid, (0, 0, 0) being the middle of the first one; 0 outside.
  at(...voxel) {
    const place = voxel.map((x) => x / this.stride);
    const cell = place.map(Math.floor);
    const rest = place.map((p, i) => p - cell[i]);
    let sum = 0;
    for (let corner = 0; corner < 8; ++corner) {
      let weight = 1, index = 0, isInside = true;
      for (let axis = 2; axis >= 0; --axis) {
        const isUpper = (corner >> axis) & 1;
        const i = cell[axis] + isUpper;
        weight *= isUpper ? rest[axis] : 1 - rest[axis];
        isInside &&= i >= 0 && i < this.size[axis];
        index = index * this.size[axis] + i;
      }
      if (weight > 0 && isInside) sum += weight * this.voxels[index];
    }
    return (sum * this.largest) / 255;
  }
}

// The largest value along a ray within a box of the scene: { value, point } or null where all is zero.
export function strongestAlong(field, volume, ray, low, high) {
  let from = 0, to = Infinity;
  const start = ray.origin.toArray(), direction = ray.direction.toArray();
  for (let axis = 0; axis < 3; ++axis) {
    if (Math.abs(direction[axis]) < 1e-9) {
      if (start[axis] < low[axis] || start[axis] > high[axis]) return null;
      continue;
    }
    const a = (low[axis] - start[axis]) / direction[axis], b = (high[axis] - start[axis]) / direction[axis];
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
  }
  let best = null;
  for (let t = from; t <= to; t += 0.5 * volume.spacing) {
    const voxel = start.map((s, i) => (s + t * direction[i] - volume.origin[i]) / volume.spacing);
    const value = field.at(...voxel);
    if (value > (best?.value ?? 0)) best = { value, voxel, point: start.map((s, i) => s + t * direction[i]) };
  }
  return best;
}
