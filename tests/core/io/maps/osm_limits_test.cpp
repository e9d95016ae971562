// The limits of OpenStreetMap and of its format PBF, which hostile maps exceed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/gdal_calls.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/osm/osm_map.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

class OsmLimits : public testing::Test {
protected:
    Result<OsmMap> read(const std::string& name, const std::string& content, OsmFormat format) {
        NoProgress quiet;
        return readOsmMap(folder_.file(name, content), format, {{}, {"building"}, {}, {}, {}}, quiet, {});
    }
    tests::TemporaryFolder folder_;
};

std::string wayOf(std::size_t nodes) {
    std::string text = "<osm version='0.6'><way id='7'>";
    for (std::size_t i = 0; i + 1 < nodes; ++i) text += fmt::format("<nd ref='{}'/>", i + 1);
    return text + "<nd ref='1'/><tag k='building' v='yes'/></way></osm>";
}

TEST_F(OsmLimits, AWayOfMoreThan2000NodesIsRefusedWithItsId) {
    EXPECT_TRUE(read("a.osm", wayOf(2000), OsmFormat::xml));
    const auto map = read("a.osm", wayOf(2001), OsmFormat::xml);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().kind, ErrorKind::limit);
    EXPECT_THAT(map.error().what, HasSubstr("way 7 has 2001 nodes"));
}

TEST_F(OsmLimits, ARelationOfMoreThan32000MembersIsRefusedWithItsId) {
    std::string text = "<osm version='0.6'><relation id='9'>";
    for (int i = 0; i < 32001; ++i) text += fmt::format("<member type='way' ref='{}' role='outer'/>", i + 1);
    const auto map =
        read("a.osm", text + "<tag k='type' v='multipolygon'/></relation></osm>", OsmFormat::xml);
    ASSERT_FALSE(map);
    EXPECT_THAT(map.error().what, HasSubstr("relation 9 has 32001 members"));
}

TEST_F(OsmLimits, ARelationOfManyOpenWaysIsJoinedToItsRings) {
    constexpr int rings = 400, sides = 4;  // more lines than GDAL is given; in no order
    std::string nodes, ways, members;
    for (int i = 0; i < rings * sides; ++i) {
        const int ring = i / sides, corner = i % sides, next = ring * sides + (corner + 1) % sides;
        nodes += fmt::format("<node id='{}' lat='{:.4f}' lon='{:.4f}'/>", i + 1, 40.75 + (corner / 2) * 1e-4,
                             -73.98 + 3e-4 * ring + (corner % 3 != 0 ? 1e-4 : 0));
        ways += fmt::format("<way id='{0}'><nd ref='{1}'/><nd ref='{2}'/></way>", i + 1,
                            (i % 2 == 0 ? i : next) + 1, (i % 2 == 0 ? next : i) + 1);
        members += fmt::format("<member type='way' ref='{}' role='outer'/>", i * 7 % (rings * sides) + 1);
    }
    const auto map = read("a.osm",
                          "<osm version='0.6'>" + nodes + ways + "<relation id='9'>" + members +
                              "<tag k='type' v='multipolygon'/></relation></osm>",
                          OsmFormat::xml);
    ASSERT_TRUE(map);
    const GdalCalls calls;
    std::size_t polygons = 0;
    forEachOsmArea(*map, [&](const OsmArea& area) { polygons += area.polygons.size(); }, {});
    EXPECT_EQ(polygons, std::size_t(rings));
}

// --- PBF, written by hand: a field of bytes or a number, and a block of them

std::string number(std::uint64_t value) {
    std::string bytes;
    for (; value > 127; value >>= 7U) bytes += char((value & 127U) | 128U);
    return bytes + char(value);
}
std::string bytesField(unsigned field, const std::string& bytes) {
    return number(field << 3U | 2U) + number(bytes.size()) + bytes;
}
std::string numberField(unsigned field, std::uint64_t value) { return number(field << 3U) + number(value); }

std::string block(const std::string& type, const std::string& blob) {
    const std::string head = bytesField(1, type) + numberField(3, blob.size());
    std::string size(4, '\0');
    for (std::size_t i = 0; i < 4; ++i) size[3 - i] = char(head.size() >> (8 * i));
    return size + head + blob;
}

const std::string pbfHeader =
    block("OSMHeader", bytesField(1, bytesField(4, "OsmSchema-V0.6") + bytesField(4, "DenseNodes")));

// A block without elements, with a field of so many bytes that the format does not know.
std::string emptyBlock(std::size_t bytes) {
    constexpr unsigned strings = 1, unknown = 99;
    return block("OSMData",
                 bytesField(1, bytesField(strings, "") + bytesField(unknown, std::string(bytes, 'a'))));
}

TEST_F(OsmLimits, ABlockThatUnpacksManyHundredFoldIsRefused) {
    const std::string bomb =
        block("OSMData", numberField(2, 32'000'000) + bytesField(3, std::string(32000, 'z')));
    const auto map = read("a.osm.pbf", pbfHeader + bomb, OsmFormat::pbf);
    ASSERT_FALSE(map);
    EXPECT_THAT(map.error().what, HasSubstr("unpacks to 32 million"));
}

TEST_F(OsmLimits, AMapIsCutIntoPiecesAtItsBlocks) {
    std::string text = pbfHeader;
    for (int i = 0; i < 10; ++i) text += emptyBlock(900'000);
    PbfPieces pieces(folder_.file("a.osm.pbf", text));
    std::size_t count = 0, bytes = 0;
    for (std::string piece = pieces.next(); !piece.empty(); piece = pieces.next(), ++count) {
        EXPECT_TRUE(piece.starts_with(pbfHeader));
        bytes += piece.size() - pbfHeader.size();
    }
    EXPECT_EQ(count, 4U) << "three blocks each";
    EXPECT_EQ(bytes, text.size() - pbfHeader.size());
    EXPECT_TRUE(read("a.osm.pbf", text, OsmFormat::pbf));
}

TEST_F(OsmLimits, AMapThatIsCutOffIsDamaged) {
    const std::string text = pbfHeader + emptyBlock(1000);
    for (const std::size_t bytes :
         {std::size_t(2), pbfHeader.size() - 1, pbfHeader.size() + 2, text.size() - 1})
        EXPECT_FALSE(read("a.osm.pbf", text.substr(0, bytes), OsmFormat::pbf)) << bytes;
    EXPECT_TRUE(read("a.osm.pbf", text, OsmFormat::pbf));
}

// Stops with the first report, of which there is one a piece.
struct StopAtOnce : Progress {
    std::stop_source source;
    int reports = 0;
    void report(double, std::string_view) override {
        ++reports;
        source.request_stop();
    }
};

TEST_F(OsmLimits, BlocksWithoutElementsCanBeStopped) {
    std::string text = pbfHeader;
    for (int i = 0; i < 30; ++i) text += emptyBlock(900'000);
    StopAtOnce stopping;
    const auto map = readOsmMap(folder_.file("a.osm.pbf", text), OsmFormat::pbf,
                                {{}, {"building"}, {}, {}, {}}, stopping, stopping.source.get_token());
    ASSERT_FALSE(map);
    EXPECT_TRUE(isCancelled(map.error()));
    EXPECT_EQ(stopping.reports, 1);
}

}  // namespace
}  // namespace noonmark
