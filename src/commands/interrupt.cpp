#include "interrupt.hpp"

#include "io/atomic_file.hpp"

#include <csignal>
#include <unistd.h>

namespace visibility::commands {

namespace {

extern "C" void leave(int signal)
{
  io::AtomicFile::remove_all();
  _exit(128 + signal);
}

}  // namespace

void install_interrupt_handler()
{
  std::signal(SIGINT, leave);
  std::signal(SIGTERM, leave);
}

}  // namespace visibility::commands
