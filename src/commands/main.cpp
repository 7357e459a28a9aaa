#include "commands.hpp"
#include "interrupt.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#ifndef VISIBILITY_VERSION
#error "the build system defines VISIBILITY_VERSION"
#endif

namespace {

constexpr int bad_input = 2;

int complain(std::string what)
{
  std::ranges::replace(what, '\n', ' ');
  std::cerr << "visibility: " << what << '\n';
  return bad_input;
}

}  // namespace

int main(int argc, char** argv)
{
  visibility::commands::install_interrupt_handler();
  CLI::App app{"What can be seen from a region: potentially visible sets, exactly decided.", "visibility"};
  app.set_version_flag("--version", VISIBILITY_VERSION);
  app.require_subcommand(1);
  int exit_code = 0;
  visibility::commands::add_generate(app);
  visibility::commands::add_info(app);
  visibility::commands::add_pvs(app);
  visibility::commands::add_preprocess(app);
  visibility::commands::add_recover(app);
  visibility::commands::add_compare(app, exit_code);
  visibility::commands::add_draw(app);
  visibility::commands::add_check(app, exit_code);
  try {
    app.parse(argc, argv);
    std::cout.flush();
    if (!std::cout) return complain("cannot write to standard output");
    return exit_code;
  } catch (CLI::Success const& request) {
    return app.exit(request);  // --help, --version
  } catch (CLI::ParseError const& e) {
    return complain(std::string(e.what()) + " (visibility --help lists commands and options)");
  } catch (std::bad_alloc const&) {
    return complain("out of memory");
  } catch (std::exception const& e) {
    return complain(e.what());
  }
}
