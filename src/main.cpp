// The program: command line in, exit code out.
#include <cstdio>
#include <exception>
#include <new>

#include "check/report.hpp"
#include "cli/plan.hpp"
#include "cli/read_options.hpp"
#include "error.hpp"
#include "fit/fit_picture.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/terminal.hpp"
#include "run/pipeline.hpp"

namespace {

int refuse(tcb::Exit exit, const std::string& text) {
  (void)std::fprintf(stderr, "%s\n", text.c_str());
  return static_cast<int>(exit);
}

void print(const std::string& text) {
  tcb::Output output("-");
  output.write(text + "\n");
  output.commit();
}

}  // namespace

int main(int argc, char** argv) {
  tcb::keep_standard_streams();
  tcb::end_when_interrupted();
  const bool colored = tcb::colors_messages(tcb::color_of(argc, argv));
  try {
    const tcb::Invocation invocation = tcb::parse(argc, argv);
    if (invocation.job.writes_files()) tcb::remove_unfinished_when_interrupted();
    if (invocation.job.comparison) return static_cast<int>(tcb::compare(invocation.job));
    const bool draws = tcb::format_of(invocation.job.output_format).is_picture;
    if (!invocation.text && invocation.job.sampling.mode == tcb::Mode::fit && draws) {
      return static_cast<int>(tcb::draw_fit(invocation.job));
    }
    if (!invocation.text) return static_cast<int>(tcb::resample(invocation.job));
    if (invocation.exit != tcb::Exit::done) return refuse(invocation.exit, *invocation.text);
    print(*invocation.text);
    return static_cast<int>(tcb::Exit::done);
  } catch (const tcb::Error& error) {
    return refuse(error.exit(), tcb::error_text(error, colored));
  } catch (const std::bad_alloc&) {
    return refuse(tcb::Exit::usage, "tcbsample: error: out of memory");
  } catch (const std::exception& error) {
    return refuse(tcb::Exit::usage, std::string("tcbsample: error: ") + error.what());
  }
}
