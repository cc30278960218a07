// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The report as the page needs it: arrays read, coordinates in the scene.

import { Vector3 } from 'three';
import { Balls } from './balls.js';
import { Surface } from './mesh.js';
import { holeColour } from './palettes.js';
import { Frame } from './payload.js';
import { Strips } from './strips.js';
import { Tubes } from './tubes.js';
import { Volume } from './volume.js';

// Of shapes at their own radius, for a ratio of 1/2: what numbers on a colour bar mean. Those of the joint map are
// larger, since it is strongest at smaller radii.
const marksAtHalf = [[1 / 16, 'plane'], [1 / 8, 'slab'], [1 / 2, 'tube'], [1, 'sphere']];

export class Content {
  constructor(report, arrays) {
    this.report = report;
    this.frame = new Frame(report.input.box);
    this.maps = new Maps(report.maps, arrays);
    this.volume = new Volume(report.grid, this.frame);
    this.#addSurface(arrays);
    this.salient = report.salient?.length ? this.#salientBalls(report.salient) : null;
    this.lines = report.lines?.branches.length ? this.#tubes(report.lines, arrays) : null;
    this.medial = report.medial?.points.number ? this.#medialBalls(report.medial, arrays) : null;
  }

  marksOf(scale) {
    const isOfRadius = this.maps.get(scale).radius !== undefined;
    return isOfRadius && this.report.parameters.sigma_ratio === 0.5 ? marksAtHalf : [];
  }

  #addSurface(arrays) {
    const { points, triangles, holes } = this.report.surface;
    const places = arrays.points(points, this.frame);
    this.surface = triangles.number ? new Surface(places, arrays.integers(triangles)) : null;
    this.cloud = triangles.number ? null : new Balls(places, new Float32Array(places.length / 3));
    this.holes = holes.number ? new Strips(arrays.points(holes, this.frame), holeColour) : null;
  }

  #scaled(radii) {
    return Float32Array.from(radii, (radius) => radius / this.frame.unit);
  }

  #salientBalls(points) {
    const centres = points.flatMap(({ x, y, z }) => [x, y, z].map((c, i) => this.frame.toScene(c, i)));
    return new Balls(new Float32Array(centres), this.#scaled(points.map(({ radius }) => radius)));
  }

  #tubes({ branches, points, radii }, arrays) {
    const places = arrays.points(points, this.frame);
    const scaled = this.#scaled(arrays.floats(radii));
    let first = 0;
    return new Tubes(branches.map(({ points: number }) => {
      const polyline = { points: [], radii: [] };
      for (let i = first; i < first + number; ++i) {
        polyline.points.push(new Vector3().fromArray(places, 3 * i));
        polyline.radii.push(scaled[i]);
      }
      first += number;
      return polyline;
    }));
  }

  #medialBalls({ points, radii, importance, mapt }, arrays) {
    const balls = new Balls(arrays.points(points, this.frame), this.#scaled(arrays.floats(radii)));
    balls.importance = arrays.floats(importance);
    balls.mapt = arrays.floats(mapt);
    return balls;
  }
}

// The maps: the joint one, and one for each radius, whose voxels are read when they are asked for.
class Maps {
  #read = new Map();

  constructor({ joint, of_radii: ofRadii }, arrays) {
    this.joint = joint;
    this.ofRadii = ofRadii;
    this.arrays = arrays;
  }

  get largest() {
    return this.joint.largest || 1;
  }

  // Of `joint` or the number of a radius; the joint map if there is no such radius.
  get(scale) {
    const name = this.ofRadii[scale] ? scale : 'joint';
    if (!this.#read.has(name)) {
      const entry = this.ofRadii[name] ?? this.joint;
      this.#read.set(name, { ...entry, size: entry.voxels.size, voxels: this.arrays.voxels(entry.voxels) });
    }
    return this.#read.get(name);
  }
}
