#pragma once

#include "visibility/line_space/primitive.hpp"
#include "visibility/line_space/tight_set.hpp"

#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace visibility {

/// The polyhedral cone {l in R^6 : b(l, h) >= 0 for every half-space h}: all oriented lines (and other vectors of
/// Plücker space) that pass the lines h on one side. Kept by double description: the largest linear subspace in it
/// (`lineality`) and the extreme rays modulo that subspace, each with the set of half-spaces that it touches.
///
/// `insert` is incremental and right for every input: redundant, repeated, opposite or zero half-spaces, cones with
/// lines, without interior, or {0}. The cone does not depend on the order of insertion; the representatives of rays
/// modulo the lineality space do. Exact for exact NT (ExactNumber, RationalNumber, CGAL::Gmpz); `double` is for
/// comparison only and guarantees nothing.
/// Cost: a vertical line before the edges keeps the cone small (they span three dimensions only).
/// Source: [Motzkin53], [Fukuda96]; proofs/plucker_cone.md, Theorem 1.
template <class NT>
class PluckerCone {
public:
  using Line = PluckerLine<NT>;
  struct Ray {
    Line line;
    TightSet tight;  ///< positions in half_spaces() of the h with b(line, h) = 0: all of them
  };

  /// All of R^6.
  PluckerCone()
  {
    for (std::size_t i = 0; i < 6; ++i) {
      lineality_.emplace_back();
      lineality_.back()[i] = NT(1);
    }
  }

  explicit PluckerCone(std::span<Line const> half_spaces) : PluckerCone()
  {
    for (Line const& h : half_spaces) insert(h);
  }

  std::vector<Line> const& half_spaces() const { return half_spaces_; }  ///< as inserted, scaled
  std::vector<Line> const& lineality() const { return lineality_; }      ///< a basis
  std::vector<Ray> const& rays() const { return rays_; }

  /// Intersects with {l : b(l, h) >= 0}.
  void insert(Line const& half_space)
  {
    half_spaces_.push_back(primitive(half_space));
    Line const& h = half_spaces_.back();
    for (std::size_t i = 0; i < lineality_.size(); ++i) {
      NT const value = plucker_product(lineality_[i], h);
      if (!is_zero(number_sign(value))) return leave_lineality(i, value);
    }
    cut_rays();
  }

  /// Whether some l has b(l, h) > 0 for all half-spaces at once.
  bool has_interior() const
  {
    if (rays_.empty()) return half_spaces_.empty();
    TightSet everywhere = rays_.front().tight;
    for (Ray const& r : rays_) everywhere = everywhere & r.tight;
    return everywhere.empty();
  }

  /// A vector with b(l, h) > 0 for all half-spaces. Requires: has_interior().
  Line interior() const
  {
    std::vector<Line> lines;
    for (Ray const& r : rays_) lines.push_back(r.line);
    make_comparable(std::span(lines));
    Line sum;
    for (Line const& l : lines)
      for (std::size_t i = 0; i < 6; ++i) sum[i] = sum[i] + l[i];
    return sum;
  }

  /// Whether the rays at positions i != j span a two-dimensional face (modulo the lineality space).
  bool adjacent(std::size_t i, std::size_t j) const
  {
    TightSet const common = rays_[i].tight & rays_[j].tight;
    if (common.size() + 2 + static_cast<int>(lineality_.size()) < 6) return false;
    for (std::size_t k = 0; k < rays_.size(); ++k)
      if (k != i && k != j && rays_[k].tight.contains(common)) return false;
    return true;
  }

  /// Throws std::logic_error naming the invariant that does not hold: signs and tight sets of the rays.
  void validate() const
  {
    for (std::size_t i = 0; i < half_spaces_.size(); ++i) {
      for (Line const& z : lineality_)
        if (!is_zero(number_sign(plucker_product(z, half_spaces_[i]))))
          throw std::logic_error("PluckerCone: the lineality space leaves a half-space");
      for (Ray const& r : rays_) {
        Sign const s = number_sign(plucker_product(r.line, half_spaces_[i]));
        if (is_negative(s)) throw std::logic_error("PluckerCone: a ray is outside of a half-space");
        if (is_zero(s) != r.tight.contains(i)) throw std::logic_error("PluckerCone: a tight set is wrong");
      }
    }
  }

private:
  /// The new half-space cuts the lineality space, where z = lineality[i] has the product `value` with it: the others
  /// and the rays are moved along z into the boundary, and z becomes a ray.
  void leave_lineality(std::size_t i, NT value)
  {
    Line const& h = half_spaces_.back();
    std::size_t const index = half_spaces_.size() - 1;
    std::swap(lineality_[i], lineality_.back());
    Line z = std::move(lineality_.back());
    lineality_.pop_back();
    if (is_negative(number_sign(value))) {
      z = reversed(z);
      value = NT(0) - value;
    }
    auto const move_along_z = [&](Line& l) {
      NT const product = plucker_product(l, h);
      if (!is_zero(number_sign(product))) l = primitive(combination<NT>(value, l, NT(0) - product, z));
    };
    for (Line& l : lineality_) move_along_z(l);
    for (Ray& r : rays_) {
      move_along_z(r.line);
      r.tight.insert(index);
    }
    rays_.push_back({std::move(z), TightSet::first(index)});
  }

  /// The new half-space contains the lineality space: drop the rays outside, cut the edges that leave it.
  void cut_rays()
  {
    Line const& h = half_spaces_.back();
    std::size_t const index = half_spaces_.size() - 1;
    std::vector<NT> value;
    std::vector<std::size_t> inside, outside;
    value.reserve(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      value.push_back(plucker_product(rays_[i].line, h));
      Sign const s = number_sign(value.back());
      if (is_zero(s)) rays_[i].tight.insert(index);
      if (is_positive(s)) inside.push_back(i);
      if (is_negative(s)) outside.push_back(i);
    }
    if (outside.empty()) return;
    std::vector<Ray> cut;
    // Neither end is tight at the new half-space, so adjacency is still that of the cone before.
    for (auto const u : inside)
      for (auto const v : outside)
        if (adjacent(u, v)) {
          Ray r{combination<NT>(NT(0) - value[v], rays_[u].line, value[u], rays_[v].line),
                rays_[u].tight & rays_[v].tight};
          make_primitive(r.line);
          r.tight.insert(index);
          cut.push_back(std::move(r));
        }
    std::size_t kept = 0, next = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if (next < outside.size() && outside[next] == i) {
        ++next;
        continue;
      }
      if (kept != i) rays_[kept] = std::move(rays_[i]);
      ++kept;
    }
    rays_.resize(kept);
    for (Ray& r : cut) rays_.push_back(std::move(r));
  }

  std::vector<Line> half_spaces_, lineality_;
  std::vector<Ray> rays_;
};

}  // namespace visibility
