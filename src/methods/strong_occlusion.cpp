#include "visibility/methods/strong_occlusion/method.hpp"

namespace visibility {

template class StrongOcclusion<Filtered>;
template class StrongOcclusion<TalliedFiltered>;
template class StrongOcclusion<Rational>;
template class StrongOcclusion<Double>;

}  // namespace visibility
