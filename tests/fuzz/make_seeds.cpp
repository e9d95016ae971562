// Writes the seeds that are not text into the given folder. Run by packaging/fuzz.
#include <cstdlib>
#include <fstream>

#include "tests/fuzz/seeds.h"

namespace noonmark::tests {

std::filesystem::path SeedFolder::file(const std::string& target, const std::string& name) const {
    std::filesystem::create_directories(path / target);
    std::filesystem::remove(path / target / name);
    return path / target / name;
}

void SeedFolder::write(const std::string& target, const std::string& name, std::string_view bytes) const {
    std::ofstream(file(target, name), std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

}  // namespace noonmark::tests

int main(int argc, char** argv) {
    using namespace noonmark::tests;
    if (argc != 2) return EXIT_FAILURE;
    const SeedFolder seeds{argv[1]};
    makeGdalSeeds(seeds);
    makeOsmSeeds(seeds);
    makeMeshSeeds(seeds);
    makeProjectSeeds(seeds);
}
