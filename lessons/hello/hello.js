#!/usr/bin/env node
// The ray of one pixel, and the first thing that it meets: hello.js FLAT.json X Y WIDTH HEIGHT
"use strict";
const fs = require("fs");

const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (s, a) => a.map((x) => s * x);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => mul(1 / Math.sqrt(dot(a, a)), a);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

// Each gives t, where the ray o + t d crosses the shape, and the normal there; or nothing.
function plane(o, d, point, n) {
  if (dot(n, d) !== 0) return { t: dot(n, sub(point, o)) / dot(n, d), n };
}

function triangle(o, d, [a, b, c]) {
  const n = unit(cross(sub(b, a), sub(c, a)));
  const hit = plane(o, d, a, n);
  if (!hit) return;
  const p = add(o, mul(hit.t, d));
  const left = ([from, to]) => dot(n, cross(sub(to, from), sub(p, from))) >= 0;
  if ([[a, b], [b, c], [c, a]].every(left)) return hit;
}

function sphere(o, d, c, r) {
  const f = sub(o, c);
  const b = -dot(d, f);
  const root = b * b - (dot(f, f) - r * r);
  if (root < 0) return;
  const near = b - Math.sqrt(root);
  const t = near > 0 ? near : b + Math.sqrt(root);
  return { t, n: unit(sub(add(o, mul(t, d)), c)) };
}

function meet(o, d, s) {
  if (s.kind === "plane") return plane(o, d, s.point, s.normal);
  if (s.kind === "triangle") return triangle(o, d, s.corners);
  if (s.kind === "sphere") return sphere(o, d, s.center, s.radius);
}

const scene = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
const [x, y, width, height] = process.argv.slice(3, 7).map(Number);
const { eye: o, u, v, w, half_height } = scene.camera;
const right = ((2 * (x + 0.5)) / width - 1) * half_height * (width / height);
const up = (1 - (2 * (y + 0.5)) / height) * half_height;
const d = unit(sub(add(mul(right, u), mul(up, v)), w));
const root = { kind: "I", origin: o, direction: d, outcome: "miss" };
let t = Infinity;
for (const s of scene.objects) {
  const hit = meet(o, d, s);
  if (!hit || hit.t <= 0 || hit.t >= t) continue;
  t = hit.t;
  const n = dot(hit.n, d) < 0 ? hit.n : mul(-1, hit.n);
  root.outcome = "hit";
  root.hit = { t, object: s.name, point: add(o, mul(t, d)), geometric_normal: n };
}
console.log(JSON.stringify({ pixel: { x, y }, root }));
