#include "support/faulty_disc.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "base/files.h"

namespace glisson::test {
namespace fs = std::filesystem;
namespace {

// Where the changed file is named in a call: which argument is a path, and which the folder that it is relative to; or
// which is an open file.
struct Call {
  long number;
  const char* name;
  int path, folder, descriptor;  // -1: none
  int flags;                     // the argument with open()'s flags, or -1
};

constexpr Call calls[] = {
    {SYS_open, "open", 0, -1, -1, 1},
    {SYS_openat, "open", 1, 0, -1, 2},
    {SYS_creat, "open", 0, -1, -1, -1},
    {SYS_write, "write", -1, -1, 0, -1},
    {SYS_pwrite64, "write", -1, -1, 0, -1},
    {SYS_writev, "write", -1, -1, 0, -1},
    {SYS_pwritev, "write", -1, -1, 0, -1},
    {SYS_sendfile, "write", -1, -1, 0, -1},
    {SYS_copy_file_range, "write", -1, -1, 2, -1},
    {SYS_ftruncate, "truncate", -1, -1, 0, -1},
    {SYS_truncate, "truncate", 0, -1, -1, -1},
    {SYS_fallocate, "allocate", -1, -1, 0, -1},
    {SYS_fsync, "flush", -1, -1, 0, -1},
    {SYS_fdatasync, "flush", -1, -1, 0, -1},
    {SYS_rename, "rename", 1, -1, -1, -1},
    {SYS_renameat, "rename", 3, 2, -1, -1},
    {SYS_renameat2, "rename", 3, 2, -1, -1},
    {SYS_link, "link", 1, -1, -1, -1},
    {SYS_linkat, "link", 3, 2, -1, -1},
    {SYS_symlink, "link", 1, -1, -1, -1},
    {SYS_symlinkat, "link", 2, 1, -1, -1},
    {SYS_mkdir, "mkdir", 0, -1, -1, -1},
    {SYS_mkdirat, "mkdir", 1, 0, -1, -1},
    {SYS_unlink, "remove", 0, -1, -1, -1},
    {SYS_unlinkat, "remove", 1, 0, -1, -1},
    {SYS_rmdir, "remove", 0, -1, -1, -1},
};

// Stops at the calls above; open() only where it writes, creates or truncates.
std::vector<sock_filter> filter() {
  std::vector<sock_filter> code{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AUDIT_ARCH_X86_64, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
  };
  for (const Call& call : calls) {
    if (call.flags < 0) {
      code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call.number), 0, 1));
      code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
      continue;
    }
    const auto low_word = offsetof(seccomp_data, args) + 8 * static_cast<unsigned>(call.flags);
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call.number), 0, 4));
    code.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(low_word)));
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, O_WRONLY | O_RDWR | O_CREAT | O_TRUNC, 0, 1));
    code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
    code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  return code;
}

// In the child: returns the watcher's end, or -1.
int watch_me() {
  auto code = filter();
  const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
  return static_cast<int>(::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

std::string text_at(pid_t process, std::uint64_t address);
std::string link_of(pid_t process, const std::string& what);

class Watch {
 public:
  Watch(const fs::path& folder, int listener, pid_t child, Fault fault, std::size_t at, DiscRun& run)
      : folder_(fs::canonical(folder).string()),
        listener_(listener),
        child_(child),
        fault_(fault),
        at_(at),
        run_(run) {}

  // Answers one call; false when the child has ended.
  bool answer() {
    seccomp_notif asked;
    std::memset(&asked, 0, sizeof asked);
    if (::ioctl(listener_, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) return errno == EINTR || errno == ENOENT;
    seccomp_notif_resp answer{asked.id, 0, 0, 0};
    answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    const auto* call =
        std::find_if(std::begin(calls), std::end(calls), [&](const Call& one) { return one.number == asked.data.nr; });
    const std::string file = file_of(*call, asked);
    const bool below = (file + "/").starts_with(folder_ + "/");
    if (below) {
      const std::string stop =
          std::string(call->name) + " " + (file == folder_ ? "." : file.substr(folder_.size() + 1));
      if (run_.stops.size() == at_) fail(asked, answer);
      // After a short write there is no more space in that file.
      else if (cut_file_ == file && std::string_view(call->name) == "write")
        refuse(answer, ENOSPC);
      if (run_.stops.size() == at_ && fault_ == Fault::short_write) cut_file_ = file;
      run_.stops.push_back(stop);
    } else if (is_elsewhere(file)) {
      run_.outside.push_back(std::string(call->name) + " " + file);
    }
    ::ioctl(listener_, SECCOMP_IOCTL_NOTIF_SEND, &answer);
    return true;
  }

 private:
  void fail(const seccomp_notif& asked, seccomp_notif_resp& answer) {
    switch (fault_) {
      case Fault::none: return;
      case Fault::no_space: return refuse(answer, ENOSPC);
      case Fault::not_allowed: return refuse(answer, EACCES);
      case Fault::interrupted: return refuse(answer, EINTR);
      case Fault::killed: ::kill(child_, SIGKILL); return refuse(answer, EINTR);
      case Fault::short_write: return write_half(asked, answer);
    }
  }

  static void refuse(seccomp_notif_resp& answer, int code) {
    answer.flags = 0;
    answer.error = -code;
  }

  // In the child's place, through its own descriptor.
  void write_half(const seccomp_notif& asked, seccomp_notif_resp& answer) const {
    const auto length = static_cast<std::size_t>(asked.data.args[2]);
    if (asked.data.nr != SYS_write || length < 2) return refuse(answer, ENOSPC);
    const int process = static_cast<int>(::syscall(SYS_pidfd_open, child_, 0));
    const int descriptor =
        static_cast<int>(::syscall(SYS_pidfd_getfd, process, static_cast<int>(asked.data.args[0]), 0));
    std::string bytes(std::min<std::size_t>(length / 2, 1 << 20), '\0');
    const iovec here{bytes.data(), bytes.size()}, there{reinterpret_cast<void*>(asked.data.args[1]), bytes.size()};
    const auto read = ::process_vm_readv(child_, &here, 1, &there, 1, 0);
    const auto written = read > 0 ? ::write(descriptor, bytes.data(), static_cast<std::size_t>(read)) : -1;
    if (descriptor >= 0) ::close(descriptor);
    if (process >= 0) ::close(process);
    if (written <= 0) return refuse(answer, ENOSPC);
    answer.flags = 0;
    answer.val = written;
  }

  static std::string file_of(const Call& call, const seccomp_notif& asked) {
    const auto process = static_cast<pid_t>(asked.pid);
    const auto& arguments = asked.data.args;
    if (call.descriptor >= 0) {
      return link_of(process, "fd/" + std::to_string(static_cast<int>(arguments[call.descriptor])));
    }
    fs::path path = text_at(process, arguments[call.path]);
    if (path.is_relative()) {
      const int at = call.folder < 0 ? AT_FDCWD : static_cast<int>(arguments[call.folder]);
      path = fs::path(link_of(process, at == AT_FDCWD ? "cwd" : "fd/" + std::to_string(at))) / path;
    }
    std::error_code problem;
    // The folder's links are followed; the file's own may be what is made or removed.
    const fs::path parent = fs::weakly_canonical(path.parent_path(), problem);
    return (problem ? path : parent / path.filename()).lexically_normal().string();
  }

  static bool is_elsewhere(const std::string& file) {
    for (const char* harmless : {"/dev/", "/proc/", "/memfd:", "pipe:", "socket:", "anon_inode:"}) {
      if (file.starts_with(harmless)) return false;
    }
    return !file.empty();
  }

  std::string folder_;
  int listener_;
  pid_t child_;
  Fault fault_;
  std::size_t at_;
  DiscRun& run_;
  std::string cut_file_;
};

std::string text_at(pid_t process, std::uint64_t address) {
  std::string text;
  char page[256];
  while (text.size() < PATH_MAX) {
    const std::size_t wanted = sizeof page - address % sizeof page;  // never across the end of what is mapped
    const iovec here{page, wanted}, there{reinterpret_cast<void*>(address), wanted};
    const auto read = ::process_vm_readv(process, &here, 1, &there, 1, 0);
    if (read <= 0) break;
    const std::string_view got(page, static_cast<std::size_t>(read));
    text += got.substr(0, got.find('\0'));
    if (got.find('\0') != std::string_view::npos) break;
    address += static_cast<std::uint64_t>(read);
  }
  return text;
}

std::string link_of(pid_t process, const std::string& what) {
  std::error_code problem;
  return fs::read_symlink("/proc/" + std::to_string(process) + "/" + what, problem).string();
}

void send_descriptor(int through, int descriptor) {
  char byte = 'x';
  iovec data{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(header), &descriptor, sizeof(int));
  ::sendmsg(through, &message, 0);
}

int received_descriptor(int through) {
  char byte = 0;
  iovec data{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  if (::recvmsg(through, &message, MSG_CMSG_CLOEXEC) <= 0) return -1;
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (header == nullptr) return -1;
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(header), sizeof(int));
  return descriptor;
}

}  // namespace

DiscRun run_on_faulty_disc(const fs::path& folder, const std::vector<std::string>& words, Fault fault, std::size_t at) {
  DiscRun run;
  const TemporaryFolder streams;
  fs::create_directories(folder / "tmp");
  fs::create_directories(folder / "home");
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return run;
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const std::string out = (streams.path() / "out").string(), err = (streams.path() / "err").string();
  const std::string tmp = (folder / "tmp").string(), home = (folder / "home").string();

  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("TMPDIR", tmp.c_str(), 1);
    ::setenv("HOME", home.c_str(), 1);
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // the driver's, of no patient
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) ::unsetenv(name);
    ::dup2(::open("/dev/null", O_RDONLY), 0);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600), 1);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600), 2);
    const int listener = watch_me();
    if (listener >= 0) send_descriptor(ends[1], listener);
    if (listener < 0) ::_exit(126);
    ::close(listener);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  const int listener = received_descriptor(ends[0]);
  ::close(ends[0]);
  if (listener >= 0) {
    Watch watch(folder, listener, child, fault, at, run);
    for (;;) {
      pollfd waiting{listener, POLLIN, 0};
      if (::poll(&waiting, 1, -1) < 0 && errno != EINTR) break;
      if ((waiting.revents & POLLIN) == 0 && (waiting.revents & (POLLHUP | POLLERR)) != 0) break;
      if ((waiting.revents & POLLIN) != 0 && !watch.answer()) break;
    }
    ::close(listener);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = read_text_file(out).value_or("");
  run.err = read_text_file(err).value_or("");
  const std::string own = fs::canonical(streams.path()).string();
  std::erase_if(run.outside, [&](const std::string& stop) { return stop.find(own) != std::string::npos; });
  return run;
}

bool can_watch_discs() {
  const TemporaryFolder folder;
  const DiscRun run = run_on_faulty_disc(folder.path(), {"/bin/sh", "-c", "echo x > \"$TMPDIR/file\""});
  return run.exit_code == 0 && !run.stops.empty();
}

std::vector<Fault> faults_of(const std::string& stop) {
  const std::string call = stop.substr(0, stop.find(' '));
  if (call == "write") return {Fault::no_space, Fault::short_write, Fault::interrupted, Fault::killed};
  if (call == "open") return {Fault::no_space, Fault::not_allowed, Fault::interrupted, Fault::killed};
  if (call == "flush") return {Fault::no_space, Fault::interrupted, Fault::killed};
  if (call == "remove") return {Fault::not_allowed, Fault::killed};
  return {Fault::no_space, Fault::not_allowed, Fault::killed};
}

std::string name_of(Fault fault) {
  switch (fault) {
    case Fault::none: return "nothing";
    case Fault::no_space: return "no space";
    case Fault::not_allowed: return "not allowed";
    case Fault::interrupted: return "interrupted";
    case Fault::short_write: return "short write";
    case Fault::killed: return "killed";
  }
  return {};
}

}  // namespace glisson::test
