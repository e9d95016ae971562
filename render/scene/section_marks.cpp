#include "render/scene/section_marks.h"

#include <QColor>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <utility>

#include "render/scene/array_entity.h"
#include "render/scene/mark_shapes.h"
#include "render/scene/outline_geometry.h"
#include "render/scene/shader_material.h"

namespace noonmark {

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
