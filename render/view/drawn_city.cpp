#include "render/view/drawn_city.h"

#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <algorithm>

#include "core/city/building_heights.h"
#include "render/scene/array_entity.h"
#include "render/scene/city_bodies.h"
#include "render/scene/picture_texture.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"
#include "render/view/frame_graph.h"
#include "render/view/traced_city.h"

namespace noonmark {

namespace {

constexpr QColor groundColour{0xee, 0xed, 0xe8};
constexpr QColor skyColour{0xa9, 0xcb, 0xe8};
constexpr QColor buildingColour{0xf7, 0xf5, 0xf1};
constexpr QColor edgeColour{0x3a, 0x40, 0x4a};
// More edges are hidden while the camera moves.
constexpr std::size_t maxEdgesInMotion = 150'000;
constexpr std::size_t maxEdgesBySoftware = 20'000;

ShaderMaterial* makeMaterial(const char* name, Qt3DCore::QNode* parent) {
    return new ShaderMaterial(QString::fromLatin1(name), parent);
}

void setAll(const std::vector<ShaderMaterial*>& materials, const QString& uniform, const QVariant& value) {
    for (ShaderMaterial* material : materials) material->set(uniform, value);
}

void includeAll(const std::vector<ShaderMaterial*>& materials, const char* part, bool included) {
    for (ShaderMaterial* material : materials) material->include(QString::fromLatin1(part), included);
}

GroundPicture noPicture() {
    GroundPicture nothing;
    nothing.grid = {0, 0, 1, 1, 1};
    nothing.pixels.resize(1);
    return nothing;
}

// Puts a picture onto materials, as the uniforms `name` and `name`Box. `texture` is replaced by the new one;
// the old one is deleted.
void lay(const QString& name, const GroundPicture& given, const std::vector<ShaderMaterial*>& materials,
         Qt3DCore::QNode*& texture, Qt3DCore::QNode* parent) {
    const GroundPicture picture = fitPicture(given);
    const Grid& grid = picture.grid;
    Qt3DCore::QNode* const previous = texture;
    Qt3DRender::QAbstractTexture* made = makeTexture(picture, parent);
    texture = made;
    setAll(materials, name, QVariant::fromValue(made));
    setAll(materials, name + QStringLiteral("Box"),
           QVector4D(float(grid.westM), float(grid.southM), float(grid.eastM() - grid.westM),
                     float(grid.northM() - grid.southM)));
    includeAll(materials, name.toUpper().toLatin1().constData(), true);
    delete previous;
}

std::vector<const Building*> listShown(const CityArrays& arrays, const ArrayDifference& changes) {
    std::vector<const Building*> shown;
    for (const auto& building : arrays.buildings) shown.push_back(building.get());
    for (const std::uint32_t removed : changes.removed) shown[removed] = nullptr;
    std::erase(shown, nullptr);
    for (const auto& building : changes.added.buildings) shown.push_back(building.get());
    return shown;
}

}  // namespace

DrawnCity::DrawnCity(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent)
    : blended_(blended),
      side_(side),
      parent_(parent),
      building_(makeMaterial("building", parent)),
      proposal_(makeMaterial("building", parent)),
      cut_(makeMaterial("cut", parent)),
      edge_(makeMaterial("edge", parent)),
      ground_(makeMaterial("ground", parent)),
      traced_(side, parent),
      crowns_(blended, side, parent),
      bodyMaterials_{building_, proposal_, traced_.material()},
      groundMaterials_{ground_, traced_.material()} {
    cut_->fromBehind();
    edge_->blend();
    for (ShaderMaterial* material : {building_, proposal_, ground_}) material->drawDepthFirst();
    const Materials surfaces{building_, proposal_, ground_, traced_.material()};
    setAll(bodyMaterials_, QStringLiteral("baseColour"), toVector(buildingColour));
    proposal_->set(QStringLiteral("baseColour"), toVector(proposalColour));
    traced_.material()->set(QStringLiteral("proposalColour"), toVector(proposalColour));
    setAll(groundMaterials_, QStringLiteral("groundColour"), toVector(groundColour));
    setAll(surfaces, QStringLiteral("haze"), toVector(backgroundColour));
    traced_.material()->set(QStringLiteral("skyBlue"), toVector(skyColour));
    setAll({edge_, traced_.material()}, QStringLiteral("edgeColour"), toVector(edgeColour));
    clearPicture();
    clearMap();
    clearFinerMap();
    surfaces_ = std::make_unique<SurfaceLayer>(surfaces, parent);
    sun_ = std::make_unique<SunLayer>(Materials{building_, proposal_, ground_}, parent);
}

DrawnCity::~DrawnCity() = default;

std::unique_ptr<BuildingBodies> DrawnCity::makeBodies(std::shared_ptr<const CityArrays> arrays,
                                                      ShaderMaterial& faces) {
    return std::make_unique<BuildingBodies>(std::move(arrays),
                                            BuildingBodies::Materials{faces, *cut_, *edge_},
                                            BuildingBodies::Layers{blended_, side_}, parent_);
}

void DrawnCity::showGround(const CityArrays& arrays) {
    delete groundEntity_;
    auto* ground = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    ground->addPoints(QStringLiteral("vertexPosition"), arrays.groundPoints);
    ground->setIndices(arrays.groundTriangles);
    groundEntity_ = makeArrayEntity(ground, *ground_, parent_, side_);
}

void DrawnCity::showCity(std::shared_ptr<const CityArrays> arrays) {
    clearPicture();
    surfaces_->clear();
    added_.reset();
    traced_.clear();
    bounds_ = arrays->bounds;
    showGround(*arrays);
    manyEdges_ = arrays->edges.size() > (drawsInSoftware() ? maxEdgesBySoftware : maxEdgesInMotion);
    city_ = makeBodies(std::move(arrays), *building_);
    showBodies();
}

void DrawnCity::showChanges(const ArrayDifference& changes) {
    if (!city_) return;
    city_->leaveOut(changes.removed);
    const auto isNew = [](const auto& building) { return isProposal(*building); };
    const bool proposed = std::ranges::all_of(changes.added.buildings, isNew);
    added_ = makeBodies(std::make_shared<const CityArrays>(makeBuildingArrays(changes.added)),
                        proposed ? *proposal_ : *building_);
    addedTraced_ = traced_.showOnly(listShown(*city_->arrays(), changes));
    showBodies();
    bounds_ = city_->arrays()->bounds;
    for (const auto& building : changes.added.buildings) {
        bounds_.topM = std::max(bounds_.topM, topM(*building));
        bounds_.box.add(noonmark::bounds(*building));
    }
}

void DrawnCity::showTrees(std::shared_ptr<const Trees> trees, std::shared_ptr<const CrownRays> rays) {
    crowns_.show(std::move(trees));
    traced_.setCrowns(std::move(rays));
    crowns_.setTraced(isTraced() && traced_.hasCrowns());
}

void DrawnCity::clear() {
    clearPicture();
    surfaces_->clear();
    sun_->clear();
    setTracedSun(std::nullopt);
    traced_.clear();
    crowns_.show(nullptr);
    added_.reset();
    city_.reset();
    bounds_ = {};
    manyEdges_ = addedTraced_ = false;
    delete groundEntity_;
    groundEntity_ = nullptr;
}

std::shared_ptr<const CityArrays> DrawnCity::arrays() const { return city_ ? city_->arrays() : nullptr; }

// Rays replace the triangles of ground and buildings, but not those of buildings that their scene lacks.
void DrawnCity::showBodies() {
    const bool traced = isTraced();
    const auto show = [this](BuildingBodies* bodies, bool shown) {
        if (!bodies) return;
        bodies->showFaces(facesShown_ && shown);
        bodies->showCut(facesShown_ && shown && cutShown_);
        bodies->showEdges(shown);
    };
    show(city_.get(), !traced);
    show(added_.get(), !traced || !addedTraced_);
    if (groundEntity_) groundEntity_->setEnabled(!traced);
    traced_.show(traced);
    crowns_.setTraced(traced && traced_.hasCrowns());
}

void DrawnCity::setRays(RayScene scene, const std::vector<std::shared_ptr<const Building>>& buildings) {
    if (!drawsInSoftware() || !city_) return;
    traced_.setScene(std::move(scene), buildings,
                     {city_->arrays()->groundPoints.back().z, city_->arrays()->terrain});
    addedTraced_ = true;
    showBodies();
}

void DrawnCity::clearRays() {
    traced_.clear();
    showBodies();
}

void DrawnCity::showFaces(bool shown) {
    facesShown_ = shown;
    showBodies();
}

void DrawnCity::showCut(bool shown) {
    cutShown_ = shown;
    showBodies();
}

bool DrawnCity::hideEdges() {
    if (!city_ || !manyEdges_ || !facesShown_ || isTraced()) return false;
    city_->showEdges(false);
    return true;
}

void DrawnCity::showEdges() {
    if (city_) city_->showEdges(!isTraced());
}

void DrawnCity::showPicture(const GroundPicture& picture, bool soFar) {
    lay(QStringLiteral("picture"), picture, groundMaterials_, texture_, parent_);
    setAll(groundMaterials_, QStringLiteral("pictureSoFar"), soFar ? 1.0F : 0.0F);
    includeAll(bodyMaterials_, "ROOFPICTURE", false);  // the texture stays until the next picture
}

void DrawnCity::showRoofPicture(const GroundPicture& picture) {
    lay(QStringLiteral("roofPicture"), picture, bodyMaterials_, roofTexture_, parent_);
    setAll(bodyMaterials_, QStringLiteral("roofPictureSoFar"), 0.0F);
}

void DrawnCity::clearPicture() {
    showPicture(noPicture(), false);
    includeAll(groundMaterials_, "PICTURE", false);
}

void DrawnCity::showMap(const GroundPicture& picture) {
    lay(QStringLiteral("map"), picture, groundMaterials_, mapTexture_, parent_);
}

void DrawnCity::clearMap() {
    showMap(noPicture());
    includeAll(groundMaterials_, "MAP", false);
}

void DrawnCity::showFinerMap(const GroundPicture& picture) {
    lay(QStringLiteral("finerMap"), picture, groundMaterials_, finerMapTexture_, parent_);
}

void DrawnCity::clearFinerMap() {
    showFinerMap(noPicture());
    includeAll(groundMaterials_, "FINERMAP", false);
}

void DrawnCity::setTracedSun(const std::optional<glm::dvec3>& towardsSun) {
    traced_.setSun(towardsSun ? std::optional(glm::vec3(*towardsSun)) : std::nullopt);
}

void DrawnCity::setHaze(float distanceM) {
    setAll({building_, proposal_, edge_, ground_, traced_.material()}, QStringLiteral("hazeDistance"),
           distanceM);
    crowns_.setHaze(distanceM);
}

void DrawnCity::redraw() {
    redrawn_ = !redrawn_;
    setAll({ground_, traced_.material()}, QStringLiteral("exposed"), redrawn_ ? 1.0F : 0.0F);
}

}  // namespace noonmark
