#include "tests/fuzz/fuzz_file.h"

#include <fcntl.h>
#include <sanitizer/lsan_interface.h>
#include <sqlite3.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "core/base/gdal_calls.h"
#include "tests/fuzz/require.h"

namespace noonmark::tests {

namespace {

// Configures SQLite, which GDAL and PROJ use too, without locks and with its pages in one piece of memory:
// allocations on the sanitizer's heap would dominate the run time.
void quickenSqlite() {
    constexpr int pageBytes = 4096 + 256, pages = 4096;
    static std::vector<char> memory(std::size_t(pageBytes) * pages);
    sqlite3_config(SQLITE_CONFIG_SINGLETHREAD);
    sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
    sqlite3_config(SQLITE_CONFIG_PAGECACHE, memory.data(), pageBytes, pages);
}

// GDAL never frees what it initialises once per process; that must not count as a leak of the first input.
void prepareGdal() {
    const __lsan::ScopedDisabler once;
    const GdalCalls calls;
}

struct Surroundings {
    Surroundings() {
        quickenSqlite();
        prepareGdal();
        std::string pattern = (std::filesystem::temp_directory_path() / "noonmark-fuzz-XXXXXX").string();
        require(::mkdtemp(pattern.data()) != nullptr, "there is a temporary folder");
        folder = pattern;
    }
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;
    ~Surroundings() {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }

    std::filesystem::path folder;
    tbb::global_control oneThread{tbb::global_control::max_allowed_parallelism, 1};
};

}  // namespace

const std::filesystem::path& fuzzFolder() {
    static const Surroundings surroundings;
    return surroundings.folder;
}

std::filesystem::path fuzzFile(const std::string& name, std::string_view bytes) {
    std::filesystem::path path = fuzzFolder() / name;
    const int file = ::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
    require(file >= 0, "the input's file can be made");
    require(::write(file, bytes.data(), bytes.size()) == ssize_t(bytes.size()), "the input is written");
    ::close(file);
    return path;
}

}  // namespace noonmark::tests
