/* Record hook for C and C++: include this file in one source file of your ray tracer, and it writes the ray trees that `raytree diff`
   and the debugger read. Nothing is written unless the environment says where: RAYTREE_RECORD=rays.json RAYTREE_PIXEL=160,100 ./tracer
   Without RAYTREE_PIXEL every pixel is recorded. One thread only. Vectors and colours are arrays of three numbers, or NULL. */
#pragma once
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RT_DEEPEST = 64, RT_LETTERS = 16384 }; /* rays inside of each other, and letters of a ray's line, at most */
typedef struct { int id, met, terms; char kind, text[RT_LETTERS]; } RtRay;
static struct { FILE *file; int on, x, y, deep, count; RtRay rays[RT_DEEPEST], *ray; } rt;

#define RT_ADD(...) snprintf(rt.ray->text + strlen(rt.ray->text), RT_LETTERS - strlen(rt.ray->text), __VA_ARGS__)
static inline void rt_vector(const char *name, const double *v) { if (v) RT_ADD(",\"%s\":[%.17g,%.17g,%.17g]", name, v[0], v[1], v[2]); }
static inline void rt_name(const char *field, const char *name) {
  if (!name) return;
  RT_ADD(",\"%s\":\"", field);
  for (; *name; name++) RT_ADD(strchr("\"\\", *name) ? "\\%c" : "%c", *name);
  RT_ADD("\"");
}
static inline void rt_check(int fits, const char *what) { if (!fits) fprintf(stderr, "raytree_hook.h: %s\n", what), exit(1); }

static inline void pixel_begin(int x, int y) { /* before the eye ray of a pixel */
  const char *path = getenv("RAYTREE_RECORD"), *wanted = getenv("RAYTREE_PIXEL");
  char here[32];
  snprintf(here, sizeof here, "%d,%d", x, y);
  if (!path || (wanted && strcmp(wanted, here))) return;
  if (!rt.file) rt.file = fopen(path, "w"), rt_check(rt.file != NULL, "RAYTREE_RECORD cannot be written");
  rt.on = 1, rt.x = x, rt.y = y, rt.deep = rt.count = 0;
}
/* A ray is sent: 'I' from the eye, 'L' to the light of this name, 'R' reflected, 'T' transmitted, both with their weight. */
static inline void ray_begin(char kind, const double *origin, const double *direction, const char *light, const double *weight) {
  if (!rt.on) return;
  const double white[3] = {1, 1, 1};
  int parent = rt.deep ? rt.ray->id : -1;
  rt_check(rt.deep < RT_DEEPEST, "RT_DEEPEST is too small");
  rt.ray = &rt.rays[rt.deep++], rt.ray->id = rt.count++, rt.ray->kind = kind, rt.ray->met = rt.ray->terms = rt.ray->text[0] = 0;
  RT_ADD("{\"pixel\":[%d,%d],\"id\":%d,\"kind\":\"%c\"", rt.x, rt.y, rt.ray->id, kind);
  if (parent >= 0) RT_ADD(",\"parent\":%d", parent);
  rt_name("light", light), rt_vector("origin", origin), rt_vector("direction", direction), rt_vector("weight", kind == 'I' ? white : weight);
}
static inline void hit(double t, const char *thing, const double *point, const double *normal) { /* what the ray meets; before its terms */
  if (!rt.on) return;
  RT_ADD(",\"hit\":{\"t\":%.17g", t), rt_name("object", thing), rt_vector("point", point), rt_vector("normal", normal), RT_ADD("}"), rt.ray->met = 1;
}
/* The ray's radiance grows by an "ambient", "diffuse", "specular", "emission" or "background" term. */
static inline void term(const char *name, const double *value, const char *light) {
  if (rt.on) RT_ADD("%s{\"term\":\"%s\"", rt.ray->terms++ ? "," : ",\"terms\":[", name), rt_vector("value", value), rt_name("light", light), RT_ADD("}");
}
static inline void ray_end(const double *radiance) { /* the ray is done, and so are those that it sent */
  if (!rt.on) return;
  if (rt.ray->terms) RT_ADD("]");
  rt_name("outcome", rt.ray->kind == 'L' ? (rt.ray->met ? "blocked" : "lit") : (rt.ray->met ? "hit" : "miss")), rt_vector("radiance", radiance);
  rt_check(strlen(rt.ray->text) < RT_LETTERS - 2, "RT_LETTERS is too small");
  fprintf(rt.file, "%s}\n", rt.ray->text), rt.deep--, rt.ray--;
}
static inline void pixel_end(const double *c) { /* linear red, green and blue of the pixel */
  if (rt.on) fprintf(rt.file, "{\"pixel\":[%d,%d],\"color\":[%.17g,%.17g,%.17g]}\n", rt.x, rt.y, c[0], c[1], c[2]), fflush(rt.file), rt.on = 0;
}
