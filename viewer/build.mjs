// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the page of mapt report, without its data, as one file: node build.mjs [FILE]. The same sources make the
// same bytes. What the page may do is fixed by the hashes of its script and its style.

import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2] ?? join(folder, 'dist', 'viewer.html');

const sha256 = (text, encoding) => createHash('sha256').update(text).digest(encoding);
const policyHash = (text) => `sha256-${sha256(text, 'base64')}`;

// What the page is made of, in a fixed order: a test finds out whether it was built since they changed.
function hashOfSources() {
  const names = ['build.mjs', 'package-lock.json', 'package.json', 'template.html', 'viewer.css',
    ...readdirSync(join(folder, 'src')).sort().map((name) => `src/${name}`)];
  return sha256(names.map((name) => `${name} ${sha256(readFileSync(join(folder, name)), 'hex')}\n`).join(''), 'hex');
}

// Within a script element these would end it, or hide its end. They occur in strings and comments only.
const inScript = (text) => text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');

async function bundle(entry, settings) {
  const result = await build({ entryPoints: [join(folder, entry)], bundle: true, minify: true, write: false, legalComments: 'none', target: ['chrome94', 'firefox113', 'safari16.4'], ...settings });
  return result.outputFiles[0].text.trim();
}

const script = inScript(await bundle('src/main.js', { format: 'esm' }));
const style = await bundle('viewer.css', {});
const ofThree = (name) => readFileSync(join(folder, 'node_modules/three', name), 'utf8').trim();
const parts = {
  THREE_VERSION: JSON.parse(ofThree('package.json')).version,
  THREE_LICENCE: ofThree('LICENSE'), // which asks to be part of each copy
  SCRIPT_HASH: policyHash(script),
  STYLE_HASH: policyHash(style),
  SOURCES_HASH: hashOfSources(),
  STYLE: style,
  SCRIPT: script,
};
const page = readFileSync(join(folder, 'template.html'), 'utf8')
  .replace(/@(THREE_VERSION|THREE_LICENCE|SCRIPT_HASH|STYLE_HASH|SOURCES_HASH|STYLE|SCRIPT)@/g, (_, name) => parts[name]);
mkdirSync(dirname(output), { recursive: true });
writeFileSync(output, page);
console.log(`${output}: ${Math.round(page.length / 1000)} kB`);
