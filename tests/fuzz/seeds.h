#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace noonmark::tests {

/// Where the seeds go: a folder a target.
struct SeedFolder {
    std::filesystem::path path;

    [[nodiscard]] std::filesystem::path file(const std::string& target, const std::string& name) const;
    void write(const std::string& target, const std::string& name, std::string_view bytes) const;
};

void makeGdalSeeds(const SeedFolder& seeds);  ///< seeds_gdal.cpp: files of formats that GDAL writes
void makeOsmSeeds(const SeedFolder& seeds);   ///< seeds_osm.cpp: OpenStreetMap PBF
void makeMeshSeeds(const SeedFolder& seeds);  ///< seeds_mesh.cpp: meshes, and scenes as they are handed over
void makeProjectSeeds(const SeedFolder& seeds);  ///< seeds_project.cpp: project files and what they hold

/// Makes an SQLite file as small as it can be. In seeds_project.cpp.
void shrink(const std::filesystem::path& database);

/// A number in this machine's byte order, appended.
template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace noonmark::tests
