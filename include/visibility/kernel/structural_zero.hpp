#pragma once

namespace visibility {

/// A number type that only knows which values are zero for structural reasons: differences of equal inputs, products
/// with such a factor, sums of such terms. A formula evaluated on it proves zeros without arithmetic; axis-aligned,
/// shared and equal-height input produces little else. `zero == false` says nothing.
struct StructuralZero {
  bool zero;
};

/// An input of a formula on `StructuralZero`: keeps its value so that differences of inputs can be compared.
struct StructuralInput {
  double v;
  operator StructuralZero() const { return {v == 0}; }
};

inline StructuralZero operator-(StructuralInput a, StructuralInput b) { return {a.v == b.v}; }
inline StructuralZero operator+(StructuralInput a, StructuralInput b) { return {a.v == -b.v}; }
inline StructuralZero operator*(StructuralZero a, StructuralZero b) { return {a.zero || b.zero}; }
inline StructuralZero operator+(StructuralZero a, StructuralZero b) { return {a.zero && b.zero}; }
inline StructuralZero operator-(StructuralZero a, StructuralZero b) { return {a.zero && b.zero}; }

}  // namespace visibility
