// Record hook: put this file beside your ray tracer, and it writes the ray trees that `raytree diff` and the debugger read.
// Nothing is written unless the environment says where: RAYTREE_RECORD=rays.json RAYTREE_PIXEL=160,100 node your_tracer.js
// Without RAYTREE_PIXEL every pixel is recorded. In a browser set `globalThis.raytreeLines = []` before: the lines go there.
const env = globalThis.process?.env ?? {};
const fs = env.RAYTREE_RECORD ? require("fs") : null;
let pixel = null, open = [], count = 0;

if (fs) fs.writeFileSync(env.RAYTREE_RECORD, "");

function write(line) {
  const text = JSON.stringify(line, (name, value) => value ?? undefined);
  if (fs) fs.appendFileSync(env.RAYTREE_RECORD, text + "\n");
  else globalThis.raytreeLines.push(text);
}

/** Before the eye ray of a pixel. */
function pixelBegin(x, y) {
  const wanted = env.RAYTREE_PIXEL ?? `${x},${y}`;
  pixel = (fs || globalThis.raytreeLines) && wanted === `${x},${y}` ? [x, y] : null;
  [open, count] = [[], 0];
}

/** A ray is sent: I from the eye, L to the light of this name, R reflected, T transmitted, both with their weight. */
function rayBegin(kind, origin, direction, light = null, weight = null) {
  if (pixel) open.push({ pixel, id: count++, parent: open.at(-1)?.id, kind, light, origin, direction, weight: kind === "I" ? [1, 1, 1] : weight, terms: [] });
}

/** The ray meets a thing of this name; of an L ray: it is in the way. */
function hit(t, object, point = null, normal = null) {
  if (pixel) open.at(-1).hit = { t, object, point, normal };
}

/** The ray's radiance grows by an ambient, diffuse, specular, emission or background term. */
function term(name, value, light = null) {
  if (pixel) open.at(-1).terms.push({ term: name, value, light });
}

/** The ray is done, and so are those that it sent. */
function rayEnd(radiance = null) {
  if (!pixel) return;
  const ray = open.pop(), words = ray.kind === "L" ? ["lit", "blocked"] : ["miss", "hit"];
  write({ ...ray, outcome: words[ray.hit ? 1 : 0], radiance, terms: ray.terms.length ? ray.terms : null });
}

/** After the eye ray: linear red, green and blue of the pixel. */
function pixelEnd(color) {
  if (pixel) write({ pixel, color });
  pixel = null;
}

module.exports = { pixelBegin, rayBegin, hit, term, rayEnd, pixelEnd };
