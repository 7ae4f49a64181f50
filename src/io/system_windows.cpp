// System: files, terminals and interruptions by Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// after windows.h, whose types it needs
#include <shellapi.h>
#undef near  // an empty macro

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <filesystem>
#include <memory>
#include <system_error>

#include "io/system.hpp"

namespace tcb::system {
namespace {

/// A path for the functions of Windows. Those beyond the old limit of lengths get the prefix that lifts it.
std::wstring native(const std::string& path) {
  constexpr std::size_t most_without_prefix = 240;
  if (path == "/dev/null") return L"NUL";
  const std::filesystem::path given(path);
  if (given.native().size() < most_without_prefix) return given.native();
  std::error_code none;
  std::filesystem::path absolute = std::filesystem::absolute(given, none);
  absolute.make_preferred();
  const std::wstring& text = absolute.native();
  const bool has_prefix = none || text.starts_with(LR"(\\)");
  return has_prefix ? text : LR"(\\?\)" + text;
}

std::string in_utf8(const wchar_t* text, int size) {
  const int room = ::WideCharToMultiByte(CP_UTF8, 0, text, size, nullptr, 0, nullptr, nullptr);
  std::string result(static_cast<std::size_t>(room), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text, size, result.data(), room, nullptr, nullptr);
  return result;
}

std::int64_t whole(std::uint32_t high, std::uint32_t low) {
  return static_cast<std::int64_t>((std::uint64_t{high} << 32U) | low);
}

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

std::optional<FileStatus> status_of_handle(HANDLE handle) {
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileType(handle) != FILE_TYPE_DISK) {
    return handle == INVALID_HANDLE_VALUE ? std::nullopt : std::optional(FileStatus{});
  }
  if (::GetFileInformationByHandle(handle, &info) == 0) return std::nullopt;
  FileStatus status;
  status.is_regular = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0;
  status.size = static_cast<std::uintmax_t>(whole(info.nFileSizeHigh, info.nFileSizeLow));
  status.modified = whole(info.ftLastWriteTime.dwHighDateTime, info.ftLastWriteTime.dwLowDateTime);
  FILE_BASIC_INFO times{};
  const bool has_times = ::GetFileInformationByHandleEx(handle, FileBasicInfo, &times, sizeof times) != 0;
  status.changed = has_times ? times.ChangeTime.QuadPart : status.modified;
  status.identity = {info.dwVolumeSerialNumber,
                     static_cast<std::uint64_t>(whole(info.nFileIndexHigh, info.nFileIndexLow))};
  return status;
}

/// Opens a file whose time of modification or status is wanted.
HANDLE open_handle(const std::string& path, DWORD access) {
  constexpr DWORD all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return ::CreateFileW(native(path).c_str(), access, all, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

/// Opens a file as a descriptor that passes bytes as they are, and that does not keep others from renaming the file.
int open_descriptor(const std::string& path, DWORD access, DWORD creation, int flags) {
  constexpr DWORD all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE handle =
      ::CreateFileW(native(path).c_str(), access, all, nullptr, creation, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return -1;
  const int descriptor = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0) ::CloseHandle(handle);
  return descriptor;
}

std::atomic<void (*)()> end_program{nullptr};

BOOL WINAPI handle_event(DWORD) {
  end_program.load()();
  return TRUE;
}

}  // namespace

std::vector<std::string> arguments(int argc, char** argv) {
  int count = 0;
  const std::unique_ptr<wchar_t*, void (*)(wchar_t**)> words(::CommandLineToArgvW(::GetCommandLineW(), &count),
                                                             [](wchar_t** list) { ::LocalFree(list); });
  if (words == nullptr) return {argv + std::min(argc, 1), argv + argc};
  std::vector<std::string> texts;
  for (int i = 1; i < count; ++i) {
    const wchar_t* const word = words.get()[i];
    texts.push_back(in_utf8(word, static_cast<int>(std::wcslen(word))));
  }
  return texts;
}

std::string error_text() {
  const DWORD code = ::GetLastError();
  const std::error_code error(static_cast<int>(code), std::system_category());
  const std::error_condition known = error.default_error_condition();  // in the words that other systems have
  if (known.category() == std::generic_category()) return known.message();
  std::array<wchar_t, 512> text{};
  DWORD size = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, code, 0,
                                text.data(), static_cast<DWORD>(text.size()), nullptr);
  while (size > 0 && (text[size - 1] == L'\n' || text[size - 1] == L'\r' || text[size - 1] == L'.')) --size;
  if (size == 0) return "error " + std::to_string(code) + " of Windows";
  return in_utf8(text.data(), static_cast<int>(size));
}

bool already_exists() {
  const DWORD code = ::GetLastError();
  return code == ERROR_FILE_EXISTS || code == ERROR_ALREADY_EXISTS;
}

/// Folders cannot be opened to read; see open_to_read().
bool failed_as_folder() { return ::GetLastError() == ERROR_DIRECTORY; }

bool failed_as_closed_pipe() {
  const DWORD code = ::GetLastError();
  return code == ERROR_BROKEN_PIPE || code == ERROR_NO_DATA || code == ERROR_PIPE_NOT_CONNECTED;
}

std::optional<FileStatus> status_of(const std::string& path) {
  const HANDLE handle = open_handle(path, FILE_READ_ATTRIBUTES);
  if (handle == INVALID_HANDLE_VALUE) return std::nullopt;
  const std::optional<FileStatus> status = status_of_handle(handle);
  ::CloseHandle(handle);
  return status;
}

std::optional<FileStatus> status_of(int descriptor) { return status_of_handle(handle_of(descriptor)); }

bool may_write(const std::string& path) {
  const HANDLE handle = open_handle(path, GENERIC_WRITE);
  if (handle == INVALID_HANDLE_VALUE) return false;
  ::CloseHandle(handle);
  return true;
}

void make_older(const std::string& path, const std::string& than) {
  const std::optional<FileStatus> newer = status_of(than);
  const HANDLE handle = newer ? open_handle(path, FILE_WRITE_ATTRIBUTES) : INVALID_HANDLE_VALUE;
  if (handle == INVALID_HANDLE_VALUE) return;
  const auto time = static_cast<std::uint64_t>(newer->modified - 1);
  const FILETIME modified{static_cast<DWORD>(time), static_cast<DWORD>(time >> 32U)};
  (void)::SetFileTime(handle, nullptr, nullptr, &modified);
  ::CloseHandle(handle);
}

int open_to_read(const std::string& path) {
  const DWORD attributes = ::GetFileAttributesW(native(path).c_str());
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
    ::SetLastError(ERROR_DIRECTORY);
    return -1;
  }
  return open_descriptor(path, GENERIC_READ, OPEN_EXISTING, _O_RDONLY);
}

int open_to_write(const std::string& path) { return open_descriptor(path, GENERIC_WRITE, OPEN_EXISTING, _O_WRONLY); }

int duplicate(int descriptor) { return ::_dup(descriptor); }
bool close(int descriptor) { return ::_close(descriptor) == 0; }
bool complete(int) { return true; }

std::ptrdiff_t read(int descriptor, char* bytes, std::size_t size) {
  DWORD count = 0;
  constexpr std::size_t most = 1U << 30U;
  if (::ReadFile(handle_of(descriptor), bytes, static_cast<DWORD>(std::min(size, most)), &count, nullptr) != 0) {
    return static_cast<std::ptrdiff_t>(count);
  }
  const DWORD code = ::GetLastError();
  return code == ERROR_BROKEN_PIPE || code == ERROR_HANDLE_EOF ? 0 : -1;
}

bool wait_to_read(int descriptor, std::chrono::milliseconds most) {
  constexpr DWORD pause = 5;
  for (auto waited = std::chrono::milliseconds(0);; waited += std::chrono::milliseconds(pause)) {
    DWORD bytes = 0;
    if (::GetFileType(handle_of(descriptor)) != FILE_TYPE_PIPE) return false;  // a console
    if (::PeekNamedPipe(handle_of(descriptor), nullptr, 0, nullptr, &bytes, nullptr) == 0 || bytes > 0) return true;
    if (waited >= most) return false;
    ::Sleep(pause);
  }
}

std::ptrdiff_t read_at(int descriptor, std::uint64_t place, char* bytes, std::size_t size) {
  OVERLAPPED at{};
  at.Offset = static_cast<DWORD>(place);
  at.OffsetHigh = static_cast<DWORD>(place >> 32U);
  DWORD count = 0;
  constexpr std::size_t most = 1U << 30U;
  if (::ReadFile(handle_of(descriptor), bytes, static_cast<DWORD>(std::min(size, most)), &count, &at) != 0) {
    return static_cast<std::ptrdiff_t>(count);
  }
  return ::GetLastError() == ERROR_HANDLE_EOF ? 0 : -1;
}

std::uint64_t place_in(int descriptor) {
  const std::int64_t place = ::_lseeki64(descriptor, 0, SEEK_CUR);
  return place < 0 ? 0 : static_cast<std::uint64_t>(place);
}

bool write(int descriptor, std::string_view bytes) {
  constexpr std::size_t most = 1U << 30U;
  while (!bytes.empty()) {
    DWORD count = 0;
    const auto size = static_cast<DWORD>(std::min(bytes.size(), most));
    if (::WriteFile(handle_of(descriptor), bytes.data(), size, &count, nullptr) == 0) return false;
    bytes.remove_prefix(count);
  }
  return true;
}

bool go_to_begin(int descriptor) { return ::_lseeki64(descriptor, 0, SEEK_SET) >= 0; }
bool go_to_end(int descriptor) { return ::_lseeki64(descriptor, 0, SEEK_END) >= 0; }

void keep_standard_streams() {
  for (const int stream : {standard_input, standard_output, standard_error}) {
    if (::_get_osfhandle(stream) >= 0) (void)::_setmode(stream, _O_BINARY);
  }
  (void)std::setvbuf(stderr, nullptr, _IONBF, 0);  // messages are in order with rows, as on other systems
  ::SetConsoleOutputCP(CP_UTF8);
}

int create_unnamed(const std::string&, unsigned) { return -1; }
bool give_name(int, const std::string&) { return false; }

int create(const std::string& name, unsigned) {
  return open_descriptor(name, GENERIC_READ | GENERIC_WRITE, CREATE_NEW, _O_RDWR);
}

int create_temporary() {
  std::array<wchar_t, MAX_PATH + 1> folder{}, name{};
  if (::GetTempPathW(static_cast<DWORD>(folder.size()), folder.data()) == 0) return -1;
  if (::GetTempFileNameW(folder.data(), L"tcb", 0, name.data()) == 0) return -1;
  const HANDLE handle = ::CreateFileW(name.data(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, CREATE_ALWAYS,
                                      FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return -1;
  return ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_RDWR | _O_BINARY | _O_NOINHERIT);
}

/// Files inherit their permissions from their folder.
bool set_permissions(int, unsigned) { return true; }

bool replace(const std::string& name, const std::string& replaced) {
  return ::MoveFileExW(native(name).c_str(), native(replaced).c_str(),
                       MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0;
}

void remove(const std::string& name) { (void)::DeleteFileW(native(name).c_str()); }

/// A file that is open is marked: nobody can open it without sharing it.
void mark_as_written(int) {}
bool has_name(int) { return true; }

void remove_unless_written(const std::string& name) {
  const HANDLE handle =
      ::CreateFileW(native(name).c_str(), DELETE, 0, nullptr, OPEN_EXISTING, FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (handle != INVALID_HANDLE_VALUE) ::CloseHandle(handle);
}

bool is_terminal(int descriptor) {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(descriptor), &mode) != 0;
}

std::size_t terminal_width() {
  constexpr std::size_t usual = 80;
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (::GetConsoleScreenBufferInfo(handle_of(standard_error), &info) == 0) return usual;
  const int width = info.srWindow.Right - info.srWindow.Left + 1;
  return width > 0 ? static_cast<std::size_t>(width) : usual;
}

/// Turns on the sequences of colors, which consoles know since Windows 10.
bool has_colors() {
  const HANDLE handle = handle_of(standard_error);
  DWORD mode = 0;
  return ::GetConsoleMode(handle, &mode) != 0 &&
         ::SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

void end_now(int exit) {
  ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(exit));
  std::abort();  // not reached
}

void end_by_closed_pipe() {
  constexpr int closed_pipe = 141;  // as of a process that the signal SIGPIPE ends
  end_now(closed_pipe);
}

void call_when_interrupted(void (*end)()) { call_in_thread_when_interrupted(end); }

/// Windows calls the handler in a thread of its own, also when the console is closed.
void call_in_thread_when_interrupted(void (*end)()) {
  const bool is_first = end_program.exchange(end) == nullptr;
  if (is_first) ::SetConsoleCtrlHandler(handle_event, TRUE);
}

}  // namespace tcb::system
