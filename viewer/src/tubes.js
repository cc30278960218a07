// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lines as tubes around them: as thin as `least`, or as thick as a part of the radius that they have.

import { BufferAttribute, BufferGeometry, Color, GLSL3, Mesh, ShaderMaterial, Vector3 } from 'three';

const sides = 10;

const vertexShader = `
in vec3 outward;
in float radius;
uniform float scale, least;
out vec3 viewNormal;
void main() {
  viewNormal = normalMatrix * outward;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + max(scale * radius, least) * outward, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform vec3 colour;
in vec3 viewNormal;
out vec4 result;
void main() {
  vec3 n = normalize(viewNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  result = vec4(colour * (0.6 + 0.4 * max(dot(n, normalize(vec3(-0.4, 0.6, 0.7))), 0.0)), 1.0);
}`;

// A frame at each point that turns as little as it can from one to the next.
function frames(points) {
  const tangents = points.map((_, i) => {
    const direction = points[Math.min(i + 1, points.length - 1)].clone().sub(points[Math.max(i - 1, 0)]);
    return direction.lengthSq() > 0 ? direction.normalize() : new Vector3(0, 0, 1);
  });
  let normal = new Vector3(1, 0, 0).cross(tangents[0]);
  if (normal.lengthSq() < 0.01) normal = new Vector3(0, 1, 0).cross(tangents[0]);
  return tangents.map((tangent) => {
    normal = normal.clone().addScaledVector(tangent, -normal.dot(tangent)).normalize();
    return [normal, tangent.clone().cross(normal)];
  });
}

export class Tubes {
  // Each polyline is { points: [Vector3], radii: [number] }, in units of the scene.
  constructor(polylines) {
    this.polylines = polylines;
    const position = [], outward = [], radius = [], index = [];
    for (const { points, radii } of polylines) {
      const first = radius.length;
      frames(points).forEach(([u, v], i) => {
        for (let k = 0; k < sides; ++k) {
          const angle = (2 * Math.PI * k) / sides;
          position.push(...points[i].toArray());
          outward.push(...u.clone().multiplyScalar(Math.cos(angle)).addScaledVector(v, Math.sin(angle)).toArray());
          radius.push(radii[i]);
        }
        if (i === 0) return;
        for (let k = 0; k < sides; ++k) {
          const a = first + (i - 1) * sides + k, b = first + (i - 1) * sides + ((k + 1) % sides);
          index.push(a, b, a + sides, b, b + sides, a + sides);
        }
      });
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
    geometry.setAttribute('outward', new BufferAttribute(new Float32Array(outward), 3));
    geometry.setAttribute('radius', new BufferAttribute(new Float32Array(radius), 1));
    geometry.setIndex(new BufferAttribute(new Uint32Array(index), 1));
    this.object = new Mesh(geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, side: 2,
      uniforms: { colour: { value: new Color() }, scale: { value: 0 }, least: { value: 0.005 } },
    }));
    this.object.frustumCulled = false;
  }

  get uniforms() {
    return this.object.material.uniforms;
  }
}
