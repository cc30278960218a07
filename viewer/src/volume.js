// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The map as a cloud: a ray marcher. A ray runs from t = 0 at the near plane to t = 1 at the far one; in parallel
// projection t is also the depth of what is opaque, where rays end.

import {
  Data3DTexture, DataTexture, GLSL3, LinearFilter, Mesh, NearestFilter, PlaneGeometry, RedFormat,
  ShaderMaterial, Vector3,
} from 'three';
import { table } from './palettes.js';

const blockSize = 8; // voxels along the side of a block, which is skipped if nothing in it is seen

const vertexShader = `
out vec2 place;
void main() {
  place = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragmentShader = `
precision highp float;
precision highp sampler3D;

uniform sampler3D map, blocks;
uniform sampler2D palette, depth;
uniform mat4 fromClip;                  // to coordinates of the grid, from 0 to 1
uniform vec3 size;                      // of the grid, in voxels
uniform vec3 low, high;                 // what is shown of it
uniform float largest;                  // the value of 255
uniform float threshold, top, opacity;
uniform float stepLength;               // in voxels of the map
uniform float unit;                     // the side of one, in voxels of the grid: opacity is for the length of those
uniform float jitter;
uniform bool isMaximum;

in vec2 place;
out vec4 result;

// Where along the ray the box begins and ends.
vec2 crossing(vec3 start, vec3 direction, vec3 low, vec3 high) {
  vec3 a = (low - start) / direction, b = (high - start) / direction;
  vec3 near = min(a, b), far = max(a, b);
  return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

void main() {
  vec2 clip = 2.0 * place - 1.0;
  vec4 nearPoint = fromClip * vec4(clip, -1.0, 1.0), farPoint = fromClip * vec4(clip, 1.0, 1.0);
  vec3 start = nearPoint.xyz, direction = farPoint.xyz - start;
  direction += vec3(lessThan(abs(direction), vec3(1e-7))) * 1e-7;

  vec2 inside = crossing(start, direction, low, high);
  float end = min(min(inside.y, texture(depth, place).r), 1.0);
  float dt = stepLength / length(direction * size);
  float t = max(inside.x, 0.0) + dt * fract(noise(gl_FragCoord.xy) + jitter);

  vec3 perBlock = size / ${blockSize.toFixed(1)};
  float seen = isMaximum ? max(threshold, 0.0) : threshold;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4096 && t < end; ++i) {
    vec3 p = start + t * direction;
    vec3 block = floor(p * perBlock);
    float most = largest * texelFetch(blocks, ivec3(block), 0).r;
    if (most <= seen) { // on to the next block
      vec3 ends = (block + step(0.0, direction)) / perBlock;
      vec3 leave = (ends - start) / direction;
      float past = min(min(leave.x, leave.y), leave.z) - t;
      t += dt * max(ceil(past / dt), 1.0);
      continue;
    }
    float value = largest * texture(map, p).r;
    if (value > seen) {
      if (isMaximum) {
        seen = value;
      } else {
        float x = clamp((value - threshold) / max(top - threshold, 1e-6), 0.0, 1.0);
        float alpha = 1.0 - pow(1.0 - 0.98 * opacity * pow(x, 1.3), stepLength * unit);
        vec3 colour = texture(palette, vec2(0.5 / 256.0 + value / top * 255.0 / 256.0, 0.5)).rgb;
        sum += (1.0 - sum.a) * vec4(alpha * colour, alpha);
        if (sum.a > 0.99) break;
      }
    }
    t += dt;
  }
  if (isMaximum && seen > threshold) {
    float x = clamp(seen / top, 0.0, 1.0);
    float alpha = opacity * smoothstep(threshold / top, threshold / top + 0.25, x);
    sum = alpha * vec4(texture(palette, vec2(0.5 / 256.0 + x * 255.0 / 256.0, 0.5)).rgb, 1.0);
  }
  result = sum;
}`;

// The largest value in each block of voxels and next to it, since values are interpolated.
function blockMaxima(voxels, size) {
  const number = size.map((n) => Math.ceil(n / blockSize));
  const maxima = new Uint8Array(number[0] * number[1] * number[2]);
  const reach = (i, n) => [Math.max(Math.floor((i - 1) / blockSize), 0), Math.min(Math.floor((i + 1) / blockSize), n - 1)];
  for (let k = 0, at = 0; k < size[2]; ++k)
    for (let j = 0; j < size[1]; ++j)
      for (let i = 0; i < size[0]; ++i, ++at) {
        const value = voxels[at];
        if (value === 0) continue;
        const [i0, i1] = reach(i, number[0]), [j0, j1] = reach(j, number[1]), [k0, k1] = reach(k, number[2]);
        for (let c = k0; c <= k1; ++c)
          for (let b = j0; b <= j1; ++b)
            for (let a = i0; a <= i1; ++a) {
              const block = a + number[0] * (b + number[1] * c);
              if (maxima[block] < value) maxima[block] = value;
            }
      }
  return { maxima, number };
}

function texture3D(bytes, size, filter) {
  const texture = new Data3DTexture(bytes, ...size);
  texture.format = RedFormat;
  texture.minFilter = texture.magFilter = filter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

export class Volume {
  // `grid` is that of the report; `frame` brings it into the scene.
  constructor(grid, frame) {
    this.origin = grid.origin.map((x, i) => frame.toScene(x, i));
    this.spacing = grid.spacing / frame.unit;
    this.bounds = [[-9, -9, -9], [9, 9, 9]];
    this.palette = new DataTexture(table('viridis'), 256, 1);
    this.palette.minFilter = this.palette.magFilter = LinearFilter;
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        map: { value: null }, blocks: { value: null }, palette: { value: this.palette }, depth: { value: null },
        fromClip: { value: null }, size: { value: new Vector3() },
        low: { value: new Vector3() }, high: { value: new Vector3() },
        largest: { value: 1 }, threshold: { value: 0 }, top: { value: 1 }, opacity: { value: 1 },
        stepLength: { value: 1 }, unit: { value: 1 }, jitter: { value: 0 }, isMaximum: { value: false },
      },
    });
    this.object = new Mesh(new PlaneGeometry(2, 2), this.material);
    this.object.frustumCulled = false;
  }

  get uniforms() {
    return this.material.uniforms;
  }

  show({ voxels, size, stride, largest }) {
    const { uniforms } = this;
    uniforms.map.value?.dispose();
    uniforms.blocks.value?.dispose();
    const { maxima, number } = blockMaxima(voxels, size);
    uniforms.map.value = texture3D(voxels, size, LinearFilter);
    uniforms.blocks.value = texture3D(maxima, number, NearestFilter);
    uniforms.largest.value = largest;
    uniforms.size.value.set(...size);
    // Texels are at the middles of voxels, the first one at the origin.
    const spacing = stride * this.spacing;
    this.stride = stride;
    this.low = this.origin.map((x) => x - spacing / 2);
    this.extent = size.map((n) => n * spacing);
    this.setClip(...this.bounds);
  }

  // In voxels of the whole grid.
  set stepLength(voxels) {
    this.uniforms.stepLength.value = voxels / this.stride;
    this.uniforms.unit.value = this.stride;
  }

  setPalette(name) {
    this.palette.image.data.set(table(name));
    this.palette.needsUpdate = true;
  }

  // The part of the box that is shown: corners in the scene.
  setClip(low, high) {
    this.bounds = [low, high];
    const toGrid = (corner) => corner.map((x, i) => Math.min(Math.max((x - this.low[i]) / this.extent[i], 0), 1));
    this.uniforms.low.value.set(...toGrid(low));
    this.uniforms.high.value.set(...toGrid(high));
  }

  setCamera(camera) {
    const toGrid = camera.matrixWorld.clone().multiply(camera.projectionMatrixInverse);
    const e = toGrid.elements;
    for (let column = 0; column < 4; ++column)
      for (let i = 0; i < 3; ++i)
        e[4 * column + i] = (e[4 * column + i] - (column === 3 ? this.low[i] : 0)) / this.extent[i];
    this.uniforms.fromClip.value = toGrid;
  }
}
