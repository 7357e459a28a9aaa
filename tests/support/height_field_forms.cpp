// Where quadratic forms are positive together: coefficients in the rays of a cone, and subdivision.

#include "support/height_field_lines.hpp"

#include <cmath>

namespace visibility::oracle::detail {
namespace {

constexpr int deepest = 240;          // levels of bisection
constexpr int most_triangles = 8000;  // per decision

Vector times(Form const& f, Vector const& v)
{
  return {f.xx * v.x + f.xy * v.y + f.xz * v.z, f.xy * v.x + f.yy * v.y + f.yz * v.z,
          f.xz * v.x + f.yz * v.y + f.zz * v.z};
}

/// The values of the polar form on all pairs of rays: on the cone the form is a combination of these with coefficients
/// that are not negative.
std::vector<NT> coefficients(Form const& form, std::span<Vector const> rays)
{
  std::vector<NT> out;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Vector const image = times(form, rays[i]);
    for (std::size_t j = 0; j <= i; ++j) out.push_back(dot(image, rays[j]));
  }
  return out;
}

bool none_positive(std::vector<NT> const& c)
{
  for (auto const& x : c)
    if (x > 0) return false;
  return true;
}

bool none_negative(std::vector<NT> const& c)
{
  for (auto const& x : c)
    if (x < 0) return false;
  return true;
}

/// Whether a + m b has no positive coefficient for some m > 0: then the two forms are nowhere positive together.
bool oppose(std::vector<NT> const& a, std::vector<NT> const& b)
{
  struct Fraction {
    NT over, under;  // under > 0; or infinite: under = 0
  } low{NT(0), NT(1)}, high{NT(1), NT(0)};
  auto const less = [](Fraction const& x, Fraction const& y) { return x.over * y.under < y.over * x.under; };
  for (std::size_t k = 0; k < a.size(); ++k) {
    int const s = sign(b[k]);
    if (s == 0 && a[k] > 0) return false;
    if (s > 0) {
      if (a[k] >= 0) return false;
      Fraction const bound{-a[k], b[k]};
      if (less(bound, high)) high = bound;
    } else if (s < 0) {
      Fraction const bound{a[k], -b[k]};
      if (less(low, bound)) low = bound;
    }
  }
  return !less(high, low);
}

double length(Vector const& a, Vector const& b)
{
  return std::hypot(CGAL::to_double(a.x) - CGAL::to_double(b.x), CGAL::to_double(a.y) - CGAL::to_double(b.y),
                    CGAL::to_double(a.z) - CGAL::to_double(b.z));
}

struct Triangle {
  std::array<Vector, 3> rays;
  std::vector<Form const*> forms;
  int depth;
};

std::array<Triangle, 2> halves(Triangle const& t)
{
  std::size_t longest = 0;
  double best = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (double const l = length(t.rays[i], t.rays[(i + 1) % 3]); l > best) best = l, longest = i;
  auto const &a = t.rays[longest], &b = t.rays[(longest + 1) % 3], &c = t.rays[(longest + 2) % 3];
  Vector const m = NT(0.5) * (a + b);
  return {Triangle{{a, m, c}, t.forms, t.depth + 1}, Triangle{{m, b, c}, t.forms, t.depth + 1}};
}

enum class Outcome { refuted, found, open };

/// Looks at one piece; drops the forms that are positive all over its interior.
Outcome look(std::vector<Form const*>& forms, std::span<Vector const> rays, Vector const& line)
{
  std::vector<Form const*> kept;
  std::vector<std::vector<NT>> rows;
  bool found = true;
  for (auto const* f : forms) {
    auto c = coefficients(*f, rays);
    if (none_positive(c)) return Outcome::refuted;
    if (none_negative(c)) continue;
    found = found && value(*f, line) > 0;
    kept.push_back(f);
    rows.push_back(std::move(c));
  }
  forms = std::move(kept);
  if (found) return Outcome::found;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (oppose(rows[i], rows[j])) return Outcome::refuted;
  return Outcome::open;
}

}  // namespace

NT value(Form const& form, Vector const& line) { return dot(times(form, line), line); }

bool nowhere_positive(Form const& form, std::span<Vector const> rays)
{
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Vector const image = times(form, rays[i]);
    for (std::size_t j = 0; j <= i; ++j)
      if (dot(image, rays[j]) > 0) return false;
  }
  return true;
}

Decision all_positive(std::vector<Form const*> const& forms, std::vector<Vector> const& rays)
{
  auto rest = forms;
  Vector const middle = inner_line(rays);
  if (auto const o = look(rest, rays, middle); o != Outcome::open)
    return {o == Outcome::found ? std::optional(middle) : std::nullopt, true};

  std::vector<Triangle> open;
  for (std::size_t i = 1; i + 1 < rays.size(); ++i) open.push_back({{rays[0], rays[i], rays[i + 1]}, rest, 0});
  Decision decision;
  for (int count = 0; !open.empty(); ++count) {
    Triangle t = std::move(open.back());
    open.pop_back();
    Vector const line = inner_line(t.rays);
    auto const outcome = look(t.forms, t.rays, line);
    if (outcome == Outcome::found) return {line, true};
    if (outcome == Outcome::refuted) continue;
    if (t.depth >= deepest || count >= most_triangles) {
      decision.decided = false;
      if (count >= most_triangles) break;
      continue;
    }
    for (auto& half : halves(t)) open.push_back(std::move(half));
  }
  return decision;
}

}  // namespace visibility::oracle::detail
