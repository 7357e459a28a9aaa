#include "kind.hpp"

#include <algorithm>
#include <array>

namespace visibility {

namespace {

using generators::Kind;

constexpr std::array makers{generators::city, generators::spheres, generators::circles, generators::box_field};

}  // namespace

std::span<GeneratorKind const> generator_kinds()
{
  static auto const kinds = [] {
    std::array<GeneratorKind, makers.size()> all;
    std::ranges::transform(makers, all.begin(), [](auto make) { return make().description; });
    return all;
  }();
  return kinds;
}

Scene generate(std::string_view specification)
{
  auto const name = specification.substr(0, specification.find(','));
  auto const kinds = generator_kinds();
  auto const kind = std::ranges::find(kinds, name, &GeneratorKind::name);
  if (kind == kinds.end()) {
    std::string list;
    for (auto const& k : kinds) (list += list.empty() ? "" : ", ") += k.name;
    throw BadInput("unknown generator '" + std::string(name) + "'; generators: " + list);
  }
  generators::Parameters const parameters(*kind, specification.substr(name.size()));
  SceneBuilder builder("gen:" + std::string(specification));
  makers[static_cast<std::size_t>(kind - kinds.begin())]().make(parameters, builder);
  return builder.finish();
}

}  // namespace visibility
