#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace noonmark::tests {

/// The folder of the seeds, with a folder per fuzz target.
struct SeedFolder {
    std::filesystem::path path;

    [[nodiscard]] std::filesystem::path file(const std::string& target, const std::string& name) const;
    void write(const std::string& target, const std::string& name, std::string_view bytes) const;
};

void makeGdalSeeds(const SeedFolder& seeds);  ///< seeds_gdal.cpp: files of formats that GDAL writes
void makeOsmSeeds(const SeedFolder& seeds);   ///< seeds_osm.cpp: OpenStreetMap PBF
void makeMeshSeeds(
    const SeedFolder& seeds);  ///< seeds_mesh.cpp: meshes, and scenes as the reader's process passes them on
void makeProjectSeeds(const SeedFolder& seeds);  ///< seeds_project.cpp: project files and their parts

/// Makes an SQLite file as small as possible. Defined in seeds_project.cpp.
void shrink(const std::filesystem::path& database);

/// Appends a number in this machine's byte order.
template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace noonmark::tests
