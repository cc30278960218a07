// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Spheres of any number: a square each, on which the fragment shader computes the sphere, its depth included.

import { GLSL3, InstancedBufferAttribute, InstancedBufferGeometry, BufferAttribute, Mesh, ShaderMaterial } from 'three';

const vertexShader = `
in vec3 centre, tint;
in float radius, isShown;
uniform float scale, least;
out vec2 place;
out vec3 colour;
out vec3 viewCentre;
out float shownRadius;
void main() {
  place = position.xy;
  colour = tint;
  shownRadius = max(scale * radius, least);
  viewCentre = (modelViewMatrix * vec4(centre, 1.0)).xyz;
  vec4 corner = vec4(viewCentre + vec3(place * shownRadius, 0.0), 1.0);
  gl_Position = isShown > 0.5 ? projectionMatrix * corner : vec4(2.0, 2.0, 2.0, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform mat4 projectionMatrix;
in vec2 place;
in vec3 colour, viewCentre;
in float shownRadius;
out vec4 result;
void main() {
  float d = dot(place, place);
  if (d > 1.0) discard;
  vec3 n = vec3(place, sqrt(1.0 - d));
  vec4 clip = projectionMatrix * vec4(viewCentre + shownRadius * n, 1.0);
  gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
  float light = 0.55 + 0.45 * max(dot(n, normalize(vec3(-0.4, 0.6, 0.7))), 0.0);
  float shine = 0.25 * pow(max(dot(n, normalize(vec3(-0.2, 0.35, 0.9))), 0.0), 30.0);
  result = vec4(colour * light + shine, 1.0);
}`;

export class Balls {
  // Coordinates and radii in units of the scene.
  constructor(centres, radii) {
    const number = radii.length;
    this.centres = centres;
    this.radii = radii;
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = number;
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.tint = new InstancedBufferAttribute(new Float32Array(3 * number).fill(0.7), 3);
    this.isShown = new InstancedBufferAttribute(new Float32Array(number).fill(1), 1);
    geometry.setAttribute('centre', new InstancedBufferAttribute(centres, 3));
    geometry.setAttribute('radius', new InstancedBufferAttribute(radii, 1));
    geometry.setAttribute('tint', this.tint);
    geometry.setAttribute('isShown', this.isShown);
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: { scale: { value: 1 }, least: { value: 0 } },
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  get uniforms() {
    return this.object.material.uniforms;
  }

  get number() {
    return this.radii.length;
  }

  shownRadius(i) {
    return Math.max(this.uniforms.scale.value * this.radii[i], this.uniforms.least.value);
  }

  // Of each ball: a colour, and whether it is there.
  paint(colourOf, isShown) {
    for (let i = 0; i < this.number; ++i) {
      this.tint.array.set(colourOf(i), 3 * i);
      this.isShown.array[i] = isShown(i) ? 1 : 0;
    }
    this.tint.needsUpdate = this.isShown.needsUpdate = true;
  }
}
