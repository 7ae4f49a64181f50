// The program: command line in, exit code out.
#include <cstdio>
#include <exception>
#include <new>

#include "cli/options.hpp"
#include "cli/reference.hpp"
#include "error.hpp"
#include "resample.hpp"

namespace {

int say(tcb::Exit exit, const std::string& text) {
  (void)std::fprintf(exit == tcb::Exit::done ? stdout : stderr, "%s\n", text.c_str());
  return static_cast<int>(exit);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const tcb::cli::Request request = tcb::cli::parse(argc, argv);
    if (request.text) return say(tcb::Exit::done, *request.text);
    return static_cast<int>(tcb::resample(request.plan));
  } catch (const tcb::Error& error) {
    return say(error.exit(), error.text());
  } catch (const std::bad_alloc&) {
    return say(tcb::Exit::usage, "tcbsample: error: out of memory");
  } catch (const std::exception& error) {
    return say(tcb::Exit::usage, std::string("tcbsample: error: ") + error.what());
  }
}
