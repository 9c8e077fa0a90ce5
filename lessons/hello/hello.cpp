// The ray of one pixel, and the first thing that it meets: hello FLAT.txt X Y WIDTH HEIGHT
// c++ -std=c++17 hello.cpp -o hello; the scene is that of `raytree scenes NAME --flat=text`.
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
struct Vec { double x, y, z; };
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec unit(Vec a) { return 1 / std::sqrt(dot(a, a)) * a; }
std::istream &operator>>(std::istream &in, Vec &a) { return in >> a.x >> a.y >> a.z; }
std::ostream &operator<<(std::ostream &out, Vec a) { return out << '[' << a.x << ',' << a.y << ',' << a.z << ']'; }

struct Ray { Vec o, d; };
struct Hit { double t = std::nan(""); Vec n; };  // t is NAN if the ray misses
Hit plane(Ray r, Vec point, Vec n) { return {dot(n, point - r.o) / dot(n, r.d), n}; }
Hit triangle(Ray r, Vec a, Vec b, Vec c) {
  Hit hit = plane(r, a, unit(cross(b - a, c - a)));
  Vec p = r.o + hit.t * r.d;
  auto left = [&](Vec from, Vec to) { return dot(hit.n, cross(to - from, p - from)) >= 0; };
  return left(a, b) && left(b, c) && left(c, a) ? hit : Hit{};
}
Hit sphere(Ray r, Vec c, double radius) {
  Vec f = r.o - c;
  double b = -dot(r.d, f), root = std::sqrt(b * b - (dot(f, f) - radius * radius));
  double t = b - root > 0 ? b - root : b + root;
  return {t, unit(r.o + t * r.d - c)};
}
int main(int argc, char **argv) {
  if (argc != 6) return std::cerr << "usage: hello FLAT.txt X Y WIDTH HEIGHT\n", 2;
  int x = std::stoi(argv[2]), y = std::stoi(argv[3]), width = std::stoi(argv[4]), height = std::stoi(argv[5]);
  Ray ray{};
  Hit closest{INFINITY, {}};
  std::ifstream file(argv[1]);
  std::string line, kind, name, object;
  while (std::getline(file, line)) {  // the camera stands before the shapes
    std::istringstream in(line);
    Vec a, b, c;
    double s = 0;
    if (in >> kind && kind == "camera" && in >> ray.o >> a >> b >> c >> s)
      ray.d = unit((2 * (x + 0.5) / width - 1) * s * width / height * a + (1 - 2 * (y + 0.5) / height) * s * b - c);
    Hit hit;
    if (kind == "plane" && in >> name >> a >> b) hit = plane(ray, a, b);
    if (kind == "triangle" && in >> name >> a >> b >> c) hit = triangle(ray, a, b, c);
    if (kind == "sphere" && in >> name >> a >> s) hit = sphere(ray, a, s);
    if (hit.t > 0 && hit.t < closest.t) closest = hit, object = name;
  }
  for (size_t at; (at = object.find("%20")) != std::string::npos;) object.replace(at, 3, " ");
  std::cout.precision(17);
  std::cout << "{\"pixel\":{\"x\":" << x << ",\"y\":" << y << "},\"root\":{\"kind\":\"I\",\"origin\":" << ray.o << ",\"direction\":" << ray.d;
  if (object.empty()) return std::cout << ",\"outcome\":\"miss\"}}\n", 0;
  Vec n = dot(closest.n, ray.d) < 0 ? closest.n : -1 * closest.n;
  std::cout << ",\"outcome\":\"hit\",\"hit\":{\"t\":" << closest.t << ",\"object\":\"" << object << "\",\"point\":" << ray.o + closest.t * ray.d
            << ",\"geometric_normal\":" << n << "}}}\n";
}
