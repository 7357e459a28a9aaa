#pragma once

#include "visibility/line_space/plucker_cone.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace visibility {

/// How far a search for a sign of q goes: portal sequences need no more than edges (proofs/plucker_cone.md, Theorem 4),
/// the half-spaces of other lines may need 2-faces.
enum class SearchDepth { edges, faces };

/// Looks for vectors of a cone on which q(l) = b(l, l) is positive, and such on which it is negative.
///
/// With `SearchDepth::faces` complete for cones with interior whose half-spaces are real lines (q(h) = 0): it looks at
/// the lineality space, the extreme rays, the edges and the 2-faces; no other face can be the first that holds a vector
/// of a sign. Sound for any cone and depth.
/// Source: proofs/plucker_cone.md, Theorems 3 and 4; the usual test [Teller92] stops at pairs.
template <class NT>
class QuadricSearch {
public:
  using Line = PluckerLine<NT>;

  /// Where a vector was found: how far the search had to go.
  enum class Stage { lineality, rays, edges, faces };
  struct Found {
    Line line;
    Stage stage;
  };

  /// Requires: the cone has interior and outlives the search.
  explicit QuadricSearch(PluckerCone<NT> const& cone, SearchDepth depth = SearchDepth::faces)
    : cone_(cone), depth_(depth)
  {
    diagonalize_lineality();
    for (auto const& r : cone.rays()) {
      rays_.push_back(lineality_is_definite_ ? without_lineality(r.line) : r.line);
      form_.push_back(plucker_form(rays_.back()));
    }
  }

  /// A vector of the cone on which q has the sign `s`. Requires: s != zero.
  std::optional<Found> find(Sign s) const
  {
    for (auto const& [z, q] : lineality_)
      if (number_sign(q) == s) return Found{z, Stage::lineality};
    if (!lineality_is_definite_) return at(Stage::lineality, along_null_line(s));
    for (std::size_t i = 0; i < rays_.size(); ++i)
      if (number_sign(form_[i]) == s) return Found{rays_[i], Stage::rays};
    for (std::size_t i = 0; i < rays_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (cone_.adjacent(i, j))
          if (auto l = on_edge(i, j, s)) return at(Stage::edges, std::move(l));
    if (depth_ == SearchDepth::edges || !lineality_.empty()) return {};
    return at(Stage::faces, in_face(s));
  }

private:
  struct Diagonal {
    Line line;
    NT form;
  };

  static std::optional<Found> at(Stage stage, std::optional<Line> line)
  {
    return line ? std::optional(Found{std::move(*line), stage}) : std::nullopt;
  }

  /// A basis of the lineality space that is orthogonal under b. It is definite iff all forms have one sign, not zero.
  void diagonalize_lineality()
  {
    auto basis = cone_.lineality();
    while (!basis.empty()) {
      if (!bring_forward(basis)) break;
      Line const z = primitive(basis.back());
      basis.pop_back();
      NT const q = plucker_form(z);
      for (Line& y : basis) y = orthogonal_to(y, z, q);
      lineality_.push_back({z, q});
    }
    for (Line& z : basis) lineality_.push_back({std::move(z), NT(0)});
    for (auto const& [z, q] : lineality_)
      lineality_is_definite_ &= !is_zero(number_sign(q)) && number_sign(q) == number_sign(lineality_.front().form);
  }

  /// Puts a vector with q != 0 last, the sum of two if need be; false if q vanishes on the whole span.
  static bool bring_forward(std::vector<Line>& basis)
  {
    for (Line& z : basis)
      if (!is_zero(number_sign(plucker_form(z)))) return std::swap(z, basis.back()), true;
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!is_zero(number_sign(plucker_product(basis[i], basis[j])))) {
          basis[i] = combination(NT(1), basis[i], NT(1), basis[j]);
          return std::swap(basis[i], basis.back()), true;
        }
    return false;
  }

  /// A positive multiple of y minus its component along z, where q = q(z) != 0.
  static Line orthogonal_to(Line const& y, Line const& z, NT const& q)
  {
    NT const b = plucker_product(y, z);
    if (is_zero(number_sign(b))) return y;
    return primitive(combination<NT>(magnitude(q), y, is_positive(number_sign(q)) ? NT(0) - b : b, z));
  }

  Line without_lineality(Line l) const
  {
    for (auto const& [z, q] : lineality_) l = orthogonal_to(l, z, q);
    return l;
  }

  /// The lineality space has no vector of sign s and is degenerate: q(r + t z) is linear in t for a z of its radical.
  std::optional<Line> along_null_line(Sign s) const
  {
    for (auto const& [z, q] : lineality_) {
      if (!is_zero(number_sign(q))) continue;
      for (std::size_t i = 0; i < rays_.size(); ++i) {
        NT const b = plucker_product(rays_[i], z);
        if (is_zero(number_sign(b))) continue;
        NT const t = magnitude(form_[i]) + NT(1);
        return combination<NT>(magnitude(b), rays_[i], number_sign(b) == s ? t : NT(0) - t, z);
      }
    }
    return {};
  }

  /// On the segment between two rays whose q is zero or has the sign -s.
  std::optional<Line> on_edge(std::size_t i, std::size_t j, Sign s) const
  {
    NT const product = plucker_product(rays_[i], rays_[j]);
    if (number_sign(product) != s) return {};
    if (!is_positive(number_sign<NT>(product * product - form_[i] * form_[j]))) return {};
    NT const b = magnitude(product);
    if (is_zero(number_sign(form_[j]))) return combination<NT>(b, rays_[i], magnitude(form_[i]) + NT(1), rays_[j]);
    return combination<NT>(magnitude(form_[j]), rays_[i], b, rays_[j]);
  }

  /// On a diagonal of a 2-face, or, when none of them tells, inside of a triangle of its rays.
  std::optional<Line> in_face(Sign s) const
  {
    auto const& rays = cone_.rays();
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if ((rays[i].tight & rays[j].tight).size() >= 3 && !cone_.adjacent(i, j))
          if (auto l = on_edge(i, j, s)) return l;
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        TightSet const common = rays[i].tight & rays[j].tight;
        if (common.size() < 3) continue;
        for (std::size_t k = 0; k < j; ++k)
          if ((common & rays[k].tight).size() >= 3)
            if (auto l = in_triangle({i, j, k}, s)) return l;
      }
    return {};
  }

  /// The Gram matrix G of s b has the signature (1, 2) and its cone of positive vectors lies in the triangle iff its
  /// diagonal is negative, det G > 0, and the adjugate of G is non-negative.
  std::optional<Line> in_triangle(std::array<std::size_t, 3> const& r, Sign s) const
  {
    auto const g = [&](std::size_t i, std::size_t j) -> NT {
      NT const b = i == j ? form_[r[i]] : plucker_product(rays_[r[i]], rays_[r[j]]);
      return is_positive(s) ? b : NT(0) - b;
    };
    NT const a = g(0, 0), b = g(1, 1), c = g(2, 2), f = g(1, 2), e = g(0, 2), d = g(0, 1);
    for (NT const* x : {&a, &b, &c})
      if (!is_negative(number_sign(*x))) return {};
    NT const adjugate[3][3] = {{b * c - f * f, e * f - d * c, d * f - e * b},
                               {e * f - d * c, a * c - e * e, d * e - a * f},
                               {d * f - e * b, d * e - a * f, a * b - d * d}};
    for (auto const& row : adjugate)
      for (NT const& x : row)
        if (is_negative(number_sign(x))) return {};
    if (!is_positive(number_sign<NT>(a * adjugate[0][0] + d * adjugate[0][1] + e * adjugate[0][2]))) return {};
    Line sum;
    for (std::size_t i = 0; i < 3; ++i)
      sum = combination<NT>(NT(1), sum, adjugate[i][0] + adjugate[i][1] + adjugate[i][2], rays_[r[i]]);
    return sum;
  }

  PluckerCone<NT> const& cone_;
  SearchDepth depth_;
  std::vector<Diagonal> lineality_;
  bool lineality_is_definite_ = true;
  std::vector<Line> rays_;  ///< of the cone; orthogonal to the lineality space where that is definite
  std::vector<NT> form_;    ///< q of each
};

}  // namespace visibility
