#pragma once

// The folder core/io/osm reads OpenStreetMap and holds its rules. Buildings: osm_map.h (this file) reads a
// file, osm_layers.h makes polygons of its ways and relations, read_osm_buildings.h reads their tags, and
// core/io/footprints/build_footprints.h assembles features into buildings. Places and context are layers of
// features (osm_layers.h), so that they are read as those of other formats.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace noonmark {

enum class OsmFormat {
    pbf,
    xml,
    overpass,  ///< JSON, as the Overpass API and OpenStreetMap's own answer
};
std::string_view nameOf(OsmFormat format);  ///< "OpenStreetMap PBF"; defined in read_osm_buildings.cpp

/// A node's place in units of 1e-7 degrees, the resolution of OpenStreetMap.
struct OsmPoint {
    std::int32_t lon = 0;
    std::int32_t lat = 0;
    bool operator==(const OsmPoint&) const = default;
};

using OsmTags = std::vector<std::pair<std::string, std::string>>;

/// What is read of a file.
struct OsmSelection {
    std::vector<std::string> keys;      ///< the tags to keep
    std::vector<std::string> areaKeys;  ///< closed ways with one of these are areas, unless area=no
    std::vector<std::string> kindKeys;  ///< areas without any of these are not; empty: all are kept
    /// Ways that are no areas and have one of these are lines; with the key natural coastlines, too, which
    /// as closed ways may be areas besides.
    std::vector<std::string> lineKeys;
    std::vector<std::string> pointKeys;  ///< nodes with one of these are points
};

struct OsmNode {
    std::int64_t id = 0;
    OsmPoint point;
    OsmTags tags;
};

struct OsmWay {
    std::int64_t id = 0;
    bool area = false;    ///< closed, and has an area key or area=yes, but not area=no
    bool line = false;    ///< has a line key, and is no area or a coastline
    bool tagged = false;  ///< an area with tags that describe it, besides remarks such as note
    OsmTags tags;         ///< those asked for, of areas and lines only
    /// In the way's order, without nodes that the file lacks; an area ends with its first point.
    std::vector<OsmPoint> points;
};

struct OsmMember {
    std::int64_t way = 0;
    bool outer = false;
};

struct OsmRelation {
    std::int64_t id = 0;
    bool tagged = false;  ///< by more than its type; otherwise its outer way describes it
    OsmTags tags;         ///< those asked for
    std::vector<OsmMember> members;
};

/// A box that a file states to cover; low is its south-western corner.
struct OsmBox {
    OsmPoint low, high;
};

/// The selected points, lines and areas of an OpenStreetMap file, and the ways of which its relations
/// consist.
struct OsmMap {
    std::vector<OsmWay> ways;            ///< by id; each has two points at least
    std::vector<OsmRelation> relations;  ///< multipolygons and boundaries, in the file's order
    std::vector<OsmNode> points;         ///< in the file's order
    std::optional<OsmBox> box;           ///< around all boxes that the file's header states
};

/// Reads the file three times: relations, ways, and the nodes of the ways that are kept, so that memory grows
/// with what is selected and not with its nodes. Nodes and ways may be in any order; entities and references
/// to other files are refused. Error: it is incomplete or damaged; a way or a node that is needed comes
/// twice; a way of more than 2,000 nodes or a relation of more than 32,000 members, which are OpenStreetMap's
/// own limits. Stops with cancelled() within 0.1 s. Backend: read_osm_map_osmium.cpp.
Result<OsmMap> readOsmMap(const std::filesystem::path& file, OsmFormat format, const OsmSelection& selection,
                          Progress& progress, const std::stop_token& stop);

/// The elements of a JSON file of Overpass as OpenStreetMap XML: nodes by id, and the shapes that `out geom`
/// adds to ways and to members of relations. An element that comes twice is taken once. Error: it is damaged,
/// larger than 1 GB, broken off by the server, or has no shapes (`out` alone). Needs the memory of the file.
Result<std::string> readOverpassAsXml(const std::filesystem::path& file,
                                      const std::stop_token& stop);  ///< defined in overpass_xml.cpp

/// Cuts an OpenStreetMap PBF file at its blocks, so that a library which cannot be stopped reads it in pieces
/// of some 0.1 s each. Backend: pbf_pieces_protozero.cpp.
class PbfPieces {
public:
    /// Throws std::runtime_error if the file's first block cannot be read.
    explicit PbfPieces(const std::filesystem::path& file);

    /// The header block and the next data blocks: up to 2 MB as they are stored or 32 MB unpacked, but at
    /// least one. Empty after the last. Throws std::runtime_error: the file is cut off or damaged; a block
    /// unpacks to 200 times its size, as no map does.
    std::string next();

    [[nodiscard]] double share() const { return double(taken_) / double(bytes_); }  ///< of the file, 0..1

private:
    struct Block {
        std::string bytes;              // with its head
        std::size_t unpackedBytes = 0;  // as it states
    };
    Block readBlock();
    std::string readBytes(std::size_t count);

    std::ifstream stream_;
    std::uintmax_t bytes_ = 0;
    std::uintmax_t taken_ = 0;
    std::string header_;
};

}  // namespace noonmark
