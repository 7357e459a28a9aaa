#pragma once

#include "visibility/drawing/plan_picture.hpp"
#include "visibility/methods/exact_25d/explanation.hpp"

#include <cstddef>

namespace visibility {

/// How much of an explanation a picture shows; there are thousands of funnels and shadows in a city.
struct ExplanationShown {
  std::size_t funnels = 0;  ///< those that cross most occluders
  std::size_t shadows = 0;  ///< of the occluders nearest to the cell
  double ground = 0;        ///< height of the ground that shadows fall on
};

/// Adds the visible parts of all top edges that reach into the region, and funnels and shadows. A shadow is what an
/// occluder hides of the ground from one end of the source: the shadow planes through its edge end it, those through
/// the ends of source and occluder are its sides.
void add_explanation(PlanPicture& picture, exact_25d::Explanation const& explanation, ExplanationShown const& shown);

}  // namespace visibility
