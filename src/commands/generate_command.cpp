#include "commands.hpp"

#include "visibility/scene/generators.hpp"
#include "visibility/scene/write_scene.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace visibility::commands {

namespace {

std::string kinds_help()
{
  std::string text = "Kinds and their parameters:\n";
  for (auto const& kind : generator_kinds()) {
    text += "\n  " + kind.name + ": " + kind.help + "\n      as published: " + kind.published + "\n";
    for (auto const& p : kind.parameters) {
      std::ostringstream value;
      value << p.value;
      text += "      " + p.name + "=" + value.str() + "  " + p.help + "\n";
    }
  }
  return text;
}

}  // namespace

void add_generate(CLI::App& app)
{
  struct Arguments {
    std::string kind, output;
    std::vector<std::string> parameters;
  };
  auto const a = std::make_shared<Arguments>();
  auto* const command = app.add_subcommand("generate", "Make a seeded scene of the papers and write it to a file");
  command->add_option("KIND", a->kind, "kind of scene")->required();
  command->add_option("PARAMETER", a->parameters, "key=value");
  command->add_option("-o,--output", a->output, "scene file to write (.obj .ply .geojson .geojsonl .json)")->required();
  command->footer(kinds_help());
  command->callback([a] {
    std::string specification = a->kind;
    for (auto const& p : a->parameters) specification += "," + p;
    Scene const scene = generate(specification);
    write_scene(a->output, scene);
    std::cout << a->output << ": " << scene.objects.size() << " objects, " << scene.primitive_count()
              << " primitives\n";
  });
}

}  // namespace visibility::commands
