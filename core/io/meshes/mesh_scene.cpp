#include "core/io/meshes/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>

namespace noonmark {

namespace {

constexpr std::string_view sceneHead = "noonmark mesh 5\n";
constexpr char objectTag = 'o';
constexpr char endTag = 'z';
constexpr char errorTag = 'e';
constexpr std::int32_t noFloor = std::numeric_limits<std::int32_t>::min();

template <class Item>
void appendItems(std::string& bytes, const Item* items, std::uint64_t count) {
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(items), count * sizeof(Item));
}

template <class Value>
void appendValue(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Items>
void appendList(std::string& bytes, const Items& items) {
    appendItems(bytes, items.data(), items.size());
}

/// Takes values from the front; after a missing value everything fails.
class SceneBytes {
public:
    explicit SceneBytes(std::string_view bytes) : rest_(bytes) {}
    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

    std::string_view take(std::size_t count) {
        good_ = good_ && count <= rest_.size();
        if (!good_) return {};
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    char takeTag() {
        const std::string_view tag = take(1);
        return tag.empty() ? '\0' : tag.front();
    }
    // Number of items of this size that follow; 0 if there are fewer bytes than that.
    std::size_t takeCount(std::size_t itemBytes) {
        std::uint64_t count = 0;
        const std::string_view bytes = take(sizeof count);
        if (good_) std::memcpy(&count, bytes.data(), sizeof count);
        good_ = good_ && count <= rest_.size() / itemBytes;
        return good_ ? std::size_t(count) : 0;
    }
    template <class Items>
    void takeList(Items& items) {
        const std::size_t count = takeCount(sizeof(items[0]));
        const std::string_view bytes = take(count * sizeof(items[0]));
        items.resize(count);
        if (!bytes.empty()) std::memcpy(items.data(), bytes.data(), bytes.size());
    }
    template <class Value>
    void takeValue(Value& value) {
        const std::string_view bytes = take(sizeof value);
        if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
    }
    void refuse() { good_ = false; }

private:
    std::string_view rest_;
    bool good_ = true;
};

bool cornersAddUp(const MeshPiece& piece) {
    std::uint64_t sum = 0;
    for (const std::uint32_t count : piece.cornerCounts) {
        if (count < 3) return false;
        sum += count;
    }
    return sum == piece.corners.size();
}

MeshPiece takePiece(SceneBytes& bytes) {
    MeshPiece piece;
    bytes.takeList(piece.points);
    bytes.takeList(piece.cornerCounts);
    bytes.takeList(piece.corners);
    bytes.takeValue(piece.origin);
    bytes.takeValue(piece.rounding);
    if (!cornersAddUp(piece)) bytes.refuse();
    return piece;
}

MeshObject takeObject(SceneBytes& bytes) {
    MeshObject object;
    bytes.takeList(object.name);
    constexpr std::size_t fewestPieceBytes =
        3 * sizeof(std::uint64_t) + sizeof(MeshPiece::origin) + sizeof(MeshPiece::rounding);
    const std::size_t pieces = bytes.takeCount(fewestPieceBytes);
    for (std::size_t i = 0; i < pieces && bytes.good(); ++i) object.pieces.push_back(takePiece(bytes));
    bytes.takeList(object.parent);
    bytes.takeList(object.note);
    object.kind = MeshObject::Kind(bytes.takeTag());
    if (object.kind < MeshObject::Kind::pieces || object.kind > MeshObject::Kind::outlines) bytes.refuse();
    std::int32_t floor = noFloor;
    bytes.takeValue(floor);
    if (floor != noFloor) object.floor = floor;
    return object;
}

Error takeError(SceneBytes& bytes) {
    Error error;
    bytes.takeList(error.what);
    bytes.takeList(error.where);
    bytes.takeList(error.advice);
    return error;
}

// Whole, so that adding it again loses nothing.
glm::dvec3 originNear(glm::dvec3 point) {
    constexpr double farUnits = 10'000, maxUnits = 1e12;
    const double maximum = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    return maximum > farUnits && maximum < maxUnits ? glm::round(point) : glm::dvec3(0);
}

}  // namespace

void addPoint(MeshPiece& piece, glm::dvec3 point) {
    if (piece.points.empty()) piece.origin = originNear(point);
    piece.points.emplace_back(point - piece.origin);
}

void appendSceneHead(std::string& bytes) { bytes += sceneHead; }

void appendObject(std::string& bytes, const MeshObject& object) {
    bytes += objectTag;
    appendList(bytes, object.name);
    const std::uint64_t pieces = object.pieces.size();
    bytes.append(reinterpret_cast<const char*>(&pieces), sizeof pieces);
    for (const MeshPiece& piece : object.pieces) {
        appendList(bytes, piece.points);
        appendList(bytes, piece.cornerCounts);
        appendList(bytes, piece.corners);
        appendValue(bytes, piece.origin);
        appendValue(bytes, piece.rounding);
    }
    appendList(bytes, object.parent);
    appendList(bytes, object.note);
    appendValue(bytes, object.kind);
    appendValue(bytes, object.floor.value_or(noFloor));
}

void appendSceneEnd(std::string& bytes) { bytes += endTag; }

void appendError(std::string& bytes, const Error& error) {
    bytes += errorTag;
    appendList(bytes, error.what);
    appendList(bytes, error.where);
    appendList(bytes, error.advice);
}

Result<MeshScene> parseScene(std::string_view all, bool& complete) {
    SceneBytes bytes(all);
    MeshScene scene;
    complete = true;
    char tag = bytes.take(sceneHead.size()) == sceneHead ? bytes.takeTag() : '\0';
    for (; tag == objectTag && bytes.good(); tag = bytes.takeTag()) scene.push_back(takeObject(bytes));
    if (tag == errorTag) {
        const Error error = takeError(bytes);
        if (bytes.good() && bytes.left() == 0) return tl::make_unexpected(error);
    }
    if (tag == endTag && bytes.good() && bytes.left() == 0) return scene;
    complete = false;
    return failure("The output of the mesh reader is incomplete");
}

}  // namespace noonmark
