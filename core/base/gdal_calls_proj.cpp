#include "core/base/gdal_calls.h"

#include <proj.h>
#include <cstdio>
#include <string_view>

namespace noonmark {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> listProjFolders() {
#ifdef _WIN32
    constexpr char separator = ';';
#else
    constexpr char separator = ':';
#endif
    std::vector<fs::path> folders;
    const PJ_INFO info = proj_info();
    std::string_view rest = info.searchpath != nullptr ? info.searchpath : "";
    while (!rest.empty()) {
        const std::string_view folder = rest.substr(0, rest.find(separator));
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
        if (!folder.empty()) folders.push_back(fs::path(folder).lexically_normal());
    }
    return folders;
}

// Those of the user and of the installation; they do not change while the program runs.
const std::vector<fs::path>& projFolders() {
    static const std::vector<fs::path> folders = listProjFolders();
    return folders;
}

bool isPlainFile(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
}

bool liesInProjFolder(const fs::path& file) {
    const fs::path folder = file.lexically_normal().parent_path();
    for (const fs::path& own : projFolders())
        if (folder == own || folder / "" == own) return isPlainFile(file);
    return false;
}

std::FILE* streamOf(PROJ_FILE_HANDLE* file) { return reinterpret_cast<std::FILE*>(file); }

PROJ_FILE_HANDLE* openFile(PJ_CONTEXT*, const char* name, PROJ_OPEN_ACCESS access, void*) {
    if (access != PROJ_OPEN_ACCESS_READ_ONLY || !liesInProjFolder(name)) return nullptr;
    return reinterpret_cast<PROJ_FILE_HANDLE*>(std::fopen(name, "rb"));
}
std::size_t readFile(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void* bytes, std::size_t count, void*) {
    return std::fread(bytes, 1, count, streamOf(file));
}
std::size_t writeNothing(PJ_CONTEXT*, PROJ_FILE_HANDLE*, const void*, std::size_t, void*) { return 0; }
int seekFile(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, long long to, int from, void*) {
    return std::fseek(streamOf(file), long(to), from) == 0 ? 1 : 0;
}
unsigned long long positionInFile(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) {
    return static_cast<unsigned long long>(std::ftell(streamOf(file)));
}
void closeFile(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) { std::fclose(streamOf(file)); }
int isThere(PJ_CONTEXT*, const char* name, void*) { return liesInProjFolder(name) ? 1 : 0; }
int changeNothing(PJ_CONTEXT*, const char*, void*) { return 0; }
int moveNothing(PJ_CONTEXT*, const char*, const char*, void*) { return 0; }

constexpr PROJ_FILE_API files{1,         openFile, readFile,      writeNothing,  seekFile,   positionInFile,
                              closeFile, isThere,  changeNothing, changeNothing, moveNothing};

// A context does not inherit the functions that open files, but it inherits this one, which it calls for
// proj.ini and proj.db before it opens any other file. PROJ then looks in its own folders as usual.
const char* confineContext(PJ_CONTEXT* context, const char*, void*) {
    proj_context_set_fileapi(context, &files, nullptr);
    return nullptr;
}

}  // namespace

void confineProj() {
    (void)projFolders();
    proj_context_set_fileapi(nullptr, &files, nullptr);
    proj_context_set_file_finder(nullptr, confineContext, nullptr);
}

bool isProjFile(const std::string& name) {
    if (fs::path(name).has_parent_path()) return false;
    for (const fs::path& folder : projFolders())
        if (isPlainFile(folder / name)) return true;
    return false;
}

}  // namespace noonmark
