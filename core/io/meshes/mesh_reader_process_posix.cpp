// The C++ library cannot start a process with limits, read from it and kill it, and core does not use Qt. The
// program's POSIX calls are all in this file.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "core/io/meshes/mesh_reader_process.h"

namespace noonmark {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* readerName = "noonmark-mesh-reader";
constexpr int stopLookMs = 50;
constexpr const char* exportAgain = "Export it again, or in smaller files";

std::optional<std::filesystem::path> readerProgram() {
    std::error_code error;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (const auto& place : {folder / readerName, folder / NOONMARK_HELPER_FOLDER / readerName})
        if (::access(place.c_str(), X_OK) == 0) return place;
    return std::nullopt;
}

struct Pipe {
    int from = -1;
    int into = -1;
    Pipe() {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) return;
        from = ends[0];
        into = ends[1];
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        closeInto();
        if (from >= 0) ::close(from);
    }
    void closeInto() {
        if (into >= 0) ::close(into);
        into = -1;
    }
};

// The new process inherits only the pipe; its signals have their defaults. It has a process group of its own:
// Ctrl-C goes to this process, which then ends the reader.
int spawned(const std::string& program, const std::vector<std::string>& words, int into, pid_t& process) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, into, sceneDescriptor);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, sceneDescriptor + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    std::vector<char*> arguments{const_cast<char*>(program.c_str())};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error =
        posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// The running reader; killed at the latest when this object is destroyed.
class ReaderProcess {
public:
    ReaderProcess() = default;
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess() { end(); }

    bool start(const std::string& program, const std::vector<std::string>& words, int into) {
        return spawned(program, words, into, process_) == 0;
    }
    void end() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
    }
    // Its exit status after it has closed its pipe; killed if it continues to run.
    int status() {
        for (int i = 0; i < 1000 && process_ > 0; ++i) {
            if (::waitpid(process_, &status_, WNOHANG) != 0) process_ = -1;
            if (process_ > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        end();
        return status_;
    }

private:
    pid_t process_ = -1;
    int status_ = 0;
};

tl::unexpected<Error> readerStopped(const std::string& why, const std::filesystem::path& file) {
    return failure("The mesh could not be read: its reader " + why, file.string(), exportAgain);
}

tl::unexpected<Error> tookTooLong(const std::filesystem::path& file, double limit, const char* of) {
    return readerStopped(fmt::format("took too long (more than {:.0f} s{})", limit, of), file);
}

tl::unexpected<Error> endedEarly(int status, const std::filesystem::path& file,
                                 const MeshReaderLimits& limits) {
    const bool exited = WIFEXITED(status);
    if (exited && WEXITSTATUS(status) == exitOutOfMemory) return readerStopped("ran out of memory", file);
    if (exited) return readerStopped(fmt::format("ended early (code {})", WEXITSTATUS(status)), file);
    if (WTERMSIG(status) == SIGXCPU) return tookTooLong(file, limits.cpuSeconds, " of processor time");
    if (WTERMSIG(status) == SIGKILL)
        return readerStopped("was stopped by the system (most likely for lack of memory)", file);
    return readerStopped(fmt::format("crashed (signal {})", WTERMSIG(status)), file);
}

// Reads everything from the pipe until it is closed.
Result<std::string> receive(int from, const std::filesystem::path& file, const MeshReaderLimits& limits,
                            const std::stop_token& stop) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
    std::string bytes;
    std::vector<char> block(std::size_t(1) << 20);
    while (true) {
        if (stop.stop_requested()) return cancelled();
        if (Clock::now() > deadline) return tookTooLong(file, limits.seconds, "");
        pollfd ready{from, POLLIN, 0};
        if (::poll(&ready, 1, stopLookMs) <= 0) continue;
        const ssize_t count = ::read(from, block.data(), block.size());
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count <= 0) return bytes;
        bytes.append(block.data(), std::size_t(count));
        if (bytes.size() > limits.resultBytes)
            return failure(fmt::format("The mesh is too large: it has more than {:.0f} MB of triangles",
                                       double(limits.resultBytes) / 1e6),
                           file.string(), "Divide it into several files");
    }
}

}  // namespace

MeshReaderLimits meshReaderLimits(std::uintmax_t fileBytes) {
    MeshReaderLimits limits;
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long pageBytes = ::sysconf(_SC_PAGESIZE);
    if (pages > 0 && pageBytes > 0)
        limits.memoryBytes =
            std::min(limits.memoryBytes, std::uint64_t(pages) * std::uint64_t(pageBytes) / 2);
    limits.cpuSeconds += double(fileBytes) / 1e6;
    limits.seconds += 4 * double(fileBytes) / 1e6;
    return limits;
}

Result<MeshScene> readMeshScene(const std::filesystem::path& file, const MeshReaderLimits& limits,
                                const std::stop_token& stop) {
    const auto program = readerProgram();
    if (!program)
        return failure("The program that reads meshes is missing", readerName, "Install Noonmark again");
    Pipe pipe;
    if (pipe.from < 0) return readerStopped("could not be started (too many open files)", file);
    // A larger pipe needs fewer reads; if refused, the default works too
    ::fcntl(pipe.from, F_SETPIPE_SZ, 1 << 20);
    ReaderProcess reader;
    const std::vector<std::string> words{std::to_string(limits.memoryBytes),
                                         fmt::format("{:.0f}", std::max(1.0, limits.cpuSeconds)),
                                         file.string()};
    if (!reader.start(program->string(), words, pipe.into))
        return readerStopped("could not be started", file);
    pipe.closeInto();
    auto bytes = receive(pipe.from, file, limits, stop);
    if (!bytes) return tl::make_unexpected(bytes.error());
    bool complete = false;
    auto scene = parseScene(*bytes, complete);
    if (complete) return scene;
    return endedEarly(reader.status(), file, limits);
}

}  // namespace noonmark
