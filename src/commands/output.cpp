#include "output.hpp"

#include "io/atomic_file.hpp"

namespace visibility::commands {

void write_output(std::string const& file, std::string const& text)
{
  io::AtomicFile out(file);
  out.stream() << text;
  out.commit();
}

}  // namespace visibility::commands
