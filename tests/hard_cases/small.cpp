#include "hard_case.hpp"

namespace visibility::hard_cases {

Cases small()
{
  Cases out;
  ViewCell const cell(Box{{-1, -1, 1}, {1, 1, 2}});
  auto const add = [&](std::string const& name, std::string const& why, Scene scene, bool is_height_field = true) {
    out.push_back({"small scenes", name, why, std::move(scene), cell, {"only"}, {}, is_height_field});
  };
  add("one box", "Nothing is in the way.", Stage().box("only", {3, -1}, {4, 1}, 3).scene());
  add("one upright triangle", "Nothing is in the way.",
      Stage().triangle("only", {3, -1, 0}, {3, 1, 0}, {3, 0, 3}).scene());
  add("one level triangle, below", "It is seen from above.",
      Stage().triangle("only", {3, -1, 0}, {5, 1, 0}, {3, 1, 0}).scene());
  add("one level triangle, above", "It is seen from below: no height field.",
      Stage().triangle("only", {3, -1, 5}, {5, 1, 5}, {3, 1, 5}).scene(), false);
  add("one ball", "Nothing is in the way.", Stage().ball("only", {{5, 0, 0}, 1}).scene(), false);
  add("the cell itself", "The object is the cell.", Stage().box("only", cell.bounds()).scene(), false);
  add("a box around the cell", "The cell lies within the object: they share points.",
      Stage().box("only", Box{{-9, -9, 0}, {9, 9, 9}}).scene(), false);
  return out;
}

}  // namespace visibility::hard_cases
