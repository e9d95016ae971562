#include "core/io/files/companion_files.h"

#include <cctype>
#include <string>

namespace noonmark {

namespace {

std::vector<const char*> companionEndings(std::string ending) {
    for (char& letter : ending) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    if (ending == ".shp") return {".dbf", ".shx", ".prj", ".cpg"};
    if (ending == ".gltf") return {".bin"};
    if (ending == ".asc" || ending == ".tif" || ending == ".tiff") return {".prj", ".tfw"};
    return {};
}

}  // namespace

std::vector<std::filesystem::path> listCompanionFiles(const std::filesystem::path& file) {
    std::vector<std::filesystem::path> companions;
    for (const char* ending : companionEndings(file.extension().string()))
        companions.push_back(std::filesystem::path(file).replace_extension(ending));
    return companions;
}

}  // namespace noonmark
