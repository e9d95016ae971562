#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <limits>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm.hpp>
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

template <class Value>
void sortUnique(std::vector<Value>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

constexpr OsmPoint nowhere{std::numeric_limits<std::int32_t>::min(), 0};

/// The places of a fixed set of nodes. Files are mostly in order, so that the next node is near the last.
class NodePlaces {
public:
    explicit NodePlaces(std::vector<std::int64_t> ids) : ids_(std::move(ids)) {
        sortUnique(ids_);
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

class MapReader {
public:
    MapReader(const std::filesystem::path& file, OsmFormat format, const OsmSelection& selection,
              Progress& progress, const std::stop_token& stop)
        : path_(file),
          file_(file.string(), format == OsmFormat::pbf ? "pbf" : "xml"),
          selection_(selection),
          progress_(progress),
          stop_(stop) {}

    Result<OsmMap> read() {
        return readEach<osmium::Relation>(0, [&](const auto& relation) { return take(relation); })
            .and_then([&] {
                sortUnique(members_);
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
        constexpr std::size_t turns = 3;
        osmium::io::Reader reader(file_, osmium::osm_entity_bits::from_item_type(Object::itemtype),
                                  osmium::io::read_meta::no, pool_);
        while (const osmium::memory::Buffer buffer = reader.read()) {
            if (stop_.stop_requested()) return cancelled();
            for (const auto& object : buffer.select<Object>())
                if (Taken taken = take(object); !taken) return taken;
            const double share =
                double(reader.offset()) / double(std::max<std::size_t>(1, reader.file_size()));
            progress_.report((double(turn) + share) / turns, "reading " + path_.filename().string());
        }
        reader.close();
        return {};
    }

    Taken take(const osmium::Relation& relation) {
        const RelationKind kind = kindOf(relation.tags());
        if (isSplit(relation)) return split("relation", relation.id());
        if (!kind.multipolygon) return {};
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
        const bool area = way.ends_have_same_id() && isWantedArea(way.tags());
        const bool line = !area && hasOneOf(way.tags(), selection_.lineKeys);
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
        places_ = NodePlaces(nodes_);
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

    [[nodiscard]] Taken twice(const char* what, std::int64_t id) const {
        return failure(fmt::format("It holds {} {} twice", what, id), path_.string(),
                       "Use an extract without history");
    }

    struct Kept {
        OsmWay way;
        std::size_t first, count;  // its nodes
    };

    const std::filesystem::path& path_;
    osmium::io::File file_;
    const OsmSelection& selection_;
    Progress& progress_;
    const std::stop_token& stop_;
    osmium::thread::Pool pool_{std::clamp(tbb::this_task_arena::max_concurrency(), 1, 8)};
    std::vector<std::int64_t> members_;  // ways that relations need
    std::vector<Kept> kept_;
    std::vector<std::int64_t> nodes_;  // of the ways kept, one after the other
    NodePlaces places_{{}};
    OsmMap map_;
};

}  // namespace

Result<OsmMap> readOsmMap(const std::filesystem::path& file, OsmFormat format, const OsmSelection& selection,
                          Progress& progress, const std::stop_token& stop) try {
    return MapReader(file, format, selection, progress, stop).read();
} catch (const std::bad_alloc&) {
    throw;  // the caller's guard reports it
} catch (const std::exception& exception) {
    return failure(fmt::format("It is incomplete or damaged ({})", exception.what()), file.string(),
                   "Download or export it again");
}

}  // namespace noonmark
