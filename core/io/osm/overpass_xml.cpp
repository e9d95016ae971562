#include <fmt/format.h>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "core/io/osm/osm_map.h"

namespace noonmark {

namespace {

using OverpassJson = nlohmann::json;

// Without control characters, which XML has no words for.
std::string escapedForXml(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '&')
            safe += "&amp;";
        else if (letter == '<')
            safe += "&lt;";
        else if (letter == '"')
            safe += "&quot;";
        else
            safe += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
    return safe;
}

std::string textOf(const OverpassJson& element, const char* key) {
    const auto found = element.find(key);
    return found != element.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::int64_t> idOf(const OverpassJson& element, const char* key) {
    const auto found = element.find(key);
    if (found == element.end() || !found->is_number_integer()) return std::nullopt;
    return found->get<std::int64_t>();
}

// Nothing for what has no place: points that a box cut off are null.
std::optional<OsmPoint> pointOf(const OverpassJson& place) {
    if (!place.is_object()) return std::nullopt;
    const auto degreesOf = [&](const char* key) {
        const auto found = place.find(key);
        return found != place.end() && found->is_number() ? found->get<double>() : std::nan("");
    };
    const double lon = degreesOf("lon"), lat = degreesOf("lat");
    if (!(std::abs(lon) <= 180 && std::abs(lat) <= 90)) return std::nullopt;
    return OsmPoint{std::int32_t(std::lround(lon * 1e7)), std::int32_t(std::lround(lat * 1e7))};
}

/// Writes elements of Overpass as those of OpenStreetMap XML. Points of shapes that no node of the file has
/// become nodes; those without an id get one below zero, equal places the same.
class OverpassWriter {
public:
    void add(const OverpassJson& element) {
        const auto id = idOf(element, "id");
        const std::string type = textOf(element, "type");
        if (!id) return;
        if (type == "node") addNode(*id, element);
        if (type == "way") addWay(*id, element);
        if (type == "relation") addRelation(*id, element);
    }

    [[nodiscard]] bool hasShapes() const { return waysWithPlaces_ || !nodes_.empty(); }
    [[nodiscard]] bool hasAny() const { return !ways_.empty() || !relations_.empty() || !nodes_.empty(); }

    std::string finish() {
        for (const auto& [id, at] : shapeNodes_)
            if (!nodeIds_.contains(id)) nodes_ += startNode(id, at) + "/>\n";
        for (const auto& [id, way] : memberWays_)
            if (!wayIds_.contains(id)) ways_ += way;
        return "<osm version=\"0.6\">\n" + nodes_ + ways_ + relations_ + "</osm>\n";
    }

private:
    static std::string startNode(std::int64_t id, OsmPoint at) {
        return fmt::format(R"(<node id="{}" lat="{:.7f}" lon="{:.7f}")", id, at.lat / 1e7, at.lon / 1e7);
    }

    static std::string tagsOf(const OverpassJson& element) {
        std::string text;
        const auto tags = element.find("tags");
        if (tags == element.end() || !tags->is_object()) return text;
        for (const auto& [key, value] : tags->items())
            if (value.is_string())
                text += fmt::format(R"(<tag k="{}" v="{}"/>)", escapedForXml(key),
                                    escapedForXml(value.get<std::string>()));
        return text;
    }

    void addNode(std::int64_t id, const OverpassJson& element) {
        const auto at = pointOf(element);
        if (!at || !nodeIds_.insert(id).second) return;
        nodes_ += startNode(id, *at) + ">" + tagsOf(element) + "</node>\n";
    }

    std::int64_t nodeAt(OsmPoint at) {
        const auto [found, isNew] =
            unnamed_.try_emplace({at.lon, at.lat}, -1 - std::int64_t(unnamed_.size()));
        if (isNew) shapeNodes_.emplace(found->second, at);
        return found->second;
    }

    // Ids of a way's nodes, or of new nodes at the places of its shape.
    std::string nodesOf(const OverpassJson& way) {
        const auto ids = way.find("nodes"), shape = way.find("geometry");
        const bool isNamed = ids != way.end() && ids->is_array();
        const bool isPlaced = shape != way.end() && shape->is_array();
        const std::size_t count = isNamed ? ids->size() : isPlaced ? shape->size() : 0;
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = isPlaced && i < shape->size() ? pointOf((*shape)[i]) : std::nullopt;
            waysWithPlaces_ = waysWithPlaces_ || at;
            if (isNamed && !(*ids)[i].is_number_integer()) continue;
            if (!isNamed && !at) continue;
            const std::int64_t id = isNamed ? (*ids)[i].get<std::int64_t>() : nodeAt(*at);
            if (at) shapeNodes_.try_emplace(id, *at);
            text += fmt::format(R"(<nd ref="{}"/>)", id);
        }
        return text;
    }

    void addWay(std::int64_t id, const OverpassJson& element) {
        if (wayIds_.insert(id).second)
            ways_ += fmt::format("<way id=\"{}\">{}{}</way>\n", id, nodesOf(element), tagsOf(element));
    }

    // The ways of a relation come with their shapes, where they are no elements of their own.
    void addRelation(std::int64_t id, const OverpassJson& element) {
        relations_ += fmt::format("<relation id=\"{}\">", id);
        if (const auto members = element.find("members"); members != element.end() && members->is_array())
            for (const OverpassJson& member : *members) addMember(member);
        relations_ += tagsOf(element) + "</relation>\n";
    }

    void addMember(const OverpassJson& member) {
        const auto ref = member.is_object() ? idOf(member, "ref") : std::nullopt;
        if (!ref || textOf(member, "type") != "way") return;
        relations_ += fmt::format(R"(<member type="way" ref="{}" role="{}"/>)", *ref,
                                  escapedForXml(textOf(member, "role")));
        if (!member.contains("geometry") || memberWays_.contains(*ref)) return;
        const std::string nodes = nodesOf(member);
        memberWays_.emplace(*ref, fmt::format("<way id=\"{}\">{}</way>\n", *ref, nodes));
    }

    std::string nodes_, ways_, relations_;
    bool waysWithPlaces_ = false;
    std::unordered_set<std::int64_t> nodeIds_, wayIds_;
    std::unordered_map<std::int64_t, OsmPoint> shapeNodes_;
    std::map<std::int64_t, std::string> memberWays_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> unnamed_;
};

struct BrokenOff {};

/// Takes one element after the other out of the stream, so that not all of them are in memory.
class OverpassParser {
public:
    explicit OverpassParser(const std::stop_token& stop) : stop_(stop) {}

    /// Throws nlohmann's exceptions; BrokenOff when stopped.
    void parse(std::istream& stream) {
        const OverpassJson rest =
            OverpassJson::parse(stream, [this](int depth, OverpassJson::parse_event_t event,
                                               OverpassJson& parsed) { return keep(depth, event, parsed); });
        remark = rest.is_object() ? textOf(rest, "remark") : std::string();
    }

    OverpassWriter writer;
    std::string remark;  ///< of the server; empty: none

private:
    bool keep(int depth, OverpassJson::parse_event_t event, OverpassJson& parsed) {
        if (stop_.stop_requested()) throw BrokenOff();
        if (event == OverpassJson::parse_event_t::key && depth == 1) key_ = parsed.get<std::string>();
        if (event != OverpassJson::parse_event_t::object_end || depth != 2 || key_ != "elements") return true;
        writer.add(parsed);
        return false;
    }

    const std::stop_token& stop_;
    std::string key_;  // of the outermost object
};

Result<void> checkAnswer(const OverpassParser& answer, const std::string& file) {
    if (answer.remark.find("error") != answer.remark.npos)
        return failure("The server broke its answer off: " + answer.remark, file,
                       "Ask for a smaller area, or allow more time: [timeout:180]");
    if (answer.writer.hasAny() && !answer.writer.hasShapes())
        return failure("The answer of Overpass holds no shapes", file,
                       "Ask for them: end the query with out geom; instead of out;");
    return {};
}

}  // namespace

Result<std::string> readOverpassAsXml(const std::filesystem::path& file, const std::stop_token& stop) try {
    constexpr std::uintmax_t maxBytes = 1'000'000'000;
    if (std::filesystem::file_size(file) > maxBytes)
        return limitReached("The answer of Overpass is larger than 1 GB", file.string(),
                            "Take an extract in PBF of so large an area");
    std::ifstream stream(file, std::ios::binary);
    OverpassParser answer(stop);
    answer.parse(stream);
    return checkAnswer(answer, file.string()).map([&] { return answer.writer.finish(); });
} catch (const BrokenOff&) {
    return cancelled();
} catch (const nlohmann::json::exception& exception) {
    return failure(fmt::format("It is incomplete or damaged ({})", exception.what()), file.string(),
                   "Ask Overpass again");
}

}  // namespace noonmark
