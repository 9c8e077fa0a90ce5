/* The ray of one pixel, and the first thing that it meets: hello FLAT.txt X Y WIDTH HEIGHT
   cc -O1 hello.c -lm -o hello; the scene is that of `raytree scenes NAME --flat=text`. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct { double x, y, z; } Vec;
static Vec axpy(double s, Vec a, Vec b) { return (Vec){s * a.x + b.x, s * a.y + b.y, s * a.z + b.z}; }
static Vec sub(Vec a, Vec b) { return axpy(-1, b, a); }
static Vec mul(double s, Vec a) { return axpy(s, a, (Vec){0, 0, 0}); }
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec unit(Vec a) { return mul(1 / sqrt(dot(a, a)), a); }
static Vec cross(Vec a, Vec b) { return (Vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/* Each gives t, where the ray o + t d crosses the shape, and the normal there; t is NAN if it misses. */
static double plane(Vec o, Vec d, Vec point, Vec normal, Vec *n) {
  *n = normal;
  return dot(normal, sub(point, o)) / dot(normal, d);
}
static double triangle(Vec o, Vec d, Vec a, Vec b, Vec c, Vec *n) {
  double t = plane(o, d, a, unit(cross(sub(b, a), sub(c, a))), n);
  Vec p = axpy(t, d, o);
  int in_a = dot(*n, cross(sub(b, a), sub(p, a))) >= 0, in_b = dot(*n, cross(sub(c, b), sub(p, b))) >= 0;
  return in_a && in_b && dot(*n, cross(sub(a, c), sub(p, c))) >= 0 ? t : NAN;
}
static double sphere(Vec o, Vec d, Vec c, double r, Vec *n) {
  Vec f = sub(o, c);
  double b = -dot(d, f), root = sqrt(b * b - (dot(f, f) - r * r)), t = b - root > 0 ? b - root : b + root;
  *n = unit(sub(axpy(t, d, o), c));
  return t;
}

int main(int argc, char **argv) {
  FILE *file = argc == 6 ? fopen(argv[1], "r") : NULL;
  if (!file) return fprintf(stderr, "usage: hello FLAT.txt X Y WIDTH HEIGHT\n"), 2;
  int x = atoi(argv[2]), y = atoi(argv[3]), width = atoi(argv[4]), height = atoi(argv[5]);
  char line[4096], kind[64], name[1024], hit[1024] = "";
  Vec a = {0}, b = {0}, c = {0}, e = {0}, n, normal = {0}, o = {0}, d = {0};
  double half, closest = INFINITY;
  while (fgets(line, sizeof line, file)) { /* the camera stands before the shapes */
    if (sscanf(line, "camera %lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf", &o.x, &o.y, &o.z, &a.x, &a.y, &a.z, &b.x, &b.y, &b.z, &c.x, &c.y, &c.z, &half) == 13)
      d = unit(sub(axpy((2 * (x + 0.5) / width - 1) * half * width / height, a, mul((1 - 2 * (y + 0.5) / height) * half, b)), c));
    int count = sscanf(line, "%63s%1023s%lf%lf%lf%lf%lf%lf%lf%lf%lf", kind, name, &a.x, &a.y, &a.z, &b.x, &b.y, &b.z, &e.x, &e.y, &e.z);
    double t = count >= 8 && !strcmp(kind, "plane") ? plane(o, d, a, b, &n) : count == 11 && !strcmp(kind, "triangle") ? triangle(o, d, a, b, e, &n)
             : count >= 6 && !strcmp(kind, "sphere") ? sphere(o, d, a, b.x, &n) : NAN;
    if (t > 0 && t < closest) closest = t, normal = n, strcpy(hit, name);
  }
  printf("{\"pixel\":{\"x\":%d,\"y\":%d},\"root\":{\"kind\":\"I\",\"origin\":[%.17g,%.17g,%.17g],\"direction\":[%.17g,%.17g,%.17g],", x, y, o.x, o.y, o.z, d.x, d.y, d.z);
  if (isinf(closest)) return puts("\"outcome\":\"miss\"}}") == EOF;
  Vec p = axpy(closest, d, o);
  if (dot(normal, d) > 0) normal = mul(-1, normal);
  for (char *s; (s = strstr(hit, "%20")); memmove(s + 1, s + 3, strlen(s + 3) + 1)) *s = ' ';
  printf("\"outcome\":\"hit\",\"hit\":{\"t\":%.17g,\"object\":\"%s\",\"point\":[%.17g,%.17g,%.17g],\"geometric_normal\":[%.17g,%.17g,%.17g]}}}\n", closest, hit, p.x, p.y, p.z, normal.x, normal.y, normal.z);
}
