#pragma once

namespace CLI {
class App;
}

/// Each function adds one subcommand to the command line. The work is done in its callback; faults are
/// thrown as BadInput, and the callback sets `exit_code` to 1 where a check found a fault.
namespace visibility::commands {

void add_generate(CLI::App& app);
void add_info(CLI::App& app);
void add_pvs(CLI::App& app);
void add_preprocess(CLI::App& app);
void add_recover(CLI::App& app);
void add_compare(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app);
void add_check(CLI::App& app, int& exit_code);

}  // namespace visibility::commands
