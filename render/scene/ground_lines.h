#pragma once

#include <vector>

#include "render/scene/array_entity.h"

class QColor;
class QVector2D;

namespace noonmark {

class ShaderMaterial;

/// Lines on the ground that are as wide as they are however far away they lie. Where something hides them
/// they are faint, so that they do not seem to lie before it, or not drawn.
class GroundLines {
public:
    enum class Behind { faint, hidden };
    /// `blended`: the layer that is drawn last; `parent` owns the nodes.
    GroundLines(const QColor& colour, float widthPx, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent,
                Behind behind = Behind::faint);
    ~GroundLines();
    GroundLines(const GroundLines&) = delete;
    GroundLines& operator=(const GroundLines&) = delete;

    void show(const std::vector<GroundLine>& lines);  ///< instead of those before
    void setViewSize(const QVector2D& size);          ///< device-independent pixels

private:
    Qt3DRender::QLayer* blended_;
    Qt3DCore::QEntity* root_;
    std::vector<ShaderMaterial*> strokes_;  ///< everywhere (faint), and where nothing hides them
    Qt3DCore::QEntity* entity_ = nullptr;
};

}  // namespace noonmark
