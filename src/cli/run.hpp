// Run: the job of a command line is done by the entry of its product.
#pragma once

namespace tcb {

/// Runs the program with the arguments of main(). Result: its exit code.
int run(int argc, char** argv);

}  // namespace tcb
