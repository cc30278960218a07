// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers for readers.

const minus = (text) => text.replace('-', '\u2212');

// Up to `digits` significant digits, no exponent where it can be avoided.
export function significant(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return minus(value.toExponential(digits - 1).replace(/\.?0+e/, 'e'));
  return minus(String(Number(value.toPrecision(digits))));
}

// As many decimals in each, so that they line up.
export function fixed(value, decimals = 2) {
  return value === null || Number.isNaN(value) ? '–' : minus(value.toFixed(decimals)).replace(/^\u2212(0\.?0*)$/, '$1');
}

// Lengths in a column: four digits of the largest, the same decimals for all.
export function lengthFormat(largest) {
  const decimals = Math.min(Math.max(3 - Math.floor(Math.log10(largest || 1)), 0), 8);
  return (value) => fixed(value, decimals);
}

export const percent = (part) => (part === null ? '–' : `${Math.round(100 * part)} %`);

export const count = (number) => number.toLocaleString('en').replace(/,/g, '\u202f');

export const seconds = (value) => `${value < 0.0995 ? value.toFixed(3) : value.toFixed(2)} s`;

// Round numbers over a range, about `wanted` of them.
export function ticks(low, high, wanted = 5) {
  const step = niceStep((high - low) / wanted);
  const result = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9); ++i) result.push(i * step);
  return result;
}

// The largest of 1, 2, 5 times a power of ten that is not larger than a length.
export function niceBelow(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].map((digit) => digit * power).find((step) => step <= length * (1 + 1e-9)) ?? power;
}

function niceStep(step) {
  const power = 10 ** Math.floor(Math.log10(step || 1));
  return [1, 2, 5, 10].map((digit) => digit * power).find((nice) => nice >= step * (1 - 1e-9));
}

// Half of the interval of the radius, or null where none is known.
export const uncertainty = (point) => (point.radius_high === null || point.radius_low === null
  ? null : (point.radius_high - point.radius_low) / 2);
