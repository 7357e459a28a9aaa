#pragma once

namespace visibility::commands {

/// Makes Ctrl-C and termination end the program at once with exit code 130 or 143, leaving no half-written file behind.
void install_interrupt_handler();

}  // namespace visibility::commands
