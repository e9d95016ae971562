#include "render/scene/ground_lines.h"

#include <QColor>
#include <QVector2D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <utility>

#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

constexpr float faintAlpha = 0.3F;

ShaderMaterial* makeStroke(const QColor& colour, float alpha, float widthPx, Qt3DCore::QEntity* parent) {
    auto* stroke = new ShaderMaterial(QStringLiteral("ribbon"), parent);
    stroke->set(QStringLiteral("lineColour"),
                QVector4D(colour.redF(), colour.greenF(), colour.blueF(), alpha));
    stroke->set(QStringLiteral("widthPx"), widthPx);
    stroke->blend();
    stroke->bothSides();
    return stroke;
}

}  // namespace

GroundLines::GroundLines(const QColor& colour, float widthPx, Qt3DRender::QLayer* blended,
                         Qt3DCore::QEntity* parent, Behind behind)
    : blended_(blended), root_(new Qt3DCore::QEntity(parent)) {
    if (behind == Behind::faint) {
        strokes_.push_back(makeStroke(colour, faintAlpha, widthPx, root_));
        strokes_.back()->alwaysVisible();
    }
    strokes_.push_back(makeStroke(colour, colour.alphaF(), widthPx, root_));
    strokes_.back()->include(QStringLiteral("LIFTED"), true);  // above the ground that they lie on
}

GroundLines::~GroundLines() { delete root_; }

void GroundLines::show(const std::vector<GroundLine>& lines) {
    delete std::exchange(entity_, nullptr);
    if (lines.empty()) return;
    entity_ = new Qt3DCore::QEntity(root_);
    for (ShaderMaterial* stroke : strokes_)
        makeArrayEntity(makeOutlineGeometry(lines), *stroke, entity_, blended_);
}

void GroundLines::setViewSize(const QVector2D& size) {
    for (ShaderMaterial* stroke : strokes_) stroke->set(QStringLiteral("viewSize"), size);
}

}  // namespace noonmark
