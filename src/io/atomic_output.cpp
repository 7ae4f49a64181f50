// Atomic outputs: temporary files, which get their final name when they are complete; interruptions.
#include "io/atomic_output.hpp"

#include <charconv>
#include <filesystem>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <system_error>
#include <utility>

#include "error.hpp"
#include "io/system.hpp"
#include "io/terminal.hpp"

namespace tcb {
namespace {

constexpr std::size_t write_size = 32UL * 1024;

/// The names of all unfinished files; never destroyed, because a signal may arrive while the program ends.
struct TemporaryFiles {
  std::mutex mutex;
  std::set<std::string> all;
};
TemporaryFiles& temporary_files() {
  static TemporaryFiles& known = *new TemporaryFiles;
  return known;
}

/// Removes all unfinished files, and ends the program.
void end_without_unfinished(void (*end)()) {
  const std::lock_guard lock(temporary_files().mutex);
  for (const std::string& name : temporary_files().all) system::remove(name);
  end();
}

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view temporary_ending = ".tcbsample";
constexpr std::size_t random_letters = 10;

/// A hidden name in the folder of `path`, with random letters.
std::string unfinished_name(const std::filesystem::path& path) {
  constexpr std::size_t longest = 200;  // file systems allow 255 bytes
  std::random_device random;
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  std::string name = "." + system::path_text(path.filename()).substr(0, longest) + ".";
  for (std::size_t i = 0; i < random_letters; ++i) name += letters[letter(random)];
  return system::path_text(path.parent_path() / (name + std::string(temporary_ending)));
}

/// Whether a file name is one that unfinished_name() makes.
bool is_unfinished_name(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(temporary_ending)) return false;
  name.remove_suffix(temporary_ending.size());
  const std::size_t point = name.rfind('.');
  const std::string_view random = name.substr(point + 1);
  return point > 0 && random.size() == random_letters && random.find_first_not_of(letters) == std::string_view::npos;
}

/// Calls make(name) with unused names of temporary files, and returns the descriptor or 0 that it returns, or -1 if it
/// fails. `name` becomes the name of the file that it made.
template <class Make>
int make_temporary(const std::string& path, std::string& name, const Make& make) {
  constexpr int most_attempts = 100;
  const std::lock_guard lock(temporary_files().mutex);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    std::string unused = unfinished_name(path);
    const int result = make(unused);
    if (result >= 0) name = *temporary_files().all.insert(std::move(unused)).first;
    if (result >= 0 || !system::already_exists()) return result;
  }
  return -1;
}

/// Opens a new file in the folder of `path` for writing. It has no name, where the system has such files, so that
/// nothing is left if the program is killed; else a temporary one. The descriptor is -1 if that fails.
void open_new(OutputTarget& target, const std::string& path, unsigned permissions) {
  target.is_file = true;
  target.descriptor = system::create_unnamed(folder_of(path), permissions);
  if (target.descriptor >= 0) return system::mark_as_written(target.descriptor);
  target.descriptor = make_temporary(path, target.temporary, [permissions](const std::string& name) {
    int descriptor = system::create(name, permissions);
    for (; descriptor >= 0; descriptor = system::create(name, permissions)) {
      system::mark_as_written(descriptor);
      if (system::has_name(descriptor)) break;  // else another program removed it before it was marked
      (void)system::close(descriptor);
    }
    return descriptor;
  });
}

/// Gives a file without a name a temporary one.
bool name_temporarily(OutputTarget& target, const std::string& path) {
  return make_temporary(path, target.temporary, [&target](const std::string& name) {
           return system::give_name(target.descriptor, name) ? 0 : -1;
         }) == 0;
}

Error cannot_write(std::string_view reason) { return usage_error("cannot be written: {}", reason); }

/// The file that a path leads to. A path that does not lead anywhere, or is too long for the system, stays as it is.
/// Throws: Error (usage) for a link that cannot be followed.
std::string target_of(const std::string& path) {
  std::error_code error, none;
  std::string target = system::path_text(std::filesystem::canonical(path, error));
  if (!error) return target;
  if (std::filesystem::is_symlink(path, none)) throw cannot_write(error.message()).in(path);
  return path;
}

/// The number of a descriptor that the program inherited, from a name such as /dev/stdout or /dev/fd/3: writing
/// continues at its offset, also if it is a file.
std::optional<int> own_descriptor(std::string_view path) {
  if (path == "/dev/stdout") return system::standard_output;
  if (path == "/dev/stderr") return system::standard_error;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view number = path.substr(folder.size());
    int descriptor = -1;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
    if (error == std::errc() && end == number.data() + number.size()) return descriptor;
  }
  return std::nullopt;
}

}  // namespace

std::string folder_of(const std::string& path) { return system::path_text(std::filesystem::path(path).parent_path()); }

void remove_left_temporaries(const std::string& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    std::error_code none;
    const std::filesystem::path& path = entry->path();
    if (!is_unfinished_name(system::path_text(path.filename())) || !entry->is_regular_file(none)) continue;
    system::remove_unless_written(system::path_text(path));
  }
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw usage_error("the folder cannot be created: {}", error.message()).in(path);
}

OutputTarget::~OutputTarget() {
  if (!temporary.empty()) {
    const std::lock_guard lock(temporary_files().mutex);
    system::remove(temporary);
    temporary_files().all.erase(temporary);
  }
  if (descriptor > system::standard_error) (void)system::close(descriptor);
}

Output::Output(std::string path, bool begins_last) : path_(std::move(path)) {
  const Compression compression = compression_of(path_);
  open();
  if (compression != Compression::none) compressor_.emplace(compression);
  if (!begins_last || (open_.is_file && !compressor_)) return;
  spool_ = std::make_unique<OutputTarget>();
  spool_->descriptor = system::create_temporary();
  if (spool_->descriptor < 0)
    throw usage_error("this output needs a temporary file, which cannot be created: {}", system::error_text())
        .in(shown_name());
}

void Output::open() {
  if (path_ == "-") return;
  if (const auto own = own_descriptor(path_)) {
    open_.descriptor = system::duplicate(*own);
    if (open_.descriptor < 0) fail_to_write();
    return;
  }
  const auto before = system::status_of(path_);
  if (before && !before->is_regular) {  // /dev/null or a pipe: written in place
    open_.descriptor = system::open_to_write(path_);
    if (open_.descriptor < 0) fail_to_write();
    return;
  }
  if (before) path_ = target_of(path_);
  if (before && !system::may_write(path_)) fail_to_write();
  constexpr unsigned for_owner = 0600, for_all = 0666;
  open_new(open_, path_, before ? for_owner : for_all);
  if (open_.descriptor < 0) fail_to_write();
  if (before && !system::set_permissions(open_.descriptor, before->permissions)) fail_to_write();
}

void Output::fail_to_write() const { throw cannot_write(system::error_text()).in(shown_name()); }

void Output::write(std::string_view text) {
  if (!live_ && text.size() < write_size) {
    pending_ += text;
    if (pending_.size() >= write_size) flush();
    return;
  }
  flush();
  put(text);
}

void Output::flush() {
  put(pending_);
  pending_.clear();
}

void Output::put(std::string_view text) { spool_ == nullptr ? send_compressed(text) : send(spool_->descriptor, text); }

void Output::send_compressed(std::string_view bytes, bool last) {
  compressor_ ? send(open_.descriptor, compressor_->add(bytes, last)) : send(open_.descriptor, bytes);
}

void Output::send(int descriptor, std::string_view bytes) const {
  if (system::write(descriptor, bytes)) return;
  if (system::failed_as_closed_pipe()) end_without_unfinished(system::end_by_closed_pipe);
  fail_to_write();
}

void Output::write_beginning(std::string_view bytes) {
  flush();
  const int descriptor = spool_ == nullptr ? open_.descriptor : spool_->descriptor;
  if (!system::go_to_begin(descriptor)) fail_to_write();
  send(descriptor, bytes);
  if (!system::go_to_end(descriptor)) fail_to_write();
}

void Output::send_spooled() {
  const int spool = spool_->descriptor;
  if (!system::go_to_begin(spool)) fail_to_write();
  std::string bytes(write_size, '\0');
  for (std::ptrdiff_t count = 1; count != 0;) {
    count = system::read(spool, bytes.data(), bytes.size());
    if (count < 0) fail_to_write();
    if (count > 0) send_compressed({bytes.data(), static_cast<std::size_t>(count)});
  }
  spool_.reset();
}

void Output::commit() {
  flush();
  if (spool_ != nullptr) send_spooled();
  if (compressor_) send_compressed("", true);
  if (path_ == "-") return;
  if (open_.is_file && !system::complete(open_.descriptor)) fail_to_write();  // writing may fail as late as here
  if (open_.is_file) give_final_name();
  const bool closes = system::close(std::exchange(open_.descriptor, -1));
  if (!closes && !open_.is_file) fail_to_write();
}

/// A file without a name gets its own at once, unless that replaces another file: then it has a temporary one first, as
/// no system replaces a file in one step by one without a name.
void Output::give_final_name() {
  if (open_.temporary.empty() && system::give_name(open_.descriptor, path_)) return;
  if (open_.temporary.empty() && !name_temporarily(open_, path_)) fail_to_write();
  const std::lock_guard lock(temporary_files().mutex);
  if (!system::replace(open_.temporary, path_)) fail_to_write();
  temporary_files().all.erase(std::exchange(open_.temporary, ""));
}

void end_when_interrupted() { system::call_when_interrupted(end_interrupted); }

void remove_unfinished_when_interrupted() {
  system::call_in_thread_when_interrupted([] { end_without_unfinished(end_interrupted); });
}

}  // namespace tcb
