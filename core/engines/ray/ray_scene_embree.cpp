#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "core/engines/ray/ray_scene.h"

namespace noonmark {

namespace {

constexpr unsigned terrainId = 0;
constexpr unsigned buildingsId = 1;
constexpr unsigned crownsId = 2;
// Ignores a user's Embree settings file, which must not change a reference. Tests set an instruction set
// ("sse4.2", "avx2") to run the code paths of other machines.
std::string deviceConfig() {
    const char* wanted = std::getenv("NOONMARK_RAY_ISA");
    return std::string("ignore_config_files=1") + (wanted != nullptr ? std::string(",isa=") + wanted : "");
}

void attach(RTCDevice device, RTCScene scene, unsigned id, const TriangleMesh& mesh, glm::vec3 from) {
    if (mesh.triangles.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(glm::vec3), mesh.vertices.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              sizeof(glm::uvec3), mesh.triangles.size());
    if (vertices != nullptr && triangles != nullptr) {
        std::ranges::transform(mesh.vertices, static_cast<glm::vec3*>(vertices),
                               [&](glm::vec3 vertex) { return vertex - from; });
        std::ranges::copy(mesh.triangles, static_cast<glm::uvec3*>(triangles));
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
    }
    rtcReleaseGeometry(geometry);
}

// The point that stored coordinates are relative to. Embree works in float32, which resolves 60 km from the
// city's origin only to 8 mm. For distant buildings it is their centre, rounded to whole metres so that
// coordinates near it lose no precision; otherwise the city's origin.
glm::vec3 originOf(const TriangleMesh& mesh) {
    constexpr float nearM = 4096;  // resolved to 0.5 mm
    if (mesh.vertices.empty()) return glm::vec3(0);
    glm::vec3 low = mesh.vertices.front(), high = low;
    for (const glm::vec3 vertex : mesh.vertices) low = glm::min(low, vertex), high = glm::max(high, vertex);
    const glm::vec3 middle = glm::round((low + high) / 2.0F);
    return std::max(std::abs(middle.x), std::abs(middle.y)) < nearM ? glm::vec3(0)
                                                                    : glm::vec3(middle.x, middle.y, 0);
}

float justBeyond(float coordinate) {
    return std::max(coordinate + RayScene::wallOffsetM,
                    std::nextafter(coordinate, std::numeric_limits<float>::max()));
}

bool shouldContinue(void* stop, double) {
    return !static_cast<const std::stop_token*>(stop)->stop_requested();
}

std::vector<std::uint32_t> listAllObstacles(const City& city) {
    std::vector<std::uint32_t> indices(city.buildings.size());
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
}

CityMesh meshOfSome(const City& city, std::span<const std::uint32_t> buildings, const std::stop_token& stop) {
    City some;
    some.buildings.reserve(buildings.size());
    for (const std::uint32_t index : buildings) some.buildings.push_back(city.buildings[index]);
    CityMesh mesh = meshOf(some, stop);
    for (std::uint32_t& building : mesh.buildingOfTriangle) building = buildings[building];
    return mesh;
}

/// What a query says to its callbacks.
struct QueryContext : RTCIntersectContext {
    std::span<const std::uint8_t> groups;  ///< see RayScene::firstHits()

    explicit QueryContext(std::span<const std::uint8_t> met = {}) : groups(met) {
        rtcInitIntersectContext(this);
        flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;  // 1.5 times as fast for similar directions
    }
    [[nodiscard]] bool meets(std::uint32_t group) const { return groups.empty() || groups[group] != 0; }
};

RTCRay rayFrom(glm::vec3 origin, glm::vec3 direction) {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = RayScene::nearestM;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0U;
    return ray;
}

RTCRay16 raysAlong(const DirectionPacket& directions) {
    RTCRay16 rays;
    std::ranges::copy(directions.x, rays.dir_x);
    std::ranges::copy(directions.y, rays.dir_y);
    std::ranges::copy(directions.z, rays.dir_z);
    std::ranges::fill(rays.tnear, RayScene::nearestM);
    std::ranges::fill(rays.time, 0.0F);
    std::ranges::fill(rays.mask, ~0U);
    std::ranges::fill(rays.id, 0U);
    std::ranges::fill(rays.flags, 0U);
    return rays;
}

// A query changes only the far end of a ray, so the rays can be reused.
void startFrom(RTCRay16& rays, glm::vec3 origin) {
    std::ranges::fill(rays.org_x, origin.x);
    std::ranges::fill(rays.org_y, origin.y);
    std::ranges::fill(rays.org_z, origin.z);
    std::ranges::fill(rays.tfar, std::numeric_limits<float>::infinity());
}

// Embree sets the far end of a blocked ray to minus infinity. Where registers hold fewer than 16 lanes, it
// does so for invalid lanes too, so only the first `count` lanes are read.
std::uint32_t blockedOf(const RTCRay16& rays, unsigned count) {
    std::uint32_t blocked = 0;
    for (unsigned lane = 0; lane < count; ++lane)
        if (rays.tfar[lane] < 0) blocked |= 1U << lane;
    return blocked;
}

const GroupedCrown& crownOf(const void* crowns, unsigned index) {
    return static_cast<const GroupedCrown*>(crowns)[index];
}

bool meets(const RTCIntersectContext* context, const GroupedCrown& crown) {
    return static_cast<const QueryContext*>(context)->meets(crown.group);
}

void boundCrown(const RTCBoundsFunctionArguments* arguments) {
    constexpr double margin = 0.001;  // rays are float32
    const Crown& crown = crownOf(arguments->geometryUserPtr, arguments->primID).crown;
    const double reach = crown.radiusM + margin;
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = float(crown.x - reach), bounds.upper_x = float(crown.x + reach);
    bounds.lower_y = float(crown.y - reach), bounds.upper_y = float(crown.y + reach);
    bounds.lower_z = float(crown.bottomM - margin), bounds.upper_z = float(crown.topM + margin);
}

struct LineOfRay {
    glm::dvec3 origin, direction;
    LineOfRay(RTCRayN* rays, unsigned count, unsigned lane)
        : origin(RTCRayN_org_x(rays, count, lane), RTCRayN_org_y(rays, count, lane),
                 RTCRayN_org_z(rays, count, lane)),
          direction(RTCRayN_dir_x(rays, count, lane), RTCRayN_dir_y(rays, count, lane),
                    RTCRayN_dir_z(rays, count, lane)) {}
};

void meetCrown(const RTCIntersectFunctionNArguments* arguments) {
    const GroupedCrown& some = crownOf(arguments->geometryUserPtr, arguments->primID);
    if (!meets(arguments->context, some)) return;
    const unsigned count = arguments->N;
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
    RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, count);
    for (unsigned lane = 0; lane < count; ++lane) {
        if (arguments->valid[lane] == 0) continue;
        const LineOfRay line(rays, count, lane);
        const LinePart part = findLinePart(some.crown, line.origin, line.direction);
        float& end = RTCRayN_tfar(rays, count, lane);
        if (!(part.leave > part.enter) || part.enter < double(RTCRayN_tnear(rays, count, lane)) ||
            part.enter > double(end))
            continue;
        const glm::dvec3 normal = normalAt(some.crown, line.origin + part.enter * line.direction);
        end = float(part.enter);
        RTCHitN_Ng_x(hits, count, lane) = float(normal.x);
        RTCHitN_Ng_y(hits, count, lane) = float(normal.y);
        RTCHitN_Ng_z(hits, count, lane) = float(normal.z);
        RTCHitN_primID(hits, count, lane) = arguments->primID;
        RTCHitN_geomID(hits, count, lane) = crownsId;
    }
}

// A ray that begins in a crown is blocked.
void blockByCrown(const RTCOccludedFunctionNArguments* arguments) {
    const GroupedCrown& some = crownOf(arguments->geometryUserPtr, arguments->primID);
    if (!meets(arguments->context, some)) return;
    const unsigned count = arguments->N;
    for (unsigned lane = 0; lane < count; ++lane) {
        if (arguments->valid[lane] == 0) continue;
        const LineOfRay line(arguments->ray, count, lane);
        const LinePart part = findLinePart(some.crown, line.origin, line.direction);
        float& end = RTCRayN_tfar(arguments->ray, count, lane);
        if (part.leave > part.enter && part.leave > double(RTCRayN_tnear(arguments->ray, count, lane)) &&
            part.enter < double(end))
            end = -std::numeric_limits<float>::infinity();
    }
}

void attach(RTCDevice device, RTCScene scene, std::vector<GroupedCrown>& crowns) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(crowns.size()));
    rtcSetGeometryUserData(geometry, crowns.data());
    rtcSetGeometryBoundsFunction(geometry, boundCrown, nullptr);
    rtcSetGeometryIntersectFunction(geometry, meetCrown);
    rtcSetGeometryOccludedFunction(geometry, blockByCrown);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, crownsId);
    rtcReleaseGeometry(geometry);
}

struct ValidLanes {
    alignas(64) std::array<int, DirectionPacket::capacity> valid{};
};

void collectOccluders(const RTCFilterFunctionNArguments* arguments);

/// Collects the buildings that a packet of rays hits. Embree reports hits in no particular order; the filter
/// keeps the nearest hit of each building.
struct OccluderContext : QueryContext {
    const std::uint32_t* buildingOfTriangle = nullptr;
    int levels = 0;
    Occluder* occluders = nullptr;  // lane x levels, sorted by distance; 0: free

    explicit OccluderContext(const std::vector<std::uint32_t>& buildings, int levelCount,
                             std::span<Occluder> out)
        : buildingOfTriangle(buildings.data()), levels(levelCount), occluders(out.data()) {
        filter = collectOccluders;
    }

    /// Returns true if nothing beyond `distance` can matter to this lane.
    bool keep(unsigned lane, float distance, std::uint32_t building) const {
        Occluder* list = occluders + std::size_t(lane) * std::size_t(levels);
        int at = 0;
        while (at < levels - 1 && list[at].distanceM > 0 && list[at].building != building) ++at;
        const bool known = list[at].distanceM > 0 && list[at].building == building;
        if (list[at].distanceM > 0 && distance >= list[at].distanceM) return !known;  // full of nearer ones
        list[at] = {distance, building};
        for (; at > 0 && list[at].distanceM < list[at - 1].distanceM; --at) std::swap(list[at], list[at - 1]);
        return false;
    }
};

constexpr unsigned collects = 1;  // flag of the lanes that hold a ray

void collectOccluders(const RTCFilterFunctionNArguments* arguments) {
    for (unsigned lane = 0; lane < arguments->N; ++lane) {
        if (arguments->valid[lane] == 0 ||
            (RTCRayN_flags(arguments->ray, arguments->N, lane) & collects) == 0 ||
            RTCHitN_geomID(arguments->hit, arguments->N, lane) != buildingsId)
            continue;
        const auto& context = *static_cast<const OccluderContext*>(arguments->context);
        const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, lane);
        const float distance = RTCRayN_tfar(arguments->ray, arguments->N, lane);
        const unsigned id = RTCRayN_id(arguments->ray, arguments->N, lane);
        // A rejected hit lets the ray continue; an accepted one ends it.
        if (!context.keep(id, distance, context.buildingOfTriangle[triangle])) arguments->valid[lane] = 0;
    }
}

constexpr auto validLanes = [] {
    std::array<ValidLanes, DirectionPacket::capacity + 1> lanes{};
    for (std::size_t count = 0; count < lanes.size(); ++count)
        for (std::size_t lane = 0; lane < count; ++lane) lanes[count].valid[lane] = -1;
    return lanes;
}();

}  // namespace

struct RayScene::Tree {
    RTCDevice device = rtcNewDevice(deviceConfig().c_str());
    RTCScene scene = device != nullptr ? rtcNewScene(device) : nullptr;
    std::vector<std::uint32_t> buildingOfTriangle;
    std::vector<GroupedCrown> crowns;  ///< relative to `from`
    std::size_t triangles = 0;
    glm::vec3 from{0};  // point that Embree's coordinates are relative to

    [[nodiscard]] glm::vec3 startOf(glm::vec3 origin) const {
        const glm::vec3 place = origin - from;
        return {justBeyond(place.x), justBeyond(place.y), place.z};
    }

    void aim(const HitPacket& packet, RTCRay16& rays) const {
        std::ranges::transform(packet.originX, rays.org_x, [this](float x) { return x - from.x; });
        std::ranges::transform(packet.originY, rays.org_y, [this](float y) { return y - from.y; });
        std::ranges::copy(packet.originZ, rays.org_z);
        std::ranges::copy(packet.directionX, rays.dir_x);
        std::ranges::copy(packet.directionY, rays.dir_y);
        std::ranges::copy(packet.directionZ, rays.dir_z);
        std::ranges::copy(packet.from, rays.tnear);
        std::ranges::copy(packet.distance, rays.tfar);
        std::ranges::fill(rays.time, 0.0F);
        std::ranges::fill(rays.mask, ~0U);
        std::ranges::fill(rays.id, 0U);
        std::ranges::fill(rays.flags, 0U);
    }

    [[nodiscard]] std::uint32_t hitOf(unsigned geometry, unsigned triangle) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return HitPacket::nothing;
        if (geometry == crownsId) return crowns[triangle].group;
        return geometry == terrainId ? HitPacket::terrain : buildingOfTriangle[triangle];
    }

    Tree() = default;
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    /// Returns false if Embree fails.
    bool build(const CityMesh& buildings, const TriangleMesh& terrain, const std::stop_token& stop) {
        if (device == nullptr || scene == nullptr) return false;
        // Robust: rays do not slip between triangles that share an edge, nor through gaps between bounding
        // boxes. A filter of the query, not of the geometry, costs other queries nothing.
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
        from = originOf(buildings.mesh);
        attach(device, scene, terrainId, terrain, from);
        attach(device, scene, buildingsId, buildings.mesh, from);
        buildingOfTriangle = buildings.buildingOfTriangle;
        triangles = buildings.mesh.triangles.size() + terrain.triangles.size();
        return commit(stop);
    }

    bool build(std::vector<GroupedCrown> given, const std::stop_token& stop) {
        if (device == nullptr || scene == nullptr) return false;
        crowns = std::move(given);
        TriangleMesh middles;
        for (const GroupedCrown& some : crowns) middles.vertices.emplace_back(some.crown.x, some.crown.y, 0);
        from = originOf(middles);
        for (GroupedCrown& some : crowns) some.crown.x -= from.x, some.crown.y -= from.y;
        attach(device, scene, crowns);
        return commit(stop);
    }

    bool commit(const std::stop_token& stop) {
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
        std::stop_token watched = stop;
        rtcSetSceneProgressMonitorFunction(scene, shouldContinue, &watched);
        rtcCommitScene(scene);
        rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
        return rtcGetDeviceError(device) == RTC_ERROR_NONE;
    }
};

namespace {

tl::unexpected<Error> tooLittleMemory(const std::string& bodies) {
    return failure("There is not enough memory to trace rays through " + bodies, RayScene::backend(),
                   "Choose a smaller region or close other programs");
}

}  // namespace

RayScene::RayScene(std::shared_ptr<const Tree> tree) : tree_(std::move(tree)) {}

Result<RayScene> RayScene::over(const City& city, std::stop_token stop) {
    return over(city, listAllObstacles(city), std::move(stop));
}

Result<RayScene> RayScene::over(const City& city, std::span<const std::uint32_t> buildings,
                                std::stop_token stop) {
    const CityMesh mesh = meshOfSome(city, buildings, stop);
    const TriangleMesh terrain = city.terrain ? meshOf(*city.terrain) : TriangleMesh{};
    if (stop.stop_requested()) return cancelled();
    auto tree = std::make_shared<Tree>();
    const bool built = tree->build(mesh, terrain, stop);
    if (stop.stop_requested()) return cancelled();
    if (!built) return tooLittleMemory(fmt::format("{} triangles", tree->triangles));
    return RayScene(std::move(tree));
}

Result<RayScene> RayScene::over(std::vector<GroupedCrown> crowns, std::stop_token stop) {
    auto tree = std::make_shared<Tree>();
    const std::size_t count = crowns.size();
    const bool built = tree->build(std::move(crowns), stop);
    if (stop.stop_requested()) return cancelled();
    if (!built) return tooLittleMemory(fmt::format("{} crowns", count));
    return RayScene(std::move(tree));
}

bool RayScene::occluded(glm::vec3 origin, glm::vec3 direction) const {
    QueryContext context;
    RTCRay ray = rayFrom(tree_->startOf(origin), direction);
    rtcOccluded1(tree_->scene, &context, &ray);
    return ray.tfar < 0;
}

void RayScene::blockedLanes(std::span<const glm::vec3> origins, const DirectionPacket& directions,
                            std::span<std::uint32_t> blocked) const {
    QueryContext context;
    const int* valid = validLanes[std::size_t(directions.count)].valid.data();
    RTCRay16 rays = raysAlong(directions);
    for (std::size_t i = 0; i < origins.size(); ++i) {
        startFrom(rays, tree_->startOf(origins[i]));
        rtcOccluded16(valid, tree_->scene, &context, &rays);
        blocked[i] = blockedOf(rays, unsigned(directions.count));
    }
}

std::optional<RayHit> RayScene::firstHit(glm::vec3 origin, glm::vec3 direction) const {
    QueryContext context;
    RTCRayHit found{};
    found.ray = rayFrom(tree_->startOf(origin), direction);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(tree_->scene, &context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    RayHit hit;
    if (found.hit.geomID == buildingsId) hit.building = tree_->buildingOfTriangle[found.hit.primID];
    hit.position = origin + direction * found.ray.tfar;
    hit.normal = glm::normalize(glm::vec3(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z));
    hit.distanceM = found.ray.tfar * glm::length(direction);
    return hit;
}

void RayScene::firstHits(HitPacket& packet, std::span<const std::uint8_t> groups) const {
    QueryContext context(groups);
    RTCRayHit16 found;
    tree_->aim(packet, found.ray);
    std::ranges::fill(found.hit.geomID, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(validLanes[HitPacket::lanes].valid.data(), tree_->scene, &context, &found);
    std::ranges::copy(found.ray.tfar, packet.distance.begin());
    std::ranges::copy(found.hit.Ng_x, packet.normalX.begin());
    std::ranges::copy(found.hit.Ng_y, packet.normalY.begin());
    std::ranges::copy(found.hit.Ng_z, packet.normalZ.begin());
    for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane)
        packet.hit[lane] = tree_->hitOf(found.hit.geomID[lane], found.hit.primID[lane]);
}

std::uint32_t RayScene::findBlocked(const HitPacket& packet, std::span<const std::uint8_t> groups) const {
    QueryContext context(groups);
    RTCRay16 rays;
    tree_->aim(packet, rays);
    rtcOccluded16(validLanes[HitPacket::lanes].valid.data(), tree_->scene, &context, &rays);
    // The far end of a ray without a range is below 0 from the start.
    std::uint32_t blocked = 0;
    for (unsigned lane = 0; lane < HitPacket::lanes; ++lane)
        if (rays.tfar[lane] < 0 && packet.distance[lane] >= 0) blocked |= 1U << lane;
    return blocked;
}

void RayScene::firstOccluders(std::span<const glm::vec3> origins, glm::vec3 direction, float nearestHitM,
                              int levels, std::span<Occluder> occluders) const {
    std::ranges::fill(occluders, Occluder{});
    OccluderContext context(tree_->buildingOfTriangle, levels, occluders);
    RTCRayHit16 found;
    for (std::size_t lane = 0; lane < 16; ++lane) {
        const glm::vec3 origin = tree_->startOf(origins[std::min(lane, origins.size() - 1)]);
        found.ray.org_x[lane] = origin.x, found.ray.org_y[lane] = origin.y, found.ray.org_z[lane] = origin.z;
        found.ray.dir_x[lane] = direction.x, found.ray.dir_y[lane] = direction.y,
        found.ray.dir_z[lane] = direction.z;
        // Where registers hold eight rays, Embree splits the packet and traces all lanes, whatever the mask
        // of valid ones says; an empty interval and no flag keep those without a receiver out.
        const bool isReceiver = lane < origins.size();
        found.ray.tnear[lane] = nearestHitM;
        found.ray.tfar[lane] = isReceiver ? std::numeric_limits<float>::infinity() : -1;
        found.ray.time[lane] = 0, found.ray.mask[lane] = ~0U;
        found.ray.id[lane] = unsigned(lane), found.ray.flags[lane] = isReceiver ? collects : 0;
        found.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(validLanes[std::min<std::size_t>(16, origins.size())].valid.data(), tree_->scene, &context,
                   &found);
}

std::size_t RayScene::triangleCount() const { return tree_->triangles; }

std::string RayScene::backend() { return std::string("Embree ") + RTC_VERSION_STRING; }

}  // namespace noonmark
