#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <osmium/io/compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm.hpp>
#include <sstream>
#include <string_view>

#include "core/io/osm/osm_map.h"

namespace noonmark {

namespace {

using Keys = std::vector<std::string>;

// Tags about the mapping: they do not describe the thing.
constexpr std::array remarkKeys{"area", "created_by", "converted_by", "note", "todo", "fixme", "FIXME"};

bool isRemark(std::string_view key) { return std::ranges::find(remarkKeys, key) != remarkKeys.end(); }

bool isAmong(std::string_view key, const Keys& keys) { return std::ranges::find(keys, key) != keys.end(); }

bool hasOneOf(const osmium::TagList& tags, const Keys& keys) {
    return std::ranges::any_of(tags, [&](const osmium::Tag& tag) { return isAmong(tag.key(), keys); });
}

bool isTaggedAsArea(const osmium::TagList& tags, const Keys& areaKeys) {
    bool area = false;
    for (const osmium::Tag& tag : tags) {
        const std::string_view key = tag.key(), value = tag.value();
        if (key == "area" && (value == "yes" || value == "no")) return value == "yes";
        area = area || isAmong(key, areaKeys);
    }
    return area;
}

bool isCoast(const osmium::TagList& tags) { return tags.has_tag("natural", "coastline"); }

OsmTags wantedTags(const osmium::TagList& tags, const Keys& keys) {
    OsmTags wanted;
    for (const osmium::Tag& tag : tags)
        if (isAmong(tag.key(), keys)) wanted.emplace_back(tag.key(), tag.value());
    return wanted;
}

// Type, and whether other tags describe the relation.
struct RelationKind {
    bool multipolygon = false, tagged = false;
};

RelationKind kindOf(const osmium::TagList& tags) {
    RelationKind kind;
    for (const osmium::Tag& tag : tags) {
        const std::string_view key = tag.key(), value = tag.value();
        if (key == "type")
            kind.multipolygon = kind.multipolygon || value == "multipolygon" || value == "boundary";
        else if (key != "created_by")
            kind.tagged = true;
    }
    return kind;
}

// Whether nodes, members or tags stand in several places of an element: the library keeps the first of them.
bool isSplit(const osmium::OSMObject& object) {
    std::vector<osmium::item_type> seen;
    for (const osmium::memory::Item& item : object) {
        if (std::ranges::find(seen, item.type()) != seen.end()) return true;
        seen.push_back(item.type());
    }
    return false;
}

struct Stopped {};

// Of a million values a stop is noticed within 0.1 s.
template <class Value>
void sortUnique(std::vector<Value>& values, const std::stop_token& stop) {
    std::size_t compared = 0;
    std::ranges::sort(values, [&](Value a, Value b) {
        if (++compared % (1U << 16U) == 0 && stop.stop_requested()) throw Stopped();
        return a < b;
    });
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

constexpr OsmPoint nowhere{std::numeric_limits<std::int32_t>::min(), 0};

/// The places of a fixed set of nodes. Files are mostly in order, so that the next node is near the last.
class NodePlaces {
public:
    explicit NodePlaces(std::vector<std::int64_t> ids, const std::stop_token& stop) : ids_(std::move(ids)) {
        sortUnique(ids_, stop);
        places_.assign(ids_.size(), nowhere);
    }

    /// The place of a node to be filled; null for a node that nothing needs.
    OsmPoint* find(std::int64_t id) {
        auto from =
            next_ < ids_.size() && ids_[next_] <= id ? ids_.begin() + std::ptrdiff_t(next_) : ids_.begin();
        const auto to = ids_.end() - from > near && id <= from[near] ? from + near + 1 : ids_.end();
        const auto found = std::lower_bound(from, to, id);
        next_ = std::size_t(found - ids_.begin());
        return found != ids_.end() && *found == id ? &places_[next_] : nullptr;
    }

private:
    static constexpr std::ptrdiff_t near = 16;
    std::vector<std::int64_t> ids_;
    std::vector<OsmPoint> places_;
    std::size_t next_ = 0;
};

// Limits of OpenStreetMap's own database.
constexpr std::size_t maxNodes = 2000;     // of a way
constexpr std::size_t maxMembers = 32000;  // of a relation

// XML that ends when the work is stopped; the parser then finds it damaged.
class StoppableText final : public osmium::io::Decompressor {
public:
    StoppableText(std::unique_ptr<std::istream> stream, std::stop_token stop)
        : stream_(std::move(stream)), stop_(std::move(stop)) {}

    std::string read() override {
        constexpr std::size_t pieceBytes = 1U << 17U;  // the library reads some twenty pieces ahead
        if (stop_.stop_requested()) return {};
        std::string piece(pieceBytes, '\0');
        stream_->read(piece.data(), std::streamsize(piece.size()));
        piece.resize(std::size_t(stream_->gcount()));
        set_offset(taken_ += piece.size());
        return piece;
    }
    void close() override {}

private:
    std::unique_ptr<std::istream> stream_;
    std::stop_token stop_;
    std::size_t taken_ = 0;
};

// The library opens files by their kind of compression and passes nothing else on. No compressed text is read
// here, so that the place of gzip is free for this one; the file is that of this thread.
thread_local std::function<std::unique_ptr<StoppableText>()> openText;

osmium::io::File stoppableText() {
    static const bool registered = osmium::io::CompressionFactory::instance().register_compression(
        osmium::io::file_compression::gzip,
        [](int, osmium::io::fsync) -> osmium::io::Compressor* { return nullptr; },
        [](int) -> osmium::io::Decompressor* { return nullptr; },
        [](const char*, std::size_t) -> osmium::io::Decompressor* { return openText().release(); });
    if (!registered) throw std::logic_error("another file reads compressed text");
    constexpr const char* none = "";
    osmium::io::File text(none, 1, "xml");
    text.set_compression(osmium::io::file_compression::gzip);
    return text;
}

class MapReader {
public:
    MapReader(const std::filesystem::path& file, OsmFormat format, const OsmSelection& selection,
              Progress& progress, const std::stop_token& stop)
        : path_(file),
          format_(format),
          bytes_(double(std::max<std::uintmax_t>(1, std::filesystem::file_size(file)))),
          selection_(selection),
          progress_(progress),
          stop_(stop) {}

    Result<OsmMap> read() {
        if (format_ == OsmFormat::overpass) {
            auto text = readOverpassAsXml(path_, stop_);
            if (!text) return tl::make_unexpected(text.error());
            text_ = *std::move(text);
            bytes_ = double(text_.size());
        }
        return readEach<osmium::Relation>(0, [&](const auto& relation) { return take(relation); })
            .and_then([&] {
                sortUnique(members_, stop_);
                return readEach<osmium::Way>(1, [&](const auto& way) { return take(way); });
            })
            .and_then([&] { return sortWays(); })
            .and_then([&] { return readEach<osmium::Node>(2, [&](const auto& node) { return take(node); }); })
            .map([&] {
                placeWays();
                return std::move(map_);
            });
    }

private:
    using Taken = Result<void>;

    template <class Object, class Take>
    Taken readEach(std::size_t turn, Take take) {
        if (format_ != OsmFormat::pbf) {
            openText = [this] { return std::make_unique<StoppableText>(openStream(), stop_); };
            return readPart<Object>(stoppableText(), take,
                                    [&](double bytes) { report(turn, bytes / bytes_); });
        }
        PbfPieces pieces(path_);
        for (std::string piece = pieces.next(); !piece.empty(); piece = pieces.next()) {
            const osmium::io::File part(piece.data(), piece.size(), "pbf");
            if (Taken taken = readPart<Object>(part, take, [](double) {}); !taken) return taken;
            report(turn, pieces.share());
        }
        return {};
    }

    [[nodiscard]] std::unique_ptr<std::istream> openStream() const {
        if (format_ == OsmFormat::overpass) return std::make_unique<std::istringstream>(text_);
        return std::make_unique<std::ifstream>(path_, std::ios::binary);
    }

    template <class Object, class Take, class Report>
    Taken readPart(const osmium::io::File& part, Take& take, Report report) {
        osmium::io::Reader reader(part, osmium::osm_entity_bits::from_item_type(Object::itemtype),
                                  osmium::io::read_meta::no, pool_);
        takeBox(reader.header().joined_boxes());
        while (const osmium::memory::Buffer buffer = reader.read()) {
            if (stop_.stop_requested()) return cancelled();
            for (const auto& object : buffer.select<Object>())
                if (Taken taken = take(object); !taken) return taken;
            report(double(reader.offset()));
        }
        reader.close();
        return stop_.stop_requested() ? Taken(cancelled()) : Taken();
    }

    void takeBox(const osmium::Box& box) {
        if (!box.valid()) return;
        map_.box = OsmBox{{box.bottom_left().x(), box.bottom_left().y()},
                          {box.top_right().x(), box.top_right().y()}};
    }

    void report(std::size_t turn, double share) {
        constexpr double turns = 3;
        progress_.report((double(turn) + share) / turns, path_.filename().string());
    }

    Taken take(const osmium::Relation& relation) {
        const RelationKind kind = kindOf(relation.tags());
        if (isSplit(relation)) return split("relation", relation.id());
        if (!kind.multipolygon) return {};
        if (relation.members().size() > maxMembers)
            return tooLarge("relation", relation.id(), relation.members().size(), "members", maxMembers);
        OsmRelation& kept = map_.relations.emplace_back(
            OsmRelation{relation.id(), kind.tagged, wantedTags(relation.tags(), selection_.keys), {}});
        for (const osmium::RelationMember& member : relation.members()) {
            const std::string_view role = member.role();
            if (member.type() != osmium::item_type::way || role == "subarea") continue;
            kept.members.push_back({member.ref(), role == "outer"});
            members_.push_back(member.ref());
        }
        return {};
    }

    Taken take(const osmium::Way& way) {
        if (isSplit(way)) return split("way", way.id());
        if (way.nodes().size() < 2) return {};
        if (way.nodes().size() > maxNodes)
            return tooLarge("way", way.id(), way.nodes().size(), "nodes", maxNodes);
        const bool area = way.ends_have_same_id() && isWantedArea(way.tags());
        const bool line = hasOneOf(way.tags(), selection_.lineKeys) && (!area || isCoast(way.tags()));
        if (!area && !line && !std::ranges::binary_search(members_, way.id())) return {};
        const bool tagged = area && std::ranges::any_of(way.tags(), [](const osmium::Tag& tag) {
                                return !isRemark(tag.key());
                            });
        OsmTags tags = area || line ? wantedTags(way.tags(), selection_.keys) : OsmTags();
        Kept kept{OsmWay{way.id(), area, line, tagged, std::move(tags), {}}, nodes_.size(), 0};
        for (const osmium::NodeRef& node : way.nodes()) nodes_.push_back(node.ref());
        if (area) nodes_.pop_back();
        kept.count = nodes_.size() - kept.first;
        kept_.push_back(std::move(kept));
        return {};
    }

    [[nodiscard]] bool isWantedArea(const osmium::TagList& tags) const {
        return isTaggedAsArea(tags, selection_.areaKeys) &&
               (selection_.kindKeys.empty() || hasOneOf(tags, selection_.kindKeys));
    }

    Taken sortWays() {
        std::ranges::stable_sort(kept_, {}, [](const Kept& kept) { return kept.way.id; });
        const auto same = std::ranges::adjacent_find(kept_, {}, [](const Kept& kept) { return kept.way.id; });
        if (same != kept_.end()) return twice("way", same->way.id);
        places_ = NodePlaces(nodes_, stop_);
        return {};
    }

    Taken take(const osmium::Node& node) {
        OsmPoint* place = places_.find(node.id());
        const bool isPoint = hasOneOf(node.tags(), selection_.pointKeys);
        if (place == nullptr && !isPoint) return {};
        if (place != nullptr && *place != nowhere) return twice("node", node.id());
        if (!node.location().valid())
            return failure(fmt::format("The coordinates of node {} are nowhere on the earth", node.id()),
                           path_.string(), "Download or export it again");
        const OsmPoint at{node.location().x(), node.location().y()};
        if (place != nullptr) *place = at;
        if (isPoint) map_.points.push_back({node.id(), at, wantedTags(node.tags(), selection_.keys)});
        return {};
    }

    // A way of which too few nodes are in the file is left out, as if the file did not have it.
    void placeWays() {
        for (Kept& kept : kept_) {
            if (stop_.stop_requested()) throw Stopped();
            for (std::size_t i = 0; i < kept.count; ++i)
                if (const OsmPoint* place = places_.find(nodes_[kept.first + i]);
                    place != nullptr && *place != nowhere)
                    kept.way.points.push_back(*place);
            if (kept.way.area && !kept.way.points.empty()) kept.way.points.push_back(kept.way.points.front());
            if (kept.way.points.size() >= 2) map_.ways.push_back(std::move(kept.way));
        }
    }

    [[nodiscard]] Taken split(const char* what, std::int64_t id) const {
        return failure(fmt::format("The members and tags of {} {} are mixed", what, id), path_.string(),
                       "Convert it: osmium cat OLD.osm -o NEW.osm.pbf");
    }

    [[nodiscard]] Taken tooLarge(const char* what, std::int64_t id, std::size_t count, const char* parts,
                                 std::size_t maximum) const {
        return limitReached(
            fmt::format("The {} {} has {} {}; OpenStreetMap has at most {}", what, id, count, parts, maximum),
            path_.string(), "Download it again, or divide the way");
    }

    [[nodiscard]] Taken twice(const char* what, std::int64_t id) const {
        return failure(fmt::format("It holds {} {} twice", what, id), path_.string(),
                       "Use an extract without history");
    }

    struct Kept {
        OsmWay way;
        std::size_t first, count;  // its nodes
    };

    const std::filesystem::path& path_;
    OsmFormat format_;
    double bytes_;      // of the file, or of text_
    std::string text_;  // of Overpass as XML
    const OsmSelection& selection_;
    Progress& progress_;
    const std::stop_token& stop_;
    osmium::thread::Pool pool_{std::clamp(tbb::this_task_arena::max_concurrency(), 1, 8)};
    std::vector<std::int64_t> members_;  // ways that relations need
    std::vector<Kept> kept_;
    std::vector<std::int64_t> nodes_;  // of the ways kept, one after the other
    NodePlaces places_{{}, {}};
    OsmMap map_;
};

}  // namespace

Result<OsmMap> readOsmMap(const std::filesystem::path& file, OsmFormat format, const OsmSelection& selection,
                          Progress& progress, const std::stop_token& stop) try {
    return MapReader(file, format, selection, progress, stop).read();
} catch (const Stopped&) {
    return cancelled();
} catch (const std::bad_alloc&) {
    throw;  // the caller's guard reports it
} catch (const std::exception& exception) {
    if (stop.stop_requested()) return cancelled();
    return failure(fmt::format("It is incomplete or damaged ({})", exception.what()), file.string(),
                   "Download or export it again");
}

}  // namespace noonmark
