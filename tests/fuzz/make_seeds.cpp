// Writes the seeds that are not text into the given folder. Run by packaging/fuzz.
#include <cstdlib>
#include <fstream>

#include "tests/core/io/zip_files.h"
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

namespace {

constexpr std::string_view town =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":9},"geometry":)"
    R"({"type":"Polygon","coordinates":[[[13,52],[13.001,52],[13.001,52.001],[13,52]]]}}]})";
constexpr std::string_view kml =
    "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><Polygon><extrude>1</extrude>"
    "<altitudeMode>relativeToGround</altitudeMode><outerBoundaryIs><LinearRing><coordinates>13,52,9 "
    "13.001,52,9 "
    "13.001,52.001,9 "
    "13,52,9</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>";

// One block, stored as it is (RFC 1951, RFC 1952).
std::string gzipOf(std::string_view content) {
    std::string bytes("\x1f\x8b\x08\0\0\0\0\0\0\x03\x01", 11);
    put(bytes, std::uint16_t(content.size()));
    put(bytes, std::uint16_t(~content.size()));
    bytes += content;
    put(bytes, ZipMaker::crcOf(content));
    put(bytes, std::uint32_t(content.size()));
    return bytes;
}

void makeArchiveSeeds(const SeedFolder& seeds) {
    ZipMaker zip, kmz, two;
    zip.add("town/town.geojson", town);
    kmz.add("doc.kml", kml);
    two.add("a.geojson", town);
    two.add("../b.geojson", town);
    seeds.write("archive", "town.zip", zip.text());
    seeds.write("archive", "town.kmz", kmz.text());
    seeds.write("archive", "outside.zip", two.text());
    seeds.write("archive", "town.geojson.gz", gzipOf(town));
}

}  // namespace

}  // namespace noonmark::tests

int main(int argc, char** argv) {
    using namespace noonmark::tests;
    if (argc != 2) return EXIT_FAILURE;
    const SeedFolder seeds{argv[1]};
    makeGdalSeeds(seeds);
    makeOsmSeeds(seeds);
    makeMeshSeeds(seeds);
    makeProjectSeeds(seeds);
    makeArchiveSeeds(seeds);
}
