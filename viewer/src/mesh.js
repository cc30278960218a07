// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The surface: translucent, and the more opaque the more it is seen from the side, as glass is.

import { BufferAttribute, BufferGeometry, Color, FrontSide, BackSide, DoubleSide, GLSL3, Mesh, ShaderMaterial, Vector3 } from 'three';

const vertexShader = `
out vec3 viewNormal, place;
void main() {
  place = position;
  viewNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform vec3 colour, low, high;
uniform float opacity;
in vec3 viewNormal, place;
out vec4 result;
void main() {
  if (any(lessThan(place, low)) || any(greaterThan(place, high))) discard;
  vec3 n = normalize(viewNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  float facing = clamp(abs(n.z), 0.06, 1.0);
  float alpha = 1.0 - pow(1.0 - min(opacity, 0.999), 1.0 / facing);
  float light = 0.62 + 0.38 * max(dot(n, normalize(vec3(-0.4, 0.6, 0.7))), 0.0);
  float shine = 0.18 * pow(max(dot(n, normalize(vec3(-0.2, 0.35, 0.9))), 0.0), 40.0);
  vec3 c = colour * light * (gl_FrontFacing ? 1.0 : 0.8) + shine;
  result = vec4(c, opacity >= 0.995 ? 1.0 : alpha);
}`;

export class Surface {
  constructor(points, triangles) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points, 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
    geometry.computeVertexNormals();
    this.uniforms = {
      colour: { value: new Color() }, opacity: { value: 0.15 },
      low: { value: new Vector3() }, high: { value: new Vector3() },
    };
    this.back = this.#layer(geometry, BackSide);
    this.front = this.#layer(geometry, FrontSide);
    this.solid = this.#layer(geometry, DoubleSide);
    this.solid.material.depthWrite = true;
    this.solid.material.transparent = false;
  }

  #layer(geometry, side) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, side, transparent: true, depthWrite: false, uniforms: this.uniforms,
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
  }

  setOpacity(opacity) {
    this.uniforms.opacity.value = opacity;
    const isSolid = opacity >= 0.995;
    this.solid.visible = isSolid;
    this.back.visible = this.front.visible = !isSolid && opacity > 0;
  }

  setColour(colour) {
    this.uniforms.colour.value.setRGB(...colour);
  }

  setClip(low, high) {
    // A little more, so that faces in the plane of the box stay.
    this.uniforms.low.value.set(...low.map((x) => x - 1e-3));
    this.uniforms.high.value.set(...high.map((x) => x + 1e-3));
  }
}
