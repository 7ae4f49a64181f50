// The program: command line in, exit code out.
#include "cli/run.hpp"

int main(int argc, char** argv) { return tcb::run(argc, argv); }
