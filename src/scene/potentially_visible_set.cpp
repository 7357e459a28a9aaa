#include "visibility/scene/potentially_visible_set.hpp"

#include <stdexcept>

namespace visibility {

std::string to_string(Guarantee guarantee)
{
  switch (guarantee) {
  case Guarantee::exact: return "exact";
  case Guarantee::conservative: return "conservative";
  case Guarantee::aggressive: return "aggressive";
  case Guarantee::none: break;
  }
  return "none";
}

Guarantee guarantee_from_string(std::string const& name)
{
  for (auto const g : {Guarantee::exact, Guarantee::conservative, Guarantee::aggressive, Guarantee::none})
    if (to_string(g) == name) return g;
  throw std::invalid_argument("unknown guarantee '" + name + "'");
}

}  // namespace visibility
