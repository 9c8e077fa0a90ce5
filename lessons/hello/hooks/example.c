/* A ray tracer with the record hook in it, in each place that it belongs: example X Y WIDTH HEIGHT traces a pixel of example.json.
   cc -O1 example.c -lm -o example; as C++: c++ -x c++ example.c -o example */
#include <math.h>
#include "raytree_hook.h"

enum { DEPTH = 3, FLOOR = 2 };
static const double BLACK[3] = {0, 0, 0}, LAMP[3] = {3, 4, 3}, BACKGROUND[3] = {0.2, 0.3, 0.5}, MIRROR[3] = {0.8, 0.2, 0.2};
static const double CENTER[2][3] = {{0, 1, 0}, {1.4, 0.4, 0.8}}, RADIUS[2] = {1, 0.4};
static const double DIFFUSE[3][3] = {{0.1, 0.1, 0.12}, {0.6, 0.55, 0.5}, {0.6, 0.55, 0.5}};
static const char *const NAME[3] = {"ball", "pearl", "floor"};

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void axpy(double s, const double *a, const double *b, double *r) { for (int i = 0; i < 3; i++) r[i] = s * a[i] + b[i]; }
static double unit(double *a) {
  double length = sqrt(dot(a, a));
  for (int i = 0; i < 3; i++) a[i] /= length;
  return length;
}
/* What the ray meets first, or -1; its t and normal. */
static int closest(const double *o, const double *d, double *t, double *n) {
  int found = -1;
  if (d[1] < 0 && -o[1] / d[1] < *t && o[1] > 0) *t = -o[1] / d[1], found = FLOOR, n[0] = n[2] = 0, n[1] = 1;
  for (int i = 0; i < 2; i++) {
    double f[3];
    axpy(-1, CENTER[i], o, f);
    double b = dot(d, f), root = b * b - dot(f, f) + RADIUS[i] * RADIUS[i], t_ball = root < 0 ? INFINITY : -b - sqrt(root);
    if (t_ball > 1e-9 && t_ball < *t) *t = t_ball, found = i, axpy(t_ball, d, f, n), unit(n);
  }
  return found;
}
static void radiance(char kind, const double *o, const double *d, int depth, const double *weight, double *color) {
  double t = INFINITY, n[3], point[3], start[3], l[3], next[3], from_there[3];
  ray_begin(kind, o, d, NULL, weight);
  int met = closest(o, d, &t, n);
  if (met < 0) {
    axpy(1, BACKGROUND, BLACK, color);
    term("background", color, NULL);
  } else {
    axpy(t, d, o, point), axpy(1e-9, n, point, start), axpy(-1, point, LAMP, l);
    hit(t, NAME[met], point, n);
    axpy(0.1, DIFFUSE[met], BLACK, color);
    term("ambient", color, NULL);
    double to_lamp = unit(l), there[3], diffuse[3];
    if (dot(n, l) > 0) {
      ray_begin('L', start, l, "lamp", NULL);
      int blocker = closest(start, l, &to_lamp, there);
      if (blocker >= 0) hit(to_lamp, NAME[blocker], NULL, NULL);
      ray_end(NULL);
      axpy(dot(n, l), DIFFUSE[met], BLACK, diffuse);
      if (blocker < 0) term("diffuse", diffuse, "lamp"), axpy(1, diffuse, color, color);
    }
    if (depth < DEPTH) {
      double mirror[3] = {MIRROR[met], MIRROR[met], MIRROR[met]};
      axpy(-2 * dot(n, d), n, d, next), unit(next);
      radiance('R', start, next, depth + 1, mirror, from_there);
      axpy(MIRROR[met], from_there, color, color);
    }
  }
  ray_end(color);
}
int main(int argc, char **argv) {
  if (argc != 5) return fprintf(stderr, "usage: example X Y WIDTH HEIGHT\n"), 2;
  double x = atof(argv[1]), y = atof(argv[2]), width = atof(argv[3]), height = atof(argv[4]), half = tan(acos(-1) / 6);
  double eye[3] = {0, 1, 4}, color[3], d[3] = {(2 * (x + 0.5) / width - 1) * half * width / height, (1 - 2 * (y + 0.5) / height) * half, -1};
  unit(d);
  pixel_begin((int)x, (int)y);
  radiance('I', eye, d, 0, NULL, color);
  pixel_end(color);
  printf("%.17g %.17g %.17g\n", color[0], color[1], color[2]);
}
