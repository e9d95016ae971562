#include <cmath>
#include <string>
#include <vector>

#include "tests/fuzz/seeds.h"

// OpenStreetMap PBF, uncompressed: https://wiki.openstreetmap.org/wiki/PBF_Format. Messages are protocol
// buffers.
namespace noonmark::tests {

namespace {

std::string varint(std::uint64_t value) {
    std::string bytes;
    for (; value >= 128; value >>= 7U) bytes += char(value % 128 + 128);
    return bytes + char(value);
}

std::uint64_t zigzag(std::int64_t value) { return std::uint64_t(value) << 1U ^ std::uint64_t(value >> 63); }

std::string number(unsigned field, std::uint64_t value) { return varint(field << 3U) + varint(value); }

std::string bytes(unsigned field, const std::string& content) {
    return varint(field << 3U | 2U) + varint(content.size()) + content;
}

// Delta-encoded numbers.
std::string deltas(unsigned field, const std::vector<std::int64_t>& values) {
    std::string packed;
    std::int64_t last = 0;
    for (const std::int64_t value : values) {
        packed += varint(zigzag(value - last));
        last = value;
    }
    return bytes(field, packed);
}

std::string plain(unsigned field, const std::vector<std::uint64_t>& values) {
    std::string packed;
    for (const std::uint64_t value : values) packed += varint(value);
    return bytes(field, packed);
}

std::string blob(const char* type, const std::string& content) {
    const std::string body = bytes(1, content) + number(2, content.size());
    const std::string head = bytes(1, type) + number(3, body.size());
    std::string all;
    for (int shift = 24; shift >= 0; shift -= 8) all += char(head.size() >> unsigned(shift) & 255U);
    return all + head + body;
}

// The table of strings to which tags refer by index; 0 is unused.
std::string strings() {
    std::string table;
    for (const char* text : {"", "building", "yes", "height", "12 m", "building:levels", "4", "type",
                             "multipolygon", "outer", "inner", "building:part"})
        table += bytes(1, text);
    return bytes(1, table);
}

// Eight corners of two squares, in units of 1e-7 degrees.
std::string nodes() {
    constexpr std::int64_t lat = 407500000, lon = -739800000;
    std::vector<std::int64_t> lats, lons, ids;
    for (const std::int64_t size : {0, 3000})
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            ids.push_back(std::int64_t(ids.size()) + 1);
            lats.push_back(lat + (y != 0 ? 10000 - size : size));
            lons.push_back(lon + (x != 0 ? 10000 - size : size));
        }
    return bytes(2, bytes(2, deltas(1, ids) + deltas(8, lats) + deltas(9, lons)));
}

std::string way(std::uint64_t id, const std::vector<std::int64_t>& corners,
                const std::vector<std::uint64_t>& keys, const std::vector<std::uint64_t>& values) {
    return bytes(3, number(1, id) + plain(2, keys) + plain(3, values) + deltas(8, corners));
}

std::string relation() {
    return bytes(4, number(1, 9) + plain(2, {7, 1}) + plain(3, {8, 2}) + plain(8, {9, 10}) +
                        deltas(9, {1, 2}) + plain(10, {1, 1}));
}

std::string block(const std::string& groups) { return blob("OSMData", strings() + groups); }

}  // namespace

void makeOsmSeeds(const SeedFolder& seeds) {
    const std::string head = blob("OSMHeader", bytes(4, "OsmSchema-V0.6") + bytes(4, "DenseNodes"));
    const std::string tagged =
        bytes(2, way(1, {1, 2, 3, 4, 1}, {1, 3, 5}, {2, 4, 6}) + way(2, {5, 6, 7, 8, 5}, {11}, {2}));
    const std::string bare = bytes(2, way(1, {1, 2, 3, 4, 1}, {}, {}) + way(2, {5, 6, 7, 8, 5}, {}, {}));
    seeds.write("osm_pbf", "ways.osm.pbf", head + block(nodes() + tagged));
    seeds.write("osm_pbf", "relation.osm.pbf",
                head + block(nodes()) + block(bare) + block(bytes(2, relation())));
}

}  // namespace noonmark::tests
