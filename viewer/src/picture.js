// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the scene: what is opaque, the far side of the surface, the cloud of the map, the near side. While anything
// moves, in as many pixels as are quick enough; when still, in all of them, and then some times more with pixels and
// rays a little displaced, whose mean has smooth edges and no noise.

import {
  ColorManagement, Color, DepthTexture, GLSL3, HalfFloatType, LinearFilter, LinearSRGBColorSpace, Mesh, NearestFilter,
  OneFactor, OneMinusSrcAlphaFactor, CustomBlending, NoBlending, PlaneGeometry, Scene, ShaderMaterial, UnsignedIntType,
  Vector2, WebGLRenderer, WebGLRenderTarget,
} from 'three';

const secondsWhileMoving = 0.06;
const secondsToRefine = 2.5;
const mostPasses = 16;

// Draws a texture over everything.
function overlay(fragment, settings, uniforms) {
  const material = new ShaderMaterial({
    glslVersion: GLSL3, depthTest: false, depthWrite: false, transparent: true, ...settings,
    uniforms: { image: { value: null }, ...uniforms },
    vertexShader: 'out vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader: `precision highp float; uniform sampler2D image; uniform float part; in vec2 place; out vec4 result;
                     void main() { ${fragment} }`,
  });
  const mesh = new Mesh(new PlaneGeometry(2, 2), material);
  mesh.frustumCulled = false;
  const scene = new Scene();
  scene.add(mesh);
  return { scene, uniforms: material.uniforms };
}

export class Picture {
  constructor(canvas, view, volume, surface) {
    ColorManagement.enabled = false;
    this.canvas = canvas;
    this.view = view;
    this.volume = volume;
    this.surface = surface;
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.gl = this.renderer.getContext();
    this.background = new Color();
    this.opaque = new Scene();
    this.farSide = new Scene();
    this.nearSide = new Scene();
    this.cloud = new Scene();
    this.cloud.add(volume.object);
    if (surface) {
      this.opaque.add(surface.solid);
      this.farSide.add(surface.back);
      this.nearSide.add(surface.front);
    }
    this.over = overlay('result = texture(image, place);',
      { blending: CustomBlending, blendSrc: OneFactor, blendDst: OneMinusSrcAlphaFactor });
    this.copy = overlay('result = vec4(texture(image, place).rgb, 1.0);', { blending: NoBlending });
    this.average = overlay('result = vec4(texture(image, place).rgb, part);', {}, { part: { value: 1 } });
    this.canAverage = Boolean(this.gl.getExtension('EXT_color_buffer_float'));
    this.targets = null;
    this.part = 0.5; // of the pixels along a side, while moving
    this.passes = 0; // since the last change
    this.spent = 0; // seconds, on these
    this.isRequested = false;
    this.timer = 0;
    this.onPass = () => {};
  }

  // Something has changed: draws soon, and refines when nothing has changed for a moment.
  request() {
    this.passes = 0;
    clearTimeout(this.timer);
    if (this.isRequested) return;
    this.isRequested = true;
    requestAnimationFrame(() => {
      this.isRequested = false;
      this.#drawWhileMoving();
      this.#refineLater(this.view.isDragged ? 250 : 90);
    });
  }

  get isRefined() {
    return this.passes >= mostPasses || this.spent > secondsToRefine && this.passes > 1;
  }

  #refineLater(milliseconds) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (this.view.isDragged) return this.#refineLater(100);
      this.#refine();
    }, milliseconds);
  }

  #drawWhileMoving() {
    const ratio = Math.min(window.devicePixelRatio, 1.5);
    this.#resize(ratio * this.part);
    this.volume.stepLength = this.part < 0.7 ? 1.6 : 1;
    const start = performance.now();
    this.#draw(0);
    this.#show(this.targets.frame);
    this.#finish();
    // Half of the way to what would take the time that there is.
    const wanted = this.part * Math.sqrt(secondsWhileMoving / Math.max((performance.now() - start) / 1000, 1e-3));
    this.part = Math.min(Math.max((this.part + wanted) / 2, 0.2), 1);
  }

  #refine() {
    this.#resize(Math.min(window.devicePixelRatio, 2));
    this.volume.stepLength = 0.7;
    const start = performance.now();
    this.#draw(this.passes);
    if (this.canAverage) {
      this.average.uniforms.image.value = this.targets.frame.texture;
      this.average.uniforms.part.value = 1 / (this.passes + 1);
      this.#render(this.average.scene, this.targets.mean);
    }
    this.#show(this.canAverage ? this.targets.mean : this.targets.frame);
    this.#finish();
    this.spent = (this.passes === 0 ? 0 : this.spent) + (performance.now() - start) / 1000;
    ++this.passes;
    if (!this.canAverage) this.passes = mostPasses;
    this.onPass(this.isRefined);
    if (!this.isRefined) this.timer = setTimeout(() => this.#refine(), 0);
  }

  #resize(ratio) {
    const width = Math.max(Math.round(this.canvas.clientWidth * ratio), 1);
    const height = Math.max(Math.round(this.canvas.clientHeight * ratio), 1);
    if (this.targets?.frame.width === width && this.targets.frame.height === height) return;
    for (const target of Object.values(this.targets ?? {})) target.dispose();
    this.renderer.setSize(width, height, false);
    const depthTexture = new DepthTexture(width, height, UnsignedIntType);
    depthTexture.minFilter = depthTexture.magFilter = NearestFilter;
    this.targets = {
      frame: new WebGLRenderTarget(width, height, { depthTexture, minFilter: LinearFilter }),
      cloud: new WebGLRenderTarget(width, height, { depthBuffer: false }),
      mean: new WebGLRenderTarget(width, height, { depthBuffer: false, type: HalfFloatType }),
    };
    this.opaque.traverse(({ material }) => material?.uniforms.pixels?.value.set(width, height));
  }

  #render(scene, target) {
    this.renderer.setRenderTarget(target);
    this.renderer.render(scene, this.view.camera);
  }

  // One pass; those after the first one have their pixels displaced, by the low-discrepancy sequence of Roberts.
  #draw(pass) {
    const camera = this.view.camera;
    this.view.update();
    const { width, height } = this.targets.frame;
    const shift = new Vector2((pass * 0.7548776662) % 1, (pass * 0.569840291) % 1).subScalar(pass === 0 ? 0 : 0.5);
    camera.setViewOffset(width, height, shift.x, shift.y, width, height);
    camera.updateProjectionMatrix();

    this.renderer.setRenderTarget(this.targets.frame);
    this.renderer.setClearColor(this.background, 1);
    this.renderer.clear();
    this.#render(this.opaque, this.targets.frame);
    this.#render(this.farSide, this.targets.frame);
    if (this.volume.uniforms.opacity.value > 0) {
      this.volume.setCamera(camera);
      this.volume.uniforms.depth.value = this.targets.frame.depthTexture;
      this.volume.uniforms.jitter.value = (pass * 0.618034) % 1;
      this.renderer.setRenderTarget(this.targets.cloud);
      this.renderer.setClearColor(0, 0);
      this.renderer.clear();
      this.#render(this.cloud, this.targets.cloud);
      this.over.uniforms.image.value = this.targets.cloud.texture;
      this.#render(this.over.scene, this.targets.frame);
    }
    this.#render(this.nearSide, this.targets.frame);
    camera.clearViewOffset();
  }

  #show(target) {
    this.copy.uniforms.image.value = target.texture;
    this.#render(this.copy.scene, null);
  }

  // Waits until the picture is there, so that times are true.
  #finish() {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}
