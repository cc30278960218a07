// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands beside the picture: controls, tables, plots, and how all of it was computed.

import { Controls, section } from './controls.js';
import { element } from './dom.js';
import { count, fixed, percent, seconds, significant } from './format.js';
import { gradient, mapPalettes, pointPalettes } from './palettes.js';
import { MapHistogram, descriptorPlot } from './plots.js';
import { PointTable, pairs, timings } from './tables.js';
import { keysOfPage } from './keys.js';

const plural = (number, one, many = `${one}s`) => `${count(number)} ${number === 1 ? one : many}`;

export function buildPanel(stage, state, content, lengths) {
  const controls = new Controls(state);
  const { report } = content;
  return element('aside', { class: 'panel', 'aria-label': 'Controls and results' },
    header(report),
    mapSection(controls, content, lengths),
    section('Surface', {},
      controls.slider(content.cloud ? 'points' : 'opacity', 'mesh', { min: 0, max: 1, step: 0.01, text: percent }),
      content.holes ? controls.toggle(`edges of holes (${count(report.input.boundary_edges)})`, 'holes') : null,
      report.surface.joined_within > 0 ? element('p', {}, `Drawn with ${count(report.surface.triangles.number / 3)} of ${count(report.input.triangles)} faces; results are of all of them.`) : null),
    content.salient ? pointSection(controls, stage, content) : missing('Salient points', report.salient),
    content.lines ? lineSection(controls, report, lengths) : missing('Centrelines', report.lines),
    content.medial ? ballSection(controls, content, lengths) : missing('Medial balls', report.medial),
    clipSection(controls, content),
    descriptorSection(report.descriptor, lengths),
    parameterSection(report, lengths),
    section('Times', { isOpen: false, note: seconds(Object.values(report.steps).reduce((a, b) => a + b, 0)) }, timings(Object.entries(report.steps), seconds)),
    section('Keys', { isOpen: false }, keysOfPage()),
    element('footer', {}, `mapt ${report.version}. Lengths are in the units of the mesh. Values of maps are rounded to 8 bits here; mapt transform writes them in full.`));
}

function header({ name, input, is_point_set: isPointSet, warnings }) {
  const facts = isPointSet
    ? plural(input.vertices, 'point')
    : [plural(input.faces, 'face'), plural(input.vertices, 'vertex', 'vertices'),
      input.is_closed ? 'closed' : `open, ${plural(input.holes, 'hole')}`,
      input.components > 1 ? plural(input.components, 'part') : null].filter(Boolean).join(' · ');
  return element('header', {}, element('h1', {}, name), element('p', {}, facts),
    warnings.length ? element('ul', { class: 'warnings' }, warnings.map((text) => element('li', {}, text))) : null);
}

// A part that was left out is null; one in which nothing was found is not.
function missing(title, part) {
  return part === null ? null : section(title, { note: 'none found' });
}

function mapSection(controls, content, lengths) {
  const { state } = controls;
  const { maps } = content;
  const step = Number((maps.largest / 200).toPrecision(1));
  const last = maps.ofRadii.length - 1;
  const histogram = new MapHistogram();
  const update = () => histogram.show(maps.get(state.get('scale')), {
    threshold: state.get('threshold'), top: maps.largest, palette: state.get('palette'),
    marks: content.marksOf(state.get('scale')),
  });
  state.watch((changed) => { if (['scale', 'threshold', 'palette'].some((key) => changed.has(key))) update(); });
  update();
  return section('Map', {},
    controls.slider('radius', 'scale', {
      min: -1, max: last, step: 1,
      toValue: (place) => (Number(place) < 0 ? 'joint' : place),
      toPlace: (scale) => (maps.ofRadii[scale] ? Number(scale) : -1),
      text: (scale) => (maps.ofRadii[scale] ? lengths(maps.ofRadii[scale].radius) : 'all (joint)'),
    }),
    controls.slider('opacity', 'map', { min: 0, max: 1, step: 0.01, text: percent }),
    controls.slider('values from', 'threshold', { min: 0, max: maps.largest, step, text: (v) => fixed(v, 3) }),
    controls.slider('up to', 'top', { min: step, max: maps.largest, step, text: (v) => fixed(v, 3) }),
    controls.select('colours', 'palette', mapPalettes.map((name) => [name, name])),
    controls.toggle('largest value along each ray', 'mip'),
    histogram.root);
}

function pointSection(controls, stage, { report }) {
  const { state } = controls;
  const table = new PointTable(report.salient, {
    onPoint: (index) => stage.markPoint(index),
    onSelect: (index) => state.set({ select: state.get('select') === index ? -1 : index }),
  });
  const strip = element('i', {}), low = element('span', {}), high = element('span', {});
  const update = (changed) => {
    const has = (...keys) => !changed || keys.some((key) => changed.has(key));
    if (has('select')) table.select(state.get('select'));
    if (has('pointmin')) table.show((index) => stage.isPointShown(index));
    if (!has('pointcolour', 'pointpalette')) return;
    strip.style.background = gradient(state.get('pointpalette'), 'to right');
    const [from, to] = stage.rangeOfPoints(state.get('pointcolour'));
    low.textContent = significant(from, 3);
    high.textContent = significant(to, 3);
  };
  state.watch(update);
  update(null);
  const largest = Math.max(...report.salient.map(({ intensity }) => intensity));
  return section('Salient points', { toggle: controls.toggle(count(report.salient.length), 'points') },
    controls.slider('size', 'pointsize', { min: 0, max: 1, step: 0.05, text: (v) => `${fixed(v)} R` }),
    controls.slider('MAPT from', 'pointmin', { min: 0, max: largest, step: 0.01, text: fixed }),
    controls.select('colour', 'pointcolour', [['sphericity', 'sphericity'], ['intensity', 'MAPT (intensity)'], ['radius', 'radius'], ['observed_fraction', 'part that is seen']]),
    controls.select('palette', 'pointpalette', pointPalettes.map((name) => [name, name === 'blue-red' ? 'blue to red (paper)' : 'blue to orange'])),
    element('div', { class: 'key-bar' }, low, strip, high),
    table.root);
}

function lineSection(controls, { lines }, lengths) {
  const length = lines.branches.reduce((sum, branch) => sum + branch.length, 0);
  return section('Centrelines', { toggle: controls.toggle(count(lines.branches.length), 'lines') },
    controls.slider('thickness', 'linesize', { min: 0, max: 1, step: 0.02, text: (v) => (v === 0 ? 'thin' : `${fixed(v)} R`) }),
    element('p', {}, `${plural(lines.branches.length, 'branch', 'branches')}, ${significant(length)} long together; mean radii from ${lengths(Math.min(...lines.branches.map((b) => b.mean_radius)))} to ${lengths(Math.max(...lines.branches.map((b) => b.mean_radius)))}.`));
}

function ballSection(controls, { report, medial }, lengths) {
  const most = Math.max(...medial.importance);
  return section('Medial balls', { toggle: controls.toggle(count(medial.number), 'balls'), isOpen: false },
    controls.slider('size', 'ballsize', { min: 0, max: 1, step: 0.01, text: (v) => `${fixed(v)} R` }),
    controls.slider('importance', 'ballmin', { min: 0, max: most, step: most / 200, text: (v) => (v === 0 ? 'all' : `≥ ${lengths(v)}`) }),
    element('p', {}, `The ${count(medial.number)} most important ones of ${count(report.medial.found)} that are not next to each other. Their colours are those of the map.`));
}

function clipSection(controls, { report }) {
  const { min, max } = report.input.box;
  const text = (axis) => (low, high) => (low === 0 && high === 1 ? 'all' : [low, high].map((part) => significant(min[axis] + part * (max[axis] - min[axis]), 3)).join(' to '));
  return section('Cut', { isOpen: false },
    ['x', 'y', 'z'].map((name, axis) => controls.range(name, 'clip', axis, text(axis))),
    element('p', {}, 'Of the surface and the map; points and lines stay whole.'));
}

function descriptorSection(descriptor, lengths) {
  if (descriptor === null) return null;
  if (descriptor.missing) return section('Shape descriptor', { isOpen: false, note: 'none' }, element('p', {}, descriptor.missing));
  return section('Shape descriptor', { isOpen: false, note: plural(descriptor.values.length, 'number') },
    descriptorPlot(descriptor, lengths),
    element('p', {}, `How many of the ${count(descriptor.voxels)} voxels inside have which value at each radius (HAPT); heights are square roots.`));
}

function parameterSection({ parameters: p, grid, input, coverage }, lengths) {
  const box = input.box.max.map((x, i) => significant(x - input.box.min[i], 4)).join(' × ');
  return section('Parameters', { isOpen: false }, pairs([
    ['side', p.side],
    ['radii', `${p.radii.length}: ${lengths(p.radii[0])} to ${lengths(p.radii.at(-1))}`],
    ['σ', p.sigma ? lengths(p.sigma) : `${p.sigma_ratio} R`],
    ['grid', `${grid.size.join(' × ')} voxels`],
    ['voxel', significant(grid.spacing)],
    ['region', `${p.region}, ${plural(grid.region_voxels, 'voxel')}`],
    ['coverage', coverage === undefined ? null : percent(coverage)],
    ['box', box],
    ['area', significant(input.area)],
    ['volume', input.volume === null ? null : significant(input.volume)],
    ['genus', input.genus],
    ['file', input.file],
    ['threads', p.threads],
  ]));
}
