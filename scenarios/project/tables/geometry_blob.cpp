#include "scenarios/project/tables/geometry_blob.h"

#include <bit>
#include <cstring>
#include <stdexcept>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t wkbPoint = 1;
constexpr std::uint32_t wkbLineString = 2;
constexpr std::uint32_t wkbPolygon = 3;
constexpr std::uint32_t wkbMultiPoint = 4;
constexpr std::uint32_t wkbMultiPolygon = 6;

template <class T>
void put(Bytes& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putHeader(Bytes& bytes, const Box2& box) {
    bytes += "GP";
    put(bytes, std::uint8_t(0));  // version 1
    put(bytes, std::uint8_t(3));  // little-endian, envelope of x and y
    put(bytes, std::int32_t(localSrsId));
    for (const float value : {box.low.x, box.high.x, box.low.y, box.high.y}) put(bytes, double(value));
}

Box2 boxOf(const std::vector<glm::vec2>& points) {
    Box2 box;
    for (const glm::vec2 point : points) box.add(point);
    return box;
}

void putPoint(Bytes& bytes, glm::vec2 point) {
    put(bytes, double(point.x));
    put(bytes, double(point.y));
}

void putRing(Bytes& bytes, const Ring& ring) {
    put(bytes, std::uint32_t(ring.size() + 1));
    for (std::size_t i = 0; i <= ring.size(); ++i) putPoint(bytes, ring[i % ring.size()]);
}

void putPolygon(Bytes& bytes, const Footprint& footprint) {
    put(bytes, std::uint8_t(1));
    put(bytes, wkbPolygon);
    put(bytes, std::uint32_t(1 + footprint.holes.size()));
    putRing(bytes, footprint.outer);
    for (const Ring& hole : footprint.holes) putRing(bytes, hole);
}

// Reads values one after the other; after the end it returns 0 and sets `sound` to false.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    T take() {
        T value{};
        sound &= bytes_.size() >= sizeof value;
        if (!sound) return value;
        std::memcpy(&value, bytes_.data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }

    void skip(std::size_t count) {
        sound &= bytes_.size() >= count;
        if (sound) bytes_.remove_prefix(count);
    }

    [[nodiscard]] bool holds(std::size_t count, std::size_t size) const {
        return count <= bytes_.size() / size;
    }

    bool sound = true;

private:
    std::string_view bytes_;
};

glm::dvec2 takePoint(Reader& reader) {
    const auto x = reader.take<double>();
    const auto y = reader.take<double>();
    reader.sound &= isWithin(x, placeLimitsM) && isWithin(y, placeLimitsM);
    return {x, y};
}

RawRing takeRing(Reader& reader) {
    const auto count = reader.take<std::uint32_t>();
    RawRing ring;
    reader.sound &= reader.holds(count, 2 * sizeof(double)) && count >= 4;
    for (std::uint32_t i = 0; reader.sound && i + 1 < count; ++i) ring.push_back(takePoint(reader));
    reader.skip(2 * sizeof(double));  // skips the closing point
    return ring;
}

bool isOurs(const std::vector<RawRing>& rings) {
    for (const RawRing& ring : rings)
        for (const glm::dvec2 point : ring)
            if (double(float(point.x)) != point.x || double(float(point.y)) != point.y) return false;
    return true;
}

Ring exact(const RawRing& ring) {
    Ring points;
    for (const glm::dvec2 point : ring) points.emplace_back(float(point.x), float(point.y));
    return points;
}

void takePolygon(Reader& reader, std::vector<Footprint>& polygons) {
    reader.sound &= reader.take<std::uint8_t>() == 1 && reader.take<std::uint32_t>() == wkbPolygon;
    const auto count = reader.take<std::uint32_t>();
    std::vector<RawRing> rings;
    reader.sound &= reader.holds(count, sizeof(double)) && count > 0;
    for (std::uint32_t i = 0; reader.sound && i < count; ++i) rings.push_back(takeRing(reader));
    if (!reader.sound) return;
    if (!isOurs(rings)) {
        for (Footprint& piece : repairFootprint(rings).pieces) polygons.push_back(std::move(piece));
        return;
    }
    Footprint footprint{exact(rings.front()), {}};
    for (std::size_t i = 1; i < rings.size(); ++i) footprint.holes.push_back(exact(rings[i]));
    polygons.push_back(std::move(footprint));
}

void skipHeader(Reader& reader) {
    const bool magic = reader.take<char>() == 'G' && reader.take<char>() == 'P';
    reader.take<std::uint8_t>();
    const auto flags = reader.take<std::uint8_t>();
    reader.take<std::int32_t>();
    constexpr std::size_t envelopeBytes[] = {0, 32, 48, 48, 64};
    const unsigned envelope = flags >> 1 & 7U;
    reader.sound &= magic && (flags & 1U) == 1 && envelope < 5;
    if (reader.sound) reader.skip(envelopeBytes[envelope]);
}

}  // namespace

Bytes polygonBlob(const Footprint& footprint) {
    Bytes bytes;
    putHeader(bytes, bounds(footprint));
    putPolygon(bytes, footprint);
    return bytes;
}

Bytes multiPolygonBlob(const std::vector<Footprint>& polygons) {
    Bytes bytes;
    Box2 box;
    for (const Footprint& polygon : polygons) box.add(bounds(polygon));
    putHeader(bytes, box);
    put(bytes, std::uint8_t(1));
    put(bytes, wkbMultiPolygon);
    put(bytes, std::uint32_t(polygons.size()));
    for (const Footprint& polygon : polygons) putPolygon(bytes, polygon);
    return bytes;
}

Bytes lineBlob(const std::vector<glm::vec2>& points) {
    Bytes bytes;
    putHeader(bytes, boxOf(points));
    put(bytes, std::uint8_t(1));
    put(bytes, wkbLineString);
    put(bytes, std::uint32_t(points.size()));
    for (const glm::vec2 point : points) putPoint(bytes, point);
    return bytes;
}

Bytes pointBlob(glm::vec2 point) {
    Bytes bytes;
    putHeader(bytes, boxOf({point}));
    put(bytes, std::uint8_t(1));
    put(bytes, wkbPoint);
    putPoint(bytes, point);
    return bytes;
}

Bytes multiPointBlob(const std::vector<glm::vec2>& points) {
    Bytes bytes;
    putHeader(bytes, boxOf(points));
    put(bytes, std::uint8_t(1));
    put(bytes, wkbMultiPoint);
    put(bytes, std::uint32_t(points.size()));
    for (const glm::vec2 point : points) {
        put(bytes, std::uint8_t(1));
        put(bytes, wkbPoint);
        putPoint(bytes, point);
    }
    return bytes;
}

std::optional<std::vector<Footprint>> toPolygons(std::string_view blob) {
    Reader reader(blob);
    skipHeader(reader);
    Reader ahead = reader;
    ahead.take<std::uint8_t>();
    std::vector<Footprint> polygons;
    std::uint32_t count = 1;
    if (ahead.take<std::uint32_t>() == wkbMultiPolygon) {
        count = ahead.take<std::uint32_t>();
        reader = ahead;
    }
    for (std::uint32_t i = 0; reader.sound && i < count; ++i) takePolygon(reader, polygons);
    if (!reader.sound) return std::nullopt;
    return polygons;
}

std::optional<std::vector<glm::vec2>> toPoints(std::string_view blob) {
    Reader reader(blob);
    skipHeader(reader);
    reader.sound &= reader.take<std::uint8_t>() == 1;
    const auto type = reader.take<std::uint32_t>();
    reader.sound &= type == wkbPoint || type == wkbLineString || type == wkbMultiPoint;
    const std::uint32_t count = type == wkbPoint ? 1 : reader.take<std::uint32_t>();
    reader.sound &= reader.holds(count, 2 * sizeof(double));
    std::vector<glm::vec2> points;
    for (std::uint32_t i = 0; reader.sound && i < count; ++i) {
        if (type == wkbMultiPoint)
            reader.sound &= reader.take<std::uint8_t>() == 1 && reader.take<std::uint32_t>() == wkbPoint;
        points.emplace_back(takePoint(reader));
    }
    if (!reader.sound) return std::nullopt;
    return points;
}

using Json = nlohmann::ordered_json;

Json ringJson(const Ring& ring) {
    Json json = Json::array();
    for (const glm::vec2 point : ring) json.push_back({point.x, point.y});
    return json;
}

Ring parseRing(const Json& json) {
    Ring ring;
    for (const Json& point : json)
        ring.emplace_back(float(numberFrom(point.at(0), placeLimitsM)),
                          float(numberFrom(point.at(1), placeLimitsM)));
    if (ring.size() < 3) throw std::invalid_argument("a ring of fewer than three points");
    return ring;
}

double numberFrom(const Json& json, const NumberLimits& limits) {
    const auto value = json.get<double>();
    if (!isWithin(value, limits)) throw std::invalid_argument("a number is out of range");
    return value;
}

}  // namespace noonmark
