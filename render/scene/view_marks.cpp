#include "render/scene/view_marks.h"

#include <QColor>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <cmath>
#include <utility>

#include "render/scene/array_entity.h"
#include "render/scene/picture_texture.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

constexpr int shapeCount = 5;
constexpr QColor cornerColour{0x0a, 0x6f, 0x4f};
constexpr QColor selectedColourOfCorner{0xc2, 0x18, 0x8b};
constexpr QColor snapColour{0xd5, 0x5e, 0x00};

void paintShape(QPainter& painter, PointMarks::Shape shape) {
    using Shape = PointMarks::Shape;
    const auto square = [&](double halfPx) {
        painter.drawRect(QRectF(-halfPx, -halfPx, 2 * halfPx, 2 * halfPx));
    };
    const bool snap = shape == Shape::snappedCorner || shape == Shape::snappedEdge;
    const QColor colour = snap                             ? snapColour
                          : shape == Shape::selectedCorner ? selectedColourOfCorner
                                                           : cornerColour;
    painter.setPen(QPen(colour, snap ? 2.5 : 1.5));
    painter.setBrush(snap ? QBrush(Qt::NoBrush)
                          : QBrush(shape == Shape::selectedCorner ? colour : QColor(Qt::white)));
    if (shape == Shape::corner || shape == Shape::selectedCorner) square(4.5);
    if (shape == Shape::middle) painter.drawEllipse(QPointF(0, 0), 3.5, 3.5);
    if (shape == Shape::snappedCorner) square(7);
    if (shape != Shape::snappedEdge) return;
    painter.drawLine(QPointF(-6.5, -6.5), QPointF(6.5, 6.5));
    painter.drawLine(QPointF(-6.5, 6.5), QPointF(6.5, -6.5));
}

// All shapes side by side, at the screen's resolution.
Qt3DRender::QAbstractTexture* makeShapes(Qt3DCore::QNode* parent) {
    const double scale = qGuiApp->devicePixelRatio();
    const int side = int(std::ceil(PointMarks::sizePx * scale));
    QImage image(shapeCount * side, side, QImage::Format_RGBA8888);
    image.fill(QColor(255, 255, 255, 0));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < shapeCount; ++i) {
        painter.resetTransform();
        painter.translate((i + 0.5) * side, 0.5 * side);
        painter.scale(scale, scale);
        paintShape(painter, PointMarks::Shape(i));
    }
    painter.end();
    const QByteArray bytes(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes());
    auto* texture = makeByteTexture(bytes, PixelKind::bytes, image.width(), image.height(), parent);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    return texture;
}

// The corners of the marks, for the shader `label`.
ArrayGeometry* makeMarkGeometry(const std::vector<PointMarks::Mark>& marks) {
    std::vector<glm::vec3> anchors, offsets, texels;
    std::vector<std::uint32_t> triangles;
    for (const PointMarks::Mark& mark : marks) {
        const auto first = std::uint32_t(anchors.size());
        for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            anchors.emplace_back(mark.at);
            offsets.emplace_back((x - 0.5) * PointMarks::sizePx, (0.5 - y) * PointMarks::sizePx, 0);
            texels.emplace_back(float(int(mark.shape) + x) / shapeCount, float(y), 0);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) triangles.push_back(first + corner);
    }
    auto* geometry = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    geometry->addPoints(QStringLiteral("vertexPosition"), anchors);
    geometry->addPoints(QStringLiteral("offset"), offsets);
    geometry->addPoints(QStringLiteral("texel"), texels);
    geometry->setIndices(triangles);
    return geometry;
}

}  // namespace

PointMarks::PointMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      blended_(blended),
      material_(new ShaderMaterial(QStringLiteral("label"), root_)) {
    root_->addComponent(overlay);
    material_->blend();
    material_->alwaysVisible();
    material_->bothSides();
    material_->include(QStringLiteral("UNCLIPPED"), true);
}

PointMarks::~PointMarks() { delete root_; }

void PointMarks::show(std::vector<Mark> marks) {
    if (std::exchange(marks_, std::move(marks)) != marks_) draw();
}

void PointMarks::showSnap(std::optional<Mark> snap) {
    if (std::exchange(snap_, snap) != snap_) draw();
}

void PointMarks::setViewSize(const QVector2D& size) { material_->set(QStringLiteral("viewSize"), size); }

// The texture is made for the first mark: most views never show one.
void PointMarks::draw() {
    delete std::exchange(entity_, nullptr);
    std::vector<Mark> all = marks_;
    if (snap_) all.push_back(*snap_);
    if (all.empty()) return;
    if (!shapes_) {
        shapes_ = makeShapes(root_);
        material_->set(QStringLiteral("names"), QVariant::fromValue(shapes_));
    }
    entity_ = makeArrayEntity(makeMarkGeometry(all), *material_, root_, blended_);
}

namespace {

constexpr QColor sectionColour{0x6a, 0x2c, 0x9c, 255};
constexpr QColor litColour{0xb5, 0x6c, 0xf0, 255};

QVector4D colourOf(const QColor& c) { return QVector4D(c.redF(), c.greenF(), c.blueF(), c.alphaF()); }

// Corner i is high on axis k where bit k of i is set.
glm::vec3 cornerOf(const SectionBox& box, unsigned i) {
    const auto at = [&](int axis) { return float((i >> axis) & 1U ? box.highM[axis] : box.lowM[axis]); };
    return {at(0), at(1), at(2)};
}

std::vector<GroundLine> makeOutline(const SectionBox& box) {
    std::vector<GroundLine> lines;
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned axis = 1; axis <= 4; axis *= 2)
            if ((i & axis) == 0) lines.push_back({{cornerOf(box, i), cornerOf(box, i | axis)}, false});
    return lines;
}

}  // namespace

SectionMarks::SectionMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended,
                           Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      blended_(blended),
      line_(new ShaderMaterial(QStringLiteral("ribbon"), root_)),
      shape_(makeBall(float(handlePx))) {
    root_->addComponent(overlay);
    line_->set(QStringLiteral("lineColour"), colourOf(sectionColour));
    line_->set(QStringLiteral("widthPx"), 1.6F);
    line_->blend();
    line_->alwaysVisible();
    line_->bothSides();
    for (Handle& handle : handles_) {
        handle.material = new ShaderMaterial(QStringLiteral("mark"), QStringLiteral("overlay"), root_);
        handle.material->set(QStringLiteral("tint"), colourOf(sectionColour));
    }
}

SectionMarks::~SectionMarks() { delete root_; }

void SectionMarks::showHandle(std::size_t side, const SectionBox& box) {
    Handle& handle = handles_[side];
    const glm::vec3 at(centreOf(box, sectionSides[side]));
    handle.material->set(QStringLiteral("anchor"), QVector3D(at.x, at.y, at.z));
    if (!handle.entity) handle.entity = makeArrayEntity(makeMeshGeometry(shape_), *handle.material, root_);
}

void SectionMarks::show(const std::optional<SectionBox>& box) {
    delete std::exchange(lines_, nullptr);
    if (!box) {
        for (Handle& handle : handles_) delete std::exchange(handle.entity, nullptr);
        return;
    }
    lines_ = makeArrayEntity(makeOutlineGeometry(makeOutline(*box)), *line_, root_, blended_);
    for (std::size_t side = 0; side < handles_.size(); ++side) showHandle(side, *box);
}

void SectionMarks::light(std::optional<std::size_t> side) {
    if (lit_ == side) return;
    if (lit_) handles_[*lit_].material->set(QStringLiteral("tint"), colourOf(sectionColour));
    if (side) handles_[*side].material->set(QStringLiteral("tint"), colourOf(litColour));
    lit_ = side;
}

void SectionMarks::setLens(const CameraPose& pose, const ViewLens& lens) {
    const auto atOneMetre = float(metresPerPixel(pose, lens, 1));
    for (const Handle& handle : handles_) handle.material->set(QStringLiteral("metresPerPixel"), atOneMetre);
    line_->set(QStringLiteral("viewSize"), QVector2D(float(lens.widthPx), float(lens.heightPx)));
}

}  // namespace noonmark
