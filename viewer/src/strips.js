// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments of a width in pixels, drawn as a rectangle each.

import { BufferAttribute, Color, GLSL3, InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial, Vector2 } from 'three';

const vertexShader = `
in vec3 from, to;
uniform vec2 pixels;                    // of the picture
uniform float width;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0), b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  vec2 along = (b.xy - a.xy) * pixels;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  gl_Position = position.x < 0.0 ? a : b;
  gl_Position.xy += width * (position.x * along + position.y * across) / pixels;
  gl_Position.z -= 1e-3;                // before the surface that it bounds
}`;

const fragmentShader = `
precision highp float;
uniform vec3 colour;
out vec4 result;
void main() { result = vec4(colour, 1.0); }`;

export class Strips {
  // Two points for each segment, as coordinates in the scene.
  constructor(ends, colour) {
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = ends.length / 6;
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const buffer = new InstancedInterleavedBuffer(ends, 6);
    geometry.setAttribute('from', new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute('to', new InterleavedBufferAttribute(buffer, 3, 3));
    this.object = new Mesh(geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader,
      uniforms: { colour: { value: new Color().setRGB(...colour) }, pixels: { value: new Vector2(1, 1) }, width: { value: 2 } },
    }));
    this.object.frustumCulled = false;
  }

  get uniforms() {
    return this.object.material.uniforms;
  }
}
